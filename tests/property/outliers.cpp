// SPDX-License-Identifier: MIT
// What occurs once in an exemplar is found, and only that, and is filled from the rest.
#include "base_color.h"

#include <lichen/exemplar_repair.h>
#include <lichen/quality.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <photographs.h>
#include <string>

using namespace lichen;
using lichen::exemplars::Fault;
using lichen::exemplars::Photograph;
using lichen::exemplars::PhotographPlan;
using lichen::test::baseColor;

namespace {

constexpr int kSide = 256;

Photograph photographOf(const PhotographPlan& plan) {
  return exemplars::photograph(exemplars::photographedSurface(plan.material, kSide), plan);
}

Outliers filled(std::vector<MapExemplar>& maps) {
  Result<Outliers> outliers = fillOutliers(maps, false);
  REQUIRE(outliers.ok());
  return std::move(outliers).value();
}

/// A disc of another colour than cloth.
void addDisc(SrgbImage& image, int x0, int y0) {
  constexpr int kRadius = 12;
  for (int y = -kRadius; y <= kRadius; ++y)
    for (int x = -kRadius; x <= kRadius; ++x)
      if (x * x + y * y <= kRadius * kRadius) {
        float* pixel = image.pixel(x0 + x, y0 + y);
        pixel[0] = 0.6f;
        pixel[1] = pixel[2] = 0.3f;
      }
}

} // namespace

TEST_CASE("a fold, a stain or a leaf is found where it is, and filled without a trace", "[large]") {
  for (const PhotographPlan& plan : {PhotographPlan{"cloth", Fault::stain, 0.6f, 1},
                                     PhotographPlan{"plaster", Fault::fold, 0.5f, 2},
                                     PhotographPlan{"moss", Fault::leaf, 0.0f, 4},
                                     PhotographPlan{"plaster", Fault::stain, 0.4f, 5},
                                     PhotographPlan{"wood_grain", Fault::leaf, 0.0f, 6}}) {
    INFO(plan.name());
    const Photograph photograph = photographOf(plan);
    std::vector<MapExemplar> maps{baseColor(photograph.image)};
    const Outliers outliers = filled(maps);
    REQUIRE(outliers.filled.size() == 1);
    CHECK_FALSE(outliers.left.has_value());
    const auto [x, y, width, height] = outliers.filled.front().place;
    const exemplars::Place& object = photograph.object;
    const double centreX = object.x + 0.5 * object.width, centreY = object.y + 0.5 * object.height;
    INFO("found at " << x << ", " << y << ", " << width << " x " << height << "; is around "
                     << centreX << ", " << centreY);
    CHECK(x < centreX);
    CHECK(y < centreY);
    CHECK(x + width > centreX);
    CHECK(y + height > centreY);
    // Most of the difference that the object makes lies inside.
    double inside = 0.0, all = 0.0;
    for (int py = 0; py < kSide; ++py)
      for (int px = 0; px < kSide; ++px) {
        double square = 0.0;
        for (int c = 0; c < 3; ++c)
          square += std::pow(double(photograph.image.pixel(px, py)[c]) -
                                 double(photograph.even.pixel(px, py)[c]),
                             2.0);
        all += square;
        const auto ux = std::uint32_t(px), uy = std::uint32_t(py);
        inside += ux >= x && ux < x + width && uy >= y && uy < y + height ? square : 0.0;
      }
    CHECK(inside > 0.95 * all);
    SrgbImage result(kSide, kSide, 3);
    result.values = maps.front().values;
    const Result<double> seams = seamVisibility(photograph.even, result);
    REQUIRE(seams.ok());
    CHECK(seams.value() < 1.15);
    const Result<double> before = colorDistance(photograph.even, photograph.image);
    const Result<double> after = colorDistance(photograph.even, result);
    REQUIRE((before.ok() && after.ok()));
    INFO("colours are " << before.value() << " away, then " << after.value());
    CHECK(after.value() < 0.5 * before.value());
  }
}

TEST_CASE("photographs without an object are left as they are", "[large]") {
  for (const char* material : {"granite", "lichen_on_stone", "moss", "rust", "sand", "terrazzo",
                               "plaster", "cloth", "wood_grain", "concrete"}) {
    INFO(material);
    const SrgbImage surface = exemplars::photographedSurface(material, kSide);
    std::vector<MapExemplar> maps{
        baseColor(exemplars::photograph(surface, {material, Fault::none, 0.0f, 1}).image)};
    const std::vector<float> before = maps.front().values;
    const Outliers outliers = filled(maps);
    CHECK((outliers.filled.empty() && !outliers.left));
    CHECK(maps.front().values == before);
  }
}

TEST_CASE(
    "what occurs twice is filled twice, and what occurs three times belongs to the material") {
  SrgbImage image = photographOf({"cloth", Fault::none, 0.0f, 1}).image;
  addDisc(image, 60, 70);
  addDisc(image, 180, 150);
  std::vector<MapExemplar> maps{baseColor(image)};
  const Outliers twice = filled(maps);
  REQUIRE(twice.filled.size() == 2);
  for (const float value : maps.front().values)
    CHECK(value < 0.55f); // no disc is left, and neither was filled from the other
  addDisc(image, 190, 40);
  std::vector<MapExemplar> thrice{baseColor(image)};
  CHECK(filled(thrice).filled.empty());
}

