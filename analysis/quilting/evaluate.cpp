// SPDX-License-Identifier: MIT
// Quilting on the CPU: (images, parameters, footprint) -> value. Steps and names follow
// shaders_glsl/noise/quilting.glsl.
#include "sampling/footprint_level.h"
#include "sampling/lattice_vertices.h"
#include "sampling/repeating_image.h"
#include "triplanar/planes.h"

#include <lichen/lattice.h>
#include <lichen/quilting_evaluate.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace lichen {
namespace {

using Value = QuiltingEvaluator::Value;
using Vec2 = std::array<float, 2>;

/// lichenQuiltingDecode: what a texel stands for.
Value decodedTexel(Value texel, shader::uint encoding) {
  if (encoding == LICHEN_ENCODING_ROOT)
    for (std::size_t c = 0; c < 3; ++c)
      texel[c] *= texel[c];
  if (encoding == LICHEN_ENCODING_LOG2)
    for (std::size_t c = 0; c < 3; ++c)
      texel[c] = std::exp2(texel[c]) - 1.0f;
  if (encoding == LICHEN_ENCODING_SLOPE)
    texel[2] = std::max(0.0f, texel[2] - 0.5f * (texel[0] * texel[0] + texel[1] * texel[1]));
  return texel;
}

/// lichenDecodedAt, of a value that is decoded.
Value inRange(Value value, shader::uint encoding) {
  if (encoding == LICHEN_ENCODING_SLOPE) {
    value[2] = std::max(value[2], 0.0f);
    return value;
  }
  const float most = encoding == LICHEN_ENCODING_LOG2 ? 3.0e38f : 1.0f;
  for (std::size_t c = 0; c < 3; ++c)
    value[c] = std::clamp(value[c], 0.0f, most);
  return value;
}

/// lichenHat: 1 at a vertex, 0 on the hexagon of its neighbours, linear in between and beyond.
/// `fromVertex` is in skewed coordinates. [cells]
float hat(const Vec2& fromVertex) {
  return 1.0f - std::max({std::abs(fromVertex[0]), std::abs(fromVertex[1]),
                          std::abs(fromVertex[0] + fromVertex[1])});
}

} // namespace

struct QuiltingEvaluator::Images {
  shader::LichenNoise noise{};
  std::vector<Vec2> offsets; ///< [tiles]
  std::vector<shader::LichenMap> constants;
  std::vector<RepeatingImage> maps;
  RepeatingImage cells;
};

namespace {

/// lichenQuiltingOffset: where the tile of a vertex is taken from. [tiles]
Vec2 offsetOf(const LatticeVertex& vertex, const std::vector<Vec2>& offsets, std::uint32_t seedWord,
              const shader::LichenNoise& noise) {
  const std::uint32_t hash = vertexHash(vertex.i, vertex.j, seedWord);
  if (offsets.empty()) { // as of tiling
    const auto steps = tileOffsetSteps(vertex.i, vertex.j, seedWord);
    return {float(steps[0]) * noise.offsetStepX, float(steps[1]) * noise.offsetStepY};
  }
  return offsets[(hash >> 16u) * std::uint32_t(offsets.size()) >> 16u];
}

} // namespace

Result<QuiltingEvaluator> QuiltingEvaluator::create(const Bundle& bundle, std::size_t noiseIndex) {
  const auto exhausted = [&] {
    return "noise " + std::to_string(noiseIndex) + ": not enough memory for its images";
  };
  return withinMemory(exhausted, [&]() -> Result<QuiltingEvaluator> {
    if (noiseIndex >= bundle.noises.size())
      return Error{ErrorKind::usage, "noise " + std::to_string(noiseIndex) + ": the bundle has " +
                                         std::to_string(bundle.noises.size())};
    const Noise& noise = bundle.noises[noiseIndex];
    if (noise.method() != Method::quilting)
      return Error{ErrorKind::usage, "noise '" + noise.name + "' has the method " +
                                         std::string(nameOf(noise.method())) + ", not quilting"};
    const shader::LichenNoiseConstants constants = shaderConstants(bundle, noiseIndex);
    auto images = std::make_shared<Images>(
        Images{constants.noise,
               {},
               {},
               {},
               RepeatingImage(bundle.tables[noise.maps.front().as<QuiltingMap>().cells])});
    for (std::size_t k = 0; k < quiltingPart(constants.noise).offsets; ++k) {
      const shader::uvec4& four = constants.offsets[k / 4];
      const std::uint32_t word = std::array{four.x, four.y, four.z, four.w}[k % 4];
      images->offsets.push_back({float(word & 0xFFFFu) / 65536.0f, float(word >> 16u) / 65536.0f});
    }
    for (std::size_t m = 0; m < noise.maps.size(); ++m) {
      images->constants.push_back(shaderMap(bundle, noise, m));
      images->maps.emplace_back(bundle.tables[noise.maps[m].as<QuiltingMap>().image]);
    }
    return QuiltingEvaluator(std::move(images));
  });
}

