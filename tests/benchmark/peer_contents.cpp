// SPDX-License-Identifier: MIT
#include "peer_contents.h"

#include "gaussian/gaussian_distribution.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace lichen::bench {
namespace {

/// Values of three channels, texel by texel.
using Texels = std::vector<std::array<double, 3>>;

void append(std::vector<std::byte>& bytes, const std::array<double, 3>& color) {
  for (const double value : color)
    bytes.push_back(std::byte(std::lround(255.0 * std::clamp(value, 0.0, 1.0))));
  bytes.push_back(std::byte{255});
}

/// All mip levels of a square image, by averages of 2 x 2.
std::vector<Texels> mipLevels(Texels image, std::size_t side) {
  std::vector<Texels> levels{std::move(image)};
  for (; side > 1; side /= 2) {
    const Texels& fine = levels.back();
    Texels coarse;
    for (std::size_t y = 0; y < side; y += 2)
      for (std::size_t x = 0; x < side; x += 2) {
        const auto* top = &fine[y * side + x];
        const auto* bottom = top + side;
        std::array<double, 3> mean{};
        for (std::size_t c = 0; c < 3; ++c)
          mean[c] = 0.25 * (top[0][c] + top[1][c] + bottom[0][c] + bottom[1][c]);
        coarse.push_back(mean);
      }
    levels.push_back(std::move(coarse));
  }
  return levels;
}

PeerTexels stored(const std::vector<Texels>& levels, std::size_t side) {
  PeerTexels image{std::uint32_t(side), std::uint32_t(side), 1, std::uint32_t(levels.size()), {}};
  for (const Texels& level : levels)
    for (const auto& color : level)
      append(image.texels, color);
  return image;
}

/// One channel: its values in ascending order, which are its quantiles.
class Quantiles {
public:
  explicit Quantiles(std::vector<double> values) : ascending_(std::move(values)) {
    std::sort(ascending_.begin(), ascending_.end());
  }
  /// `u` in [0, 1].
  [[nodiscard]] double at(double u) const {
    const auto rank = std::size_t(u * double(ascending_.size()));
    return ascending_[std::min(rank, ascending_.size() - 1)];
  }

private:
  std::vector<double> ascending_;
};

/// An image whose channels are Gaussian, and what leads back from it.
struct Gaussianized {
  Texels image;
  std::vector<Quantiles> quantiles; ///< one per channel
};

Gaussianized gaussianized(const Texels& image) {
  Gaussianized result{Texels(image.size()), {}};
  for (std::size_t c = 0; c < 3; ++c) {
    std::vector<std::size_t> order(image.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return image[a][c] < image[b][c]; });
    std::vector<double> values;
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
      values.push_back(image[order[rank]][c]);
      result.image[order[rank]][c] =
          gaussian::gaussianQuantile((double(rank) + 0.5) / double(order.size()));
    }
    result.quantiles.emplace_back(std::move(values));
  }
  return result;
}

PeerTexels colorTable(const Gaussianized& colors) {
  constexpr std::uint32_t kSide = 32; // [HN18] section 4.3
  const auto value = [&](std::size_t c, std::uint32_t cell) {
    return colors.quantiles[c].at((double(cell) + 0.5) / kSide);
  };
  PeerTexels table{kSide, kSide, kSide, 1, {}};
  for (std::uint32_t b = 0; b < kSide; ++b)
    for (std::uint32_t g = 0; g < kSide; ++g)
      for (std::uint32_t r = 0; r < kSide; ++r)
        append(table.texels, {value(0, r), value(1, g), value(2, b)});
  return table;
}

/// The deviation of each channel that a mip level lost.
std::array<double, 3> lostDeviations(const Texels& level) {
  constexpr double kVariance = gaussian::kGaussianDeviation * gaussian::kGaussianDeviation;
  std::array<double, 3> lost{};
  for (std::size_t c = 0; c < 3; ++c) {
    double variance = 0.0;
    for (const auto& color : level) {
      const double offset = color[c] - gaussian::kGaussianMean;
      variance += offset * offset / double(level.size());
    }
    lost[c] = std::sqrt(std::max(0.0, kVariance - variance));
  }
  return lost;
}

