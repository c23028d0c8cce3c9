// SPDX-License-Identifier: MIT
// Inverse power iteration [K13] on the connection Laplacian with cotangent weights [SSC19], for all
// parts of a mesh at once. The matrix has a block per part, and each part's vector is normalized
// separately. With an axis there is one more solve, with a larger shift.
// Deviations: weights below kLeastWeight are raised to it, which keeps the matrix positive definite
// with obtuse angles. Fans that share a point are tied, so the field continues across edges with
// more than two faces.
#include "smoothest.h"

#include "surface.h"

#include <Eigen/Sparse>

#include <algorithm>
#include <numeric>

namespace lichen::direction_field {
namespace {

using Matrix = Eigen::SparseMatrix<Complex, Eigen::ColMajor, std::int64_t>;
using Vector = Eigen::VectorXcd;

/// Least weight of an edge. Edges of a regular mesh have 0.58.
constexpr double kLeastWeight = 0.01;
/// Weight between two fans of one point: about what a regular mesh has across a cut.
constexpr double kTieWeight = 1.0;
/// Fans whose normals differ by more than 120 degrees are not tied: the smallest rotation between
/// them depends on rounding.
constexpr double kLeastTiedCosine = -0.5;
/// Shift of the matrix, in units of 1 / (area of the part). The smallest eigenvalue of a flat part
/// is 0; the next is about 3 / area. The shift makes the matrix positive definite, and it is so
/// small that a flat field is exact after two steps.
constexpr double kShift = 1e-6;
/// -lambda of [K13] times the area of the part. Alignment acts over a length of 1 / sqrt(-lambda),
/// a tenth of the square root of the area. Around a cylinder of radius R and length 2 R, the axis
/// then has 0.89 of its effect on a plane. Bumps much smaller than that length do not rotate the
/// field.
constexpr double kAlignment = 100.0;
/// Weight of the smoothest field where the axis is normal to the surface. The smoothest field
/// decides if the axis is within 6 degrees of the normal; elsewhere it rotates the field by at most
/// 6 degrees.
constexpr double kSmoothestShare = 0.1;

/// The sum over edges of w |u_j - r u_i|^2 as a Hermitian matrix. Only the upper half is stored.
class Assembly {
public:
  explicit Assembly(const Surface& surface, const Connection& connection)
      : parts_(surface.vertexCount()) {
    const std::size_t count = surface.vertexCount();
    entries_.reserve(surface.faces.size() + 2 * count);
    diagonal_.assign(count, 0.0);
    for (std::uint32_t h = 0; h < surface.faces.size(); ++h) {
      const std::uint32_t other = surface.twin[h];
      if (other != kNone && other < h)
        continue;
      double cotangents = connection.cornerCotangent[previousCorner(h)];
      if (other != kNone)
        cotangents += connection.cornerCotangent[previousCorner(other)];
      couple(surface.vertexOf[h], surface.vertexOf[nextCorner(h)],
             std::max(cotangents / 2.0, kLeastWeight), std::polar(1.0, connection.turnOf[h]));
    }
    tieFans(surface, connection);
  }

  /// Adds to the diagonal `shift` times each vertex's share of its part's area.
  [[nodiscard]] Matrix finish(const std::vector<double>& areas, double shift) {
    std::vector<double> partArea(diagonal_.size(), 0.0);
    for (std::uint32_t v = 0; v < diagonal_.size(); ++v)
      partArea[parts_.find(v)] += areas[v];
    for (std::uint32_t v = 0; v < diagonal_.size(); ++v)
      entries_.emplace_back(v, v, diagonal_[v] + shift * areas[v] / partArea[parts_.find(v)]);
    const auto size = Eigen::Index(diagonal_.size());
    Matrix matrix(size, size);
    matrix.setFromTriplets(entries_.begin(), entries_.end());
    return matrix;
  }
  [[nodiscard]] DisjointSets takeParts() { return std::move(parts_); }

private:
  void couple(std::uint32_t i, std::uint32_t j, double weight, Complex rotation) {
    diagonal_[i] += weight;
    diagonal_[j] += weight;
    parts_.unite(i, j);
    if (i < j)
      entries_.emplace_back(i, j, -weight * std::conj(rotation));
    else
      entries_.emplace_back(j, i, -weight * rotation);
  }

  /// Couples each vertex with the next vertex at the same point.
  void tieFans(const Surface& surface, const Connection& connection) {
    std::vector<std::uint32_t> previous(surface.points.size(), kNone);
    for (std::uint32_t v = 0; v < surface.vertexCount(); ++v) {
      const std::uint32_t u = std::exchange(previous[surface.pointOfVertex[v]], v);
      if (u == kNone || connection.normalOf[u].dot(connection.normalOf[v]) < kLeastTiedCosine)
        continue;
      const Complex carried =
          inPlane(connection, v,
                  turned(connection.axisOf[u], connection.normalOf[u], connection.normalOf[v]));
      couple(u, v, kTieWeight, carried / std::abs(carried));
    }
  }

