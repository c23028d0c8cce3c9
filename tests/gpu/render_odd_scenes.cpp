// SPDX-License-Identifier: MIT
// Scenes that glTF allows and exporters seldom write: each is drawn, the validation layers say
// nothing, and no value of the picture is NaN.
#include "gpu_scene.h"
#include "noise_context.h"
#include "rendered.h"

#include <lichen/image_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

using namespace lichen;
using namespace lichen::test;
using nlohmann::json;

namespace {

void addTriangleWithoutArea(GltfScene& scene) {
  scene.addMesh({{"POSITION", scene.addFloats({0, 0, 0, 0.5, 0, 0, 1, 0, 0}, 3)}},
                scene.addIndices({0, 1, 2, 0, 0, 0}, 1), 0);
}

constexpr int kWidth = 48, kHeight = 32;
constexpr float kFieldOfView = 0.6f, kDistance = 4.0f;

/// A sphere of triangles, with a textured material and a normal texture.
GltfScene plainScene() {
  GltfScene scene;
  const std::size_t checker = scene.addChecker(4, {0.9f, 0.2f, 0.1f}, {0.8f, 0.8f, 0.7f});
  const std::size_t bumps = scene.addChecker(8, {0.6f, 0.5f, 0.95f}, {0.4f, 0.5f, 0.95f});
  scene.addBall(
      scene.addMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", checker}}}}},
                         {"normalTexture", {{"index", bumps}}}}));
  scene.addCamera(kDistance, kFieldOfView);
  return scene;
}

json& attributesOf(GltfScene& scene) {
  return scene.json["meshes"][0]["primitives"][0]["attributes"];
}

/// The node of the ball.
json& nodeOf(GltfScene& scene) { return scene.json["nodes"][0]; }

/// Pixels that a length of 1 across the view takes, at a distance of 1 from the camera.
const double kPixelsPerSlope = 0.5 * kHeight / std::tan(0.5 * double(kFieldOfView));
/// The outline of a ball of radius 1 is seen under an angle whose sine is 1 / kDistance.
const double kBallPixels = kPixelsPerSlope / std::sqrt(double(kDistance * kDistance) - 1.0);

/// How far inside an outline a point is, in pixels right of and below the middle of the picture;
/// negative outside.
using Outline = std::function<double(double x, double y)>;

Outline discOf(double radius) {
  return [=](double x, double y) { return radius - std::hypot(x, y); };
}

/// A triangle by its corners, clockwise as seen; may be thinner than a pixel.
Outline triangleOf(const std::array<std::array<double, 2>, 3>& corners) {
  return [=](double x, double y) {
    double inside = 1e9;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto &from = corners[k], &to = corners[(k + 1) % 3];
      const double alongX = to[0] - from[0], alongY = to[1] - from[1];
      inside = std::min(inside, (alongX * (y - from[1]) - alongY * (x - from[0])) /
                                    std::hypot(alongX, alongY));
    }
    return inside;
  };
}

/// Where points at a distance from the camera are seen, right of and below the middle.
std::array<std::array<double, 2>, 3> seenAt(double distance,
                                            std::array<std::array<double, 2>, 3> points) {
  for (auto& [x, y] : points) {
    x *= kPixelsPerSlope / distance;
    y *= -kPixelsPerSlope / distance;
  }
  return points;
}

Outline eitherOf(const Outline& a, const Outline& b) {
  return [=](double x, double y) { return std::max(a(x, y), b(x, y)); };
}

const Outline kBall = discOf(kBallPixels);
const Outline kNothing = [](double, double) { return -1e9; };

/// What is known of the picture beside its outline.
enum class Known {
  outline,  ///< no more
  asPlain,  ///< it is the plain scene's
  otherSky, ///< the sky is not the plain scene's
};

struct OddScene {
  const char* what;
  std::function<void(GltfScene&)> change;
  Outline outline = kBall;
  Known known = Known::outline;
  bool reachesOut = false; ///< more than a pixel out of the outline of the ball
};

