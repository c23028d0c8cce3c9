// SPDX-License-Identifier: MIT
// The smoothest direction fields on generated meshes: the singularities that topology requires, the
// known fields of flat meshes, and robustness on odd meshes.
#include <lichen/direction_field.h>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <set>

using namespace lichen;
using Eigen::Vector3d;
using std::numbers::pi;

namespace {

struct Mesh {
  std::vector<Vector3> positions;
  std::vector<std::uint32_t> triangles;

  std::uint32_t add(const Vector3d& p) {
    positions.push_back({float(p.x()), float(p.y()), float(p.z())});
    return std::uint32_t(positions.size() - 1);
  }
  void add(std::initializer_list<std::uint32_t> triangle) {
    triangles.insert(triangles.end(), triangle);
  }
  void append(const Mesh& other) {
    const auto first = std::uint32_t(positions.size());
    positions.insert(positions.end(), other.positions.begin(), other.positions.end());
    for (const std::uint32_t i : other.triangles)
      triangles.push_back(first + i);
  }
};

Vector3d at(const std::vector<Vector3>& values, std::size_t i) {
  return {values[i][0], values[i][1], values[i][2]};
}

/// A grid of columns x rows quads; `place` returns the point of a column and row. Neighbouring
/// quads share their points. Opposite ends of the grid do not share points, but may coincide.
template <class Place>
Mesh grid(std::uint32_t columns, std::uint32_t rows, Place place) {
  Mesh mesh;
  for (std::uint32_t j = 0; j <= rows; ++j)
    for (std::uint32_t i = 0; i <= columns; ++i)
      mesh.add(place(i, j));
  for (std::uint32_t j = 0; j < rows; ++j)
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
      mesh.add({a, b, d});
      mesh.add({a, d, c});
    }
  return mesh;
}

Mesh plane(std::uint32_t side) {
  return grid(side, side, [](auto i, auto j) { return Vector3d(i, j, 0.0); });
}

/// Ends and poles coincide in position only. The triangles at the poles have only two distinct
/// points.
Mesh ball(std::uint32_t columns, std::uint32_t rows, const Vector3d& radii = {1.0, 1.0, 1.0}) {
  return grid(columns, rows, [&](auto i, auto j) -> Vector3d {
    const double along = 2.0 * pi * double(i % columns) / columns, down = pi * double(j) / rows;
    const double ring = j == 0 || j == rows ? 0.0 : std::sin(down);
    return radii.cwiseProduct(
        Vector3d(ring * std::cos(along), ring * std::sin(along), std::cos(down)));
  });
}

Mesh torus(std::uint32_t columns, std::uint32_t rows) {
  return grid(columns, rows, [&](auto i, auto j) -> Vector3d {
    const double a = 2.0 * pi * double(i % columns) / columns;
    const double b = 2.0 * pi * double(j % rows) / rows;
    return {(3.0 + std::cos(b)) * std::cos(a), (3.0 + std::cos(b)) * std::sin(a), std::sin(b)};
  });
}

/// Moves positions by up to `amount`; coincident positions move alike.
Mesh shaken(Mesh mesh, float amount, unsigned seed) {
  std::mt19937 random(seed);
  std::map<Vector3, Vector3> moved;
  for (Vector3& p : mesh.positions) {
    const auto [entry, isNew] = moved.try_emplace(p, p);
    if (isNew)
      for (float& x : entry->second)
        x += amount * (float(random() % 2001) / 1000.0f - 1.0f);
    p = entry->second;
  }
  return mesh;
}

DirectionField fieldOf(const Mesh& mesh, const std::vector<Vector3>& normals = {},
                       const std::optional<Vector3>& axis = {}) {
  Result<DirectionField> field = directionField(mesh.positions, mesh.triangles, normals, {}, axis);
  REQUIRE(field.ok());
  REQUIRE(field.value().tangents.size() == mesh.positions.size());
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vector3d t = at(field.value().tangents, i), n = at(field.value().normals, i);
    // The product of unit vectors of floats: three roundings of 6e-8 each, plus the product's own.
    REQUIRE(std::abs(t.norm() - 1.0) < 5e-7);
    REQUIRE(std::abs(n.norm() - 1.0) < 5e-7);
    REQUIRE(std::abs(t.dot(n)) < 5e-7);
  }
  return std::move(field).value();
}

