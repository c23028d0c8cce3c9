// SPDX-License-Identifier: MIT
// What a bake promises: the Gaussian image, the inverse table and its slabs.
#include "example_exemplar.h"

#include <lichen/image.h>
#include <lichen/tiling.h>

#include <catch2/catch.hpp>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <tiling/borders.h>
#include <tiling/gaussianize.h>
#include <tiling/inverse_table.h>
#include <tiling/mip_chain.h>
#include <tiling/prefilter.h>
#include <tiling/slab_means.h>
#include <tiling/table_lookup.h>
#include <transport/random.h>

using namespace lichen;
using namespace lichen::tiling;

namespace {

std::vector<std::array<float, 3>> sorted(const std::vector<Point>& points) {
  std::vector<std::array<float, 3>> result;
  for (const Point& p : points)
    result.push_back({p.x, p.y, p.z});
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<float> light(const MapExemplar& map) {
  std::vector<float> values(map.values.size());
  std::transform(map.values.begin(), map.values.end(), values.begin(), srgbToLinear);
  return values;
}

/// A normal deviate from counted uniform numbers [BM58].
double deviate(std::uint64_t seed, std::uint64_t counter) {
  const double u = transport::randomUniform(seed, 2 * counter);
  const double v = transport::randomUniform(seed, 2 * counter + 1);
  return std::sqrt(-2.0 * std::log(1.0 - u)) * std::cos(6.283185307179586 * v);
}

/// An independent, slow lookup: interpolates between cell middles by their hat functions.
double slowLookup(const InverseTable& table, const std::array<double, 3>& gaussian, int channel) {
  double sum = 0.0;
  for (std::size_t cell = 0; cell < table.cellCount(); ++cell) {
    double weight = 1.0;
    std::size_t rest = cell;
    for (int axis = 0; axis < table.dimensions; ++axis) {
      const auto place = double(rest % std::size_t(table.side));
      rest /= std::size_t(table.side);
      const double u = std::clamp(table.side * gaussianCdf(gaussian[std::size_t(axis)]) - 0.5, 0.0,
                                  table.side - 1.0);
      weight *= std::max(0.0, 1.0 - std::abs(u - place));
    }
    if (weight > 0.0)
      sum +=
          weight * double(table.values[cell * std::size_t(table.channels) + std::size_t(channel)]);
  }
  return sum;
}

struct Baked {
  MapExemplar map;
  std::vector<Point> points;
  Gaussianized gaussian;
};

Baked baked(MapExemplar map, bool periodic = true, Precision precision = Precision::bits16) {
  const ColorSpace space = colorSpaceOf(map);
  std::vector<Point> points = transportPoints(map, space);
  Gaussianized gaussian = gaussianize(map, points, space.dimensions(), periodic, precision,
                                      transport::TransportOptions{});
  return {std::move(map), std::move(points), std::move(gaussian)};
}

} // namespace

TEST_CASE("the quantile inverts the distribution function") {
  for (const double u : {1e-9, 1e-4, 0.01, 0.2, 0.5, 0.77, 0.999, 1.0 - 1e-7})
    CHECK(gaussianCdf(gaussianQuantile(u)) == Approx(u).epsilon(1e-5));
}

TEST_CASE("stratified Gaussian sets have mean 1/2 and covariance I / 36 exactly") {
  for (const int dimensions : {1, 2, 3})
    for (const std::size_t count : {std::size_t(64), std::size_t(1000), std::size_t(4096)}) {
      std::vector<float> values;
      for (const Point& p : stratifiedGaussian(count, dimensions, Precision::bits16))
        values.insert(values.end(), &p.x, &p.x + dimensions);
      const Moments moments = momentsOf(values, dimensions);
      // Float rounding of the stored coordinates.
      CHECK((moments.mean.array() - 0.5).abs().maxCoeff() < 1e-7);
      const ChannelMatrix unit = ChannelMatrix::Identity(dimensions, dimensions) / 36.0;
      CHECK((moments.covariance - unit).cwiseAbs().maxCoeff() < 1e-8);
    }
}

TEST_CASE("each coordinate of a stratified set has one value in the middle of each stratum") {
  // Powers of the coordinates' bases fill their digits. Whitening moves what is left of the
  // strata's middles: a correlation of about 0.01 times a value of at most 4 deviations, 0.007.
  for (const auto& [count, axis] : {std::pair{std::size_t(4096), 0}, {4096, 1}, {6561, 2}}) {
    std::vector<float> values;
    for (const Point& p : stratifiedGaussian(count, 3, Precision::bits16))
      values.push_back(axis == 0 ? p.x : axis == 1 ? p.y : p.z);
    std::sort(values.begin(), values.end());
    for (std::size_t k = 0; k < count; ++k)
      REQUIRE(double(values[k]) ==
              Approx(gaussianQuantile((double(k) + 0.5) / double(count))).margin(0.007));
  }
}

TEST_CASE("an 8-bit Gaussian set keeps its variance although it is clamped at three deviations") {
  std::vector<float> values;
  for (const Point& p : stratifiedGaussian(65536, 3, Precision::bits8)) {
    values.insert(values.end(), {p.x, p.y, p.z});
    REQUIRE(std::min({p.x, p.y, p.z}) >= 0.0f);
    REQUIRE(std::max({p.x, p.y, p.z}) <= 1.0f);
  }
  const Moments moments = momentsOf(values, 3);
  // Rounding to 1/255 adds (1/255)^2 / 12 to the variance, 4.6e-5 of it; clamping would
  // lose 5.6e-3.
  const ChannelMatrix unit = ChannelMatrix::Identity(3, 3) / 36.0;
  CHECK((moments.covariance - unit).cwiseAbs().maxCoeff() * 36.0 < 3e-4);
}

TEST_CASE("the Gaussianized image is a permutation of the stratified set") {
  for (const Precision precision : {Precision::bits8, Precision::bits16})
    for (const bool periodic : {true, false}) {
      const Baked b = baked(test::threeMaterials(48, 40, 7), periodic, precision);
      const auto stratified = sorted(stratifiedGaussian(48 * 40, 3, precision));
      CHECK(sorted(b.gaussian.image) == stratified);
      CHECK(sorted(b.gaussian.matched) == stratified);
    }
}

TEST_CASE("lookups in the table have the exemplar's mean and covariance") {
  const Baked b = baked(test::threeMaterials(160, 160, 3));
  const std::vector<float> values = light(b.map);
  const InverseTable table =
      fitInverseTable(b.gaussian, b.points, values, 3, transport::TransportOptions{});
  const Moments found = interpolatedMoments(table);
  const Moments wanted = momentsOf(values, 3);
  // Clamping to the exemplar's range leaves at most a thousandth.
  CHECK((found.mean - wanted.mean).cwiseAbs().maxCoeff() < 1e-4);
  CHECK((found.covariance - wanted.covariance).norm() < 1e-3 * wanted.covariance.norm());

  // The closed form of the moments, against lookups at stratified points.
  std::vector<float> looked;
  for (const Point& p : stratifiedGaussian(2000, 3, Precision::bits16))
    for (int c = 0; c < 3; ++c)
      looked.push_back(float(slowLookup(table, {p.x, p.y, p.z}, c)));
  const Moments sampled = momentsOf(looked, 3);
  // Standard error of a mean of 2000 is 2.2 % of a deviation; stratification makes it smaller.
  const double deviation = std::sqrt(wanted.covariance.diagonal().maxCoeff());
  CHECK((sampled.mean - found.mean).cwiseAbs().maxCoeff() < 0.02 * deviation);
}

TEST_CASE("a one-dimensional cell averages the values whose ranks it covers") {
  // Three values in 256 cells: cell 85 covers ranks 85 / 256 to 86 / 256, a third of it below 1
  // / 3. Restoring the moments stretches the table by no more than the two mixed cells lost: 1 %.
  MapExemplar map;
  map.channels = {MapChannel::red};
  map.encoding = ValueEncoding::linear;
  map.width = 3;
  map.height = 1;
  map.values = {0.0f, 0.5f, 1.0f};
  const Baked b = baked(map);
  const InverseTable table = fitInverseTable(b.gaussian, b.points, map.values, 1, {});
  REQUIRE(table.values.size() == 256);
  CHECK(double(table.values[84]) == Approx(0.0).margin(0.01));
  CHECK(double(table.values[85]) == Approx(0.5 * 2.0 / 3.0).margin(0.01));
  CHECK(double(table.values[86]) == Approx(0.5).margin(0.01));
  CHECK(double(table.values[170]) == Approx(0.5 + 0.5 / 3.0).margin(0.01));
  CHECK(double(table.values[171]) == Approx(1.0).margin(0.01));
}

TEST_CASE("the table stays inside the hull of the exemplar's colours") {
  // Lookups interpolate cells, so they stay inside the cells' convex hull: it is enough that no
  // cell reaches farther in any direction than the exemplar does.
  for (const std::uint64_t seed : {5u, 6u}) {
    const Baked b = baked(test::threeMaterials(128, 128, seed));
    const std::vector<float> values = light(b.map);
    const InverseTable table =
        fitInverseTable(b.gaussian, b.points, values, 3, transport::TransportOptions{});
    for (std::uint64_t k = 0; k < 200; ++k) {
      const Point direction = transport::randomDirection(31, k);
      const auto extent = [&](const std::vector<float>& colours) {
        std::pair<float, float> range{1e9f, -1e9f};
        for (std::size_t i = 0; i < colours.size(); i += 3) {
          const float along = dot(direction, {colours[i], colours[i + 1], colours[i + 2]});
          range = {std::min(range.first, along), std::max(range.second, along)};
        }
        return range;
      };
      const auto [low, high] = extent(values);
      // Restoring the covariance that interpolation loses stretches the table by up to 2 %.
      const float allowed = 0.02f * (high - low);
      const auto [tableLow, tableHigh] = extent(table.values);
      REQUIRE(tableLow >= low - allowed);
      REQUIRE(tableHigh <= high + allowed);
    }
  }
}

TEST_CASE("going to the Gaussian and back returns the exemplar's values") {
  const Baked b = baked(test::threeMaterials(128, 128, 9));
  const std::vector<float> values = light(b.map);
  const InverseTable table =
      fitInverseTable(b.gaussian, b.points, values, 3, transport::TransportOptions{});
  double squares = 0.0;
  constexpr std::size_t kStep = 61; // a sample of the pixels: slowLookup visits every cell
  std::size_t count = 0;
  for (std::size_t i = 0; i < b.gaussian.matched.size(); i += kStep, ++count) {
    const Point& g = b.gaussian.matched[i];
    for (int c = 0; c < 3; ++c) {
      const double error =
          slowLookup(table, {g.x, g.y, g.z}, c) - double(values[3 * i + std::size_t(c)]);
      squares += error * error;
    }
  }
  const double variance = momentsOf(values, 3).covariance.trace();
  // The table has one cell for half a pixel here; a wrong inverse would leave twice the variance.
  CHECK(squares / double(count) < 0.1 * variance);
}

TEST_CASE("the mips of white noise lose what averaging of white noise must lose") {
  // Each mip averages four independent texels: it keeps a quarter of the variance before.
  Gaussianized white{256, 256, 3, stratifiedGaussian(256 * 256, 3, Precision::bits16), {}};
  for (std::size_t i = white.image.size(); i-- > 1;)
    std::swap(white.image[i], white.image[transport::randomBits(5, i) % (i + 1)]);
  const std::vector<ChannelMatrix> lost = lostVariance(gaussianTable(white, 16));
  REQUIRE(lost.size() == 9);
  CHECK(scalarLoss(lost[0]) == 0.0);
  for (std::size_t mip = 1; mip < 5; ++mip) {
    const double kept = std::pow(0.25, double(mip));
    // The mean of three sample variances over n texels has standard error kept sqrt(2 / (3 n)):
    // five of them, false alarms below 1e-6 a level.
    const double texels = 65536.0 * kept;
    CHECK(1.0 - scalarLoss(lost[mip]) ==
          Approx(kept).margin(5.0 * kept * std::sqrt(2.0 / (3.0 * texels))));
  }
}

TEST_CASE("each mip texel is the average of the area it covers, for any size") {
  // Sides odd and even, a side that reaches 1 first, D of 1 to 3. The slow average cuts both levels
  // into the cells of their common grid and counts in integers.
  for (const auto& [width, height, dimensions] :
       {std::array{45, 23, 3}, std::array{7, 61, 2}, std::array{64, 3, 1}, std::array{32, 32, 3}}) {
    const auto count = std::size_t(width) * std::size_t(height);
    const Gaussianized noise{
        width, height, dimensions, stratifiedGaussian(count, dimensions, Precision::bits16), {}};
    const Table table = gaussianTable(noise, 16);
    const int channels = channelCount(table.format);
    REQUIRE(int(table.mipLevels) == int(std::bit_width(unsigned(std::max(width, height)))));
    for (std::uint32_t mip = 1; mip < table.mipLevels; ++mip) {
      INFO(width << " x " << height << ", mip " << mip);
      const std::vector<float> above = decodeLevel(table, mip - 1);
      const std::vector<float> level = decodeLevel(table, mip);
      const auto side = [mip](int full, std::uint32_t back) {
        return std::max(1, full >> (mip - back));
      };
      const int aboveWidth = side(width, 1), aboveHeight = side(height, 1);
      const int levelWidth = side(width, 0), levelHeight = side(height, 0);
      std::vector<double> sums(level.size(), 0.0);
      for (int y = 0; y < aboveHeight * levelHeight; ++y)
        for (int x = 0; x < aboveWidth * levelWidth; ++x)
          for (int c = 0; c < channels; ++c)
            sums[std::size_t((y / aboveHeight * levelWidth + x / aboveWidth) * channels + c)] +=
                double(above[std::size_t(
                    (y / levelHeight * aboveWidth + x / levelWidth) * channels + c)]);
      // A half below 2 is off by at most 2^-11, and so are the halves averaged here.
      for (std::size_t i = 0; i < level.size(); ++i)
        REQUIRE(double(level[i]) ==
                Approx(sums[i] / (aboveWidth * aboveHeight)).margin(std::exp2(-10)));
    }
  }
}

TEST_CASE("blended mips decode to the mean colour, Gaussian or not") {
  const Baked b = baked(test::threeMaterials(128, 128, 4));
  const InverseTable table =
      fitInverseTable(b.gaussian, b.points, light(b.map), 3, transport::TransportOptions{});
  const Table image = gaussianTable(b.gaussian, 16);
  const std::vector<ChannelMatrix> lost = lostVariance(image);
  std::vector<InverseTable> slabs = prefilteredSlabs(table, lost);
  restoreSlabMeans(slabs, image, lost);
  // Between the slabs of a mip the mean is interpolated like the values.
  constexpr std::uint32_t kMip = 2;
  const std::vector<float> texels = decodeLevel(image, kMip);
  const std::size_t count = texels.size() / 4;
  const double place = 7.0 * (1.0 - std::sqrt(1.0 - scalarLoss(lost[kMip])));
  const auto slab = std::size_t(place);
  const TableLookup<3> lower(slabs[slab]);
  const TableLookup<3> upper(slabs[slab + 1]);
  std::mt19937 random(11);
  std::uniform_int_distribution<std::size_t> anywhere(0, count - 1);
  std::exponential_distribution<double> exponential; // three, normalised: uniform in a triangle
  constexpr int kSamples = 200000;
  std::array<double, 3> sum{};
  std::array<double, 3> squares{};
  for (int k = 0; k < kSamples; ++k) {
    std::array<double, 3> w{exponential(random), exponential(random), exponential(random)};
    const double total = w[0] + w[1] + w[2];
    const double norm = std::sqrt(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]) / total;
    std::array<float, 3> g{0.5f, 0.5f, 0.5f};
    for (const double weight : w) {
      const float* texel = &texels[4 * anywhere(random)];
      for (std::size_t c = 0; c < 3; ++c)
        g[c] += float(weight / total / norm) * (texel[c] - 0.5f);
    }
    const auto low = lower(g);
    const auto high = upper(g);
    for (std::size_t c = 0; c < 3; ++c) {
      const double value = double(low[c]) + (place - double(slab)) * double(high[c] - low[c]);
      sum[c] += value;
      squares[c] += value * value;
    }
  }
  for (std::size_t c = 0; c < 3; ++c) {
    const double mean = sum[c] / kSamples;
    const double variance = squares[c] / kSamples - mean * mean;
    // Five standard errors of this sum and of the 65,536 fetches that the shift is measured with;
    // the slab below and the one above are shifted for their own places between mips.
    const double error = 5.0 * std::sqrt(variance * (1.0 / kSamples + 1.0 / 65536.0));
    INFO("mean " << mean << ", slab mean " << slabs.back().values[c] << ", error " << error);
    CHECK(mean == Approx(double(slabs.back().values[c])).margin(error));
  }
}

