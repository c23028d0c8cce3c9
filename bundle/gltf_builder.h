// SPDX-License-Identifier: MIT
// The binary data of a glTF file under construction: one buffer, its views and accessors.
#pragma once

#include <lichen/json_tree.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace lichen {

enum class ViewTarget { none = 0, vertices = 34962, indices = 34963 };

struct GltfBuilder {
  JsonTree bufferViews = JsonTree::array();
  JsonTree accessors = JsonTree::array();
  std::vector<std::byte> binary;

  /// Appends bytes at a multiple of `alignment`. Returns the index of their view.
  std::size_t addView(std::span<const std::byte> bytes, std::size_t alignment,
                      ViewTarget target = ViewTarget::none);
  /// Adds a tightly packed accessor with its own view. Vertices have float components, indices
  /// 16-bit ones. Returns the accessor's index.
  template <std::size_t kComponents>
  std::size_t addVertices(const std::vector<std::array<float, kComponents>>& values,
                          bool withBounds = false);
  std::size_t addIndices(const std::vector<std::uint16_t>& indices);
};

} // namespace lichen
