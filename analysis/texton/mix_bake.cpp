// SPDX-License-Identifier: MIT
// Maps of n exemplars -> a texton noise with a frame for each step between them.
//
// The unit of each quantity is its standard deviation and the same in all exemplars. So the joint
// fit neglects none of a set's maps, and contrasts between exemplars do not change.
// Sources: [GLM17] section 7; docs/decisions/008-textons.md.
#include "exemplar/value_encoding.h"
#include "gaussian_model.h"
#include "joint_exemplar.h"
#include "mixing.h"
#include "texton_table.h"

#include <lichen/texton_mix.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace lichen {
namespace {

using namespace texton;

Error usage(std::string message) { return {ErrorKind::usage, std::move(message)}; }

Result<void> checkOptions(std::size_t exemplars, const TextonMixOptions& options) {
  if (exemplars < 2 || exemplars > kMaxMixedExemplars)
    return usage(
        fmt::format("exemplars to mix: {}; expected 2 to {}", exemplars, kMaxMixedExemplars));
  if (Result<void> checked = checkTextonOptions(options.texton); !checked)
    return checked;
  if (!options.weights.empty())
    return {}; // the fit checks the weights
  const int legs = int(exemplars) - 1;
  const int most = (kMaxTextonSteps - 1) / legs + 1;
  if (options.steps < int(kMixStepsRange.least) || options.steps > most)
    return usage(fmt::format("steps from an exemplar to the next: {}; expected {} to {} for {} "
                             "exemplars, at most {} textons in all",
                             options.steps, kMixStepsRange.least, most, exemplars,
                             kMaxTextonSteps));
  return {};
}

/// Returns the names of a map's channels.
std::string channelsOf(const MapExemplar& map) {
  std::vector<std::string_view> names;
  for (const MapChannel channel : map.channels)
    names.push_back(nameOf(channel));
  return fmt::format("{}", fmt::join(names, ", "));
}

/// Checks that two exemplars have the same maps, channels and encodings.
Result<void> checkAlike(const MixedExemplar& first, const MixedExemplar& other) {
  const auto refuse = [&](const std::string& what) {
    return Error{ErrorKind::badInput,
                 fmt::format("{}: {}; expected the same maps in all exemplars", other.name, what)};
  };
  const auto find = [](const MixedExemplar& exemplar, MapTarget target) {
    return std::find_if(exemplar.maps.begin(), exemplar.maps.end(),
                        [&](const MapExemplar& map) { return map.target == target; });
  };
  for (const MapExemplar& map : first.maps)
    if (find(other, map.target) == other.maps.end())
      return refuse(fmt::format("has no {}, which {} has", nameOf(map.target), first.name));
  for (std::size_t m = 0; m < other.maps.size(); ++m) {
    const MapExemplar& map = other.maps[m];
    const auto same = find(first, map.target);
    if (same == first.maps.end())
      return refuse(fmt::format("has {}, which {} does not have", nameOf(map.target), first.name));
    if (same->channels != map.channels)
      return refuse(fmt::format("{} has {}, in {} it has {}", nameOf(map.target), channelsOf(map),
                                first.name, channelsOf(*same)));
    if (same->encoding != map.encoding)
      return refuse(fmt::format("{} is stored as {}, in {} as {}", nameOf(map.target),
                                nameOf(map.encoding), first.name, nameOf(same->encoding)));
    if (first.maps[m].target != map.target)
      return usage(other.name + ": maps in another order; expected the order of their targets");
  }
  return {};
}

Result<void> checkMaps(std::span<const MixedExemplar> exemplars) {
  for (const MixedExemplar& exemplar : exemplars) {
    if (exemplar.maps.empty())
      return usage(exemplar.name + ": no maps; expected at least one");
    std::set<MapTarget> targets;
    for (const MapExemplar& map : exemplar.maps) {
      if (Result<void> checked = exemplar::checkRanges(map); !checked)
        return checked.error();
      if (!targets.insert(map.target).second)
        return usage(
            fmt::format("{}: two maps of {}; expected one", exemplar.name, nameOf(map.target)));
    }
    if (Result<void> alike = checkAlike(exemplars.front(), exemplar); !alike)
      return alike.error();
  }
  return {};
}

/// Returns the width and height of the largest map along each axis.
std::array<int, 2> sizeOf(const MixedExemplar& exemplar) {
  std::array<int, 2> size{};
  for (const MapExemplar& map : exemplar.maps)
    size = {std::max(size[0], map.width), std::max(size[1], map.height)};
  return size;
}

/// Returns the tile that all exemplars span, as onOneGrid() makes it.
Result<std::array<int, 2>> tileOf(std::span<const MixedExemplar> exemplars) {
  std::array<int, 2> tile{};
  for (const MixedExemplar& exemplar : exemplars)
    tile[0] = std::max(tile[0], sizeOf(exemplar)[0]);
  for (const MixedExemplar& exemplar : exemplars) {
    const auto [width, height] = sizeOf(exemplar);
    const double rows = std::round(double(height) * double(tile[0]) / double(width));
    if (rows > double(kMaxTableSide))
      return Error{ErrorKind::badInput,
                   fmt::format("{}: {} x {} pixels become {} x {:.0f} at the widest exemplar's "
                               "width; expected a height of at most {}",
                               exemplar.name, width, height, tile[0], rows, kMaxTableSide)};
    tile[1] = std::max(tile[1], int(rows));
  }
  return tile;
}

TextonShape shapeOf(const std::array<int, 2>& tile, std::size_t exemplars,
                    const TextonMixOptions& options) {
  const TextonOptions& texton = options.texton;
  TextonShape shape;
  shape.coefficientsX = std::clamp(texton.support - texton.order, 1, tile[0]);
  shape.coefficientsY = std::clamp(texton.support - texton.order, 1, tile[1]);
  shape.order = texton.order;
  shape.mipLevels = shape.mostMipLevels();
  shape.texelsPerTileX = tile[0];
  shape.texelsPerTileY = tile[1];
  if (options.weights.empty())
    shape.steps = int(exemplars - 1) * (options.steps - 1) + 1;
  return shape;
}

Result<void> checkFrames(const TextonShape& shape) {
  const std::uint64_t rows = std::uint64_t(shape.frameHeight()) * std::uint64_t(shape.steps);
  if (rows <= kMaxTableSide)
    return {};
  return usage(fmt::format("{} steps of {} rows each make an image of {}; expected at most {}; "
                           "use fewer steps or a smaller support",
                           shape.steps, shape.frameHeight(), rows, kMaxTableSide));
}

/// Returns one unit per channel for all exemplars: the root mean square of their own units.
Eigen::VectorXd sharedUnits(std::span<const JointExemplar> exemplars) {
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(exemplars.front().units.size());
  for (const JointExemplar& exemplar : exemplars)
    squares += exemplar.units.cwiseAbs2();
  return (squares / double(exemplars.size())).cwiseSqrt();
}

MixExemplar modelled(const std::string& name, JointExemplar exemplar,
                     const Eigen::VectorXd& units) {
  const Eigen::VectorXd ratios = exemplar.units.cwiseQuotient(units);
  const auto channels = std::size_t(exemplar.channels());
  for (std::size_t i = 0; i < exemplar.values.size(); ++i)
    exemplar.values[i] *= float(ratios[Eigen::Index(i % channels)]);
  return {name,
          gaussianModel(exemplar.values, exemplar.width, exemplar.height, exemplar.channels()),
          ratios.asDiagonal() * exemplar.covariance * ratios.asDiagonal()};
}

/// Returns the length of the difference over the root mean square of both lengths.
double relativeDistance(const TextonCoefficients& a, const TextonCoefficients& b) {
  double difference = 0.0, size = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i) {
    const double x = double(a.values[i]), y = double(b.values[i]);
    difference += (x - y) * (x - y);
    size += (x * x + y * y) / 2.0;
  }
  return size > 0.0 ? std::sqrt(difference / size) : 0.0;
}

