// SPDX-License-Identifier: MIT
// The preview scene: its geometry is consistent and matches the documentation.
#include "bundle_example.h"
#include "bundle_surgery.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace lichen;
using example::GlbParts;

namespace {

struct Vec {
  double x = 0, y = 0, z = 0;
};
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec cross(Vec a, Vec b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double length(Vec a) { return std::sqrt(dot(a, a)); }

GlbParts scene(PreviewShape shape) {
  BundleFile file = example::everyMap();
  file.shape = shape;
  return GlbParts(encodeGlb(file).value());
}

/// The components of an accessor, tightly packed as the writer packs them.
template <class T>
std::vector<T> read(GlbParts& parts, const nlohmann::json& index, std::size_t components) {
  const nlohmann::json& accessor = parts.json["accessors"][index.get<std::size_t>()];
  const nlohmann::json& view = parts.json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  std::vector<T> values(accessor["count"].get<std::size_t>() * components);
  REQUIRE(view["byteLength"] == values.size() * sizeof(T));
  std::memcpy(values.data(), parts.binary.data() + view["byteOffset"].get<std::size_t>(),
              values.size() * sizeof(T));
  return values;
}

struct Geometry {
  std::vector<float> positions, normals, uvs, tangents;
  std::vector<std::uint16_t> indices;

  Geometry(GlbParts& parts, const nlohmann::json& primitive)
      : positions(read<float>(parts, primitive["attributes"]["POSITION"], 3)),
        normals(read<float>(parts, primitive["attributes"]["NORMAL"], 3)),
        uvs(read<float>(parts, primitive["attributes"]["TEXCOORD_0"], 2)),
        indices(read<std::uint16_t>(parts, primitive["indices"], 1)) {
    if (primitive["attributes"].contains("TANGENT"))
      tangents = read<float>(parts, primitive["attributes"]["TANGENT"], 4);
  }
  [[nodiscard]] Vec position(std::size_t i) const {
    return {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]};
  }
  [[nodiscard]] Vec normal(std::size_t i) const {
    return {normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]};
  }
  [[nodiscard]] Vec tangent(std::size_t i) const {
    return {tangents[4 * i], tangents[4 * i + 1], tangents[4 * i + 2]};
  }
};

/// A triangle's area on the surface and in texture coordinates, and the direction on it in which u
/// grows. The area in texture coordinates is positive if, seen from outside, u points right and v
/// down.
struct Triangle {
  double area = 0, uvArea = 0;
  Vec normal, alongU;

  Triangle(const Geometry& g, std::size_t first) {
    const std::size_t a = g.indices[first], b = g.indices[first + 1], c = g.indices[first + 2];
    const Vec e1 = g.position(b) - g.position(a);
    const Vec e2 = g.position(c) - g.position(a);
    normal = cross(e1, e2);
    area = length(normal) / 2;
    const double u1 = double(g.uvs[2 * b]) - g.uvs[2 * a], u2 = double(g.uvs[2 * c]) - g.uvs[2 * a];
    const double v1 = double(g.uvs[2 * b + 1]) - g.uvs[2 * a + 1];
    const double v2 = double(g.uvs[2 * c + 1]) - g.uvs[2 * a + 1];
    uvArea = (u2 * v1 - u1 * v2) / 2;
    alongU = v2 * e1 - v1 * e2;
    alongU = (u1 * v2 - u2 * v1 < 0 ? -1.0 : 1.0) * alongU;
  }
};

} // namespace

TEST_CASE("every triangle of the preview faces outwards and has its texture upright") {
  for (const PreviewShape shape : {PreviewShape::sphere, PreviewShape::plane}) {
    GlbParts parts = scene(shape);
    for (const nlohmann::json& mesh : parts.json["meshes"])
      for (const nlohmann::json& primitive : mesh["primitives"]) {
        const Geometry g(parts, primitive);
        for (std::size_t i = 0; i < g.indices.size(); i += 3) {
          const Triangle triangle(g, i);
          REQUIRE(triangle.area > 0.0);
          REQUIRE(dot(triangle.normal, g.normal(g.indices[i])) > 0.0);
          REQUIRE(triangle.uvArea > 0.0);
        }
      }
  }
}

TEST_CASE("one exemplar spans the same area everywhere on the ball and on the ground") {
  GlbParts parts = scene(PreviewShape::sphere);
  // The example's Gaussian images are twice as wide as high, and preserve that shape on the
  // surface.
  constexpr double kExemplarsPerSquareMetre = 1.5 * (2.0 * 1.5);
  for (const nlohmann::json& mesh : parts.json["meshes"]) {
    const Geometry g(parts, mesh["primitives"][0]);
    const bool isBall = mesh["name"] != "ground";
    double area = 0, uvArea = 0;
    for (std::size_t i = 0; i < g.indices.size(); i += 3) {
      const Triangle triangle(g, i);
      area += triangle.area;
      uvArea += triangle.uvArea;
      // Towards the back of the ball, texture triangles become less similar to surface triangles.
      if (!isBall || g.position(g.indices[i]).z > 0.0)
        REQUIRE(triangle.uvArea / triangle.area == Approx(kExemplarsPerSquareMetre).epsilon(0.02));
    }
    CHECK(uvArea / area == Approx(kExemplarsPerSquareMetre).epsilon(0.02));
  }
}

