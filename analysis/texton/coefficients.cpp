// SPDX-License-Identifier: MIT
// Coefficients (channels, height, width) and a covariance -> coefficients with that covariance.
//
// Sources: [GLM17] section 4.3; [PC19] eq. 2.40 for the map.
#include "coefficients.h"

#include "transport/covariance.h"

#include <lichen/spectrum.h>

#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace lichen::texton {
namespace {

using Eigen::MatrixXd;

/// Rounding of the float coefficients and of the eigenvalues limits the accuracy of the first map.
/// The second map is almost the identity and removes most of the remaining error.
constexpr int kRounds = 2;
/// Largest error of a covariance within what the coefficients can express, relative to its two
/// standard deviations: the target of docs/benchmarks.md.
constexpr double kTolerance = 1e-6;
/// Largest part of a covariance, in the same measure, that may lie outside the texton's range. A
/// thousandth is far below what the eye sees, and above what a brightness gradient in one colour of
/// a grey photograph leaves.
constexpr double kUnreachable = 1e-3;

/// Filters one plane with the kernel's autocorrelation along both axes.
MatrixXd filtered(const MatrixXd& plane, const std::vector<double>& b) {
  const auto order = Eigen::Index(b.size()) - 1;
  const auto alongRows = [&](const MatrixXd& in) {
    MatrixXd out = b[0] * in;
    for (Eigen::Index lag = 1; lag <= std::min(order, in.rows() - 1); ++lag) {
      const Eigen::Index rest = in.rows() - lag;
      out.topRows(rest) += b[std::size_t(lag)] * in.bottomRows(rest);
      out.bottomRows(rest) += b[std::size_t(lag)] * in.topRows(rest);
    }
    return out;
  };
  return alongRows(alongRows(plane).transpose()).transpose();
}

/// Returns the coefficients as a matrix with one column per channel.
Eigen::Map<Eigen::MatrixXf> columnsOf(TextonCoefficients& coefficients) {
  return {coefficients.values.data(), Eigen::Index(coefficients.width) * coefficients.height,
          coefficients.channels};
}

} // namespace

MatrixXd noiseCovariance(const TextonCoefficients& coefficients, int order) {
  const std::vector<double> b = kernelAutocorrelation(order);
  const Eigen::Index texels = Eigen::Index(coefficients.width) * coefficients.height;
  const Eigen::Map<const Eigen::MatrixXf> all(coefficients.values.data(), texels,
                                              coefficients.channels);
  const MatrixXd values = all.cast<double>();
  MatrixXd smoothed(values.rows(), values.cols());
  for (Eigen::Index c = 0; c < values.cols(); ++c) {
    const Eigen::Map<const MatrixXd> plane(values.col(c).data(), coefficients.width,
                                           coefficients.height);
    const MatrixXd result = filtered(plane, b);
    smoothed.col(c) = Eigen::Map<const Eigen::VectorXd>(result.data(), texels);
  }
  const MatrixXd product = values.transpose() * smoothed;
  return 0.5 * (product + product.transpose());
}

bool correctCovariance(TextonCoefficients& coefficients, int order, const MatrixXd& target) {
  // Measure channels in standard deviations of the target: faint channels get the same tolerance.
  const Eigen::VectorXd deviations = target.diagonal().cwiseMax(0.0).cwiseSqrt();
  const Eigen::VectorXd units = (deviations.array() > 0.0).select(deviations, 1.0);
  const auto inUnits = [&](const MatrixXd& covariance) -> MatrixXd {
    return units.cwiseInverse().asDiagonal() * covariance * units.cwiseInverse().asDiagonal();
  };
  const MatrixXd whole = inUnits(target);
  // Project on the combinations of channels in which the texton varies.
  const MatrixXd range = transport::power(inUnits(noiseCovariance(coefficients, order)), 0.0);
  const MatrixXd wanted = range * whole * range;
  if ((whole - wanted).cwiseAbs().maxCoeff() > kUnreachable)
    return false;
  const std::vector<float> before = coefficients.values;
  auto columns = columnsOf(coefficients);
  for (int round = 0; round < kRounds; ++round) {
    const MatrixXd now = inUnits(noiseCovariance(coefficients, order));
    const MatrixXd map = units.cwiseInverse().asDiagonal() * transport::covarianceMap(now, wanted) *
                         units.asDiagonal();
    columns = (columns.cast<double>() * map).cast<float>().eval();
    for (Eigen::Index c = 0; c < columns.cols(); ++c)
      if (!(deviations[c] > 0.0))
        columns.col(c).setZero(); // clears rounding, which the channel's scale would amplify
  }
  const MatrixXd left = inUnits(noiseCovariance(coefficients, order)) - wanted;
  if (left.cwiseAbs().maxCoeff() <= kTolerance)
    return true;
  coefficients.values = before;
  return false;
}

