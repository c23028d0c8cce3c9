// SPDX-License-Identifier: MIT
// fuzz_scene_replay: mutations of valid scenes; see replay().
#include "bundle_example.h"
#include "mutation.h"
#include "render_gltf.h"

#include <lichen/gltf_files.h>

using namespace lichen;
using namespace lichen::fuzz;
using nlohmann::json;

namespace {

/// A triangle with a skin, weights of morph targets, sparse positions and all members that a node
/// may have.
Bytes animated() {
  test::GltfScene scene;
  const std::size_t positions = scene.addFloats({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
  const std::size_t moved = scene.addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
  const std::size_t inverse = scene.addFloats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 4);
  scene.json["accessors"][inverse]["type"] = "MAT4";
  scene.json["accessors"][inverse]["count"] = 1;
  const std::size_t changed = scene.addIndices({1}, 2);
  scene.json["accessors"][positions]["sparse"] = {
      {"count", 1},
      {"indices",
       {{"bufferView", scene.json["accessors"][changed]["bufferView"]}, {"componentType", 5123}}},
      {"values", {{"bufferView", scene.json["accessors"][moved]["bufferView"]}}}};
  scene.addMesh({{"POSITION", positions}}, scene.addIndices({0, 1, 2}, 1),
                scene.addMaterial({{"doubleSided", true}}),
                {{"skin", 0}, {"scale", {1, -1, 1}}, {"weights", {0.5}}});
  scene.json["skins"] = {{{"joints", {0}}, {"inverseBindMatrices", inverse}}};
  return scene.glb();
}

/// A ground with a texture in every slot, alpha, a camera and a sun.
Bytes textured() {
  test::GltfScene scene;
  const std::size_t texture = scene.addChecker(1, {1, 1, 1}, {0, 0, 0});
  const json slot{
      {"index", texture},
      {"extensions",
       {{"KHR_texture_transform", {{"offset", {0.5, 0}}, {"rotation", 0.3}, {"scale", {2, 2}}}}}}};
  scene.json["samplers"] = {{{"magFilter", 9728}, {"minFilter", 9985}, {"wrapS", 33071}}};
  scene.json["textures"][texture]["sampler"] = 0;
  scene.addGround(
      scene.addMaterial(
          {{"pbrMetallicRoughness",
            {{"baseColorTexture", slot},
             {"metallicRoughnessTexture", slot},
             {"roughnessFactor", 0.5}}},
           {"normalTexture", {{"index", texture}, {"scale", 0.5}}},
           {"occlusionTexture", {{"index", texture}, {"strength", 0.5}}},
           {"emissiveTexture", slot},
           {"emissiveFactor", {1, 1, 1}},
           {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}}},
           {"alphaMode", "MASK"},
           {"alphaCutoff", 0.3}}),
      1.0f, 0.0f);
  scene.addCamera(3.0f, 0.7f);
  scene.addSun(3.0f);
  return scene.glb();
}

/// One primitive of every mode, with and without indices.
Bytes modes() {
  test::GltfScene scene;
  const std::size_t positions = scene.addFloats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, 3);
  const std::size_t indices = scene.addIndices({0, 1, 2, 3}, 4);
  json primitives = json::array();
  for (int mode = 0; mode <= 6; ++mode) {
    primitives.push_back({{"attributes", {{"POSITION", positions}}}, {"mode", mode}});
    primitives.push_back(
        {{"attributes", {{"POSITION", positions}}}, {"indices", indices}, {"mode", mode}});
  }
  scene.json["meshes"] = {{{"primitives", primitives}}};
  scene.json["nodes"] = {{{"mesh", 0}}};
  scene.json["scenes"][0]["nodes"] = {0};
  return scene.glb();
}

Bytes bundle() {
  BundleFile file = example::smallest();
  file.previews[0].baseColor = example::tinyPng();
  file.shape = PreviewShape::plane;
  return encodeGlb(file).value();
}

/// Small files, so that mutations hit structure instead of vertices.
std::vector<Bytes> seeds() {
  return {animated(), textured(), modes(), bundle(), encodeGlb(example::textonMix()).value()};
}

Bytes mutated(const std::vector<Bytes>& files, Random& random) {
  Bytes file = files[below(random, files.size())];
  constexpr std::size_t kMostMutations = 3;
  const std::size_t count = 1 + below(random, kMostMutations);
  if (random() % 4 == 0) {
    for (std::size_t i = 0; i < count; ++i)
      mutateBytes(file, files, random);
    return file;
  }
  test::GltfScene scene(file);
  for (std::size_t i = 0; i < count; ++i)
    mutateJson(scene.json, random);
  if (random() % 2 == 0 && !scene.binary.empty())
    scene.binary[below(random, scene.binary.size())] ^= std::byte(1u << (random() % 8));
  return frameGlb(scene.json.dump(), scene.binary);
}

} // namespace

int main(int argumentCount, char** arguments) {
  const std::vector<Bytes> files = seeds();
  return replay({arguments, std::size_t(argumentCount)}, files,
                [&](Random& random) { return mutated(files, random); });
}
