// SPDX-License-Identifier: MIT
// The report of a mix: the sizes and the scale of its pictures, and its progress.
#include "example_exemplar.h"

#include <lichen/base64.h>
#include <lichen/image_io.h>
#include <lichen/noise_report.h>
#include <lichen/texton_mix.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <report/method_report.h>
#include <report/mix_section.h>

using namespace lichen;
using namespace lichen::test;
using Json = nlohmann::ordered_json;

namespace {

constexpr int kSide = 96;
constexpr int kSupport = 24;

/// A mix of three inputs of other sizes: a square, half a square, and a smaller square.
struct Mixed {
  explicit Mixed(std::vector<double> mixWeights = {}) : weights(std::move(mixWeights)) {
    TextonMixOptions options;
    options.texton.support = kSupport;
    options.steps = 3;
    options.weights = weights;
    Result<TextonMixBake> bake = bakeTextonMix("mix", exemplars, options);
    REQUIRE(bake);
    bundle.noises = {std::move(bake.value().noise)};
    bundle.tables = std::move(bake.value().tables);
    bundle.materials = {MaterialNoise{}};
    bundle.materialNames = {"mix"};
    modelErrors = std::move(bake.value().quality.modelErrors);
    for (const MixedExemplar& exemplar : exemplars)
      inputs.push_back({.name = exemplar.name,
                        .exemplars = exemplar.maps,
                        .risks = {&noRisks, 1},
                        .origins = {&origin, 1}});
  }

  [[nodiscard]] BakeRecord record() const {
    return {.bundle = bundle,
            .inputs = inputs,
            .mix = ReportedMix{.modelErrors = modelErrors, .weights = weights},
            .command = {},
            .facts = {},
            .timings = {},
            .notes = {}};
  }

  std::vector<double> weights;
  std::vector<MixedExemplar> exemplars{{"square", {threeMaterials(kSide, kSide, 1)}},
                                       {"half", {threeMaterials(kSide, kSide / 2, 2)}},
                                       {"small", {threeMaterials(kSide / 2, kSide / 2, 3)}}};
  std::vector<Risk> noRisks;
  ExemplarOrigin origin;
  Bundle bundle;
  std::vector<double> modelErrors;
  std::vector<ReportedInput> inputs;
};

SrgbImage pictureOf(const Json& json) {
  const std::string uri = json.at("png");
  const std::optional<std::vector<std::byte>> png = decodeBase64(uri.substr(uri.find(',') + 1));
  REQUIRE(png);
  return std::get<SrgbImage>(decodeImage(*png, "picture").value().pixels);
}

/// The pictures of a section: every object with a `png`.
std::vector<SrgbImage> picturesIn(const Json& json) {
  std::vector<SrgbImage> pictures;
  if (json.is_object() && json.contains("png"))
    pictures.push_back(pictureOf(json));
  for (const Json& inner : json)
    if (inner.is_structured())
      for (SrgbImage& picture : picturesIn(inner))
        pictures.push_back(std::move(picture));
  return pictures;
}

/// Checks that the fractions rise within [0, 1], and that a stop ends the operation at once.
template <class Operation>
void checkProgress(const Operation& operation, std::size_t leastReports) {
  std::vector<double> fractions;
  REQUIRE(operation([&](double fraction) {
    fractions.push_back(fraction);
    return true;
  }));
  CHECK(fractions.size() >= leastReports);
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  CHECK(fractions.front() >= 0.0);
  CHECK(fractions.back() <= 1.0);
  for (const std::size_t last : {std::size_t(1), fractions.size() / 2, fractions.size()}) {
    std::size_t calls = 0;
    const auto stopped = operation([&](double) { return ++calls < last; });
    REQUIRE_FALSE(stopped);
    CHECK(stopped.error().kind == ErrorKind::environment);
    CHECK(calls == last);
  }
}

} // namespace

