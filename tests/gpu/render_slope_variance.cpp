// SPDX-License-Identifier: MIT
// Bumps smaller than a pixel: the highlight of a plane with a normal noise, and the light of
// coloured bumps, from a distance.
#include "../property/bundle_of.h"
#include "lit_views.h"
#include "rendered.h"

#include <lichen/bundle_writer.h>
#include <lichen/lattice.h>
#include <lichen/texton.h>
#include <lichen/tiling.h>

#include <algorithm>
#include <cmath>
#include <numeric>

using namespace lichen;
using namespace lichen::test;
using renderer::RenderSettings;

namespace {

constexpr int kTexels = 64;    // per side of the exemplar
constexpr float kTiles = 4.0f; // across the plane

/// Slopes of a smooth random height field with a deviation of 0.12 along each axis: most of the
/// plane tilts by less than 15 degrees.
MapExemplar bumps() {
  constexpr float kDeviation = 0.12f;
  const auto height = [](int x, int y) { // white noise, averaged over 3 x 3 twice
    float sum = 0.0f;
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx)
        sum += float((3 - std::abs(dx)) * (3 - std::abs(dy))) * 0x1p-24f *
               float(pcg3d({std::uint32_t((x + dx + kTexels) % kTexels),
                            std::uint32_t((y + dy + kTexels) % kTexels), 7u})[0] >>
                     8u);
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

/// Fraction of the way from a texel to the next where interpolation loses what it loses on average,
/// f (1 - f) = 1/6.
const double kBetweenTexels = 0.5 - std::sqrt(1.0 / 12.0);

/// A map that repeats, interpolated there along both axes.
MapExemplar betweenTexels(const MapExemplar& map) {
  MapExemplar result = map;
  const auto at = [&](int x, int y, int c) {
    return map.values[std::size_t((y % map.height * map.width + x % map.width) * 2 + c)];
  };
  const auto t = float(kBetweenTexels);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      for (int c = 0; c < 2; ++c)
        result.values[std::size_t((y * map.width + x) * 2 + c)] =
            std::lerp(std::lerp(at(x, y, c), at(x + 1, y, c), t),
                      std::lerp(at(x, y + 1, c), at(x + 1, y + 1, c), t), t);
  return result;
}

/// With one texel a pixel, all pixels show it there.
template <class Bake>
BundleFile bundleFileOf(Result<Bake> bake) {
  BundleFile file;
  file.bundle = bundleOf(std::move(bake));
  MaterialNoise between;
  between.offset = {kBetweenTexels / kTexels, kBetweenTexels / kTexels};
  file.bundle.materials.emplace_back(between);
  file.previews.emplace_back();
  file.shape = PreviewShape::none;
  file.generator = "lichen tests";
  return file;
}

BundleFile bumpyBundle(const MapExemplar& map) {
  TilingOptions options;
  options.periodic = Periodic::yes;
  options.gaussian = GaussianOnly::no; // they are almost Gaussian, and this test needs the table
  return bundleFileOf(bakeTiling("bumps", {&map, 1}, options));
}

/// Colours of the bumps: the higher the slope to the right, the lighter.
std::vector<MapExemplar> colouredBumps() {
  MapExemplar colours;
  colours.channels = {MapChannel::red, MapChannel::green, MapChannel::blue};
  const MapExemplar map = bumps();
  colours.width = map.width;
  colours.height = map.height;
  for (std::size_t i = 0; i < map.values.size(); i += 2) {
    const float light = std::clamp(0.5f + 1.5f * map.values[i], 0.05f, 0.95f);
    colours.values.insert(colours.values.end(), {light, 0.8f * light, 0.5f});
  }
  return {colours, map};
}

/// Removes the slope variance from all levels of a bundle's table.
void removeVariance(Bundle& bundle) {
  Table& table = bundle.tables[*bundle.noises[0].maps[0].as<TilingMap>().inverseTable];
  std::vector<std::byte> without;
  for (std::uint32_t level = 0; level < table.mipLevels; ++level) {
    std::vector<float> texels = decodeLevel(table, level);
    for (std::size_t i = 2; i < texels.size(); i += 4)
      texels[i] = 0.0f;
    appendTexels(without, table.format, texels);
  }
  table.texels = std::move(without);
}

/// Adds an orthographic camera on the z axis with this half width and half height, and a light at
/// `lightAngle` above the axis.
void addCameraAndLight(GltfScene& scene, float halfWidth, float halfHeight, double lightAngle) {
  nlohmann::json& json = scene.json;
  json["cameras"].push_back(
      {{"type", "orthographic"},
       {"orthographic",
        {{"xmag", halfWidth}, {"ymag", halfHeight}, {"znear", 0.1}, {"zfar", 10}}}});
  json["nodes"].push_back({{"camera", json["cameras"].size() - 1}, {"translation", {0, 0, 5}}});
  json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
  scene.addSun(1.0f);
  json["nodes"].back()["rotation"] = {-std::sin(lightAngle / 2), 0, 0, std::cos(lightAngle / 2)};
}

/// A metallic plane that faces the camera.
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
  addCameraAndLight(scene, h, h, lightAngle);
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

/// The GGX lobe, but for a factor, at a half vector with the slope (0, `half`), of facets around a
/// normal with these slopes.
double lobe(double alpha2, double slopeX, double slopeY, double half) {
  const double dot = 1.0 + slopeY * half;
  const double cosine2 =
      dot * dot / ((1.0 + slopeX * slopeX + slopeY * slopeY) * (1.0 + half * half));
  const double d = 1.0 + (alpha2 - 1.0) * cosine2;
  return alpha2 / (d * d);
}

/// Shares of the variance of slopes: of those that are drawn, and of those that a pixel hides.
struct SlopeShares {
  double drawn = 0.0, hidden = 1.0;
};

/// What a plane of these slopes reflects from a distance, over what it reflects close up, where a
/// lobe as wide as itself and the hidden slopes stands for the mean of their lobes.
double lobeRatio(const MapExemplar& map, double roughness, double half, SlopeShares shares = {}) {
  const double alpha2 = std::pow(roughness, 4);
  double squares = 0.0; // twice the variance along each axis, times the count
  for (const float value : map.values)
    squares += double(value) * double(value);
  squares /= double(map.values.size()) / 2.0;
  const double wide2 = std::min(1.0, alpha2 + shares.hidden * squares);
  const double scale = std::sqrt(shares.drawn);
  double near = 0.0, far = 0.0;
  for (std::size_t i = 0; i < map.values.size(); i += 2)
    for (const double side : {-half, half}) { // the field is as likely to rise as to fall
      const auto x = double(map.values[i]), y = double(map.values[i + 1]);
      near += lobe(alpha2, x, y, side);
      far += lobe(wide2, scale * x, scale * y, side);
    }
  return far / near;
}

/// The ratio's: cosines, the visibility of tilted facets, and the sample of 16 tiles.
constexpr double kRatioTolerance = 0.05;

} // namespace

TEST_CASE("a bumpy plane far away reflects as one with resolved bumps, but for the lobe's shape") {
  const BundleFile bumpy = bumpyBundle(bumps());
  const MapExemplar map = betweenTexels(bumps());
  BundleFile flat = bumpy;
  removeVariance(flat.bundle);
  constexpr std::uint32_t kFar = 16;                               // 16 texels per pixel
  constexpr std::uint32_t kNear = std::uint32_t(kTiles) * kTexels; // one texel per pixel
  double greatest = 0.0;
  for (const auto& [roughness, degrees] : {std::pair{0.2, 2.0},
                                           {0.2, 12.0},
                                           {0.2, 24.0},
                                           {0.3, 0.0},
                                           {0.4, 0.0},
                                           {0.5, 0.0},
                                           {1.0, 0.0}}) {
    const double angle = degrees * 3.14159265358979 / 180.0;
    const auto radianceOf = [&](const BundleFile& file, std::uint32_t side) {
      GltfScene scene = planeUnder(file, angle);
      scene.json["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = roughness;
      return meanRadiance(render(scene.glb(), lightOnly(side)));
    };
    const double drawn = radianceOf(bumpy, kNear), ratio = radianceOf(bumpy, kFar) / drawn;
    const double expected = lobeRatio(map, roughness, std::tan(angle / 2.0));
    greatest = std::max(greatest, ratio);
    INFO("roughness " << roughness << ", " << degrees << " degrees: drawn " << drawn << ", ratio "
                      << ratio << ", expected " << expected);
    CHECK(ratio == Approx(expected).epsilon(kRatioTolerance));
    if (degrees > 0.0)
      CHECK(std::abs(ratio - 1.0) < 0.4 * std::abs(radianceOf(flat, kFar) / drawn - 1.0));
  }
  CHECK(greatest > 1.2); // docs/theory.md: at most 1.25
}

namespace {

constexpr double kLightAngle = 0.1; // radians, above the camera's axis

/// Squares that face an orthographic camera with pixels of 1 / kTexels: one column per noise scale,
/// one row of rough stone and one of worn metal. `sides` are the squares' sides in pixels; the
/// first is the largest.
LinearImage squares(BundleFile file, Mapping mapping, std::span<const double> texelsPerPixel,
                    std::span<const std::uint32_t> sides) {
  // A file has one material per noise.
  const Noise noise = file.bundle.noises[0];
  MaterialNoise use = *file.bundle.materials[0];
  use.mapping = mapping;
  file.bundle.noises.clear();
  file.bundle.materials.clear();
  for (int row = 0; row < 2; ++row)
    for (const double texels : texelsPerPixel) {
      use.scale = 1.0 / texels;
      use.noise = file.bundle.noises.size();
      file.bundle.materials.emplace_back(use);
      file.bundle.noises.push_back(noise);
      file.bundle.noises.back().name += std::to_string(use.noise);
    }
  file.previews.resize(file.bundle.materials.size());
  GltfScene scene(encodeGlb(file).value());
  const std::uint32_t height = 2 * sides[0];
  const std::uint32_t width = std::accumulate(sides.begin(), sides.end(), 0u);
  for (std::size_t row = 0; row < 2; ++row) {
    float left = -0.5f * float(width) / kTexels;
    for (std::size_t column = 0; column < sides.size(); ++column) {
      const std::size_t material = row * sides.size() + column;
      scene.json["materials"][material]["pbrMetallicRoughness"] = {
          {"metallicFactor", row}, {"roughnessFactor", row == 0 ? 0.9 : 0.5}};
      const float side = float(sides[column]) / kTexels, right = left + side;
      const float top = row == 0 ? float(sides[0]) / kTexels : 0.0f, bottom = top - side;
      scene.addMesh(
          {{"POSITION",
            scene.addFloats({left, top, 0, left, bottom, 0, right, bottom, 0, right, top, 0}, 3)},
           {"NORMAL", scene.addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 3)},
           {"TANGENT", scene.addFloats({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, 4)},
           {"TEXCOORD_0",
            scene.addFloats({left, -top, left, -bottom, right, -bottom, right, -top}, 2)}},
          scene.addIndices({0, 1, 2, 0, 2, 3}, 1), material);
      left = right;
    }
  }
  addCameraAndLight(scene, 0.5f * float(width) / kTexels, 0.5f * float(height) / kTexels,
                    kLightAngle);
  RenderSettings settings = lightOnly(height);
  settings.width = width;
  return render(scene.glb(), settings);
}

/// Mean radiance of the square of pixels that starts at this column and row.
double meanRadiance(const LinearImage& image, std::uint32_t left, std::uint32_t top,
                    std::uint32_t side) {
  double sum = 0.0;
  for (std::uint32_t y = top; y < top + side; ++y)
    for (std::uint32_t x = left; x < left + side; ++x)
      for (std::size_t c = 0; c < 3; ++c)
        sum += double(image.pixel(int(x), int(y))[c]);
  return sum / (3.0 * side * side);
}

/// At 2 texels a pixel both methods fetch halfway between the mip levels 0 and 1. Shares of the
/// variance of a view with one texel a pixel.
SlopeShares sharesAtTwoTexels(const Bundle& bundle) {
  const NoiseMap& map = bundle.noises[0].maps[1];
  if (bundle.noises[0].method() == Method::tiling) { // interpolation has left less than all of it
    const std::vector<float> losses = fetchLosses(bundle.tables[map.as<TilingMap>().gaussian]);
    const auto between = double(losses[0]);
    const double lost = 0.5 * (between + double(losses[1]));
    return {(1.0 - lost) / (1.0 - between), (lost - between) / (1.0 - between)};
  }
  const auto& texton = map.as<TextonMap>();
  double drawn = 0.0;
  for (std::size_t c = 0; c < 2; ++c) { // the mean of two levels; docs/theory.md: their covariance
    const double coarse2 = 1.0 - lossRow(texton.mipLoss, c, 2)[1];
    const double covariance = coarse2 + 0.5 * std::pow(coarse2, 1.5) * (1.0 - coarse2);
    drawn += 0.5 * 0.25 * (1.0 + 2.0 * covariance + coarse2);
  }
  return {drawn, 1.0 - drawn};
}

} // namespace

TEST_CASE("lit, coloured bumps have the same brightness at every distance, in both mappings") {
  const std::vector<MapExemplar> maps = colouredBumps();
  TilingOptions tiling;
  tiling.periodic = Periodic::yes;
  TextonOptions texton;
  texton.support = 32;
  constexpr std::array<double, 4> kTexelsAPixel{1.0, 2.0, 8.0, 100.0 * kTexels};
  // The resolved one shows 16 tiles.
  constexpr std::array<std::uint32_t, 4> kSides{4 * kTexels, 2 * kTexels, 32, 16};
  // Stone: the cosine on bumps is off by 0.12^2 / 2 along each axis, plus the spread of 16 tiles.
  constexpr double kStoneTolerance = 0.03;
  // Metal: brighter by the shape of the lobe, in full where a pixel hides all bumps.
  const double half = std::tan(kLightAngle / 2.0);
  constexpr double kAllHidden = 8.0;
  // There most slopes are drawn: tighter than the 0.034 by which brightness differs from a view
  // that hides none. Measured: at most 0.023.
  constexpr double kRatioToleranceAtTwo = 0.03;
  for (const BundleFile& file : {bundleFileOf(bakeTiling("bumps", maps, tiling)),
                                 bundleFileOf(bakeTexton("bumps", maps, texton))}) {
    // Textons are scaled to the exemplar's variance as they are interpolated.
    const bool isTiling = file.bundle.noises[0].method() == Method::tiling;
    const MapExemplar drawnSlopes = isTiling ? betweenTexels(maps[1]) : maps[1];
    const double metal = lobeRatio(drawnSlopes, 0.5, half);
    const double metalAtTwo = lobeRatio(drawnSlopes, 0.5, half, sharesAtTwoTexels(file.bundle));
    for (const Mapping mapping : {Mapping::uv, Mapping::triplanar}) {
      const LinearImage image = squares(file, mapping, kTexelsAPixel, kSides);
      for (std::uint32_t row = 0; row < 2; ++row) {
        const double drawn = meanRadiance(image, 0, row * kSides[0], kSides[0]);
        std::uint32_t left = kSides[0];
        for (std::size_t k = 1; k < kSides.size(); left += kSides[k], ++k) {
          const double seen = meanRadiance(image, left, row * kSides[0], kSides[k]);
          INFO((row == 0 ? "stone, " : "metal, ")
               << nameOf(file.bundle.noises[0].method()) << ", " << nameOf(mapping) << ", "
               << kTexelsAPixel[k] << " texels a pixel: drawn " << drawn << ", seen " << seen);
          const double ratio = seen / drawn;
          const double ofMetal = kTexelsAPixel[k] >= kAllHidden ? metal : metalAtTwo;
          INFO("ratio " << ratio << ", expected of metal " << ofMetal);
          if (row == 0)
            CHECK(ratio == Approx(1.0).margin(kStoneTolerance));
          else
            CHECK(ratio == Approx(ofMetal).epsilon(kTexelsAPixel[k] >= kAllHidden
                                                       ? kRatioTolerance
                                                       : kRatioToleranceAtTwo));
        }
      }
    }
  }
}

TEST_CASE(
    "a light below a plane's horizon does not reach its bumps, and fades toward the horizon") {
  const BundleFile bumpy = bumpyBundle(bumps());
  BundleFile flat = bumpy;
  removeVariance(flat.bundle);
  // A lamp casts no shadows, so only its angle can darken the plane.
  const auto underLamp = [](const BundleFile& file, double degrees, std::uint32_t side) {
    constexpr double kDistance = 1000.0; // the angle is the same for the whole plane
    const double elevation = degrees * 3.14159265358979 / 180.0;
    GltfScene scene = planeUnder(file, 0.0);
    scene.json["materials"][0]["pbrMetallicRoughness"] = {{"metallicFactor", 0},
                                                          {"roughnessFactor", 0.9}};
    scene.json["extensions"]["KHR_lights_punctual"]["lights"][0] = {{"type", "point"}};
    scene.json["nodes"].back().erase("rotation");
    scene.json["nodes"].back()["translation"] = {0, kDistance * std::cos(elevation),
                                                 kDistance * std::sin(elevation)};
    return meanRadiance(render(scene.glb(), lightOnly(side)));
  };
  constexpr std::uint32_t kFar = 16, kNear = std::uint32_t(kTiles) * kTexels;
  CHECK(underLamp(bumpy, -1.0, kNear) == 0.0);
  CHECK(underLamp(bumpy, -1.0, kFar) == 0.0);
  const double resolved = underLamp(bumpy, 2.0, kNear), unresolved = underLamp(bumpy, 2.0, kFar);
  const double ofPlane = underLamp(flat, 2.0, kFar);
  INFO("resolved " << resolved << ", unresolved " << unresolved << ", plane " << ofPlane);
  CHECK(unresolved == Approx(resolved).epsilon(0.1)); // four normals for all
  // Without the bumps' shadows: the mean of the positive part of a Gaussian with the mean 0.035,
  // the sine of 2 degrees, and the deviation 0.12 is 0.067, twice the plane's.
  CHECK(resolved == Approx(ofPlane).epsilon(0.15));
}

namespace {

/// bumps(), smoother and with this deviation.
MapExemplar smoothBumps(float deviation) {
  MapExemplar map = bumps();
  map.values = smoothed(std::move(map.values), kTexels, 2);
  const float squares =
      std::inner_product(map.values.begin(), map.values.end(), map.values.begin(), 0.0f);
  for (float& value : map.values)
    value *= deviation / std::sqrt(squares / float(map.values.size()));
  return map;
}

} // namespace

TEST_CASE(
    "under sun and sky, unresolved bumps are as bright as in a supersampled picture, and so is "
    "the diffuse light of each") {
  const BundleFile bumpy = bumpyBundle(smoothBumps(0.2f));
  BundleFile flat = bumpy;
  removeVariance(flat.bundle);
  constexpr double kRoughness = 0.4;
  constexpr std::uint32_t kPixels = 8; // a side
  LitPlane plane(testDevice(), bumpy, kTexels, kRoughness, 0.0);
  for (const double texelsPerPixel : {8.0, 32.0})
    for (const Viewpoint& from : {Viewpoint(), towardSun(), awayFromSun()}) {
      INFO(texelsPerPixel << " texels a pixel, from " << from.elevation << " degrees");
      // Two steps of an 8-bit picture at a medium grey.
      CHECK(plane.seen(texelsPerPixel, from, kPixels).meanError == Approx(0.0).margin(0.03));
    }
  // The highlight of a plane without bumps is about four times as bright.
  LitPlane flatPlane(testDevice(), flat, kTexels, kRoughness, 0.0);
  CHECK(flatPlane.seen(32.0, towardSun(), kPixels).meanError > 0.2);
  // A single normal would be 3 % too bright under the sun and 2 % too dark under the sky.
  LitPlane rough(testDevice(), bumpy, kTexels, 0.9, 0.0);
  for (const LitBy light : {LitBy::sun, LitBy::sky})
    for (const Viewpoint& from : {Viewpoint(), awayFromSun()})
      CHECK(rough.seen(32.0, from, kPixels, light).meanError == Approx(0.0).margin(0.01));
}
