// SPDX-License-Identifier: MIT
// Noise and core textures: a noise replaces the textures of the channels it provides, and no
// others.
#include "rendered.h"
#include "synthetic_noise.h"

#include <lichen/image_io.h>

#include <algorithm>
#include <array>
#include <cmath>

using namespace lichen;
using namespace lichen::test;
using nlohmann::json;
using renderer::RenderSettings;

namespace {

const SyntheticMap kBaseColor{3, 64, 64, true, 4};
const SyntheticMap kNormal{2, 64, 64, false, 4};
const SyntheticMap kOrm{1, 64, 64, false, 4};

GltfScene ballOf(std::span<const std::byte> noiseGlb) {
  GltfScene scene(noiseGlb);
  scene.addBall(0);
  scene.addCamera(4.0f, 0.6f);
  scene.addSun(3.0f);
  return scene;
}

GltfScene noiseBall(const std::vector<SyntheticMap>& maps) { return ballOf(syntheticGlb(maps)); }

json& materialOf(GltfScene& scene) { return scene.json["materials"][0]; }

GltfScene withoutNoise(GltfScene scene) {
  materialOf(scene).erase("extensions");
  return scene;
}

LinearImage picture(const GltfScene& scene, const std::string& view = "") {
  RenderSettings settings = settingsOf(64, 64, 1);
  settings.debugView = view;
  return render(scene.glb(), settings);
}

/// The scene's picture with this alpha mode and factor.
LinearImage blended(GltfScene scene, const char* mode, double alpha) {
  materialOf(scene)["alphaMode"] = mode;
  materialOf(scene)["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, alpha};
  return picture(scene);
}

/// A noise with base colour whose second map becomes one of another target, with one channel.
BundleFile withOtherMap(MapTarget target, MapChannel channel) {
  BundleFile file = syntheticBundle(std::vector{kBaseColor, kOrm});
  NoiseMap& map = file.bundle.noises[0].maps[1];
  map.target = target;
  map.channels = {channel};
  map.mean.resize(1);
  map.covariance.resize(1);
  return file;
}

/// A checkerboard in each core texture slot except base colour.
void addCoreTextures(GltfScene& scene) {
  const std::size_t bumps = scene.addChecker(8, {0.65f, 0.5f, 0.95f}, {0.35f, 0.5f, 0.95f});
  const std::size_t orm = scene.addChecker(6, {0.2f, 0.3f, 0.0f}, {1.0f, 0.7f, 0.0f});
  const std::size_t glow = scene.addChecker(4, {0.0f, 0.1f, 0.3f}, {0.2f, 0.0f, 0.0f});
  json& material = materialOf(scene);
  material["normalTexture"]["index"] = bumps;
  material["occlusionTexture"]["index"] = orm;
  material["emissiveTexture"]["index"] = glow;
  material["emissiveFactor"] = {1, 1, 1};
  material["pbrMetallicRoughness"]["metallicRoughnessTexture"]["index"] = orm;
}

/// A base colour texture that is half transparent.
void addHoles(GltfScene& scene) {
  SrgbImage image(64, 64, 4);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) {
      float* pixel = image.pixel(x, y);
      std::fill_n(pixel, 3, 0.5f);
      pixel[3] = (x / 16 + y / 16) % 2 == 0 ? 1.0f : 0.0f;
    }
  const std::size_t view = scene.addView(encodePng(image, 8).value());
  scene.json["images"] = {{{"bufferView", view}, {"mimeType", "image/png"}}};
  scene.json["textures"] = {{{"source", 0}}};
  materialOf(scene)["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
}

} // namespace

TEST_CASE("a noise does not affect core textures of channels it lacks") {
  GltfScene scene = noiseBall({kBaseColor});
  addCoreTextures(scene);
  CHECK(picture(scene).values != picture(withoutNoise(scene)).values);
  CHECK(picture(scene, "normals").values == picture(withoutNoise(scene), "normals").values);
  // With a black factor the base colour has no effect, so both pictures are equal.
  materialOf(scene)["pbrMetallicRoughness"]["baseColorFactor"] = {0, 0, 0, 1};
  CHECK(picture(scene).values == picture(withoutNoise(scene)).values);
}

TEST_CASE("a noise replaces core textures of the channels it provides") {
  GltfScene plain = noiseBall({kBaseColor, kNormal, kOrm});
  GltfScene textured = plain;
  addCoreTextures(textured);
  json& material = materialOf(textured);
  material.erase("emissiveTexture");
  material.erase("emissiveFactor");
  material["pbrMetallicRoughness"]["baseColorTexture"]["index"] =
      textured.addChecker(4, {1, 0, 0}, {0, 1, 0});
  CHECK(picture(plain).values == picture(textured).values);
}

TEST_CASE("a map without a table beside one with a table has its mean light") {
  const LinearImage drawn =
      picture(noiseBall({{3, 64, 64, true, 0, SyntheticTable::none}, kOrm}), "base-color");
  std::array<double, 3> mean{}; // in the middle of the ball
  for (int y = 24; y < 40; ++y)
    for (int x = 24; x < 40; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        mean[c] += double(drawn.pixel(x, y)[c]) / 256.0;
  // Roots with mean 1/2 and deviation 1/10 are 0.5^2 + 0.1^2 = 0.26 as light. An unread table would
  // be black. Tolerance: a quarter, for a few patches of noise.
  for (const double channel : mean)
    CHECK(channel == Approx(0.26).margin(0.06));
}

TEST_CASE("channels that a noise's ORM map lacks come from the core texture") {
  const BundleFile file =
      withOtherMap(MapTarget::occlusionRoughnessMetallic, MapChannel::roughness);
  GltfScene byFactor = ballOf(encodeGlb(file).value());
  GltfScene byTexture = byFactor;
  materialOf(byFactor)["pbrMetallicRoughness"]["metallicFactor"] = 0;
  // Its roughness, 0.9, is unused; metallic is 0.
  const std::size_t texture = byTexture.addChecker(1, {0, 0.9f, 0}, {0, 0.9f, 0});
  json& pbr = materialOf(byTexture)["pbrMetallicRoughness"];
  pbr["metallicRoughnessTexture"]["index"] = texture;
  pbr["metallicFactor"] = 1;
  CHECK(picture(byTexture).values == picture(byFactor).values);
  pbr.erase("metallicRoughnessTexture");
  CHECK(picture(byTexture).values != picture(byFactor).values);
}

TEST_CASE("a masked surface has the same holes in the picture and in its shadow, with and "
          "without a noise") {
  GltfScene scene = noiseBall({kBaseColor});
  addHoles(scene);
  materialOf(scene)["alphaMode"] = "MASK";
  materialOf(scene)["doubleSided"] = true;
  // Through the holes, the sky is visible, which is black in this view.
  CHECK(picture(scene, "normals").values == picture(withoutNoise(scene), "normals").values);
  GltfScene opaque = scene;
  materialOf(opaque).erase("alphaMode");
  CHECK(picture(scene, "normals").values != picture(opaque, "normals").values);

  // With a black factor, only holes and shadows can differ.
  const auto ground = scene.addMaterial({{"pbrMetallicRoughness", {{"metallicFactor", 0}}}});
  scene.addGround(ground, 10.0f, -1.0f);
  materialOf(scene)["pbrMetallicRoughness"]["baseColorFactor"] = {0, 0, 0, 1};
  CHECK(picture(scene).values == picture(withoutNoise(scene)).values);
}

TEST_CASE("a noise's opacity replaces the base colour's alpha, in every alphaMode") {
  BundleFile file = withOtherMap(MapTarget::opacity, MapChannel::opacity);
  file.bundle.materials[0]->contrast = 0.0; // constant: the table's middle
  GltfScene scene = ballOf(encodeGlb(file).value());
  GltfScene plain = noiseBall({kBaseColor});
  materialOf(plain)["extensions"]["LICHEN_materials_exemplar_noise"]["contrast"] = 0.0;
  // From synthetic_noise.cpp's table at (1/2, 1/2, 1/2): 1/2 + sin(3 * 0.65) / 4.
  const double middle = 0.5 + 0.25 * std::sin(3.0 * 0.65);
  // Half floats below 1 have steps of 2^-11 in the table; pictures add a few of them.
  CHECK(largestDifference(blended(plain, "BLEND", middle), blended(scene, "BLEND", 1.0)) <
        4.0 * 0x1p-11);
  CHECK(blended(scene, "OPAQUE", 1.0).values == blended(plain, "OPAQUE", 1.0).values);
  // The cutoff is 1/2, and the ground shows the shadow of the remaining part.
  for (GltfScene* shown : {&scene, &plain})
    shown->addGround(shown->addMaterial(json::object()), 10.0f, -1.0f);
  CHECK(blended(scene, "MASK", 1.0).values == blended(plain, "OPAQUE", 1.0).values);
  CHECK(blended(scene, "MASK", 0.6).values == blended(plain, "MASK", 0.4).values);
  CHECK(blended(scene, "MASK", 0.6).values != blended(plain, "OPAQUE", 1.0).values);
}

TEST_CASE("a blended surface casts a shadow where its opacity is at least 1/2") {
  GltfScene scene = noiseBall({kBaseColor});
  scene.addGround(scene.addMaterial(json::object()), 10.0f, -1.0f);
  addHoles(scene); // half the texels have alpha 0, half have alpha 1
  const auto drawnAt = [&](bool hasNoise, double alpha) {
    return blended(hasNoise ? scene : withoutNoise(scene), "BLEND", alpha);
  };
  for (const bool hasNoise : {false, true})
    CHECK(largestDifference(drawnAt(hasNoise, 0.49), drawnAt(hasNoise, 0.51)) > 0.1);
  // Without a shadow, changing opacity by 0.01 changes a pixel by about 0.01 of its range.
  CHECK(largestDifference(drawnAt(true, 0.48), drawnAt(true, 0.49)) < 0.02);
}

TEST_CASE("a material whose noise has a later revision renders without it, with a note") {
  GltfScene scene = noiseBall({kBaseColor, kNormal});
  addCoreTextures(scene);
  GltfScene later = scene;
  later.json["extensions"]["LICHEN_materials_exemplar_noise"]["noises"][0]["revision"] = 2;
  materialOf(later)["extensions"]["LICHEN_materials_exemplar_noise"]["mapping"] = "surface";
  const auto drawn = renderPicture(later.glb(), settingsOf(64, 64, 1));
  CHECK(drawn.pixels.values == picture(withoutNoise(scene)).values);
  CHECK(drawn.pixels.values != picture(scene).values);
  REQUIRE(drawn.notes.size() == 1);
  CHECK(drawn.notes[0] == "/materials/0: this version does not know its noise's method or "
                          "revision (2); its core textures are used instead");
}

TEST_CASE("the error for a device that cannot filter a noise's table names file and table") {
  const TemporaryFolder folder;
  const auto path = writeInto(folder, "scene.glb", noiseBall({kBaseColor}).glb());
  const auto read = renderer::readScene(path);
  REQUIRE(read.ok());
  VulkanDevice& device = testDevice(); // loads the functions
  static PFN_vkGetInstanceProcAddr real;
  real = vkGetInstanceProcAddr;
  vkGetInstanceProcAddr = [](VkInstance instance, const char* name) -> PFN_vkVoidFunction {
    const PFN_vkGetPhysicalDeviceFormatProperties nothing =
        [](VkPhysicalDevice, VkFormat, VkFormatProperties* properties) { *properties = {}; };
    return std::string_view(name) == "vkGetPhysicalDeviceFormatProperties"
               ? reinterpret_cast<PFN_vkVoidFunction>(nothing)
               : real(instance, name);
  };
  renderer::RenderSettings settings = settingsOf(16, 16, 1);
  settings.pipelines = nullptr; // which has the plugin's functions
  const auto drawn = renderer::renderScene(device, read.value(), settings);
  vkGetInstanceProcAddr = real;
  REQUIRE_FALSE(drawn.ok());
  CHECK(drawn.error().kind == ErrorKind::environment);
  CHECK(drawn.error().message.starts_with(path.string() + ": table "));
}

TEST_CASE("a note names each ignored map of a noise once") {
  const GltfScene scene =
      ballOf(encodeGlb(withOtherMap(MapTarget::height, MapChannel::height)).value());
  const auto notes = renderPicture(scene.glb(), settingsOf(16, 16, 1)).notes;
  REQUIRE(notes.size() == 1);
  CHECK(notes[0] == "the height map of the noise synthetic is ignored; lichen-render --displace "
                    "METRES shows it");
  CHECK(renderPicture(noiseBall({kBaseColor}).glb(), settingsOf(16, 16, 1)).notes.empty());
}