const std::vector<OddScene> kOddScenes{
    {"no normals", [](GltfScene& s) { attributesOf(s).erase("NORMAL"); }},
    {"no texture coordinates", [](GltfScene& s) { attributesOf(s).erase("TEXCOORD_0"); }},
    {"nothing but positions",
     [](GltfScene& s) {
       attributesOf(s).erase("NORMAL");
       attributesOf(s).erase("TEXCOORD_0");
     }},
    {"no material", [](GltfScene& s) { s.json["meshes"][0]["primitives"][0].erase("material"); }},
    {"normals of zero",
     [](GltfScene& s) {
       const auto count = s.json["accessors"][0]["count"];
       s.json["accessors"].push_back({{"componentType", 5126}, {"type", "VEC3"}, {"count", count}});
       attributesOf(s)["NORMAL"] = s.json["accessors"].size() - 1;
     }},
    {"triangles without area", addTriangleWithoutArea, kBall, Known::asPlain},
    {"indices of 8 bits",
     [](GltfScene& s) {
       s.addMesh({{"POSITION", s.addFloats({-2, -1, -1, 2, -1, -1, 0, 2, -1}, 3)}},
                 s.addIndices({0, 1, 2}, 1), 0);
     },
     eitherOf(kBall, triangleOf(seenAt(kDistance + 1.0, {{{0, 2}, {2, -1}, {-2, -1}}}))),
     Known::outline, true},
    {"one vertex moved by a sparse accessor",
     [](GltfScene& s) {
       const std::vector<float> far{-1.5f, 0, 0}; // the leftmost
       const std::vector<std::uint32_t> which{16 * 65 + 32};
       const std::size_t values = s.addView(std::as_bytes(std::span(far)));
       const std::size_t indices = s.addView(std::as_bytes(std::span(which)));
       s.json["accessors"][0]["sparse"] = {
           {"count", 1},
           {"indices", {{"bufferView", indices}, {"componentType", 5125}}},
           {"values", {{"bufferView", values}}}};
     },
     eitherOf(kBall, triangleOf(seenAt(kDistance, {{{-1.5, 0}, {0, 0.2}, {0, -0.2}}}))),
     Known::outline, true},
    {"a mirrored node",
     [](GltfScene& s) {
       nodeOf(s)["scale"] = {-1, 1, 1};
     }},
    {"a node flattened to nothing",
     [](GltfScene& s) {
       nodeOf(s)["scale"] = {1, 0, 1};
     },
     kNothing},
    {"a node scaled to a point",
     [](GltfScene& s) {
       nodeOf(s)["scale"] = {0, 0, 0};
     },
     kNothing},
    {"a rotation of zero",
     [](GltfScene& s) {
       nodeOf(s)["rotation"] = {0, 0, 0, 0};
     },
     kBall, Known::asPlain},
    {"a scene far out and tiny",
     [](GltfScene& s) {
       nodeOf(s)["translation"] = {1e6, -1e6, 1e6};
       nodeOf(s)["scale"] = {1e-3, 1e-3, 1e-3};
     },
     kNothing},
    {"a light without light", [](GltfScene& s) { s.addSun(0.0f); }, kBall, Known::asPlain},
    {"a lamp in the surface",
     [](GltfScene& s) {
       s.addSun(1.0f);
       s.json["extensions"]["KHR_lights_punctual"]["lights"][0] = {{"type", "point"}};
       s.json["nodes"].back()["translation"] = {0, 0, 1};
     },
     kBall, Known::otherSky},
    {"a spot with a cone of no width",
     [](GltfScene& s) {
       s.addSun(1.0f);
       s.json["extensions"]["KHR_lights_punctual"]["lights"][0] = {
           {"type", "spot"}, {"spot", {{"innerConeAngle", 0}, {"outerConeAngle", 0}}}};
     },
     kBall, Known::otherSky},
    {"an orthographic camera",
     [](GltfScene& s) {
       s.json["cameras"][0] = {
           {"type", "orthographic"},
           {"orthographic", {{"xmag", 2}, {"ymag", 2}, {"znear", 0}, {"zfar", 10}}}};
     },
     discOf(0.5 * kHeight / 2.0), Known::otherSky},
    {"a mask that nothing passes",
     [](GltfScene& s) {
       s.json["materials"][0]["alphaMode"] = "MASK";
       s.json["materials"][0]["alphaCutoff"] = 2;
     },
     kNothing},
    {"a glass mirror without roughness",
     [](GltfScene& s) {
       s.json["materials"][0]["alphaMode"] = "BLEND";
       s.json["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = 0;
     }},
    {"a texture transform to a point",
     [](GltfScene& s) {
       s.json["materials"][0]["normalTexture"]["extensions"]["KHR_texture_transform"] = {
           {"scale", {0, 0}}, {"rotation", 1}};
     }},
    {"a texture of one texel, read without mip levels",
     [](GltfScene& s) {
       SrgbImage texel(1, 1, 1);
       texel.values = {0.5f};
       const std::size_t view = s.addView(encodePng(texel, 8).value());
       s.json["images"][0] = {{"bufferView", view}};
       s.json["samplers"] = {{{"magFilter", 9728}, {"minFilter", 9728}, {"wrapS", 33071}}};
       s.json["textures"][0]["sampler"] = 0;
     }},
    {"a scene that is not the first",
     [](GltfScene& s) {
       s.json["scenes"].push_back(s.json["scenes"][0]);
       s.json["scenes"][0] = json::object();
       s.json["scene"] = 1;
     },
     kBall, Known::asPlain},
    {"faults in what the scene does not draw",
     [](GltfScene& s) {
       s.addMesh({{"POSITION", 99}}, 98, 97, {{"scale", "large"}});
       json& nodes = s.json["scenes"][0]["nodes"];
       const json other = {{"nodes", {nodes.back()}}};
       nodes.erase(nodes.size() - 1);
       s.json["scenes"].push_back(other);
       attributesOf(s)["_UNKNOWN"] = 99;
       s.json["accessors"].push_back({{"type", "VEC5"}});
       s.json["cameras"].push_back({{"type", "fisheye"}});
       s.json["images"].push_back({{"uri", "absent.png"}});
       s.json["textures"].push_back({{"source", 99}});
       s.json["skins"] = {json::object()};
       s.json["animations"] = 3;
     },
     kBall, Known::asPlain},
    {"vertices that meshoptimizer compressed for readers that know it",
     [](GltfScene& s) {
       s.json["extensionsUsed"] = {"EXT_meshopt_compression"};
       s.json["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}};
     },
     kBall, Known::asPlain},
};

/// The sky of a scene, by a triangle that is not seen: a scene without triangles is refused.
GltfScene withoutBall(GltfScene scene) {
  addTriangleWithoutArea(scene);
  scene.json["scenes"][0]["nodes"].erase(0);
  return scene;
}

LinearImage lightOf(const GltfScene& scene) {
  renderer::RenderSettings settings = settingsOf(kWidth, kHeight, 2);
  settings.toneMap = false; // which would hide infinite light
  return render(scene.glb(), settings);
}

/// A pixel is taken for inside or outside where all of it is, wherever in it frames look.
constexpr double kPixel = 1.5;

/// The least light of the pixels inside an outline, over all channels.
float darkestInside(const LinearImage& picture, const Outline& outline) {
  float darkest = std::numeric_limits<float>::max();
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x)
      if (outline(x + 0.5 - 0.5 * kWidth, y + 0.5 - 0.5 * kHeight) > kPixel)
        darkest =
            std::min(darkest, *std::min_element(picture.pixel(x, y), picture.pixel(x, y) + 3));
  return darkest;
}

/// How many pixels outside an outline differ from a picture of the sky alone, and how many
/// inside are.
std::pair<int, int> misplaced(const LinearImage& picture, const LinearImage& sky,
                              const Outline& outline) {
  std::pair<int, int> wrong{0, 0};
  for (int y = 0; y < kHeight; ++y)
    for (int x = 0; x < kWidth; ++x) {
      const double inside = outline(x + 0.5 - 0.5 * kWidth, y + 0.5 - 0.5 * kHeight);
      const bool isSky = std::equal(picture.pixel(x, y), picture.pixel(x, y) + 3, sky.pixel(x, y));
      wrong.first += inside < -kPixel && !isSky ? 1 : 0;
      wrong.second += inside > kPixel && isSky ? 1 : 0;
    }
  return wrong;
}

} // namespace

