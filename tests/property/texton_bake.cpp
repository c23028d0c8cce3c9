// SPDX-License-Identifier: MIT
// Judges a texton bake by its stored tables alone: the covariance of the noise between all channels
// of all maps, and what its mips preserve.
#include "example_exemplar.h"

#include <lichen/image.h>
#include <lichen/texton.h>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <cmath>
#include <exemplar/value_encoding.h>
#include <texton/coefficients.h>

namespace lichen {
namespace {

using Eigen::MatrixXd;

/// The B-spline of degree 2 order + 1 at the integers, as in [GLM17] section 4.1 and ALGORITHMS.
double sampledSpline(int order, int lag) {
  constexpr double kOrder3[] = {151.0 / 315.0, 397.0 / 1680.0, 1.0 / 42.0, 1.0 / 5040.0};
  lag = std::abs(lag);
  if (order == 0)
    return lag == 0 ? 1.0 : 0.0;
  if (order == 1)
    return lag == 0 ? 2.0 / 3.0 : (lag == 1 ? 1.0 / 6.0 : 0.0);
  return lag < 4 ? kOrder3[lag] : 0.0;
}

/// The stored coefficients of one channel.
struct Channel {
  std::vector<double> texels; ///< of one mip, row by row
  int width = 0;
  int height = 0;
};

std::vector<Channel> channelsOf(const MethodBake& bake, std::uint32_t level = 0) {
  std::vector<Channel> all;
  for (const NoiseMap& map : bake.noise.maps) {
    const Table& table = bake.tables[map.as<TextonMap>().image];
    const std::vector<float> values = decodeLevel(table, level);
    const auto stride = std::size_t(channelCount(table.format));
    for (std::size_t c = 0; c < map.channels.size(); ++c) {
      Channel channel{{}, int(table.width >> level), int(table.height >> level)};
      for (std::size_t i = c; i < values.size(); i += stride)
        channel.texels.push_back(map.as<TextonMap>().scale[c] * double(values[i]));
      all.push_back(std::move(channel));
    }
  }
  return all;
}

/// Sum over k, l of b(k - l) a(k) b(l), by definition.
double covariance(const Channel& a, const Channel& b, int order) {
  double sum = 0.0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x)
      for (int dy = -order; dy <= order; ++dy)
        for (int dx = -order; dx <= order; ++dx) {
          const int u = x + dx, v = y + dy;
          if (u >= 0 && v >= 0 && u < b.width && v < b.height)
            sum += sampledSpline(order, dx) * sampledSpline(order, dy) *
                   a.texels[std::size_t(y * a.width + x)] * b.texels[std::size_t(v * b.width + u)];
        }
  return sum;
}

MatrixXd storedCovariance(const MethodBake& bake) {
  const std::vector<Channel> channels = channelsOf(bake);
  const auto n = Eigen::Index(channels.size());
  MatrixXd result(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      result(i, j) = covariance(channels[std::size_t(i)], channels[std::size_t(j)],
                                bake.noise.as<TextonShape>().order);
  return result;
}

/// The covariance of the values that a noise stores: roots of light for colours.
MatrixXd exemplarCovariance(std::span<const MapExemplar> maps) {
  std::vector<std::vector<double>> channels;
  for (const MapExemplar& map : exemplar::asStored(maps)) {
    const std::size_t n = map.channels.size();
    for (std::size_t c = 0; c < n; ++c) {
      std::vector<double> values;
      double mean = 0.0;
      for (std::size_t i = c; i < map.values.size(); i += n) {
        values.push_back(map.values[i]);
        mean += map.values[i];
      }
      for (double& value : values)
        value -= mean / double(values.size());
      channels.push_back(std::move(values));
    }
  }
  const auto n = Eigen::Index(channels.size());
  MatrixXd result = MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) {
      const std::vector<double>&a = channels[std::size_t(i)], &b = channels[std::size_t(j)];
      for (std::size_t k = 0; k < a.size(); ++k)
        result(i, j) += a[k] * b[k] / double(a.size());
    }
  return result;
}

/// Slopes and a roughness that follow the colours' light, so that all maps are related.
std::vector<MapExemplar> materialSet(const MapExemplar& color) {
  MapExemplar normal = color, rough = color;
  normal.target = MapTarget::normal;
  normal.channels = {MapChannel::slopeX, MapChannel::slopeY};
  normal.encoding = ValueEncoding::slope;
  normal.values.clear();
  rough.target = MapTarget::occlusionRoughnessMetallic;
  rough.channels = {MapChannel::roughness};
  rough.encoding = ValueEncoding::linear;
  rough.values.clear();
  const auto green = [&](int x, int y) {
    x = (x + color.width) % color.width;
    y = (y + color.height) % color.height;
    return color.values[3 * std::size_t(y * color.width + x) + 1];
  };
  for (int y = 0; y < color.height; ++y)
    for (int x = 0; x < color.width; ++x) {
      normal.values.push_back(green(x - 1, y) - green(x + 1, y));
      normal.values.push_back(green(x, y - 1) - green(x, y + 1));
      rough.values.push_back(1.0f - green(x, y));
    }
  return {color, normal, rough};
}

MethodBake bakeOf(std::span<const MapExemplar> maps, const TextonOptions& options) {
  Result<MethodBake> baked = bakeTexton("stone", maps, options);
  REQUIRE(baked);
  return std::move(baked).value();
}

TextonOptions supportOf(int support, int order = 1, int bits = 16) {
  TextonOptions options;
  options.support = support;
  options.order = order;
  options.bits = bits;
  return options;
}

/// The largest error of a covariance relative to the standard deviations of its two channels.
double worstError(const MatrixXd& stored, const MatrixXd& wanted) {
  double worst = 0.0;
  for (Eigen::Index i = 0; i < wanted.rows(); ++i)
    for (Eigen::Index j = 0; j < wanted.cols(); ++j)
      worst = std::max(worst, std::abs(stored(i, j) - wanted(i, j)) /
                                  std::sqrt(wanted(i, i) * wanted(j, j)));
  return worst;
}

/// A colour map, and the roughness map of another surface times `gain`.
std::vector<MapExemplar> colorAndRoughness(float gain) {
  const MapExemplar other = test::threeMaterials(64, 64, 18);
  MapExemplar rough = other;
  rough.target = MapTarget::occlusionRoughnessMetallic;
  rough.channels = {MapChannel::roughness};
  rough.encoding = ValueEncoding::linear;
  rough.quantum = 1.0 / 65535.0;
  rough.values.clear();
  for (std::size_t i = 1; i < other.values.size(); i += 3)
    rough.values.push_back(gain * other.values[i]);
  return {test::threeMaterials(64, 64, 17), rough};
}

/// 32-bit texels are rounded by 6e-8; the target is 1e-6.
constexpr double kCovarianceTolerance = 1e-6;

} // namespace

