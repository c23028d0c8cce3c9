// SPDX-License-Identifier: MIT
// Barycentres of Gaussian textures and of covariances, against closed forms and brute force; models
// of different sizes on one grid.
#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <texton/barycenter.h>
#include <texton/gaussian_model.h>
#include <transport/covariance.h>

using namespace lichen;
using namespace lichen::texton;
using Complex = std::complex<double>;
using Eigen::MatrixXd;

namespace {

constexpr double kPi = std::numbers::pi;

/// The transform of a kernel of independent normal values, as for a white-noise exemplar.
texton::GaussianModel randomModel(int width, int height, int channels, unsigned seed) {
  std::mt19937 bits(seed);
  std::normal_distribution<float> normal;
  texton::GaussianModel model;
  std::vector<float> plane(std::size_t(width) * std::size_t(height));
  for (int c = 0; c < channels; ++c) {
    for (float& value : plane)
      value = normal(bits);
    model.channels.push_back(forwardFft(plane, width, height));
    model.channels.back().values[0] = 0.0f;
  }
  return model;
}

/// A model that has `vector`, one value per channel, at its only pair of frequencies.
texton::GaussianModel oneFrequency(const std::vector<Complex>& vector) {
  texton::GaussianModel model;
  for (const Complex value : vector)
    model.channels.push_back({3, 1, {0.0f, std::complex<float>(value)}});
  return model;
}

Complex at(const texton::GaussianModel& model, std::size_t channel, std::size_t i) {
  return Complex(model.channels[channel].values[i]);
}

/// |sum_k w_k e^(i phi_k) t_k|^2 at frequency i.
double powerOf(const std::vector<texton::GaussianModel>& models, const std::vector<double>& weights,
               const std::vector<double>& phases, std::size_t i) {
  double power = 0.0;
  for (std::size_t c = 0; c < models[0].channels.size(); ++c) {
    Complex sum = 0.0;
    for (std::size_t k = 0; k < models.size(); ++k)
      sum += weights[k] * std::polar(1.0, phases[k]) * at(models[k], c, i);
    power += std::norm(sum);
  }
  return power;
}

double powerAt(const texton::GaussianModel& model, std::size_t i) {
  double power = 0.0;
  for (std::size_t c = 0; c < model.channels.size(); ++c)
    power += std::norm(at(model, c, i));
  return power;
}

/// Whether frequency i is its own mirror; phases are then signs.
bool isReal(const HalfSpectrum& shape, std::size_t i) {
  const int u = int(i % std::size_t(shape.columns()));
  const int v = int(i / std::size_t(shape.columns()));
  return shape.multiplicity(u) == 1 && (2 * v) % shape.height == 0;
}

/// Largest difference of the power and cross spectra, relative to the largest power.
double spectrumDifference(const texton::GaussianModel& a, const texton::GaussianModel& b) {
  double difference = 0.0;
  double largest = 0.0;
  for (std::size_t i = 0; i < a.channels[0].values.size(); ++i) {
    for (std::size_t c = 0; c < a.channels.size(); ++c)
      for (std::size_t d = 0; d < a.channels.size(); ++d)
        difference = std::max(difference, std::abs(at(a, c, i) * std::conj(at(a, d, i)) -
                                                   at(b, c, i) * std::conj(at(b, d, i))));
    largest = std::max(largest, powerAt(a, i));
  }
  return difference / largest;
}

MatrixXd randomCovariance(int size, int rank, unsigned seed) {
  std::mt19937 bits(seed);
  std::normal_distribution<double> normal;
  const MatrixXd factor = MatrixXd::NullaryExpr(size, rank, [&] { return normal(bits); });
  return factor * factor.transpose();
}

// Floats have 24 bits, and the values here are sums of a few products.
constexpr double kRounding = 1e-5;

} // namespace

