// SPDX-License-Identifier: MIT
// Texton noise on the CPU: (textons, parameters, footprint) -> value. [GLM17] eq. 2. The steps and
// names follow shaders_glsl/noise/texton.glsl, surface_texton.glsl and texton_gradient.glsl.
#include "impacts.h"
#include "level_retained.h"
#include "mixed_map.h"
#include "sampling/repeating_image.h"
#include "surface_impacts.h"
#include "triplanar/planes.h"

#include <lichen/texton_evaluate.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace lichen {
namespace {

using texton::Impacts;
using texton::Vec2;
using Value = TextonEvaluator::Value;

Vec2 clamped(const Vec2& texel, const texton::Reach& reach) {
  return {std::clamp(texel[0], reach.low[0], reach.high[0]),
          std::clamp(texel[1], reach.low[1], reach.high[1])};
}

/// The weights of a cubic B-spline at f in [0, 1) after the centre of the second of four texels.
struct CubicWeights {
  explicit CubicWeights(float f) {
    const float r = 1.0f - f;
    value = {r * r * r / 6.0f, (4.0f - 3.0f * f * f * (1.0f + r)) / 6.0f,
             (4.0f - 3.0f * r * r * (1.0f + f)) / 6.0f, f * f * f / 6.0f};
    slope = {-0.5f * r * r, 0.5f * f * (3.0f * f - 4.0f), 0.5f * r * (4.0f - 3.0f * r),
             0.5f * f * f};
  }
  std::array<float, 4> value{};
  std::array<float, 4> slope{};
};

/// A texton's image and the shape of its noise, for evaluation at one point.
class Textons {
public:
  Textons(const RepeatingImage& image, const shader::LichenNoise& noise, const Impacts& impacts,
          const MixPlace& mix)
      : image_(image), noise_(noise), shape_(textonPart(noise)), impacts_(impacts), mix_(mix) {}

  /// Returns h at an offset in an impact's frame, filtered to the footprint.
  [[nodiscard]] Value at(const Vec2& place) const {
    Vec2 texel = texelAt(place);
    const float frame = frameAt(texel);
    const float minified = std::min(impacts_.level, 1.0f);
    texel = stepped(texel);
    if (!isCubic())
      return fetch(texel, frame, impacts_.level);
    // Blend between the spline and the first mip.
    Value value = cubic(texel, frame).value;
    const Value mip = fetch(clamped(texel, texton::mipReach(impacts_.level, shape_)), frame,
                            std::ceil(impacts_.level));
    for (std::size_t c = 0; c < 3; ++c)
      value[c] += minified * (mip[c] - value[c]);
    return value;
  }

  /// Returns the value and derivatives [1 / texel] of the first channel.
  [[nodiscard]] std::array<float, 3> gradientAt(const Vec2& place) const {
    const Vec2 texel = texelAt(place);
    const float frame = frameAt(texel);
    const float level = isCubic() ? std::ceil(impacts_.level) : impacts_.level;
    const float side = std::exp2(level);
    const texton::Reach reach = texton::mipReach(level, shape_);
    const auto first = [&](float x, float y) {
      return fetch(clamped({texel[0] + x, texel[1] + y}, reach), frame, level)[0];
    };
    const float half = 0.5f * side;
    // The value of order 0 has steps. The finite differences measure the slope between them.
    const float value = fetch(clamped(stepped(texel), reach), frame, level)[0];
    std::array<float, 3> result{value, (first(half, 0.0f) - first(-half, 0.0f)) / side,
                                (first(0.0f, half) - first(0.0f, -half)) / side};
    if (!isCubic())
      return result;
    const Cubic magnified = cubic(texel, frame);
    const std::array<float, 3> spline{magnified.value[0], magnified.slope[0], magnified.slope[1]};
    const float minified = std::min(impacts_.level, 1.0f);
    for (std::size_t k = 0; k < 3; ++k)
      result[k] = spline[k] + minified * (result[k] - spline[k]);
    return result;
  }

private:
  struct Cubic {
    Value value{};
    Vec2 slope{}; ///< of the first channel, per texel
  };

  [[nodiscard]] bool isCubic() const { return shape_.order == 3 && impacts_.level < 1.0f; }

  [[nodiscard]] Vec2 texelAt(const Vec2& place) const {
    return {place[0] + impacts_.middle[0], place[1] + impacts_.middle[1]};
  }