TEST_CASE("a texton's noise has the exemplar's covariance, for every order") {
  const MapExemplar map = test::threeMaterials(64, 48, 5);
  const MatrixXd wanted = exemplarCovariance({&map, 1});
  for (const int order : {0, 1, 3}) {
    const MethodBake bake = bakeOf({&map, 1}, supportOf(16, order));
    CHECK(worstError(storedCovariance(bake), wanted) <= kCovarianceTolerance);
    CHECK(bake.figures.quality.covarianceError <= kCovarianceTolerance);
  }
}

TEST_CASE("half floats preserve a texton's covariance up to rounding") {
  const MapExemplar map = test::threeMaterials(64, 64, 6);
  const MatrixXd wanted = exemplarCovariance({&map, 1});
  const MethodBake bake = bakeOf({&map, 1}, supportOf(32, 1, 8));
  // Each of 961 texels a has a uniform error of at most 2^-11 a, and the covariance a^T B a has an
  // error of twice the sum of a (B a) times these. Relative to the covariance, its standard
  // deviation is 2 2^-11 / sqrt(3 961), times the root of the flatness, 2 at most, times |a| |B a|
  // / (a^T B a), at most 5/3 for eigenvalues of B between 1/9 and 1 (Kantorovich): 6.1e-5. The
  // limit is four of these.
  const double measured = worstError(storedCovariance(bake), wanted);
  CHECK(measured <= 2.4e-4);
  // The reported error is the half floats', not the error of the coefficients before rounding.
  CHECK(bake.figures.quality.covarianceError == Approx(measured).epsilon(1e-3));
}