TextonMixQuality qualityOf(const TextonMix& mix) {
  TextonMixQuality quality;
  quality.channelErrors.resize(mix.steps.front().errors.channels.size(), 0.0);
  for (std::size_t k = 0; k < mix.steps.size(); ++k) {
    const ModelErrors& errors = mix.steps[k].errors;
    quality.modelErrors.push_back(errors.all);
    for (std::size_t c = 0; c < errors.channels.size(); ++c)
      quality.channelErrors[c] = std::max(quality.channelErrors[c], errors.channels[c]);
    quality.rankError = std::max(quality.rankError, mix.steps[k].rankError);
    if (k > 0)
      quality.largestStep = std::max(
          quality.largestStep, relativeDistance(mix.steps[k - 1].texton, mix.steps[k].texton));
  }
  return quality;
}

/// Converts the steps to the units of the maps and adds the mean of each step.
std::vector<TextonOfMaps> inMapUnits(TextonMix mix, std::span<const Eigen::VectorXd> means,
                                     const Eigen::VectorXd& units) {
  std::vector<TextonOfMaps> steps;
  for (MixStep& step : mix.steps) {
    TextonOfMaps& result = steps.emplace_back();
    result.coefficients = inStoredUnits(std::move(step.texton), units);
    result.mean = Eigen::VectorXd::Zero(units.size());
    for (std::size_t k = 0; k < means.size(); ++k)
      result.mean += step.weights[k] * means[k];
  }
  return steps;
}

