// SPDX-License-Identifier: MIT
// The papers' fit of a texton, which the library's is compared with.
#pragma once

#include <lichen/spectrum.h>

#include <cmath>
#include <texton/coefficients.h>
#include <texton/fit.h>

namespace lichen::test {

/// [GLM17] algorithm 1 as printed; for order 0, [GLM14] algorithm 2. 50 projections in [GLM17]
/// section 4.2. Only the phases of white noise's t^* . alpha^ would survive the first projection.
/// They are uniform and independent, and so are those that this starts from.
[[nodiscard]] inline texton::TextonCoefficients papersTexton(const texton::GaussianModel& model,
                                                             const texton::FitOptions& options,
                                                             int projections = 50) {
  const int width = model.width(), height = model.height();
  const std::vector<float> kernelX = texton::kernelAmplitudes(options.order, width);
  const std::vector<float> kernelY = texton::kernelAmplitudes(options.order, height);
  texton::TextonCoefficients coefficients{
      options.width, options.height, int(model.channels.size()), {}};
  std::vector<HalfSpectrum> x;
  for (const HalfSpectrum& channel : model.channels)
    x.push_back(forwardFft(phaseRandomizedPlane(channel, options.seed), width, height));
  for (int step = 0; step < projections; ++step) {
    for (std::size_t c = 0; step > 0 && c < x.size(); ++c)
      x[c] = texton::channelSpectrum(coefficients, c, width, height);
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < x[0].columns(); ++u) {
        std::complex<float> product = 0.0f;
        for (std::size_t c = 0; c < x.size(); ++c)
          product += std::conj(model.channels[c].at(u, v)) * x[c].at(u, v);
        const float modulus = std::abs(product);
        const std::complex<float> phase = modulus > 0.0f ? product / modulus : 1.0f;
        const float kernel = kernelX[std::size_t(u)] * kernelY[std::size_t(v)];
        for (std::size_t c = 0; c < x.size(); ++c)
          x[c].at(u, v) = phase * model.channels[c].at(u, v) / kernel;
      }
    coefficients.values.clear();
    for (const HalfSpectrum& channel : x) {
      const std::vector<float> plane = inverseFft(channel);
      for (int row = 0; row < options.height; ++row)
        coefficients.values.insert(coefficients.values.end(), plane.begin() + row * width,
                                   plane.begin() + row * width + options.width);
    }
  }
  return coefficients;
}

} // namespace lichen::test
