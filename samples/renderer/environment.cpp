// SPDX-License-Identifier: MIT
// Prefiltering [Karis 2013, Real Shading in Unreal Engine 4]. Each sample reads the mip level that
// matches its solid angle [Krivanek and Colbert 2008, Real-time Shading with Filtered Importance
// Sampling, eqs. 11 to 13].
#include "environment.h"

#include "directions.h"
#include "sky.h"

#include <lichen/image_io.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <utility>

namespace lichen::renderer {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;
constexpr int kSpecularSide = 128;
constexpr int kDiffuseSide = 16;
constexpr std::uint32_t kSpecularSamples = 48;
constexpr std::uint32_t kDiffuseSamples = 128;
constexpr std::uint32_t kBrdfSamples = 256;
constexpr float kSchlickPower = 5.0f;
constexpr float kLeastAlpha = 0.002f;

/// Averages 2 x 2 pixels, or 2 x 1 where one side is 1. Drops an odd last row or column.
LinearImage halved(const LinearImage& fine) {
  LinearImage coarse(std::max(fine.width / 2, 1), std::max(fine.height / 2, 1), fine.channels);
  const int right = fine.width > 1 ? 1 : 0;
  const int below = fine.height > 1 ? 1 : 0;
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x)
      for (int c = 0; c < coarse.channels; ++c) {
        const int fx = 2 * x;
        const int fy = 2 * y;
        coarse.pixel(x, y)[c] =
            0.25f * (fine.pixel(fx, fy)[c] + fine.pixel(fx + right, fy)[c] +
                     fine.pixel(fx, fy + below)[c] + fine.pixel(fx + right, fy + below)[c]);
      }
  return coarse;
}

/// Mip pyramid of a panorama.
class PanoramaPyramid {
public:
  explicit PanoramaPyramid(const LinearImage& panorama) {
    levels_.push_back(panorama);
    while (std::min(levels_.back().width, levels_.back().height) > 2)
      levels_.push_back(halved(levels_.back()));
  }

  /// Bilinear sample of the level whose texels best match `solidAngle`.
  [[nodiscard]] glm::vec3 sample(glm::vec3 direction, float solidAngle) const {
    const float texel = 2.0f * kPi * kPi / (float(levels_[0].width) * float(levels_[0].height));
    const float level = 0.5f * std::log2(std::max(solidAngle / texel, 1.0f));
    const std::size_t nearest = std::min(std::size_t(level + 0.5f), levels_.size() - 1);
    const LinearImage& image = levels_[nearest];
    const glm::vec2 position =
        panoramaCoordinate(direction) * glm::vec2(image.width, image.height) - 0.5f;
    const glm::vec2 corner = glm::floor(position);
    const glm::vec2 f = position - corner;
    const auto texelAt = [&](int x, int y) {
      const float* p = image.pixel((int(corner.x) + x + image.width) % image.width,
                                   std::clamp(int(corner.y) + y, 0, image.height - 1));
      return glm::vec3(p[0], p[1], p[2]);
    };
    return glm::mix(glm::mix(texelAt(0, 0), texelAt(1, 0), f.x),
                    glm::mix(texelAt(0, 1), texelAt(1, 1), f.x), f.y);
  }

private:
  std::vector<LinearImage> levels_;
};

/// Point i of n of the Hammersley set.
glm::vec2 hammersley(std::uint32_t i, std::uint32_t n) {
  std::uint32_t bits = i;
  bits = (bits << 16) | (bits >> 16);
  bits = ((bits & 0x55555555u) << 1) | ((bits & 0xAAAAAAAAu) >> 1);
  bits = ((bits & 0x33333333u) << 2) | ((bits & 0xCCCCCCCCu) >> 2);
  bits = ((bits & 0x0F0F0F0Fu) << 4) | ((bits & 0xF0F0F0F0u) >> 4);
  bits = ((bits & 0x00FF00FFu) << 8) | ((bits & 0xFF00FF00u) >> 8);
  constexpr float kTwoToMinus32 = 2.3283064365386963e-10f;
  return {(float(i) + 0.5f) / float(n), (float(bits) + 0.5f) * kTwoToMinus32};
}

