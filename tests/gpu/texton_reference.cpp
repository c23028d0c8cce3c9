// SPDX-License-Identifier: MIT
// The oracle of the texton tests; see texton_reference.h.
#include "texton_reference.h"

#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <cmath>

namespace lichen::test {
namespace {

/// The derivative of the centred B-spline of an order.
double splineSlope(int order, double x) {
  return order == 0 ? 0.0 : centredSpline(order - 1, x + 0.5) - centredSpline(order - 1, x - 0.5);
}

} // namespace

double centredSpline(int order, double x) {
  if (order == 0)
    return x >= -0.5 && x < 0.5 ? 1.0 : 0.0;
  const double half = 0.5 * (order + 1);
  return ((half + x) * centredSpline(order - 1, x + 0.5) +
          (half - x) * centredSpline(order - 1, x - 0.5)) /
         order;
}

int poissonQuantile(double quantile) {
  int count = 0;
  double probability = std::exp(-1.0);
  for (double sum = probability; quantile >= sum && count < 12; sum += probability)
    probability /= ++count;
  return count;
}

double deviationAt(const NoiseMap& map, double weight, std::size_t channel) {
  const std::size_t diagonal = channel * (map.channels.size() + 1);
  const auto ofStep = [&](std::size_t step) {
    return std::sqrt((step == 0 ? map.covariance
                                : map.as<TextonMap>().laterSteps[step - 1].covariance)[diagonal]);
  };
  const double at = std::clamp(weight, 0.0, 1.0) * double(map.as<TextonMap>().laterSteps.size());
  const auto below = std::size_t(at);
  return below == map.as<TextonMap>().laterSteps.size()
             ? ofStep(below)
             : ofStep(below) + (at - double(below)) * (ofStep(below + 1) - ofStep(below));
}

TextonReference::TextonReference(const Bundle& bundle, const shader::LichenMaterial& material)
    : bundle_(bundle), material_(material), part_(textonPart(material)),
      noise_(shaderNoise(bundle, 0)), texton_(textonPart(noise_)) {
  const double cellX = double(noise_.tileTexelsX) / double(material_.columnsPerTile);
  const double offsetX = double(material_.offsetX) * double(noise_.tileTexelsX);
  const double offsetY = double(material_.offsetY) * double(noise_.tileTexelsY);
  const double cellY = double(noise_.tileTexelsY) / double(material_.rowsPerTile);
  for (std::int32_t j = 0; j < material_.periodRows; ++j)
    for (std::int32_t i = 0; i < material_.periodColumns; ++i) {
      const auto hash = pcg3d({std::uint32_t(i), std::uint32_t(j), material_.seedWord});
      const bool poisson = part_.pointProcess == LICHEN_POINTS_POISSON;
      const int count = poisson ? poissonQuantile(double(hash[1]) / std::exp2(32.0)) : 1;
      for (int k = 0; k < count; ++k) {
        const std::uint32_t word = poisson ? pcg(hash[0] + std::uint32_t(k)) : hash[0];
        const double x = i - material_.cellI + ((word >> 16 & 32767) + 0.5) / 32768.0;
        const double y = j - material_.cellJ + ((word >> 1 & 32767) + 0.5) / 32768.0;
        impacts_.push_back(
            {x * cellX - offsetX, y * cellY - offsetY, (word >> 31) != 0 ? -1.0 : 1.0});
      }
    }
  const Table& image = bundle.tables[bundle.noises[0].maps[0].as<TextonMap>().image];
  for (std::uint32_t level = 0; level < image.mipLevels; ++level)
    mips_.push_back(decodeLevel(image, level));
}

TextonReference::Sum TextonReference::at(double tileX, double tileY, std::uint32_t mip,
                                         double mixWeight,
                                         std::array<double, 2> mixGradient) const {
  const NoiseMap& map = bundle_.noises[0].maps[0];
  const Table& image = bundle_.tables[map.as<TextonMap>().image];
  const auto stored = std::size_t(channelCount(image.format));
  const int order = mip == 0 ? int(texton_.order) : 1;
  const double side = std::exp2(double(mip));
  const int width = int(image.width >> mip);
  const int columns = int(std::ceil(texton_.coefficientsX / side));
  const int rows = int(std::ceil(texton_.coefficientsY / side));
  const double pointX = tileX * double(noise_.tileTexelsX);
  const double pointY = tileY * double(noise_.tileTexelsY);
  const double periodX = double(material_.periodTilesX) * double(noise_.tileTexelsX);
  const double periodY = double(material_.periodTilesY) * double(noise_.tileTexelsY);
  Sum sum;
  for (const Impact& impact : impacts_) {
    // Includes all copies within twice the reach of the texton and its mips.
    const double farX = 2.0 * texton_.coefficientsX + 4.0 * side + 8.0;
    const double farY = 2.0 * texton_.coefficientsY + 4.0 * side + 8.0;
    for (double y = impact.y + periodY * std::ceil((pointY - farY - impact.y) / periodY);
         y < pointY + farY; y += periodY)
      for (double x = impact.x + periodX * std::ceil((pointX - farX - impact.x) / periodX);
           x < pointX + farX; x += periodX) {
        const double atX = pointX - x + 0.5 * texton_.coefficientsX;
        const double atY = pointY - y + 0.5 * texton_.coefficientsY;
        const double weight =
            std::clamp(mixWeight + mixGradient[0] * (x - pointX) / double(noise_.tileTexelsX) +
                           mixGradient[1] * (y - pointY) / double(noise_.tileTexelsY),
                       0.0, 1.0);
        const int step = int(std::floor(weight * (double(texton_.steps) - 1.0) + 0.5));
        const int top = step * (texton_.frameY >> mip);
        for (int row = 0; row < rows; ++row) {
          const double y0 = atY / side - row - 0.5;
          if (std::abs(y0) > 2.0)
            continue;
          for (int column = 0; column < columns; ++column) {
            const double x0 = atX / side - column - 0.5;
            if (std::abs(x0) > 2.0)
              continue;
            const float* texel =
                &mips_[mip][(std::size_t(top + row) * std::size_t(width) + std::size_t(column)) *
                            stored];
            const double h = impact.sign * centredSpline(order, x0) * centredSpline(order, y0);
            for (std::size_t c = 0; c < map.channels.size(); ++c)
              sum.value[c] += h * map.as<TextonMap>().scale[c] * double(texel[c]);
            const double first = impact.sign * map.as<TextonMap>().scale[0] * double(texel[0]);
            sum.gradient[0] += first * splineSlope(order, x0) * centredSpline(order, y0);
            sum.gradient[1] += first * centredSpline(order, x0) * splineSlope(order, y0);
          }
        }
      }
  }
  const double cellArea = double(noise_.tileTexelsX) / double(material_.columnsPerTile) *
                          double(noise_.tileTexelsY) / double(material_.rowsPerTile);
  for (double& value : sum.value)
    value *= std::sqrt(cellArea);
  sum.gradient[0] *= std::sqrt(cellArea) * double(noise_.tileTexelsX) / side;
  sum.gradient[1] *= std::sqrt(cellArea) * double(noise_.tileTexelsY) / side;
  return sum;
}

} // namespace lichen::test