  /// Order 0: returns the texel's centre under magnification, blending to `texel` itself at the
  /// first mip.
  [[nodiscard]] Vec2 stepped(Vec2 texel) const {
    if (shape_.order != 0)
      return texel;
    const float minified = std::min(impacts_.level, 1.0f);
    for (float& coordinate : texel) {
      const float step = std::floor(coordinate) + 0.5f;
      coordinate = step * (1.0f - minified) + coordinate * minified;
    }
    return texel;
  }

  /// Returns the top of an impact's frame in the image. In a mix, each impact uses the weight at
  /// its own position. [GLM17] section 7.
  [[nodiscard]] float frameAt(const Vec2& texel) const {
    if (shape_.steps <= 1)
      return 0.0f;
    const float x = (0.5f * float(shape_.coefficientsX) - texel[0]) / noise_.tileTexelsX;
    const float y = (0.5f * float(shape_.coefficientsY) - texel[1]) / noise_.tileTexelsY;
    const float weight =
        std::clamp(mix_.weight + mix_.gradient[0] * x + mix_.gradient[1] * y, 0.0f, 1.0f);
    return std::floor(weight * (float(shape_.steps) - 1.0f) + 0.5f) * float(shape_.frameY);
  }

  [[nodiscard]] Value fetch(const Vec2& texel, float frame, float level) const {
    return image_.at(texel[0] / float(shape_.frameX),
                     (texel[1] + frame) / float(shape_.frameY * int(shape_.steps)), level);
  }

  /// Evaluates the cubic B-spline of the coefficients as a direct sum over texels.
  [[nodiscard]] Cubic cubic(const Vec2& texel, float frame) const {
    const float baseX = std::floor(texel[0] - 0.5f);
    const float baseY = std::floor(texel[1] - 0.5f);
    const CubicWeights x(texel[0] - 0.5f - baseX);
    const CubicWeights y(texel[1] - 0.5f - baseY);
    Cubic sum;
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t i = 0; i < 4; ++i) {
        const int column = int(baseX) + int(i) - 1;
        const int row = int(baseY) + int(j) - 1;
        if (column < 0 || row < 0 || column >= shape_.coefficientsX || row >= shape_.coefficientsY)
          continue;
        const Value& alpha =
            image_.texels(0)[(std::size_t(frame) + std::size_t(row)) * std::size_t(shape_.frameX) +
                             std::size_t(column)];
        for (std::size_t c = 0; c < 3; ++c)
          sum.value[c] += x.value[i] * y.value[j] * alpha[c];
        sum.slope[0] += x.slope[i] * y.value[j] * alpha[0];
        sum.slope[1] += x.value[i] * y.slope[j] * alpha[0];
      }
    return sum;
  }

  const RepeatingImage& image_;
  const shader::LichenNoise& noise_;
  const shader::LichenTextonNoise shape_;
  const Impacts& impacts_;
  const MixPlace& mix_;
};

/// Limits the footprint's level to those with a known lost variance.
float knownLevel(const Impacts& impacts) {
  return std::min(impacts.footprintLevel, float(LICHEN_MAX_MIPS - 1));
}

/// Returns the factor for the sums over impacts. Beyond the last mip the textons stay the same and
/// their amplitude falls with the standard deviation.
std::array<float, 3> gainOf(const Impacts& impacts, const shader::LichenMaterial& material,
                            const shader::LichenMap& map) {
  const std::array<float, 3> fetched = texton::levelRetained(map, impacts.level);
  const std::array<float, 3> seen = texton::levelRetained(map, knownLevel(impacts));
  constexpr float kLeast = 1e-6f; // below the square of a kept amplitude's first step, 1/255
  const float amplitude = textonPart(material).amplitude;
  std::array<float, 3> gain{};
  for (std::size_t c = 0; c < gain.size(); ++c)
    gain[c] = material.contrast * std::sqrt(seen[c] / std::max(fetched[c], kLeast)) * amplitude;
  return gain;
}

/// Where the footprint averages out all variation, the mean needs no impacts.
bool needsImpacts(const std::array<float, 3>& gain) { return gain != std::array<float, 3>{}; }

/// Returns the share of each channel's variance that is lost to filtering.
std::array<float, 3> lostOf(const Impacts& impacts, const shader::LichenMap& here) {
  std::array<float, 3> lost = texton::levelRetained(here, knownLevel(impacts));
  for (float& share : lost)
    share = 1.0f - share;
  return lost;
}

