// SPDX-License-Identifier: MIT
// Maps of an exemplar -> a texton noise: one joint fit, colour correction, and tables with mips.
//
// Sources: [GLM17] section 4, [GLM14]. The contrast of the noise: docs/decisions/008-textons.md.
#include "coefficients.h"
#include "exemplar/value_encoding.h"
#include "fit.h"
#include "gaussian_model.h"
#include "joint_exemplar.h"
#include "progress_part.h"
#include "texton_table.h"

#include <lichen/spectrum.h>
#include <lichen/texton.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lichen {
namespace {

using namespace texton;
using Eigen::MatrixXd;

/// Share of the progress, from the processor time for 512 x 512 pixels.
constexpr double kFitOfProgress = 0.95;

/// Returns weights for all channels: the first map's as the eye sees them, 0 for the others.
std::vector<float> firstMapWeights(const MapExemplar& first, std::size_t channels) {
  std::vector<float> weights = seenWeights(first.channels);
  weights.resize(channels, 0.0f);
  return weights;
}

/// Fits coefficients to the exemplar and corrects them to the covariance of its own
/// model.
TextonCoefficients fitted(const GaussianModel& model, const TextonOptions& options,
                          ProgressPart progress) {
  FitOptions fit;
  fit.width = std::clamp(options.support - options.order, 1, model.width());
  fit.height = std::clamp(options.support - options.order, 1, model.height());
  fit.order = options.order;
  fit.progress = progress;
  TextonCoefficients coefficients = fitCoefficients(model, fit);
  // If the model's range is not the texton's, the covariance stays uncorrected.
  (void)correctCovariance(coefficients, options.order, modelCovariance(model));
  return coefficients;
}

Result<void> check(std::span<const MapExemplar> maps, const TextonOptions& options) {
  const auto usage = [](const std::string& what) { return Error{ErrorKind::usage, what}; };
  if (maps.empty())
    return usage("no maps; expected at least one");
  std::set<MapTarget> targets;
  for (const MapExemplar& map : maps) {
    if (Result<void> checked = exemplar::checkRanges(map); !checked)
      return checked.error();
    if (!targets.insert(map.target).second)
      return usage("two maps of " + std::string(nameOf(map.target)) + "; expected one");
  }
  return checkTextonOptions(options);
}

/// Returns the largest error of a stored covariance, relative to the standard deviations of its two
/// channels.
double covarianceError(const MethodBake& bake, const JointExemplar& joint, const MatrixXd& wanted) {
  const MatrixXd stored = noiseCovariance(storedTexton(bake.noise, bake.noise.maps, bake.tables),
                                          bake.noise.as<TextonShape>().order);
  double worst = 0.0;
  for (Eigen::Index a = 0; a < wanted.rows(); ++a)
    for (Eigen::Index b = 0; b < wanted.cols(); ++b)
      if (const double deviations = std::sqrt(wanted(a, a) * wanted(b, b)); deviations > 0.0) {
        const double inUnits = stored(a, b) / (joint.units[a] * joint.units[b]);
        worst = std::max(worst, std::abs(inUnits - wanted(a, b)) / deviations);
      }
  return worst;
}

TextonShape shapeOf(const JointExemplar& joint, const TextonCoefficients& coefficients, int order) {
  TextonShape shape;
  shape.coefficientsX = coefficients.width;
  shape.coefficientsY = coefficients.height;
  shape.order = order;
  shape.mipLevels = shape.mostMipLevels();
  shape.texelsPerTileX = joint.width;
  shape.texelsPerTileY = joint.height;
  return shape;
}

Result<MethodBake> baked(std::string name, std::span<const MapExemplar> maps,
                         const TextonOptions& options, ProgressPart progress) {
  MethodBake bake;
  JointExemplar joint = joinedMaps(maps);
  const GaussianModel model =
      gaussianModel(joint.values, joint.width, joint.height, joint.channels());
  joint.values = {}; // frees as much memory as the model takes
  const MatrixXd& wanted = joint.covariance;
  if (!isModelled(modelCovariance(model), wanted))
    return Error{ErrorKind::badInput, "the exemplar varies only from one border to the other, "
                                      "which no texton can reproduce; use a photograph with "
                                      "detail, or another method"};
  TextonCoefficients coefficients = fitted(model, options, progress.part(0.0, kFitOfProgress));
  ModelErrors errors = modelErrors(model, coefficients, options.order);
  bake.figures.quality.modelError = errors.all;
  bake.figures.quality.channelErrors = std::move(errors.channels);
  bake.figures.quality.flatness = flatness(interpolatedSpot(coefficients, options.order),
                                           firstMapWeights(maps.front(), model.channels.size()));
  progress.reach(kFitOfProgress);

  if (!correctCovariance(coefficients, options.order, wanted))
    return Error{
        ErrorKind::badInput,
        fmt::format("{} x {} coefficients cannot vary as the exemplar's {} channels do; use a "
                    "larger support, or another method",
                    coefficients.width, coefficients.height, joint.channels())};
  bake.noise.name = std::move(name);
  bake.noise.data = shapeOf(joint, coefficients, options.order);
  const TextonOfMaps whole{inStoredUnits(std::move(coefficients), joint.units), joint.mean};
  storeMaps({&whole, 1}, maps, options.bits, bake.noise, bake.tables);
  bake.figures.quality.covarianceError = covarianceError(bake, joint, wanted);
  progress.reach(1.0);
  return bake;
}

} // namespace

Result<MethodBake> bakeTexton(std::string name, std::span<const MapExemplar> maps,
                              const TextonOptions& options) {
  if (Result<void> checked = check(maps, options); !checked)
    return checked.error();
  const auto exhausted = [] { return "not enough memory to fit a texton"; };
  return withinMemory(exhausted, [&]() -> Result<MethodBake> {
    return unlessInterrupted("the bake", [&]() -> Result<MethodBake> {
      return baked(std::move(name), maps, options, ProgressPart(options.progress));
    });
  });
}

} // namespace lichen