TEST_CASE("a low-contrast map of a set is fitted as exactly as a high-contrast one") {
  // A power of 2, so that floats round alike: 1/16384 of the variance.
  constexpr float kGain = 1.0f / 128.0f;
  const std::vector<MapExemplar> faint = colorAndRoughness(kGain);
  const MethodBake faintBake = bakeOf(faint, supportOf(24));
  CHECK(worstError(storedCovariance(faintBake), exemplarCovariance(faint)) <= kCovarianceTolerance);
  const MethodBake strongBake = bakeOf(colorAndRoughness(1.0f), supportOf(24));
  CHECK(faintBake.figures.quality.channelErrors == strongBake.figures.quality.channelErrors);
  for (std::size_t i = 0; i < 2; ++i)
    CHECK(faintBake.tables[i].texels == strongBake.tables[i].texels);
  CHECK(faintBake.noise.maps[1].as<TextonMap>().scale[0] ==
        kGain * strongBake.noise.maps[1].as<TextonMap>().scale[0]);
}

TEST_CASE("the maps of a set preserve their covariances") {
  const std::vector<MapExemplar> maps = materialSet(test::threeMaterials(64, 64, 7));
  const MatrixXd wanted = exemplarCovariance(maps);
  const MethodBake bake = bakeOf(maps, supportOf(24));
  CHECK(worstError(storedCovariance(bake), wanted) <= kCovarianceTolerance);
  REQUIRE(bake.noise.maps.size() == 3);
  CHECK(bake.noise.maps[1].mean.size() == 2);
}

TEST_CASE("textons support grey stored as RGB, a constant channel and a single colour") {
  MapExemplar grey = test::threeMaterials(48, 48, 8);
  for (std::size_t i = 0; i < grey.values.size(); i += 3)
    grey.values[i + 1] = grey.values[i + 2] = grey.values[i];
  const MatrixXd wanted = exemplarCovariance({&grey, 1});
  const MethodBake greyBake = bakeOf({&grey, 1}, supportOf(16));
  CHECK((storedCovariance(greyBake) - wanted).norm() <= kCovarianceTolerance * wanted.norm());

  MapExemplar flatBlue = test::threeMaterials(48, 48, 9);
  for (std::size_t i = 2; i < flatBlue.values.size(); i += 3)
    flatBlue.values[i] = 0.25f;
  const MethodBake blueBake = bakeOf({&flatBlue, 1}, supportOf(16));
  CHECK(blueBake.noise.maps[0].as<TextonMap>().scale[2] == 0.0);
  CHECK(blueBake.noise.maps[0].mean[2] == Approx(std::sqrt(srgbToLinear(0.25f))));

  MapExemplar one = flatBlue;
  std::fill(one.values.begin(), one.values.end(), 0.5f);
  const MethodBake oneBake = bakeOf({&one, 1}, supportOf(16));
  CHECK(oneBake.figures.quality.modelError == 0.0);
  CHECK(oneBake.noise.maps[0].as<TextonMap>().scale == std::vector<double>{0.0, 0.0, 0.0});
}

TEST_CASE("an exemplar of one pixel and one narrower than the support give textons") {
  const MapExemplar map = test::threeMaterials(64, 64, 10);
  for (const auto& [width, height] : {std::pair{1, 1}, {64, 3}, {7, 64}}) {
    const MapExemplar part = test::cropped(map, 0, 0, width, height);
    const Result<MethodBake> baked = bakeTexton("stone", {&part, 1}, supportOf(16));
    REQUIRE(baked);
    CHECK(baked.value().noise.as<TextonShape>().coefficientsX == std::min(15, width));
    CHECK(baked.value().noise.as<TextonShape>().coefficientsY == std::min(15, height));
  }
}

