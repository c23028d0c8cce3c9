// SPDX-License-Identifier: MIT
// Checks a texton's texels, within their rounding error: 0 around the coefficients, mip levels that
// average the level above, and the stated covariance and lost variance.
//
// The noise's covariance is sum over k, l of b(k - l) alpha(k) alpha(l)^T, where alpha is scale x
// texels. If texels a and a' have errors of at most e and e', the error of a sum of their products
// is at most sum b (|a| e' + e |a'| + e e'). Source: [GLM17] section 4.1.
#include "texton_format.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>

namespace lichen {
namespace {

/// Relative rounding error of a number written with about seven digits.
constexpr double kTextRounding = 1e-6;

/// The rounding error of a texel: a share of its magnitude, plus the step between the smallest
/// values.
struct Rounding {
  double share = 0.0;
  double least = 0.0;
};

/// Twice the error of one rounding to nearest, because mip levels may be averages of rounded
/// texels.
Rounding roundingOf(TexelFormat format) {
  const bool isHalf = texelBytes(format) == 2 * std::size_t(channelCount(format));
  constexpr double kSumsOfSingles = 4.0; // an average of four adds and divides in single precision
  return isHalf ? Rounding{0x1p-10, 0x1p-24} : Rounding{kSumsOfSingles * 0x1p-23, 0x1p-149};
}

/// Texels of one channel of a frame, row-major; texels outside count as 0. The magnitudes, which
/// bound the rounding errors, are averaged like the values.
struct Plane {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<float> values;
  std::vector<float> magnitudes;
};

double errorOf(float magnitude, const Rounding& rounding) {
  return rounding.share * double(magnitude) + rounding.least;
}

/// Averages of 2 x 2 texels, with 0 beyond the borders.
std::vector<float> halved(std::span<const float> values, std::size_t width, std::size_t height) {
  std::vector<float> half;
  half.reserve((width + 1) / 2 * ((height + 1) / 2));
  for (std::size_t y = 0; y < height; y += 2)
    for (std::size_t x = 0; x < width; x += 2) {
      double sum = 0.0;
      for (std::size_t v = y; v < std::min(y + 2, height); ++v)
        for (std::size_t u = x; u < std::min(x + 2, width); ++u)
          sum += double(values[v * width + u]);
      half.push_back(float(sum / 4.0));
    }
  return half;
}

Plane halved(const Plane& plane) {
  return {(plane.width + 1) / 2, (plane.height + 1) / 2,
          halved(plane.values, plane.width, plane.height),
          halved(plane.magnitudes, plane.width, plane.height)};
}

/// [GLM17] section 4.1: b_j, j = 0 .. order, the B-spline of degree 2 order + 1 at the integers.
std::span<const double> kernelAutocorrelation(int order) {
  static constexpr std::array<double, 1> kBox = {1.0};
  static constexpr std::array<double, 2> kTent = {2.0 / 3.0, 1.0 / 6.0};
  static constexpr std::array<double, 4> kCubic = {151.0 / 315.0, 397.0 / 1680.0, 1.0 / 42.0,
                                                   1.0 / 5040.0};
  if (order == 0)
    return kBox;
  return order == 1 ? std::span<const double>(kTent) : std::span<const double>(kCubic);
}

/// The sum over k, l of b(k - l) p(k) q(l) for two planes of `width` texels per row.
double product(std::span<const float> p, std::span<const float> q, std::size_t width, int order) {
  const std::span<const double> b = kernelAutocorrelation(order);
  const auto reach = std::size_t(order);
  const std::size_t rows = p.size() / width;
  // For one row: weighted sums of p along y, and q padded with zeros.
  std::vector<double> alongY(width), padded(width + 2 * reach);
  double sum = 0.0;
  for (std::size_t y = 0; y < rows; ++y) {
    std::fill(alongY.begin(), alongY.end(), 0.0);
    for (std::size_t j = y - std::min(y, reach); j < std::min(y + reach + 1, rows); ++j) {
      const double weight = b[j < y ? y - j : j - y];
      for (std::size_t x = 0; x < width; ++x)
        alongY[x] += weight * double(p[j * width + x]);
    }
    std::copy_n(q.begin() + std::ptrdiff_t(y * width), width,
                padded.begin() + std::ptrdiff_t(reach));
    for (std::size_t x = 0; x < width; ++x) {
      double alongX = b[0] * padded[x + reach];
      for (std::size_t k = 1; k <= reach; ++k)
        alongX += b[k] * (padded[x + reach - k] + padded[x + reach + k]);
      sum += alongY[x] * alongX;
    }
  }
  return sum;
}

double sumOf(std::span<const float> values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// A sum of products and its rounding error.
struct Moment {
  double value = 0.0;
  double error = 0.0;
};

Moment momentOf(const Plane& p, const Plane& q, int order, const Rounding& rounding) {
  // A texel's error is share |a| + least, and the b add up to 1.
  const auto [share, least] = rounding;
  const double shares = (2.0 + share) * share * product(p.magnitudes, q.magnitudes, p.width, order);
  const double leasts = least * ((1.0 + share) * (sumOf(p.magnitudes) + sumOf(q.magnitudes)) +
                                 least * double(p.values.size()));
  return {product(p.values, q.values, p.width, order), shares + leasts};
}

/// The texton under test, and the reader that records its faults.
struct Texton {
  ObjectReader& reader;
  const TextonShape& shape;
  const NoiseMap& map;
  const TextonMap& data;
  const Table& image;
  Rounding rounding;                      ///< rounding error of the texels
  std::vector<std::vector<float>> levels; ///< decoded mip levels of the image
};

/// Extracts one channel of one step's frame.
Plane planeOf(const Texton& texton, std::size_t step, std::uint32_t level, std::size_t channel) {
  const auto stride = std::size_t(channelCount(texton.image.format));
  Plane plane{texton.shape.frameWidth() >> level, texton.shape.frameHeight() >> level, {}, {}};
  const std::size_t texels = plane.width * plane.height;
  plane.values.resize(texels);
  plane.magnitudes.resize(texels);
  const float* first = &texton.levels[level][step * texels * stride + channel];
  for (std::size_t i = 0; i < texels; ++i) {
    plane.values[i] = first[i * stride];
    plane.magnitudes[i] = std::abs(plane.values[i]);
  }
  return plane;
}

std::string placeOf(std::size_t x, std::size_t y, std::uint32_t level) {
  return "at texel (" + std::to_string(x) + ", " + std::to_string(y) + ") of level " +
         std::to_string(level);
}

std::string text(double value) { return nlohmann::json(value).dump(); }

/// Checks that each frame is 0 outside the coefficients.
bool checkBorders(const Texton& texton) {
  const auto stride = std::size_t(channelCount(texton.image.format));
  for (std::size_t y = 0; y < texton.image.height; ++y)
    for (std::size_t x = 0; x < texton.image.width; ++x) {
      if (x < std::size_t(texton.shape.coefficientsX) &&
          y % texton.shape.frameHeight() < std::size_t(texton.shape.coefficientsY))
        continue;
      const float* texel = &texton.levels[0][(y * texton.image.width + x) * stride];
      for (std::size_t c = 0; c < texton.map.channels.size(); ++c)
        if (texel[c] != 0.0f) {
          texton.reader.error("texton-border", "texton",
                              text(double(texel[c])) + " " + placeOf(x, y, 0) +
                                  ", outside the coefficients; expected 0 there");
          return false;
        }
    }
  return true;
}

/// Checks that each mip level of a channel averages the level above it.
bool checkMips(const Texton& texton, std::size_t step, std::size_t channel) {
  Plane average = planeOf(texton, step, 0, channel);
  for (std::uint32_t level = 1; level < texton.image.mipLevels; ++level) {
    average = halved(average);
    Plane mip = planeOf(texton, step, level, channel);
    for (std::size_t i = 0; i < mip.values.size(); ++i)
      if (std::abs(double(mip.values[i]) - double(average.values[i])) >
          errorOf(mip.magnitudes[i], texton.rounding) +
              errorOf(average.magnitudes[i], texton.rounding)) {
        const std::size_t row = step * mip.height + i / mip.width;
        texton.reader.error("texton-mips", "texton",
                            text(double(mip.values[i])) + " " + placeOf(i % mip.width, row, level) +
                                "; expected the average of those of the level above, " +
                                text(double(average.values[i])));
        return false;
      }
    average = std::move(mip);
  }
  return true;
}

/// Checks that each scale is six times its channel's standard deviation, in a mix the largest of
/// all steps.
void checkScale(const Texton& texton) {
  constexpr double kDeviations = 6.0;
  const std::size_t n = texton.map.channels.size();
  for (std::size_t c = 0; c < n; ++c) {
    double variance = texton.map.covariance[c * n + c];
    for (const TextonStep& step : texton.data.laterSteps)
      variance = std::max(variance, step.covariance[c * n + c]);
    const double wanted = kDeviations * std::sqrt(variance);
    if (std::abs(texton.data.scale[c] - wanted) > kTextRounding * wanted)
      return texton.reader.error("texton-scale", "scale",
                                 text(texton.data.scale[c]) + " at " + std::to_string(c) +
                                     "; expected six times the deviation, " + text(wanted));
  }
}

/// Checks that the noise of a step has the stated covariance.
void checkCovariance(const Texton& texton, std::size_t step,
                     const std::vector<double>& covariance) {
  const std::size_t n = texton.map.channels.size();
  std::vector<Plane> planes;
  for (std::size_t c = 0; c < n; ++c)
    planes.push_back(planeOf(texton, step, 0, c));
  for (std::size_t c = 0; c < n; ++c)
    for (std::size_t d = 0; d <= c; ++d) {
      const Moment moment = momentOf(planes[c], planes[d], texton.shape.order, texton.rounding);
      const double factor = texton.data.scale[c] * texton.data.scale[d];
      const double stated = covariance[c * n + d];
      if (std::abs(factor * moment.value - stated) >
          factor * moment.error + kTextRounding * std::abs(stated))
        return texton.reader.error(
            "texton-covariance", "covariance",
            text(stated) + " of channels " + std::to_string(d) + " and " + std::to_string(c) +
                "; expected that of the texton's noise, " + text(factor * moment.value));
    }
}

/// The share of a channel's variance that remains at each level of averaging. Empty for a constant
/// channel.
std::vector<Moment> keptShares(const Texton& texton, std::size_t step, std::size_t channel,
                               std::size_t levels) {
  Plane plane = planeOf(texton, step, 0, channel);
  const Moment whole = momentOf(plane, plane, texton.shape.order, texton.rounding);
  if (whole.value <= 0.0)
    return {};
  std::vector<Moment> kept{{1.0, 0.0}};
  double texelArea = 1.0;
  for (std::uint32_t level = 1; level < levels; ++level) {
    texelArea *= 4.0;
    plane = level < texton.image.mipLevels ? planeOf(texton, step, level, channel) : halved(plane);
    // Minified textons are interpolated bilinearly, for every order.
    const Moment moment = momentOf(plane, plane, 1, texton.rounding);
    const double share = texelArea * moment.value / whole.value;
    kept.push_back({share, (texelArea * moment.error + share * whole.error) / whole.value});
  }
  return kept;
}

/// Checks a channel's lost variance at each level of averaging, which must never decrease.
bool checkLosses(const Texton& texton, std::size_t step, std::size_t channel,
                 const std::vector<double>& mipLoss) {
  const std::span<const double> stated = lossRow(mipLoss, channel, texton.map.channels.size());
  const std::vector<Moment> kept = keptShares(texton, step, channel, stated.size());
  double loss = 0.0, error = kTextRounding;
  for (std::size_t level = 0; level < stated.size(); ++level) {
    if (!kept.empty()) {
      loss = std::clamp(1.0 - kept[level].value, loss, 1.0);
      error = std::max(error, kept[level].error);
    }
    if (std::abs(loss - stated[level]) > error) {
      texton.reader.error("texton-mip-loss", "mipLoss",
                          text(stated[level]) + " at " +
                              std::to_string(channel * stated.size() + level) +
                              "; expected that of the texton's noise, " + text(loss));
      return false;
    }
  }
  return true;
}

/// Checks the lost variance of all channels of a step. Stops at the first fault.
void checkLosses(const Texton& texton, std::size_t step, const std::vector<double>& mipLoss) {
  for (std::size_t c = 0; c < texton.map.channels.size(); ++c)
    if (!checkLosses(texton, step, c, mipLoss))
      return;
}

} // namespace

void checkTextonTexels(ObjectReader& reader, const TextonShape& shape, const NoiseMap& map,
                       const TextonMap& data, const Table& image) {
  Texton texton{reader, shape, map, data, image, roundingOf(image.format), {}};
  for (std::uint32_t level = 0; level < image.mipLevels; ++level)
    texton.levels.push_back(decodeLevel(image, level));
  if (!checkBorders(texton))
    return;
  for (std::size_t step = 0; step < std::size_t(shape.steps); ++step)
    for (std::size_t c = 0; c < map.channels.size(); ++c)
      if (!checkMips(texton, step, c))
        return;
  checkScale(texton);
  checkCovariance(texton, 0, map.covariance);
  checkLosses(texton, 0, data.mipLoss);
  for (std::size_t k = 0; k < data.laterSteps.size(); ++k) {
    checkCovariance(texton, k + 1, data.laterSteps[k].covariance);
    checkLosses(texton, k + 1, data.laterSteps[k].mipLoss);
  }
}

} // namespace lichen
