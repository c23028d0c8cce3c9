// SPDX-License-Identifier: MIT
// Statistics of texton noise against closed forms; whole images of it.
#include "texton_evaluation.h"

#include <lichen/synthesize.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <map>
#include <random>

using namespace lichen;
using namespace lichen::test;

namespace {

struct Evaluation : TextonEvaluation {
  Evaluation(const SyntheticTexton& source, PointProcess process, double impacts,
             std::uint32_t seed)
      : TextonEvaluation(source, materialOf(process, impacts, seed)) {}

  /// Stored values minus their mean, at a position in texels with the footprint of this mip level.
  [[nodiscard]] std::array<double, 3> at(double x, double y, double level = 0.0) const {
    const float side = std::exp2(float(level > 0.0 ? level + 0.5 : 0.0));
    const float pixelX = side / constants.tileTexelsX;
    const float pixelY = side / constants.tileTexelsY;
    TileFootprint place;
    place.position = {float(x) / constants.tileTexelsX, float(y) / constants.tileTexelsY};
    place.dx = {pixelX, 0.0f};
    place.dy = {0.0f, pixelY};
    return storedAt(place);
  }
  /// Sides of the cells of impacts.
  [[nodiscard]] std::array<double, 2> cellTexels() const {
    return {double(constants.tileTexelsX) / double(material.material.columnsPerTile),
            double(constants.tileTexelsY) / double(material.material.rowsPerTile)};
  }
};

const SyntheticTexton kColour{
    .coefficientsX = 12, .coefficientsY = 10, .mipLevels = 2, .wholeFloats = true};
const SyntheticTexton kHeight{
    .coefficientsX = 12, .coefficientsY = 10, .mipLevels = 2, .channels = 1, .wholeFloats = true};

/// Calls act(x, y) for `side` x `side` positions [texels]. Each is random in its own square, and
/// the squares are further apart than textons reach, so that the values are independent.
template <class Act>
void atIndependentPlaces(int side, double reachTexels, const Act& act) {
  std::mt19937 generator(3u);
  std::uniform_real_distribution<double> inside(0.0, 16.0);
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const double x = i * (reachTexels + 16.0) + inside(generator);
      const double y = j * (reachTexels + 16.0) + inside(generator);
      act(x, y);
    }
}

/// h of order 1, sampled, so that integrals over it are sums.
class SampledTexton {
public:
  explicit SampledTexton(const SyntheticTexton& source)
      : source_(source), coefficients_(syntheticCoefficients(source, 0)) {}

  static constexpr int kPerTexel = 8;
  [[nodiscard]] int width() const { return (source_.coefficientsX + 1) * kPerTexel; }
  [[nodiscard]] int height() const { return (source_.coefficientsY + 1) * kPerTexel; }
  [[nodiscard]] double at(int column, int row) const {
    const double x = (column + 0.5) / kPerTexel - 1.0, y = (row + 0.5) / kPerTexel - 1.0;
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) {
      const int i = int(std::floor(x)) + k % 2, j = int(std::floor(y)) + k / 2;
      if (i >= 0 && j >= 0 && i < source_.coefficientsX && j < source_.coefficientsY)
        sum += (1.0 - std::abs(x - i)) * (1.0 - std::abs(y - j)) *
               coefficients_[std::size_t(j * source_.coefficientsX + i)];
    }
    return sum;
  }

private:
  SyntheticTexton source_;
  std::vector<double> coefficients_;
};

/// The excess kurtosis of the noise. For a Poisson process, Campbell's theorem gives the sum of the
/// cells' fourth cumulants over the squared variance. For a stratified process a cell holds one
/// impact, whose fourth cumulant is smaller by three times its squared variance. Averaged over the
/// position of the grid.
double excessKurtosis(const Evaluation& noise, PointProcess process) {
  const SampledTexton h(kHeight);
  const double area = 1.0 / (SampledTexton::kPerTexel * SampledTexton::kPerTexel);
  const std::array<double, 2> cell = noise.cellTexels();
  double squares = 0.0, fourths = 0.0;
  for (int row = 0; row < h.height(); ++row)
    for (int column = 0; column < h.width(); ++column) {
      squares += std::pow(h.at(column, row), 2) * area;
      fourths += std::pow(h.at(column, row), 4) * area;
    }
  double cells = 0.0;
  constexpr int kPlaces = 6;
  for (int place = 0; place < kPlaces * kPlaces; ++place) {
    std::map<std::pair<int, int>, double> inCell;
    for (int row = 0; row < h.height(); ++row)
      for (int column = 0; column < h.width(); ++column) {
        const double x =
            (column + 0.5) / SampledTexton::kPerTexel / cell[0] + double(place % kPlaces) / kPlaces;
        const double y =
            (row + 0.5) / SampledTexton::kPerTexel / cell[1] + double(place / kPlaces) / kPlaces;
        inCell[{int(x), int(y)}] += std::pow(h.at(column, row), 2) * area;
      }
    for (const auto& [index, sum] : inCell)
      cells += sum * sum / (kPlaces * kPlaces);
  }
  const double lambda = 1.0 / (cell[0] * cell[1]);
  const double poisson = fourths / (lambda * squares * squares);
  return process == PointProcess::poisson ? poisson : poisson - 3.0 * cells / (squares * squares);
}

