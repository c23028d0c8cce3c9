// SPDX-License-Identifier: MIT
// Power plane -> boxes of frequencies (power_tree) -> octaves -> energies by least squares, on the
// spectrum and on the autocovariance.
//
// [LRP14] section 4.3. The energies are fitted to the spectra that the windows make of the boxes,
// where the paper gives each stratum its own energy: docs/decisions/009-local-random-phase.md.
#include "cosine_fit.h"

#include "octave_lattice.h"

#include <lichen/fft.h>
#include <lichen/local_random_phase_map.h>

#include <Eigen/Dense>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

namespace lichen::local_random_phase {
namespace {

/// Edges of a lattice in units of 1 / sqrt(area of a box): a window about as wide in frequency as
/// the box. Longer ones show single waves: docs/decisions/009-local-random-phase.md.
constexpr double kEdgesPerBox = 0.9;

/// Boxes of frequencies at which the spectra are compared: small beside the widths of the windows.
constexpr std::size_t kComparedBoxes = 3000;

/// Weights p^-1.2 of the spectrum's rows by their power p, between the weights of the absolute and
/// of the relative error. Constants of the fit, on twelve exemplars:
/// docs/decisions/009-local-random-phase.md.
constexpr double kWeightExponent = 1.2;

/// The sum of squares of the lags' rows over the sum of the spectrum's rows.
constexpr double kLagWeight = 5.0;

/// Lags are compared as far as autocovarianceError() does [texels].
constexpr int kMostLag = 31;

/// Cosines of similar areas that share an octave, as each octave costs a pixel three hashes and
/// windows. Even, as the image's rows hold two.
constexpr std::size_t kSharing = 4;

double areaOf(const FrequencyBox& box) { return box.width() * box.height(); }

/// The octave of boxes between two areas.
int octaveOf(double least, double most, const std::array<double, 2>& edges) {
  const double edge = kEdgesPerBox / std::pow(least * most, 0.25); // [tiles]
  const double octave = std::log2(std::sqrt(edges[0] * edges[1]) / edge);
  return std::clamp(int(std::lround(octave)), 0, int(kMostOctaves) - 1);
}

/// The mean power of a box's frequencies, and half of what they stand for. (0, 0) does not count.
struct BoxPower {
  double sum = 0.0;
  double frequencies = 0.0;
  [[nodiscard]] double mean() const { return frequencies > 0.0 ? sum / frequencies : 0.0; }
};

BoxPower powerOf(const PowerPlane& power, const FrequencyBox& box) {
  BoxPower result;
  for (int v = box.top; v < box.bottom; ++v)
    for (int u = box.left; u < box.right; ++u) {
      if (u == 0 && v == 0)
        continue;
      const double weight = u == 0 ? 0.5 : 1.0;
      result.sum += weight * power.at(u, v);
      result.frequencies += weight;
    }
  return result;
}

/// sin(pi x) / (pi x).
double sinc(double x) {
  const double phase = std::numbers::pi * x;
  return phase == 0.0 ? 1.0 : std::sin(phase) / phase;
}

/// The power spectral density and the autocovariance of a cosine of variance 1. Half of the
/// variance lies at the frequencies of its box, half at their mirrors.
class CosineSpectrum {
public:
  /// `texels`: of the tile, along x and y.
  CosineSpectrum(const WindowSpectrum& window, const Cosine& cosine,
                 const std::array<double, 2>& edges, const std::array<double, 2>& texels)
      : window_(window), box_(cosine.box), texels_(texels) {
    for (std::size_t axis = 0; axis < 2; ++axis)
      edges_[axis] = std::ldexp(edges[axis], -cosine.octave);
  }

  /// Frequencies that texels cannot hold appear at others.
  [[nodiscard]] double at(double u, double v) const {
    const double aliasU = u - texels_[0], aliasV = v - std::copysign(texels_[1], v);
    return 0.5 *
           (twoSided(u, v) + twoSided(aliasU, v) + twoSided(u, aliasV) + twoSided(aliasU, aliasV));
  }

  /// At a lag in tiles: the mean of cos 2 pi f t over the box, under the windows.
  [[nodiscard]] double covariance(double x, double y) const {
    const double u = 0.5 * (box_.low() + box_.high()), v = 0.5 * (box_.lowRow() + box_.highRow());
    return window_.correlation(x / edges_[0], y / edges_[1]) * sinc(box_.width() * x) *
           sinc(box_.height() * y) * std::cos(2.0 * std::numbers::pi * (u * x + v * y));
  }

private:
  [[nodiscard]] double twoSided(double u, double v) const {
    return oneSided(u, v) + oneSided(-u, -v);
  }

