// SPDX-License-Identifier: MIT
// The preview scene: one ball of radius 1 per noise on a common ground, lit by a sun from the upper
// left. The camera is low in front of the balls, or higher if they form several rows. Units are
// metres, +Y is up, and the camera looks along -Z. Texture coordinates count exemplars if the
// material's scale is 1.
// Source of the ball's mapping: J. P. Snyder, Map Projections, 1987, ch. 24 (Lambert azimuthal
// equal-area): radius 2 sin(theta / 2) at the angle theta from the centre.
#include "preview_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

using Vec3 = std::array<float, 3>;

struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
  std::vector<std::array<float, 4>> tangents;
  std::vector<std::array<float, 2>> uvs;
  std::vector<std::uint16_t> indices;
};

// A ball's diameter spans about three exemplars: enough to distinguish noise from repetition, and
// few enough to show the texture's detail.
constexpr double kExemplarsPerMetre = 1.5;
constexpr double kBallSpacing = 2.5;
constexpr double kCameraFieldOfView = 36.0 * std::numbers::pi / 180.0; // vertical
constexpr double kCameraElevation = 8.0 * std::numbers::pi / 180.0;
/// For several rows: a row kRowSpacing behind another appears above it, since kRowSpacing *
/// sin(kRowsElevation) is a ball's diameter.
constexpr double kRowsElevation = 45.0 * std::numbers::pi / 180.0;
constexpr double kRowSpacing = 2.0 * std::numbers::sqrt2;
constexpr double kCameraDistance = 4.8;     // one ball fills two thirds of the height
constexpr double kCameraTargetHeight = 0.9; // a little below the ball's centre
constexpr double kMarginAroundBalls = 1.25;

std::array<double, 3> combine(double a, const std::array<double, 3>& x, double b,
                              const std::array<double, 3>& y) {
  return {a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]};
}

