// SPDX-License-Identifier: MIT
// Tiling and blending on the CPU: (tables, parameters, footprint) -> value. [HN18] Algorithm 1 with
// the prefiltered table. Steps and names follow shaders_glsl/noise/tiling.glsl with a trilinear
// sampler.
#include "fewer_taps.h"
#include "sampling/footprint_level.h"
#include "sampling/level_kept.h"
#include "sampling/repeating_image.h"
#include "simplex_lattice.h"
#include "tile_rotation.h"
#include "triplanar/planes.h"

#include <lichen/tiling_evaluate.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace lichen {
namespace {

using Value = TilingEvaluator::Value;

/// Abramowitz and Stegun 7.1.28, |error| <= 3e-7.
float errorFunction(float x) {
  const float a = std::abs(x);
  float p = 0.0000430638f;
  for (const float coefficient :
       {0.0002765672f, 0.0001520143f, 0.0092705272f, 0.0422820123f, 0.0705230784f, 1.0f})
    p = p * a + coefficient;
  p *= p;
  p *= p;
  p *= p;
  p *= p;
  return std::copysign(1.0f - 1.0f / p, x);
}

/// [HN18] eq. 22, corrected: the CDF of N(1/2, (1/6)^2).
float uniformFromGaussian(float value) {
  constexpr float kThreeRootTwo = 4.2426406871f;
  return 0.5f + 0.5f * errorFunction(kThreeRootTwo * (value - 0.5f));
}

/// lichenTilingLevel for a trilinear sampler; at most the last mip level.
float levelOfDetail(const shader::LichenMap& map, const TileFootprint& at) {
  return std::min(footprintLevel(at, map.widthTexels, map.heightTexels), float(map.mipCount - 1));
}

/// The share of the variance that remains after a bilinear fetch of one mip level.
float fetchKept(const shader::LichenMap& map, int mip, const TileFootprint& at, float magnified,
                bool shareTexels) {
  const float kept = mipKept(map.mipKept0, mip);
  // Midway between four texels the fetch is their average, a texel of the next mip level.
  constexpr float kLeast = 1e-3f; // of the unorm bytes, below the smallest
  const float loss = 4.0f - 4.0f * mipKept(map.mipKept0, mip + 1) / std::max(kept, kLeast);
  // The average over all positions between texels applies if the taps differ in position, or if
  // pixels are smaller than texels, where the table's level would show as a mesh.
  constexpr float kAverage = 1.0f / 6.0f;
  const auto share = [&](float position, float size) {
    const float texel = std::ldexp(position * size, -mip) - 0.5f;
    const float inside = texel - std::floor(texel);
    const float here =
        shareTexels && mip < int(map.alignedMips) ? inside * (1.0f - inside) : kAverage;
    return 1.0f - loss * (here + magnified * (kAverage - here));
  };
  return kept * kept * share(at.position[0], map.widthTexels) *
         share(at.position[1], map.heightTexels);
}

/// The share of the variance that a tap loses: it blends a mip level with its own average.
float lostVariance(const shader::LichenMap& map, const shader::LichenNoise& noise,
                   const TileFootprint& at, float level) {
  const bool shareTexels = tiling::turnsKeepTexels(noise);
  const float lod = std::max(level, 0.0f);
  const int mip = int(lod);
  const float magnified = std::clamp(-level, 0.0f, 1.0f);
  const float below = fetchKept(map, mip, at, magnified, shareTexels);
  const float above = fetchKept(map, mip + 1, at, magnified, shareTexels);
  const float rest = 1.0f - (lod - float(mip));
  return 1.0f - (above + rest * rest * (below - above));
}

/// The share of the lost variance that is due to the footprint; interpolation loses the rest.
float footprintShare(const shader::LichenMap& map, float level, float lostVariance) {
  const float lost = 1.0f - levelKept(map, std::max(level, 0.0f));
  return lost < lostVariance ? lost / lostVariance : 1.0f;
}

/// The level of the table that is prefiltered for this lost variance: lichenTableLevel.
float tableLevel(const shader::LichenMap& map, float lost, float contrast) {
  const auto last = float(map.tableLevels - 1);
  const float beforeLast = 1.0f / std::max(last * last, 1.0f);
  const float least = std::min(std::max(0.0f, 1.0f - lost), beforeLast);
  return last * (1.0f - std::sqrt(std::max(1.0f - contrast * contrast * lost, least)));
}

/// lichenWithinTable.
Value withinTable(const Value& gaussian, float lost, float contrast) {
  const float scale = 1.0f / std::sqrt(std::max(1.0f, contrast * contrast * lost));
  Value within = gaussian;
  for (std::size_t c = 0; c < 3; ++c)
    within[c] = 0.5f + scale * (gaussian[c] - 0.5f);
  return within;
}

bool isSlope(const shader::LichenMap& map) { return map.encoding == LICHEN_ENCODING_SLOPE; }

void turnSlopesBack(Value& value, const std::array<float, 2>& turn) {
  const auto [x, y] = tiling::slopesTurnedBack(value[0], value[1], turn);
  value[0] = x;
  value[1] = y;
}

/// Describes what is wrong with a quality, if anything.
std::optional<std::string> problemOf(const TilingQuality& quality) {
  if (quality.taps != 2 && quality.taps != 3)
    return "taps " + std::to_string(quality.taps) + "; expected 2 or 3";
  if (!(quality.oneTapTiles >= kOneTapTilesRange.least &&
        quality.oneTapTiles <= kOneTapTilesRange.most))
    return "one tap from " + std::to_string(quality.oneTapTiles) +
           " tiles per pixel; expected a number from 0 to 1000000";
  return std::nullopt;
}

} // namespace

