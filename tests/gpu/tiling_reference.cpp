// SPDX-License-Identifier: MIT
// The oracle of the tiling tests; see tiling_reference.h. Steps are numbered as in the format's
// specification (docs/gltf_extension/README.md).
#include "tiling_reference.h"

#include <lichen/lattice.h>
#include <lichen/shader_parameters.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace lichen::test {
namespace {

using Vec2 = std::array<double, 2>;
using Vec4 = std::array<double, 4>;
using Complex = std::complex<double>;

std::int64_t floorDivide(std::int64_t value, std::int64_t by) {
  return value >= 0 ? value / by : -((-value + by - 1) / by);
}

/// Linear along each axis at texel coordinates (texel k's centre is k + 1/2), repeated or clamped
/// to the edge.
Vec4 filtered(const Volume& v, const std::array<double, 3>& at, bool repeats) {
  const std::array<int, 3> size{v.width, v.height, v.depth};
  Vec4 result{};
  for (int corner = 0; corner < 8; ++corner) {
    std::size_t texel = 0;
    double weight = 1.0;
    for (std::size_t axis = 3; axis-- > 0;) {
      const int side = corner >> axis & 1;
      const double low = std::floor(at[axis] - 0.5);
      const int k = int(low) + side, last = size[axis] - 1;
      const std::int64_t wrapped = k - floorDivide(k, size[axis]) * size[axis];
      texel =
          texel * std::size_t(size[axis]) + std::size_t(repeats ? wrapped : std::clamp(k, 0, last));
      weight *= std::abs(1 - side - (at[axis] - 0.5 - low));
    }
    for (std::size_t c = 0; c < v.channels; ++c)
      result[c] += weight * double(v.values[texel * v.channels + c]);
  }
  return result;
}

/// Linear between mip levels; `at(level)` is a texel of one.
template <class At>
Vec4 betweenLevels(double level, std::size_t count, const At& at) {
  level = std::clamp(level, 0.0, double(count - 1));
  const auto low = std::size_t(level);
  const Vec4 a = at(low), b = at(std::min(low + 1, count - 1));
  Vec4 result{};
  for (std::size_t c = 0; c < 4; ++c)
    result[c] = a[c] + (level - double(low)) * (b[c] - a[c]);
  return result;
}

Volume volumeOf(const Table& table, std::uint32_t level) {
  const auto side = [&](std::uint32_t size) { return int(std::max(1u, size >> level)); };
  return {side(table.width), side(table.height), side(table.depth),
          std::size_t(channelCount(table.format)), decodeLevel(table, level)};
}

struct Vertex {
  int i = 0, j = 0;
  double weight = 0.0;
};

/// Steps 1 and 2.
std::array<Vertex, 3> triangleAt(Vec2 p, const shader::LichenMaterial& m, double sharpness) {
  const double a = p[0] * double(m.columnsPerTile) - 0.5 * p[1] * double(m.rowsPerTile);
  const double b = p[1] * double(m.rowsPerTile);
  const double f = a - std::floor(a), g = b - std::floor(b);
  const int i = int(std::uint32_t(int(std::floor(a))) + std::uint32_t(m.cellI));
  const int j = int(std::uint32_t(int(std::floor(b))) + std::uint32_t(m.cellJ));
  const auto next = [](int value) { return int(std::uint32_t(value) + 1u); };
  std::array<Vertex, 3> vertices;
  if (f + g < 1.0)
    vertices = {{{i, j, 1.0 - f - g}, {next(i), j, f}, {i, next(j), g}}};
  else
    vertices = {{{next(i), next(j), f + g - 1.0}, {next(i), j, 1.0 - g}, {i, next(j), 1.0 - f}}};
  double sum = 0.0;
  for (Vertex& v : vertices)
    sum += v.weight = std::pow(v.weight, sharpness);
  for (Vertex& v : vertices)
    v.weight /= sum;
  return vertices;
}

struct Tap {
  Vec2 place;
  Complex turn{1.0};
};

/// Step 3.
Tap tapOf(Vec2 p, Vertex v, const shader::LichenMaterial& m, const shader::LichenNoise& noise) {
  if (m.periodRows > 0) {
    const std::int64_t k = floorDivide(v.j, m.periodRows);
    const std::int64_t i = v.i + k * (m.periodRows / 2);
    const std::int64_t q = floorDivide(i, m.periodColumns);
    v.j = int(v.j - k * m.periodRows);
    v.i = int(i - q * m.periodColumns);
    p[0] -= double(q) * double(m.periodTilesX);
    p[1] -= double(k) * double(m.periodTilesY);
  }
  const auto i = std::uint32_t(v.i), j = std::uint32_t(v.j);
  Tap tap{p};
  if (const std::uint32_t rotation = partOf<shader::LichenTilingMaterial>(m).tileRotation;
      rotation > 1) {
    const double quarters = tileQuarterTurns(i, j, m.seedWord, rotation);
    tap.turn = std::polar(1.0, 0.5 * std::numbers::pi * quarters);
    const Complex there = tap.turn * Complex(p[0], p[1]);
    tap.place = {there.real(), there.imag()};
  }
  const auto steps = tileOffsetSteps(i, j, m.seedWord);
  tap.place[0] += steps[0] * double(noise.offsetStepX);
  tap.place[1] += steps[1] * double(noise.offsetStepY);
  return tap;
}

/// Step 5, "Decoding": the coefficients are part of the format.
double uniformOf(double gaussian) {
  constexpr std::array<double, 5> kCoefficients{2.3890824, -13.9188528, 65.2096975, -182.1468761,
                                                220.6686413};
  const double x = std::clamp(gaussian - 0.5, -0.48083, 0.48083);
  double sum = 0.5;
  for (std::size_t k = 0; k < kCoefficients.size(); ++k)
    sum += kCoefficients[k] * std::pow(x, 2.0 * double(k) + 1.0);
  return sum;
}

/// The mean of decode(x + e) for Gaussian e, by the midpoint rule over eight standard deviations in
/// each direction.
template <class Decode>
double meanOver(const Decode& decode, double x, double deviation) {
  constexpr int kSteps = 400;
  constexpr double kReach = 8.0;
  double sum = 0.0, weights = 0.0;
  for (int k = 0; k < kSteps; ++k) {
    const double e = kReach * (2.0 * (k + 0.5) / kSteps - 1.0);
    const double weight = std::exp(-0.5 * e * e);
    sum += weight * decode(x + deviation * e);
    weights += weight;
  }
  return sum / weights;
}

/// Step 4: log2 of the side of a footprint with these sides in texels.
double sideOf(Vec2 x, Vec2 y) {
  const double major = std::max({1.0, std::hypot(x[0], x[1]), std::hypot(y[0], y[1])});
  const double area = std::abs(x[0] * y[1] - x[1] * y[0]);
  const double slant = std::min(major * major / std::max(area, major), 16.0);
  return std::log2(major) - std::log2(slant) / 4.0;
}

/// log2 of the side of the square with the area that an anisotropic sampler averages over: as long
/// as the longer side, and as wide as the shorter one or the longer one over the most probes.
double sideOfProbes(Vec2 x, Vec2 y, double maxAnisotropy) {
  const double a = std::max(1.0, std::hypot(x[0], x[1]));
  const double b = std::max(1.0, std::hypot(y[0], y[1]));
  const double width = std::max(std::min(a, b), std::max(a, b) / maxAnisotropy);
  return std::log2(std::sqrt(std::max(a, b) * width));
}

/// What a fetch at texel coordinates `t` loses, over the average between texels.
double lossShareOf(Vec2 t, Vec2 x, Vec2 y) {
  double here = 0.0;
  for (const double coordinate : t) {
    const double f =
        coordinate - 0.5 - std::floor(coordinate - 0.5); // of the way to the next centre
    here += 3.0 * f * (1.0 - f);
  }
  const double major = std::min(1.0, std::max(std::hypot(x[0], x[1]), std::hypot(y[0], y[1])));
  const double weight = std::pow(major, 4.0) * (1.0 - std::min(sideOf(x, y), 1.0));
  return 1.0 + weight * (here - 1.0);
}

} // namespace