std::array<double, 3> normalized(const std::array<double, 3>& v) {
  const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

Vec3 toFloat(const std::array<double, 3>& v) { return {float(v[0]), float(v[1]), float(v[2])}; }

/// Triangles of the sectors [first, last) of a polar grid, counter-clockwise. Vertex 0 is the
/// centre, followed by `rings` rings of `sectors` vertices from the inside out.
std::vector<std::uint16_t> polarIndices(int rings, int sectors, int first, int last) {
  std::vector<std::uint16_t> indices;
  const auto vertex = [sectors](int ring, int sector) {
    return std::uint16_t(1 + ring * sectors + sector % sectors);
  };
  for (int s = first; s < last; ++s)
    indices.insert(indices.end(), {0, vertex(0, s), vertex(0, s + 1)});
  for (int r = 0; r + 1 < rings; ++r)
    for (int s = first; s < last; ++s)
      indices.insert(indices.end(), {vertex(r, s), vertex(r + 1, s), vertex(r + 1, s + 1),
                                     vertex(r, s), vertex(r + 1, s + 1), vertex(r, s + 1)});
  return indices;
}

/// A sphere of radius 1 about the origin, mapped from the side that faces `toCamera` (a unit vector
/// in the plane x = 0). The projection's only singular point is on the far side, so no seam or pole
/// is visible.
Mesh makeBall(const std::array<double, 3>& toCamera, double exemplarAspect) {
  constexpr int kRings = 48;
  constexpr int kSectors = 96;
  const std::array<double, 3> right = {1.0, 0.0, 0.0};
  const std::array<double, 3> up = {0.0, toCamera[2], -toCamera[1]}; // toCamera x right
  Mesh mesh;
  const auto addVertex = [&](double theta, double phi) {
    const auto outward = combine(std::cos(phi), right, std::sin(phi), up);
    const auto position = combine(std::cos(theta), toCamera, std::sin(theta), outward);
    const auto alongTheta = combine(-std::sin(theta), toCamera, std::cos(theta), outward);
    const auto alongPhi = combine(-std::sin(phi), right, std::cos(phi), up);
    // The direction in which u grows, from the projection's derivative 2 cos(theta / 2) along theta
    // and its inverse's 1 / cos(theta / 2) along phi. The lower bound keeps it from vanishing at
    // the far point.
    const double squash = std::max(1e-3, std::pow(std::cos(theta / 2.0), 2.0));
    const auto tangent =
        toFloat(normalized(combine(std::cos(phi), alongTheta, -std::sin(phi) * squash, alongPhi)));
    const double radius = 2.0 * std::sin(theta / 2.0) * kExemplarsPerMetre;
    mesh.positions.push_back(toFloat(position));
    mesh.normals.push_back(toFloat(position));
    mesh.tangents.push_back({tangent[0], tangent[1], tangent[2], 1.0f});
    // The centre of an exemplar faces the camera.
    mesh.uvs.push_back({float(0.5 + radius * std::cos(phi)),
                        float(0.5 - exemplarAspect * radius * std::sin(phi))});
  };
  addVertex(0.0, 0.0);
  for (int r = 1; r <= kRings; ++r)
    for (int s = 0; s < kSectors; ++s) // the last ring is the far point, offset by half a sector
      addVertex(std::numbers::pi * r / kRings,
                2.0 * std::numbers::pi * (s + (r == kRings ? 0.5 : 0.0)) / kSectors);
  mesh.indices = polarIndices(kRings - 1, kSectors, 0, kSectors);
  const auto lastRing = std::uint16_t(1 + (kRings - 2) * kSectors);
  for (int s = 0; s < kSectors; ++s)
    mesh.indices.insert(mesh.indices.end(),
                        {std::uint16_t(lastRing + s), std::uint16_t(lastRing + kSectors + s),
                         std::uint16_t(lastRing + (s + 1) % kSectors)});
  return mesh;
}

/// A disc in the plane y = 0. The ring radii double, so that texture coordinates stay precise near
/// the camera. The edge is 0.2 degrees below the horizon.
constexpr int kGroundRings = 11;
Mesh makeGround(double exemplarAspect) {
  constexpr double kFirstRadius = 0.5; // metres; the last is 512
  Mesh mesh;
  const auto addVertex = [&](double x, double z) {
    mesh.positions.push_back({float(x), 0.0f, float(z)});
    mesh.normals.push_back({0.0f, 1.0f, 0.0f});
    mesh.tangents.push_back({1.0f, 0.0f, 0.0f, 1.0f});
    mesh.uvs.push_back(
        {float(x * kExemplarsPerMetre), float(exemplarAspect * z * kExemplarsPerMetre)});
  };
  addVertex(0.0, 0.0);
  for (int r = 0; r < kGroundRings; ++r)
    for (int s = 0; s < kGroundSectors; ++s) {
      const double radius = std::ldexp(kFirstRadius, r);
      const double phi = 2.0 * std::numbers::pi * s / kGroundSectors;
      addVertex(radius * std::cos(phi), -radius * std::sin(phi));
    }
  return mesh;
}

/// Adds the accessors of a mesh; tangents only if a material needs them.
Json addAttributes(GltfBuilder& builder, const Mesh& mesh, bool withTangents) {
  Json attributes = {{"POSITION", builder.addVertices<3>(mesh.positions, true)},
                     {"NORMAL", builder.addVertices<3>(mesh.normals)},
                     {"TEXCOORD_0", builder.addVertices<2>(mesh.uvs)}};
  if (withTangents)
    attributes["TANGENT"] = builder.addVertices<4>(mesh.tangents);
  return attributes;
}

void addPrimitive(Json& mesh, Json attributes, std::size_t indices, std::size_t material,
                  bool withTangents) {
  if (!withTangents)
    attributes.erase("TANGENT");
  mesh["primitives"].push_back(
      {{"attributes", std::move(attributes)}, {"indices", indices}, {"material", material}});
}

bool any(const std::vector<bool>& values) {
  return std::find(values.begin(), values.end(), true) != values.end();
}

/// Adds the ground, divided into one sector per element of `needsTangents`.
void addGround(Json& root, GltfBuilder& builder, const std::vector<bool>& needsTangents,
               double exemplarAspect) {
  const std::size_t materials = needsTangents.size();
  const Json attributes = addAttributes(builder, makeGround(exemplarAspect), any(needsTangents));
  Json mesh = {{"name", "ground"}};
  for (std::size_t i = 0; i < materials; ++i) {
    const auto sector = [&](std::size_t part) {
      return int(std::size_t(kGroundSectors) * part / materials);
    };
    const auto indices = polarIndices(kGroundRings, kGroundSectors, sector(i), sector(i + 1));
    addPrimitive(mesh, attributes, builder.addIndices(indices), i, needsTangents[i]);
  }
  root["nodes"].push_back({{"name", "ground"}, {"mesh", root["meshes"].size()}});
  root["meshes"].push_back(std::move(mesh));
}

/// The horizontal position of a ball's centre: x to the right, z towards the camera.
struct BallPlace {
  double x = 0.0;
  double z = 0.0;
};

/// Ball centres in rows about the origin, in a nearly square grid; two balls lie side by side.
std::vector<BallPlace> ballPlaces(std::size_t balls) {
  const auto columns = std::size_t(std::ceil(std::sqrt(double(balls))));
  const std::size_t rows = (balls + columns - 1) / columns;
  std::vector<BallPlace> places;
  for (std::size_t i = 0; i < balls; ++i) {
    const std::size_t row = i / columns;
    const std::size_t inRow = std::min(columns, balls - row * columns);
    const auto centred = [](std::size_t place, std::size_t count) {
      return double(place) - (double(count) - 1.0) / 2.0;
    };
    places.push_back(
        {kBallSpacing * centred(i % columns, inRow), kRowSpacing * centred(row, rows)});
  }
  return places;
}

/// Adds one ball per material.
void addBalls(Json& root, GltfBuilder& builder, const std::array<double, 3>& eye,
              const std::vector<bool>& needsTangents, double exemplarAspect) {
  const Mesh ball = makeBall(normalized({0.0, eye[1] - 1.0, eye[2]}), exemplarAspect);
  const Json attributes = addAttributes(builder, ball, any(needsTangents));
  const std::size_t indices = builder.addIndices(ball.indices);
  const std::vector<BallPlace> places = ballPlaces(needsTangents.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    Json mesh = {{"name", "ball " + std::to_string(i)}};
    addPrimitive(mesh, attributes, indices, i, needsTangents[i]);
    root["nodes"].push_back({{"name", mesh["name"]},
                             {"translation", {places[i].x, 1.0, places[i].z}},
                             {"mesh", root["meshes"].size()}});
    root["meshes"].push_back(std::move(mesh));
  }
}

/// Quaternion (x, y, z, w) of a rotation about +X by `pitch`, then about +Y by `yaw`.
Json rotation(double yaw, double pitch) {
  const double sy = std::sin(yaw / 2.0), cy = std::cos(yaw / 2.0);
  const double sp = std::sin(pitch / 2.0), cp = std::cos(pitch / 2.0);
  return {cy * sp, sy * cp, -sy * sp, cy * cp};
}

/// The camera distance at which a square image contains all balls.
double cameraDistance(const std::vector<BallPlace>& balls, double elevation) {
  double distance = kCameraDistance;
  for (const BallPlace& ball : balls) {
    const double fromMiddle =
        1.0 + std::max(std::abs(ball.x), std::abs(ball.z) * std::sin(elevation));
    const double towardCamera = ball.z * std::cos(elevation);
    distance = std::max(distance, towardCamera + kMarginAroundBalls * fromMiddle /
                                                     std::tan(kCameraFieldOfView / 2.0));
  }
  return distance;
}

void addCameraAndSun(Json& root, const std::array<double, 3>& eye, double elevation) {
  root["nodes"].push_back({{"name", "camera"},
                           {"translation", eye},
                           {"rotation", rotation(0.0, -elevation)},
                           {"camera", 0}});
  root["cameras"].push_back(
      {{"name", "camera"},
       {"type", "perspective"},
       {"perspective", {{"yfov", kCameraFieldOfView}, {"znear", 0.1}, {"zfar", 2000.0}}}});
  // From the upper left and slightly behind the camera, so that relief is visible in the shading.
  constexpr double kSunYaw = -50.0 * std::numbers::pi / 180.0;
  constexpr double kSunPitch = -42.0 * std::numbers::pi / 180.0;
  constexpr double kSunLux = 3.0; // about pi: white paper facing the sun has radiance 1
  root["nodes"].push_back({{"name", "sun"},
                           {"rotation", rotation(kSunYaw, kSunPitch)},
                           {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  root["extensionsUsed"].push_back("KHR_lights_punctual");
  root["extensions"]["KHR_lights_punctual"]["lights"].push_back({{"name", "sun"},
                                                                 {"type", "directional"},
                                                                 {"color", {1.0, 0.95, 0.88}},
                                                                 {"intensity", kSunLux}});
}

} // namespace

void addPreviewScene(Json& root, GltfBuilder& builder, PreviewShape shape,
                     const std::vector<bool>& needsTangents, double exemplarAspect) {
  if (shape == PreviewShape::none)
    return;
  const bool withBalls = shape == PreviewShape::sphere;
  const std::vector<BallPlace> balls = ballPlaces(withBalls ? needsTangents.size() : 1);
  const double elevation = balls.front().z < 0.0 ? kRowsElevation : kCameraElevation;
  const double distance = cameraDistance(balls, elevation);
  const std::array<double, 3> eye = {0.0, kCameraTargetHeight + distance * std::sin(elevation),
                                     distance * std::cos(elevation)};
  root["nodes"] = Json::array();
  root["meshes"] = Json::array();
  const std::vector<bool> first(1, needsTangents.front());
  addGround(root, builder, withBalls ? first : needsTangents, exemplarAspect);
  if (withBalls)
    addBalls(root, builder, eye, needsTangents, exemplarAspect);
  addCameraAndSun(root, eye, elevation);
  Json nodeIndices = Json::array();
  for (std::size_t i = 0; i < root["nodes"].size(); ++i)
    nodeIndices.push_back(i);
  root["scene"] = 0;
  root["scenes"].push_back({{"nodes", std::move(nodeIndices)}});
}

} // namespace lichen
