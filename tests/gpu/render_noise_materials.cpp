// SPDX-License-Identifier: MIT
// A noise beside core textures: it takes the place of those whose channels it has, and of no other.
#include "rendered.h"
#include "synthetic_noise.h"
#include "synthetic_texton.h"

#include <lichen/image_io.h>

#include <algorithm>
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

/// A checkerboard in each core texture slot but the base colour's.
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

/// A base colour texture half of which is transparent.
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

TEST_CASE("core textures of what a noise lacks are drawn as without it") {
  GltfScene scene = noiseBall({kBaseColor});
  addCoreTextures(scene);
  CHECK(picture(scene).values != picture(withoutNoise(scene)).values);
  CHECK(picture(scene, "normals").values == picture(withoutNoise(scene), "normals").values);
  // With a black factor nothing is left of the base colour, and the pictures are one.
  materialOf(scene)["pbrMetallicRoughness"]["baseColorFactor"] = {0, 0, 0, 1};
  CHECK(picture(scene).values == picture(withoutNoise(scene)).values);
}

TEST_CASE("core textures of what a noise has are not drawn") {
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

TEST_CASE(
    "noises with a separable table, or without one, are drawn beside one with a joint table") {
  // In the middle of the ball. Stored values of mean 1/2 and deviation 1/10, as light: 0.223. The
  // separable table's values average 0.5 +- 0.1 a channel, and its map takes 1/2 each to 0.4, 0.55
  // and 0.07. An unread table would be black. A few patches of noise: a tenth either way.
  const auto middleOf = [](const SyntheticMap& map) {
    const LinearImage image = picture(noiseBall({map, kOrm}), "base-color");
    std::array<double, 3> mean{};
    for (int y = 24; y < 40; ++y)
      for (int x = 24; x < 40; ++x)
        for (std::size_t c = 0; c < 3; ++c)
          mean[c] += double(image.pixel(x, y)[c]) / 256.0;
    return mean;
  };
  for (const double channel : middleOf({3, 64, 64, true, 0, SyntheticTable::none}))
    CHECK(channel == Approx(0.223).margin(0.06));
  const auto separable = middleOf({3, 64, 64, true, 4, SyntheticTable::separable});
  CHECK(separable[0] == Approx(0.4).margin(0.15));
  CHECK(separable[1] == Approx(0.54).margin(0.15));
  CHECK(separable[2] == Approx(0.08).margin(0.15));
}

TEST_CASE("a noise of textons is drawn, and its impacts are shown") {
  const SyntheticTexton texton;
  BundleFile file = syntheticTextonBundle(texton);
  const GltfScene scene = ballOf(encodeGlb(file).value());
  file.bundle.materials[0]->seed = 2;
  const GltfScene other = ballOf(encodeGlb(file).value());
  const auto meanOf = [](const LinearImage& image) {
    std::array<double, 3> mean{};
    for (int y = 24; y < 40; ++y)
      for (int x = 24; x < 40; ++x)
        for (std::size_t c = 0; c < 3; ++c)
          mean[c] += double(image.pixel(x, y)[c]) / 256.0;
    return mean;
  };
  // In the middle of the ball: stored values of mean 1/2 and deviation 0.08, as light 0.222. A few
  // patches of noise: a fifth either way.
  const LinearImage color = picture(scene, "base-color");
  for (const double channel : meanOf(color))
    CHECK(channel == Approx(0.222).margin(0.05));
  CHECK(color.values != picture(other, "base-color").values);
  // 30 of 60 impacts are green; 24 to 36 have at least half of it, and none is white.
  const auto impacts = meanOf(picture(scene, "impacts"));
  CHECK(impacts[1] > 0.8);
  CHECK(impacts[0] < 0.5);
  CHECK(impacts[2] < 0.5);
  const auto gaussian = meanOf(picture(scene, "gaussian"));
  CHECK(gaussian[0] == Approx(0.5).margin(0.15));
  // Views of the lattice have nothing to show.
  CHECK(meanOf(picture(scene, "lattice"))[0] == Approx(0.5).margin(0.001));
}

TEST_CASE("the channels that a noise's ORM lacks come from the core texture") {
  BundleFile file = syntheticBundle(std::vector{kBaseColor, kOrm});
  NoiseMap& orm = file.bundle.noises[0].maps[1];
  orm.channels = {MapChannel::roughness};
  orm.mean.resize(1);
  orm.covariance.resize(1);
  GltfScene byFactor = ballOf(encodeGlb(file).value());
  GltfScene byTexture = byFactor;
  materialOf(byFactor)["pbrMetallicRoughness"]["metallicFactor"] = 0;
  // Its roughness, 0.9, is not used; metallic is 0.
  const std::size_t texture = byTexture.addChecker(1, {0, 0.9f, 0}, {0, 0.9f, 0});
  json& pbr = materialOf(byTexture)["pbrMetallicRoughness"];
  pbr["metallicRoughnessTexture"]["index"] = texture;
  pbr["metallicFactor"] = 1;
  CHECK(picture(byTexture).values == picture(byFactor).values);
  pbr.erase("metallicRoughnessTexture");
  CHECK(picture(byTexture).values != picture(byFactor).values);
}

TEST_CASE("the holes of a mask are where the shadow has them, with a noise as without") {
  GltfScene scene = noiseBall({kBaseColor});
  addHoles(scene);
  materialOf(scene)["alphaMode"] = "MASK";
  materialOf(scene)["doubleSided"] = true;
  // What is seen through the holes has no normal: the sky, and black in this view.
  CHECK(picture(scene, "normals").values == picture(withoutNoise(scene), "normals").values);
  GltfScene opaque = scene;
  materialOf(opaque).erase("alphaMode");
  CHECK(picture(scene, "normals").values != picture(opaque, "normals").values);

  // With a black factor only holes and shadows are left to differ.
  const auto ground = scene.addMaterial({{"pbrMetallicRoughness", {{"metallicFactor", 0}}}});
  scene.addGround(ground, 10.0f, -1.0f);
  materialOf(scene)["pbrMetallicRoughness"]["baseColorFactor"] = {0, 0, 0, 1};
  CHECK(picture(scene).values == picture(withoutNoise(scene)).values);
}

TEST_CASE("a noise's opacity is the base colour's alpha, of which alphaMode makes what glTF says") {
  BundleFile file = syntheticBundle(std::vector{kBaseColor, kOrm});
  const auto withoutOpacity = ballOf(encodeGlb(syntheticBundle(std::vector{kBaseColor})).value());
  NoiseMap& map = file.bundle.noises[0].maps[1];
  map.target = MapTarget::opacity;
  map.channels = {MapChannel::opacity};
  map.mean.resize(1);
  map.covariance.resize(1);
  file.bundle.materials[0]->contrast = 0.0; // one value everywhere: the table's middle
  GltfScene scene = ballOf(encodeGlb(file).value());
  GltfScene plain = withoutOpacity;
  materialOf(plain)["extensions"]["LICHEN_materials_exemplar_noise"]["contrast"] = 0.0;
  const auto drawn = [](GltfScene shown, const char* mode, double alpha) {
    materialOf(shown)["alphaMode"] = mode;
    materialOf(shown)["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, alpha};
    return picture(shown);
  };
  // Of synthetic_noise.cpp's table at (1/2, 1/2, 1/2): 1/2 + sin(3 * 0.65) / 4.
  const double middle = 0.5 + 0.25 * std::sin(3.0 * 0.65);
  const LinearImage wanted = drawn(plain, "BLEND", middle);
  const LinearImage found = drawn(scene, "BLEND", 1.0);
  double largest = 0.0;
  for (std::size_t i = 0; i < wanted.values.size(); ++i)
    largest = std::max(largest, std::abs(double(found.values[i]) - double(wanted.values[i])));
  // The table's half floats below 1 have steps of 2^-11, pictures a few of light.
  CHECK(largest < 4.0 * 0x1p-11);
  CHECK(drawn(scene, "OPAQUE", 1.0).values == drawn(plain, "OPAQUE", 1.0).values);
  // The cutoff is 1/2, and the ground has the shadow of what it leaves.
  for (GltfScene* shown : {&scene, &plain})
    shown->addGround(shown->addMaterial(json::object()), 10.0f, -1.0f);
  CHECK(drawn(scene, "MASK", 1.0).values == drawn(plain, "OPAQUE", 1.0).values);
  CHECK(drawn(scene, "MASK", 0.6).values == drawn(plain, "MASK", 0.4).values);
  CHECK(drawn(scene, "MASK", 0.6).values != drawn(plain, "OPAQUE", 1.0).values);
}

TEST_CASE("what is blended casts a shadow where its opacity is at least a half") {
  GltfScene scene = noiseBall({kBaseColor});
  scene.addGround(scene.addMaterial(json::object()), 10.0f, -1.0f);
  addHoles(scene); // texels of alpha 0 and 1, by halves
  const auto drawn = [&](bool hasNoise, double alpha) {
    GltfScene shown = hasNoise ? scene : withoutNoise(scene);
    materialOf(shown)["alphaMode"] = "BLEND";
    materialOf(shown)["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, alpha};
    return picture(shown);
  };
  const auto largestDifference = [](const LinearImage& a, const LinearImage& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
      largest = std::max(largest, std::abs(double(a.values[i]) - double(b.values[i])));
    return largest;
  };
  for (const bool hasNoise : {false, true})
    CHECK(largestDifference(drawn(hasNoise, 0.49), drawn(hasNoise, 0.51)) > 0.1);
  // Without a shadow, a hundredth of opacity changes a pixel by about a hundredth of its range.
  CHECK(largestDifference(drawn(true, 0.48), drawn(true, 0.49)) < 0.02);
}

TEST_CASE("a material whose noise is of a later revision is drawn as without it, with a note") {
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
                          "revision (2); the core textures are drawn");
}

TEST_CASE("a device that cannot filter a noise's table is refused by the file and the table") {
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
  const auto drawn = renderer::renderScene(device, read.value(), settingsOf(16, 16, 1));
  vkGetInstanceProcAddr = real;
  REQUIRE_FALSE(drawn.ok());
  CHECK(drawn.error().kind == ErrorKind::environment);
  CHECK(drawn.error().message.starts_with(path.string() + ": table "));
}

TEST_CASE("maps of a noise that are not drawn are named once for each") {
  BundleFile file = syntheticBundle(std::vector{kBaseColor, kOrm});
  NoiseMap& height = file.bundle.noises[0].maps[1];
  height.target = MapTarget::height;
  height.channels = {MapChannel::height};
  height.mean.resize(1);
  height.covariance.resize(1);
  const GltfScene scene = ballOf(encodeGlb(file).value());
  const auto notes = renderPicture(scene.glb(), settingsOf(16, 16, 1)).notes;
  REQUIRE(notes.size() == 1);
  CHECK(notes[0] == "the height of the noise synthetic is not drawn");
  CHECK(renderPicture(noiseBall({kBaseColor}).glb(), settingsOf(16, 16, 1)).notes.empty());
}
