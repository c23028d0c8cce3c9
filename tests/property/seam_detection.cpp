// SPDX-License-Identifier: MIT
// Whether seam detection separates exemplars that tile from crops that do not: on the generated
// materials and, if run by hand with `property_seam_detection "[photographs]"`, on the photographs
// in ../shared/exemplars.
#include "checkout_paths.h"
#include "example_exemplar.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exemplar/borders.h>
#include <filesystem>
#include <materials.h>

using namespace lichen;

namespace {

struct Named {
  std::string name;
  MapExemplar map;
};

MapExemplar mapOf(const SrgbImage& image) {
  MapExemplar map;
  map.channels = {MapChannel::red, MapChannel::green, MapChannel::blue};
  map.channels.resize(image.channels >= 3 ? 3 : 1);
  map.width = image.width;
  map.height = image.height;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      map.values.insert(map.values.end(), image.pixel(x, y),
                        image.pixel(x, y) + map.channels.size());
  return map;
}

std::vector<Named> generatedMaterials(int side) {
  std::vector<Named> result;
  for (const exemplars::Material& material : exemplars::kMaterials)
    result.push_back({material.name, mapOf(material.generate(side))});
  return result;
}

/// All of them tile, according to their README.
std::vector<Named> photographs() {
  const std::filesystem::path folder = sourcePath("../shared/exemplars");
  std::vector<std::filesystem::path> paths;
  std::error_code absent;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, absent))
    if (entry.path().extension() == ".png")
      paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  std::vector<Named> result;
  for (const std::filesystem::path& path : paths) {
    const Result<ImageFile> file = readImage(path);
    REQUIRE(file);
    result.push_back({path.lexically_relative(folder).string(),
                      mapOf(std::get<SrgbImage>(file.value().pixels))});
  }
  return result;
}

/// Crops with a share of the side, at `places` positions along each axis.
std::vector<MapExemplar> cropsOf(const MapExemplar& map, double share, int places) {
  const int width = int(share * map.width);
  const int height = int(share * map.height);
  std::vector<MapExemplar> crops;
  for (int row = 0; row < places; ++row)
    for (int column = 0; column < places; ++column)
      crops.push_back(test::cropped(map, (map.width - width) * column / (places - 1),
                                    (map.height - height) * row / (places - 1), width, height));
  return crops;
}

double strongest(const MapExemplar& map) {
  const exemplar::SeamStrength strength = exemplar::seamStrength(map);
  return std::max(strength.betweenColumns, strength.betweenRows);
}

/// White grain: pixels across any border differ as much as neighbours do, so a crop has no visible
/// seam.
constexpr const char* kWhiteGrain = "painted_plaster_wall/normal.png";

void checkToldApart(const Named& exemplar) {
  INFO(exemplar.name << ", seam of " << strongest(exemplar.map));
  CHECK(exemplar::isPeriodic(exemplar.map));
  if (exemplar.name == kWhiteGrain)
    return;
  for (const MapExemplar& crop : cropsOf(exemplar.map, 0.625, 3)) {
    INFO("crop: seam of " << strongest(crop));
    CHECK_FALSE(exemplar::isPeriodic(crop));
  }
}

} // namespace

TEST_CASE("generated materials tile and their crops do not") {
  for (const int side : {96, 256})
    for (const Named& exemplar : generatedMaterials(side))
      checkToldApart(exemplar);
}

TEST_CASE("photographs that tile are told from their crops", "[.][photographs]") {
  const std::vector<Named> all = photographs();
  REQUIRE_FALSE(all.empty());
  for (const Named& exemplar : all)
    checkToldApart(exemplar);
}

TEST_CASE("a seam is measured in units of the interior's steps") {
  const auto imageOf = [](auto value) {
    MapExemplar map = test::threeMaterials(16, 16, 1, 1);
    for (std::size_t i = 0; i < map.values.size(); ++i)
      map.values[i] = value(int(i / 3 % 16));
    return exemplar::seamStrength(map);
  };
  const exemplar::SeamStrength constant = imageOf([](int) { return 0.5f; });
  CHECK(constant.betweenColumns == 0.0);
  CHECK(constant.betweenRows == 0.0);
  // Steps of 1/16 inside, 15/16 across the seam.
  const exemplar::SeamStrength ramp = imageOf([](int x) { return float(x) / 16.0f; });
  CHECK(ramp.betweenColumns == Approx(15.0));
  CHECK(ramp.betweenRows == 0.0);
  // A single step inside affects fewer than a tenth of the lines.
  const exemplar::SeamStrength halves = imageOf([](int x) { return x < 8 ? 0.0f : 1.0f; });
  CHECK(std::isinf(halves.betweenColumns));
}

// The table of docs/decisions/006-seam-detection.md: analysis_tests '[table]'.
TEST_CASE("the strength of seams, tabulated", "[.][table]") {
  std::vector<Named> all = generatedMaterials(512);
  for (Named& photograph : photographs())
    all.push_back(std::move(photograph));
  std::puts(
      "| exemplar | whole | crops, 5 % quantile of axes | crops, least of the stronger axis |\n"
      "|---|---|---|---|");
  for (const Named& exemplar : all) {
    std::vector<double> axes, either;
    for (const double share : {0.25, 0.5, 0.625, 0.75, 0.875})
      for (const MapExemplar& crop : cropsOf(exemplar.map, share, 4)) {
        const exemplar::SeamStrength strength = exemplar::seamStrength(crop);
        axes.insert(axes.end(), {strength.betweenColumns, strength.betweenRows});
        either.push_back(std::max(strength.betweenColumns, strength.betweenRows));
      }
    std::sort(axes.begin(), axes.end());
    const exemplar::SeamStrength whole = exemplar::seamStrength(exemplar.map);
    std::printf("| %s | %.2f, %.2f | %.2f | %.2f |\n", exemplar.name.c_str(), whole.betweenColumns,
                whole.betweenRows, axes[axes.size() / 20],
                *std::min_element(either.begin(), either.end()));
  }
}
