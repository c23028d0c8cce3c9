// SPDX-License-Identifier: MIT
// Text -> waves and splines; or a picture -> its cosines.
#include "multiple_kernels_pattern.h"

#include "../srgb_picture.h"
#include "text_parts.h"

#include <lichen/pattern.h>

#include <cmath>
#include <string_view>

namespace lichen::cli {
namespace {

constexpr NumberRange kNumbers{-512.0, 512.0}; // whole cycles per tile, and values
constexpr std::size_t kMostPoints = 32;        // that a spline has
constexpr int kMostRepeats = 64;               // that a picture has along each axis of a tile

bool isWhole(double value) { return value == std::floor(value); }

/// Whether numbers begin with a frequency.
bool isFrequency(const std::vector<double>& numbers) {
  return isWhole(numbers[0]) && isWhole(numbers[1]) && (numbers[0] != 0.0 || numbers[1] != 0.0);
}

std::optional<PatternPart> partFrom(std::string_view text) {
  if (const auto wave = numbersAfter("wave", text, kNumbers, 2, 4); wave && isFrequency(*wave))
    return PatternPart{{int((*wave)[0]), int((*wave)[1]), wave->size() > 2 ? (*wave)[2] : 1.0,
                        wave->size() > 3 ? (*wave)[3] : 0.0}};
  if (const auto spline = numbersAfter("spline", text, kNumbers, 4, 2 + kMostPoints);
      spline && isFrequency(*spline))
    return patternOfSpline(int((*spline)[0]), int((*spline)[1]),
                           std::span<const double>(*spline).subspan(2));
  return std::nullopt;
}

std::optional<StrongestWaves> strongestFrom(std::string_view text) {
  const auto count = numbersAfter("cosines", text, {1.0, double(kMostPatternCosines)}, 1);
  if (!count || !isWhole(count->front()))
    return std::nullopt;
  return StrongestWaves{int(count->front())};
}

/// "dot.png" or "dot.png:8"; nothing if the number after the last colon is out of range.
std::optional<PatternPicture> pictureFrom(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos ||
      text.find_first_not_of("0123456789", colon + 1) != std::string::npos)
    return PatternPicture{text};
  const std::optional<int> repeats = wholeNumber(1, kMostRepeats).read(text.substr(colon + 1));
  return repeats ? std::optional(PatternPicture{text.substr(0, colon), *repeats}) : std::nullopt;
}

} // namespace

Accepted<std::optional<PatternChoice>> patternChoice() {
  const auto read = [](const std::string& text) -> std::optional<std::optional<PatternChoice>> {
    if (const auto strongest = strongestFrom(text))
      return PatternChoice(*strongest);
    if (const auto parts = partsFrom<PatternPart>(text, partFrom))
      return PatternChoice(*parts);
    // What begins like a part is a mistake in it.
    if (text.empty() || text.starts_with("cosines:") || text.starts_with("wave:") ||
        text.starts_with("spline:"))
      return std::nullopt;
    if (const auto picture = pictureFrom(text))
      return PatternChoice(*picture);
    return std::nullopt;
  };
  return {"cosines:N|PARTS|PICTURE[:N]",
          "cosines:N with N from 1 to " + std::to_string(kMostPatternCosines) +
              ", parts such as wave:8:0 or spline:0:4:1:0:0.5 with commas between them and whole "
              "cycles per tile, or a picture, which a number from 1 to " +
              std::to_string(kMostRepeats) + " after a colon repeats",
          read};
}

Result<Perturbation> perturbationOf(const PatternChoice& choice, double amount) {
  Perturbation perturbation;
  perturbation.amount = amount;
  if (const auto* strongest = std::get_if<StrongestWaves>(&choice)) {
    perturbation.cosines = strongest->cosines;
    return perturbation;
  }
  perturbation.cosines = kMostPatternCosines;
  if (const auto* parts = std::get_if<std::vector<PatternPart>>(&choice)) {
    for (const PatternPart& part : *parts)
      perturbation.pattern.insert(perturbation.pattern.end(), part.begin(), part.end());
  } else {
    const auto& [path, repeats] = std::get<PatternPicture>(choice);
    Result<SrgbImage> picture = readSrgb(path);
    if (!picture)
      return picture.error();
    perturbation.pattern = patternOf(picture.value(), repeats, perturbation.cosines);
  }
  return perturbation;
}

} // namespace lichen::cli