TEST_CASE("a slab holds the expectation of the table under what a fetch has lost") {
  const Baked b = baked(test::threeMaterials(96, 96, 4));
  const InverseTable table =
      fitInverseTable(b.gaussian, b.points, light(b.map), 3, transport::TransportOptions{});
  ChannelMatrix half(3, 3); // of everything, with channels that lose differently and together
  half << 0.7, 0.15, 0.0, 0.15, 0.5, -0.1, 0.0, -0.1, 0.3;
  const std::vector<double> levels = tableLevels();
  const std::vector<InverseTable> slabs = prefilteredSlabs(table, {half});
  REQUIRE(slabs.size() == levels.size());
  CHECK(slabs.front().values == table.values);

  constexpr std::size_t kSlab = 2;
  const ChannelMatrix loss = half * (levels[kSlab] / scalarLoss(half));
  const Eigen::LLT<ChannelMatrix> factor(loss);
  const ChannelMatrix lower = factor.matrixL();
  constexpr int kSamples = 1500;
  for (const std::size_t cell : {std::size_t(16912), std::size_t(9000), std::size_t(23456)}) {
    std::array<double, 3> middle{};
    std::size_t rest = cell;
    for (double& coordinate : middle) {
      coordinate = gaussianQuantile((double(rest % 32) + 0.5) / 32.0);
      rest /= 32;
    }
    double sum = 0.0;
    double squares = 0.0;
    for (int s = 0; s < kSamples; ++s) {
      ChannelVector z(3);
      for (int c = 0; c < 3; ++c)
        z[c] = deviate(17, std::uint64_t(3 * s + c)) / 6.0;
      const ChannelVector e = lower * z;
      const double value =
          slowLookup(table, {middle[0] + e[0], middle[1] + e[1], middle[2] + e[2]}, 0);
      sum += value;
      squares += value * value;
    }
    const double mean = sum / kSamples;
    const double deviationOfValue = std::sqrt(std::max(0.0, squares / kSamples - mean * mean));
    // Five standard errors of the Monte Carlo mean, alpha 6e-7, and of the slab's own 64 stratified
    // samples, whose error is below a third of independent samples'.
    const double tolerance =
        5.0 * deviationOfValue * (1.0 / std::sqrt(double(kSamples)) + 1.0 / 24.0);
    CHECK(double(slabs[kSlab].values[3 * cell]) == Approx(mean).margin(tolerance));
  }
  const Moments moments = interpolatedMoments(table);
  for (std::size_t c = 0; c < 3; ++c)
    CHECK(double(slabs.back().values[c]) == Approx(moments.mean[Eigen::Index(c)]).epsilon(1e-5));
}

