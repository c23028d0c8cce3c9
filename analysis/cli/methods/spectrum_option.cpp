// SPDX-License-Identifier: MIT
// Text -> rings and bands -> amplitudes; or a picture -> its luminance.
#include "spectrum_option.h"

#include <lichen/image_io.h>
#include <lichen/spectrum.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace lichen::cli {
namespace {

constexpr double kMostCycles = 8192.0; // per tile; no exemplar has more

/// "ring:8:12" -> its numbers; nothing unless `name` begins the text and `count` numbers follow.
std::optional<std::vector<double>> numbersAfter(std::string_view name, std::string_view text,
                                                std::size_t count) {
  if (!text.starts_with(name))
    return std::nullopt;
  const Accepted<double> cycles = number({-kMostCycles, kMostCycles});
  std::vector<double> values;
  for (text.remove_prefix(name.size()); !text.empty();) {
    if (text.front() != ':')
      return std::nullopt;
    text.remove_prefix(1);
    const std::string_view word = text.substr(0, text.find(':'));
    const std::optional<double> value = cycles.read(std::string(word));
    if (!value)
      return std::nullopt;
    values.push_back(*value);
    text.remove_prefix(word.size());
  }
  return values.size() == count ? std::make_optional(values) : std::nullopt;
}

std::optional<SpectrumPart> partFrom(std::string_view text) {
  if (const auto ring = numbersAfter("ring", text, 2))
    if ((*ring)[0] >= 0.0 && (*ring)[1] > (*ring)[0])
      return SpectrumRing{(*ring)[0], (*ring)[1]};
  if (const auto band = numbersAfter("band", text, 4))
    if ((*band)[1] >= (*band)[0] && (*band)[3] >= (*band)[2])
      return SpectrumBand{(*band)[0], (*band)[1], (*band)[2], (*band)[3]};
  return std::nullopt;
}

std::optional<std::vector<SpectrumPart>> partsFrom(std::string_view text) {
  std::vector<SpectrumPart> parts;
  for (;;) {
    const std::size_t comma = text.find(',');
    const std::optional<SpectrumPart> part = partFrom(text.substr(0, comma));
    if (!part)
      return std::nullopt;
    parts.push_back(*part);
    if (comma == std::string_view::npos)
      return parts;
    text.remove_prefix(comma + 1);
  }
}

bool holds(const SpectrumRing& ring, double u, double v) {
  const double magnitude = std::hypot(u, v);
  return magnitude >= ring.from && magnitude <= ring.to;
}
bool holds(const SpectrumBand& band, double u, double v) {
  return u >= band.left && u <= band.right && v >= band.top && v <= band.bottom;
}

SpectrumPicture pictureOf(const std::vector<SpectrumPart>& parts, int most) {
  SpectrumPicture picture{2 * most + 1, 2 * most + 1, {}};
  for (int v = -most; v <= most; ++v)
    for (int u = -most; u <= most; ++u) {
      const auto isIn = [&](const SpectrumPart& part) {
        return std::visit([&](const auto& own) { return holds(own, u, v) || holds(own, -u, -v); },
                          part);
      };
      picture.amplitudes.push_back(std::any_of(parts.begin(), parts.end(), isIn) ? 1.0f : 0.0f);
    }
  return picture;
}

} // namespace

Accepted<std::optional<SpectrumChoice>> spectrumChoice() {
  const auto read = [](const std::string& text) -> std::optional<std::optional<SpectrumChoice>> {
    if (const auto parts = partsFrom(text))
      return SpectrumChoice(*parts);
    // What begins like a part is a mistake in it.
    if (text.empty() || text.starts_with("ring:") || text.starts_with("band:"))
      return std::nullopt;
    return SpectrumChoice(std::filesystem::path(text));
  };
  return {"PICTURE|PARTS",
          "a picture, or parts such as ring:8:12 or band:0:2:20:40 with commas between them", read};
}

Result<SpectrumPicture> spectrumPicture(const SpectrumChoice& choice, int most) {
  if (const auto* parts = std::get_if<std::vector<SpectrumPart>>(&choice))
    return pictureOf(*parts, most);
  const auto& path = std::get<std::filesystem::path>(choice);
  Result<ImageFile> file = readImage(path);
  if (!file)
    return file.error();
  const SrgbImage image = std::holds_alternative<SrgbImage>(file.value().pixels)
                              ? std::get<SrgbImage>(std::move(file.value().pixels))
                              : toSrgb(std::get<LinearImage>(file.value().pixels));
  SpectrumPicture picture{image.width, image.height, luminancePlane(image)};
  const std::size_t middle =
      std::size_t(image.height / 2) * std::size_t(image.width) + std::size_t(image.width / 2);
  picture.amplitudes[middle] = 0.0f;
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