  std::vector<Eigen::Triplet<Complex, std::int64_t>> entries_;
  std::vector<double> diagonal_;
  DisjointSets parts_;
};

/// Whether the triangular factor of a matrix, given its upper half, has at most `mostEntries`
/// entries and takes at most `mostProducts` products. Stops when a limit is exceeded. Computes the
/// elimination tree by row subtrees [L90].
bool factorFits(const Matrix& upper, std::int64_t mostEntries, double mostProducts) {
  const std::int64_t size = upper.cols();
  std::vector<std::int64_t> parent(std::size_t(size), -1), seenIn(std::size_t(size), -1);
  std::vector<std::int64_t> inColumn(std::size_t(size), 0);
  std::int64_t entries = 0;
  double products = 0.0;
  for (std::int64_t k = 0; k < size; ++k) {
    seenIn[std::size_t(k)] = k;
    for (Matrix::InnerIterator entry(upper, k); entry; ++entry)
      for (std::int64_t i = entry.row(); i < k && seenIn[std::size_t(i)] != k;
           i = parent[std::size_t(i)]) {
        if (parent[std::size_t(i)] < 0)
          parent[std::size_t(i)] = k;
        seenIn[std::size_t(i)] = k;
        products += double(++inColumn[std::size_t(i)]);
        if (++entries > mostEntries || products > mostProducts)
          return false;
      }
  }
  return true;
}

/// The start of the iteration: a field constant and linear in the position, with coefficients that
/// favour no symmetry. It has a component along every smooth field and rotates with the mesh.
Vector startingField(const Surface& surface, const Connection& connection) {
  const Eigen::Vector3d constant(1.0, 0.55, 0.35);
  const Eigen::Matrix3d linear{{0.31, -0.83, 0.47}, {0.59, 0.22, -0.41}, {-0.67, 0.53, -0.29}};
  Vector start(Eigen::Index(surface.vertexCount()));
  for (std::size_t v = 0; v < surface.vertexCount(); ++v)
    start[Eigen::Index(v)] =
        inPlane(connection, v, constant + linear * surface.points[surface.pointOfVertex[v]]);
  return start;
}

/// Area-weighted norms of the parts of a mesh.
class PartNorms {
public:
  PartNorms(DisjointSets parts, const std::vector<double>& areas) : areas_(areas) {
    for (std::uint32_t v = 0; v < areas.size(); ++v)
      partOf_.push_back(parts.find(v));
  }

  /// Scales each part to norm 1. A part that vanishes becomes constant.
  void normalize(Vector& field) const {
    std::vector<double> squares(areas_.size(), 0.0), partArea(areas_.size(), 0.0);
    for (std::size_t v = 0; v < areas_.size(); ++v) {
      squares[partOf_[v]] += areas_[v] * std::norm(field[Eigen::Index(v)]);
      partArea[partOf_[v]] += areas_[v];
    }
    for (std::size_t v = 0; v < areas_.size(); ++v) {
      const double square = squares[partOf_[v]];
      Complex& value = field[Eigen::Index(v)];
      value = square > 0.0 ? value / std::sqrt(square) : 1.0 / std::sqrt(partArea[partOf_[v]]);
    }
  }

  /// The largest squared distance, over all parts, between two fields.
  [[nodiscard]] double distance(const Vector& a, const Vector& b) const {
    std::vector<double> squares(areas_.size(), 0.0);
    for (std::size_t v = 0; v < areas_.size(); ++v)
      squares[partOf_[v]] += areas_[v] * std::norm(a[Eigen::Index(v)] - b[Eigen::Index(v)]);
    return squares.empty() ? 0.0 : *std::max_element(squares.begin(), squares.end());
  }