struct TilingEvaluator::Map {
  shader::LichenMap constants{};
  RepeatingImage image;
  std::size_t channels = 0;
  int tableSide = 0;
  std::vector<Value> table; ///< slab k, then the cells, first axis fastest; empty without one
};

Result<TilingEvaluator> TilingEvaluator::create(const Bundle& bundle, std::size_t noiseIndex,
                                                const TilingQuality& quality) {
  const auto exhausted = [&] {
    return "noise " + std::to_string(noiseIndex) + ": not enough memory for its tables";
  };
  return withinMemory(exhausted, [&]() -> Result<TilingEvaluator> {
    if (noiseIndex >= bundle.noises.size())
      return Error{ErrorKind::usage, "noise " + std::to_string(noiseIndex) + ": the bundle has " +
                                         std::to_string(bundle.noises.size())};
    const Noise& noise = bundle.noises[noiseIndex];
    if (noise.method() != Method::tiling)
      return Error{ErrorKind::usage, "noise '" + noise.name + "' has the method " +
                                         std::string(nameOf(noise.method())) + ", not tiling"};
    if (const std::optional<std::string> problem = problemOf(quality))
      return Error{ErrorKind::usage, *problem};
    auto maps = std::make_shared<std::vector<Map>>();
    for (std::size_t m = 0; m < noise.maps.size(); ++m) {
      const auto& stored = noise.maps[m].as<TilingMap>();
      Map map{shaderMap(bundle, noise, m),
              RepeatingImage(bundle.tables[stored.gaussian]),
              noise.maps[m].channels.size(),
              0,
              {}};
      if (stored.inverseTable) {
        const Table& table = bundle.tables[*stored.inverseTable];
        map.tableSide = int(table.width);
        map.table = texelsOf(table, 0);
      }
      maps->push_back(std::move(map));
    }
    return TilingEvaluator(std::move(maps), quality);
  });
}

std::size_t TilingEvaluator::mapCount() const { return maps_->size(); }