TEST_CASE("an exemplar that tiles is told from a crop that does not") {
  for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
    const MapExemplar whole = test::threeMaterials(128, 128, seed);
    CHECK(isPeriodic(whole));
    CHECK_FALSE(isPeriodic(test::cropped(whole, 10, 0, 90, 128)));
    CHECK_FALSE(isPeriodic(test::cropped(whole, 0, 20, 128, 77)));
  }
}

TEST_CASE("a strip too short to judge across is judged along") {
  MapExemplar ramp = test::threeMaterials(256, 6, 1, 1);
  for (std::size_t i = 0; i < ramp.values.size(); ++i)
    ramp.values[i] = float(i / 3 % 256) / 255.0f;
  CHECK_FALSE(isPeriodic(ramp));
}

TEST_CASE("the seam itself shows the displaced image alone, at every size") {
  for (const int side : {8, 16, 64}) {
    const Baked b = baked(test::threeMaterials(side, side, 2, 1));
    const std::vector<Point> faded = crossFadeBorders(b.gaussian.matched, side, side);
    // In the corners both cross-fades have weight 1: half a side away on both axes.
    for (const int y : {0, side - 1})
      for (const int x : {0, side - 1}) {
        const Point& displaced =
            b.gaussian.matched[std::size_t((y + side / 2) % side * side + (x + side / 2) % side)];
        INFO(side << ": " << x << ", " << y);
        CHECK(faded[std::size_t(y * side + x)].x == Approx(displaced.x).margin(1e-5));
      }
  }
}

