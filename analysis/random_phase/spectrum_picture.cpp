// SPDX-License-Identifier: MIT
// Rings, bands and lobes -> amplitudes; or a picture -> its codes.
#include <lichen/spectrum.h>
#include <lichen/spectrum_picture.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

double amplitudeAt(const SpectrumRing& ring, double u, double v) {
  const double magnitude = std::hypot(u, v);
  return magnitude >= ring.from && magnitude <= ring.to ? 1.0 : 0.0;
}
double amplitudeAt(const SpectrumBand& band, double u, double v) {
  return u >= band.left && u <= band.right && v >= band.top && v <= band.bottom ? 1.0 : 0.0;
}
double amplitudeAt(const SpectrumLobe& lobe, double u, double v) {
  const double distance = std::hypot(u - lobe.u, v - lobe.v) / lobe.radius;
  return std::exp(-0.5 * distance * distance);
}

/// Scans of grey have channels that are off by some codes.
bool isColored(const SrgbImage& image, std::size_t channels) {
  constexpr float kLeast = 12.0f / 255.0f;
  for (std::size_t i = 0; channels >= 3 && i < image.values.size(); i += channels)
    if (const auto [low, high] =
            std::minmax({image.values[i], image.values[i + 1], image.values[i + 2]});
        high - low > kLeast)
      return true;
  return false;
}

} // namespace

SpectrumPicture spectrumOf(std::span<const SpectrumPart> parts, int most) {
  SpectrumPicture picture{2 * most + 1, 2 * most + 1, {}};
  for (int v = -most; v <= most; ++v)
    for (int u = -most; u <= most; ++u) {
      double amplitude = 0.0;
      for (const SpectrumPart& part : parts)
        amplitude = std::max(amplitude, std::visit(
                                            [&](const auto& own) {
                                              return std::max(amplitudeAt(own, u, v),
                                                              amplitudeAt(own, -u, -v));
                                            },
                                            part));
      picture.amplitudes.push_back(float(amplitude));
    }
  return picture;
}

Result<SpectrumPicture> spectrumOf(const SrgbImage& image, const std::string& name) {
  const auto pixels = std::size_t(image.width) * std::size_t(image.height);
  const auto channels = image.values.size() / pixels;
  SpectrumPicture picture{image.width, image.height, {}};
  if (isColored(image, channels)) {
    picture.channels = 3;
    for (std::size_t i = 0; i < image.values.size(); i += channels)
      picture.amplitudes.insert(picture.amplitudes.end(), &image.values[i], &image.values[i] + 3);
  } else {
    picture.amplitudes = luminancePlane(image);
  }
  const std::size_t middle =
      std::size_t(image.height / 2) * std::size_t(image.width) + std::size_t(image.width / 2);
  for (int c = 0; c < picture.channels; ++c)
    picture.amplitudes[std::size_t(picture.channels) * middle + std::size_t(c)] = 0.0f;
  if (std::ranges::none_of(picture.amplitudes, [](float amplitude) { return amplitude > 0.0f; }))
    return Error{ErrorKind::badInput,
                 name + ": black everywhere but in the middle, where no frequency lies; "
                        "expected a spectrum with the frequency 0 in the middle"};
  return picture;
}

} // namespace lichen
