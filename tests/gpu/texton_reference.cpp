// SPDX-License-Identifier: MIT
// The oracle of the texton tests; see texton_reference.h.
#include "texton_reference.h"

#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <cmath>

namespace lichen::test {
namespace {

/// The centred B-spline of an order by the Cox-de Boor recursion, on half-open intervals.
double centredSpline(int order, double x) {
  if (order == 0)
    return x >= -0.5 && x < 0.5 ? 1.0 : 0.0;
  const double half = 0.5 * (order + 1);
  return ((half + x) * centredSpline(order - 1, x + 0.5) +
          (half - x) * centredSpline(order - 1, x - 0.5)) /
         order;
}

/// Inverts the distribution function of a Poisson variable of mean 1.
int poissonQuantile(double quantile) {
  int count = 0;
  double probability = std::exp(-1.0);
  for (double sum = probability; quantile >= sum && count < 12; sum += probability)
    probability /= ++count;
  return count;
}

double signOf(std::uint32_t word) { return (word >> 31) != 0 ? -1.0 : 1.0; }

} // namespace

TextonReference::TextonReference(const Bundle& bundle, const shader::LichenMaterial& material)
    : map_(bundle.noises[0].maps[0]), textonMap_(map_.as<TextonMap>()),
      image_(bundle.tables[textonMap_.image]), material_(material),
      part_(partOf<shader::LichenTextonMaterial>(material)), noise_(shaderNoise(bundle, 0)),
      texton_(partOf<shader::LichenTextonNoise>(noise_)) {
  const double cellX = double(noise_.tileTexelsX) / double(material_.columnsPerTile);
  const double cellY = double(noise_.tileTexelsY) / double(material_.rowsPerTile);
  const double offsetX = double(material_.offsetX) * double(noise_.tileTexelsX);
  const double offsetY = double(material_.offsetY) * double(noise_.tileTexelsY);
  for (std::int32_t j = 0; j < material_.periodRows; ++j)
    for (std::int32_t i = 0; i < material_.periodColumns; ++i) {
      const auto hash = pcg3d({std::uint32_t(i), std::uint32_t(j), material_.seedWord});
      for (const std::uint32_t word : wordsOf(hash[0], hash[1])) {
        const double x = i - material_.cellI + ((word >> 16 & 32767) + 0.5) / 32768.0;
        const double y = j - material_.cellJ + ((word >> 1 & 32767) + 0.5) / 32768.0;
        impacts_.push_back({x * cellX - offsetX, y * cellY - offsetY, signOf(word)});
      }
    }
  for (std::uint32_t level = 0; level < image_.mipLevels; ++level)
    mips_.push_back(decodeLevel(image_, level));
}

std::vector<std::uint32_t> TextonReference::wordsOf(std::uint32_t word, std::uint32_t count) const {
  if (part_.pointProcess != LICHEN_POINTS_POISSON)
    return {word};
  std::vector<std::uint32_t> words;
  for (int k = 0; k < poissonQuantile(double(count) / std::exp2(32.0)); ++k)
    words.push_back(pcg(word + std::uint32_t(k)));
  return words;
}

void TextonReference::addTexton(Vec& sum, double x, double y, std::uint32_t mip,
                                const MixPlace& mix, double factor) const {
  const auto stored = std::size_t(channelCount(image_.format));
  const int order = mip == 0 ? int(texton_.order) : 1;
  const double side = std::exp2(double(mip));
  const double weight = double(mix.weight) +
                        double(mix.gradient[0]) * x / double(noise_.tileTexelsX) +
                        double(mix.gradient[1]) * y / double(noise_.tileTexelsY);
  const int step =
      int(std::floor(std::clamp(weight, 0.0, 1.0) * (double(texton_.steps) - 1.0) + 0.5));
  const int top = step * (texton_.frameY >> mip);
  for (int row = 0; row * side < texton_.coefficientsY; ++row) {
    const double y0 = (0.5 * texton_.coefficientsY - y) / side - row - 0.5;
    if (std::abs(y0) > 2.0) // the reach of order 3
      continue;
    for (int column = 0; column * side < texton_.coefficientsX; ++column) {
      const double x0 = (0.5 * texton_.coefficientsX - x) / side - column - 0.5;
      if (std::abs(x0) > 2.0)
        continue;
      const float* texel =
          &mips_[mip][std::size_t((top + row) * int(image_.width >> mip) + column) * stored];
      const double splineX = centredSpline(order, x0), splineY = centredSpline(order, y0);
      for (std::size_t c = 0; c < map_.channels.size(); ++c)
        sum[c] += factor * splineX * splineY * textonMap_.scale[c] * double(texel[c]);
    }
  }
}

Vec TextonReference::inPlane(double tileX, double tileY, std::uint32_t mip,
                             const MixPlace& mix) const {
  const double pointX = tileX * double(noise_.tileTexelsX);
  const double pointY = tileY * double(noise_.tileTexelsY);
  const double periodX = double(material_.periodTilesX) * double(noise_.tileTexelsX);
  const double periodY = double(material_.periodTilesY) * double(noise_.tileTexelsY);
  // Twice the reach of the texton and its mips.
  const double farX = 2.0 * texton_.coefficientsX + 4.0 * std::exp2(double(mip)) + 8.0;
  const double farY = 2.0 * texton_.coefficientsY + 4.0 * std::exp2(double(mip)) + 8.0;
  const double root = std::sqrt(double(noise_.tileTexelsX) / double(material_.columnsPerTile) *
                                double(noise_.tileTexelsY) / double(material_.rowsPerTile));
  Vec sum{};
  for (const Impact& impact : impacts_)
    for (double y = impact.y + periodY * std::ceil((pointY - farY - impact.y) / periodY);
         y < pointY + farY; y += periodY)
      for (double x = impact.x + periodX * std::ceil((pointX - farX - impact.x) / periodX);
           x < pointX + farX; x += periodX)
        addTexton(sum, x - pointX, y - pointY, mip, mix, impact.sign * root);
  return sum;
}

Vec TextonReference::onSurface(const Vec& point, const SurfaceFrame& frame, std::uint32_t mip,
                               const MixPlace& mix) const {
  const double tileTexels = double(noise_.tileTexelsX);
  const double scale = 1.0 / std::hypot(double(material_.uvToTileXX), double(material_.uvToTileXY));
  const double texelsPerMetre = tileTexels / (scale * double(noise_.tileSizeMetres));
  const double cube = tileTexels / double(material_.columnsPerTile);
  const double thickness = std::sqrt(double(texton_.coefficientsX + int(texton_.order)) *
                                     double(texton_.coefficientsY + int(texton_.order)));
  const double root = std::sqrt(cube * cube * cube * 3.0 / thickness); // [GLM17] proposition 3
  const std::array<std::int32_t, 3> origin{material_.cellI, material_.cellJ, part_.cellK};
  const double far = 1.5 * std::max(texton_.coefficientsX, texton_.coefficientsY) +
                     4.0 * std::exp2(double(mip)) + 4.0;
  std::array<std::int64_t, 3> first{}, last{}, at{};
  for (std::size_t k = 0; k < 3; ++k) {
    first[k] = std::int64_t(std::floor((point[k] * texelsPerMetre - far) / cube));
    last[k] = std::int64_t(std::floor((point[k] * texelsPerMetre + far) / cube));
  }
  Vec sum{};
  for (at[2] = first[2]; at[2] <= last[2]; ++at[2])
    for (at[1] = first[1]; at[1] <= last[1]; ++at[1])
      for (at[0] = first[0]; at[0] <= last[0]; ++at[0]) {
        std::array<std::uint32_t, 3> cell{};
        for (std::size_t k = 0; k < 3; ++k)
          cell[k] = std::uint32_t(at[k] + origin[k]);
        const auto column = pcg3d({cell[0], cell[1], material_.seedWord});
        for (const std::uint32_t word :
             wordsOf(pcg(column[0] + cell[2]), pcg(column[1] + cell[2]))) {
          Vec way{};
          for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t bits = word >> (21 - 10 * k) & 1023u;
            way[k] = (double(at[k]) + (bits + 0.5) / 1024.0) * cube - point[k] * texelsPerMetre;
          }
          const double height = std::abs(dot(way, frame.outward)) / (0.5 * thickness);
          if (height < 1.0)
            addTexton(sum, dot(way, frame.right), dot(way, frame.down), mip, mix,
                      signOf(word) * (1.0 - height) * root);
        }
      }
  return sum;
}

double TextonReference::gaussian(const Vec& sum, double mixWeight, std::size_t channel) const {
  const std::size_t diagonal = channel * (map_.channels.size() + 1);
  const auto ofStep = [&](std::size_t step) {
    return std::sqrt(
        (step == 0 ? map_.covariance : textonMap_.laterSteps[step - 1].covariance)[diagonal]);
  };
  const double at = std::clamp(mixWeight, 0.0, 1.0) * double(textonMap_.laterSteps.size());
  const auto below = std::size_t(at);
  double deviation = ofStep(below);
  if (below < textonMap_.laterSteps.size())
    deviation += (at - double(below)) * (ofStep(below + 1) - deviation);
  return 0.5 + sum[channel] / (6.0 * deviation);
}

} // namespace lichen::test
