// SPDX-License-Identifier: MIT
// Synthetic texton noises for the tests; see synthetic_texton.h.
#include "synthetic_texton.h"

#include "glb_of.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace lichen::test {
namespace {

/// The B-spline of degree 2 order + 1 at the integers: [UAE93].
double autocorrelation(int order, int lag) {
  lag = std::abs(lag);
  const std::array<std::array<double, 4>, 4> values{
      {{1.0},
       {2.0 / 3.0, 1.0 / 6.0},
       {},
       {2416.0 / 5040.0, 1191.0 / 5040.0, 120.0 / 5040.0, 1.0 / 5040.0}}};
  return lag > 3 ? 0.0 : values[std::size_t(order)][std::size_t(lag)];
}

struct Plane {
  int width = 0, height = 0;
  std::size_t channels = 0;
  std::vector<double> values;

  [[nodiscard]] double at(int x, int y, std::size_t c) const {
    if (x < 0 || y < 0 || x >= width || y >= height)
      return 0.0;
    return values[(std::size_t(y) * std::size_t(width) + std::size_t(x)) * channels + c];
  }
};

/// Averages of 2 x 2 texels of a plane surrounded by zeros.
Plane halved(const Plane& fine) {
  Plane coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, fine.channels, {}};
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x)
      for (std::size_t c = 0; c < coarse.channels; ++c)
        coarse.values.push_back((fine.at(2 * x, 2 * y, c) + fine.at(2 * x + 1, 2 * y, c) +
                                 fine.at(2 * x, 2 * y + 1, c) + fine.at(2 * x + 1, 2 * y + 1, c)) /
                                4.0);
  return coarse;
}

/// sum b(k - l + lag) a(k) a(l)^T.
std::vector<double> quadraticForm(const Plane& a, int order, int lagX, int lagY) {
  std::vector<double> sum(a.channels * a.channels, 0.0);
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x)
      for (int dy = -order; dy <= order; ++dy)
        for (int dx = -order; dx <= order; ++dx) {
          const double b = autocorrelation(order, dx) * autocorrelation(order, dy);
          for (std::size_t c = 0; c < a.channels; ++c)
            for (std::size_t d = 0; d < a.channels; ++d)
              sum[c * a.channels + d] += b * a.at(x, y, c) * a.at(x + dx + lagX, y + dy + lagY, d);
        }
  return sum;
}

/// Weights of 1, 2, 1 along each axis.
Plane smoothed(const Plane& rough) {
  Plane smooth = rough;
  for (int y = 0; y < rough.height; ++y)
    for (int x = 0; x < rough.width; ++x)
      for (std::size_t c = 0; c < rough.channels; ++c) {
        double sum = 0.0;
        for (int k = 0; k < 9; ++k)
          sum += (2 - std::abs(k % 3 - 1)) * (2 - std::abs(k / 3 - 1)) *
                 rough.at(x + k % 3 - 1, y + k / 3 - 1, c) / 16.0;
        smooth
            .values[(std::size_t(y) * std::size_t(rough.width) + std::size_t(x)) * rough.channels +
                    c] = sum;
      }
  return smooth;
}

double trace(const std::vector<double>& matrix, std::size_t n) {
  double sum = 0.0;
  for (std::size_t i = 0; i < n; ++i)
    sum += matrix[i * n + i];
  return sum;
}

/// The share of each channel's variance that a bilinear fetch of each mip loses. The first mip uses
/// the order's own fetch.
std::vector<double> mipLosses(Plane mip, int order, std::size_t levels) {
  const std::size_t n = mip.channels;
  std::vector<double> losses(n * levels, 0.0);
  const std::vector<double> whole = quadraticForm(mip, order, 0, 0);
  double texelArea = 1.0;
  for (std::size_t level = 1; level < levels; ++level) {
    mip = halved(mip);
    texelArea *= 4.0;
    const std::vector<double> left = quadraticForm(mip, 1, 0, 0);
    for (std::size_t c = 0; c < n; ++c) {
      double* loss = &losses[c * levels + level];
      *loss = std::clamp(1.0 - texelArea * left[c * (n + 1)] / whole[c * (n + 1)], loss[-1], 1.0);
    }
  }
  return losses;
}

Plane planeOf(const SyntheticTexton& texton, int step) {
  return {texton.coefficientsX, texton.coefficientsY, std::size_t(texton.channels),
          syntheticCoefficients(texton, step)};
}

TexelFormat formatOf(const SyntheticTexton& texton) {
  using enum TexelFormat;
  constexpr TexelFormat kHalf[] = {r16Sfloat, rg16Sfloat, rgba16Sfloat};
  constexpr TexelFormat kWhole[] = {r32Sfloat, rgba32Sfloat, rgba32Sfloat};
  return (texton.wholeFloats ? kWhole : kHalf)[texton.channels - 1];
}

TextonShape shapeOf(const SyntheticTexton& texton) {
  TextonShape shape;
  shape.coefficientsX = texton.coefficientsX;
  shape.coefficientsY = texton.coefficientsY;
  shape.order = texton.order;
  shape.mipLevels = texton.mipLevels;
  shape.texelsPerTileX = texton.texelsPerTileX;
  shape.texelsPerTileY = texton.texelsPerTileY;
  shape.steps = texton.steps;
  return shape;
}