TEST_CASE("variance that a texton cannot show is dropped below a thousandth, and an error above") {
  // Two identical channels: (1, 1) spans the range of their covariance. For unit variances and
  // correlation 1 - e, the part outside that range is e / 2 in every entry.
  texton::TextonCoefficients coefficients{8, 8, 2, std::vector<float>(128)};
  for (std::size_t i = 0; i < 64; ++i)
    coefficients.values[i] = coefficients.values[64 + i] = float(int(i * i % 17) - 8);
  const auto target = [](double e) {
    return (MatrixXd(2, 2) << 1.0, 1.0 - e, 1.0 - e, 1.0).finished();
  };
  const std::vector<float> before = coefficients.values;
  CHECK_FALSE(texton::correctCovariance(coefficients, 1, target(2.2e-3)));
  CHECK(coefficients.values == before);
  REQUIRE(texton::correctCovariance(coefficients, 1, target(1.8e-3)));
  const MatrixXd reached = texton::noiseCovariance(coefficients, 1);
  CHECK((reached - MatrixXd::Constant(2, 2, 1.0 - 0.9e-3)).cwiseAbs().maxCoeff() <= 1e-6);
}

TEST_CASE("a texton's frame is 0 outside the coefficients, and its mips are averages") {
  const MapExemplar map = test::threeMaterials(64, 64, 12);
  const MethodBake bake = bakeOf({&map, 1}, supportOf(32));
  const auto& shape = bake.noise.as<TextonShape>();
  REQUIRE(shape.mipLevels == 3);
  for (std::size_t c = 0; c < 3; ++c) {
    Channel fine = channelsOf(bake)[c];
    for (int y = 0; y < fine.height; ++y)
      for (int x = 0; x < fine.width; ++x)
        if (x >= shape.coefficientsX || y >= shape.coefficientsY)
          CHECK(fine.texels[std::size_t(y * fine.width + x)] == 0.0);
    for (const std::uint32_t level : {1u, 2u}) {
      const Channel coarse = channelsOf(bake, level)[c];
      for (int y = 0; y < coarse.height; ++y)
        for (int x = 0; x < coarse.width; ++x) {
          const auto at = [&](int u, int v) {
            return fine.texels[std::size_t((2 * y + v) * fine.width + 2 * x + u)];
          };
          CHECK(coarse.texels[std::size_t(y * coarse.width + x)] ==
                Approx(0.25 * (at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1))).margin(1e-7));
        }
      fine = coarse;
    }
  }
}

TEST_CASE("support, order and bits change the texton as documented") {
  const MapExemplar map = test::threeMaterials(64, 64, 14);
  const MethodBake plain = bakeOf({&map, 1}, supportOf(16));
  CHECK(plain.noise.as<TextonShape>().coefficientsX == 15);
  CHECK(plain.noise.as<TextonShape>().frameWidth() == 18);
  CHECK(bakeOf({&map, 1}, supportOf(24)).figures.quality.modelError <
        plain.figures.quality.modelError);
  CHECK(bakeOf({&map, 1}, supportOf(16, 3)).noise.as<TextonShape>().coefficientsX == 13);
  CHECK(texelBytes(plain.tables[0].format) == 16);
  CHECK(texelBytes(bakeOf({&map, 1}, supportOf(16, 1, 8)).tables[0].format) == 8);
}

TEST_CASE("the errors for options and maps out of range have the value") {
  const MapExemplar map = test::threeMaterials(32, 32, 15);
  const auto refused = [&](const TextonOptions& options, const std::string& words) {
    const Result<MethodBake> baked = bakeTexton("stone", {&map, 1}, options);
    REQUIRE_FALSE(baked);
    CHECK(baked.error().kind == ErrorKind::usage);
    CHECK_THAT(baked.error().message, Catch::Contains(words));
  };
  refused(supportOf(3), "support 3");
  refused(supportOf(1025), "support 1025");
  refused(supportOf(16, 2), "order 2");
  refused(supportOf(16, 1, 12), "12 bits");
}

TEST_CASE("a texton bake needs at least one map, and each map once") {
  const MapExemplar map = test::threeMaterials(32, 32, 15);
  CHECK_FALSE(bakeTexton("stone", {}, supportOf(16)));
  const std::vector<MapExemplar> twice{map, map};
  CHECK_FALSE(bakeTexton("stone", twice, supportOf(16)));
}

} // namespace lichen