glm::vec3 onHemisphere(float cosine, float azimuth) {
  const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
  return {std::cos(azimuth) * sine, std::sin(azimuth) * sine, cosine};
}

/// Samples a GGX half vector around +z.
glm::vec3 sampleGgx(glm::vec2 point, float alpha) {
  const float cosine = std::sqrt((1.0f - point.y) / (1.0f + (alpha * alpha - 1.0f) * point.y));
  return onHemisphere(cosine, 2.0f * kPi * point.x);
}

float ggx(float nDotH, float alpha) {
  const float a2 = alpha * alpha;
  const float d = nDotH * nDotH * (a2 - 1.0f) + 1.0f;
  return a2 / (kPi * d * d);
}

/// A sample direction relative to the lobe's axis, with its weight and solid angle.
struct Sample {
  glm::vec3 direction;
  float weight;
  float solidAngle;
};

std::vector<Sample> specularSamples(float alpha) {
  std::vector<Sample> samples;
  for (std::uint32_t i = 0; i < kSpecularSamples; ++i) {
    const glm::vec3 h = sampleGgx(hammersley(i, kSpecularSamples), alpha);
    const glm::vec3 l(2.0f * h.z * h.x, 2.0f * h.z * h.y, 2.0f * h.z * h.z - 1.0f);
    // With v = n, pdf = D(h) / 4.
    if (l.z > 0.0f)
      samples.push_back({l, l.z, 4.0f / (ggx(h.z, alpha) * float(kSpecularSamples))});
  }
  return samples;
}

std::vector<Sample> diffuseSamples() {
  std::vector<Sample> samples;
  for (std::uint32_t i = 0; i < kDiffuseSamples; ++i) {
    const glm::vec2 point = hammersley(i, kDiffuseSamples);
    const float cosine = std::sqrt(1.0f - point.y);
    samples.push_back({onHemisphere(cosine, 2.0f * kPi * point.x), 1.0f,
                       kPi / (std::max(cosine, 1e-3f) * float(kDiffuseSamples))});
  }
  return samples;
}

/// Direction of a cube map's texel [Vulkan 1.3, table "Cube map face and coordinate selection"].
glm::vec3 cubeDirection(int face, float s, float t) {
  const float a = 2.0f * s - 1.0f;
  const float b = 2.0f * t - 1.0f;
  const std::array<glm::vec3, 6> directions{glm::vec3(1, -b, -a), glm::vec3(-1, -b, a),
                                            glm::vec3(a, 1, b),   glm::vec3(a, -1, -b),
                                            glm::vec3(a, -b, 1),  glm::vec3(-a, -b, -1)};
  return glm::normalize(directions[std::size_t(face)]);
}

CubeLevel fillCube(int side, const std::function<glm::vec3(glm::vec3)>& valueAlong) {
  CubeLevel level;
  level.side = side;
  level.texels.reserve(std::size_t(side) * std::size_t(side) * 6);
  for (int face = 0; face < 6; ++face)
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        level.texels.push_back(valueAlong(
            cubeDirection(face, (float(x) + 0.5f) / float(side), (float(y) + 0.5f) / float(side))));
  return level;
}

glm::vec3 average(const PanoramaPyramid& pyramid, glm::vec3 axis,
                  const std::vector<Sample>& samples) {
  const glm::mat3 frame = frameAlong(axis);
  glm::vec3 sum(0.0f);
  float weights = 0.0f;
  for (const Sample& sample : samples) {
    sum += sample.weight * pyramid.sample(frame * sample.direction, sample.solidAngle);
    weights += sample.weight;
  }
  return sum / weights;
}

