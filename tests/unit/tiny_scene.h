// SPDX-License-Identifier: MIT
// Small handmade glTF scenes, and small noises to apply to them.
#pragma once

#include <lichen/bundle_writer.h>

#include <nlohmann/json.hpp>

#include <array>
#include <string>
#include <vector>

namespace lichen::example {

/// A glTF document under construction, with one buffer.
struct TinyScene {
  nlohmann::ordered_json json = {{"asset", {{"version", "2.0"}}}};
  std::vector<std::byte> binary;

  /// Appends bytes as a buffer view; `stride` 0 means none. Returns its index.
  std::size_t addView(std::span<const std::byte> bytes, std::size_t stride = 0);
  /// Appends values as a buffer view and an accessor. Returns the accessor's index.
  template <class Value>
  std::size_t addAccessor(const std::vector<Value>& values, const char* type, int componentType,
                          std::size_t componentCount) {
    const std::size_t view = addView(std::as_bytes(std::span(values)));
    json["accessors"].push_back({{"bufferView", view},
                                 {"componentType", componentType},
                                 {"count", values.size() / componentCount},
                                 {"type", type}});
    return json["accessors"].size() - 1;
  }
  std::size_t addFloats(const std::vector<float>& values, const char* type, std::size_t components);

  /// Returns a GLB, or the text of a .gltf whose buffer is at `uri`.
  [[nodiscard]] std::vector<std::byte> glb() const;
  [[nodiscard]] std::string gltf(const std::string& uri) const;
};

/// A table of two materials: 'wood' is a square with normals, texture coordinates and indices;
/// 'glass' is a closed pyramid with positions only. Both are in mesh 'table', which a node uses.
[[nodiscard]] TinyScene tableScene();

/// A bundle of one texton noise with one map of 3 x 3 coefficients of order 1.
[[nodiscard]] BundleFile smallTexton();

} // namespace lichen::example
