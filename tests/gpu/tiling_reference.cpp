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
#include <utility>

namespace lichen::test {
namespace {

using Vec2 = std::array<double, 2>;
using Vec4 = std::array<double, 4>;

int wrapped(int value, int size) { return ((value % size) + size) % size; }

const float* texel(const Volume& v, int x, int y, int z) {
  return &v.values[((std::size_t(z) * std::size_t(v.height) + std::size_t(y)) *
                        std::size_t(v.width) +
                    std::size_t(x)) *
                   v.channels];
}

/// Bilinear sampling with repeat at normalized (x, y).
Vec4 sampleRepeat(const Volume& v, Vec2 at) {
  const double x = at[0] * v.width - 0.5, y = at[1] * v.height - 0.5;
  const int x0 = int(std::floor(x)), y0 = int(std::floor(y));
  Vec4 result{};
  for (int k = 0; k < 4; ++k) {
    const double weight = std::abs(1 - k % 2 - (x - x0)) * std::abs(1 - k / 2 - (y - y0));
    const float* source = texel(v, wrapped(x0 + k % 2, v.width), wrapped(y0 + k / 2, v.height), 0);
    for (std::size_t c = 0; c < v.channels; ++c)
      result[c] += weight * double(source[c]);
  }
  return result;
}

/// Linear along each axis, clamped to edge, at texel coordinates (texel k's centre is k + 1/2).
Vec4 sampleClamp(const Volume& v, std::array<double, 3> at) {
  const std::array<int, 3> size{v.width, v.height, v.depth};
  std::array<int, 3> base{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    at[axis] = std::clamp(at[axis] - 0.5, 0.0, double(size[axis] - 1));
    base[axis] = std::min(int(at[axis]), std::max(0, size[axis] - 2));
    at[axis] -= base[axis];
  }
  Vec4 result{};
  for (int k = 0; k < 8; ++k) {
    const int dx = k & 1, dy = (k >> 1) & 1, dz = k >> 2;
    const double weight =
        std::abs(1 - dx - at[0]) * std::abs(1 - dy - at[1]) * std::abs(1 - dz - at[2]);
    if (weight == 0.0)
      continue;
    const float* source = texel(v, base[0] + dx, base[1] + dy, base[2] + dz);
    for (std::size_t c = 0; c < v.channels; ++c)
      result[c] += weight * double(source[c]);
  }
  return result;
}

struct Parameters {
  const shader::LichenMaterial& material;
  const shader::LichenTilingMaterial tiling;
  const shader::LichenNoise& noise;
};

struct Vertex {
  int i = 0, j = 0;
  double weight = 0.0;
};

/// Steps 1 and 2.
std::array<Vertex, 3> triangleAt(Vec2 p, const Parameters& u) {
  const double a =
      p[0] * double(u.material.columnsPerTile) - 0.5 * p[1] * double(u.material.rowsPerTile);
  const double b = p[1] * double(u.material.rowsPerTile);
  const double f = a - std::floor(a), g = b - std::floor(b);
  const int i = int(std::uint32_t(int(std::floor(a))) + std::uint32_t(u.material.cellI));
  const int j = int(std::uint32_t(int(std::floor(b))) + std::uint32_t(u.material.cellJ));
  const auto next = [](int value) { return int(std::uint32_t(value) + 1u); };
  std::array<Vertex, 3> vertices;
  if (f + g < 1.0)
    vertices = {{{i, j, 1.0 - f - g}, {next(i), j, f}, {i, next(j), g}}};
  else
    vertices = {{{next(i), next(j), f + g - 1.0}, {next(i), j, 1.0 - g}, {i, next(j), 1.0 - f}}};
  double sum = 0.0;
  for (Vertex& v : vertices)
    sum += v.weight = std::pow(v.weight, double(u.tiling.blendSharpness));
  for (Vertex& v : vertices)
    v.weight /= sum;
  return vertices;
}

struct Tap {
  Vec2 place;
  std::complex<double> turn;
};

bool rotatesTiles(const Parameters& u) { return u.tiling.tileRotation > 1; }

/// Step 3.
Tap tapOf(Vec2 p, Vertex v, const Parameters& u) {
  if (u.material.periodRows > 0) {
    const auto floorDivide = [](std::int64_t value, std::int64_t by) {
      return value >= 0 ? value / by : -((-value + by - 1) / by);
    };
    const std::int64_t k = floorDivide(v.j, u.material.periodRows);
    std::int64_t i = v.i + k * (u.material.periodRows / 2);
    const std::int64_t q = floorDivide(i, u.material.periodColumns);
    v.j = int(v.j - k * u.material.periodRows);
    v.i = int(i - q * u.material.periodColumns);
    p[0] -= double(q) * double(u.material.periodTilesX);
    p[1] -= double(k) * double(u.material.periodTilesY);
  }
  const auto steps = tileOffsetSteps(std::uint32_t(v.i), std::uint32_t(v.j), u.material.seedWord);
  Tap tap{p, 1.0};
  if (rotatesTiles(u)) {
    const std::uint32_t quarters = tileQuarterTurns(std::uint32_t(v.i), std::uint32_t(v.j),
                                                    u.material.seedWord, u.tiling.tileRotation);
    tap.turn = std::polar(1.0, 0.5 * std::numbers::pi * double(quarters));
    const std::complex<double> there = tap.turn * std::complex<double>(p[0], p[1]);
    tap.place = {there.real(), there.imag()};
  }
  tap.place[0] += double(steps[0]) * double(u.noise.offsetStepX);
  tap.place[1] += double(steps[1]) * double(u.noise.offsetStepY);
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
double lossShareOf(Vec2 t, Vec2 x, Vec2 y, double side) {
  double here = 0.0;
  for (const double coordinate : t) {
    const double f =
        coordinate - 0.5 - std::floor(coordinate - 0.5); // of the way to the next centre
    here += 3.0 * f * (1.0 - f);
  }
  const double major = std::min(1.0, std::max(std::hypot(x[0], x[1]), std::hypot(y[0], y[1])));
  const double weight = std::pow(major, 4.0) * (1.0 - std::min(side, 1.0));
  return 1.0 + weight * (here - 1.0);
}

} // namespace

TilingReference::TilingReference(const Bundle& bundle, std::size_t map, FetchedBy fetchedBy,
                                 double tableLevelError)
    : noise_(shaderNoise(bundle, 0)), shaderMap_(shaderMap(bundle, bundle.noises[0], map)),
      map_(bundle.noises[0].maps[map]), tiling_(map_.as<TilingMap>()), fetchedBy_(fetchedBy),
      tableLevelError_(tableLevelError) {
  const Table& gaussian = bundle.tables[tiling_.gaussian];
  for (std::uint32_t level = 0; level < gaussian.mipLevels; ++level)
    levels_.push_back({int(std::max(1u, gaussian.width >> level)),
                       int(std::max(1u, gaussian.height >> level)), 1,
                       std::size_t(channelCount(gaussian.format)), decodeLevel(gaussian, level)});
  if (!tiling_.inverseTable)
    return;
  const Table& table = bundle.tables[*tiling_.inverseTable];
  for (std::uint32_t level = 0; level < table.mipLevels; ++level)
    table_.push_back({int(std::max(1u, table.width >> level)),
                      int(std::max(1u, table.height >> level)),
                      int(std::max(1u, table.depth >> level)),
                      std::size_t(channelCount(table.format)), decodeLevel(table, level)});
}

TilingReference::Decoded TilingReference::fromTable(const Decoded& gaussian, double lost) const {
  const double level =
      std::min(5.0 * (1.0 - std::sqrt(1.0 - lost)) + tableLevelError_, double(table_.size() - 1));
  const auto at = [&](std::size_t k) {
    const Volume& cells = table_[k];
    return sampleClamp(cells,
                       {uniformOf(gaussian[0]) * cells.width, uniformOf(gaussian[1]) * cells.height,
                        uniformOf(gaussian[2]) * cells.depth});
  };
  const auto low = std::size_t(level);
  const Vec4 a = at(low), b = at(std::min(low + 1, table_.size() - 1));
  Decoded value{};
  for (std::size_t c = 0; c < 4; ++c) {
    value[c] = a[c] + (level - double(low)) * (b[c] - a[c]);
    if (map_.encoding == ValueEncoding::root)
      value[c] *= value[c];
  }
  return value;
}

TilingReference::Decoded TilingReference::withoutTable(const Decoded& gaussian, double lost) const {
  const std::size_t n = map_.channels.size();
  // [L_ij] with L L^T the covariance, by the formulas for two and three dimensions.
  const auto& c = map_.covariance;
  std::array<std::array<double, 3>, 3> l{};
  l[0][0] = std::sqrt(c[0]);
  if (n > 1) {
    l[1][0] = c[n] / l[0][0];
    l[1][1] = std::sqrt(c[n + 1] - l[1][0] * l[1][0]);
  }
  if (n > 2) {
    l[2][0] = c[6] / l[0][0];
    l[2][1] = (c[7] - l[2][0] * l[1][0]) / l[1][1];
    l[2][2] = std::sqrt(c[8] - l[2][0] * l[2][0] - l[2][1] * l[2][1]);
  }
  const auto decode = [&](double x) {
    switch (map_.encoding) {
    case ValueEncoding::slope:
      return x;
    case ValueEncoding::log2:
      return std::exp2(x) - 1.0;
    case ValueEncoding::linear:
      return x;
    default:
      return x * x;
    }
  };
  Decoded value{0.0, 0.0, 0.0, 1.0};
  double variances = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    double x = map_.mean[i];
    for (std::size_t j = 0; j <= i; ++j)
      x += 6.0 * l[i][j] * (gaussian[j] - 0.5);
    value[i] = meanOver(decode, x, std::sqrt(lost * c[i * n + i]));
    if (map_.encoding == ValueEncoding::linear)
      value[i] = std::clamp(value[i], 0.0, 1.0);
    if (map_.encoding == ValueEncoding::log2)
      value[i] = std::max(value[i], 0.0);
    variances += lost * c[i * n + i];
  }
  if (map_.encoding == ValueEncoding::slope)
    value[2] = variances / 2.0;
  return value;
}

TilingReference::Decoded TilingReference::decoded(const Decoded& gaussian, double loss, double here,
                                                  double contrast) const {
  const double lost = here * loss;
  Decoded value = tiling_.inverseTable
                      ? fromTable(gaussian, std::pow(std::min(contrast, 1.0), 2.0) * lost)
                      : withoutTable(gaussian, contrast * contrast * lost);
  if (map_.encoding != ValueEncoding::slope)
    return value;
  if (tiling_.inverseTable)
    value[2] *= std::max(1.0, 2.0 * contrast - 1.0);
  const double between = double(levels_.front().values[levels_.front().channels - 1]);
  value[2] *= loss > between ? (loss - between) / loss : 0.0;
  return value;
}

TilingReference::Sample TilingReference::evaluate(const Point& point,
                                                  const shader::LichenMaterial& material) const {
  const Parameters u{material, tilingPart(material), noise_};
  const auto toTile = [&](std::array<float, 2> v) {
    return Vec2{double(u.material.uvToTileXX) * double(v[0]) +
                    double(u.material.uvToTileXY) * double(v[1]),
                double(u.material.uvToTileYX) * double(v[0]) +
                    double(u.material.uvToTileYY) * double(v[1])};
  };
  Vec2 p = toTile(point.uv);
  p = {p[0] + double(u.material.offsetX), p[1] + double(u.material.offsetY)};
  const auto texels = [&](Vec2 tiles) {
    return Vec2{tiles[0] * double(u.noise.tileTexelsX), tiles[1] * double(u.noise.tileTexelsY)};
  };
  const Vec2 texelsX = texels(toTile(point.gradientX)), texelsY = texels(toTile(point.gradientY));
  const double widest = fetchedBy_ == FetchedBy::gradients
                            ? sideOfProbes(texelsX, texelsY, double(u.material.maxAnisotropy))
                            : sideOf(texelsX, texelsY);
  const double side = widest + double(shaderMap_.levelOffset);
  const double lambda =
      fetchedBy_ == FetchedBy::gradients ? side : (side < 1.0 ? side / 2.0 : side - 0.5);
  const double here = shaderMap_.levelOffset == 0.0f
                          ? lossShareOf(texels(p), texelsX, texelsY, sideOf(texelsX, texelsY))
                          : 1.0;

  // Steps 4 and 5.
  const double lod = std::clamp(lambda, 0.0, double(levels_.size() - 1));
  const auto lower = std::size_t(lod);
  const std::size_t upper = std::min(lower + 1, levels_.size() - 1);
  Sample sample;
  double squares = 0.0;
  std::vector<std::pair<Decoded, Tap>> taps;
  std::vector<double> weights;
  for (const Vertex& vertex : triangleAt(p, u)) {
    const Tap tap = tapOf(p, vertex, u);
    const Vec4 low = sampleRepeat(levels_[lower], tap.place);
    const Vec4 high = sampleRepeat(levels_[upper], tap.place);
    const double t = lod - double(lower);
    const std::size_t last = levels_.front().channels - 1;
    Decoded fetched{};
    for (std::size_t c = 0; c < 3; ++c) {
      fetched[c] = c < last ? low[c] + t * (high[c] - low[c]) + 0.5 - 128.0 / 255.0 : 0.5;
      sample.gaussian[c] += vertex.weight * (fetched[c] - 0.5);
    }
    fetched[3] = low[last] + t * (high[last] - low[last]);
    sample.gaussian[3] = here * fetched[3];
    taps.emplace_back(fetched, tap);
    weights.push_back(vertex.weight);
    squares += vertex.weight * vertex.weight;
  }
  for (std::size_t c = 0; c < 3; ++c)
    sample.gaussian[c] =
        0.5 + double(u.material.contrast) * sample.gaussian[c] / std::sqrt(squares);
  const double loss = taps.front().first[3];
  sample.loss = loss;
  sample.here = here;

  if (shaderMap_.encoding == LICHEN_ENCODING_SLOPE && rotatesTiles(u))
    // Step 6, with rotated tiles.
    for (std::size_t k = 0; k < taps.size(); ++k) {
      Decoded& gaussian = taps[k].first;
      for (std::size_t c = 0; c < 3; ++c)
        gaussian[c] = 0.5 + double(u.material.contrast) * (gaussian[c] - 0.5);
      const Decoded slopes = decoded(gaussian, loss, here, double(u.material.contrast));
      const double share = weights[k] / std::sqrt(squares);
      const std::complex<double> turned =
          taps[k].second.turn * std::complex<double>(slopes[0], slopes[1]);
      sample.value[0] += share * turned.real();
      sample.value[1] += share * turned.imag();
      sample.value[2] += share * share * slopes[2];
    }
  else
    sample.value = decoded(sample.gaussian, loss, here, double(u.material.contrast));
  return sample;
}

} // namespace lichen::test