// Order of a B-spline -> its sampled autocorrelation and the Fourier series of the samples.
//
// Sources: [GLM17] section 4.1 for order 1; [UAE93] for the others.

std::vector<double> kernelAutocorrelation(int order) {
  assert(order >= 0 && order <= 8);
  // [UAE93] eq. 2.3 at integers: the spline of degree m as a sum of one-sided powers.
  const int degree = 2 * order + 1;
  std::vector<double> samples;
  for (int j = 0; j <= order; ++j) {
    double sum = 0.0;
    double coefficient = 1.0; // (-1)^i times the binomial (degree + 1 over i), over degree!
    for (int i = 1; i <= degree; ++i)
      coefficient /= i;
    for (int i = 0; i <= degree + 1; ++i) {
      const double distance = double(j + order + 1 - i);
      if (distance > 0.0)
        sum += coefficient * std::pow(distance, degree);
      coefficient *= -double(degree + 1 - i) / double(i + 1);
    }
    samples.push_back(sum);
  }
  return samples;
}

double kernelPower(int order, double cyclesPerTexel) {
  const std::vector<double> samples = kernelAutocorrelation(order);
  double power = samples[0];
  for (std::size_t j = 1; j < samples.size(); ++j)
    power += 2.0 * samples[j] * std::cos(2.0 * std::numbers::pi * double(j) * cyclesPerTexel);
  return power;
}

std::vector<float> kernelAmplitudes(int order, int size) {
  std::vector<float> amplitudes;
  for (int k = 0; k < size; ++k)
    amplitudes.push_back(float(std::sqrt(kernelPower(order, double(k) / size))));
  return amplitudes;
}

// Texton -> the ratio of the fourth to the squared second moment of its texels.
//
// The kurtosis of the noise follows from Campbell's theorem: the cumulant of order n of a
// renormalised spot noise is sum h^n / intensity^(n / 2 - 1), where intensity = impacts / support.
// Source: [GLM14] section 4.

double flatness(const TextonCoefficients& spot, std::span<const float> weights) {
  assert(weights.size() == std::size_t(spot.channels));
  const std::size_t pixels = std::size_t(spot.width) * std::size_t(spot.height);
  double squares = 0.0;
  double fourths = 0.0;
  for (std::size_t i = 0; i < pixels; ++i) {
    double value = 0.0;
    for (std::size_t c = 0; c < weights.size(); ++c)
      value += double(weights[c]) * double(spot.values[c * pixels + i]);
    squares += value * value;
    fourths += value * value * value * value;
  }
  return squares > 0.0 ? double(pixels) * fourths / (squares * squares) : 0.0;
}

TextonCoefficients interpolatedSpot(const TextonCoefficients& coefficients, int order) {
  if (order < 3)
    return coefficients;
  constexpr std::array<float, 3> kCubic = {1.0f / 6.0f, 4.0f / 6.0f, 1.0f / 6.0f};
  TextonCoefficients spot{
      coefficients.width + 2, coefficients.height + 2, coefficients.channels, {}};
  spot.values.resize(std::size_t(spot.width) * std::size_t(spot.height) *
                     std::size_t(spot.channels));
  const auto at = [](const TextonCoefficients& plane, int x, int y, int c) {
    return (std::size_t(c) * std::size_t(plane.height) + std::size_t(y)) *
               std::size_t(plane.width) +
           std::size_t(x);
  };
  for (int c = 0; c < spot.channels; ++c)
    for (int y = 0; y < coefficients.height; ++y)
      for (int x = 0; x < coefficients.width; ++x)
        for (int k = 0; k < 9; ++k)
          spot.values[at(spot, x + k % 3, y + k / 3, c)] +=
              kCubic[std::size_t(k % 3)] * kCubic[std::size_t(k / 3)] *
              coefficients.values[at(coefficients, x, y, c)];
  return spot;
}

std::vector<float> seenWeights(std::span<const MapChannel> channels) {
  if (channels.front() == MapChannel::red)
    return {kLuminanceWeights.begin(), kLuminanceWeights.end()};
  return std::vector<float>(channels.size(), 1.0f);
}

} // namespace lichen::texton
