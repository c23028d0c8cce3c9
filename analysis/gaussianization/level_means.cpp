// SPDX-License-Identifier: MIT
// Levels of a table, Gaussian image -> levels whose means over the shader's fetches equal the
// exemplar's.
#include "level_means.h"

#include "prefilter.h"
#include "random_blend.h"
#include "table_lookup.h"

#include <lichen/gaussian_image.h>
#include <lichen/lattice.h>

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace lichen::gaussianization {
namespace {

/// Blended fetches per mean. Independent values of standard deviation 0.3 would give it a standard
/// error of 0.0012; one tap of each is spread evenly over the image, which lowers that.
constexpr std::uint32_t kSamples = 1u << 16u;

/// The level of detail at which fetches lose `loss`, and the factor that gives their values about
/// the mean the deviation of that loss: 1 unless all fetches lose more.
struct FetchLevel {
  float lod = 0.0f;
  float scale = 1.0f;
};

FetchLevel fetchLevelOf(float loss, const std::vector<float>& losses) {
  const float least = losses.front();
  if (loss <= least)
    return {0.0f, least < 1.0f ? std::sqrt((1.0f - loss) / (1.0f - least)) : 1.0f};
  for (std::size_t mip = 1; mip < losses.size(); ++mip)
    if (loss < losses[mip])
      return {float(mip - 1) + (loss - losses[mip - 1]) / (losses[mip] - losses[mip - 1]), 1.0f};
  return {float(losses.size() - 1), 1.0f};
}

/// A blend of fetches at three positions, two of them random.
std::array<float, 3> blendedFetch(const RepeatingImage& image, const FetchLevel& at,
                                  std::uint32_t sample) {
  const auto unit = [](std::uint32_t hash) { return float(hash >> 8u) * 0x1.0p-24f; };
  const std::array<std::uint32_t, 3> x = pcg3d({sample, 0u, 0u});
  const std::array<std::uint32_t, 3> y = pcg3d({sample, 1u, 0u});
  const std::array<float, 3> weights = randomBlendWeights(x[2], y[2]);
  const std::array<std::array<float, 2>, 3> taps{
      {spreadPosition(sample, kSamples), {unit(x[0]), unit(y[0])}, {unit(x[1]), unit(y[1])}}};
  std::array<float, 3> value{0.5f, 0.5f, 0.5f};
  for (std::size_t k = 0; k < 3; ++k) {
    const RepeatingImage::Value tap = image.at(taps[k][0], taps[k][1], at.lod);
    for (std::size_t c = 0; c < 3; ++c)
      value[c] += weights[k] * at.scale * (tap[c] - kStoredGaussianMean);
  }
  return value;
}

template <std::size_t kDimensions>
FetchMoments momentsOfFetches(const InverseTable& table, const RepeatingImage& image,
                              const FetchLevel& at) {
  const TableLookup<kDimensions> lookup(table);
  FetchMoments moments;
  for (std::uint32_t sample = 0; sample < kSamples; ++sample) {
    const TableValue value = lookup(blendedFetch(image, at, sample));
    for (std::size_t c = 0; c < 4; ++c) {
      moments.mean[c] += double(value[c]) / kSamples;
      moments.square[c] += double(value[c]) * double(value[c]) / kSamples;
    }
  }
  return moments;
}

/// The part of the variance of the last level's roots, at its own distance, that counts for their
/// mean light: distant fetches lose more, until they all decode to one colour. The error of the
/// mean is then half that variance at both ends.
constexpr double kShownOfLast = 0.5;

/// What is added to values with this mean and variance so that they, or their squares, have the
/// mean `wanted`.
double shiftTo(double wanted, double mean, double variance, bool isRoot) {
  // E[(v + d)^2] = (E[v] + d)^2 + Var v.
  return (isRoot ? std::sqrt(std::max(0.0, wanted - variance)) : wanted) - mean;
}

} // namespace

FetchMoments fetchMoments(const InverseTable& table, int level, const RepeatingImage& gaussian,
                          const std::vector<float>& losses) {
  const FetchLevel at = fetchLevelOf(float(levelLoss(level)), losses);
  switch (table.dimensions) {
  case 1:
    return momentsOfFetches<1>(table, gaussian, at);
  case 2:
    return momentsOfFetches<2>(table, gaussian, at);
  default:
    return momentsOfFetches<3>(table, gaussian, at);
  }
}

void restoreLevelMeans(std::vector<InverseTable>& levels, bool holdsRoots, const Table& gaussian,
                       const std::vector<float>& losses) {
  const RepeatingImage image(gaussian);
  const InverseTable& exact = levels.front();
  const exemplar::Moments wanted = interpolatedMoments(exact);
  const auto channels = std::size_t(exact.channels);
  tbb::parallel_for(std::size_t(1), levels.size(), [&](std::size_t k) {
    InverseTable& level = levels[k];
    const FetchMoments fetched = fetchMoments(level, int(k), image, losses);
    for (std::size_t c = 0; c < channels; ++c) {
      float low = exact.values[c];
      float high = low;
      for (std::size_t i = c; i < exact.values.size(); i += channels) {
        low = std::min(low, exact.values[i]);
        high = std::max(high, exact.values[i]);
      }
      const auto channel = Eigen::Index(c);
      const double mean = wanted.mean[channel];
      const double target = holdsRoots ? wanted.covariance(channel, channel) + mean * mean : mean;
      const double variance = fetched.square[c] - fetched.mean[c] * fetched.mean[c];
      const double shown = k + 1 < levels.size() ? variance : kShownOfLast * variance;
      const auto shift = float(shiftTo(target, fetched.mean[c], shown, holdsRoots));
      for (std::size_t i = c; i < level.values.size(); i += channels)
        level.values[i] = std::clamp(level.values[i] + shift, low, high);
    }
  });
}

} // namespace lichen::gaussianization