  [[nodiscard]] double oneSided(double u, double v) const {
    const double left = (u - box_.high()) * edges_[0], right = (u - box_.low()) * edges_[0];
    const double top = (v - box_.highRow()) * edges_[1], bottom = (v - box_.lowRow()) * edges_[1];
    const double sum = window_.below(right, bottom) - window_.below(left, bottom) -
                       window_.below(right, top) + window_.below(left, top);
    return sum / (box_.width() * box_.height());
  }

  const WindowSpectrum& window_;
  FrequencyBox box_;
  std::array<double, 2> texels_;
  std::array<double, 2> edges_{};
};

/// Rows of the least squares: `made` by a variance of 1 of each cosine, which has a column, and
/// `wanted` of all together.
struct Rows {
  Eigen::MatrixXd made;
  Eigen::VectorXd wanted;
};

/// Minimizes |made energies - wanted|^2 over energies >= 0 by coordinate descent. `gram` is
/// made^T made and `products` made^T wanted.
Eigen::VectorXd nonNegativeLeastSquares(const Eigen::MatrixXd& gram,
                                        const Eigen::VectorXd& products, Eigen::VectorXd energies) {
  constexpr int kSweeps = 2000;
  constexpr double kSmallestChange = 1e-7; // of the sum of energies
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    double change = 0.0;
    for (Eigen::Index j = 0; j < energies.size(); ++j) {
      if (!(gram(j, j) > 0.0))
        continue;
      const double next =
          std::max(0.0, energies[j] + (products[j] - gram.row(j).dot(energies)) / gram(j, j));
      change = std::max(change, std::abs(next - energies[j]));
      energies[j] = next;
    }
    if (change <= kSmallestChange * energies.sum())
      break;
  }
  return energies;
}

/// Boxes of nearly constant power, weighted so that the error lies between the absolute and the
/// relative one.
Rows spectrumRows(const PowerPlane& smooth, const std::vector<CosineSpectrum>& cosines) {
  constexpr double kLeastPower = 1e-6; // of the largest, as in power_tree
  const std::vector<FrequencyBox> boxes = boxesOfEqualPower(smooth, kComparedBoxes);
  std::vector<BoxPower> powers;
  double largest = 0.0;
  for (const FrequencyBox& box : boxes) {
    powers.push_back(powerOf(smooth, box));
    largest = std::max(largest, powers.back().mean());
  }
  Rows rows{Eigen::MatrixXd(Eigen::Index(boxes.size()), Eigen::Index(cosines.size())),
            Eigen::VectorXd(Eigen::Index(boxes.size()))};
  tbb::parallel_for(Eigen::Index(0), rows.made.rows(), [&](Eigen::Index i) {
    const FrequencyBox& box = boxes[std::size_t(i)];
    const BoxPower& own = powers[std::size_t(i)];
    const double weight = std::sqrt(
        own.frequencies / std::pow(own.mean() + kLeastPower * largest + 1e-300, kWeightExponent));
    const double u = 0.5 * (box.low() + box.high()), v = 0.5 * (box.lowRow() + box.highRow());
    for (std::size_t j = 0; j < cosines.size(); ++j)
      rows.made(i, Eigen::Index(j)) = weight * cosines[j].at(u, v);
    rows.wanted[i] = weight * own.mean();
  });
  return rows;
}

/// The autocovariance at the lags of a half plane. It belongs to the exemplar itself: smoothing the
/// spectrum would narrow it.
Rows lagRows(const PowerPlane& power, const std::vector<CosineSpectrum>& cosines) {
  HalfSpectrum spectrum{2 * power.columns, power.rows + 1, {}};
  const int width = spectrum.width, height = spectrum.height, half = power.rows / 2;
  spectrum.values.resize(std::size_t(spectrum.columns()) * std::size_t(height));
  for (int v = -half; v <= half; ++v)
    for (int u = 0; u < power.columns; ++u)
      if (u != 0 || v != 0)
        spectrum.at(u, (v + height) % height) = float(power.at(u, v));
  const std::vector<float> plane = inverseFft(spectrum); // over the number of texels
  constexpr int kSupportsPerSide = 4;                    // as autocovarianceError()
  const int columns = std::min(kMostLag, width / kSupportsPerSide);
  const int lines = std::min(kMostLag, height / kSupportsPerSide) + 1;
  const Eigen::Index stride = 2 * columns + 1;
  Rows rows{Eigen::MatrixXd(stride * lines, Eigen::Index(cosines.size())),
            Eigen::VectorXd(stride * lines)};
  tbb::parallel_for(0, lines, [&](int y) {
    for (int x = -columns; x <= columns; ++x) {
      const Eigen::Index i = y * stride + x + columns;
      for (std::size_t j = 0; j < cosines.size(); ++j)
        rows.made(i, Eigen::Index(j)) =
            cosines[j].covariance(double(x) / width, double(y) / height);
      rows.wanted[i] =
          double(width) * height *
          double(plane[std::size_t(y) * std::size_t(width) + std::size_t((x + width) % width)]);
    }
  });
  return rows;
}

/// Sets the energies, from the spectrum and from the autocovariance.
void fitEnergies(const PowerPlane& power, const PowerPlane& smooth,
                 const std::array<double, 2>& edges, std::vector<Cosine>& cosines) {
  const WindowSpectrum window;
  std::vector<CosineSpectrum> spectra;
  Eigen::VectorXd energies(Eigen::Index(cosines.size()));
  for (std::size_t j = 0; j < cosines.size(); ++j) {
    spectra.emplace_back(window, cosines[j], edges,
                         std::array{2.0 * power.columns, power.rows + 1.0});
    energies[Eigen::Index(j)] = 2.0 * powerOf(smooth, cosines[j].box).sum;
  }
  const double variance = energies.sum();
  const Rows boxes = spectrumRows(smooth, spectra), lags = lagRows(power, spectra);
  const double weight =
      kLagWeight * boxes.wanted.squaredNorm() / lags.wanted.squaredNorm(); // the variance is not 0
  energies = nonNegativeLeastSquares(
      boxes.made.transpose() * boxes.made + weight * lags.made.transpose() * lags.made,
      boxes.made.transpose() * boxes.wanted + weight * lags.made.transpose() * lags.wanted,
      std::move(energies));
  const double scale = variance / energies.sum();
  for (std::size_t j = 0; j < cosines.size(); ++j)
    cosines[j].energy = scale * energies[Eigen::Index(j)];
}

/// Within each octave by the direction of the wave: solid noise spreads the third frequencies of
/// cosines that follow each other.
void sortByDirection(std::vector<Cosine>& cosines) {
  const auto directionOf = [](const FrequencyBox& box) {
    return std::atan2(box.lowRow() + box.highRow(), box.low() + box.high());
  };
  std::stable_sort(cosines.begin(), cosines.end(), [&](const Cosine& a, const Cosine& b) {
    return std::pair(a.octave, directionOf(a.box)) < std::pair(b.octave, directionOf(b.box));
  });
}

} // namespace