TilingReference::TilingReference(const Bundle& bundle, std::size_t map, FetchedBy fetchedBy)
    : noise_(shaderNoise(bundle, 0)), shaderMap_(shaderMap(bundle, bundle.noises[0], map)),
      map_(bundle.noises[0].maps[map]), fetchedBy_(fetchedBy) {
  const auto& tiling = map_.as<TilingMap>();
  const Table& gaussian = bundle.tables[tiling.gaussian];
  for (std::uint32_t level = 0; level < gaussian.mipLevels; ++level)
    levels_.push_back(volumeOf(gaussian, level));
  if (!tiling.inverseTable)
    return;
  const Table& table = bundle.tables[*tiling.inverseTable];
  for (std::uint32_t level = 0; level < table.mipLevels; ++level)
    table_.push_back(volumeOf(table, level));
}

TilingReference::Decoded TilingReference::fromTable(const Decoded& gaussian, double lost) const {
  Decoded value =
      betweenLevels(5.0 * (1.0 - std::sqrt(1.0 - lost)), table_.size(), [&](std::size_t level) {
        const Volume& cells = table_[level];
        return filtered(cells,
                        {uniformOf(gaussian[0]) * cells.width,
                         uniformOf(gaussian[1]) * cells.height,
                         uniformOf(gaussian[2]) * cells.depth},
                        false);
      });
  if (map_.encoding == ValueEncoding::root)
    for (double& channel : value)
      channel *= channel;
  return value;
}

