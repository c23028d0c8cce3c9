// SPDX-License-Identifier: MIT
// Reading an exemplar's pixels: what resampling preserves and removes, colours under transparency,
// joined channels, and names.
#include "example_exemplar.h"
#include "plane_of.h"

#include <lichen/image.h>
#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <exemplar/invisible_color.h>
#include <exemplar/map_values.h>
#include <exemplar/resample.h>
#include <exemplar/set_files.h>
#include <numbers>
#include <numeric>
#include <transport/random.h>

using namespace lichen;
using namespace lichen::exemplar;

namespace {

MapExemplar heightMap(int width, int height, const auto& value) {
  MapExemplar map = test::planeOf(width, height, value);
  map.target = MapTarget::height;
  map.channels = {MapChannel::height};
  return map;
}

double mean(const MapExemplar& map) {
  return std::accumulate(map.values.begin(), map.values.end(), 0.0) / double(map.values.size());
}

/// Shifts each pixel right and down, with wraparound.
MapExemplar rolled(const MapExemplar& map, int right, int down) {
  MapExemplar result = map;
  const std::size_t channels = map.channels.size();
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const auto at = [&](int column, int row) {
        return (std::size_t(row) * std::size_t(map.width) + std::size_t(column)) * channels;
      };
      std::copy_n(&map.values[at(x, y)], channels,
                  &result.values[at((x + right) % map.width, (y + down) % map.height)]);
    }
  return result;
}

double largestDifference(const MapExemplar& a, const MapExemplar& b) {
  REQUIRE(a.values.size() == b.values.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    largest = std::max(largest, std::abs(double(a.values[i]) - double(b.values[i])));
  return largest;
}

constexpr double kRounding = 1e-6; // from sums of floats below 1

/// Central differences to the right and upwards, with wraparound.
std::array<double, 2> slopesAt(const SrgbImage& height, int x, int y) {
  const auto at = [&](int column, int row) {
    return double(*height.pixel((column + height.width) % height.width,
                                (row + height.height) % height.height));
  };
  return {0.5 * (at(x + 1, y) - at(x - 1, y)), 0.5 * (at(x, y - 1) - at(x, y + 1))};
}

/// The normals of a height map, as the colours of a normal map.
SrgbImage normalsOf(const SrgbImage& height, bool greenPointsDown) {
  SrgbImage normals(height.width, height.height, 3);
  for (int y = 0; y < height.height; ++y)
    for (int x = 0; x < height.width; ++x) {
      const auto [right, up] = slopesAt(height, x, y);
      const double length = std::sqrt(right * right + up * up + 1.0);
      const std::array<double, 3> normal{-right, greenPointsDown ? up : -up, 1.0};
      for (std::size_t c = 0; c < 3; ++c)
        normals.pixel(x, y)[c] = float(0.5 + 0.5 * normal[c] / length);
    }
  return normals;
}

} // namespace

TEST_CASE("a resampled map has the wanted size, and the same mean at integer ratios") {
  const MapExemplar map = test::threeMaterials(48, 36, 3);
  MapExemplar linear = map;
  linear.encoding = ValueEncoding::linear; // otherwise resampling preserves the mean of the light
  const MapExemplar half = resampled(linear, 24, 12, true);
  CHECK(half.width == 24);
  CHECK(half.height == 12);
  CHECK(mean(half) == Approx(mean(linear)).margin(kRounding));
  CHECK(largestDifference(resampled(map, 48, 36, true), map) == 0.0);
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 1}, {1, 90}, {97, 53}}) {
    const MapExemplar other = resampled(map, width, height, false);
    CHECK(other.values.size() == std::size_t(3 * width * height));
    const auto [least, most] = std::minmax_element(map.values.begin(), map.values.end());
    CHECK(*std::min_element(other.values.begin(), other.values.end()) >= *least - 1e-6f);
    CHECK(*std::max_element(other.values.begin(), other.values.end()) <= *most + 1e-6f);
  }
}

TEST_CASE("resampling preserves slow waves and removes those above the new Nyquist limit") {
  const auto wave = [](int cycles) {
    return heightMap(64, 4, [=](int x, int) {
      return 0.5 + 0.4 * std::cos(2.0 * std::numbers::pi * cycles * (x + 0.5) / 64.0);
    });
  };
  const auto amplitude = [&](int cycles) {
    const MapExemplar small = resampled(wave(cycles), 16, 1, true);
    double most = 0.0;
    for (const float value : small.values)
      most = std::max(most, std::abs(double(value) - 0.5) / 0.4);
    return most;
  };
  // The Fourier transform of the cubic by quadrature, at f cycles per pixel of the result: 0.9913
  // at 1/16, 0.8450 at 1/4, 0 at 1 and 2, 0.0047 at 3/2. The largest sample of a wave is half a
  // pixel from its crest.
  const auto crest = [](double f) { return std::cos(std::numbers::pi * f); };
  CHECK(amplitude(1) == Approx(0.9913 * crest(1.0 / 16.0)).margin(0.002));
  CHECK(amplitude(4) == Approx(0.8450 * crest(1.0 / 4.0)).margin(0.002));
  CHECK(amplitude(16) < 0.002);
  CHECK(amplitude(24) < 0.007);
  CHECK(amplitude(32) < 0.002);
}