TEST_CASE("blended borders continue each other as neighbours inside do") {
  const Baked b = baked(test::cropped(test::threeMaterials(128, 128, 6, 5), 5, 5, 96, 80));
  const std::vector<Point> faded = crossFadeBorders(b.gaussian.matched, 96, 80);
  const auto meanStep = [&](const std::vector<Point>& image, int from, int to) {
    double sum = 0.0;
    for (int y = 0; y < 80; ++y) {
      const Point& p = image[std::size_t(y * 96 + from)];
      const Point& q = image[std::size_t(y * 96 + to)];
      sum += std::abs(double(p.x) - double(q.x)) + std::abs(double(p.y) - double(q.y));
    }
    return sum;
  };
  double inside = 0.0;
  for (int x = 0; x < 95; ++x)
    inside += meanStep(faded, x, x + 1) / 95.0;
  // Grain hides part of the seam: unrelated borders differ by a fifth more here.
  CHECK(meanStep(b.gaussian.matched, 95, 0) > 1.15 * inside);
  CHECK(meanStep(faded, 95, 0) < 1.1 * inside);
}

TEST_CASE("inputs that span fewer dimensions are baked in those") {
  const auto bake = [](const MapExemplar& map) {
    Result<TilingBake> result = bakeTiling("x", {&map, 1}, TilingOptions{});
    REQUIRE(result);
    return std::move(result).value();
  };
  MapExemplar map = test::threeMaterials(64, 64, 8);
  SECTION("grey stored as RGB has one Gaussian channel and a table of 256 colours") {
    for (std::size_t i = 0; i < map.values.size(); ++i)
      map.values[i] = map.values[i - i % 3];
    const TilingBake b = bake(map);
    CHECK(b.tables[0].format == TexelFormat::r8Unorm);
    CHECK(b.tables[1].width == 256);
    const std::vector<float> texels = decodeLevel(b.tables[1], 0);
    for (std::size_t i = 0; i < texels.size(); i += 4) { // no rainbow
      REQUIRE(texels[i] == texels[i + 1]);
      REQUIRE(texels[i] == texels[i + 2]);
    }
    for (std::size_t i = 4; i < std::size_t(256 * 4); i += 4) // brighter is more, but for a code
      REQUIRE(texels[i] >= texels[i - 4] - 2.0f / 255.0f);
    CHECK(texels[std::size_t(255 * 4)] > texels[0] + 0.1f);
  }
  SECTION("two colours lie on a line") {
    for (std::size_t i = 0; i < map.values.size(); i += 3) {
      const bool first = map.values[i] > 0.5f;
      map.values[i] = first ? 0.8f : 0.1f;
      map.values[i + 1] = first ? 0.4f : 0.3f;
      map.values[i + 2] = first ? 0.2f : 0.9f;
    }
    CHECK(bake(map).tables[0].format == TexelFormat::r8Unorm);
  }
  SECTION("colours on a slanted line, rounded to 8 bits, still lie on a line") {
    for (std::size_t i = 0; i < map.values.size(); i += 3)
      for (std::size_t c = 1; c < 3; ++c)
        map.values[i + c] = std::round(255.0f * (c == 1 ? 0.7f : 0.4f) * map.values[i]) / 255.0f;
    CHECK(bake(map).tables[0].format == TexelFormat::r8Unorm);
  }
  SECTION("colours in a plane have two Gaussian channels") {
    for (std::size_t i = 0; i < map.values.size(); i += 3)
      map.values[i + 2] = 0.5f * map.values[i] + 0.25f * map.values[i + 1];
    const TilingBake b = bake(map);
    CHECK(b.tables[0].format == TexelFormat::rg8Unorm);
    CHECK(b.tables[1].height == 64 * std::uint32_t(kTableLevels));
  }
  SECTION("one colour gives one colour") {
    std::fill(map.values.begin(), map.values.end(), 0.5f);
    const TilingBake b = bake(map);
    const std::vector<float> texels = decodeLevel(b.tables[1], 0);
    for (std::size_t i = 0; i < texels.size(); i += 4)
      REQUIRE(texels[i] == Approx(srgbToLinear(0.5f)).margin(0.003));
  }
  SECTION("a single pixel and a single row are accepted") {
    CHECK(bake(test::cropped(map, 3, 3, 1, 1)).noise.maps.size() == 1);
    CHECK(bake(test::cropped(map, 0, 3, 64, 1)).noise.maps.size() == 1);
  }
}

