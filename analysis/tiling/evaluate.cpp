// SPDX-License-Identifier: MIT
// Tiling and blending on the CPU: (tables, parameters, footprint) -> value. [HN18] Algorithm 1 with
// the prefiltered table. Steps and names follow shaders_glsl/noise/tiling.glsl with a trilinear
// sampler.
#include "gaussianization/value_decoder.h"
#include "sampling/footprint_level.h"
#include "sampling/repeating_image.h"
#include "simplex_lattice.h"
#include "tile_rotation.h"
#include "triplanar/planes.h"

#include <lichen/tiling_evaluate.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace lichen {
namespace {

using Value = TilingEvaluator::Value;

bool isSlope(const shader::LichenMap& map) { return map.encoding == LICHEN_ENCODING_SLOPE; }

/// lichenLossShare.
float lossShare(const shader::LichenNoise& noise, const TileFootprint& at, float footprint) {
  const std::array<float, 2> texels{noise.tileTexelsX, noise.tileTexelsY};
  float here = 0.0f;
  std::array<float, 2> squares{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const float texel = at.position[axis] * texels[axis];
    const float fromCentre = std::abs(texel - std::floor(texel) - 0.5f);
    here += 3.0f * fromCentre * (1.0f - fromCentre);
    squares[0] += at.dx[axis] * texels[axis] * at.dx[axis] * texels[axis];
    squares[1] += at.dy[axis] * texels[axis] * at.dy[axis] * texels[axis];
  }
  const float squared = std::min(1.0f, std::max(squares[0], squares[1]));
  return 1.0f + squared * squared * (1.0f - std::min(footprint, 1.0f)) * (here - 1.0f);
}

void rotateSlopesBack(Value& value, const std::array<float, 2>& turn) {
  const auto [x, y] = tiling::turned({value[0], value[1]}, turn);
  value[0] = x;
  value[1] = y;
}

} // namespace

/// The tiles at a point: where they are fetched, and what is fetched. The fourth component is the
/// share of the variance that fetches lose on average.
struct TilingEvaluator::Tiles {
  tiling::Taps taps;
  std::array<Value, 3> value{};
  float lossShare = 1.0f; ///< what they lose here, over that
};

struct TilingEvaluator::Map {
  gaussianization::ValueDecoder decoder;
  RepeatingImage image;
  std::size_t channels = 0;

  [[nodiscard]] const shader::LichenMap& constants() const { return decoder.constants(); }
};

Result<TilingEvaluator> TilingEvaluator::create(const Bundle& bundle, std::size_t noiseIndex,
                                                bool nearestTableLevel) {
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
    auto maps = std::make_shared<std::vector<Map>>();
    for (std::size_t m = 0; m < noise.maps.size(); ++m) {
      const auto& stored = noise.maps[m].as<TilingMap>();
      maps->push_back(
          {gaussianization::ValueDecoder(bundle, shaderMap(bundle, noise, m), stored.inverseTable),
           RepeatingImage(bundle.tables[stored.gaussian], Alpha::lastChannel),
           noise.maps[m].channels.size()});
    }
    return TilingEvaluator(shaderNoise(bundle, noiseIndex), std::move(maps), nearestTableLevel);
  });
}

std::size_t TilingEvaluator::mapCount() const { return maps_->size(); }

std::vector<float> TilingEvaluator::decodedTexels(std::size_t mapIndex) const {
  const Map& map = (*maps_)[mapIndex];
  std::vector<float> values;
  values.reserve(map.image.texels(0).size() * map.channels);
  for (const Value& texel : map.image.texels(0)) {
    constexpr float kShift = 0.5f - kStoredGaussianMean;
    const Value value =
        decode(map, {texel[0] + kShift, texel[1] + kShift, texel[2] + kShift, 0.0f}, 1.0f);
    values.insert(values.end(), value.begin(), value.begin() + std::ptrdiff_t(map.channels));
  }
  return values;
}

/// lichenDecode, of a Gaussian value with the share of the lost variance in the fourth component.
Value TilingEvaluator::decode(const Map& map, const Value& gaussian, float contrast) const {
  return map.decoder.decode(gaussian, contrast, nearestTableLevel_);
}

/// lichenDecodeTile.
Value TilingEvaluator::decodeTile(const Map& map, const Value& tile, float lossShare,
                                  float contrast) const {
  Value value = decode(map, {tile[0], tile[1], tile[2], lossShare * tile[3]}, contrast);
  if (isSlope(map.constants()))
    value[2] *= footprintShare(map, tile[3]);
  return value;
}