TEST_CASE("the ground shows an exemplar with the proportions that its textons state") {
  BundleFile file = example::smallestTexton();
  file.bundle.noises[0].as<TextonShape>().texelsPerTileX *= 3; // the image becomes as wide as high
  file.shape = PreviewShape::plane;
  GlbParts parts(encodeGlb(file).value());
  const Geometry ground(parts, parts.json["meshes"][0]["primitives"][0]);
  REQUIRE_FALSE(ground.indices.empty());
  for (std::size_t i = 0; i < ground.indices.size(); i += 3) {
    const Triangle triangle(ground, i);
    CHECK(triangle.uvArea / triangle.area == Approx(1.5 * (3.0 * 1.5)).epsilon(0.02));
  }
}

TEST_CASE("tangents are unit vectors along u, and exist exactly if there is a normal texture") {
  for (const PreviewShape shape : {PreviewShape::sphere, PreviewShape::plane}) {
    GlbParts parts = scene(shape);
    for (const nlohmann::json& mesh : parts.json["meshes"])
      for (const nlohmann::json& primitive : mesh["primitives"]) {
        const nlohmann::json& material =
            parts.json["materials"][primitive["material"].get<std::size_t>()];
        CHECK(primitive["attributes"].contains("TEXCOORD_0"));
        REQUIRE(primitive["attributes"].contains("TANGENT") == material.contains("normalTexture"));
        if (!material.contains("normalTexture"))
          continue;
        const Geometry g(parts, primitive);
        for (std::size_t i = 0; i < g.indices.size(); i += 3) {
          const std::size_t vertex = g.indices[i];
          const Vec tangent = g.tangent(vertex);
          REQUIRE(length(tangent) == Approx(1.0).epsilon(1e-5));
          REQUIRE(std::abs(dot(tangent, g.normal(vertex))) < 1e-5);
          REQUIRE(g.tangents[4 * vertex + 3] == 1.0f);
          const Vec alongU = Triangle(g, i).alongU;
          if (g.position(vertex).z > 0.0 || mesh["name"] == "ground") // the visible side
            REQUIRE(dot(tangent, alongU) / length(alongU) > 0.99);
        }
      }
  }
}

TEST_CASE("a ball rests on the ground in front of the camera, which sees the horizon above its "
          "middle") {
  GlbParts parts = scene(PreviewShape::sphere);
  Vec eye;
  double pitch = 0;
  for (const nlohmann::json& node : parts.json["nodes"]) {
    if (node["name"] == "ball 0")
      CHECK(node["translation"][1] == 1.0);
    if (node["name"] == "camera") {
      eye = {node["translation"][0], node["translation"][1], node["translation"][2]};
      pitch = 2.0 * std::asin(node["rotation"][0].get<double>());
    }
  }
  const double fieldOfView = parts.json["cameras"][0]["perspective"]["yfov"];
  CHECK(eye.z > 2.0);
  CHECK(pitch < 0.0);
  CHECK(-pitch < fieldOfView / 2.0);
}

TEST_CASE("a preview image spans its exemplars at the noise's own scale, offset and rotation") {
  const GlbParts parts = scene(PreviewShape::sphere);
  const nlohmann::json& material = parts.json["materials"][1];
  const nlohmann::json& transform =
      material["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"];
  // everyMap(): scale 0.25, offset (0.5, -3), rotation 0.1, 2 exemplars per image.
  CHECK(transform["scale"] == nlohmann::json({2.0, 2.0}));
  CHECK(transform["offset"] == nlohmann::json({0.25, -1.5}));
  CHECK(transform["rotation"] == 0.1);
  CHECK(material["name"] == "wet moss");
  CHECK(material["alphaMode"] == "BLEND");
}

TEST_CASE("factors are 1 for channels of the noise and stand in for missing channels") {
  const GlbParts parts = scene(PreviewShape::sphere);
  const nlohmann::json& felt = parts.json["materials"][0]["pbrMetallicRoughness"];
  CHECK(felt["metallicFactor"] == 0.0);
  CHECK(felt["roughnessFactor"] == 0.8);
  const nlohmann::json& moss = parts.json["materials"][1]["pbrMetallicRoughness"];
  CHECK(moss["metallicFactor"] == 1.0);
  CHECK(moss["roughnessFactor"] == 1.0);
}

TEST_CASE("inconsistent parts of a bundle file are an error") {
  const auto refused = [](const std::function<void(BundleFile&)>& change) {
    BundleFile file = example::everyMap();
    change(file);
    const auto glb = encodeGlb(file);
    return !glb.ok() && glb.error().kind == ErrorKind::usage;
  };
  CHECK(refused([](BundleFile& f) { f.bundle.noises.clear(); }));
  CHECK(refused([](BundleFile& f) { f.previews.pop_back(); }));
  CHECK(refused([](BundleFile& f) { f.bundle.materials.pop_back(); }));
  CHECK(refused([](BundleFile& f) { f.bundle.materials[1].reset(); }));
  CHECK(refused([](BundleFile& f) { f.bundle.materials[1]->noise = 2; }));
  CHECK(refused([](BundleFile& f) { f.bundle.materials[1]->texCoord = 1; }));
  CHECK(refused([](BundleFile& f) { f.bundle.materials[1]->contrast = 7.0; }));
  CHECK(refused([](BundleFile& f) { f.previews[0].tilesPerImage = 0; }));
  CHECK(refused([](BundleFile& f) { f.bundle.noises[0].maps[0].mean[0] = std::nan(""); }));
  CHECK(refused([](BundleFile& f) { f.bundle.noises[0].maps[0].as<TilingMap>().gaussian = 100; }));
  CHECK(refused([](BundleFile& f) { f.bundle.noises[0].name = "\xff"; }));
}