TEST_CASE("resampling wraps around borders that fit") {
  const MapExemplar map = test::threeMaterials(32, 32, 9);
  const MapExemplar direct = resampled(map, 16, 8, true);
  const MapExemplar shiftedFirst = resampled(rolled(map, 6, 12), 16, 8, true);
  CHECK(largestDifference(shiftedFirst, rolled(direct, 3, 3)) < kRounding);
  CHECK(largestDifference(resampled(rolled(map, 6, 12), 16, 8, false), rolled(direct, 3, 3)) >
        0.01);
}

TEST_CASE("a transparent pixel gets the colour of the opaque pixels around it") {
  MapExemplar color = test::threeMaterials(33, 20, 4);
  const MapExemplar original = color;
  const auto opacityOf = [&](auto value) {
    MapExemplar map = heightMap(color.width, color.height, value);
    map.target = MapTarget::opacity;
    map.channels = {MapChannel::opacity};
    return map;
  };
  SECTION("where opacity is the same everywhere, and where there is none, nothing changes") {
    for (const double alpha : {1.0, 0.5, 0.0}) {
      fillInvisible(color, opacityOf([=](int, int) { return alpha; }));
      CHECK(color.values == original.values);
    }
  }
  SECTION("one covered pixel gives its colour to all") {
    fillInvisible(color, opacityOf([](int x, int y) { return x == 20 && y == 7 ? 1.0 : 0.0; }));
    const std::size_t covered = 3 * (7 * 33 + 20);
    for (std::size_t i = 0; i < color.values.size(); ++i)
      CHECK(color.values[i] == Approx(original.values[covered + i % 3]).margin(1e-5));
  }
  SECTION("covered pixels keep theirs, and hidden colours reach nobody") {
    const MapExemplar opacity = opacityOf([](int x, int) { return x % 11 < 5 ? 1.0 : 0.0; });
    for (std::size_t i = 0; i < color.values.size(); ++i)
      if (opacity.values[i / 3] == 0.0f)
        color.values[i] = 1.0f;
    MapExemplar other = original;
    fillInvisible(color, opacity);
    fillInvisible(other, opacity);
    CHECK(color.values == other.values); // independent of the hidden values
    for (std::size_t i = 0; i < color.values.size(); ++i)
      if (opacity.values[i / 3] == 1.0f)
        REQUIRE(color.values[i] == original.values[i]);
  }
}

TEST_CASE("joined channels have the format's order and the size of the largest map") {
  using enum MapChannel;
  const auto part = [](MapChannel channel, int side, double value, double quantum) {
    MapExemplar map = heightMap(side, side, [=](int, int) { return value; });
    map.target = MapTarget::occlusionRoughnessMetallic;
    map.channels = {channel};
    map.quantum = quantum;
    return map;
  };
  const std::vector<MapExemplar> parts{part(metallic, 4, 0.75, 1.0 / 255.0),
                                       part(occlusion, 8, 0.25, 1.0 / 65535.0),
                                       part(roughness, 2, 0.5, 1.0 / 255.0)};
  const MapExemplar map = joined(parts, true);
  CHECK(map.channels == std::vector{occlusion, roughness, metallic});
  CHECK(map.width == 8);
  CHECK(map.quantum == 1.0 / 65535.0);
  REQUIRE(map.values.size() == 3 * 64);
  for (std::size_t i = 0; i < map.values.size(); i += 3) {
    CHECK(map.values[i] == Approx(0.25f));
    CHECK(map.values[i + 1] == Approx(0.5f));
    CHECK(map.values[i + 2] == Approx(0.75f));
  }
}

TEST_CASE("the last words of a name decide which map a file is") {
  using enum FileRole;
  const std::pair<const char*, FileRole> cases[] = {
      {"rock_nor_1k", normal},
      {"wood_ao_1k-jpg", occlusion},
      {"ao-rough-metal", occlusionRoughnessMetallic},
      {"Helmet_occlusionRoughnessMetallic", occlusionRoughnessMetallic},
      {"Helmet_metallicRoughness", roughnessMetallic},
      {"Rock036_2K-PNG_AmbientOcclusion", occlusion},
      {"RockBaseColor", baseColor},
      {"rock base colour", baseColor},
      {"ROCK_EMISSIVE_COLOR", emissive},
      {"RockAORoughness", roughness},
      {"Fence003_Opacity", opacity},
      {"Rock_Displacement_16bit", height},
      {"brick_normal_map_v2", normal},
      {"Bark_Albedo_LOD0", baseColor},
      {"wood_albedo_1001", baseColor}};
  for (const auto& [name, role] : cases) {
    INFO(name);
    CHECK(fileRole(name) == role);
  }
  for (const char* name : {"Metal009", "metal_plate", "rough_stone_thumb", "MetalPlate", "preview",
                           "roughen", "2K-PNG", "", "___", "\xff\xfe"}) {
    INFO(name);
    CHECK(fileRole(name) == std::nullopt);
  }
}

