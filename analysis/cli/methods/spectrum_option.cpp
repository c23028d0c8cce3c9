// SPDX-License-Identifier: MIT
// Text -> rings, bands and lobes, or a picture.
#include "spectrum_option.h"

#include "../srgb_picture.h"
#include "text_parts.h"

#include <algorithm>
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
    return spectrumOf(*parts, most);
  const auto& path = std::get<std::filesystem::path>(choice);
  const Result<SrgbImage> image = readSrgb(path);
  return image ? spectrumOf(image.value(), path.string()) : image.error();
}

Result<void> setSpectrum(const std::optional<SpectrumChoice>& choice,
                         std::span<const MapExemplar> maps,
                         std::optional<SpectrumPicture>& spectrum) {
  if (!choice || maps.empty())
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