TEST_CASE("odd scenes are drawn in the right place, without validation messages") {
  const LinearImage sky = lightOf(withoutBall(plainScene())), plain = lightOf(plainScene());
  const float darkest = darkestInside(plain, kBall);
  REQUIRE(darkest > 0.0f);
  for (const OddScene& odd : kOddScenes) {
    INFO(odd.what);
    GltfScene scene = plainScene();
    odd.change(scene);
    const LinearImage picture = lightOf(scene);
    CHECK(std::all_of(picture.values.begin(), picture.values.end(),
                      [](float v) { return std::isfinite(v) && v >= 0.0f; }));
    if (odd.known == Known::asPlain)
      CHECK((picture.values == plain.values));
    const LinearImage& itsSky = odd.known == Known::otherSky ? lightOf(withoutBall(scene)) : sky;
    CHECK(misplaced(picture, itsSky, odd.outline) == std::pair{0, 0});
    CHECK((misplaced(picture, itsSky, kBall).first > 0) == odd.reachesOut);
    // How bright it is depends on its albedo, of 0.02 to 1, and on where that falls, at dusk on a
    // tenth of a day's light: no bound can be derived that is nearer than what tells it from black.
    CHECK(darkestInside(picture, odd.outline) > 0.05f * darkest);
  }
}