TEST_CASE("flat regions stay smooth once Gaussianized") {
  // Half of the pixels share one colour: their order is free, and follows the surroundings.
  MapExemplar map = test::threeMaterials(96, 96, 12, 6);
  for (std::size_t i = 0; i < map.values.size(); i += 3)
    if (map.values[i] > 0.6f)
      map.values[i] = map.values[i + 1] = map.values[i + 2] = 0.7f;
  const Baked b = baked(map);
  double steps = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < b.points.size(); ++i)
    if (map.values[3 * i] == 0.7f && map.values[3 * i + 3] == 0.7f && (i + 1) % 96 != 0) {
      const Point& p = b.gaussian.matched[i];
      const Point& q = b.gaussian.matched[i + 1];
      steps += double(dot({p.x - q.x, p.y - q.y, p.z - q.z}, {p.x - q.x, p.y - q.y, p.z - q.z}));
      ++count;
    }
  // Arbitrary order would make neighbours independent: a mean square of about 2 x 3 / 36 within
  // the half of the Gaussian that the colour takes, at least 0.08.
  CHECK(steps / double(count) < 0.04);
}

TEST_CASE("equal values are ordered as their surroundings are, within half a step of the file") {
  MapExemplar map;
  map.channels = {MapChannel::red};
  map.width = 64;
  map.height = 1;
  for (int x = 0; x < map.width; ++x) // dark, flat, bright
    map.values.push_back(x < 16 ? 0.2f : x < 48 ? 0.5f : 0.8f);
  const ColorSpace space = colorSpaceOf(map);
  const std::vector<Point> points = transportPoints(map, space);
  CHECK(points[46].x > points[40].x);
  CHECK(points[40].x > points[24].x);
  CHECK(points[24].x > points[17].x);
  for (std::size_t x = 0; x < points.size(); ++x)
    CHECK(double(points[x].x) + space.moments.mean[0] ==
          Approx(double(map.values[x])).margin(0.5 * map.quantum + 1e-6));
}