  /// Rotates each part as a whole to agree with another field as well as possible.
  void turnTowards(const Vector& other, Vector& field) const {
    std::vector<Complex> sums(areas_.size());
    for (std::size_t v = 0; v < areas_.size(); ++v)
      sums[partOf_[v]] += areas_[v] * other[Eigen::Index(v)] * std::conj(field[Eigen::Index(v)]);
    for (std::size_t v = 0; v < areas_.size(); ++v)
      if (const Complex sum = sums[partOf_[v]]; std::abs(sum) > 0.0)
        field[Eigen::Index(v)] *= sum / std::abs(sum);
  }

private:
  const std::vector<double>& areas_;
  std::vector<std::uint32_t> partOf_;
};

/// A triangular factor of a matrix, in an order that gives few entries.
class OrderedFactor {
public:
  /// `upper` is the upper half of a positive definite matrix. False if the factor exceeds the
  /// limits, which no surface reaches.
  [[nodiscard]] bool compute(const Matrix& upper, const ProgressPart& progress) {
    // Measured: a surface with a million triangles takes 3.4e7 entries and 1.4e10 products;
    // kMostFieldTriangles take 7.4e7 and 4.2e10. The limits mean 4.8 GB and some minutes.
    constexpr std::int64_t kMostEntries = 200'000'000;
    constexpr double kMostProducts = 1e11;
    constexpr double kOrderingShare = 0.08; // of the time, on a million triangles
    Eigen::AMDOrdering<std::int64_t>()(upper.selfadjointView<Eigen::Upper>(), ordering_);
    Matrix ordered(upper.rows(), upper.cols());
    ordered.selfadjointView<Eigen::Upper>() =
        upper.selfadjointView<Eigen::Upper>().twistedBy(ordering_.inverse());
    if (!factorFits(ordered, kMostEntries, kMostProducts))
      return false;
    progress.reach(kOrderingShare);
    factor_.compute(ordered);
    progress.reach(1.0);
    return factor_.info() == Eigen::Success;
  }
  [[nodiscard]] Vector solve(const Vector& right) const {
    const Vector ordered = ordering_.inverse() * right;
    return ordering_ * Vector(factor_.solve(ordered));
  }

private:
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int64_t> ordering_;
  Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<std::int64_t>> factor_;
};

/// Inverse power iteration, until a step barely changes the field.
void iterate(const OrderedFactor& factor, const PartNorms& parts, const std::vector<double>& areas,
             Vector& field, const ProgressPart& progress) {
  constexpr int kMostSteps = 30;
  constexpr double kConverged = 1e-10; // squared distance of one step; the error is smaller
  const Eigen::Map<const Eigen::VectorXd> weights(areas.data(), Eigen::Index(areas.size()));
  for (int step = 0; step < kMostSteps; ++step) {
    Vector next = factor.solve(weights.asDiagonal() * field);
    parts.normalize(next);
    const double moved = parts.distance(next, field);
    field.swap(next);
    if (moved < kConverged)
      break;
    progress.reach(double(step + 1) / kMostSteps);
  }
}

Error notSolved() {
  return {ErrorKind::badInput, "its triangles are not connected like a surface; the directions "
                               "on them cannot be computed"};
}

/// The smoothest field before its values are scaled to absolute value 1, and its norms.
struct Smoothest {
  Vector field;
  PartNorms parts;
};

Result<Smoothest> solveSmoothest(const Surface& surface, const Connection& connection,
                                 const ProgressPart& progress) {
  constexpr double kFactorShare = 0.8; // of the time, on a million triangles
  Assembly assembly(surface, connection);
  OrderedFactor factor;
  if (!factor.compute(assembly.finish(connection.areaOf, kShift), progress.part(0.0, kFactorShare)))
    return notSolved();
  Smoothest smoothest{startingField(surface, connection),
                      PartNorms(assembly.takeParts(), connection.areaOf)};
  smoothest.parts.normalize(smoothest.field);
  iterate(factor, smoothest.parts, connection.areaOf, smoothest.field,
          progress.part(kFactorShare, 1.0));
  return smoothest;
}

std::vector<Complex> asDirections(const Vector& field) {
  std::vector<Complex> directions(std::size_t(field.size()));
  for (std::size_t v = 0; v < directions.size(); ++v) {
    const Complex value = field[Eigen::Index(v)];
    directions[v] = std::abs(value) > 0.0 ? value / std::abs(value) : Complex(1.0);
  }
  return directions;
}

/// q of [K13]: the axis projected on the tangent planes, plus the smoothest field where that is
/// short.
Vector guidingField(const Connection& connection, const Eigen::Vector3d& axis,
                    Smoothest smoothest) {
  Vector guide(smoothest.field.size());
  for (std::size_t v = 0; v < std::size_t(guide.size()); ++v)
    guide[Eigen::Index(v)] = inPlane(connection, v, axis);
  smoothest.parts.turnTowards(guide, smoothest.field);
  const std::vector<Complex> directions = asDirections(smoothest.field);
  for (std::size_t v = 0; v < directions.size(); ++v) {
    Complex& value = guide[Eigen::Index(v)];
    value += kSmoothestShare * std::max(0.0, 1.0 - std::norm(value)) * directions[v];
  }
  return guide;
}

} // namespace

Result<std::vector<Complex>> smoothestField(const Surface& surface, const Connection& connection,
                                            const ProgressPart& progress) {
  if (surface.vertexCount() == 0)
    return std::vector<Complex>();
  const Result<Smoothest> smoothest = solveSmoothest(surface, connection, progress);
  if (!smoothest)
    return smoothest.error();
  return asDirections(smoothest.value().field);
}

/// [K13]: (A - lambda M) u = M q.
Result<std::vector<Complex>> alignedField(const Surface& surface, const Connection& connection,
                                          const Eigen::Vector3d& axis,
                                          const ProgressPart& progress) {
  constexpr double kSmoothestTime = 0.55; // first factor and iteration, before the second factor
  if (surface.vertexCount() == 0)
    return std::vector<Complex>();
  Result<Smoothest> smoothest =
      solveSmoothest(surface, connection, progress.part(0.0, kSmoothestTime));
  if (!smoothest)
    return smoothest.error();
  const Vector guide = guidingField(connection, axis.normalized(), std::move(smoothest).value());
  OrderedFactor factor;
  if (!factor.compute(Assembly(surface, connection).finish(connection.areaOf, kAlignment),
                      progress.part(kSmoothestTime, 1.0)))
    return notSolved();
  const Eigen::Map<const Eigen::VectorXd> weights(connection.areaOf.data(), guide.size());
  return asDirections(factor.solve(weights.asDiagonal() * guide));
}

} // namespace lichen::direction_field