/// Converts a sum over impacts to Gaussian values. `here` is the map at this weight of the mix.
Value gaussianOf(Value sum, const std::array<float, 3>& gain, const shader::LichenMap& here) {
  const std::array<float, 3> factor{here.sumFactor.x, here.sumFactor.y, here.sumFactor.z};
  for (std::size_t c = 0; c < 3; ++c)
    sum[c] = 0.5f + gain[c] * factor[c] * sum[c];
  sum[3] = 1.0f;
  return sum;
}

} // namespace

struct TextonEvaluator::Map {
  shader::LichenMap constants{};
  RepeatingImage image;
  texton::MixRows mix;
};

Result<TextonEvaluator> TextonEvaluator::create(const Bundle& bundle, std::size_t noiseIndex) {
  const auto exhausted = [&] {
    return "noise " + std::to_string(noiseIndex) + ": not enough memory for its textons";
  };
  return withinMemory(exhausted, [&]() -> Result<TextonEvaluator> {
    if (noiseIndex >= bundle.noises.size())
      return Error{ErrorKind::usage, "noise " + std::to_string(noiseIndex) + ": the bundle has " +
                                         std::to_string(bundle.noises.size())};
    const Noise& noise = bundle.noises[noiseIndex];
    if (noise.method() != Method::texton)
      return Error{ErrorKind::usage, "noise '" + noise.name + "' has the method " +
                                         std::string(nameOf(noise.method())) + ", not texton"};
    auto maps = std::make_shared<std::vector<Map>>();
    for (std::size_t m = 0; m < noise.maps.size(); ++m)
      maps->push_back({shaderMap(bundle, noise, m),
                       RepeatingImage(bundle.tables[noise.maps[m].as<TextonMap>().image]),
                       texton::MixRows(noise.maps[m])});
    return TextonEvaluator(shaderNoise(bundle, noiseIndex), std::move(maps));
  });
}

std::size_t TextonEvaluator::mapCount() const { return maps_->size(); }

Value TextonEvaluator::gaussian(std::size_t mapIndex, const shader::LichenMaterial& material,
                                const TileFootprint& at, const MixPlace& mix) const {
  const Map& map = (*maps_)[mapIndex];
  const Impacts impacts = texton::impactsWithin(0.0f, at, material, noise_);
  const Textons textons(map.image, noise_, impacts, mix);
  const shader::LichenMap here = map.mix.at(map.constants, mix);
  const std::array<float, 3> gain = gainOf(impacts, material, here);
  Value sum{};
  if (needsImpacts(gain))
    texton::forEachImpact(impacts, material, [&](const Vec2& place, float sign) {
      const Value h = textons.at(place);
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += sign * h[c];
    });
  return gaussianOf(sum, gain, here);
}

Value TextonEvaluator::gaussian(std::size_t mapIndex, const shader::LichenMaterial& material,
                                const SurfaceFootprint& at, const MixPlace& mix) const {
  const Map& map = (*maps_)[mapIndex];
  const texton::SurfaceImpacts near = texton::surfaceImpactsAt(at, material, noise_);
  const Textons textons(map.image, noise_, near.impacts, mix);
  const shader::LichenMap here = map.mix.at(map.constants, mix);
  const std::array<float, 3> gain = gainOf(near.impacts, material, here);
  Value sum{};
  if (needsImpacts(gain))
    surface::forEachImpact(near.cubes, [&](const surface::Impact& impact) {
      const Value h = textons.at(impact.offset);
      for (std::size_t c = 0; c < 3; ++c)
        sum[c] += impact.weight * h[c];
    });
  return gaussianOf(sum, gain, here);
}

std::array<float, 3> TextonEvaluator::lostVariance(std::size_t mapIndex,
                                                   const shader::LichenMaterial& material,
                                                   const TileFootprint& at,
                                                   const MixPlace& mix) const {
  const Map& map = (*maps_)[mapIndex];
  return lostOf(texton::impactsWithin(0.0f, at, material, noise_), map.mix.at(map.constants, mix));
}

