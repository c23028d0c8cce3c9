// SPDX-License-Identifier: MIT
// What someone who looks at a scene changes about all its noises at once.
#pragma once

#include <cstdint>
#include <optional>

namespace lichen::renderer {

enum class NoiseMapping { uv, triplanar, surface };

/// NoiseChanges::tileRotation of any angle: as many steps of a turn as the format has.
inline constexpr std::uint32_t kFreeTileRotation = 65536;

/// Relative to what each material says, and kept within what the plugin accepts. The default
/// changes nothing.
struct NoiseChanges {
  std::optional<std::uint32_t> noise;  ///< of the bundle, in place of each material's own
  std::optional<NoiseMapping> mapping; ///< uv or triplanar, in place of each material's own
  std::optional<bool> inObjectSpace;   ///< of mappings in space, in place of each material's own
  std::uint32_t seedStep = 0;          ///< added to the seed, modulo 2^32
  double scaleFactor = 1.0;
  double blendSharpnessFactor = 1.0;
  double planeSharpnessFactor = 1.0;
  double contrastFactor = 1.0;
  std::optional<std::uint32_t> tileRotation; ///< in place of each material's own
  [[nodiscard]] bool operator==(const NoiseChanges&) const = default;
};

} // namespace lichen::renderer
