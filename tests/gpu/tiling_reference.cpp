// SPDX-License-Identifier: MIT
// The oracle of the tiling tests; see tiling_reference.h. Steps are numbered as in the format's
// specification (docs/gltf_extension/README.md).
#include "tiling_reference.h"

#include <lichen/lattice.h>

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
    for (std::size_t c = 0; c < std::min<std::size_t>(3, v.channels); ++c)
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

struct Vertex {
  int i = 0, j = 0;
  double weight = 0.0;
  Vec2 place{}; // its position, in tiles from the tile origin
};

/// Steps 1 and 2.
std::array<Vertex, 3> triangleAt(Vec2 p, const shader::LichenNoise& n) {
  const double a =
      p[0] * double(n.columnsPerTile) - 0.5 * p[1] * double(n.rowsPerTile) + double(n.fractionI);
  const double b = p[1] * double(n.rowsPerTile) + double(n.fractionJ);
  const double f = a - std::floor(a), g = b - std::floor(b);
  const int i = int(std::uint32_t(int(std::floor(a))) + std::uint32_t(n.cellI));
  const int j = int(std::uint32_t(int(std::floor(b))) + std::uint32_t(n.cellJ));
  const auto next = [](int value) { return int(std::uint32_t(value) + 1u); };
  std::array<Vertex, 3> vertices;
  if (f + g < 1.0)
    vertices = {{{i, j, 1.0 - f - g}, {next(i), j, f}, {i, next(j), g}}};
  else
    vertices = {{{next(i), next(j), f + g - 1.0}, {next(i), j, 1.0 - g}, {i, next(j), 1.0 - f}}};
  for (Vertex& v : vertices) {
    const double column = std::floor(a) + double(v.i != i) - double(n.fractionI);
    const double row = std::floor(b) + double(v.j != j) - double(n.fractionJ);
    v.place = {(column + 0.5 * row) / double(n.columnsPerTile), row / double(n.rowsPerTile)};
  }
  double sum = 0.0;
  for (Vertex& v : vertices)
    sum += v.weight = std::pow(v.weight, double(n.blendSharpness));
  for (Vertex& v : vertices)
    v.weight /= sum;
  return vertices;
}

struct Tap {
  Vec2 place;
  std::complex<double> turn;
};

bool turnsTiles(const shader::LichenNoise& n) { return n.tileRotation > 1; }
bool turnsAboutVertices(const shader::LichenNoise& n) {
  return turnsTiles(n) && n.tileRotation != 2 && !(n.tileRotation == 4 && n.tileAspect == 1.0f);
}

/// Step 3.
Tap tapOf(Vec2 p, Vertex v, const shader::LichenNoise& n) {
  const Vec2 fromVertex{p[0] - v.place[0], p[1] - v.place[1]};
  if (n.periodRows > 0) {
    const auto floorDivide = [](std::int64_t value, std::int64_t by) {
      return value >= 0 ? value / by : -((-value + by - 1) / by);
    };
    const std::int64_t k = floorDivide(v.j, n.periodRows);
    std::int64_t i = v.i + k * (n.periodRows / 2);
    const std::int64_t q = floorDivide(i, n.periodColumns);
    v.j = int(v.j - k * n.periodRows);
    v.i = int(i - q * n.periodColumns);
    p[0] -= double(q) * double(n.periodTilesX);
    p[1] -= double(k) * double(n.periodTilesY);
  }
  const auto index = tileOffsetIndex(std::uint32_t(v.i), std::uint32_t(v.j), n.seedWord,
                                     n.offsetCountX, n.offsetCountY);
  Tap tap{p, 1.0};
  if (turnsTiles(n)) {
    const std::uint32_t step =
        tileRotationStep(std::uint32_t(v.i), std::uint32_t(v.j), n.seedWord, n.tileRotation);
    tap.turn = std::polar(1.0, 2.0 * std::numbers::pi * double(step) / double(n.tileRotation));
    const Vec2 way = turnsAboutVertices(n) ? fromVertex : p;
    const auto aspect = double(n.tileAspect);
    const std::complex<double> there = tap.turn * std::complex<double>(way[0] * aspect, way[1]);
    tap.place = {there.real() / aspect, there.imag()};
  }
  tap.place[0] += double(index[0]) * double(n.offsetStepX);
  tap.place[1] += double(index[1]) * double(n.offsetStepY);
  return tap;
}

