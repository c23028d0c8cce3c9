// SPDX-License-Identifier: MIT
// Gaussian models (spectra of height x width, one per channel) -> their distance.
//
// A model has one white noise for all channels, so at each frequency the covariance of its channels
// is t t^*, where t is the vector of their transforms. The squared distance between two such
// rank-one matrices is |t|^2 + |h|^2 - 2 |h^* t|, and frequencies are independent.
// Source: [GLM14] eq. 1 and 5.
#include "model_distance.h"

#include "interpolation.h"

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
double meanPower(const gaussian::GaussianModel& model, const Power& power) {
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

gaussian::GaussianModel noiseModel(const TextonCoefficients& coefficients, int order, int width,
                                   int height) {
  const std::vector<float> kernelX = kernelAmplitudes(order, width);
  const std::vector<float> kernelY = kernelAmplitudes(order, height);
  const std::size_t size = std::size_t(coefficients.width) * std::size_t(coefficients.height);
  PatchFft transform(width, height, coefficients.width, coefficients.height);
  gaussian::GaussianModel model;
  for (int c = 0; c < coefficients.channels; ++c) {
    HalfSpectrum spectrum{width, height, {}};
    spectrum.values.resize(std::size_t(spectrum.columns()) * std::size_t(height));
    transform.forward(std::span(coefficients.values).subspan(std::size_t(c) * size, size),
                      spectrum);
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < spectrum.columns(); ++u)
        spectrum.at(u, v) *= kernelX[std::size_t(u)] * kernelY[std::size_t(v)];
    spectrum.values[0] = 0.0f;
    model.channels.push_back(std::move(spectrum));
  }
  return model;
}

double modelVariance(const gaussian::GaussianModel& model) {
  return meanPower(model, [&](std::size_t i) {
    double power = 0.0;
    for (const HalfSpectrum& channel : model.channels)
      power += std::norm(std::complex<double>(channel.values[i]));
    return power;
  });
}

double squaredTransportDistance(const gaussian::GaussianModel& a,
                                const gaussian::GaussianModel& b) {
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

} // namespace lichen::texton
