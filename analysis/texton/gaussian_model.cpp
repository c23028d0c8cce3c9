// SPDX-License-Identifier: MIT
// Gaussian models (spectra of height x width, one per channel) -> their distance.
//
// A model has one white noise for all channels, so at each frequency the covariance of its channels
// is t t^*, where t is the vector of their transforms. The squared distance between two such
// rank-one matrices is |t|^2 + |h|^2 - 2 |h^* t|, and frequencies are independent.
// Source: [GLM14] eq. 1 and 5.
#include "gaussian_model.h"

#include "coefficients.h"
#include "transport/covariance.h"

#include <lichen/spectrum.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace lichen::texton {
namespace {

/// Returns the sum of `power` over all frequencies of the full plane, divided by the number of
/// pixels. It adds row by row, so that the bytes do not depend on the number of threads.
template <class Power>
double meanPower(const GaussianModel& model, const Power& power) {
  const HalfSpectrum& first = model.channels[0];
  const auto columns = std::size_t(first.columns());
  std::vector<double> rows(std::size_t(first.height), 0.0);
  tbb::parallel_for(std::size_t(0), rows.size(), [&](std::size_t v) {
    for (std::size_t u = 0; u < columns; ++u)
      rows[v] += first.multiplicity(int(u)) * power(v * columns + u);
  });
  return std::accumulate(rows.begin(), rows.end(), 0.0) / double(first.width) /
         double(first.height);
}

} // namespace

HalfSpectrum channelSpectrum(const TextonCoefficients& coefficients, std::size_t channel, int width,
                             int height) {
  const auto columns = std::size_t(coefficients.width), rows = std::size_t(coefficients.height);
  std::vector<float> plane(std::size_t(width) * rows, 0.0f);
  for (std::size_t y = 0; y < rows; ++y)
    std::copy_n(coefficients.values.data() + (channel * rows + y) * columns, columns,
                plane.data() + y * std::size_t(width));
  return forwardFft(plane, width, height);
}

GaussianModel noiseModel(const TextonCoefficients& coefficients, int order, int width, int height) {
  const std::vector<float> kernelX = kernelAmplitudes(order, width);
  const std::vector<float> kernelY = kernelAmplitudes(order, height);
  GaussianModel model;
  for (int c = 0; c < coefficients.channels; ++c) {
    HalfSpectrum spectrum = channelSpectrum(coefficients, std::size_t(c), width, height);
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < spectrum.columns(); ++u)
        spectrum.at(u, v) *= kernelX[std::size_t(u)] * kernelY[std::size_t(v)];
    spectrum.values[0] = 0.0f;
    model.channels.push_back(std::move(spectrum));
  }
  return model;
}

double modelVariance(const GaussianModel& model) {
  return meanPower(model, [&](std::size_t i) {
    double power = 0.0;
    for (const HalfSpectrum& channel : model.channels)
      power += std::norm(std::complex<double>(channel.values[i]));
    return power;
  });
}

double squaredTransportDistance(const GaussianModel& a, const GaussianModel& b) {
  assert(a.width() == b.width() && a.height() == b.height());
  assert(a.channels.size() == b.channels.size());
  const double distance = meanPower(a, [&](std::size_t i) {
    double power = 0.0;
    std::complex<double> product = 0.0;
    for (std::size_t c = 0; c < a.channels.size(); ++c) {
      const std::complex<double> first = a.channels[c].values[i];
      const std::complex<double> second = b.channels[c].values[i];
      power += std::norm(first) + std::norm(second);
      product += std::conj(first) * second;
    }
    return power - 2.0 * std::abs(product);
  });
  return std::max(distance, 0.0); // equal models leave rounding
}

// Image (height, width, channels) -> the transforms of the kernels of its Gaussian texture.
//
// Sources: [GLM17] sections 3.1 and 4.2; [M11].

GaussianModel gaussianModel(std::span<const float> values, int width, int height,
                            int channelCount) {
  const std::size_t pixels = std::size_t(width) * std::size_t(height);
  const auto channels = std::size_t(channelCount);
  assert(width >= 1 && height >= 1 && values.size() == pixels * channels);
  const float scale = 1.0f / std::sqrt(float(pixels));
  GaussianModel model;
  std::vector<float> plane(pixels);
  for (std::size_t c = 0; c < channels; ++c) {
    for (std::size_t i = 0; i < pixels; ++i)
      plane[i] = values[i * channels + c] * scale;
    model.channels.push_back(forwardFft(periodicComponent(plane, width, height), width, height));
    model.channels.back().values[0] = 0.0f; // removes the mean
  }
  return model;
}

// Model (channels, height, width / 2 + 1) -> covariance (channels x channels).

Eigen::MatrixXd modelCovariance(const GaussianModel& model) {
  const auto channels = Eigen::Index(model.channels.size());
  Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(channels, channels);
  const HalfSpectrum& shape = model.channels[0];
  const auto columns = std::size_t(shape.columns());
  for (std::size_t i = 0; i < shape.values.size(); ++i) {
    const double multiplicity = shape.multiplicity(int(i % columns));
    for (Eigen::Index a = 0; a < channels; ++a) {
      const std::complex<double> first = model.channels[std::size_t(a)].values[i];
      for (Eigen::Index b = 0; b <= a; ++b) {
        const std::complex<double> second = model.channels[std::size_t(b)].values[i];
        sum(a, b) += multiplicity * (first * std::conj(second)).real();
      }
    }
  }
  sum.triangularView<Eigen::StrictlyUpper>() = sum.transpose();
  return sum / (double(model.width()) * double(model.height()));
}

bool isModelled(const Eigen::MatrixXd& model, const Eigen::MatrixXd& wanted) {
  constexpr double kNegligible = 1e-3;    // of the largest variance
  constexpr double kLeastModelled = 0.01; // of the wanted variance: a gain of ten
  const auto axes = transport::principalAxes(wanted);
  for (Eigen::Index k = 0; k < axes.eigenvalues().size(); ++k) {
    const double variance = axes.eigenvalues()[k];
    const auto axis = axes.eigenvectors().col(k);
    if (variance > kNegligible * axes.eigenvalues().maxCoeff() &&
        axis.dot(model * axis) < kLeastModelled * variance)
      return false;
  }
  return true;
}

} // namespace lichen::texton