std::array<float, 3> TextonEvaluator::lostVariance(std::size_t mapIndex,
                                                   const shader::LichenMaterial& material,
                                                   const SurfaceFootprint& at,
                                                   const MixPlace& mix) const {
  const Map& map = (*maps_)[mapIndex];
  return lostOf(texton::surfaceImpactsAt(at, material, noise_).impacts,
                map.mix.at(map.constants, mix));
}

Value TextonEvaluator::decoded(const Map& map, const shader::LichenMaterial& material,
                               const Value& gaussian, std::array<float, 3> lost,
                               const MixPlace& mix) {
  // Contrast scales the lost variance like the remaining one.
  for (float& share : lost)
    share *= material.contrast * material.contrast;
  return decodedGaussian(map.mix.at(map.constants, mix), {gaussian[0], gaussian[1], gaussian[2]},
                         lost);
}

Value TextonEvaluator::evaluate(std::size_t mapIndex, const shader::LichenMaterial& material,
                                const TileFootprint& at, const MixPlace& mix) const {
  return decoded((*maps_)[mapIndex], material, gaussian(mapIndex, material, at, mix),
                 lostVariance(mapIndex, material, at, mix), mix);
}

Value TextonEvaluator::evaluate(std::size_t mapIndex, const shader::LichenMaterial& material,
                                const SurfaceFootprint& at, const MixPlace& mix) const {
  return decoded((*maps_)[mapIndex], material, gaussian(mapIndex, material, at, mix),
                 lostVariance(mapIndex, material, at, mix), mix);
}

Value TextonEvaluator::gaussian(std::size_t mapIndex,
                                const shader::LichenTriplanarMaterial& material,
                                const TriplanarFootprint& at, const MixPlace& mix) const {
  return triplanar::blendedGaussian(
      triplanar::planesAt(at, material, noise_),
      [&](const auto& plane) { return gaussian(mapIndex, plane.material, plane.at, mix); });
}

std::array<float, 3> TextonEvaluator::lostVariance(std::size_t mapIndex,
                                                   const shader::LichenTriplanarMaterial& material,
                                                   const TriplanarFootprint& at,
                                                   const MixPlace& mix) const {
  std::array<float, 3> lost{};
  for (const triplanar::Plane& plane : triplanar::planesAt(at, material, noise_)) {
    if (plane.weight == 0.0f)
      continue;
    const std::array<float, 3> own = lostVariance(mapIndex, plane.material, plane.at, mix);
    for (std::size_t c = 0; c < lost.size(); ++c)
      lost[c] += plane.weight * plane.weight * own[c];
  }
  return lost;
}

Value TextonEvaluator::evaluate(std::size_t mapIndex,
                                const shader::LichenTriplanarMaterial& material,
                                const TriplanarFootprint& at, const MixPlace& mix) const {
  const Map& map = (*maps_)[mapIndex];
  if (map.constants.encoding == LICHEN_ENCODING_SLOPE)
    return triplanar::blendedSlopes(
        triplanar::planesAt(at, material, noise_),
        [&](const auto& plane) { return evaluate(mapIndex, plane.material, plane.at, mix); });
  return decoded(map, material.material, gaussian(mapIndex, material, at, mix),
                 lostVariance(mapIndex, material, at, mix), mix);
}

std::array<float, 3> TextonEvaluator::gradient(std::size_t mapIndex,
                                               const shader::LichenMaterial& material,
                                               const TileFootprint& at, const MixPlace& mix) const {
  const Map& map = (*maps_)[mapIndex];
  constexpr float kMargin = 0.5f; // reach of the finite differences beyond the texton
  const Impacts impacts = texton::impactsWithin(kMargin, at, material, noise_);
  const Textons textons(map.image, noise_, impacts, mix);
  const shader::LichenMap here = map.mix.at(map.constants, mix);
  const float scale = here.row0.x * here.sumFactor.x * gainOf(impacts, material, here)[0];
  std::array<float, 3> sum{};
  if (scale > 0.0f)
    texton::forEachImpact(impacts, material, [&](const Vec2& place, float sign) {
      const std::array<float, 3> h = textons.gradientAt(place);
      for (std::size_t k = 0; k < 3; ++k)
        sum[k] += sign * h[k];
    });
  const std::array<float, 2> meanSlope = map.mix.meanSlope(mix);
  return {here.row0.w + scale * sum[0], scale * sum[1] * noise_.tileTexelsX + meanSlope[0],
          scale * sum[2] * noise_.tileTexelsY + meanSlope[1]};
}

} // namespace lichen