PeerTexels axisTable(const Gaussianized& axes, const std::vector<Texels>& levels) {
  constexpr std::uint32_t kWidth = 128; // Unity's procedural stochastic texturing
  constexpr int kSamples = 64;          // strata of a Gaussian
  PeerTexels table{kWidth, std::uint32_t(levels.size()), 1, 1, {}};
  for (const Texels& level : levels) {
    const std::array<double, 3> lost = lostDeviations(level);
    for (std::uint32_t x = 0; x < kWidth; ++x) {
      const double center = (double(x) + 0.5) / kWidth;
      std::array<double, 3> mean{};
      for (std::size_t c = 0; c < 3; ++c)
        for (int sample = 0; sample < kSamples; ++sample) {
          const double deviate =
              (gaussian::gaussianQuantile((sample + 0.5) / kSamples) - gaussian::kGaussianMean) /
              gaussian::kGaussianDeviation;
          const double value = center + lost[c] * deviate;
          mean[c] += axes.quantiles[c].at(gaussian::gaussianCdf(value)) / kSamples;
        }
      append(table.texels, mean);
    }
  }
  return table;
}

/// The image along its principal axes, each scaled to [0, 1]. Writes the vectors that lead back.
Texels decorrelated(const Texels& image, PeerContents& contents) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const auto& color : image)
    mean += Eigen::Vector3d(color[0], color[1], color[2]) / double(image.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const auto& color : image) {
    const Eigen::Vector3d offset = Eigen::Vector3d(color[0], color[1], color[2]) - mean;
    covariance += offset * offset.transpose() / double(image.size());
  }
  const Eigen::Matrix3d axes =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors();
  Texels result(image.size());
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  for (int k = 0; k < 3; ++k) {
    const auto along = [&](const std::array<double, 3>& color) {
      return axes.col(k).dot(Eigen::Vector3d(color[0], color[1], color[2]));
    };
    double least = along(image[0]), most = least;
    for (const auto& color : image) {
      least = std::min(least, along(color));
      most = std::max(most, along(color));
    }
    const double range = std::max(most - least, 1e-6); // a grey exemplar varies along one axis
    for (std::size_t i = 0; i < image.size(); ++i)
      result[i][std::size_t(k)] = (along(image[i]) - least) / range;
    origin += least * axes.col(k);
    for (int c = 0; c < 3; ++c)
      contents.colorAxes[std::size_t(k)][std::size_t(c)] = float(range * axes(c, k));
  }
  for (int c = 0; c < 3; ++c) {
    contents.mean[std::size_t(c)] = mean[c];
    contents.colorOrigin[std::size_t(c)] = float(origin[c]);
  }
  return result;
}

} // namespace

PeerContents peerContents(const SrgbImage& exemplar) {
  const auto side = std::size_t(exemplar.width);
  Texels image;
  for (std::size_t i = 0; i < exemplar.pixelCount(); ++i) {
    const float* pixel = &exemplar.values[3 * i];
    image.push_back({double(pixel[0]), double(pixel[1]), double(pixel[2])});
  }
  PeerContents contents;
  const Gaussianized colors = gaussianized(image);
  const Gaussianized axes = gaussianized(decorrelated(image, contents));
  const std::vector<Texels> axisLevels = mipLevels(axes.image, side);
  contents.exemplar = stored(mipLevels(image, side), side);
  contents.gaussianImage = stored(mipLevels(colors.image, side), side);
  contents.colorTable = colorTable(colors);
  contents.decorrelatedImage = stored(axisLevels, side);
  contents.axisTable = axisTable(axes, axisLevels);
  return contents;
}

} // namespace lichen::bench
