// SPDX-License-Identifier: MIT
// Order of a B-spline -> its sampled autocorrelation and the Fourier series of the samples.
//
// Sources: [GLM17] section 4.1 for order 1; [UAE93] for the others.
#include "interpolation.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace lichen::texton {

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

} // namespace lichen::texton
