// SPDX-License-Identifier: MIT
// The report of a mix: the sizes and the scale of its pictures, and its progress.
#include "example_exemplar.h"
#include "parsed_page.h"

#include <lichen/map_picture.h>
#include <lichen/noise_report.h>
#include <lichen/texton_mix.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <report/method_report.h>
#include <report/mix_section.h>

using namespace lichen;
using namespace lichen::test;

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

PageElement sectionOf(const BakeRecord& record, int side) {
  return parsedMarkup(describeMix(record, 0, side).value());
}

/// The places along the path, in percent, of elements that have one.
std::vector<std::string> placesOf(const std::vector<PageElement>& elements) {
  std::vector<std::string> places;
  for (const PageElement& element : elements)
    if (const auto style = element.attributes.find("style"); style != element.attributes.end())
      places.push_back(style->second);
  return places;
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
    const std::vector<PageElement> pictures = picturesIn(sectionOf(record, kPictureSide));
    CHECK(pictures.size() == mixPictures(record));
    for (const PageElement& picture : pictures)
      CHECK(pictureOf(picture).pixelCount() <= kPictureSide * kPictureSide);
  }
}

TEST_CASE("a reduced picture of a texton consists of the means of its texels") {
  const Mixed mixed;
  const Noise& noise = mixed.bundle.noises[0];
  const auto pictureAt = [&](int side) {
    const MapLook look(mixed.exemplars[0].maps[0], noise.maps[0].encoding);
    const auto pictures =
        reportOf(Method::texton).pictures({mixed.bundle, noise, noise.maps[0], look, 0.0, side});
    return pictureOf(parsedMarkup(imageMarkup(pictures.value().at(0), {})).children.at(0));
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
    const std::array whole{side, side}, half{side, side / 2};
    const PageElement section = sectionOf(mixed.record(), side);
    REQUIRE(section.all("div", "class", "panes").size() == 2);
    for (const PageElement& pane : section.all("summary")) {
      const SrgbImage picture = pictureOf(pane.children.at(0));
      CHECK(std::array{picture.width, picture.height} ==
            (pane.children[0].attributes.at("alt") == "half" ? half : whole));
    }
  }
}

TEST_CASE("panes and curves of a path rise from 0 to 1, and the mix by weights has no place") {
  const PageElement paths = sectionOf(Mixed().record(), kSide);
  const PageElement panes = paths.all("div", "class", "panes").at(1);
  CHECK(placesOf(panes.all("i")) == std::vector<std::string>{"--along:0.0%", "--along:0.0%",
                                                             "--along:50.0%", "--along:100.0%",
                                                             "--along:100.0%"});
  // The inputs lie below the steps.
  CHECK(placesOf(paths.all("svg").at(1).all("path")) ==
        std::vector<std::string>{"--along:0.0%", "--along:100.0%", "--along:0.0%", "--along:50.0%",
                                 "--along:100.0%"});
  const PageElement weighted = sectionOf(Mixed({1.0, 2.0, 1.0}).record(), kSide);
  CHECK(weighted.all("details").size() == 4);
  CHECK(placesOf(weighted.all("i", "class", "key exemplar ramped")) ==
        std::vector<std::string>{"--along:0.0%", "--along:50.0%", "--along:100.0%"});
  CHECK(placesOf(weighted.all("i", "class", "key result")).empty());
}

TEST_CASE("a page shows texts of any bytes as text") {
  const Mixed mixed;
  BakeRecord record = mixed.record();
  const std::string hostile = "a\x01\xff\r <b>&amp;\"'\t\n\xe2\x82",
                    shown = "a\uFFFD\uFFFD\uFFFD <b>&amp;\"'\t\n\uFFFD\uFFFD";
  record.command = hostile;
  record.facts = {{hostile, hostile}};
  record.timings = {{hostile, 1.0}};
  record.notes = {hostile};
  std::vector<ReportedInput> inputs = mixed.inputs;
  for (ReportedInput& input : inputs)
    input.name = hostile;
  record.inputs = inputs;
  const std::vector<std::byte> bytes = encodeNoiseReport(record).value().page;
  const PageElement page = parsedPage({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  CHECK(page.all("pre").at(0).text == shown);
  CHECK(page.all("dt").at(0).text == shown);
  CHECK(page.all("dd").at(0).text == shown);
  CHECK(page.all("dt").at(1).text == shown);
  CHECK(page.all("li").back().text == shown);
  CHECK(page.all("article").back().all("h2").at(0).text == "baseColor of " + shown);
  CHECK(page.all("summary").at(0).all("b").at(0).text == shown);
  CHECK(page.all("img").at(0).attributes.at("alt") == shown);
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