std::vector<float> TilingEvaluator::decodedTexels(std::size_t mapIndex) const {
  const Map& map = (*maps_)[mapIndex];
  std::vector<float> values;
  values.reserve(map.image.texels(0).size() * map.channels);
  for (const Value& texel : map.image.texels(0)) {
    const Value value = decode(map, texel, 0.0f, 1.0f);
    values.insert(values.end(), value.begin(), value.begin() + std::ptrdiff_t(map.channels));
  }
  return values;
}

Value TilingEvaluator::slabLookup(const Map& map, const Value& uniform, std::size_t slab) {
  const auto side = std::size_t(map.tableSide);
  const std::size_t dimensions = map.constants.dimensions;
  std::array<std::size_t, 3> step{};
  std::array<float, 3> fraction{};
  std::size_t base = slab;
  std::size_t stride = 1;
  for (std::size_t axis = 0; axis < dimensions; ++axis)
    base *= side;
  for (std::size_t axis = 0; axis < dimensions; ++axis, stride *= side) {
    const float place = std::clamp(uniform[axis] * float(side) - 0.5f, 0.0f, float(side - 1));
    const auto cell = std::size_t(place);
    base += cell * stride;
    step[axis] = cell + 1 < side ? stride : 0;
    fraction[axis] = place - float(cell);
  }
  const Value* cells = map.table.data() + base;
  const auto line = [&](std::size_t at) {
    return mix(cells[at], cells[at + step[0]], fraction[0]);
  };
  const auto square = [&](std::size_t at) {
    return mix(line(at), line(at + step[1]), fraction[1]);
  };
  if (dimensions == 1)
    return line(0);
  return dimensions == 2 ? square(0) : mix(square(0), square(step[2]), fraction[2]);
}

Value TilingEvaluator::decodeJoint(const Map& map, const Value& gaussian, float level) {
  Value uniform{};
  for (std::size_t axis = 0; axis < map.constants.dimensions; ++axis)
    uniform[axis] = uniformFromGaussian(gaussian[axis]);
  const auto slab = std::size_t(level);
  const Value value = slabLookup(map, uniform, slab);
  const float t = level - float(slab);
  return t > 0.0f ? mix(value, slabLookup(map, uniform, slab + 1), t) : value;
}

Value TilingEvaluator::decode(const Map& map, const Value& gaussian, float lost, float contrast) {
  if (map.constants.decoding == LICHEN_DECODING_GAUSSIAN) {
    const float scaled = contrast * contrast * lost;
    return decodedGaussian(map.constants, {gaussian[0], gaussian[1], gaussian[2]},
                           {scaled, scaled, scaled});
  }
  const Value within = withinTable(gaussian, lost, contrast);
  return decodeJoint(map, within, tableLevel(map.constants, lost, contrast));
}

Value TilingEvaluator::blended(const Map& map, const shader::LichenNoise& noise,
                               const TileFootprint& at, BlendOperator blend, float lod,
                               float lost) const {
  tiling::Taps taps = tiling::tapsAt(noise, at.position);
  tiling::takeFewerTaps(taps, at, quality_);
  const bool decodeFirst = blend != BlendOperator::histogramPreserving;
  const bool turnsSlopes = tiling::turnsTiles(noise) && isSlope(map.constants);
  const shader::vec4& mean = map.constants.mean;
  const Value middle = !decodeFirst  ? Value{0.5f, 0.5f, 0.5f, 1.0f}
                       : turnsSlopes ? Value{0.0f, 0.0f, mean.z, 1.0f}
                                     : Value{mean.x, mean.y, mean.z, 1.0f};
  Value sum{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (taps.weight[k] == 0.0f)
      continue;
    Value tap = map.image.at(taps.position[k][0], taps.position[k][1], lod);
    if (decodeFirst)
      tap = decode(map, tap, lost, 1.0f);
    if (decodeFirst && turnsSlopes)
      turnSlopesBack(tap, taps.turn[k]);
    for (std::size_t c = 0; c < 3; ++c)
      sum[c] += taps.weight[k] * (tap[c] - middle[c]);
  }
  const float scale = noise.contrast / (blend == BlendOperator::linear ? 1.0f : taps.norm);
  Value result = middle;
  for (std::size_t c = 0; c < 3; ++c)
    result[c] += scale * sum[c];
  return result;
}