TilingReference::Decoded TilingReference::withoutTable(const Decoded& gaussian, double lost) const {
  const std::size_t n = map_.channels.size();
  const auto& covariance = map_.covariance;
  const auto decode = [&](double x) {
    switch (map_.encoding) {
    case ValueEncoding::slope:
    case ValueEncoding::linear:
      return x;
    case ValueEncoding::log2:
      return std::exp2(x) - 1.0;
    default:
      return x * x;
    }
  };
  std::array<std::array<double, 3>, 3> l{}; // l l^T is the covariance
  Decoded value{0.0, 0.0, 0.0, 1.0};
  double variances = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    double x = map_.mean[i];
    for (std::size_t j = 0; j <= i; ++j) {
      double rest = covariance[i * n + j];
      for (std::size_t k = 0; k < j; ++k)
        rest -= l[i][k] * l[j][k];
      l[i][j] = i == j ? std::sqrt(rest) : rest / l[j][j];
      x += 6.0 * l[i][j] * (gaussian[j] - 0.5);
    }
    value[i] = meanOver(decode, x, std::sqrt(lost * covariance[i * n + i]));
    if (map_.encoding == ValueEncoding::linear)
      value[i] = std::clamp(value[i], 0.0, 1.0);
    if (map_.encoding == ValueEncoding::log2)
      value[i] = std::max(value[i], 0.0);
    variances += lost * covariance[i * n + i];
  }
  if (map_.encoding == ValueEncoding::slope)
    value[2] = variances / 2.0;
  return value;
}

TilingReference::Decoded TilingReference::decoded(const Decoded& gaussian, double loss, double here,
                                                  double contrast) const {
  const double lost = here * loss;
  Decoded value = table_.empty()
                      ? withoutTable(gaussian, contrast * contrast * lost)
                      : fromTable(gaussian, std::pow(std::min(contrast, 1.0), 2.0) * lost);
  if (map_.encoding != ValueEncoding::slope)
    return value;
  if (!table_.empty())
    value[2] *= std::max(1.0, 2.0 * contrast - 1.0);
  const double between = double(levels_.front().values[levels_.front().channels - 1]);
  value[2] *= loss > between ? (loss - between) / loss : 0.0;
  return value;
}

TilingReference::Sample TilingReference::evaluate(const Point& point,
                                                  const shader::LichenMaterial& m) const {
  const auto toTile = [&](std::array<float, 2> v) {
    return Vec2{double(m.uvToTileXX) * double(v[0]) + double(m.uvToTileXY) * double(v[1]),
                double(m.uvToTileYX) * double(v[0]) + double(m.uvToTileYY) * double(v[1])};
  };
  const auto texels = [&](Vec2 tiles) {
    return Vec2{tiles[0] * double(noise_.tileTexelsX), tiles[1] * double(noise_.tileTexelsY)};
  };
  Vec2 p = toTile(point.uv);
  p = {p[0] + double(m.offsetX), p[1] + double(m.offsetY)};
  const Vec2 x = texels(toTile(point.gradientX)), y = texels(toTile(point.gradientY));
  const auto offset = double(shaderMap_.levelOffset), contrast = double(m.contrast);
  const double side = sideOf(x, y) + offset;
  const double level = fetchedBy_ == FetchedBy::gradients
                           ? sideOfProbes(x, y, double(m.maxAnisotropy)) + offset
                           : (side < 1.0 ? side / 2.0 : side - 0.5);

  // Steps 4 and 5.
  Sample sample;
  sample.here = offset == 0.0 ? lossShareOf(texels(p), x, y) : 1.0;
  const auto triangle =
      triangleAt(p, m, double(partOf<shader::LichenTilingMaterial>(m).blendSharpness));
  double squares = 0.0;
  for (const Vertex& vertex : triangle)
    squares += vertex.weight * vertex.weight;
  const std::size_t last = levels_.front().channels - 1;
  std::array<Decoded, 3> gaussians; // of each tile
  std::array<Complex, 3> turns;
  sample.gaussian = {0.5, 0.5, 0.5, 0.0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Tap tap = tapOf(p, triangle[k], m, noise_);
    const Vec4 fetched = betweenLevels(level, levels_.size(), [&](std::size_t l) {
      const Volume& image = levels_[l];
      return filtered(image, {tap.place[0] * image.width, tap.place[1] * image.height, 0.5}, true);
    });
    turns[k] = tap.turn;
    gaussians[k] = {0.5, 0.5, 0.5, 0.0};
    for (std::size_t c = 0; c < last; ++c) {
      const double about = contrast * (fetched[c] - 128.0 / 255.0);
      gaussians[k][c] += about;
      sample.gaussian[c] += triangle[k].weight * about / std::sqrt(squares);
    }
    sample.loss = fetched[last]; // the same in all tiles
  }
  sample.gaussian[3] = sample.here * sample.loss;
  if (shaderMap_.encoding != LICHEN_ENCODING_SLOPE ||
      partOf<shader::LichenTilingMaterial>(m).tileRotation <= 1) {
    sample.value = decoded(sample.gaussian, sample.loss, sample.here, contrast);
    return sample;
  }
  // Step 6, with rotated tiles.
  for (std::size_t k = 0; k < 3; ++k) {
    const Decoded slopes = decoded(gaussians[k], sample.loss, sample.here, contrast);
    const double share = triangle[k].weight / std::sqrt(squares);
    const Complex turned = turns[k] * Complex(slopes[0], slopes[1]);
    sample.value[0] += share * turned.real();
    sample.value[1] += share * turned.imag();
    sample.value[2] += share * share * slopes[2];
  }
  return sample;
}

} // namespace lichen::test