double uniformOf(double gaussian) {
  return 0.5 + 0.5 * std::erf(3.0 * std::sqrt(2.0) * (gaussian - 0.5));
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

/// Step 4: the level of detail of a footprint with these sides in texels.
double levelOf(Vec2 x, Vec2 y, FetchedBy fetchedBy) {
  const double major = std::max(std::hypot(x[0], x[1]), std::hypot(y[0], y[1]));
  if (major <= 1.0 || fetchedBy == FetchedBy::gradients)
    return std::log2(major);
  const double area = std::abs(x[0] * y[1] - x[1] * y[0]);
  const double slant = std::min(major * major / std::max(area, major), 16.0);
  const double side = std::log2(major) - std::log2(slant) / 4.0;
  return side < 1.0 ? side / 2.0 : side - 0.5;
}

/// Step 5: s, and the share of it that the mips lose at the centres of their texels.
std::array<double, 2> lostVariance(Vec2 p, double lambda, const shader::LichenNoise& n,
                                   const shader::LichenMap& m) {
  const shader::uint words[] = {m.mipKept0.x, m.mipKept0.y, m.mipKept0.z, m.mipKept0.w};
  const auto amplitude = [&](int mip) {
    mip = std::min(mip, 15);
    return double(words[mip / 4] >> (8 * (mip % 4)) & 255u) / 255.0;
  };
  const double magnified = std::clamp(-lambda, 0.0, 1.0);
  const auto kept = [&](int mip) {
    const double a = amplitude(mip);
    if (a == 0.0)
      return 0.0;
    const double c = 4.0 * (1.0 - amplitude(mip + 1) / a);
    const auto share = [&](double position, float size) {
      const double x = position * double(size) / std::exp2(mip) - 0.5, f = x - std::floor(x);
      const bool isShared = mip < int(m.alignedMips) && !turnsAboutVertices(n);
      const double here = isShared ? f * (1.0 - f) : 1.0 / 6.0;
      return 1.0 - c * (here * (1.0 - magnified) + magnified / 6.0);
    };
    return a * a * share(p[0], m.widthTexels) * share(p[1], m.heightTexels);
  };
  lambda = std::clamp(lambda, 0.0, double(m.mipCount - 1));
  const int mu = int(std::floor(lambda));
  const double t = lambda - mu, below = kept(mu), above = kept(mu + 1);
  const double atTexels =
      std::pow(amplitude(mu + 1), 2) +
      (1.0 - t) * (1.0 - t) * (std::pow(amplitude(mu), 2) - std::pow(amplitude(mu + 1), 2));
  return {1.0 - (above + (1.0 - t) * (1.0 - t) * (below - above)), 1.0 - atTexels};
}

} // namespace

TilingReference::TilingReference(const Bundle& bundle, const NoiseMap& map, FetchedBy fetchedBy)
    : map_(map), tiling_(map.as<TilingMap>()), slabs_(tiling_.levels.size()),
      fetchedBy_(fetchedBy) {
  const Table& gaussian = bundle.tables[tiling_.gaussian];
  for (std::uint32_t level = 0; level < gaussian.mipLevels; ++level)
    levels_.push_back({int(std::max(1u, gaussian.width >> level)),
                       int(std::max(1u, gaussian.height >> level)), 1,
                       std::size_t(channelCount(gaussian.format)), decodeLevel(gaussian, level)});
  if (!tiling_.inverseTable)
    return;
  const Table& table = bundle.tables[*tiling_.inverseTable];
  table_ = {int(table.width), int(table.height), int(std::max(1u, table.depth)),
            std::size_t(channelCount(table.format)), decodeLevel(table, 0)};
}

TilingReference::Decoded TilingReference::fromTable(const Decoded& gaussian, double level,
                                                    unsigned dimensions) const {
  std::array<double, 3> u{};
  for (std::size_t c = 0; c < 3; ++c)
    u[c] = uniformOf(gaussian[c]);
  const int cellsX = table_.width;
  const int cellsY = dimensions == 3 ? table_.height : table_.height / int(slabs_);
  const int cellsZ = table_.depth / (dimensions == 3 ? int(slabs_) : 1);
  const auto slab = [&](int k) {
    const auto inside = [](double value, int cells) {
      return std::clamp(value * cells, 0.5, cells - 0.5);
    };
    std::array<double, 3> at{inside(u[0], cellsX), inside(u[1], cellsY), inside(u[2], cellsZ)};
    if (dimensions == 1)
      at[1] = 0.5;
    at[dimensions == 3 ? 2 : 1] += double(k * (dimensions == 3 ? cellsZ : cellsY));
    return sampleClamp(table_, at);
  };
  const int low = int(level), high = std::min(low + 1, int(slabs_) - 1);
  const Vec4 a = slab(low), b = slab(high);
  Decoded value{};
  for (std::size_t c = 0; c < 4; ++c)
    value[c] = a[c] + (level - low) * (b[c] - a[c]);
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
      return std::exp2(std::clamp(x, 0.0, 16.0)) - 1.0;
    case ValueEncoding::linear:
      return std::clamp(x, 0.0, 1.0);
    default:
      x = std::clamp(x, 0.0, 1.0);
      return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    }
  };
  Decoded value{0.0, 0.0, 0.0, 1.0};
  double variances = 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    double x = map_.mean[i];
    for (std::size_t j = 0; j <= i; ++j)
      x += 6.0 * l[i][j] * (gaussian[j] - 0.5);
    value[i] = meanOver(decode, x, std::sqrt(lost * c[i * n + i]));
    variances += lost * c[i * n + i];
  }
  if (map_.encoding == ValueEncoding::slope)
    value[2] = variances / 2.0;
  return value;
}