/// The frames of all steps, stacked vertically, and their mips.
Table imageOf(const SyntheticTexton& texton, const TextonShape& shape,
              const std::vector<double>& scale) {
  Table table;
  table.name = "synthetic.texton";
  table.format = formatOf(texton);
  table.width = shape.frameWidth();
  table.height = shape.frameHeight() * std::uint32_t(shape.steps);
  table.mipLevels = std::uint32_t(shape.mipLevels);
  const auto stored = std::size_t(channelCount(table.format));
  std::vector<Plane> steps;
  for (int step = 0; step < texton.steps; ++step)
    steps.push_back(planeOf(texton, step));
  for (std::uint32_t level = 0; level < table.mipLevels; ++level) {
    std::vector<float> texels;
    for (Plane& plane : steps) {
      for (int y = 0; y < int(shape.frameHeight() >> level); ++y)
        for (int x = 0; x < int(shape.frameWidth() >> level); ++x)
          for (std::size_t c = 0; c < stored; ++c)
            texels.push_back(c < scale.size() ? float(plane.at(x, y, c) / scale[c]) : 0.0f);
      plane = halved(plane);
    }
    appendTexels(table.texels, table.format, texels);
  }
  return table;
}

} // namespace

std::vector<double> syntheticCoefficients(const SyntheticTexton& texton, int step) {
  std::mt19937 generator(std::uint32_t(step) + 17u);
  std::normal_distribution<double> gaussian;
  const auto bell = [](int k, int count) {
    const double x = (k + 0.5) / count - 0.5;
    return std::exp(-8.0 * x * x); // e^-2 at the border: errors there remain visible
  };
  Plane plane{texton.coefficientsX, texton.coefficientsY, std::size_t(texton.channels), {}};
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x) {
      const double shared = gaussian(generator);
      for (std::size_t c = 0; c < plane.channels; ++c)
        plane.values.push_back((shared + 0.5 * gaussian(generator)) * bell(x, plane.width) *
                               bell(y, plane.height));
    }
  for (int pass = 0; pass < texton.smoothings; ++pass)
    plane = smoothed(plane);
  const double variance =
      trace(quadraticForm(plane, texton.order, 0, 0), plane.channels) / texton.channels;
  for (double& value : plane.values)
    value *= texton.deviation * (1.0 + 0.5 * step) / std::sqrt(variance);
  return plane.values;
}

std::vector<double> covarianceAt(const SyntheticTexton& texton,
                                 std::span<const double> coefficients, int lagX, int lagY) {
  const Plane plane{texton.coefficientsX,
                    texton.coefficientsY,
                    std::size_t(texton.channels),
                    {coefficients.begin(), coefficients.end()}};
  return quadraticForm(plane, texton.order, lagX, lagY);
}

BundleFile syntheticTextonBundle(const SyntheticTexton& texton) {
  using enum MapChannel;
  const auto n = std::size_t(texton.channels);
  NoiseMap map;
  map.target = n == 3 ? MapTarget::baseColor : n == 2 ? MapTarget::normal : MapTarget::height;
  map.encoding = n == 3   ? ValueEncoding::root
                 : n == 2 ? ValueEncoding::slope
                          : ValueEncoding::linear;
  map.channels = n == 3   ? std::vector{red, green, blue}
                 : n == 2 ? std::vector{slopeX, slopeY}
                          : std::vector{height};
  map.mean.assign(n, n == 2 ? 0.1 : 0.5);
  auto& data = map.data.emplace<TextonMap>();
  data.scale.assign(n, 0.0);
  for (int k = 0; k < texton.steps; ++k) {
    const Plane step = planeOf(texton, k);
    TextonStep statistics{std::vector<double>(n, map.mean[0] - 0.1 * std::min(k, 4)),
                          quadraticForm(step, texton.order, 0, 0),
                          mipLosses(step, texton.order, texton.lossLevels)};
    for (std::size_t c = 0; c < n; ++c)
      data.scale[c] = std::max(data.scale[c], 6.0 * std::sqrt(statistics.covariance[c * n + c]));
    if (k > 0) {
      data.laterSteps.push_back(std::move(statistics));
    } else {
      map.covariance = std::move(statistics.covariance);
      data.mipLoss = std::move(statistics.mipLoss);
    }
  }

  BundleFile file;
  Noise noise;
  noise.name = "synthetic texton";
  noise.data = shapeOf(texton);
  file.bundle.tables.push_back(imageOf(texton, noise.as<TextonShape>(), data.scale));
  noise.maps.push_back(std::move(map));
  file.bundle.noises.push_back(std::move(noise));
  file.bundle.materials.emplace_back(MaterialNoise{});
  file.previews.emplace_back();
  file.shape = PreviewShape::none;
  file.generator = "lichen tests";
  return file;
}

std::vector<std::byte> syntheticTextonGlb(const SyntheticTexton& texton) {
  return glbOf(syntheticTextonBundle(texton));
}

} // namespace lichen::test