TEST_CASE("amplitudes of one channel are averaged, whatever the number of textures") {
  const std::vector<texton::GaussianModel> models{
      randomModel(12, 9, 1, 1), randomModel(12, 9, 1, 2), randomModel(12, 9, 1, 3),
      randomModel(12, 9, 1, 4), randomModel(12, 9, 1, 5)};
  const std::vector<double> weights{0.1, 0.35, 0.0, 0.3, 0.25};
  const Barycenter found = barycenter(models, weights);
  for (std::size_t i = 0; i < models[0].channels[0].values.size(); ++i) {
    double amplitude = 0.0;
    for (std::size_t k = 0; k < models.size(); ++k)
      amplitude += weights[k] * std::abs(at(models[k], 0, i));
    CHECK(std::abs(at(found.model, 0, i)) == Approx(amplitude).epsilon(kRounding));
  }
  // The root of the rounding error of squares.
  CHECK(found.rankError < 1e-3);
}

TEST_CASE("two have the same barycentre as three of which two are the same") {
  const texton::GaussianModel a = randomModel(10, 8, 3, 1);
  const texton::GaussianModel b = randomModel(10, 8, 3, 2);
  const texton::GaussianModel two = barycenter(std::vector{a, b}, std::vector{0.3, 0.7}).model;
  const texton::GaussianModel three =
      barycenter(std::vector{a, b, b}, std::vector{0.3, 0.3, 0.4}).model;
  // The fixed point stops when |m|^2 gains less than 1e-7: its phases are accurate to the root.
  CHECK(spectrumDifference(two, three) < 2e-3);
  // Aligned models lie on the path between the two, a straight line; its ends are the models.
  const std::vector<texton::GaussianModel> aligned = alignedModels(std::vector{a, b});
  CHECK(spectrumDifference(two, between(aligned[0], aligned[1], 0.7)) < kRounding);
  CHECK(spectrumDifference(a, aligned[0]) < kRounding);
  CHECK(aligned[1].channels[2].values == b.channels[2].values);
}

TEST_CASE("the phases of three textures are the optimum over all phases") {
  const std::vector<texton::GaussianModel> models{
      randomModel(7, 6, 3, 11), randomModel(7, 6, 3, 12), randomModel(7, 6, 3, 13)};
  const std::vector<double> weights{0.25, 0.35, 0.4};
  const Barycenter found = barycenter(models, weights);
  constexpr int kAngles = 240;
  // |m|^2 is a sum of three cosines of phase differences. Half a step from the best phases, each is
  // lower by at most (pi / 240)^2 / 2 of itself; together they are at most |m|^2 plus 1 / 2.
  const double slack = 2.0 * std::pow(kPi / kAngles, 2);
  const HalfSpectrum& shape = models[0].channels[0];
  for (std::size_t i = 1; i < shape.values.size(); ++i) {
    const int angles = isReal(shape, i) ? 2 : kAngles;
    double best = 0.0;
    for (int p = 0; p < angles; ++p)
      for (int q = 0; q < angles; ++q)
        best = std::max(best, powerOf(models, weights,
                                      {2.0 * kPi * p / angles, 2.0 * kPi * q / angles, 0.0}, i));
    INFO("frequency " << i);
    CHECK(powerAt(found.model, i) >= best * (1.0 - kRounding));
    CHECK(powerAt(found.model, i) <= best * (1.0 + slack));
    for (std::size_t c = 0; c < 3 && isReal(shape, i); ++c)
      CHECK(at(found.model, c, i).imag() == 0.0);
  }
  // All frequencies but (0, 0) and (0, 3) are exact. The iteration stops at a gain below 1e-7,
  // which may leave some 1e-5 of the power.
  CHECK(found.rankError < 0.02);
}

TEST_CASE("the fit finds the highest of several maxima over the phases of three textures") {
  // Two channels, for which two maxima are more frequent.
  const std::vector<texton::GaussianModel> models{
      randomModel(601, 1, 2, 21), randomModel(601, 1, 2, 22), randomModel(601, 1, 2, 23)};
  const std::vector<double> weights(3, 1.0 / 3.0);
  const texton::GaussianModel found = barycenter(models, weights).model;
  constexpr int kAngles = 90;
  for (std::size_t i = 1; i < models[0].channels[0].values.size(); ++i) {
    double best = 0.0;
    for (int p = 0; p < kAngles; ++p)
      for (int q = 0; q < kAngles; ++q)
        best = std::max(best, powerOf(models, weights,
                                      {2.0 * kPi * p / kAngles, 2.0 * kPi * q / kAngles, 0.0}, i));
    INFO("frequency " << i);
    CHECK(powerAt(found, i) >= best * (1.0 - kRounding));
  }
}