std::size_t QuiltingEvaluator::mapCount() const { return images_->maps.size(); }

Value QuiltingEvaluator::evaluate(std::size_t map, const shader::LichenMaterial& material,
                                  const TileFootprint& at) const {
  return inRange(blend(map, material, at), images_->constants[map].encoding);
}

/// lichenGaussianAt, plus the mean less 1/2.
Value QuiltingEvaluator::blend(std::size_t mapIndex, const shader::LichenMaterial& material,
                               const TileFootprint& footprint) const {
  constexpr float kMostSharpness = 4.0f; // log2 of the steepness of cuts
  constexpr float kLeastHat = 1e-3f, kLeastWeight = 1e-6f;
  TileFootprint at = footprint;
  at.position[0] += material.offsetX;
  at.position[1] += material.offsetY;
  const shader::LichenQuiltingNoise part = quiltingPart(images_->noise);
  const shader::LichenMap& map = images_->constants[mapIndex];
  const float ofTile = footprintLevel(at, images_->noise.tileTexelsX, images_->noise.tileTexelsY);
  const float cellLevel = std::floor(sharpLevel(ofTile + part.cellLevelOffset) + 0.5f);
  const float level = sharpLevel(ofTile + map.levelOffset);
  std::array<float, 3> weights{};
  std::array<Vec2, 3> taps{};
  float sharpness = 0.0f, highest = 0.0f, sum = 0.0f, squares = 0.0f;
  const std::array<LatticeVertex, 3> vertices = latticeVertices(material, at.position);
  for (std::size_t k = 0; k < 3; ++k) {
    const LatticeVertex& vertex = vertices[k];
    const Vec2 offset = offsetOf(vertex, images_->offsets, material.seedWord, images_->noise);
    taps[k] = {at.position[0] - vertex.period[0] + offset[0],
               at.position[1] - vertex.period[1] + offset[1]};
    const Value cell = images_->cells.at(taps[k][0], taps[k][1], cellLevel);
    sharpness = cell[2];
    const float rows = part.reach * (2.0f * cell[1] - 1.0f) * material.rowsPerTile;
    const float columns =
        part.reach * (2.0f * cell[0] - 1.0f) * material.columnsPerTile - 0.5f * rows;
    weights[k] = std::max(kLeastHat, hat({vertex.cells[0] + columns, vertex.cells[1] + rows}));
    highest = std::max(highest, weights[k]);
  }
  const float steepness = std::exp2(kMostSharpness * sharpness);
  for (float& weight : weights)
    weight = std::max(0.0f, highest - steepness * (highest - weight));
  // Only two tiles are fetched: the smallest weight is taken from all.
  const auto least = std::min_element(weights.begin(), weights.end());
  const float taken = *least;
  for (float& weight : weights) {
    weight = &weight == &*least ? 0.0f : std::max(weight - taken, kLeastWeight);
    sum += weight;
  }
  for (float& weight : weights) {
    weight /= sum;
    squares += weight * weight;
  }
  const float correlation = part.correlation * sharpness;
  const float gain = material.contrast / std::sqrt(squares + correlation * (1.0f - squares));
  const Value mean{map.mean.x, map.mean.y, map.mean.z, 1.0f};
  Value value = mean;
  for (std::size_t k = 0; k < 3; ++k) {
    if (weights[k] == 0.0f)
      continue;
    const Value tap =
        decodedTexel(images_->maps[mapIndex].at(taps[k][0], taps[k][1], level), map.encoding);
    for (std::size_t c = 0; c < 3; ++c)
      value[c] += gain * weights[k] * (tap[c] - mean[c]);
  }
  return value;
}

Value QuiltingEvaluator::evaluate(std::size_t mapIndex,
                                  const shader::LichenTriplanarMaterial& material,
                                  const TriplanarFootprint& at) const {
  const shader::LichenMap& map = images_->constants[mapIndex];
  const std::array<triplanar::Plane, 3> planes = triplanar::planesAt(at, material, images_->noise);
  if (map.encoding == LICHEN_ENCODING_SLOPE)
    return triplanar::blendedSlopes(
        planes, [&](const auto& plane) { return evaluate(mapIndex, plane.material, plane.at); });
  const std::array<float, 3> mean{map.mean.x, map.mean.y, map.mean.z};
  Value value = triplanar::blendedGaussian(planes, [&](const auto& plane) {
    Value onPlane = blend(mapIndex, plane.material, plane.at);
    for (std::size_t c = 0; c < 3; ++c)
      onPlane[c] += 0.5f - mean[c];
    return onPlane;
  });
  for (std::size_t c = 0; c < 3; ++c)
    value[c] += mean[c] - 0.5f;
  value[3] = 1.0f;
  return inRange(value, map.encoding);
}

} // namespace lichen
