// SPDX-License-Identifier: MIT
// Maps (height, width, channels each) -> one image (height, width, all channels) in units.
#include "joint_exemplar.h"

#include "exemplar/resample.h"
#include "exemplar/value_encoding.h"
#include "transport/covariance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

namespace lichen::texton {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

using Moments = transport::Moments<MatrixXd>;

Moments momentsOf(std::span<const float> values, std::size_t channels) {
  return transport::momentsOf<MatrixXd>(
      values.size() / channels, int(channels),
      [&](std::size_t i, int c) { return values[i * channels + std::size_t(c)]; });
}

bool areOneQuantity(MapChannel a, MapChannel b) {
  const auto isColor = [](MapChannel channel) {
    return channel == MapChannel::red || channel == MapChannel::green ||
           channel == MapChannel::blue;
  };
  const auto isSlope = [](MapChannel channel) {
    return channel == MapChannel::slopeX || channel == MapChannel::slopeY;
  };
  return a == b || (isColor(a) && isColor(b)) || (isSlope(a) && isSlope(b));
}

/// Returns the variances of a map's channels, or 0 where only float rounding varies.
VectorXd variancesOf(const Moments& moments) {
  VectorXd variances = moments.covariance.diagonal();
  for (Index c = 0; c < variances.size(); ++c) {
    const double rounding = std::numeric_limits<float>::epsilon() * moments.mean[c];
    if (variances[c] <= rounding * rounding)
      variances[c] = 0.0;
  }
  return variances;
}

/// Returns each channel's unit: the root of the mean variance over the channels of its quantity,
/// and at least the standard deviation of rounding to the file's steps.
VectorXd unitsOf(const MapExemplar& map, const VectorXd& variances) {
  const double roundingVariance = map.quantum * map.quantum / 12.0;
  VectorXd units(variances.size());
  for (Index c = 0; c < units.size(); ++c) {
    double sum = 0.0;
    int count = 0;
    for (Index d = 0; d < units.size(); ++d)
      if (areOneQuantity(map.channels[std::size_t(c)], map.channels[std::size_t(d)])) {
        sum += variances[d];
        ++count;
      }
    units[c] = std::sqrt(std::max(sum / count, roundingVariance));
  }
  return units;
}

} // namespace

JointExemplar joinedMaps(std::span<const MapExemplar> maps) {
  JointExemplar joint;
  Index channels = 0;
  for (const MapExemplar& map : maps) {
    joint.width = std::max(joint.width, map.width);
    joint.height = std::max(joint.height, map.height);
    channels += Index(map.channels.size());
  }
  joint.mean.resize(channels);
  joint.units.resize(channels);
  VectorXd variances(channels);
  const std::size_t pixels = std::size_t(joint.width) * std::size_t(joint.height);
  joint.values.resize(pixels * std::size_t(channels));
  Index first = 0;
  for (const MapExemplar& source : maps) {
    const MapExemplar map = exemplar::asStored(source);
    const auto n = Index(map.channels.size());
    const Moments own = momentsOf(map.values, std::size_t(n));
    joint.mean.segment(first, n) = own.mean;
    joint.units.segment(first, n) = unitsOf(map, variancesOf(own));
    variances.segment(first, n) =
        variancesOf(own).cwiseQuotient(joint.units.segment(first, n).cwiseAbs2());
    std::optional<MapExemplar> resized;
    if (map.width != joint.width || map.height != joint.height)
      resized = exemplar::resampled(map, joint.width, joint.height, false);
    const std::vector<float>& values = resized ? resized->values : map.values;
    for (std::size_t i = 0; i < pixels; ++i)
      for (Index c = 0; c < n; ++c)
        joint.values[i * std::size_t(channels) + std::size_t(first + c)] =
            float((double(values[i * std::size_t(n) + std::size_t(c)]) - own.mean[c]) /
                  joint.units[first + c]);
    first += n;
  }
  joint.covariance = momentsOf(joint.values, std::size_t(channels)).covariance;
  const VectorXd gains = (joint.covariance.diagonal().array() > 0.0)
                             .select(variances.cwiseQuotient(joint.covariance.diagonal()), 0.0)
                             .cwiseSqrt();
  joint.covariance = gains.asDiagonal() * joint.covariance * gains.asDiagonal();
  return joint;
}

Result<void> checkTextonOptions(const TextonOptions& options) {
  const auto usage = [](const std::string& what) { return Error{ErrorKind::usage, what}; };
  if (options.support < int(kTextonSupportRange.least) ||
      options.support > int(kTextonSupportRange.most))
    return usage("support " + std::to_string(options.support) + "; expected 4 to " +
                 std::to_string(kMaxTextonSide));
  if (options.order != 0 && options.order != 1 && options.order != 3)
    return usage("order " + std::to_string(options.order) + "; expected 0, 1 or 3");
  if (options.bits != 8 && options.bits != 16)
    return usage(std::to_string(options.bits) + " bits; expected 8 or 16");
  return {};
}

} // namespace lichen::texton