TEST_CASE("no picture of a mix has more pixels than asked for, even of a larger texton") {
  constexpr int kPictureSide = kSupport / 2;
  for (const std::vector<double>& weights : {std::vector<double>{}, {1.0, 2.0, 1.0}}) {
    const Mixed mixed(weights);
    const BakeRecord record = mixed.record();
    const std::vector<SrgbImage> pictures =
        picturesIn(describeMix(record, 0, kPictureSide).value());
    CHECK(pictures.size() == mixPictures(record));
    for (const SrgbImage& picture : pictures)
      CHECK(picture.pixelCount() <= kPictureSide * kPictureSide);
  }
}

TEST_CASE("a reduced picture of a texton consists of the means of its texels") {
  const Mixed mixed;
  const Noise& noise = mixed.bundle.noises[0];
  const auto pictureAt = [&](int side) {
    return pictureOf(
        reportOf(Method::texton).image(mixed.bundle, noise, noise.maps[0], 0.0, side).value());
  };
  const SrgbImage whole = pictureAt(kSupport), half = pictureAt(kSupport / 2);
  CHECK(whole.width == kSupport - 1); // coefficients of order 1
  REQUIRE(half.width == kSupport / 2);
  // The largest magnitude sets each picture's range, so they agree up to a factor; grey is 0.5.
  double products = 0.0, squares = 0.0, meanSquares = 0.0;
  for (int y = 0; y < half.height; ++y)
    for (int x = 0; x < half.width; ++x) {
      const int left = x * whole.width / half.width, right = (x + 1) * whole.width / half.width;
      const int top = y * whole.height / half.height, bottom = (y + 1) * whole.height / half.height;
      double mean = 0.0;
      for (int v = top; v < bottom; ++v)
        for (int u = left; u < right; ++u)
          mean += double(whole.pixel(u, v)[0]) - 0.5;
      mean /= double((right - left) * (bottom - top));
      const double here = double(half.pixel(x, y)[0]) - 0.5;
      products += mean * here;
      squares += here * here;
      meanSquares += mean * mean;
    }
  CHECK(products / std::sqrt(squares * meanSquares) > 0.999); // rounded to 8 bits
}

TEST_CASE("all panes of a mix show the same number of texels per pixel") {
  const Mixed mixed;
  for (const int side : {kSide, kSide / 2}) {
    const Json section = describeMix(mixed.record(), 0, side).value();
    CHECK(section.at("extents") == Json{side, side});
    const auto extentsOf = [](const Json& pane) {
      const SrgbImage picture = pictureOf(pane);
      return std::array{picture.width, picture.height};
    };
    const std::array whole{side, side}, half{side, side / 2};
    REQUIRE(section.at("paths").size() == 2);
    for (const Json& path : section["paths"])
      for (const Json& pane : path.at("panes"))
        CHECK(extentsOf(pane) == (pane.value("name", "") == "half" ? half : whole));
  }
}

TEST_CASE("panes and curves of a path rise from 0 to 1, and the mix by weights has no place") {
  const Json path = describeMix(Mixed().record(), 0, kSide).value().at("paths")[1];
  std::vector<double> along, ofCurves;
  for (const Json& pane : path.at("panes"))
    along.push_back(pane.at("along"));
  for (const Json& curve : path.at("spectrum").at("curves"))
    ofCurves.push_back(curve.at("along"));
  CHECK(along == std::vector{0.0, 0.0, 0.5, 1.0, 1.0});
  CHECK(ofCurves == along);
  const Json panes =
      describeMix(Mixed({1.0, 2.0, 1.0}).record(), 0, kSide).value().at("paths")[0].at("panes");
  REQUIRE(panes.size() == 4);
  for (std::size_t input = 0; input < 3; ++input)
    CHECK(panes[input].at("along") == 0.5 * double(input));
  CHECK(panes[3].at("along").is_null());
}

TEST_CASE("a report of a mix reports its progress, and ends where the caller stops it") {
  const Mixed mixed, texture({1.0, 2.0, 1.0});
  const BakeRecord steps = mixed.record(), one = texture.record();
  // Two paths of three steps; each step synthesizes twice.
  checkProgress([&](const Progress& progress) { return describeMix(steps, 0, kSide, progress); },
                12);
  checkProgress([&](const Progress& progress) { return encodeNoiseReport(one, progress); }, 2);
  checkProgress([&](const Progress& progress) { return encodeNoiseReport(steps, progress); }, 15);
}
