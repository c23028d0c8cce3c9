// SPDX-License-Identifier: MIT
// The oracle of the surface tests; see surface_reference.h.
#include "surface_reference.h"

#include "texton_reference.h"

#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <cmath>

namespace lichen::test {
namespace {

double dot(const SurfaceReference::Vec& a, const SurfaceReference::Vec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// The random words of a cube's impacts.
std::vector<std::uint32_t> wordsOf(const std::array<std::int64_t, 3>& cube,
                                   const shader::LichenMaterial& material, bool isPoisson) {
  const auto column = pcg3d({std::uint32_t(cube[0]), std::uint32_t(cube[1]), material.seedWord});
  const std::uint32_t word = pcg(column[0] + std::uint32_t(cube[2]));
  if (!isPoisson)
    return {word};
  std::vector<std::uint32_t> words;
  const int count =
      poissonQuantile(double(pcg(column[1] + std::uint32_t(cube[2]))) / std::exp2(32.0));
  for (int k = 0; k < count; ++k)
    words.push_back(pcg(word + std::uint32_t(k)));
  return words;
}

} // namespace

SurfaceReference::SurfaceReference(const Bundle& bundle, const shader::LichenMaterial& material)
    : bundle_(bundle), material_(material), part_(textonPart(material)),
      noise_(shaderNoise(bundle, 0)), texton_(textonPart(noise_)) {
  const Table& image = bundle.tables[bundle.noises[0].maps[0].as<TextonMap>().image];
  for (std::uint32_t level = 0; level < image.mipLevels; ++level)
    mips_.push_back(decodeLevel(image, level));
}

SurfaceReference::Vec SurfaceReference::textonAt(double x, double y, std::uint32_t mip,
                                                 int step) const {
  const NoiseMap& map = bundle_.noises[0].maps[0];
  const Table& image = bundle_.tables[map.as<TextonMap>().image];
  const auto stored = std::size_t(channelCount(image.format));
  const int order = mip == 0 ? int(texton_.order) : 1;
  const double side = std::exp2(double(mip));
  Vec sum{};
  for (int row = 0; row * side < texton_.coefficientsY; ++row)
    for (int column = 0; column * side < texton_.coefficientsX; ++column) {
      const double h = centredSpline(order, x / side - column - 0.5) *
                       centredSpline(order, y / side - row - 0.5);
      const auto texel =
          std::size_t((step * (texton_.frameY >> mip) + row) * int(image.width >> mip) + column);
      for (std::size_t c = 0; c < map.channels.size(); ++c)
        sum[c] += h * map.as<TextonMap>().scale[c] * double(mips_[mip][texel * stored + c]);
    }
  return sum;
}

SurfaceReference::Vec SurfaceReference::at(const Vec& point, const Vec& right, const Vec& down,
                                           const Vec& outward, std::uint32_t mip, double mixWeight,
                                           std::array<double, 2> mixGradient) const {
  const double tileTexels = double(noise_.tileTexelsX);
  const double scale = 1.0 / std::hypot(double(material_.uvToTileXX), double(material_.uvToTileXY));
  const double texelsPerMetre = tileTexels / (scale * double(noise_.tileSizeMetres));
  const double cube = tileTexels / double(material_.columnsPerTile);
  const double thickness = std::sqrt(double(texton_.coefficientsX + int(texton_.order)) *
                                     double(texton_.coefficientsY + int(texton_.order)));
  const std::array<std::int32_t, 3> origin{material_.cellI, material_.cellJ, part_.cellK};
  const double far = 1.5 * std::max(texton_.coefficientsX, texton_.coefficientsY) +
                     4.0 * std::exp2(double(mip)) + 4.0;
  std::array<std::int64_t, 3> first{}, last{};
  Vec texels{};
  for (std::size_t k = 0; k < 3; ++k) {
    texels[k] = point[k] * texelsPerMetre;
    first[k] = std::int64_t(std::floor((texels[k] - far) / cube));
    last[k] = std::int64_t(std::floor((texels[k] + far) / cube));
  }
  Vec sum{};
  for (std::int64_t k = first[2]; k <= last[2]; ++k)
    for (std::int64_t j = first[1]; j <= last[1]; ++j)
      for (std::int64_t i = first[0]; i <= last[0]; ++i)
        for (const std::uint32_t word :
             wordsOf({i + origin[0], j + origin[1], k + origin[2]}, material_,
                     part_.pointProcess == LICHEN_POINTS_POISSON)) {
          const std::array<std::uint32_t, 3> bits{word >> 21, word >> 11, word >> 1};
          const std::array<std::int64_t, 3> corner{i, j, k};
          Vec way{};
          for (std::size_t axis = 0; axis < 3; ++axis)
            way[axis] = texels[axis] -
                        (double(corner[axis]) + (double(bits[axis] % 1024u) + 0.5) / 1024.0) * cube;
          const double height = std::abs(dot(way, outward)) / (0.5 * thickness);
          if (height >= 1.0)
            continue;
          const double alongX = dot(way, right), alongY = dot(way, down);
          const double weight = std::clamp(mixWeight - mixGradient[0] * alongX / tileTexels -
                                               mixGradient[1] * alongY / double(noise_.tileTexelsY),
                                           0.0, 1.0);
          const int step = int(std::floor(weight * (double(texton_.steps) - 1.0) + 0.5));
          const Vec h = textonAt(alongX + 0.5 * texton_.coefficientsX,
                                 alongY + 0.5 * texton_.coefficientsY, mip, step);
          for (std::size_t c = 0; c < 3; ++c)
            sum[c] += ((word >> 31) != 0 ? -1.0 : 1.0) * (1.0 - height) * h[c];
        }
  // [GLM17] proposition 3.
  const double lambda = 1.0 / (cube * cube * cube);
  for (double& value : sum)
    value /= std::sqrt(lambda * thickness / 3.0);
  return sum;
}

} // namespace lichen::test
