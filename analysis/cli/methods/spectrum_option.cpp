// SPDX-License-Identifier: MIT
// Text -> rings, bands and lobes -> amplitudes; or a picture -> its codes.
#include "spectrum_option.h"

#include "../srgb_picture.h"
#include "text_parts.h"

#include <lichen/spectrum.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace lichen::cli {
namespace {

constexpr double kMostCycles = 8192.0; // per tile; no exemplar has more

std::optional<SpectrumPart> partFrom(std::string_view text) {
  const NumberRange cycles{-kMostCycles, kMostCycles};
  if (const auto ring = numbersAfter("ring", text, cycles, 2))
    if ((*ring)[0] >= 0.0 && (*ring)[1] > (*ring)[0])
      return SpectrumRing{(*ring)[0], (*ring)[1]};
  if (const auto band = numbersAfter("band", text, cycles, 4))
    if ((*band)[1] >= (*band)[0] && (*band)[3] >= (*band)[2])
      return SpectrumBand{(*band)[0], (*band)[1], (*band)[2], (*band)[3]};
  if (const auto lobe = numbersAfter("lobe", text, cycles, 3))
    if ((*lobe)[2] > 0.0)
      return SpectrumLobe{(*lobe)[0], (*lobe)[1], (*lobe)[2]};
  return std::nullopt;
}

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

SpectrumPicture pictureOf(const std::vector<SpectrumPart>& parts, int most) {
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

} // namespace

Accepted<std::optional<SpectrumChoice>> spectrumChoice() {
  const auto read = [](const std::string& text) -> std::optional<std::optional<SpectrumChoice>> {
    if (const auto parts = partsFrom<SpectrumPart>(text, partFrom))
      return SpectrumChoice(*parts);
    // What begins like a part is a mistake in it.
    if (text.empty() || text.starts_with("ring:") || text.starts_with("band:") ||
        text.starts_with("lobe:"))
      return std::nullopt;
    return SpectrumChoice(std::filesystem::path(text));
  };
  return {
      "PICTURE|PARTS",
      "a picture, or parts such as ring:8:12, band:0:2:20:40 or lobe:12:5:3 with commas between "
      "them",
      read};
}

Result<SpectrumPicture> spectrumPicture(const SpectrumChoice& choice, int most) {
  if (const auto* parts = std::get_if<std::vector<SpectrumPart>>(&choice))
    return pictureOf(*parts, most);
  const auto& path = std::get<std::filesystem::path>(choice);
  const Result<SrgbImage> read = readSrgb(path);
  if (!read)
    return read.error();
  const SrgbImage& image = read.value();
  const auto pixels = std::size_t(image.width) * std::size_t(image.height);
  const auto channels = image.values.size() / pixels;
  // Scans of grey have channels that are off by some codes.
  const auto isColored = [&] {
    constexpr float kLeast = 12.0f / 255.0f;
    for (std::size_t i = 0; channels >= 3 && i < image.values.size(); i += channels)
      if (const auto [low, high] =
              std::minmax({image.values[i], image.values[i + 1], image.values[i + 2]});
          high - low > kLeast)
        return true;
    return false;
  };
  SpectrumPicture picture{image.width, image.height, {}};
  if (isColored()) {
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
  if (std::none_of(picture.amplitudes.begin(), picture.amplitudes.end(),
                   [](float amplitude) { return amplitude > 0.0f; }))
    return Error{ErrorKind::badInput,
                 path.string() + ": black everywhere but in the middle, where no frequency lies; "
                                 "expected a spectrum with the frequency 0 in the middle"};
  return picture;
}

Result<void> setSpectrum(const std::optional<SpectrumChoice>& choice,
                         std::span<const MapExemplar> maps,
                         std::optional<SpectrumPicture>& spectrum) {
  if (!choice)
    return {};
  int most = 1; // what the largest map can hold
  for (const MapExemplar& map : maps)
    most = std::max(most, std::max(map.width, map.height) / 2);
  Result<SpectrumPicture> picture = spectrumPicture(*choice, most);
  if (!picture)
    return picture.error();
  spectrum = std::move(picture).value();
  return {};
}

} // namespace lichen::cli
