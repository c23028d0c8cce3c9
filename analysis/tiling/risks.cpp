// SPDX-License-Identifier: MIT
// One map -> its risks, in a fixed order. Thresholds: docs/decisions/007-verdicts.md.
#include "exemplar/grain.h"
#include "exemplar/low_pass.h"
#include "progress_part.h"
#include "suitability/color_measures.h"
#include "suitability/gaussian_plane.h"
#include "suitability/picture_measures.h"
#include "suitability/risk_of.h"
#include "suitability/spectral_measures.h"

#include <lichen/exemplar_repair.h>
#include <lichen/suitability.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lichen {
namespace {

using namespace suitability;
using exemplar::edgeConcentration;
using exemplar::kEdgeConcentration;
using exemplar::kShortestLight;

// Parts of the progress, from the time of each step on 1024 x 1024 pixels.
constexpr double kSlopesOfProgress = 0.4;
constexpr double kPlaneOfProgress = 0.5;
constexpr double kTransformOfProgress = 0.55;
constexpr double kLatticeOfProgress = 0.4; // part of structureRisk

/// Whether flattening helps against slow variation in a map.
enum class SlowCause {
  light,  ///< uneven light or cloudiness: flattening helps
  object, ///< flattening leaves the outline
};

/// Advised periods, as a share of the longer side. The longest leaves 1 - 2^(-1/9), a fourteenth,
/// of a wave as long as that side (1 - lowPassGain()).
constexpr double kLongestAdvisedPeriod = 1.0 / 3.0;

/// The slow variation in a map.
struct SlowPart {
  SlowCause cause = SlowCause::light;
  double firstPixels = 1.0; ///< as in assessSuitability()
};

/// The flattening that helps, if any: a period that is a share of the longer side. Opacity is never
/// flattened.
std::vector<BakeSetting> flattening(const MapExemplar& map, const SlowPart& slow, double share) {
  if (slow.cause == SlowCause::object || map.target == MapTarget::opacity)
    return {};
  const double period = share * std::max(map.width, map.height) * slow.firstPixels;
  const double pixels = std::clamp(period, kFlattenPeriodRange.least, kFlattenPeriodRange.most);
  return {{"flatten", std::to_string(std::lround(pixels))}};
}

/// The transform of the Gaussian plane; a single value if there is no plane.
HalfSpectrum spectrumOf(const std::optional<GaussianPlane>& plane) {
  return plane ? forwardFft(plane->values, plane->width, plane->height)
               : HalfSpectrum{1, 1, {0.0f}};
}

Risk cloudinessRisk(const MapExemplar& map, const HalfSpectrum& spectrum, const SlowPart& slow) {
  const double measured = cloudiness(spectrum);
  // Slow variation can be removed, a lattice cannot: find out which one causes the clouds.
  const int side = std::max(spectrum.width, spectrum.height);
  const auto flattensBy = [&](double share) {
    return cloudiness(spectrum, share * side) < kCloudiness.mild;
  };
  double share = kLongestAdvisedPeriod;
  while (share > kShortestLight && !flattensBy(share))
    share = std::max(share / std::numbers::sqrt2, kShortestLight);
  return riskOf("cloudiness", scoreOf(measured, kCloudiness),
                "the contrast will vary by " + percent(measured) + " across the noise",
                "depending on which tiles are blended",
                {flattensBy(share) ? flattening(map, slow, share) : std::vector<BakeSetting>{},
                 "a photograph that varies less over large distances"});
}

Risk fewColorsRisk(const FewColors& few) {
  return riskOf(
      "structure", scoreOf(few.spacing, kColorSpacing),
      "the image has only " + std::to_string(std::max(2L, std::lround(few.count))) +
          " colours and almost nothing between them",
      "so outlines will be ragged",
      {{},
       "a photograph with gradual colours; an image that tiles can be repeated as a plain "
       "texture instead"});
}

Risk structureRisk(const HalfSpectrum& spectrum, const FewColors& few, ProgressPart progress) {
  const double lattice = latticeShare(spectrum);
  progress.reach(kLatticeOfProgress);
  const double coherence = phaseCoherence(spectrum);
  const double latticeScore = scoreOf(lattice, kLatticeShare);
  const double coherenceScore = scoreOf(coherence, kPhaseCoherence);
  if (scoreOf(few.spacing, kColorSpacing) > std::max(latticeScore, coherenceScore))
    return fewColorsRisk(few);
  const std::string consequence = "which random blending breaks into pieces";
  const std::string advice = "a photograph without joints, letters or a regular pattern; an image "
                             "that tiles can be repeated as a plain texture instead";
  const Remedy remedy{{{"method", "quilting"}}, advice};
  if (latticeScore > coherenceScore)
    return riskOf("structure", latticeScore,
                  percent(lattice) + " of the variation repeats regularly", consequence, remedy);
  return riskOf("structure", coherenceScore,
                "outlines, such as joints and letters, are " + percent(coherence) + " coherent",
                consequence, remedy);
}

/// `seen` is the map, or its slopes if those are what shows.
Risk lowFrequencyRisk(const MapExemplar& map, const MapExemplar& seen, const SlowPart& slow) {
  const double measured = slowVariationShare(seen);
  // Peak to peak of a wave with that standard deviation.
  const double difference = 2.0 * std::sqrt(2.0) * measured;
  return riskOf(
      "low-frequency", scoreOf(measured, kSlowVariation),
      "one side or part of the image differs from the rest by " + percent(difference) +
          " of the full range",
      "which will show as patches",
      slow.cause == SlowCause::object
          ? Remedy{{}, "a photograph with many such objects, or a crop without the object"}
          : Remedy{flattening(map, slow, kLongestAdvisedPeriod), "even light"});
}

Risk clippingRisk(const MapExemplar& map, const FewColors& few) {
  if (few.spacing >= kColorSpacing.mild) // then black and white are not a fault of the exposure
    return riskOf("clipping", 0.0, "the image has few colours", {}, {});
  const ClippedShare clipped = clippedShare(map);
  return riskOf("clipping", scoreOf(clipped.white + clipped.black, kClippedShare),
                percent(clipped.white) + " of the pixels are white and " + percent(clipped.black) +
                    " black",
                "without detail",
                {{},
                 clipped.white > clipped.black ? "a photograph with less exposure"
                                               : "a photograph with more exposure"});
}

Risk unevenScaleRisk(const MapExemplar& map) {
  const double octaves = unevenScale(map);
  return riskOf("uneven-scale", scoreOf(octaves, kUnevenScale),
                fmt::format("fine detail is {:.1f} times as strong at one side as at the other",
                            std::exp2(0.5 * octaves)),
                "as in a slanted or partly blurred photograph, so near and far will mix",
                {{}, "a photograph from straight in front, in focus everywhere"});
}

/// Cloudiness and low frequency; `seen` is the map, or its slopes if light shows these.
std::vector<Risk> slowRisks(const MapExemplar& map, const MapExemplar& seen,
                            const HalfSpectrum& spectrum, bool periodic, double firstPixels) {
  const bool isRisk =
      slowVariationShare(seen) >= kSlowVariation.mild || cloudiness(spectrum) >= kCloudiness.mild;
  const SlowCause cause = isRisk && edgeConcentration(map, periodic) > kEdgeConcentration
                              ? SlowCause::object
                              : SlowCause::light;
  const SlowPart slow{cause, firstPixels};
  return {cloudinessRisk(map, spectrum, slow), lowFrequencyRisk(map, seen, slow)};
}

/// The same for a height map, measured on its slopes, which lighting shows.
std::vector<Risk> slopeRisks(const MapExemplar& height, gaussian::BorderTreatment borders,
                             double firstPixels, ProgressPart progress) {
  const MapExemplar slopes = slopesOfHeight(height, borders.fit);
  const std::optional<GaussianPlane> plane = gaussianPlane(slopes, borders, progress);
  return slowRisks(height, slopes, spectrumOf(plane), borders.fit, firstPixels);
}

std::vector<Risk> risksOf(const MapExemplar& map, gaussian::BorderTreatment borders,
                          double firstPixels, ProgressPart progress) {
  const bool isHeight = map.target == MapTarget::height;
  const ProgressPart first = isHeight ? progress.part(0.0, kSlopesOfProgress) : ProgressPart();
  const ProgressPart rest = isHeight ? progress.part(kSlopesOfProgress, 1.0) : progress;
  std::vector<Risk> risks;
  if (isHeight)
    risks = slopeRisks(map, borders, firstPixels, first);
  const std::optional<GaussianPlane> plane =
      gaussianPlane(map, borders, rest.part(0.0, kPlaneOfProgress));
  rest.reach(kPlaneOfProgress);
  const HalfSpectrum spectrum = spectrumOf(plane);
  rest.reach(kTransformOfProgress);
  if (!isHeight)
    risks = slowRisks(map, map, spectrum, borders.fit, firstPixels);
  const FewColors few = fewColors(map);
  risks.insert(risks.begin() + 1,
               structureRisk(spectrum, few, rest.part(kTransformOfProgress, 1.0)));
  // A material of one colour may well be white.
  risks.push_back(plane ? clippingRisk(map, few)
                        : riskOf("clipping", 0.0, "the image has one colour", {}, {}));
  risks.push_back(unevenScaleRisk(map));
  return risks;
}

} // namespace

Result<std::vector<Risk>> assessSuitability(const MapExemplar& map, bool periodic,
                                            const Progress& progress, double firstPixels,
                                            std::optional<Grain> grain) {
  return assessed(map, [&] {
    return risksOf(map, {periodic, grain ? *grain : exemplar::grainOf(map)}, firstPixels,
                   ProgressPart(progress));
  });
}

} // namespace lichen