/// Blends the slopes of rotated tiles, each of which has lost the share `lost` of its variance:
/// lichenTilingDecodeTiles.
Value TilingEvaluator::turnedSlopes(const Map& map, const shader::LichenNoise& noise,
                                    const TileFootprint& at, float lod, float lost) const {
  tiling::Taps taps = tiling::tapsAt(noise, at.position);
  tiling::takeFewerTaps(taps, at, quality_);
  Value sum{0.0f, 0.0f, 0.0f, 1.0f};
  for (std::size_t k = 0; k < 3; ++k) {
    if (taps.weight[k] == 0.0f)
      continue;
    Value tap = map.image.at(taps.position[k][0], taps.position[k][1], lod);
    for (std::size_t c = 0; c < 3; ++c)
      tap[c] = 0.5f + noise.contrast * (tap[c] - 0.5f);
    Value slopes = decode(map, tap, lost, noise.contrast);
    turnSlopesBack(slopes, taps.turn[k]);
    const float share = taps.weight[k] / taps.norm;
    sum[0] += share * slopes[0];
    sum[1] += share * slopes[1];
    sum[2] += share * share * slopes[2];
  }
  return sum;
}

/// Decodes a Gaussian value of one plane.
Value TilingEvaluator::decoded(const Map& map, const shader::LichenNoise& noise,
                               const TileFootprint& at, const Value& gaussian) {
  Value result = decode(map, gaussian, gaussian[3], noise.contrast);
  if (isSlope(map.constants))
    result[2] *= footprintShare(map.constants, levelOfDetail(map.constants, at), gaussian[3]);
  return result;
}

Value TilingEvaluator::gaussian(std::size_t mapIndex, const shader::LichenNoise& noise,
                                const TileFootprint& at) const {
  const Map& map = (*maps_)[mapIndex];
  const float lod = levelOfDetail(map.constants, at);
  const float lost = lostVariance(map.constants, noise, at, lod);
  Value result = blended(map, noise, at, BlendOperator::histogramPreserving, lod, lost);
  result[3] = lost;
  return result;
}

Value TilingEvaluator::evaluate(std::size_t mapIndex, const shader::LichenNoise& noise,
                                const TileFootprint& at, BlendOperator blend) const {
  const Map& map = (*maps_)[mapIndex];
  const bool turnsSlopes = tiling::turnsTiles(noise) && isSlope(map.constants);
  if (blend == BlendOperator::histogramPreserving && !turnsSlopes)
    return decoded(map, noise, at, gaussian(mapIndex, noise, at));
  const float lod = levelOfDetail(map.constants, at);
  const float lost = lostVariance(map.constants, noise, at, lod);
  if (blend != BlendOperator::histogramPreserving)
    return blended(map, noise, at, blend, lod, lost);
  Value slopes = turnedSlopes(map, noise, at, lod, lost);
  slopes[2] *= footprintShare(map.constants, lod, lost);
  return slopes;
}

Value TilingEvaluator::gaussian(std::size_t mapIndex, const shader::LichenNoise& noise,
                                const TriplanarFootprint& at) const {
  return triplanar::blendedGaussian(triplanar::planesAt(at, noise), [&](const auto& plane) {
    return gaussian(mapIndex, plane.noise, plane.at);
  });
}

Value TilingEvaluator::evaluate(std::size_t mapIndex, const shader::LichenNoise& noise,
                                const TriplanarFootprint& at) const {
  const Map& map = (*maps_)[mapIndex];
  if (isSlope(map.constants))
    return triplanar::blendedSlopes(triplanar::planesAt(at, noise), [&](const auto& plane) {
      return evaluate(mapIndex, plane.noise, plane.at);
    });
  const Value blend = gaussian(mapIndex, noise, at);
  return decode(map, blend, blend[3], noise.contrast);
}

} // namespace lichen