TEST_CASE("a bake does not depend on the number of threads") {
  const MapExemplar map = test::threeMaterials(160, 120, 21);
  const auto bakeWith = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    Result<TilingBake> result = bakeTiling("x", {&map, 1}, TilingOptions{});
    REQUIRE(result);
    return std::move(result).value();
  };
  const TilingBake one = bakeWith(1);
  const TilingBake many = bakeWith(4);
  REQUIRE(one.tables.size() == many.tables.size());
  for (std::size_t t = 0; t < one.tables.size(); ++t)
    CHECK(one.tables[t].texels == many.tables[t].texels);
  CHECK(one.noise.maps[0].mipLoss == many.noise.maps[0].mipLoss);
}

TEST_CASE("one map that does not tile makes the whole set be blended") {
  const MapExemplar whole = test::threeMaterials(64, 64, 1);
  const MapExemplar crop = test::cropped(test::threeMaterials(128, 128, 2), 9, 5, 64, 64);
  TilingOptions options;
  options.transport = TransportEffort::fast;
  const auto wasPeriodic = [&](const std::vector<MapExemplar>& maps) {
    const Result<TilingBake> bake = bakeTiling("x", maps, options);
    REQUIRE(bake);
    return bake.value().exemplarWasPeriodic;
  };
  CHECK(wasPeriodic({whole}));
  CHECK_FALSE(wasPeriodic({whole, crop}));
  CHECK_FALSE(wasPeriodic({crop, whole}));
  options.periodic = Periodic::yes;
  CHECK(wasPeriodic({crop}));
}

