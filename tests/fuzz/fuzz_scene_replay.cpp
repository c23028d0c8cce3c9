// SPDX-License-Identifier: MIT
// fuzz_scene_replay CASES SEED REGRESSIONS: runs the files of a folder, on which the loader once
// failed, and mutations of valid scenes through the fuzzer's entry point; deterministic.
// fuzz_scene_replay corpus FOLDER: writes the unmutated files as a corpus for libFuzzer: scenes
// from this file, the glTF files of Debian's assimp-testmodels if installed, and bundles.
#include "bundle_example.h"
#include "gltf_mutation.h"
#include "render_gltf.h"

#include <lichen/base64.h>
#include <lichen/files.h>
#include <lichen/gltf_container.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

using namespace lichen;
using namespace lichen::fuzz;
using nlohmann::json;

namespace {

const std::filesystem::path kModels = "/usr/share/assimp/models";

/// Maximum processor time for one small file. The loader itself may take two seconds; sanitizers
/// take about ten times as long.
constexpr double kMostSeconds = 20.0;

/// A triangle with a skin, a morph target, sparse positions and all members that a node may have.
Bytes animated() {
  test::GltfScene scene;
  const std::size_t positions = scene.addFloats({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
  const std::size_t moved = scene.addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
  const std::size_t joints = scene.addIndices(std::vector<std::uint32_t>(3 * 4, 0), 2);
  scene.json["accessors"][joints]["type"] = "VEC4";
  scene.json["accessors"][joints]["count"] = 3;
  const std::size_t weights = scene.addFloats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 4);
  const std::size_t inverse = scene.addFloats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 4);
  scene.json["accessors"][inverse]["type"] = "MAT4";
  scene.json["accessors"][inverse]["count"] = 1;
  const std::size_t changed = scene.addIndices({1}, 2);
  scene.json["accessors"][positions]["sparse"] = {
      {"count", 1},
      {"indices",
       {{"bufferView", scene.json["accessors"][changed]["bufferView"]}, {"componentType", 5123}}},
      {"values", {{"bufferView", scene.json["accessors"][moved]["bufferView"]}}}};
  scene.addMesh({{"POSITION", positions}, {"JOINTS_0", joints}, {"WEIGHTS_0", weights}},
                scene.addIndices({0, 1, 2}, 1), scene.addMaterial({{"doubleSided", true}}),
                {{"skin", 0}, {"scale", {1, -1, 1}}, {"weights", {0.5}}});
  scene.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", moved}}};
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

/// Embeds the files that a .gltf refers to, because a fuzzer's input is a single file.
Bytes selfContained(const std::filesystem::path& path, const Bytes& file) {
  std::variant<GltfContainer, Finding> opened = openGltf(file);
  auto* container = std::get_if<GltfContainer>(&opened);
  if (!container || container->isGlb)
    return file;
  json& document = container->document;
  for (const char* kind : {"buffers", "images"}) {
    if (!document.contains(kind) || !document[kind].is_array())
      continue;
    for (json& item : document[kind]) {
      if (!item.is_object() || !item.contains("uri") || !item["uri"].is_string())
        continue;
      const auto bytes = readFile(path.parent_path() / item["uri"].get<std::string>());
      if (bytes)
        item["uri"] = "data:application/octet-stream;base64," + encodeBase64(bytes.value());
    }
  }
  const std::string text = document.dump(-1, ' ', false, json::error_handler_t::replace);
  const auto bytes = std::as_bytes(std::span(text));
  return {bytes.begin(), bytes.end()};
}

bool write(const std::filesystem::path& path, const Bytes& file) {
  std::ofstream stream(path, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(file.data()), std::streamsize(file.size()));
  return bool(stream);
}

int writeCorpus(const std::filesystem::path& folder) {
  constexpr std::size_t kMostBytes = std::size_t(1) << 18; // larger files are slow
  std::vector<Bytes> files = seeds();
  if (std::filesystem::is_directory(kModels))
    for (const auto& entry : std::filesystem::recursive_directory_iterator(kModels))
      if (entry.path().extension() == ".gltf" || entry.path().extension() == ".glb")
        if (const auto bytes = readFile(entry.path()))
          files.push_back(selfContained(entry.path(), bytes.value()));
  int index = 0;
  for (const Bytes& file : files)
    if (file.size() <= kMostBytes && !write(folder / ("scene-" + std::to_string(index++)), file))
      return EXIT_FAILURE;
  return EXIT_SUCCESS;
}

Bytes mutated(const std::vector<Bytes>& files, Random& random) {
  Bytes file = files[below(random, files.size())];
  constexpr std::size_t kMostMutations = 3;
  const std::size_t count = 1 + below(random, kMostMutations);
  if (random() % 4 == 0) {
    for (std::size_t i = 0; i < count; ++i)
      mutateBytes(file, random);
    return file;
  }
  test::GltfScene scene(file);
  for (std::size_t i = 0; i < count; ++i)
    mutateJson(scene.json, random);
  if (random() % 2 == 0 && !scene.binary.empty())
    scene.binary[below(random, scene.binary.size())] ^= std::byte(1u << (random() % 8));
  return frameGlb(scene.json.dump(), scene.binary);
}

void run(const Bytes& file) {
  LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(file.data()), file.size());
}

/// Number of files; nullopt if one cannot be read or takes too long.
std::optional<std::size_t> replayFolder(const std::string& folder) {
  const auto files = listFolder(folder);
  if (!files)
    return std::nullopt;
  for (const std::filesystem::path& path : files.value()) {
    const auto file = readFile(path);
    if (!file)
      return std::nullopt;
    const std::clock_t start = std::clock();
    run(file.value());
    const double seconds = double(std::clock() - start) / CLOCKS_PER_SEC;
    if (seconds > kMostSeconds) {
      std::fprintf(stderr, "%s: %.1f s, more than %.0f\n", path.c_str(), seconds, kMostSeconds);
      return std::nullopt;
    }
  }
  return files.value().size();
}

} // namespace

int main(int argumentCount, char** arguments) {
  if (argumentCount == 3 && std::string(arguments[1]) == "corpus")
    return writeCorpus(arguments[2]);
  if (argumentCount != 4) {
    std::fprintf(stderr, "usage: fuzz_scene_replay CASES SEED REGRESSIONS | corpus FOLDER\n");
    return 2;
  }
  const std::optional<std::size_t> replayed = replayFolder(arguments[3]);
  if (!replayed)
    return EXIT_FAILURE;
  const std::vector<Bytes> files = seeds();
  const unsigned long long cases = std::strtoull(arguments[1], nullptr, 10);
  const unsigned long long seed = std::strtoull(arguments[2], nullptr, 10);
  for (unsigned long long i = 0; i < cases; ++i) {
    Random random(seed * cases + i);
    run(mutated(files, random));
  }
  std::printf("%zu regression files, %llu mutated files, none mishandled\n", *replayed, cases);
  return EXIT_SUCCESS;
}
