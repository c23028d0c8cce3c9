// SPDX-License-Identifier: MIT
// Renders a plane with one and with many samples per pixel; see lit_views.h.
#include "lit_views.h"

#include "lighting.h"
#include "render_gltf.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace lichen::test {
namespace {

/// Samples of a reference per texel along each axis, and the least per pixel.
constexpr double kSamplesPerTexel = 2.0;
constexpr double kLeastSamples = 8.0;

template <class Value>
Value taken(Result<Value> result) {
  if (!result)
    throw std::runtime_error(result.error().message);
  return std::move(result).value();
}

renderer::Scene planeScene(const BundleFile& file, double roughnessFactor, double metallicFactor) {
  GltfScene scene(taken(encodeGlb(file)));
  scene.json["materials"][0]["pbrMetallicRoughness"] = {{"metallicFactor", metallicFactor},
                                                        {"roughnessFactor", roughnessFactor}};
  const float s = 1.0f; // sized to each view
  scene.addMesh({{"POSITION", scene.addFloats({-s, 0, -s, -s, 0, s, s, 0, s, s, 0, -s}, 3)},
                 {"NORMAL", scene.addFloats({0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0}, 3)},
                 {"TANGENT", scene.addFloats({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, 4)},
                 {"TEXCOORD_0", scene.addFloats({-s, -s, -s, s, s, s, s, -s}, 2)}},
                scene.addIndices({0, 1, 2, 0, 2, 3}, 1), 0);
  return taken(renderer::parseScene(scene.glb(), "plane.glb"));
}

constexpr double kDegree = std::numbers::pi / 180.0;

/// Length of a pixel on the plane over its width.
double slantOf(const Viewpoint& from) { return 1.0 / std::sin(from.elevation * kDegree); }

renderer::Camera cameraAt(const Viewpoint& from, double halfSide) {
  const double elevation = from.elevation * kDegree, azimuth = from.azimuth * kDegree;
  // Camera axes: x to the right, y up, z away from the view.
  const glm::dvec3 right(std::cos(azimuth), 0.0, -std::sin(azimuth));
  const glm::dvec3 away(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                        std::cos(azimuth) * std::cos(elevation));
  // The view reaches halfSide / sin(elevation) to the front and to the back.
  const double distance = 2.0 * halfSide / std::tan(elevation) + 1.0;
  renderer::Camera camera;
  camera.worldFromCamera =
      glm::dmat4(glm::dvec4(right, 0.0), glm::dvec4(glm::cross(away, right), 0.0),
                 glm::dvec4(away, 0.0), glm::dvec4(distance * away, 1.0));
  camera.perspective = false;
  camera.halfHeight = float(halfSide);
  camera.near = 0.0f;
  camera.far = float(2.0 * distance);
  return camera;
}

double luminanceAt(const LinearImage& image, std::uint32_t x, std::uint32_t y) {
  const float* rgb = image.pixel(int(x), int(y));
  return 0.2126 * double(rgb[0]) + 0.7152 * double(rgb[1]) + 0.0722 * double(rgb[2]);
}

/// Unit vector from the plane to the sun of a scene without lights.
glm::dvec3 builtInSun() { return renderer::arrangeLights({}, {}, false).towardSun; }

double azimuthOf(const glm::dvec3& direction) {
  return std::atan2(direction.x, direction.z) / kDegree;
}

} // namespace

Viewpoint towardSun() {
  const glm::dvec3 sun = builtInSun();
  return {std::asin(sun.y) / kDegree, azimuthOf(-sun)};
}

Viewpoint awayFromSun() {
  constexpr double kElevation = 30.0;
  return {kElevation, azimuthOf(builtInSun())};
}

std::vector<float> smoothed(std::vector<float> values, int side, int channels) {
  constexpr int kPasses = 2, kRadius = 2;
  constexpr float kTaps = float((2 * kRadius + 1) * (2 * kRadius + 1));
  const auto index = [&](int x, int y, int c) {
    return std::size_t(((y + side) % side * side + (x + side) % side) * channels + c);
  };
  for (int pass = 0; pass < kPasses; ++pass) {
    std::vector<float> mean(values.size());
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        for (int c = 0; c < channels; ++c)
          for (int dy = -kRadius; dy <= kRadius; ++dy)
            for (int dx = -kRadius; dx <= kRadius; ++dx)
              mean[index(x, y, c)] += values[index(x + dx, y + dy, c)] / kTaps;
    values = std::move(mean);
  }
  return values;
}

LitPlane::LitPlane(VulkanDevice& device, const BundleFile& file, int texels, double roughnessFactor,
                   double metallicFactor)
    : device_(device), pipelines_(device),
      scene_(planeScene(file, roughnessFactor, metallicFactor)), texels_(texels) {}

LinearImage LitPlane::picture(double halfSide, const Viewpoint& from, std::uint32_t side,
                              LitBy light) {
  scene_.lights.clear(); // of the previous picture
  scene_.cameras = {cameraAt(from, halfSide)};
  // Large enough for any direction of view; not larger, because texture coordinates are floats.
  const float reach = float(2.0 * halfSide * slantOf(from));
  for (renderer::Vertex& vertex : scene_.primitives[0].vertices) {
    vertex.position = reach * glm::sign(vertex.position);
    vertex.texCoord0 = reach * glm::sign(vertex.texCoord0);
  }
  renderer::RenderSettings settings;
  settings.width = settings.height = side;
  settings.frames = 1; // more would shrink the footprints
  settings.toneMap = false;
  settings.skies = &skies_;
  settings.pipelines = &pipelines_;
  if (light == LitBy::sun)
    settings.environment = LinearImage(8, 4, 3); // black
  if (light == LitBy::sky) {
    const renderer::Lighting lighting = renderer::arrangeLights(scene_, {}, false);
    const renderer::Light& sun = lighting.lights[0];
    settings.environment =
        skies_.prepare(lighting.towardSun, sun.color * sun.intensity, lighting.skyIrradiance)
            .environment.panorama;
  }
  if (light == LitBy::sun) // without an environment the renderer adds its own sun
    scene_.lights = {renderer::arrangeLights(scene_, {}, false).lights[0]};
  return taken(renderer::renderScene(device_, scene_, settings)).pixels;
}

LitError LitPlane::seen(double texelsPerPixel, const Viewpoint& from, std::uint32_t side,
                        LitBy light) {
  const auto samples = std::uint32_t(
      std::max(kLeastSamples, std::ceil(kSamplesPerTexel * slantOf(from) * texelsPerPixel)));
  side = std::clamp(kReferenceSide / samples, 1u, side);
  const double halfSide = 0.5 * side * texelsPerPixel / texels_;
  const LinearImage frame = picture(halfSide, from, side, light);
  const LinearImage fine = picture(halfSide, from, side * samples, light);
  const double pixels = double(side) * double(side);
  double sum = 0.0, frameSum = 0.0, squares = 0.0, aliased = 0.0;
  for (std::uint32_t y = 0; y < side; ++y)
    for (std::uint32_t x = 0; x < side; ++x) {
      double mean = 0.0;
      for (std::uint32_t v = 0; v < samples; ++v)
        for (std::uint32_t u = 0; u < samples; ++u)
          mean += luminanceAt(fine, x * samples + u, y * samples + v);
      mean /= double(samples) * double(samples);
      const double shown = luminanceAt(frame, x, y);
      sum += mean;
      frameSum += shown;
      squares += (shown - mean) * (shown - mean);
      // The middle lies between four samples, or two, or on one.
      for (const std::uint32_t v : {(samples - 1) / 2, samples / 2})
        for (const std::uint32_t u : {(samples - 1) / 2, samples / 2}) {
          const double sample = luminanceAt(fine, x * samples + u, y * samples + v);
          aliased += 0.25 * (sample - mean) * (sample - mean);
        }
    }
  LitError error;
  const double mean = sum / pixels;
  error.meanError = frameSum / sum - 1.0;
  error.pixelError = std::sqrt(squares / pixels) / mean;
  error.aliasing = std::sqrt(aliased / pixels) / mean;
  return error;
}

} // namespace lichen::test
