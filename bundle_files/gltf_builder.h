// SPDX-License-Identifier: MIT
// Binary data to be added to a glTF document: one buffer, its views and accessors.
#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace lichen {

enum class ViewTarget { none = 0, vertices = 34962, indices = 34963 };

struct GltfBuilder {
  std::size_t firstView = 0;     ///< number of views that the document has without these
  std::size_t firstAccessor = 0; ///< number of accessors that it has without these
  nlohmann::ordered_json bufferViews = nlohmann::ordered_json::array();
  nlohmann::ordered_json accessors = nlohmann::ordered_json::array();
  std::vector<std::byte> binary;

  /// Appends bytes at a multiple of `alignment`. Returns the index of their view in the document.
  std::size_t addView(std::span<const std::byte> bytes, std::size_t alignment,
                      ViewTarget target = ViewTarget::none);
  /// Adds a tightly packed accessor with its own view. Vertices have float components, indices
  /// 16-bit ones. Returns the accessor's index in the document.
  template <std::size_t kComponents>
  std::size_t addVertices(std::span<const std::array<float, kComponents>> values,
                          bool withBounds = false);
  std::size_t addIndices(const std::vector<std::uint16_t>& indices);
};

} // namespace lichen