TEST_CASE("what is too large to fill is left, with its place") {
  SrgbImage image = photographOf({"cloth", Fault::none, 0.0f, 1}).image;
  for (int i = 60; i < 200; ++i) // a stroke down to the right
    for (int k = 0; k < 10; ++k)
      image.pixel(i + k, i)[0] = 0.6f;
  std::vector<MapExemplar> maps{baseColor(image)};
  const std::vector<float> before = maps.front().values;
  const Outliers outliers = filled(maps);
  CHECK(outliers.filled.empty());
  CHECK(maps.front().values == before);
  REQUIRE(outliers.left.has_value());
  const auto [x, y, width, height] = *outliers.left;
  CHECK((x <= 60 && x > 40 && y <= 60 && y > 40));
  CHECK((x + width >= 210 && x + width < 230 && y + height >= 200 && y + height < 220));
}

TEST_CASE("all maps of a set are filled at the same place, and the record fills them again") {
  SrgbImage image = photographOf({"cloth", Fault::none, 0.0f, 1}).image;
  addDisc(image, 60, 70);
  MapExemplar height;
  height.target = MapTarget::height;
  height.channels = {MapChannel::height};
  height.encoding = ValueEncoding::linear;
  height.width = height.height = kSide / 2;
  for (int i = 0; i < height.width * height.height; ++i)
    height.values.push_back(std::hypot(i % height.width - 30, i / height.width - 35) < 6.0 ? 1.0f
                                                                                           : 0.2f);
  std::vector<MapExemplar> maps{baseColor(image), height};
  const std::vector<MapExemplar> before = maps;
  const Outliers outliers = filled(maps);
  REQUIRE(outliers.filled.size() == 1);
  for (const float value : maps[1].values)
    CHECK(value == Approx(0.2f));
  std::vector<MapExemplar> again = before;
  REQUIRE(fillPlaces(again, outliers.filled, false).ok());
  CHECK(again[0].values == maps[0].values);
  CHECK(again[1].values == maps[1].values);
}

TEST_CASE("what nobody sees is not filled") {
  SrgbImage image(kSide, kSide, 3);
  std::fill(image.values.begin(), image.values.end(), 0.5f);
  for (int i = 0; i < 100; ++i)
    image.pixel(100 + i % 10, 100 + i / 10)[0] = 0.5f + 1.0f / 255.0f;
  std::vector<MapExemplar> maps{baseColor(image)};
  const Outliers outliers = filled(maps);
  CHECK((outliers.filled.empty() && !outliers.left));
}

TEST_CASE("an object in grey values, and in light above 1, is filled") {
  const SrgbImage cloth = photographOf({"cloth", Fault::none, 0.0f, 1}).image;
  for (const ValueEncoding encoding : {ValueEncoding::srgb, ValueEncoding::log2}) {
    MapExemplar map = baseColor(cloth);
    map.encoding = encoding;
    for (std::size_t i = 0; i < map.values.size(); ++i)
      map.values[i] = map.values[i - i % 3];
    for (int y = 100; y < 116; ++y)
      for (int x = 60; x < 76; ++x)
        for (int c = 0; c < 3; ++c)
          map.values[std::size_t(3 * (y * kSide + x) + c)] = 0.8f;
    std::vector<MapExemplar> maps{map};
    CHECK(filled(maps).filled.size() == 1);
    CHECK(*std::ranges::max_element(maps.front().values) < 0.7f);
  }
}

TEST_CASE("a part at a border of an image that tiles still fits the opposite border") {
  MapExemplar map = baseColor(exemplars::photographedSurface("moss", kSide));
  std::vector<MapExemplar> maps{map};
  const FilledPlace place{{0, 100, 60, 60}, {200, 200}};
  REQUIRE(fillPlaces(maps, {&place, 1}, true).ok());
  const auto column = [&](const MapExemplar& of, int x) {
    double sum = 0.0;
    for (int y = 100; y < 160; ++y)
      sum += std::abs(double(of.values[std::size_t(3 * (y * of.width + x))]) -
                      double(map.values[std::size_t(3 * (y * of.width + x))]));
    return sum / 60.0;
  };
  CHECK(column(maps.front(), 0) < 0.02);  // the fade has begun by half a pixel of ten
  CHECK(column(maps.front(), 30) > 0.05); // and is complete in the middle
  REQUIRE(fillPlaces(maps, {&place, 1}, false).ok());
  CHECK(column(maps.front(), 0) > 0.05);
}

TEST_CASE("places outside the exemplar, and maps without colours, are errors") {
  std::vector<MapExemplar> maps{test::threeMaterials(16, 8, 1)};
  const auto messageOf = [&](const FilledPlace& place) {
    const Result<void> done = fillPlaces(maps, {&place, 1}, false);
    REQUIRE_FALSE(done.ok());
    CHECK(done.error().kind == ErrorKind::usage);
    return done.error().message;
  };
  CHECK(messageOf({{0, 0, 17, 1}, {0, 0}}) ==
        "a part of 17 x 1 pixels at 0, 0, replaced from 0, 0; expected both inside the exemplar's "
        "16 x 8");
  messageOf({{0, 8, 1, 1}, {0, 0}});
  messageOf({{0, 0, 4, 4}, {13, 0}});
  messageOf({{0, 0, 4, 4}, {4294967295u, 0}});
  messageOf({{0, 0, 0, 4}, {0, 0}});
  const FilledPlace whole{{0, 0, 16, 8}, {0, 0}};
  CHECK(fillPlaces(maps, {&whole, 1}, false).ok());
  CHECK_FALSE(fillPlaces({}, {}, false).ok());
  maps.front().target = MapTarget::emissive;
  CHECK_FALSE(fillOutliers(maps, false).ok());
}