LinearImage asRgb(const LinearImage& image) {
  if (image.channels == 3)
    return image;
  LinearImage rgb(image.width, image.height, 3);
  for (std::size_t i = 0; i < image.pixelCount(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      rgb.values[3 * i + c] =
          image.values[i * std::size_t(image.channels) + (image.channels >= 3 ? c : 0)];
  return rgb;
}

/// Scale and bias of F0 for a uniform environment; their sum is at most 1.
glm::vec2 scaleAndBiasOfF0(float nDotV, float alpha) {
  const glm::vec3 v = onHemisphere(nDotV, 0.0f);
  const float a2 = alpha * alpha;
  glm::vec2 sum(0.0f);
  for (std::uint32_t i = 0; i < kBrdfSamples; ++i) {
    const glm::vec3 h = sampleGgx(hammersley(i, kBrdfSamples), alpha);
    const float vDotH = glm::dot(v, h);
    const glm::vec3 l = 2.0f * vDotH * h - v;
    if (l.z <= 0.0f || vDotH <= 0.0f)
      continue;
    // Height-correlated Smith [Heitz 2014, eq. 99]; 4 n.l v.h / n.h is the sampling weight.
    const float visibility = 0.5f / (l.z * std::sqrt(nDotV * nDotV * (1.0f - a2) + a2) +
                                     nDotV * std::sqrt(l.z * l.z * (1.0f - a2) + a2));
    const float weight = visibility * 4.0f * l.z * vDotH / h.z;
    const float fresnel = std::pow(1.0f - vDotH, kSchlickPower);
    sum += glm::vec2(1.0f - fresnel, fresnel) * weight;
  }
  sum /= float(kBrdfSamples);
  return sum / std::max(sum.x + sum.y, 1.0f); // sampling error must not create energy
}

} // namespace

float alphaOf(float roughness) { return std::max(roughness * roughness, kLeastAlpha); }

Result<LinearImage> readPanorama(const std::filesystem::path& path,
                                 std::vector<std::string>& notes) {
  Result<ImageFile> file = readImage(path);
  if (!file)
    return file.error();
  for (const std::string& note : file.value().notes)
    notes.push_back(path.string() + ": " + note);
  const auto* code = std::get_if<SrgbImage>(&file.value().pixels);
  LinearImage panorama =
      code != nullptr ? toLinear(*code) : std::get<LinearImage>(std::move(file.value().pixels));
  if (panorama.width != 2 * panorama.height)
    notes.push_back(path.string() + ": " + std::to_string(panorama.width) + " x " +
                    std::to_string(panorama.height) +
                    " pixels; a panorama of the whole sphere is twice as wide as high, so this one "
                    "appears stretched");
  return panorama;
}

LinearImage fitInto(LinearImage panorama, int longestSide) {
  while (std::max(panorama.width, panorama.height) > longestSide)
    panorama = halved(panorama);
  return panorama;
}

Environment prepareEnvironment(const LinearImage& panorama) {
  Environment environment;
  environment.panorama = asRgb(panorama);
  const PanoramaPyramid pyramid(environment.panorama);
  for (int level = 0; level < kSpecularLevels; ++level) {
    const int side = kSpecularSide >> level;
    const float texelAngle = 4.0f * kPi / (6.0f * float(side) * float(side));
    if (level == 0) {
      environment.specular.push_back(
          fillCube(side, [&](glm::vec3 d) { return pyramid.sample(d, texelAngle); }));
      continue;
    }
    const auto samples = specularSamples(alphaOf(float(level) / float(kSpecularLevels - 1)));
    environment.specular.push_back(
        fillCube(side, [&](glm::vec3 d) { return average(pyramid, d, samples); }));
  }
  const auto samples = diffuseSamples();
  environment.diffuse =
      fillCube(kDiffuseSide, [&](glm::vec3 d) { return average(pyramid, d, samples); });
  environment.brdf = environmentBrdf(kBrdfSide);
  return environment;
}

std::vector<glm::vec4> environmentBrdf(int side) {
  std::vector<glm::vec4> table;
  for (int y = 0; y < side; ++y) {
    const float alpha = alphaOf((float(y) + 0.5f) / float(side));
    float meanLoss = 0.0f;
    for (int x = 0; x < side; ++x) {
      const float nDotV = (float(x) + 0.5f) / float(side);
      const glm::vec2 scaleAndBias = scaleAndBiasOfF0(nDotV, alpha);
      const float loss = std::max(1.0f - scaleAndBias.x - scaleAndBias.y, 0.0f);
      meanLoss += 2.0f * nDotV * loss / float(side);
      table.emplace_back(scaleAndBias, loss, 0.0f);
    }
    for (int x = 0; x < side; ++x)
      table[std::size_t(y * side + x)].w = meanLoss;
  }
  return table;
}

} // namespace lichen::renderer