constexpr PointProcess kProcesses[] = {PointProcess::stratified, PointProcess::poisson};

} // namespace

TEST_CASE("the covariance at a lag is sum b(k - l) alpha alpha^T, for both processes") {
  const std::vector<double> alpha = syntheticCoefficients(kColour, 0);
  const std::vector<double> whole = covarianceAt(kColour, alpha, 0, 0);
  for (const PointProcess process : kProcesses) {
    const Evaluation noise(kColour, process, 30.0, 5);
    for (const auto& [lagX, lagY] :
         std::vector<std::array<int, 2>>{{0, 0}, {1, 0}, {0, 2}, {3, -1}, {-2, 5}, {13, 0}}) {
      std::array<double, 9> sum{};
      std::array<double, 3> mean{};
      constexpr int kSide = 120;
      constexpr double kCount = double(kSide) * kSide;
      atIndependentPlaces(kSide, 32.0, [&](double x, double y) {
        const auto here = noise.at(x, y), there = noise.at(x + lagX, y + lagY);
        for (std::size_t c = 0; c < 3; ++c) {
          mean[c] += here[c] / kCount;
          for (std::size_t d = 0; d < 3; ++d)
            sum[3 * c + d] += here[c] * there[d] / kCount;
        }
      });
      const std::vector<double> expected = covarianceAt(kColour, alpha, lagX, lagY);
      INFO("lag " << lagX << ", " << lagY << ", " << nameOf(process));
      for (std::size_t c = 0; c < 3; ++c) {
        // 5 standard errors, alpha 6e-7 each; standard errors are Gaussian, plus a tenth for the
        // kurtosis.
        CHECK(std::abs(mean[c]) < 5.0 * std::sqrt(whole[4 * c] / kCount));
        for (std::size_t d = 0; d < 3; ++d) {
          const double error = std::sqrt(
              (whole[4 * c] * whole[4 * d] + expected[3 * c + d] * expected[3 * c + d]) / kCount);
          CHECK(std::abs(sum[3 * c + d] - expected[3 * c + d]) < 5.0 * 1.1 * error);
        }
      }
    }
  }
}

TEST_CASE("the kurtosis of each process matches its closed form, and the variance does not depend "
          "on the grid") {
  const double variance = covarianceAt(kHeight, syntheticCoefficients(kHeight, 0), 0, 0)[0];
  for (const PointProcess process : kProcesses) {
    const Evaluation noise(kHeight, process, 4.0, 9);
    const std::array<double, 2> cell = noise.cellTexels();
    constexpr int kSide = 260, kBins = 6;
    constexpr double kCount = double(kSide) * kSide;
    double fourth = 0.0, eighth = 0.0;
    std::array<double, kBins * kBins> squares{}, counts{};
    atIndependentPlaces(kSide, 16.0, [&](double x, double y) {
      const double square = std::pow(noise.at(x, y)[0], 2) / variance;
      fourth += square * square / kCount;
      eighth += std::pow(square, 4) / kCount;
      const auto bin = [](double place) {
        return std::size_t(std::min(kBins - 1, int((place - std::floor(place)) * kBins)));
      };
      const std::size_t at = bin(y / cell[1]) * kBins + bin(x / cell[0]);
      squares[at] += square;
      counts[at] += 1.0;
    });
    const double excess = excessKurtosis(noise, process);
    // 5 standard errors of the mean of fourth powers, alpha 6e-7.
    const double error = std::sqrt((eighth - fourth * fourth) / kCount);
    INFO(nameOf(process) << ": excess " << fourth - 3.0 << ", closed form " << excess);
    CHECK(std::abs(fourth - 3.0 - excess) < 5.0 * error);
    double chiSquare = 0.0;
    for (std::size_t k = 0; k < squares.size(); ++k)
      chiSquare += std::pow(squares[k] / counts[k] - 1.0, 2) * counts[k] / (fourth - 1.0);
    // 36 bins: 78.6 is exceeded with probability 5e-5.
    CHECK(chiSquare < 78.6);
  }
  // The two processes are far apart, so the test can distinguish them.
  const Evaluation any(kHeight, PointProcess::stratified, 4.0, 9);
  CHECK(excessKurtosis(any, PointProcess::poisson) >
        0.5 + excessKurtosis(any, PointProcess::stratified));
}

