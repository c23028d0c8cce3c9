// SPDX-License-Identifier: MIT
#include "bundle/gltf_container.h"
#include "landscape.h"
#include "materials.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <string>

using namespace lichen;
using exemplars::kMaterials;
using exemplars::Material;

namespace {

/// 64-bit FNV-1a of the image's 8-bit values.
std::uint64_t fingerprint(const SrgbImage& image) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const float value : image.values)
    hash = (hash ^ std::uint64_t(std::lround(value * 255.0f))) * 0x100000001b3u;
  return hash;
}

} // namespace

TEST_CASE("every exemplar has the same bytes on every run and machine") {
  // Recorded from the generators. They change only when a material is changed on purpose.
  const std::map<std::string, std::uint64_t> expected{
      {"granite", 0x9df5416b37c7cd82u}, {"lichen_on_stone", 0xf785353a6c12a436u},
      {"moss", 0xcd673f2c5085c7aau},    {"rust", 0x7d9d1f2d7b0ec06fu},
      {"sand", 0x2c23e81269a770f9u},    {"terrazzo", 0x1deb40914e40c83fu},
  };
  for (const Material& material : kMaterials) {
    INFO(material.name);
    CHECK(fingerprint(material.generate(96)) == expected.at(material.name));
  }
}

TEST_CASE("the landscape has a million triangles that all face upwards, and rock has blended edges",
          "[large]") {
  const std::vector<std::byte> glb = exemplars::landscapeGlb();
  const auto opened = openGltf(glb);
  const auto& file = std::get<GltfContainer>(opened);
  const auto values = [&](std::size_t accessor, auto sample) {
    const auto& view =
        file.document["bufferViews"]
                     [file.document["accessors"][accessor]["bufferView"].get<std::size_t>()];
    std::vector<decltype(sample)> result(view["byteLength"].get<std::size_t>() / sizeof sample);
    std::memcpy(result.data(), file.binaryChunk->data() + view["byteOffset"].get<std::size_t>(),
                result.size() * sizeof sample);
    return result;
  };
  const auto& parts = file.document["meshes"][0]["primitives"];
  const auto positions =
      values(parts[0]["attributes"]["POSITION"].get<std::size_t>(), std::array<float, 3>());
  const auto colors =
      values(parts[0]["attributes"]["COLOR_0"].get<std::size_t>(), std::array<std::uint8_t, 4>());
  REQUIRE(parts.size() == 3);
  REQUIRE(colors.size() == positions.size());
  CHECK(file.document["materials"][2]["alphaMode"] == "BLEND");
  std::set<std::array<std::uint32_t, 3>> ground;
  std::size_t triangles = 0, downwards = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto indices =
        values(parts[k]["indices"].get<std::size_t>(), std::array<std::uint32_t, 3>());
    CHECK(indices.size() > 20'000);
    if (k == 0)
      ground.insert(indices.begin(), indices.end());
    if (k < 2)
      triangles += indices.size();
    for (const auto& triangle : indices) {
      // Layers of rock lie on ground. A vertex is rock if it would show none of the ground.
      const auto isWhole = [&](std::uint32_t vertex) { return colors[vertex][3] == 255; };
      if (k == 1)
        REQUIRE(std::all_of(triangle.begin(), triangle.end(), isWhole));
      if (k == 2)
        REQUIRE(ground.contains(triangle));
    }
    for (const auto& [a, b, c] : indices) {
      const auto &p = positions[a], &q = positions[b], &r = positions[c];
      downwards += (q[2] - p[2]) * (r[0] - p[0]) - (q[0] - p[0]) * (r[2] - p[2]) <= 0.0f;
    }
  }
  CHECK(triangles == 1'000'000);
  CHECK(downwards == 0);
}
