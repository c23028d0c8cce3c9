// SPDX-License-Identifier: MIT
// Models and covariances of n exemplars -> texton coefficients for each step between them.
//
// Between two exemplars, once their phases are aligned, the barycentres lie on a straight line
// between the two spectra. So one texton is fitted to all exemplars together, with the channels of
// all of them and one phase per frequency. Interpolating two of its parts gives a texton of the
// barycentre there. [GLM17] instead fits each step alone from the same noise, and neighbours end in
// different minima (docs/decisions/008-textons.md lists the errors and step lengths of both).
// Sources: [GLM17] section 7; [XFPA14].
#include "mixing.h"

#include "barycenter.h"
#include "coefficients.h"
#include "gaussian_model.h"
#include "progress_part.h"
#include "transport/covariance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace lichen::texton {
namespace {

using Eigen::MatrixXd;

/// Least variance of a model, relative to the strongest exemplar's. Weaker models are divided by
/// this instead of their own, so that the rounding of a constant exemplar is not fitted as a
/// texture. That rounding is 3e-14 for values in [0, 1]; faint photographs have 1e-3, and one step
/// of 8 bits in a tenth of the pixels has 1e-6.
constexpr double kLeastPower = 1e-8;
/// Share of the progress: the errors of 21 steps take less than a tenth of the time.
constexpr double kFitOfProgress = 0.9;

/// Refuses exemplars that no texton can represent.
Result<void> check(std::span<const MixExemplar> exemplars) {
  for (const MixExemplar& exemplar : exemplars)
    if (!isModelled(modelCovariance(exemplar.model), exemplar.covariance))
      return Error{ErrorKind::badInput,
                   fmt::format("{}: varies only from one border to the other, which no texton "
                               "can reproduce; use a photograph with detail",
                               exemplar.name)};
  return {};
}

/// The options for textons no larger than the model.
FitOptions fitOptions(FitOptions options, const GaussianModel& model,
                      const ProgressPart& progress) {
  options.width = std::min(options.width, model.width());
  options.height = std::min(options.height, model.height());
  options.progress = progress;
  return options;
}

/// Fits textons to aligned models with one phase per frequency, as parts of one joint texton. All
/// models have the same weight, so that low contrast does not count less.
std::vector<TextonCoefficients> fittedTogether(std::span<const GaussianModel> aligned,
                                               const FitOptions& options) {
  std::vector<double> deviations;
  for (const GaussianModel& model : aligned)
    deviations.push_back(std::sqrt(modelVariance(model)));
  const double strongest = *std::max_element(deviations.begin(), deviations.end());
  for (double& deviation : deviations)
    deviation = strongest > 0.0 ? std::max(deviation, std::sqrt(kLeastPower) * strongest) : 1.0;
  GaussianModel joint;
  for (std::size_t k = 0; k < aligned.size(); ++k) {
    for (HalfSpectrum channel : aligned[k].channels) {
      for (std::complex<float>& value : channel.values)
        value /= float(deviations[k]);
      joint.channels.push_back(std::move(channel));
    }
  }
  const TextonCoefficients all = fitCoefficients(joint, options);
  std::vector<TextonCoefficients> result;
  const std::size_t size = all.values.size() / aligned.size();
  for (std::size_t k = 0; k < aligned.size(); ++k) {
    const auto begin = all.values.begin() + std::ptrdiff_t(k * size);
    TextonCoefficients part{all.width,
                            all.height,
                            int(aligned[k].channels.size()),
                            {begin, begin + std::ptrdiff_t(size)}};
    for (float& value : part.values)
      value *= float(deviations[k]);
    result.push_back(std::move(part));
  }
  return result;
}

TextonCoefficients between(const TextonCoefficients& first, const TextonCoefficients& second,
                           double rho) {
  TextonCoefficients result = first;
  for (std::size_t i = 0; i < result.values.size(); ++i)
    result.values[i] = float((1.0 - rho) * first.values[i] + rho * second.values[i]);
  return result;
}

/// Corrects step.texton to the covariance of `model` as far as possible and measures its error, as
/// for every texton. Then corrects it to the covariance of the exemplars' barycentre.
Result<void> finish(std::span<const MixExemplar> exemplars, const GaussianModel& model, int order,
                    MixStep& step) {
  (void)correctCovariance(step.texton, order, modelCovariance(model));
  step.errors = modelErrors(model, step.texton, order);
  std::vector<MatrixXd> covariances;
  for (const MixExemplar& exemplar : exemplars)
    covariances.push_back(exemplar.covariance);
  const MatrixXd wanted = transport::covarianceBarycenter(covariances, step.weights);
  if (correctCovariance(step.texton, order, wanted))
    return {};
  std::vector<std::string> parts;
  for (std::size_t k = 0; k < exemplars.size(); ++k)
    parts.push_back(fmt::format("{:.3g} {}", step.weights[k], exemplars[k].name));
  return Error{ErrorKind::badInput,
               fmt::format("a mix of {}: {} x {} coefficients cannot vary as these colours do; use "
                           "a larger texton, or exemplars with detail",
                           fmt::join(parts, ", "), step.texton.width, step.texton.height)};
}

std::vector<GaussianModel> modelsOf(std::span<const MixExemplar> exemplars) {
  std::vector<GaussianModel> models;
  for (const MixExemplar& exemplar : exemplars)
    models.push_back(exemplar.model);
  return onOneGrid(models);
}

Result<TextonMix> path(std::span<const MixExemplar> exemplars, int stepsPerLeg,
                       const FitOptions& options) {
  const ProgressPart& progress = options.progress;
  const std::vector<GaussianModel> aligned = alignedModels(modelsOf(exemplars));
  const std::vector<TextonCoefficients> textons =
      fittedTogether(aligned, fitOptions(options, aligned[0], progress.part(0.0, kFitOfProgress)));
  TextonMix mix;
  const std::size_t legs = exemplars.size() - 1;
  const auto perLeg = std::size_t(stepsPerLeg);
  for (std::size_t index = 0; index <= legs * perLeg; ++index) {
    const std::size_t leg = std::min(index / perLeg, legs - 1);
    const double rho = double(index - leg * perLeg) / double(perLeg);
    MixStep step{std::vector<double>(exemplars.size(), 0.0),
                 between(textons[leg], textons[leg + 1], rho)};
    step.weights[leg] = 1.0 - rho;
    step.weights[leg + 1] = rho;
    const GaussianModel model = texton::between(aligned[leg], aligned[leg + 1], rho);
    if (Result<void> finished = finish(exemplars, model, options.order, step); !finished)
      return finished.error();
    mix.steps.push_back(std::move(step));
    progress.part(kFitOfProgress, 1.0).reach(double(index + 1) / double(legs * perLeg + 1));
  }
  return mix;
}

Result<TextonMix> single(std::span<const MixExemplar> exemplars, std::vector<double> weights,
                         const FitOptions& options) {
  const Barycenter found = barycenter(modelsOf(exemplars), weights);
  MixStep step{std::move(weights), {}};
  step.rankError = found.rankError;
  step.texton = fitCoefficients(found.model, fitOptions(options, found.model, options.progress));
  if (Result<void> finished = finish(exemplars, found.model, options.order, step); !finished)
    return finished.error();
  TextonMix mix;
  mix.steps.push_back(std::move(step));
  return mix;
}

/// Returns the weights divided by their sum.
Result<std::vector<double>> normalized(std::span<const double> weights, std::size_t exemplars) {
  const auto usage = [](std::string what) { return Error{ErrorKind::usage, std::move(what)}; };
  if (weights.size() != exemplars)
    return usage(fmt::format("weights: {} for {} exemplars; expected one per exemplar",
                             weights.size(), exemplars));
  double sum = 0.0;
  for (const double weight : weights) {
    if (!(weight >= 0.0 && std::isfinite(weight)))
      return usage(fmt::format("a weight of {}; expected 0 or more", weight));
    sum += weight;
  }
  if (!(sum > 0.0 && std::isfinite(sum)))
    return usage(fmt::format("weights of sum {}; expected a sum above 0", sum));
  std::vector<double> result(weights.begin(), weights.end());
  for (double& weight : result)
    weight /= sum;
  return result;
}

} // namespace

Result<TextonMix> fitTextonPath(std::span<const MixExemplar> exemplars, int stepsPerLeg,
                                const FitOptions& options) {
  assert(exemplars.size() >= 2 && stepsPerLeg >= 1);
  if (Result<void> checked = check(exemplars); !checked)
    return checked.error();
  return unlessInterrupted("the mix", [&] { return path(exemplars, stepsPerLeg, options); });
}

Result<TextonMix> fitTextonBarycenter(std::span<const MixExemplar> exemplars,
                                      std::span<const double> weights, const FitOptions& options) {
  Result<std::vector<double>> ofSumOne = normalized(weights, exemplars.size());
  if (!ofSumOne)
    return ofSumOne.error();
  if (Result<void> checked = check(exemplars); !checked)
    return checked.error();
  return unlessInterrupted("the mix",
                           [&] { return single(exemplars, std::move(ofSumOne).value(), options); });
}

} // namespace lichen::texton
