// SPDX-License-Identifier: MIT
// Changes that the viewer's user makes to all noises of a scene at once.
#pragma once

#include <cstdint>
#include <optional>

namespace lichen::renderer {

enum class NoiseMapping { uv, triplanar, solid };

/// Relative to each material's own values, and clamped to the ranges of the plugin. The default
/// changes nothing.
struct NoiseChanges {
  /// Replaces each material's own; triplanar where the noise does not support it.
  std::optional<NoiseMapping> mapping;
  std::uint32_t seedStep = 0; ///< added to each seed, modulo 2^32
  double scaleFactor = 1.0;
  double contrastFactor = 1.0;
  [[nodiscard]] bool operator==(const NoiseChanges&) const = default;
};

} // namespace lichen::renderer