TEST_CASE("the error for an image or a primitive too large for the device names its size") {
  renderer::Scene scene;
  scene.images.resize(1);
  scene.images[0].width = 9;
  scene.primitives.resize(1);
  scene.primitives[0].vertices.resize(6);
  VkPhysicalDeviceLimits limits{};
  limits.maxImageDimension2D = 9;
  limits.maxDrawIndexedIndexValue = 5;
  CHECK(renderer::fitsDevice(scene, limits).ok());
  scene.images[0].width = 10;
  const auto image = renderer::fitsDevice(scene, limits);
  REQUIRE_FALSE(image.ok());
  CHECK(image.error().message.find("10 x 1 is too large; this device supports up to 9 x 9") !=
        std::string::npos);
  scene.images.clear();
  scene.primitives[0].vertices.resize(7);
  const auto primitive = renderer::fitsDevice(scene, limits);
  REQUIRE_FALSE(primitive.ok());
  CHECK(primitive.error().kind == ErrorKind::environment);
  CHECK(primitive.error().message.find("7 vertices is too large; this device supports up to 6") !=
        std::string::npos);
}

TEST_CASE("one note says that a scene has more lights than are used") {
  GltfScene scene = plainScene();
  for (int i = 0; i < 20; ++i) {
    scene.addSun(1.0f);
    scene.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "directional"}, {"intensity", 1.0}}};
  }
  const auto notes = renderPicture(scene.glb(), settingsOf(16, 16, 1)).notes;
  REQUIRE(notes.size() == 1);
  CHECK(notes[0] == "the scene has 20 lights; only the 16 strongest are used");
}

TEST_CASE("one note names an unusable camera that is not chosen") {
  GltfScene scene = triangleScene();
  scene.addCamera(4.0f, 0.6f);
  scene.json["cameras"].push_back(
      {{"type", "perspective"}, {"perspective", {{"yfov", 0.6}, {"znear", 1e-9}}}});
  for (int place = 0; place < 2; ++place) {
    scene.json["nodes"].push_back({{"camera", 1}});
    scene.json["scenes"][0]["nodes"].push_back(scene.json["nodes"].size() - 1);
  }
  CHECK(renderPicture(scene.glb(), settingsOf(8, 8, 1)).notes ==
        std::vector<std::string>{"/cameras/1/perspective/znear: 1e-09 is out of range; expected "
                                 "1e-06 or more; the camera is ignored"});
}

TEST_CASE("the error for a device with fewer descriptors than the shaders need names the limit") {
  VkPhysicalDeviceLimits limits{};
  limits.maxPerStageDescriptorSamplers = 16; // the least that Vulkan allows
  limits.maxPerStageDescriptorSampledImages = 27;
  CHECK(renderer::fitsDescriptors(limits).ok());
  limits.maxPerStageDescriptorSampledImages = 16;
  const auto images = renderer::fitsDescriptors(limits);
  REQUIRE_FALSE(images.ok());
  CHECK(images.error().kind == ErrorKind::environment);
  CHECK(images.error().message ==
        "this device has 16 sampled images (maxPerStageDescriptorSampledImages) a shader stage; "
        "the renderer needs 27");
  limits.maxPerStageDescriptorSampledImages = 27;
  limits.maxPerStageDescriptorSamplers = 13;
  const auto samplers = renderer::fitsDescriptors(limits);
  REQUIRE_FALSE(samplers.ok());
  CHECK(samplers.error().message.find("maxPerStageDescriptorSamplers") != std::string::npos);
}
