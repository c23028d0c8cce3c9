// SPDX-License-Identifier: MIT
// Plane (height, width) -> its least-squares polynomial (height, width), by orthonormal polynomials
// along each axis.
#include "trend.h"

#include <Eigen/Core>
#include <Eigen/QR>

#include <algorithm>

namespace lichen::suitability {
namespace {

constexpr Eigen::Index kDegree = 4;
constexpr Eigen::Index kReferenceDegree = 8; // the material's own variation: from kDegree + 1 on
constexpr double kStandsOut = 4.0;           // in variances of the material's own terms
constexpr double kFewestReferences = 4.0;    // terms that estimate that variance

/// Orthonormal columns of degree 0, 1, ... (side, at most kReferenceDegree + 1), even and odd in
/// turn.
Eigen::MatrixXd polynomialsOf(int side) {
  const Eigen::Index count = std::min<Eigen::Index>(kReferenceDegree + 1, side);
  Eigen::MatrixXd powers = Eigen::MatrixXd::Ones(side, count);
  for (Eigen::Index k = 1; k < count; ++k)
    powers.col(k) = powers.col(k - 1).cwiseProduct(Eigen::VectorXd::LinSpaced(side, -1.0, 1.0));
  const Eigen::HouseholderQR<Eigen::MatrixXd> factors(powers);
  return factors.householderQ() * Eigen::MatrixXd::Identity(side, count);
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

} // namespace lichen::suitability
