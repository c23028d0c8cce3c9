// SPDX-License-Identifier: MIT
// Power plane -> boxes of frequencies (power_tree) -> octaves -> energies by least squares.
//
// [LRP14] section 4.3. The energies are fitted to the spectra that the windows make of the boxes,
// where the paper gives each stratum its own energy: docs/decisions/027-cosines.md.
#include "cosine_fit.h"

#include "window_spectrum.h"

#include <lichen/local_random_phase_map.h>

#include <Eigen/Dense>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace lichen::local_random_phase {
namespace {

/// Edges of a lattice in units of 1 / sqrt(area of a box): a window about as wide in frequency as
/// the box. From 1 to 1.5 the errors hardly change; longer edges show single waves.
constexpr double kEdgesPerBox = 1.3;

/// Boxes of frequencies at which the spectra are compared: small beside the widths of the windows.
constexpr std::size_t kComparedBoxes = 3000;

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

/// The power spectral density of a cosine of variance 1: half of the variance lies at the
/// frequencies of its box, half at their mirrors.
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

/// Minimizes |spectra energies - wanted|^2 over energies >= 0 by coordinate descent.
Eigen::VectorXd nonNegativeLeastSquares(const Eigen::MatrixXd& spectra,
                                        const Eigen::VectorXd& wanted, Eigen::VectorXd energies) {
  constexpr int kSweeps = 2000;
  constexpr double kSmallestChange = 1e-7; // of the sum of energies
  const Eigen::MatrixXd gram = spectra.transpose() * spectra;
  const Eigen::VectorXd products = spectra.transpose() * wanted;
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

/// Sets the energies. Rows are boxes of nearly constant power, weighted so that the error lies
/// between the absolute one, which the autocovariance shows, and the relative one.
void fitEnergies(const PowerPlane& power, const std::array<double, 2>& edges,
                 std::vector<Cosine>& cosines) {
  const std::vector<FrequencyBox> compared = boxesOfEqualPower(power, kComparedBoxes);
  const WindowSpectrum window;
  const auto rows = Eigen::Index(compared.size()), columns = Eigen::Index(cosines.size());
  Eigen::MatrixXd spectra = Eigen::MatrixXd::Zero(rows, columns);
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(rows);
  std::vector<BoxPower> powers;
  double largest = 0.0;
  for (const FrequencyBox& box : compared) {
    powers.push_back(powerOf(power, box));
    largest = std::max(largest, powers.back().mean());
  }
  tbb::parallel_for(Eigen::Index(0), columns, [&](Eigen::Index j) {
    const CosineSpectrum spectrum(window, cosines[std::size_t(j)], edges,
                                  {2.0 * power.columns, power.rows + 1.0});
    for (Eigen::Index i = 0; i < rows; ++i) {
      const FrequencyBox& box = compared[std::size_t(i)];
      spectra(i, j) =
          spectrum.at(0.5 * (box.low() + box.high()), 0.5 * (box.lowRow() + box.highRow()));
    }
  });
  constexpr double kLeastPower = 1e-6; // of the largest, as in power_tree
  // From 1 to 2 the errors of six exemplars change by a tenth.
  constexpr double kWeightExponent = 1.6;
  for (Eigen::Index i = 0; i < rows; ++i) {
    const BoxPower& own = powers[std::size_t(i)];
    const double weight = std::sqrt(
        own.frequencies / std::pow(own.mean() + kLeastPower * largest + 1e-300, kWeightExponent));
    spectra.row(i) *= weight;
    wanted[i] = weight * own.mean();
  }
  Eigen::VectorXd energies(columns);
  double variance = 0.0;
  for (Eigen::Index j = 0; j < columns; ++j)
    variance += energies[j] = 2.0 * powerOf(power, cosines[std::size_t(j)].box).sum;
  energies = nonNegativeLeastSquares(spectra, wanted, std::move(energies));
  const double scale = variance / energies.sum();
  for (Eigen::Index j = 0; j < columns; ++j)
    cosines[std::size_t(j)].energy = scale * energies[j];
}

} // namespace

std::vector<Cosine> fitCosines(const PowerPlane& power, std::size_t count,
                               const std::array<double, 2>& edges) {
  std::vector<Cosine> cosines;
  for (const FrequencyBox& box : boxesOfEqualPower(power, count))
    if (powerOf(power, box).sum > 0.0)
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
  fitEnergies(power, edges, cosines);
  if (cosines.size() % 2 != 0) // one of no frequency
    cosines.push_back({{1, 1, 0, 0}, cosines.back().octave, 0.0});
  return cosines;
}

} // namespace lichen::local_random_phase