TilingReference::Sample TilingReference::evaluate(const Point& point, const shader::LichenNoise& n,
                                                  const shader::LichenMap& m) const {
  const auto toTile = [&](std::array<float, 2> v) {
    return Vec2{double(n.uvToTileXX) * double(v[0]) + double(n.uvToTileXY) * double(v[1]),
                double(n.uvToTileYX) * double(v[0]) + double(n.uvToTileYY) * double(v[1])};
  };
  Vec2 p = toTile(point.uv);
  p = {p[0] + double(n.offsetX), p[1] + double(n.offsetY)};
  const auto texels = [&](std::array<float, 2> v) {
    const Vec2 tiles = toTile(v);
    return Vec2{tiles[0] * double(m.widthTexels), tiles[1] * double(m.heightTexels)};
  };
  const double lambda = levelOf(texels(point.gradientX), texels(point.gradientY), fetchedBy_);

  // Step 4.
  const double lod = std::clamp(lambda, 0.0, double(levels_.size() - 1));
  const auto lower = std::size_t(lod);
  const std::size_t upper = std::min(lower + 1, levels_.size() - 1);
  Sample sample;
  double squares = 0.0;
  std::vector<std::pair<Decoded, Tap>> taps;
  std::vector<double> weights;
  for (const Vertex& vertex : triangleAt(p, n)) {
    const Tap tap = tapOf(p, vertex, n);
    const Vec4 low = sampleRepeat(levels_[lower], tap.place);
    const Vec4 high = sampleRepeat(levels_[upper], tap.place);
    const double t = lod - double(lower);
    Decoded fetched{};
    for (std::size_t c = 0; c < 3; ++c) {
      fetched[c] = low[c] + t * (high[c] - low[c]);
      sample.gaussian[c] += vertex.weight * (fetched[c] - 0.5);
    }
    taps.emplace_back(fetched, tap);
    weights.push_back(vertex.weight);
    squares += vertex.weight * vertex.weight;
  }
  for (std::size_t c = 0; c < 3; ++c)
    sample.gaussian[c] = 0.5 + double(n.contrast) * sample.gaussian[c] / std::sqrt(squares);
  const auto [lost, lostAtTexels] = lostVariance(p, lambda, n, m);
  sample.gaussian[3] = lost;

  // Step 6.
  const double missing = double(n.contrast) * double(n.contrast) * lost;
  const double last = double(slabs_) - 1.0;
  const double kept = std::max(1.0 - missing, std::min(1.0 - lost, 1.0 / (last * last)));
  const double level = last * (1.0 - std::sqrt(kept));
  const auto decode = [&](Decoded gaussian) {
    if (!tiling_.inverseTable)
      return withoutTable(gaussian, missing);
    for (double& value : gaussian)
      value = 0.5 + (value - 0.5) / std::sqrt(std::max(1.0, missing));
    return fromTable(gaussian, level, m.dimensions);
  };
  if (m.encoding == LICHEN_ENCODING_SLOPE && turnsTiles(n))
    // Step 8, with rotated tiles.
    for (std::size_t k = 0; k < taps.size(); ++k) {
      Decoded& gaussian = taps[k].first;
      for (std::size_t c = 0; c < 3; ++c)
        gaussian[c] = 0.5 + double(n.contrast) * (gaussian[c] - 0.5);
      const Decoded slopes = decode(gaussian);
      const double share = weights[k] / std::sqrt(squares);
      const std::complex<double> turned =
          taps[k].second.turn * std::complex<double>(slopes[0], slopes[1]);
      sample.value[0] += share * turned.real();
      sample.value[1] += share * turned.imag();
      sample.value[2] += share * share * slopes[2];
    }
  else
    sample.value = decode(sample.gaussian);
  if (m.encoding == LICHEN_ENCODING_SLOPE && lost > 0.0)
    sample.value[2] *= lostAtTexels / lost;
  return sample;
}

} // namespace lichen::test