/// The angle between a tangent, rotated with the normals, and the tangent of another vertex.
double angleBetween(const DirectionField& field, std::size_t i, std::size_t j) {
  const Vector3d from = at(field.normals, i), to = at(field.normals, j);
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(from, to);
  const Vector3d carried = turn * at(field.tangents, i);
  return std::acos(std::clamp(carried.dot(at(field.tangents, j)), -1.0, 1.0));
}

/// The largest such angle over the edges of triangles that share no position with a singular one.
double largestTurn(const Mesh& mesh, const DirectionField& field) {
  std::set<Vector3> singular;
  for (const FieldSingularity& s : field.singularities)
    for (std::size_t k = 0; k < 3; ++k)
      singular.insert(mesh.positions[mesh.triangles[3 * s.triangle + k]]);
  double largest = 0.0;
  for (std::size_t c = 0; c < mesh.triangles.size(); ++c) {
    const std::uint32_t i = mesh.triangles[c];
    const std::uint32_t j = mesh.triangles[c % 3 == 2 ? c - 2 : c + 1];
    if (mesh.positions[i] != mesh.positions[j] && !singular.contains(mesh.positions[i]) &&
        !singular.contains(mesh.positions[j]))
      largest = std::max(largest, angleBetween(field, i, j));
  }
  return largest;
}

} // namespace

TEST_CASE("a flat mesh has one direction everywhere, whatever its holes, border and triangles") {
  Mesh flat = shaken(plane(20), 0.25f, 7);
  for (Vector3& p : flat.positions)
    p[2] = 0.0f; // perturbed in its plane: angles of all kinds, obtuse ones too
  std::vector<std::uint32_t> kept;
  for (std::size_t t = 0; t < flat.triangles.size() / 3; ++t)
    if (const std::size_t cell = t / 2; cell % 20 < 7 || cell % 20 > 11 || cell / 20 % 9 < 4)
      kept.insert(kept.end(),
                  {flat.triangles[3 * t], flat.triangles[3 * t + 1], flat.triangles[3 * t + 2]});
  flat.triangles = kept;
  const DirectionField exact = fieldOf(flat);
  for (const std::uint32_t i : flat.triangles)
    CHECK((at(exact.tangents, i) - at(exact.tangents, flat.triangles[0])).norm() < 1e-6);
  // Rotated off the axes, so that no float is exact by chance.
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.0, Vector3d(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  for (std::size_t i = 0; i < flat.positions.size(); ++i) {
    const Vector3d p = turn * at(flat.positions, i);
    flat.positions[i] = {float(p.x()), float(p.y()), float(p.z())};
  }
  const DirectionField field = fieldOf(flat);
  CHECK(field.singularities.empty());
  REQUIRE(field.components.size() == 1);
  CHECK(!field.components[0].isClosed);
  CHECK(field.components[0].eulerCharacteristic < 1);
  for (const std::uint32_t i : flat.triangles)
    // Positions of magnitude 20 in floats are 1e-6 out of the plane; triangles are at least 0.1
    // high.
    CHECK((at(field.tangents, i) - at(field.tangents, flat.triangles[0])).norm() < 5e-5);
}

TEST_CASE("the singularity indices of a closed component add up to its Euler characteristic") {
  Mesh mesh = ball(24, 12);
  Mesh ring = torus(40, 16);
  for (Vector3& p : ring.positions)
    p[0] += 10.0f;
  mesh.append(ring);
  mesh.append(shaken(ball(16, 8, {1.0, 2.0, 0.5}), 0.05f, 3));
  const DirectionField field = fieldOf(mesh);
  REQUIRE(field.components.size() == 3);
  for (const FieldComponent& component : field.components) {
    CHECK(component.isClosed);
    CHECK(component.indexSum == component.eulerCharacteristic);
  }
  CHECK(field.components[0].eulerCharacteristic == 2);
  CHECK(field.components[1].eulerCharacteristic == 0);
  CHECK(field.components[2].eulerCharacteristic == 2);
  // Topology requires exactly this many: two for a ball, none for a ring.
  CHECK(field.components[0].singularities == 2);
  CHECK(field.components[1].singularities == 0);
  CHECK(field.components[2].singularities == 2);
  int sum = 0;
  for (const FieldSingularity& singularity : field.singularities)
    sum += singularity.index;
  CHECK(sum == 4);
}

TEST_CASE("directions of neighbours differ little except at singularities, also across seams") {
  // On a ball the field is smooth and vanishes at two opposite points, with one rotation around
  // each. Between the ends of an edge it rotates by the angle that the edge spans as seen from the
  // zero. Edges outside the zero's own triangle span less than a right angle.
  const Mesh mesh = ball(48, 24);
  const DirectionField field = fieldOf(mesh, mesh.positions); // on a ball, positions are normals
  CHECK(largestTurn(mesh, field) < pi / 2.0);
  std::vector<double> turns;
  for (std::size_t c = 0; c + 1 < mesh.triangles.size(); c += 3)
    if (mesh.positions[mesh.triangles[c]] != mesh.positions[mesh.triangles[c + 1]])
      turns.push_back(angleBetween(field, mesh.triangles[c], mesh.triangles[c + 1]));
  std::sort(turns.begin(), turns.end());
  CHECK(turns[turns.size() / 2] < 0.1); // h / r, with a median distance of about pi / 3
  // The ends of the grid coincide in position only.
  for (std::uint32_t j = 1; j < 24; ++j)
    CHECK((at(field.tangents, j * 49) - at(field.tangents, j * 49 + 48)).norm() < 1e-6);
  const Mesh ring = torus(40, 16);
  CHECK(largestTurn(ring, fieldOf(ring)) < 0.2);
}

TEST_CASE("the field does not depend on the order of vertices and triangles") {
  const Mesh mesh = shaken(ball(20, 10, {1.0, 1.6, 0.7}), 0.03f, 5);
  const DirectionField field = fieldOf(mesh);
  std::vector<std::uint32_t> order(mesh.positions.size()), triangles(mesh.triangles.size() / 3);
  std::iota(order.begin(), order.end(), 0u);
  std::iota(triangles.begin(), triangles.end(), 0u);
  std::mt19937 random(11);
  std::shuffle(order.begin(), order.end(), random);
  std::shuffle(triangles.begin(), triangles.end(), random);
  Mesh other;
  other.positions.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    other.positions[order[i]] = mesh.positions[i];
  for (const std::uint32_t t : triangles)
    for (std::uint32_t k = 0; k < 3; ++k)
      other.triangles.push_back(order[mesh.triangles[3 * t + (k + t) % 3]]);
  const DirectionField otherField = fieldOf(other);
  // The iteration stops at the same step; rounding grows by the inverse of the spectral gap.
  for (std::size_t i = 0; i < order.size(); ++i)
    CHECK((at(field.tangents, i) - at(otherField.tangents, order[i])).norm() < 1e-4);
  CHECK(otherField.singularities.size() == field.singularities.size());
}

/// The largest angle between a tangent and the tangential part of the axis, over the vertices where
/// that part is at least `shortest` times the axis.
double largestDeviation(const DirectionField& field, const Vector3d& axis, double shortest) {
  double largest = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < field.tangents.size(); ++i) {
    const Vector3d normal = at(field.normals, i);
    const Vector3d flat = axis.normalized() - normal * normal.dot(axis.normalized());
    if (flat.norm() < shortest)
      continue;
    ++count;
    const double cosine = flat.normalized().dot(at(field.tangents, i));
    largest = std::max(largest, std::acos(std::clamp(cosine, -1.0, 1.0)));
  }
  REQUIRE(count > 0);
  return largest;
}