std::vector<Cosine> fitCosines(const PowerPlane& power, std::span<const FrequencyBox> boxes,
                               const std::array<double, 2>& edges, bool isGiven) {
  std::vector<Cosine> cosines;
  const PowerPlane smooth = smoothed(power);
  for (const FrequencyBox& box : boxes)
    if (powerOf(isGiven ? power : smooth, box).sum > 0.0)
      cosines.push_back({box});
  if (cosines.empty())
    return cosines;
  const auto order = [](const Cosine& a, const Cosine& b) {
    return std::tuple(areaOf(a.box), a.box.top, a.box.left) <
           std::tuple(areaOf(b.box), b.box.top, b.box.left);
  };
  std::sort(cosines.begin(), cosines.end(), order);
  for (std::size_t j = 0; j < cosines.size(); ++j) {
    const std::size_t first = j - j % kSharing;
    const std::size_t last = std::min(first + kSharing, cosines.size()) - 1;
    cosines[j].octave = octaveOf(areaOf(cosines[first].box), areaOf(cosines[last].box), edges);
  }
  if (isGiven)
    for (Cosine& cosine : cosines)
      cosine.energy = 2.0 * powerOf(power, cosine.box).sum;
  else
    fitEnergies(power, smooth, edges, cosines);
  sortByDirection(cosines);
  if (cosines.size() % 2 != 0) // one of no frequency
    cosines.push_back({{1, 1, 0, 0}, cosines.back().octave, 0.0});
  return cosines;
}

} // namespace lichen::local_random_phase