TEST_CASE("three textures with two optimal mixtures give one of them, with every kernel") {
  // At 120 degrees, the phases may go around in either direction, and any law between the two is a
  // barycentre: |m|^2 = 1/2, a set of circles.
  std::vector<texton::GaussianModel> models;
  for (int k = 0; k < 3; ++k)
    models.push_back(oneFrequency({std::cos(2.0 * kPi * k / 3.0), std::sin(2.0 * kPi * k / 3.0)}));
  const Barycenter found = barycenter(models, std::vector<double>(3, 1.0 / 3.0));
  CHECK(powerAt(found.model, 1) == Approx(0.5).epsilon(kRounding));
  CHECK(found.rankError < 1e-3);
}

TEST_CASE("the rank error measures what one kernel cannot show of four textures") {
  // Vectors whose directions are the corners of a tetrahedron: |t_k^* t_l|^2 = 1/3. Their Gram
  // matrix G has the eigenvalues 2, 2, 0, 0 and is itself the best correlation matrix, because tr(G
  // X) <= 2 tr X = 8 = tr G^2. The barycentre is 1/4 of the identity: power 1/2, two kernels.
  std::vector<texton::GaussianModel> models{oneFrequency({1.0, 0.0})};
  for (int k = 0; k < 3; ++k)
    models.push_back(oneFrequency(
        {std::sqrt(1.0 / 3.0), std::sqrt(2.0 / 3.0) * std::polar(1.0, 2.0 * kPi * k / 3.0)}));
  const std::vector<double> weights(4, 0.25);
  constexpr int kAngles = 90;
  const auto angle = [](int i) { return 2.0 * kPi * i / kAngles; };
  double best = 0.0;
  for (int p = 0; p < kAngles; ++p)
    for (int q = 0; q < kAngles; ++q)
      for (int r = 0; r < kAngles; ++r)
        best = std::max(best, powerOf(models, weights, {angle(p), angle(q), angle(r), 0.0}, 1));
  REQUIRE(best < 0.49);
  const Barycenter found = barycenter(models, weights);
  const double power = powerAt(found.model, 1);
  // Half a step for each of six phase differences.
  CHECK(power == Approx(best).epsilon(6.0 * std::pow(kPi / kAngles, 2)));
  CHECK(power >= best * (1.0 - kRounding));
  // Between S = I/4 and m m^*: tr S + |m|^2 - 2 (m^* S m)^(1/2).
  const double distance = 0.5 + power - std::sqrt(power);
  CHECK(found.rankError == Approx(std::sqrt(distance / 0.5)).epsilon(1e-3));
}

TEST_CASE("the covariance between two textures follows the geodesic of their transport") {
  const std::vector<MatrixXd> pair{randomCovariance(3, 3, 1), randomCovariance(3, 3, 2)};
  const MatrixXd map = transport::covarianceMap(pair[0], pair[1]);
  for (const double rho : {0.0, 0.05, 0.5, 0.8, 1.0}) {
    const MatrixXd line = (1.0 - rho) * MatrixXd::Identity(3, 3) + rho * map;
    const MatrixXd expected = line * pair[0] * line;
    const MatrixXd found = transport::covarianceBarycenter(pair, std::vector{1.0 - rho, rho});
    // The map's own eigenvalues are rounded to 1e-12 of the largest; the result depends on their
    // roots.
    CHECK((found - expected).norm() < 1e-5 * expected.norm());
  }
}