Vector3 asArray(const Vector3d& v) { return {float(v.x()), float(v.y()), float(v.z())}; }

TEST_CASE("with an axis the field of a plane is the projection of the axis") {
  Mesh mesh = shaken(plane(12), 0.2f, 4);
  for (Vector3& p : mesh.positions)
    p[2] = 0.0f;
  for (const Vector3d& axis : {Vector3d(1.0, 0.0, 0.0), Vector3d(-0.3, 0.8, 0.5)})
    CHECK(largestDeviation(fieldOf(mesh, {}, asArray(axis)), axis, 0.0) < 1e-5);
}

TEST_CASE("with an axis the field of a ball follows it, and is singular at its ends") {
  // On a ball, the tangential part of the axis is an eigenvector of the smooth Laplacian. The
  // solution is a multiple of it. The smoothest field rotates it by a tenth of cos^2 over sin, and
  // the mesh by less than that. Where sin is at least 1/2, this is asin(0.1 * 0.75 / 0.5): 8
  // degrees.
  const Mesh mesh = ball(48, 24);
  const Vector3d axis = Vector3d(0.4, 1.0, 0.3).normalized();
  const DirectionField field = fieldOf(mesh, mesh.positions, asArray(axis));
  CHECK(largestDeviation(field, axis, 0.5) < std::asin(0.15));
  CHECK(largestDeviation(field, axis, 0.95) < std::asin(0.1 * 0.0975 / 0.95) + 0.01);
  REQUIRE(field.singularities.size() == 2);
  for (const FieldSingularity& singularity : field.singularities) {
    Vector3d middle = Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      middle += at(mesh.positions, mesh.triangles[3 * singularity.triangle + k]) / 3.0;
    // No nearer than the smoothest field moves it, asin(0.1), plus one triangle, 2 pi / 48.
    CHECK(std::abs(middle.normalized().dot(axis)) > std::cos(0.1 + 2.0 * pi / 48.0));
  }
}