TEST_CASE("minified noise has the variance of mipLoss, also beyond the last mip, and is the "
          "average of the noise") {
  const double variance = covarianceAt(kHeight, syntheticCoefficients(kHeight, 0), 0, 0)[0];
  const Evaluation noise(kHeight, PointProcess::stratified, 30.0, 2);
  const std::vector<double>& losses = noise.bundle.noises[0].maps[0].as<TextonMap>().mipLoss;
  for (const int level : {1, 2, 3, 4}) {
    constexpr int kSide = 120;
    constexpr double kCount = double(kSide) * kSide;
    double square = 0.0;
    const double reach = 24.0 + 2.0 * std::exp2(level);
    atIndependentPlaces(kSide, reach, [&](double x, double y) {
      square += std::pow(noise.at(x, y, level)[0], 2) / kCount;
    });
    // 5 standard errors of a variance, alpha 6e-7, plus the quantization of the lost variance to
    // bytes at small kept amplitudes.
    const double kept = variance * (1.0 - losses[std::size_t(level)]);
    const double step = variance * 2.0 * std::sqrt(1.0 - losses[std::size_t(level)]) / 510.0;
    INFO("level " << level);
    CHECK(std::abs(square - kept) < 5.0 * 1.1 * kept * std::sqrt(2.0 / kCount) + step);
  }
  const SyntheticTexton smooth{.coefficientsX = 24,
                               .coefficientsY = 20,
                               .channels = 1,
                               .wholeFloats = true,
                               .smoothings = 10};
  const Evaluation fine(smooth, PointProcess::stratified, 30.0, 2);
  for (const int level : {1, 2}) {
    // A box average of texels, interpolated linearly. Averaged over the positions of the mip's
    // texels, it is an average over the quadratic B-spline of the pixel's width.
    const auto spline = [](double x) {
      x = std::abs(x);
      return x < 0.5 ? 0.75 - x * x : 0.5 * std::pow(std::max(0.0, 1.5 - x), 2);
    };
    const double side = std::exp2(level);
    double product = 0.0, filtered = 0.0, averaged = 0.0;
    atIndependentPlaces(24, 64.0, [&](double x, double y) {
      double average = 0.0;
      constexpr int kSamples = 12; // along each axis, over three pixels
      for (int k = 0; k < kSamples * kSamples; ++k) {
        const double dx = 3.0 * ((k % kSamples + 0.5) / kSamples - 0.5);
        const double dy = 3.0 * ((k / kSamples + 0.5) / kSamples - 0.5);
        average += spline(dx) * spline(dy) * fine.at(x + side * dx, y + side * dy)[0];
      }
      const double value = fine.at(x, y, level)[0];
      product += value * average;
      filtered += value * value;
      averaged += average * average;
    });
    const double correlation = product / std::sqrt(filtered * averaged);
    INFO("level " << level << ", correlation " << correlation);
    CHECK(correlation > 0.99); // 0.999 and 0.997 measured
  }
}

namespace {

LinearImage synthesized(const Bundle& bundle, const SynthesisOptions& options) {
  Result<LinearImage> image = synthesize(bundle, options);
  REQUIRE(image);
  return std::move(image).value();
}

} // namespace

TEST_CASE("a tileable image of texton noise moved by its origin is the same image, rolled") {
  const Bundle bundle = syntheticTextonBundle(kColour).bundle;
  SynthesisOptions options;
  options.width = 96;
  options.height = 72;
  options.tileable = true;
  for (const PointProcess process : kProcesses) {
    options.material.pointProcess = process;
    options.origin = {0.0, 0.0};
    const LinearImage first = synthesized(bundle, options);
    options.origin = {-20.0 + 40.0 / 64.0, 17.0 / 48.0};
    const LinearImage moved = synthesized(bundle, options);
    const int shiftX = 40 + 64 * -20, shiftY = 17;
    for (int y = 0; y < 72; ++y)
      for (int x = 0; x < 96; ++x) {
        const int fromX = ((x + shiftX) % 96 + 96) % 96, fromY = (y + shiftY) % 72;
        // Positions are rounded to 2^-17 texels; slopes of 30 impacts are below 1 per texel.
        for (int c = 0; c < 3; ++c)
          REQUIRE(moved.pixel(x, y)[c] == Approx(first.pixel(fromX, fromY)[c]).margin(1e-3));
      }
  }
}

TEST_CASE("integer parts of the origin are exact for texton noise") {
  const Bundle bundle = syntheticTextonBundle(kColour).bundle;
  SynthesisOptions options;
  options.width = options.height = 48;
  options.origin = {1e9, -3e8};
  const LinearImage first = synthesized(bundle, options);
  options.origin = {1e9 + 0.25, -3e8 + 0.5};
  const LinearImage second = synthesized(bundle, options);
  for (int y = 24; y < 48; ++y)
    for (int x = 16; x < 48; ++x)
      REQUIRE(second.pixel(x - 16, y - 24)[0] == Approx(first.pixel(x, y)[0]).margin(1e-3));
}