TEST_CASE("commuting covariances and singular covariances can be mixed") {
  MatrixXd axes = Eigen::HouseholderQR<MatrixXd>(randomCovariance(4, 4, 3)).householderQ();
  const auto along = [&](double a, double b, double c, double d) -> MatrixXd {
    return axes * Eigen::Vector4d(a, b, c, d).asDiagonal() * axes.transpose();
  };
  const auto squareOfMean = [](double a, double b, double c) {
    return std::pow(0.2 * std::sqrt(a) + 0.3 * std::sqrt(b) + 0.5 * std::sqrt(c), 2);
  };
  const std::vector<MatrixXd> three{along(1, 0, 0.04, 0), along(4, 2, 0, 0), along(0, 3, 1, 0)};
  const MatrixXd expected =
      along(squareOfMean(1, 4, 0), squareOfMean(0, 2, 3), squareOfMean(0.04, 0, 1), 0);
  const MatrixXd found = transport::covarianceBarycenter(three, std::vector{0.2, 0.3, 0.5});
  CHECK((found - expected).norm() < 1e-6);
  // Two degenerate covariances at an angle: the barycentre is the line between them.
  const Eigen::Vector2d first(1.0, 0.2), second(0.5, 1.0);
  const std::vector<MatrixXd> lines{first * first.transpose(), second * second.transpose()};
  const Eigen::Vector2d middle = 0.4 * first + 0.6 * second;
  const MatrixXd line = transport::covarianceBarycenter(lines, std::vector{0.4, 0.6});
  CHECK((line - middle * middle.transpose()).norm() < 1e-6);
}

TEST_CASE("a finer grid has the same texture, of even and odd sizes") {
  // A smooth periodic image, sampled twice; all frequencies are below half the coarser sampling
  // rate.
  const auto sampled = [](int width, int height) {
    std::vector<float> plane;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        plane.push_back(float((std::cos(2.0 * kPi * (3.0 * x / width - 2.0 * y / height)) +
                               0.5 * std::sin(2.0 * kPi * (x + 0.2) * 5.0 / width) +
                               0.3 * std::cos(2.0 * kPi * 4.0 * y / height)) /
                              std::sqrt(double(width * height))));
    return texton::GaussianModel{{forwardFft(plane, width, height)}};
  };
  const std::vector<texton::GaussianModel> grid =
      onOneGrid(std::vector{sampled(12, 10), sampled(36, 30)});
  REQUIRE(grid[0].width() == 36);
  REQUIRE(grid[0].height() == 30);
  CHECK(spectrumDifference(grid[0], grid[1]) < kRounding);
  // Includes half the sampling, and sizes that do not divide each other.
  for (const auto& [width, height] : {std::pair{8, 6}, {7, 5}, {8, 5}, {5, 6}, {9, 7}}) {
    const texton::GaussianModel coarse = randomModel(width, height, 3, unsigned(width));
    const texton::GaussianModel fine = onOneGrid(std::vector{coarse, randomModel(24, 20, 3, 2)})[0];
    CHECK(fine.width() == 24);
    CHECK((texton::modelCovariance(fine) - texton::modelCovariance(coarse)).norm() <
          kRounding * texton::modelCovariance(coarse).norm());
  }
}

TEST_CASE("a taller tile has the same texture wherever a compact kernel makes it") {
  // The autocorrelation of a patch of sum 0: compact, with a positive spectrum. The patch's
  // position is not part of the texture, and it may lie across the border.
  const std::vector<float> patch{1, -2, 0.5f, 0, 3, -1, -0.5f, -1, 0};
  const auto placed = [&](int width, int height, int shift) {
    std::vector<float> plane(std::size_t(width * height), 0.0f);
    for (int a = 0; a < 9; ++a)
      for (int b = 0; b < 9; ++b) {
        const int x = (a % 3 - b % 3 + shift + width) % width;
        const int y = (a / 3 - b / 3 + shift + height) % height;
        plane[std::size_t(y * width + x)] += patch[std::size_t(a)] * patch[std::size_t(b)];
      }
    return texton::GaussianModel{{forwardFft(plane, width, height)}};
  };
  const std::vector<texton::GaussianModel> grid =
      onOneGrid(std::vector{placed(16, 12, 6), placed(16, 23, 0)});
  REQUIRE(grid[0].height() == 23);
  CHECK(spectrumDifference(grid[0], grid[1]) < kRounding);
  // Any kernel preserves its covariance, up to the loss at frequency 0 from cropping.
  const texton::GaussianModel white = randomModel(16, 12, 3, 4);
  const texton::GaussianModel tall = onOneGrid(std::vector{white, randomModel(32, 40, 3, 5)})[0];
  CHECK(tall.width() == 32);
  CHECK(tall.height() == 40);
  CHECK((texton::modelCovariance(tall) - texton::modelCovariance(white)).norm() <
        kRounding * texton::modelCovariance(white).norm());
}