TEST_CASE("the file names of material libraries determine the maps") {
  using enum FileRole;
  const std::pair<const char*, std::optional<FileRole>> cases[] = {
      // Poly Haven
      {"rock_face_03_diff_2k", baseColor},
      {"rock_face_03_nor_gl_2k", normalGl},
      {"rock_face_03_nor_dx_2k", normalDx},
      {"rock_face_03_arm_2k", occlusionRoughnessMetallic},
      {"rock_face_03_disp_2k", height},
      {"rock_face_03_rough_2k", roughness},
      {"rock_face_03_ao_2k", occlusion},
      {"metal_plate_metal_4k", metallic},
      {"metal_plate_spec_4k", std::nullopt},
      {"fabric_pattern_05_col_01_1k", baseColor},
      // ambientCG
      {"Metal032_2K-PNG_Color", baseColor},
      {"Metal032_2K-PNG_Metalness", metallic},
      {"Metal032_2K-PNG_NormalGL", normalGl},
      {"Metal032_2K_Roughness", roughness},
      {"Metal032_8K-JPG_Displacement", height},
      {"Lava004_1K-JPG_Emission", emissive},
      {"Metal032", std::nullopt}, // the picture of a ball
      {"Metal032_PREVIEW", std::nullopt},
      // FreePBR
      {"rusty-metal_albedo", baseColor},
      {"rusty-metal_normal-ogl", normalGl},
      {"rusty-metal_normal-dx", normalDx},
      {"rusty-metal_metallic", metallic},
      {"rusty-metal_roughness", roughness},
      {"rusty-metal_ao", occlusion},
      {"rusty-metal_height", height},
      {"rusty-metal_preview", std::nullopt},
      // 3dtextures.me, current and former names
      {"Metal_Plate_047_basecolor", baseColor},
      {"Metal_Plate_047_ambientOcclusion", occlusion},
      {"Metal_Plate_047_metallic", metallic},
      {"Metal_Plate_047_normal", normal},
      {"Stone_Wall_001_COLOR", baseColor},
      {"Stone_Wall_001_NORM", normal},
      {"Stone_Wall_001_OCC", occlusion},
      {"Stone_Wall_001_ROUGH", roughness},
      {"Stone_Wall_001_DISP", height},
      {"Stone_Wall_001_SPEC", std::nullopt},
      {"Material_2076", std::nullopt},
      // textures.com
      {"TexturesCom_Metal_Plates_3x3_2K_albedo", baseColor},
      {"TexturesCom_Metal_Plates_3x3_2K_normal", normal},
      {"TexturesCom_Metal_Plates_3x3_2K_roughness", roughness},
      {"TexturesCom_Metal_Plates_header", std::nullopt},
      {"MetalPlatesBare0012_1_M", std::nullopt}};
  const auto changed = [](std::string name, int (*change)(int)) {
    for (char& c : name)
      c = char(change(static_cast<unsigned char>(c)));
    return name;
  };
  for (const auto& [name, role] : cases) {
    INFO(name);
    CHECK(fileRole(name) == role);
    CHECK(fileRole(changed(name, std::tolower)) == role);
    CHECK(fileRole(changed(name, std::toupper)) == role);
  }
}

TEST_CASE("rotating a normal map rotates its normals, which still match the height") {
  SrgbImage height(12, 7, 1);
  for (std::size_t i = 0; i < height.values.size(); ++i)
    height.values[i] = float(transport::randomUniform(4, i));
  // A code is rounded by 2^-25, and a component by twice that. A slope s below 1/2 is then off by
  // (1 + s) / nz times that, with nz above 1 / 1.3: 4 of 2^-25. The quotient doubles it.
  constexpr double kRounding = 8.0 * 0x1p-25;
  for (const bool greenPointsDown : {false, true})
    for (int orientation = 1; orientation <= 8; ++orientation) {
      INFO("orientation " << orientation << ", green points down " << greenPointsDown);
      const ImageFile rotated = upright({height, 8, orientation, {}});
      const NamedImage normals{upright({normalsOf(height, greenPointsDown), 8, orientation, {}}),
                               "normals", "normals"};
      std::vector<std::string> notes;
      const MapExemplar map = normalMap(normals, greenPointsDown, notes).value();
      const auto& actual = std::get<SrgbImage>(rotated.pixels);
      REQUIRE(map.width == actual.width);
      double worst = 0.0;
      for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
          for (std::size_t c = 0; c < 2; ++c)
            worst = std::max(
                worst, std::abs(double(map.values[std::size_t(2 * (y * map.width + x) + int(c))]) -
                                slopesAt(actual, x, y)[c]));
      CHECK(worst < kRounding);
    }
}
