// SPDX-License-Identifier: MIT
// What a viewer without our extension shows for a material set from `lichen bake`.
#include "set_run.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <span>

using namespace lichen;
using namespace lichen::cli_test;
using nlohmann::json;

namespace {

/// The core material of a GLB, as a viewer without our extension reads it.
struct CoreMaterial {
  json material;
  std::vector<SrgbImage> images; ///< image i, which texture i uses
  bool hasTangents = false;      ///< at least one primitive has them
};

CoreMaterial coreMaterialOf(const std::string& glb) {
  // A GLB header of 12 bytes, then two chunks with headers of 8 bytes: the JSON and the buffer.
  const auto wordAt = [&](std::size_t at) {
    std::uint32_t word = 0;
    std::memcpy(&word, &glb[at], sizeof word);
    return word;
  };
  const std::size_t textBytes = wordAt(12);
  const json gltf = json::parse(glb.substr(20, textBytes));
  const auto* buffer = reinterpret_cast<const std::byte*>(&glb[20 + textBytes + 8]);
  CoreMaterial core{gltf.at("materials").at(0), {}, false};
  for (const json& texture : gltf.at("textures")) {
    const json& image = gltf.at("images").at(texture.at("source").get<std::size_t>());
    const json& view = gltf.at("bufferViews").at(image.at("bufferView").get<std::size_t>());
    const std::span file(buffer + view.at("byteOffset").get<std::size_t>(),
                         view.at("byteLength").get<std::size_t>());
    core.images.push_back(std::get<SrgbImage>(decodeImage(file, "preview").value().pixels));
  }
  for (const json& mesh : gltf.at("meshes"))
    for (const json& primitive : mesh.at("primitives"))
      core.hasTangents = core.hasTangents || primitive.at("attributes").contains("TANGENT");
  return core;
}

/// Checks that every pixel of the texture that `info` references is `wanted`.
void checkPreview(const CoreMaterial& core, const json& info, const Pixel& wanted) {
  const SrgbImage& image = core.images.at(info.at("index").get<std::size_t>());
  REQUIRE(std::size_t(image.channels) == wanted.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < image.values.size(); ++i)
    largest =
        std::max(largest, std::abs(double(image.values[i]) - double(wanted[i % wanted.size()])));
  CHECK(largest < 1.5 / 255.0); // rounding by the table and by PNG
}

} // namespace

TEST_CASE("the core material of a set has each map in its slot") {
  const Workplace workplace;
  const Pixel glow{code(40), code(80), code(10)};
  const std::string set = writeSet(workplace, {{"diff.png", kColor},
                                               {"opacity.png", {code(140)}},
                                               {"nor_gl.png", kNormal},
                                               {"emissive.png", glow},
                                               {"rough.png", {code(102)}}});
  baked(workplace, {set});
  const CoreMaterial core = coreMaterialOf(workplace.read("set.glb"));
  CHECK(core.material.at("alphaMode") == "BLEND");
  const json& pbr = core.material.at("pbrMetallicRoughness");
  CHECK(pbr.at("metallicFactor") == 0.0); // there is no metallic map
  CHECK(pbr.at("roughnessFactor") == 1.0);
  CHECK(core.material.at("emissiveFactor") == json({1.0, 1.0, 1.0}));
  CHECK_FALSE(core.material.contains("occlusionTexture"));
  Pixel colorAndOpacity = kColor;
  colorAndOpacity.push_back(code(140));
  checkPreview(core, pbr.at("baseColorTexture"), colorAndOpacity);
  checkPreview(core, core.material.at("normalTexture"), kNormal);
  checkPreview(core, pbr.at("metallicRoughnessTexture"), {1.0f, code(102), 1.0f});
  checkPreview(core, core.material.at("emissiveTexture"), glow);
  CHECK(core.hasTangents);

  baked(workplace, {set + "/opacity.png", set + "/rough.png"});
  const CoreMaterial rest = coreMaterialOf(workplace.read("set.glb"));
  CHECK_FALSE(rest.hasTangents);
  checkPreview(rest, rest.material.at("pbrMetallicRoughness").at("baseColorTexture"),
               {1.0f, 1.0f, 1.0f, code(140)});
}
