// SPDX-License-Identifier: MIT
// A quilting noise and its material -> the members of the shader's constants that only it has.
#include "methods/map_constants.h"
#include "methods/method_parameters.h"

#include <cmath>

namespace lichen {
namespace {

static_assert(kMostQuiltingOffsets == LICHEN_MAX_OFFSETS);

/// The mean of the decoded values: the last mip level, which is one texel.
std::array<float, 4> meanOf(const Table& image, ValueEncoding encoding) {
  std::vector<float> mean = decodeLevel(image, image.mipLevels - 1);
  mean.resize(4, 0.0f);
  if (encoding == ValueEncoding::root)
    for (float& value : mean)
      value *= value;
  if (encoding == ValueEncoding::log2)
    for (float& value : mean)
      value = std::exp2(value) - 1.0f;
  if (encoding == ValueEncoding::slope)
    mean[2] -= 0.5f * (mean[0] * mean[0] + mean[1] * mean[1]); // the variance
  return {mean[0], mean[1], mean[2], 1.0f};
}

Grain grainOf(const shader::LichenNoise& noise) {
  return Grain(partOf<shader::LichenQuiltingNoise>(noise).grain);
}

/// A share in [0, 1) as a number of 65,536ths.
shader::uint word16(double share) {
  constexpr double kSteps = 65536.0;
  return shader::uint(std::llround(share * kSteps)) & 0xFFFFu;
}

bool fits(Mapping mapping) { return mapping == Mapping::uv || mapping == Mapping::triplanar; }

std::size_t imageOf(const NoiseMap& map) { return map.as<QuiltingMap>().image; }

Lattice cells(const shader::LichenNoise& noise, const MaterialNoise&, const Placement& placement) {
  const Grain grain = grainOf(noise);
  return placement.periodic ? periodicLattice(placement.periodTilesX, placement.periodTilesY, grain)
                            : infiniteLattice(grain);
}

std::array<std::int64_t, 2> originStep(const shader::LichenNoise& noise, const MaterialNoise&) {
  return {latticeOriginStep(grainOf(noise)), 1};
}

std::array<std::int32_t, 2> cellOf(const shader::LichenNoise& noise, const MaterialNoise&,
                                   std::int64_t tileX, std::int64_t tileY) {
  return latticeCell(tileX, tileY, grainOf(noise));
}

void setMap(const Bundle& bundle, const Noise& noise, const NoiseMap& map,
            shader::LichenMap& constants) {
  const Table& image = bundle.tables[map.as<QuiltingMap>().image];
  setImage(constants, image);
  constants.levelOffset = levelOffset(image, tileSize(bundle, noise));
  constants.decoding = LICHEN_DECODING_NONE;
  const std::array<float, 4> mean = meanOf(image, map.encoding);
  constants.mean = {mean[0], mean[1], mean[2], mean[3]};
}

void setNoise(const Bundle& bundle, const Noise& noise, shader::LichenNoise& constants) {
  const auto& shared = noise.as<QuiltingNoise>();
  shader::LichenQuiltingNoise part{};
  part.grain = shader::uint(shared.grain);
  part.reach = float(shared.reach);
  part.correlation = float(shared.correlation);
  part.offsets = shader::uint(shared.offsets.size());
  if (!noise.maps.empty()) {
    const Table& cells = bundle.tables[noise.maps.front().as<QuiltingMap>().cells];
    part.cellLevelOffset = levelOffset(cells, tileSize(bundle, noise));
  }
  setPart(constants, part);
  setOffsetSteps(constants);
}

void setConstants(const Noise& noise, shader::LichenNoiseConstants& constants) {
  const auto& offsets = noise.as<QuiltingNoise>().offsets;
  for (std::size_t k = 0; k < offsets.size(); ++k) {
    const shader::uint word = word16(offsets[k][0]) | word16(offsets[k][1]) << 16u;
    shader::uvec4& four = constants.offsets[k / 4];
    shader::uint* const words[] = {&four.x, &four.y, &four.z, &four.w};
    *words[k % 4] = word;
  }
}

std::size_t cellsOf(const NoiseMap& map) { return map.as<QuiltingMap>().cells; }

} // namespace

extern const MethodParameters kQuiltingParameters{.fits = fits,
                                                  .isLayerable = false,
                                                  .imageOf = imageOf,
                                                  .sharedImage = cellsOf,
                                                  .cells = cells,
                                                  .originStep = originStep,
                                                  .cellOf = cellOf,
                                                  .setMap = setMap,
                                                  .setNoise = setNoise,
                                                  .setConstants = setConstants};

} // namespace lichen