TilingEvaluator::Tiles TilingEvaluator::tilesAt(const Map& map,
                                                const shader::LichenMaterial& material,
                                                TileFootprint at) const {
  at.position[0] += material.offsetX;
  at.position[1] += material.offsetY;
  Tiles tiles{tiling::tapsAt(material, noise_, at.position)};
  const float footprint = footprintLevel(at, noise_.tileTexelsX, noise_.tileTexelsY);
  const float level = sharpLevel(footprint + map.constants().levelOffset);
  if (map.constants().levelOffset == 0.0f)
    tiles.lossShare = lossShare(noise_, at, footprint);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [x, y] = tiles.taps.position[k];
    tiles.value[k] = map.image.at(x, y, level);
    for (std::size_t c = 0; c < 3; ++c)
      tiles.value[k][c] += 0.5f - kStoredGaussianMean;
  }
  return tiles;
}

/// lichenFootprintShare.
float TilingEvaluator::footprintShare(const Map& map, float loss) {
  const float interpolation = map.constants().interpolationLoss;
  return loss > interpolation ? 1.0f - interpolation / loss : 0.0f;
}

Value TilingEvaluator::blended(const Tiles& tiles, const shader::LichenMaterial& material) {
  Value blend{};
  for (std::size_t k = 0; k < 3; ++k)
    for (std::size_t c = 0; c < 4; ++c)
      blend[c] += tiles.taps.weight[k] * tiles.value[k][c];
  const float gain = material.contrast / tiles.taps.norm;
  for (std::size_t c = 0; c < 3; ++c)
    blend[c] = 0.5f + gain * (blend[c] - 0.5f);
  return blend;
}

/// The slopes of rotated tiles, decoded one by one, turned back and blended about 0: a joint table
/// knows slopes as they lie in the exemplar.
Value TilingEvaluator::rotatedSlopes(const Map& map, const Tiles& tiles,
                                     const shader::LichenMaterial& material) const {
  Value sum{0.0f, 0.0f, 0.0f, 1.0f};
  for (std::size_t k = 0; k < 3; ++k) {
    Value tile = tiles.value[k];
    for (std::size_t c = 0; c < 3; ++c)
      tile[c] = 0.5f + material.contrast * (tile[c] - 0.5f);
    Value slopes = decodeTile(map, tile, tiles.lossShare, material.contrast);
    rotateSlopesBack(slopes, tiles.taps.turn[k]);
    const float share = tiles.taps.weight[k] / tiles.taps.norm;
    sum[0] += share * slopes[0];
    sum[1] += share * slopes[1];
    sum[2] += share * share * slopes[2];
  }
  return sum;
}

Value TilingEvaluator::gaussian(std::size_t mapIndex, const shader::LichenMaterial& material,
                                const TileFootprint& at) const {
  const Tiles tiles = tilesAt((*maps_)[mapIndex], material, at);
  Value blend = blended(tiles, material);
  blend[3] *= tiles.lossShare;
  return blend;
}

Value TilingEvaluator::evaluate(std::size_t mapIndex, const shader::LichenMaterial& material,
                                const TileFootprint& at) const {
  const Map& map = (*maps_)[mapIndex];
  const Tiles tiles = tilesAt(map, material, at);
  if (tiling::rotatesTiles(material) && isSlope(map.constants()))
    return rotatedSlopes(map, tiles, material);
  return decodeTile(map, blended(tiles, material), tiles.lossShare, material.contrast);
}

Value TilingEvaluator::gaussian(std::size_t mapIndex,
                                const shader::LichenTriplanarMaterial& material,
                                const TriplanarFootprint& at) const {
  return triplanar::blendedGaussian(
      triplanar::planesAt(at, material, noise_),
      [&](const auto& plane) { return gaussian(mapIndex, plane.material, plane.at); });
}

Value TilingEvaluator::evaluate(std::size_t mapIndex,
                                const shader::LichenTriplanarMaterial& material,
                                const TriplanarFootprint& at) const {
  const Map& map = (*maps_)[mapIndex];
  if (isSlope(map.constants()))
    return triplanar::blendedSlopes(
        triplanar::planesAt(at, material, noise_),
        [&](const auto& plane) { return evaluate(mapIndex, plane.material, plane.at); });
  const Value blend = gaussian(mapIndex, material, at);
  return decode(map, blend, material.material.contrast);
}

} // namespace lichen
