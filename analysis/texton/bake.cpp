// SPDX-License-Identifier: MIT
// Maps of an exemplar -> a texton noise: one joint fit, its colours corrected, stored with mips.
//
// Sources: [GLM17] section 4, [GLM14]. What contrast the noise has: docs/decisions/015-texton.md.
#include "color_correction.h"
#include "comparison.h"
#include "exemplar/resample.h"
#include "fit.h"
#include "model_covariance.h"
#include "progress_part.h"
#include "texton_table.h"
#include "tiling/map_ranges.h"

#include <lichen/spectrum.h>
#include <lichen/texton.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace lichen {
namespace {

using namespace texton;
using Eigen::MatrixXd;

// Of the progress, by processor time of 512 x 512 pixels with their held-out half.
constexpr double kFitOfProgress = 0.6;
constexpr double kHeldOutOfProgress = 0.97;

/// The stored value is the mean plus six deviations a unit, as where other Gaussian values are
/// decoded without a table.
constexpr double kScaleDeviations = 6.0;

/// All maps as one image of `channels` interleaved values a pixel.
struct JointExemplar {
  int width = 0;
  int height = 0;
  std::size_t channels = 0;
  std::vector<float> values;
  Eigen::VectorXd mean; ///< of each map's own pixels
  MatrixXd covariance;  ///< likewise; between maps of different sizes, of the resampled ones
};

MatrixXd covarianceOf(std::span<const float> values, std::size_t channels, Eigen::VectorXd& mean) {
  const Eigen::Map<const Eigen::MatrixXf> all(values.data(), Eigen::Index(channels),
                                              Eigen::Index(values.size() / channels));
  mean = all.cast<double>().rowwise().mean();
  MatrixXd sum = MatrixXd::Zero(all.rows(), all.rows());
  constexpr Eigen::Index kBlock = 4096; // pixels, so that the copy in double stays small
  for (Eigen::Index begin = 0; begin < all.cols(); begin += kBlock) {
    const Eigen::Index count = std::min(kBlock, all.cols() - begin);
    const MatrixXd centred = all.middleCols(begin, count).cast<double>().colwise() - mean;
    sum.noalias() += centred * centred.transpose();
  }
  return sum / double(all.cols());
}

JointExemplar joined(std::span<const MapExemplar> maps) {
  JointExemplar joint;
  for (const MapExemplar& map : maps) {
    joint.width = std::max(joint.width, map.width);
    joint.height = std::max(joint.height, map.height);
    joint.channels += map.channels.size();
  }
  joint.values.resize(std::size_t(joint.width) * std::size_t(joint.height) * joint.channels);
  joint.mean.resize(Eigen::Index(joint.channels));
  Eigen::VectorXd gains = Eigen::VectorXd::Ones(Eigen::Index(joint.channels));
  std::size_t first = 0;
  for (const MapExemplar& map : maps) {
    const std::size_t n = map.channels.size();
    const bool fits = map.width == joint.width && map.height == joint.height;
    const MapExemplar sized =
        fits ? map : exemplar::resampled(map, joint.width, joint.height, false);
    for (std::size_t i = 0; i < sized.values.size(); ++i)
      joint.values[i / n * joint.channels + first + i % n] = sized.values[i];
    Eigen::VectorXd mean, ignored;
    const MatrixXd own = covarianceOf(map.values, n, mean);
    const MatrixXd resized = covarianceOf(sized.values, n, ignored);
    for (Eigen::Index c = 0; c < Eigen::Index(n); ++c) {
      joint.mean[Eigen::Index(first) + c] = mean[c];
      if (resized(c, c) > 0.0)
        gains[Eigen::Index(first) + c] = std::sqrt(own(c, c) / resized(c, c));
    }
    first += n;
  }
  Eigen::VectorXd ignored;
  joint.covariance =
      gains.asDiagonal() * covarianceOf(joint.values, joint.channels, ignored) * gains.asDiagonal();
  return joint;
}

/// Of all channels: those of the first map as an eye sees them.
std::vector<float> firstMapWeights(const MapExemplar& first, std::size_t channels) {
  std::vector<float> weights = seenWeights(first.channels);
  weights.resize(channels, 0.0f);
  return weights;
}

/// The coefficients of a part of the exemplar, corrected to the covariance of its own model.
TextonCoefficients fitted(const GaussianModel& model, const TextonOptions& options,
                          ProgressPart progress) {
  FitOptions fit;
  fit.width = std::clamp(options.support - options.order, 1, model.width());
  fit.height = std::clamp(options.support - options.order, 1, model.height());
  fit.order = options.order;
  fit.seed = options.fitSeed;
  int done = 0;
  const int steps = iterationsOf(fit, FitMethod(options.fit));
  fit.goOn = [&] {
    progress.reach(double(done++) / double(steps));
    return true;
  };
  TextonCoefficients coefficients = fitCoefficients(model, fit, FitMethod(options.fit));
  // Where the model's range is not the texton's, its covariance is as near as it is.
  (void)correctCovariance(coefficients, options.order, modelCovariance(model));
  return coefficients;
}

/// A half of the exemplar along its longer side, the first or the other.
GaussianModel halfModel(const JointExemplar& joint, bool isFirst) {
  const bool isWide = joint.width >= joint.height;
  const int width = isWide ? joint.width / 2 : joint.width;
  const int height = isWide ? joint.height : joint.height / 2;
  const int x0 = isWide && !isFirst ? joint.width - width : 0;
  const int y0 = !isWide && !isFirst ? joint.height - height : 0;
  std::vector<float> values;
  values.reserve(std::size_t(width) * std::size_t(height) * joint.channels);
  for (int y = y0; y < y0 + height; ++y) {
    const auto row = joint.values.begin() +
                     std::ptrdiff_t((std::size_t(y) * std::size_t(joint.width) + std::size_t(x0)) *
                                    joint.channels);
    values.insert(values.end(), row, row + std::ptrdiff_t(std::size_t(width) * joint.channels));
  }
  return gaussianModel(values, width, height, int(joint.channels));
}

std::optional<double> heldOutError(const JointExemplar& joint, const TextonOptions& options,
                                   ProgressPart progress) {
  const int halfSide = std::max(joint.width, joint.height) / 2;
  if (std::min({joint.width, joint.height, halfSide}) < options.support)
    return std::nullopt;
  const TextonCoefficients coefficients = fitted(halfModel(joint, true), options, progress);
  return relativeModelError(halfModel(joint, false), coefficients, options.order);
}

/// One channel's part of a model or of coefficients.
double channelError(const GaussianModel& model, const TextonCoefficients& coefficients, int order,
                    std::size_t channel) {
  const std::size_t texels = coefficients.values.size() / std::size_t(coefficients.channels);
  const auto begin = coefficients.values.begin() + std::ptrdiff_t(channel * texels);
  const TextonCoefficients alone{
      coefficients.width, coefficients.height, 1, {begin, begin + std::ptrdiff_t(texels)}};
  return relativeModelError({{model.channels[channel]}}, alone, order);
}

Result<void> check(std::span<const MapExemplar> maps, const TextonOptions& options) {
  const auto usage = [](const std::string& what) { return Error{ErrorKind::usage, what}; };
  if (maps.empty())
    return usage("no maps; at least one is accepted");
  std::set<MapTarget> targets;
  for (const MapExemplar& map : maps) {
    if (Result<void> checked = tiling::checkRanges(map); !checked)
      return checked.error();
    if (!targets.insert(map.target).second)
      return usage("two maps of " + std::string(nameOf(map.target)) + "; one is accepted");
  }
  if (options.support < int(kTextonSupportRange.least) ||
      options.support > int(kTextonSupportRange.most))
    return usage("support " + std::to_string(options.support) + "; 4 to " +
                 std::to_string(kMaxTextonSide) + " is accepted");
  if (options.order != 0 && options.order != 1 && options.order != 3)
    return usage("order " + std::to_string(options.order) + "; 0, 1 or 3 is accepted");
  if (options.bits != 8 && options.bits != 16)
    return usage(std::to_string(options.bits) + " bits; 8 or 16 is accepted");
  return {};
}

/// The maps of the noise and their tables.
void store(const JointExemplar& joint, std::span<const MapExemplar> maps,
           const TextonCoefficients& coefficients, int bits, TextonBake& bake) {
  const MatrixXd covariance = noiseCovariance(coefficients, bake.noise.texton.order);
  Eigen::Index first = 0;
  for (const MapExemplar& source : maps) {
    const auto n = Eigen::Index(source.channels.size());
    NoiseMap map;
    map.target = source.target;
    map.channels = source.channels;
    map.encoding = source.encoding;
    for (Eigen::Index c = first; c < first + n; ++c) {
      map.mean.push_back(joint.mean[c]);
      map.scale.push_back(kScaleDeviations * std::sqrt(std::max(0.0, covariance(c, c))));
      for (Eigen::Index d = first; d < first + n; ++d)
        map.covariance.push_back(covariance(c, d));
    }
    Table table = textonTable({&coefficients, 1}, bake.noise.texton, std::size_t(first), map.scale,
                              bits == 16 ? 32 : 16);
    table.name = bake.noise.name + "." + std::string(nameOf(map.target)) + ".texton";
    map.mipLoss = mipLosses(table, bake.noise.texton, std::size_t(n));
    map.image = bake.tables.size();
    bake.tables.push_back(std::move(table));
    bake.noise.maps.push_back(std::move(map));
    first += n;
  }
}

Result<TextonBake> baked(std::string name, std::span<const MapExemplar> maps,
                         const TextonOptions& options, ProgressPart progress) {
  const JointExemplar joint = joined(maps);
  const GaussianModel model =
      gaussianModel(joint.values, joint.width, joint.height, int(joint.channels));
  const MatrixXd modelled = modelCovariance(model);
  const MatrixXd wanted =
      options.variance == TextonVariance::exemplar ? joint.covariance : modelled;
  const Error unmodelled{ErrorKind::badInput, "the exemplar varies only from one border to the "
                                              "other, and no texton does; a photograph with "
                                              "detail, or another method, is accepted"};
  if (!isModelled(modelled, wanted))
    return unmodelled;
  TextonCoefficients coefficients = fitted(model, options, progress.part(0.0, kFitOfProgress));

  TextonBake bake;
  bake.quality.modelError = relativeModelError(model, coefficients, options.order);
  for (std::size_t c = 0; c < joint.channels; ++c)
    bake.quality.channelErrors.push_back(channelError(model, coefficients, options.order, c));
  bake.quality.flatness = flatness(interpolatedSpot(coefficients, options.order),
                                   firstMapWeights(maps.front(), joint.channels));
  bake.quality.heldOutError =
      heldOutError(joint, options, progress.part(kFitOfProgress, kHeldOutOfProgress));
  progress.reach(kHeldOutOfProgress);

  if (!correctCovariance(coefficients, options.order, wanted))
    return unmodelled;
  bake.quality.covarianceError = (noiseCovariance(coefficients, options.order) - wanted).norm() /
                                 std::max(wanted.norm(), 1e-30);

  bake.noise.name = std::move(name);
  bake.noise.method = Method::texton;
  TextonShape& shape = bake.noise.texton;
  shape.coefficientsX = coefficients.width;
  shape.coefficientsY = coefficients.height;
  shape.order = options.order;
  shape.mipLevels = shape.mostMipLevels();
  shape.texelsPerTileX = joint.width;
  shape.texelsPerTileY = joint.height;
  store(joint, maps, coefficients, options.bits, bake);
  progress.reach(1.0);
  return bake;
}

} // namespace

Result<TextonBake> bakeTexton(std::string name, std::span<const MapExemplar> maps,
                              const TextonOptions& options) {
  if (Result<void> checked = check(maps, options); !checked)
    return checked.error();
  const auto exhausted = [] { return "not enough memory to fit a texton"; };
  return withinMemory(exhausted, [&]() -> Result<TextonBake> {
    return unlessInterrupted("the bake", [&]() -> Result<TextonBake> {
      return baked(std::move(name), maps, options, ProgressPart(options.progress));
    });
  });
}

} // namespace lichen