TEST_CASE("with an axis along a tube its field follows the axis, and with an axis across it has no "
          "singularity") {
  const Mesh tube = grid(48, 16, [](auto i, auto j) -> Vector3d {
    const double around = 2.0 * pi * double(i % 48) / 48.0;
    return {std::cos(around), std::sin(around), double(j) / 8.0};
  });
  std::vector<Vector3> normals = tube.positions;
  for (Vector3& normal : normals)
    normal[2] = 0.0f;
  const DirectionField along = fieldOf(tube, normals, Vector3{0.0f, 0.0f, 1.0f});
  CHECK(largestDeviation(along, Vector3d::UnitZ(), 0.0) < 1e-4);
  CHECK(along.singularities.empty());
  const Vector3d across = Vector3d::UnitX();
  const DirectionField field = fieldOf(tube, normals, asArray(across));
  CHECK(field.singularities.empty());
  // As for the ball, plus the effect of smoothing on a wave around the tube: smoothing scales its
  // length by 1 / (1 + area / 100), area 4 pi, but does not shrink the smoothest field.
  CHECK(largestDeviation(field, across, 0.5) < std::atan(0.15 * (1.0 + 4.0 * pi / 100.0)));
  // The rotation is narrow: 12 degrees beside such a line, the axis' part is twice the smoothest
  // field's.
  CHECK(largestDeviation(field, across, std::sin(12.0 * pi / 180.0)) < pi / 6.0);
  // The axis' part has opposite signs on the two sides of a line where it vanishes. The field
  // rotates there; it does not flip from one column to the next.
  CHECK(largestTurn(tube, field) < pi / 2.0);
}

TEST_CASE("an axis of length 0 is an error") {
  const Mesh mesh = plane(2);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const Vector3 axis : {Vector3{}, Vector3{nan, 0.0f, 1.0f}}) {
    const auto field = directionField(mesh.positions, mesh.triangles, {}, {}, axis);
    REQUIRE(!field.ok());
    CHECK(field.error().kind == ErrorKind::usage);
  }
}

TEST_CASE(
    "tangent planes follow the given normals, or the area-weighted average if there are none") {
  const Mesh mesh = plane(4);
  std::vector<Vector3> leaning(mesh.positions.size(), Vector3{0.6f, 0.0f, 0.8f});
  CHECK(fieldOf(mesh, leaning).normals[7][0] == Approx(0.6));
  leaning[3] = {0.0f, 0.0f, 0.0f};
  CHECK(fieldOf(mesh, leaning).normals[3] == Vector3{0.0f, 0.0f, 1.0f});
  // Two walls that meet; the longer one has twice the area.
  Mesh corner;
  corner.positions = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 2}};
  corner.triangles = {0, 2, 1, 0, 1, 3};
  const Vector3 normal = fieldOf(corner).normals[0];
  CHECK(normal[0] == Approx(2.0 / std::sqrt(5.0)));
  CHECK(normal[2] == Approx(1.0 / std::sqrt(5.0)));
}

TEST_CASE("triangles of opposite winding form one surface") {
  Mesh mesh = ball(24, 12);
  std::mt19937 random(4);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3)
    if (random() % 3 == 0)
      std::swap(mesh.triangles[t], mesh.triangles[t + 1]);
  const DirectionField field = fieldOf(mesh, mesh.positions); // on a ball, positions are normals
  REQUIRE(field.components.size() == 1);
  CHECK(field.components[0].isClosed);
  CHECK(field.components[0].indexSum == 2);
  CHECK(largestTurn(mesh, field) < pi / 2.0);
}

