// SPDX-License-Identifier: MIT
// write_validator_samples FOLDER: writes bundles of every kind of map, in every preview shape and
// both file forms, and images of material sets to bake.
#include "bundle_example.h"
#include "tiny_scene.h"

#include <lichen/files.h>
#include <lichen/image_io.h>

#include <cstdio>

namespace {

using namespace lichen;

/// Ramps that differ in every channel and repeat every 8 pixels.
SrgbImage ramps(int channels) {
  SrgbImage image(16, 16, channels);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      for (int c = 0; c < channels; ++c)
        image.pixel(x, y)[c] = float((x * (c + 1) + y) % 8) / 7.0f;
  return image;
}

Result<void> writeSets(const std::filesystem::path& folder) {
  for (const char* name : {"every_map", "height_only"})
    std::filesystem::create_directories(folder / name);
  for (const auto& [name, channels] : {std::pair{"every_map/color.png", 4},
                                       {"every_map/normal.png", 3},
                                       {"every_map/orm.png", 3},
                                       {"every_map/emissive.png", 3},
                                       {"every_map/height.png", 1},
                                       {"height_only/height.png", 1}})
    if (Result<void> written = writeImage(folder / name, ramps(channels)); !written)
      return written;
  return {};
}

/// A scene whose materials have other extensions and an image in a data URI.
example::TinyScene shadedScene() {
  example::TinyScene scene = example::tableScene();
  const std::string dot = // a PNG of one pixel
      "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4z8AAAAMBAQDJ/pLvAAAAAElFTkSu"
      "QmCC";
  scene.json["extensionsUsed"] = {"KHR_materials_clearcoat", "KHR_materials_unlit"};
  scene.json["images"] = {{{"uri", "data:image/png;base64," + dot}}};
  scene.json["textures"] = {{{"source", 0}}};
  scene.json["materials"][0]["emissiveTexture"] = {{"index", 0}};
  scene.json["materials"][0]["extensions"]["KHR_materials_clearcoat"] = {{"clearcoatFactor", 1}};
  scene.json["materials"][1]["extensions"]["KHR_materials_unlit"] =
      nlohmann::ordered_json::object();
  return scene;
}

/// A scene whose materials have an extension that `lichen apply` removes, which is required, and
/// extensions that it keeps.
example::TinyScene competingScene() {
  using Json = nlohmann::ordered_json;
  example::TinyScene scene = shadedScene();
  scene.json["extensionsUsed"].push_back("KHR_texture_transform");
  scene.json["extensionsRequired"] = {"KHR_materials_unlit"};
  Json& material = scene.json["materials"][0];
  material["emissiveTexture"] = {{"index", 0},
                                 {"extensions", {{"KHR_texture_transform", {{"scale", {2, 2}}}}}}};
  material["extensions"]["KHR_materials_unlit"] = Json::object();
  return scene;
}

/// Writes a third-party scene, as one file and as two, and a noise for its surfaces.
Result<void> writeScenes(const std::filesystem::path& folder) {
  const example::TinyScene scene = example::tableScene();
  const std::string text = scene.gltf("table.bin");
  const example::TinyScene shaded = shadedScene();
  const std::string shadedText = shaded.gltf("shaded.bin");
  const example::TinyScene competing = competingScene();
  const std::string competingText = competing.gltf("competing.bin");
  for (const Result<void>& written :
       {replaceFile(folder / "table.glb", scene.glb()),
        replaceFile(folder / "table.bin", scene.binary),
        replaceFile(folder / "table.gltf", std::as_bytes(std::span(text))),
        replaceFile(folder / "shaded.bin", shaded.binary),
        replaceFile(folder / "shaded.gltf", std::as_bytes(std::span(shadedText))),
        replaceFile(folder / "competing.bin", competing.binary),
        replaceFile(folder / "competing.gltf", std::as_bytes(std::span(competingText))),
        writeBundle(folder / "wool.glb", example::smallTexton())})
    if (!written)
      return written;
  return {};
}

} // namespace

int main(int argumentCount, char** arguments) {
  if (argumentCount != 2) {
    std::fprintf(stderr, "usage: write_validator_samples FOLDER\n");
    return 2;
  }
  struct Sample {
    const char* name;
    PreviewShape shape;
  };
  constexpr std::array<Sample, 4> kSamples = {{{"sphere.glb", PreviewShape::sphere},
                                               {"plane.glb", PreviewShape::plane},
                                               {"none.glb", PreviewShape::none},
                                               {"separate.gltf", PreviewShape::sphere}}};
  for (const Sample& sample : kSamples) {
    BundleFile file = example::everyMap();
    file.shape = sample.shape;
    const Result<void> written =
        writeBundle(std::filesystem::path(arguments[1]) / sample.name, file);
    if (!written) {
      std::fprintf(stderr, "%s\n", written.error().message.c_str());
      return 1;
    }
  }
  for (const Result<void>& written : {writeSets(arguments[1]), writeScenes(arguments[1])})
    if (!written) {
      std::fprintf(stderr, "%s\n", written.error().message.c_str());
      return 1;
    }
  return 0;
}
