// SPDX-License-Identifier: MIT
// Spot (channels, height, width) and domain -> noise on the domain (channels, height, width).
//
// The white noise is one process on Z^2, so any part of the noise is available "on demand", as
// [GLM14] section 2.4 asks.
#include "spot_noise.h"

#include <lichen/fft.h>

#include <algorithm>

namespace lichen::gaussian {
namespace {

/// Returns the domain of points whose spots reach `domain`, [GLM14] algorithm 1: `domain` minus the
/// spot's pixels. On a torus this is the torus.
PixelDomain pointDomain(const PixelDomain& domain, const Spot& spot) {
  if (domain.periodic)
    return domain;
  return {domain.x - (spot.width - 1), domain.y - (spot.height - 1), domain.width + spot.width - 1,
          domain.height + spot.height - 1, false};
}

std::span<const float> plane(const Spot& spot, int channel) {
  const std::size_t pixels = std::size_t(spot.width) * std::size_t(spot.height);
  return std::span(spot.values).subspan(std::size_t(channel) * pixels, pixels);
}

std::span<float> plane(NoisePlanes& noise, int channel) {
  const std::size_t pixels = std::size_t(noise.width) * std::size_t(noise.height);
  return std::span(noise.values).subspan(std::size_t(channel) * pixels, pixels);
}

NoisePlanes zeros(const PixelDomain& domain, int channels) {
  NoisePlanes noise{domain.width, domain.height, channels, {}};
  noise.values.assign(
      std::size_t(channels) * std::size_t(domain.width) * std::size_t(domain.height), 0.0f);
  return noise;
}

/// Convolves the spot with a field on its point domain. The transforms are periodic. On a plane of
/// the field's size, the part that wraps falls on pixels outside the domain.
NoisePlanes convolvedBySpectra(const Spot& spot, const std::vector<float>& field,
                               const PixelDomain& points, const PixelDomain& domain) {
  const int width = domain.periodic ? domain.width : fastTransformSize(points.width);
  const int height = domain.periodic ? domain.height : fastTransformSize(points.height);
  const auto at = [columns = std::size_t(width)](int x, int y) {
    return std::size_t(y) * columns + std::size_t(x);
  };
  std::vector<float> padded(std::size_t(width) * std::size_t(height), 0.0f);
  for (int y = 0; y < points.height; ++y)
    std::copy_n(field.data() + std::ptrdiff_t(y) * points.width, points.width,
                padded.data() + std::ptrdiff_t(y) * width);
  const HalfSpectrum fieldSpectrum = forwardFft(padded, width, height);

  const int left = domain.x - points.x;
  const int top = domain.y - points.y;
  NoisePlanes noise = zeros(domain, spot.channels);
  for (int c = 0; c < spot.channels; ++c) {
    padded.assign(padded.size(), 0.0f);
    const std::span<const float> from = plane(spot, c);
    for (int j = 0; j < spot.height; ++j)
      for (int i = 0; i < spot.width; ++i)
        padded[at(i % width, j % height)] +=
            from[std::size_t(j) * std::size_t(spot.width) + std::size_t(i)];
    HalfSpectrum product = forwardFft(padded, width, height);
    for (std::size_t i = 0; i < product.values.size(); ++i)
      product.values[i] *= fieldSpectrum.values[i];
    const std::vector<float> convolved = inverseFft(product);
    const std::span<float> to = plane(noise, c);
    for (int y = 0; y < domain.height; ++y)
      std::copy_n(convolved.data() + at(left, top + y), domain.width,
                  to.data() + std::ptrdiff_t(y) * domain.width);
  }
  return noise;
}

} // namespace

NoisePlanes gaussianSpotNoise(const Spot& spot, const PixelDomain& domain, std::uint64_t seed) {
  const PixelDomain points = pointDomain(domain, spot);
  return convolvedBySpectra(spot, gaussianWhiteNoise(points, seed), points, domain);
}

} // namespace lichen::gaussian