TEST_CASE("the field is continuous across an edge with three triangles") {
  // A floor with a fin on the edge between its two halves.
  Mesh mesh = plane(8);
  for (std::uint32_t j = 0; j < 8; ++j) {
    const std::uint32_t a = j * 9 + 4, b = a + 9;
    const std::uint32_t top = mesh.add(Vector3d(4.0, double(j) + 0.5, 1.0));
    mesh.add({a, b, top});
  }
  const DirectionField field = fieldOf(mesh);
  for (std::uint32_t j = 1; j < 8; ++j)
    CHECK(angleBetween(field, j * 9 + 2, j * 9 + 6) < 0.1);
}

TEST_CASE("meshes without area and non-manifold meshes have a field") {
  Mesh odd;
  CHECK(fieldOf(odd).tangents.empty());
  odd.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {-0.0f, 0, 0}, {5, 5, 5}};
  CHECK(fieldOf(odd).components.empty()); // points only
  odd.triangles = {0, 1, 2, 0, 0, 1, 0, 4, 3, 3, 3, 3};
  CHECK(fieldOf(odd).components.size() == 1); // three collinear points, degenerate triangles
  odd.triangles = {0, 1, 3, 0, 3, 1, 0, 1, 3};
  CHECK(fieldOf(odd).components.size() == 1);
  // Two closed fans at one point, and a book of five pages.
  Mesh bow = ball(8, 4);
  Mesh second = bow;
  for (Vector3& p : second.positions)
    p[2] += 2.0f;
  bow.append(second);
  CHECK(fieldOf(bow).components.size() == 2);
  Mesh book;
  book.positions = {{0, 0, 0}, {0, 0, 1}};
  for (int page = 0; page < 5; ++page) {
    book.add(Vector3d(std::cos(page), std::sin(page), 0.5));
    book.add({0, 1, std::uint32_t(2 + page)});
  }
  CHECK(fieldOf(book).components.size() == 5);
  // Magnitudes near the largest and the smallest float in one mesh.
  Mesh extreme;
  extreme.positions = {
      {3e38f, 0, 0}, {-3e38f, 0, 0}, {0, 3e38f, 0}, {1e-45f, 0, 0}, {0, 1e-45f, 0}};
  extreme.triangles = {0, 1, 2, 0, 2, 3, 1, 3, 4, 3, 4, 0};
  (void)fieldOf(extreme);
}

TEST_CASE("random triangles give a valid field or an error") {
  std::mt19937 random(1);
  for (int round = 0; round < 40; ++round) {
    Mesh mesh;
    for (int i = 0; i < 30; ++i)
      mesh.add(Vector3d(double(random() % 4), double(random() % 4), double(random() % 3)));
    for (int i = 0; i < 3 * 60; ++i)
      mesh.triangles.push_back(std::uint32_t(random() % 30));
    for (const FieldComponent& component : fieldOf(mesh).components)
      CHECK((!component.isClosed || component.indexSum == component.eulerCharacteristic));
  }
}

TEST_CASE("invalid meshes are errors") {
  const std::vector<Vector3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<std::uint32_t> triangle{0, 1, 2}, outside{0, 1, 3};
  const auto kindOf = [](const Result<DirectionField>& result) {
    REQUIRE(!result.ok());
    return result.error().kind;
  };
  CHECK(kindOf(directionField(positions, outside)) == ErrorKind::badInput);
  const std::vector<Vector3> normals(2, {0, 0, 1});
  CHECK(kindOf(directionField(positions, triangle, normals)) == ErrorKind::badInput);
  std::vector<Vector3> bad = positions;
  bad[1][1] = std::numeric_limits<float>::quiet_NaN();
  CHECK(kindOf(directionField(bad, triangle)) == ErrorKind::badInput);
  bad[1][1] = std::numeric_limits<float>::infinity();
  CHECK(kindOf(directionField(bad, triangle)) == ErrorKind::badInput);
  const std::vector<std::uint32_t> many(3 * (kMostFieldTriangles + 1), 0);
  CHECK(kindOf(directionField(positions, many)) == ErrorKind::resources);
}

TEST_CASE("triangles whose factorization would exhaust memory are an error") {
  // Vertices of a random graph, whose elimination fills much of the matrix.
  std::mt19937 random(9);
  Mesh mesh;
  for (int i = 0; i < 200'000; ++i)
    mesh.add(Vector3d(double(random() % 100'000), double(random() % 100'000), double(i)));
  for (std::size_t i = 0; i < 3 * 150'000; ++i)
    mesh.triangles.push_back(std::uint32_t(random() % 200'000));
  const Result<DirectionField> field = directionField(mesh.positions, mesh.triangles);
  REQUIRE(!field.ok());
  CHECK(field.error().kind == ErrorKind::badInput);
}