TEST_CASE("options and maps out of range are refused") {
  const MapExemplar map = test::threeMaterials(8, 8, 1, 1);
  TilingOptions options;
  options.bits = 9;
  const Result<TilingBake> result = bakeTiling("x", {&map, 1}, options);
  REQUIRE_FALSE(result);
  CHECK(result.error().kind == ErrorKind::usage);
  CHECK_FALSE(bakeTiling("x", {}, TilingOptions{}));
  const auto refused = [](const MapExemplar& given, const TilingOptions& with) {
    const Result<TilingBake> bake = bakeTiling("x", {&given, 1}, with);
    return !bake && bake.error().kind == ErrorKind::usage;
  };
  MapExemplar broken = map;
  broken.values.pop_back();
  CHECK(refused(broken, TilingOptions{}));
  broken = map;
  broken.values[7] = std::nanf("");
  CHECK(refused(broken, TilingOptions{}));
  broken = map;
  broken.channels.clear();
  CHECK(refused(broken, TilingOptions{}));
  broken.channels.assign(4, MapChannel::red);
  broken.values.resize(std::size_t(8 * 8 * 4), 0.5f);
  CHECK(refused(broken, TilingOptions{}));
  for (const auto& [width, height] :
       {std::pair{0, 8}, {8, 0}, {-8, 8}, {16385, 1}, {1, 16385}, {1 << 30, 1 << 30}}) {
    broken = map;
    broken.width = width;
    broken.height = height;
    if (std::max(width, height) == 16385)
      broken.values.resize(std::size_t(16385 * 3), 0.5f);
    INFO(width << " x " << height);
    CHECK(refused(broken, TilingOptions{}));
  }
  broken = map;
  broken.quantum = 0.0;
  CHECK(refused(broken, TilingOptions{}));
}

