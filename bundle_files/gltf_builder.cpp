// SPDX-License-Identifier: MIT
// Buffer views and accessors of a glTF file under construction; see gltf_builder.h.
#include "gltf_builder.h"

#include <algorithm>

namespace lichen {

using Json = nlohmann::ordered_json;

std::size_t GltfBuilder::addView(std::span<const std::byte> bytes, std::size_t alignment,
                                 ViewTarget target) {
  binary.resize((binary.size() + alignment - 1) / alignment * alignment);
  Json view = {{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}};
  if (target != ViewTarget::none)
    view["target"] = int(target);
  binary.insert(binary.end(), bytes.begin(), bytes.end());
  bufferViews.push_back(std::move(view));
  return firstView + bufferViews.size() - 1;
}

template <std::size_t kComponents>
std::size_t GltfBuilder::addVertices(std::span<const std::array<float, kComponents>> values,
                                     bool withBounds) {
  constexpr int kFloat = 5126;
  Json accessor = {
      {"bufferView", addView(std::as_bytes(values), sizeof(float), ViewTarget::vertices)},
      {"componentType", kFloat},
      {"count", values.size()},
      {"type", "VEC" + std::to_string(kComponents)}};
  if (withBounds) {
    auto least = values.front();
    auto most = values.front();
    for (const auto& value : values)
      for (std::size_t c = 0; c < kComponents; ++c) {
        least[c] = std::min(least[c], value[c]);
        most[c] = std::max(most[c], value[c]);
      }
    accessor["min"] = least;
    accessor["max"] = most;
  }
  accessors.push_back(std::move(accessor));
  return firstAccessor + accessors.size() - 1;
}

template std::size_t GltfBuilder::addVertices(std::span<const std::array<float, 2>>, bool);
template std::size_t GltfBuilder::addVertices(std::span<const std::array<float, 3>>, bool);
template std::size_t GltfBuilder::addVertices(std::span<const std::array<float, 4>>, bool);

std::size_t GltfBuilder::addIndices(const std::vector<std::uint16_t>& indices) {
  constexpr int kUnsignedShort = 5123;
  const std::size_t view =
      addView(std::as_bytes(std::span(indices)), sizeof(std::uint32_t), ViewTarget::indices);
  accessors.push_back({{"bufferView", view},
                       {"componentType", kUnsignedShort},
                       {"count", indices.size()},
                       {"type", "SCALAR"}});
  return firstAccessor + accessors.size() - 1;
}

} // namespace lichen