Result<TextonMix> fitted(std::span<const MixExemplar> exemplars, const TextonShape& shape,
                         const TextonMixOptions& options) {
  FitOptions fit;
  fit.width = shape.coefficientsX;
  fit.height = shape.coefficientsY;
  fit.order = shape.order;
  fit.progress = ProgressPart(options.texton.progress);
  if (!options.weights.empty())
    return fitTextonBarycenter(exemplars, options.weights, fit);
  return fitTextonPath(exemplars, options.steps - 1, fit);
}

Result<TextonMixBake> baked(std::string name, std::span<const MixedExemplar> exemplars,
                            const TextonShape& shape, const TextonMixOptions& options) {
  const std::span<const MapExemplar> maps = exemplars.front().maps;
  std::vector<JointExemplar> joints;
  std::vector<Eigen::VectorXd> means;
  for (const MixedExemplar& exemplar : exemplars) {
    joints.push_back(joinedMaps(exemplar.maps));
    means.push_back(joints.back().mean);
  }
  const Eigen::VectorXd units = sharedUnits(joints);
  std::vector<MixExemplar> models;
  for (std::size_t k = 0; k < exemplars.size(); ++k)
    models.push_back(modelled(exemplars[k].name, std::move(joints[k]), units));
  Result<TextonMix> mix = fitted(models, shape, options);
  if (!mix)
    return mix.error();
  TextonMixBake bake;
  bake.quality = qualityOf(mix.value());
  bake.noise.name = std::move(name);
  bake.noise.data = shape;
  storeMaps(inMapUnits(std::move(mix).value(), means, units), maps, options.texton.bits, bake.noise,
            bake.tables);
  return bake;
}

} // namespace

Result<TextonMixBake> bakeTextonMix(std::string name, std::span<const MixedExemplar> exemplars,
                                    const TextonMixOptions& options) {
  if (Result<void> checked = checkOptions(exemplars.size(), options); !checked)
    return checked.error();
  if (Result<void> checked = checkMaps(exemplars); !checked)
    return checked.error();
  const Result<std::array<int, 2>> tile = tileOf(exemplars);
  if (!tile)
    return tile.error();
  const TextonShape shape = shapeOf(tile.value(), exemplars.size(), options);
  if (Result<void> checked = checkFrames(shape); !checked)
    return checked.error();
  return withinMemory([] { return "not enough memory to fit the textons of a mix"; },
                      [&] { return baked(std::move(name), exemplars, shape, options); });
}

} // namespace lichen