TEST_CASE(
    "values beyond what tables hold are refused by value and range, up to it they are baked") {
  MapExemplar map = test::threeMaterials(8, 8, 1, 1);
  const auto bakeWith = [&map](ValueEncoding encoding, float value) {
    map.encoding = encoding;
    map.values[7] = value;
    return bakeTiling("x", {&map, 1}, TilingOptions{});
  };
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kLargest = std::numeric_limits<float>::max();
  using enum ValueEncoding;
  for (const ValueEncoding encoding : {srgb, linear, slope, log2})
    for (const float value : {kInfinity, -kInfinity, kLargest, -kLargest, std::nanf("")}) {
      const Result<TilingBake> bake = bakeWith(encoding, value);
      REQUIRE_FALSE(bake);
      CHECK(bake.error().kind == ErrorKind::usage);
    }
  CHECK(bakeWith(log2, 17.0f).error().message ==
        "a map with the value 17, which stands for 131071: both from -65504 to 65504 are accepted");
  CHECK_FALSE(bakeWith(srgb, 200.0f)); // light of 229,000
  CHECK_FALSE(bakeWith(linear, 65536.0f));
  for (const auto& [encoding, value] : {std::pair{srgb, linearToSrgb(kHalfMax)},
                                        {linear, kHalfMax},
                                        {slope, -kHalfMax},
                                        {log2, std::log2(1.0f + kHalfMax)}}) {
    const Result<TilingBake> bake = bakeWith(encoding, value);
    REQUIRE(bake);
    for (const Table& table : bake.value().tables) {
      const std::vector<float> texels = decodeLevel(table, 0);
      CHECK(std::all_of(texels.begin(), texels.end(), [](float v) { return std::isfinite(v); }));
    }
    const std::vector<double>& covariance = bake.value().noise.maps[0].covariance;
    CHECK(std::all_of(covariance.begin(), covariance.end(),
                      [](double v) { return std::isfinite(v); }));
  }
}
