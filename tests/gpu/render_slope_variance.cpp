// SPDX-License-Identifier: MIT
// Bumps that a pixel hides: the highlight of a plane with a normal noise, seen from afar.
#include "rendered.h"

#include <lichen/bundle_writer.h>
#include <lichen/lattice.h>
#include <lichen/tiling.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace lichen;
using namespace lichen::test;
using renderer::RenderSettings;

namespace {

constexpr int kTexels = 64;    // a side of the exemplar
constexpr float kTiles = 4.0f; // across the plane

/// Slopes of a smooth random height, with a deviation of 0.12 along each axis: most of the plane
/// leans by less than 15 degrees.
MapExemplar bumps() {
  constexpr float kDeviation = 0.12f;
  const auto height = [](int x, int y) { // white noise, averaged over 3 x 3
    float sum = 0.0f;
    for (int dy = 0; dy < 3; ++dy)
      for (int dx = 0; dx < 3; ++dx)
        sum += float(pcg3d({std::uint32_t((x + dx) % kTexels), std::uint32_t((y + dy) % kTexels),
                            7u})[0] >>
                     8u) *
               0x1p-24f;
    return sum;
  };
  MapExemplar map;
  map.target = MapTarget::normal;
  map.channels = {MapChannel::slopeX, MapChannel::slopeY};
  map.encoding = ValueEncoding::slope;
  map.width = map.height = kTexels;
  for (int y = 0; y < kTexels; ++y)
    for (int x = 0; x < kTexels; ++x)
      map.values.insert(map.values.end(),
                        {height(x + 1, y) - height(x, y), height(x, y) - height(x, y + 1)});
  const float squares =
      std::inner_product(map.values.begin(), map.values.end(), map.values.begin(), 0.0f);
  for (float& value : map.values)
    value *= kDeviation / std::sqrt(squares / float(map.values.size()));
  return map;
}

BundleFile bumpyBundle(const MapExemplar& map) {
  TilingOptions options;
  options.periodic = Periodic::yes;
  options.gaussian = GaussianOnly::no; // they nearly are, and this is about the table
  Result<TilingBake> bake = bakeTiling("bumps", {&map, 1}, options);
  REQUIRE(bake);
  BundleFile file;
  file.bundle.tables = std::move(bake.value().tables);
  file.bundle.noises = {std::move(bake.value().noise)};
  file.bundle.materials.emplace_back(MaterialNoise{});
  file.previews.emplace_back();
  file.shape = PreviewShape::none;
  file.generator = "lichen tests";
  return file;
}

/// Takes the slopes' variance out of a bundle's table.
void forgetVariance(Bundle& bundle) {
  Table& table = bundle.tables[*bundle.noises[0].maps[0].inverseTable];
  std::vector<float> texels = decodeLevel(table, 0);
  for (std::size_t i = 2; i < texels.size(); i += 4)
    texels[i] = 0.0f;
  table.texels.clear();
  appendTexels(table.texels, table.format, texels);
}

/// A metallic plane that faces an orthographic camera, lit from `lightAngle` above the view.
GltfScene planeUnder(const BundleFile& file, double lightAngle) {
  GltfScene scene(encodeGlb(file).value());
  scene.json["materials"][0]["pbrMetallicRoughness"] = {{"metallicFactor", 1},
                                                        {"roughnessFactor", 0.2}};
  const float h = kTiles / 2;
  scene.addMesh({{"POSITION", scene.addFloats({-h, h, 0, -h, -h, 0, h, -h, 0, h, h, 0}, 3)},
                 {"NORMAL", scene.addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 3)},
                 {"TANGENT", scene.addFloats({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, 4)},
                 {"TEXCOORD_0", scene.addFloats({0, 0, 0, kTiles, kTiles, kTiles, kTiles, 0}, 2)}},
                scene.addIndices({0, 1, 2, 0, 2, 3}, 1), 0);
  nlohmann::json& json = scene.json;
  json["cameras"].push_back(
      {{"type", "orthographic"},
       {"orthographic", {{"xmag", h}, {"ymag", h}, {"znear", 0.1}, {"zfar", 10}}}});
  json["nodes"].push_back({{"camera", json["cameras"].size() - 1}, {"translation", {0, 0, 5}}});
  json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
  scene.addSun(1.0f);
  json["nodes"].back()["rotation"] = {-std::sin(lightAngle / 2), 0, 0, std::cos(lightAngle / 2)};
  return scene;
}

RenderSettings lightOnly(std::uint32_t side) {
  RenderSettings settings = settingsOf(side, side, 1);
  settings.toneMap = false;
  settings.environment = LinearImage(8, 4, 3);
  return settings;
}

double meanRadiance(const LinearImage& image) {
  return std::accumulate(image.values.begin(), image.values.end(), 0.0) /
         double(image.values.size());
}

} // namespace

TEST_CASE("a bumpy plane seen from afar reflects as much as one whose bumps are drawn") {
  const BundleFile bumpy = bumpyBundle(bumps());
  BundleFile flat = bumpy;
  forgetVariance(flat.bundle);
  constexpr std::uint32_t kFar = 16;                               // 16 texels a pixel
  constexpr std::uint32_t kNear = std::uint32_t(kTiles) * kTexels; // one
  for (const double degrees : {2.0, 12.0, 24.0}) {
    const double angle = degrees * 3.14159265358979 / 180.0;
    const GltfScene scene = planeUnder(bumpy, angle);
    const double drawn = meanRadiance(render(scene.glb(), lightOnly(kNear)));
    const double hidden = meanRadiance(render(scene.glb(), lightOnly(kFar)));
    const double forgotten = meanRadiance(render(planeUnder(flat, angle).glb(), lightOnly(kFar)));
    INFO(degrees << " degrees: drawn " << drawn << ", hidden " << hidden << ", forgotten "
                 << forgotten);
    // Slopes whose variances add are Beckmann's; the GGX of the same alpha is lower by up to 30 %
    // between one and two deviations from the middle, where the last light has its reflection.
    CHECK(std::abs(hidden / drawn - 1.0) < 0.35);
    CHECK(std::abs(hidden / drawn - 1.0) < 0.4 * std::abs(forgotten / drawn - 1.0));
  }
}

TEST_CASE("rotating a noise turns its slopes with it, and not their variance") {
  MapExemplar slope = bumps();
  for (std::size_t i = 0; i < slope.values.size(); i += 2) {
    slope.values[i] = 0.3f;
    slope.values[i + 1] = 0.0f;
  }
  BundleFile file = bumpyBundle(slope);
  constexpr double kTurn = 0.7;
  file.bundle.materials[0]->rotation = kTurn;
  RenderSettings settings = lightOnly(8);
  settings.debugView = "normals";
  const LinearImage normals = render(planeUnder(file, 0.0).glb(), settings);
  // The height is 0.3 x, x = cos u + sin v: it rises by 0.3 cos to the right and 0.3 sin downwards.
  const std::array<double, 3> normal{-0.3 * std::cos(kTurn), 0.3 * std::sin(kTurn), 1.0};
  const double length = std::hypot(0.3, 1.0);
  for (std::size_t c = 0; c < 3; ++c) // an 11-bit half of 0.3, and an 8-bit or half target
    CHECK(double(normals.pixel(4, 4)[c]) ==
          Approx(0.5 + 0.5 * normal[c] / length).margin(2.0 / 255.0));
}
