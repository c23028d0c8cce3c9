// SPDX-License-Identifier: MIT
// Plane (height, width) -> the low-passed plane.
#include "low_pass.h"

#include "color_space.h"

#include <lichen/fft.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>

namespace lichen::exemplar {
namespace {

/// Filters a plane that repeats.
Plane filtered(const Plane& plane, const Period& period) {
  HalfSpectrum spectrum = forwardFft(plane.values, plane.width, plane.height);
  for (int v = 0; v < spectrum.height; ++v) {
    const int signedV = spectrum.signedRow(v);
    for (int u = 0; u < spectrum.columns(); ++u)
      spectrum.at(u, v) *=
          float(lowPassGain(period.x * u / spectrum.width, period.y * signedV / spectrum.height));
  }
  return {plane.width, plane.height, inverseFft(spectrum)};
}

} // namespace

Plane mirrored(const Plane& plane) {
  Plane whole{2 * plane.width, 2 * plane.height, {}};
  whole.values.reserve(4 * plane.values.size());
  for (int y = 0; y < whole.height; ++y) {
    const int from = y < plane.height ? y : whole.height - 1 - y;
    const auto row = plane.values.begin() + std::ptrdiff_t(from) * plane.width;
    whole.values.insert(whole.values.end(), row, row + plane.width);
    whole.values.insert(whole.values.end(), std::make_reverse_iterator(row + plane.width),
                        std::make_reverse_iterator(row));
  }
  return whole;
}

Plane lowPassed(const Plane& plane, Plane trend, const Period& period, bool periodic) {
  Plane rest = plane;
  for (std::size_t i = 0; i < rest.values.size(); ++i)
    rest.values[i] -= trend.values[i];
  const Plane low = filtered(periodic ? rest : mirrored(rest), period);
  for (int y = 0; y < plane.height; ++y)
    for (int x = 0; x < plane.width; ++x)
      trend.values[std::size_t(y) * std::size_t(plane.width) + std::size_t(x)] +=
          low.values[std::size_t(y) * std::size_t(low.width) + std::size_t(x)];
  return trend;
}

// Plane (height, width) -> its least-squares polynomial (height, width), by orthonormal polynomials
// along each axis.
namespace {

constexpr Eigen::Index kDegree = 4;
constexpr Eigen::Index kReferenceDegree = 8; // the material's own variation: from kDegree + 1 on
constexpr double kStandsOut = 4.0;           // in variances of the material's own terms
constexpr double kFewestReferences = 4.0;    // terms that estimate that variance

/// Orthonormal columns of degree 0, 1, ... (side, at most kReferenceDegree + 1), even and odd in
/// turn.
Eigen::MatrixXd polynomialsOf(int side) {
  const Eigen::Index count = std::min<Eigen::Index>(kReferenceDegree + 1, side);
  Eigen::MatrixXd columns = Eigen::MatrixXd::Ones(side, count) / std::sqrt(double(side));
  for (Eigen::Index k = 1; k < count; ++k) {
    auto column = columns.col(k);
    column = columns.col(k - 1).cwiseProduct(Eigen::VectorXd::LinSpaced(side, -1.0, 1.0));
    for (Eigen::Index other = 0; other < k; ++other)
      column -= columns.col(other).dot(column) * columns.col(other);
    column.normalize();
  }
  return columns;
}

/// Calls use(v, u) for each term of a degree in [first, last].
template <typename Use>
void forTerms(const Eigen::MatrixXd& terms, Eigen::Index first, Eigen::Index last, const Use& use) {
  for (Eigen::Index v = 0; v < terms.rows(); ++v)
    for (Eigen::Index u = 0; u < terms.cols(); ++u)
      if (u + v >= first && u + v <= last)
        use(v, u);
}

/// The terms that stand out, and the mean; all others are 0.
Eigen::MatrixXd outstanding(const Eigen::MatrixXd& terms, bool periodic) {
  double squares = 0.0, count = 0.0;
  forTerms(terms, kDegree + 1, kReferenceDegree, [&](Eigen::Index v, Eigen::Index u) {
    squares += terms(v, u) * terms(v, u);
    count += 1.0;
  });
  Eigen::MatrixXd kept = Eigen::MatrixXd::Zero(terms.rows(), terms.cols());
  kept(0, 0) = terms(0, 0);
  if (count < kFewestReferences)
    return kept;
  const double own = squares / count;
  forTerms(terms, 1, kDegree, [&](Eigen::Index v, Eigen::Index u) {
    const double term = terms(v, u);
    const bool isOdd = u % 2 != 0 || v % 2 != 0;
    if (!(periodic && isOdd) && term * term > kStandsOut * own)
      kept(v, u) = term - kStandsOut * own / term;
  });
  return kept;
}

} // namespace

Plane trendOf(const Plane& plane, bool periodic) {
  using Rows = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const Rows> values(plane.values.data(), plane.height, plane.width);
  const Eigen::MatrixXd across = polynomialsOf(plane.width), down = polynomialsOf(plane.height);
  const Eigen::MatrixXd terms = (down.transpose() * values.cast<double>()) * across;
  Plane trend{plane.width, plane.height, std::vector<float>(plane.values.size())};
  Eigen::Map<Rows>(trend.values.data(), plane.height, plane.width) =
      (down * outstanding(terms, periodic) * across.transpose()).cast<float>();
  return trend;
}

// Values (height, width, channels) -> concentration of the slow gradients.

double edgeConcentration(const MapExemplar& map, bool periodic) {
  const double period = kShortestLight * std::max(map.width, map.height);
  const Plane plane{map.width, map.height, principalComponent(map).values};
  const Plane slow = lowPassed(plane, trendOf(plane, periodic), {period, period}, periodic);
  const auto at = [&](int x, int y) { return double(slow.at(x, y)); };
  // Forward differences suffice: the plane has no variation at the scale of a pixel.
  double squares = 0.0, fourths = 0.0;
  for (int y = 0; y + 1 < slow.height; ++y)
    for (int x = 0; x + 1 < slow.width; ++x) {
      const double right = at(x + 1, y) - at(x, y), down = at(x, y + 1) - at(x, y);
      const double square = right * right + down * down;
      squares += square;
      fourths += square * square;
    }
  const double count = double(slow.width - 1) * double(slow.height - 1);
  return squares > 0.0 ? count * fourths / (squares * squares) : 0.0;
}

} // namespace lichen::exemplar
