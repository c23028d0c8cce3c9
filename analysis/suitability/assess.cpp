// SPDX-License-Identifier: MIT
// One map -> its risks, in a fixed order. Thresholds: docs/decisions/013-suitability.md.
#include "calibration.h"
#include "clipped_share.h"
#include "cloudiness.h"
#include "few_colors.h"
#include "gaussian_plane.h"
#include "lattice_share.h"
#include "phase_coherence.h"
#include "slow_variation.h"
#include "tiling/map_ranges.h"

#include <lichen/suitability.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

using namespace suitability;

std::string percent(double share) { return std::to_string(std::lround(100.0 * share)) + " %"; }

/// What is measured is said of every exemplar, what comes of it where it is a risk.
Risk risk(std::string_view name, double score, std::string measured, const std::string& consequence,
          std::string remedy) {
  if (score < kMildScore)
    return {name, score, Risk::Level::none, std::move(measured), {}};
  return {name, score, score < kSevereScore ? Risk::Level::mild : Risk::Level::severe,
          measured + ", " + consequence, std::move(remedy)};
}

/// --flatten auto goes by the base colour; a period can be given for every map.
std::string flattenOption(const MapExemplar& map) {
  return map.target == MapTarget::baseColor ? "--flatten auto" : "--flatten PERIOD";
}

Risk cloudinessRisk(const MapExemplar& map, const HalfSpectrum& spectrum) {
  const double measured = cloudiness(spectrum);
  // Whether it is slow variation that clouds, which can be removed, or a lattice, which cannot.
  const int side = std::max(spectrum.width, spectrum.height);
  const bool flattens = cloudinessAbove(spectrum, kShortestAutoPeriod * side) < kCloudiness.mild;
  const std::string photograph = "a photograph that varies less over large distances";
  return risk("cloudiness", scoreOf(measured, kCloudiness),
              "the contrast will vary by " + percent(measured) + " from place to place",
              "with what is blended there by chance",
              flattens ? flattenOption(map) + ", or " + photograph : photograph);
}

Risk fewColorsRisk(const FewColors& few) {
  return risk("structure", scoreOf(few.spacing, kColorSpacing),
              "the image has only " + std::to_string(std::max(2L, std::lround(few.count))) +
                  " colours, with next to nothing between them",
              "whose outlines come out ragged",
              "a photograph, whose colours pass into one another, or repeating this image");
}

Risk structureRisk(const HalfSpectrum& spectrum, const FewColors& few) {
  const double lattice = latticeShare(spectrum);
  const double coherence = phaseCoherence(spectrum);
  const double latticeScore = scoreOf(lattice, kLatticeShare);
  const double coherenceScore = scoreOf(coherence, kPhaseCoherence);
  if (scoreOf(few.spacing, kColorSpacing) > std::max(latticeScore, coherenceScore))
    return fewColorsRisk(few);
  const std::string consequence = "which random blending breaks into pieces";
  const std::string remedy =
      "a photograph without joints, letters or a regular pattern, or repeating this one";
  if (latticeScore > coherenceScore)
    return risk("structure", latticeScore,
                percent(lattice) + " of the variation repeats at even steps", consequence, remedy);
  return risk("structure", coherenceScore,
              "outlines, as joints and letters have, are coherent to " + percent(coherence),
              consequence, remedy);
}

/// Of the values that a map has nominally: 8-bit normals have components in [-1, 1], and light
/// above 1 has no limit but its own.
double spanOf(const MapExemplar& map) {
  switch (map.encoding) {
  case ValueEncoding::srgb:
  case ValueEncoding::linear:
    break;
  case ValueEncoding::slope:
    return 2.0;
  case ValueEncoding::log2:
    return std::max(1.0, double(*std::max_element(map.values.begin(), map.values.end())));
  }
  return 1.0;
}

Risk lowFrequencyRisk(const MapExemplar& map) {
  const double measured = slowVariation(map) / spanOf(map);
  // Peak to peak of a wave of that deviation.
  const double difference = 2.0 * std::sqrt(2.0) * measured;
  return risk("low-frequency", scoreOf(measured, kSlowVariation),
              "one side or part of the image differs from the rest by " + percent(difference) +
                  " of the full range",
              "which will show as patches",
              flattenOption(map) + ", even light, or a crop without the one large object");
}

Risk clippingRisk(const MapExemplar& map, const FewColors& few) {
  if (few.spacing >= kColorSpacing.mild) // black and white among them are no fault of exposure
    return risk("clipping", 0.0, "the image has few colours", {}, {});
  const ClippedShare clipped = clippedShare(map);
  return risk("clipping", scoreOf(clipped.white + clipped.black, kClippedShare),
              percent(clipped.white) + " of the pixels are white and " + percent(clipped.black) +
                  " black",
              "without detail",
              clipped.white > clipped.black ? "a photograph with less exposure"
                                            : "a photograph with more exposure");
}

std::vector<Risk> risksOf(const MapExemplar& map, bool periodic) {
  const std::optional<GaussianPlane> plane = gaussianPlane(map, periodic);
  const HalfSpectrum spectrum =
      plane ? forwardFft(plane->values, plane->width, plane->height) : HalfSpectrum{1, 1, {0.0f}};
  const FewColors few = fewColors(map);
  std::vector<Risk> risks{cloudinessRisk(map, spectrum), structureRisk(spectrum, few),
                          lowFrequencyRisk(map)};
  // One colour may well be white.
  risks.push_back(plane ? clippingRisk(map, few)
                        : risk("clipping", 0.0, "the image has one colour", {}, {}));
  return risks;
}

} // namespace

std::string_view nameOf(Risk::Level level) {
  switch (level) {
  case Risk::Level::none:
    return "none";
  case Risk::Level::mild:
    return "mild";
  case Risk::Level::severe:
    break;
  }
  return "severe";
}

Result<std::vector<Risk>> assessSuitability(const MapExemplar& map, bool periodic) {
  const auto exhausted = [&] {
    return "not enough memory to assess " + std::to_string(map.width) + " x " +
           std::to_string(map.height) + " pixels";
  };
  return withinMemory(exhausted, [&]() -> Result<std::vector<Risk>> {
    if (Result<void> checked = tiling::checkRanges(map); !checked)
      return checked.error();
    return risksOf(map, periodic);
  });
}

} // namespace lichen
