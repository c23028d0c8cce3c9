// SPDX-License-Identifier: MIT
// One exemplar under several methods: how near a noise looks, and the rows and page of the sheet.
#include "bundle_of.h"
#include "example_exemplar.h"

#include <lichen/method_sheet.h>
#include <lichen/multiple_kernels.h>
#include <lichen/quality.h>
#include <lichen/texton.h>
#include <lichen/tiling.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr int kWidth = 96, kHeight = 80;

MethodTrial trialOf(Bundle bundle, double seconds, double fetches) {
  bundle.materials = {MaterialNoise()};
  return {std::move(bundle), seconds, fetches};
}

MethodTrial tilingTrial(const MapExemplar& exemplar) {
  return trialOf(bundleOf(bakeTiling("a", {&exemplar, 1}, {})), 1.5, 4.0);
}

} // namespace

TEST_CASE(
    "the look of a noise is a picture of so many exemplars, as far off as lookDistance() says") {
  const MapExemplar exemplar = threeMaterials(kWidth, kHeight, 5);
  const Result<MethodLook> look = lookOf(tilingTrial(exemplar), exemplar, 1.5);
  REQUIRE(look);
  CHECK(look.value().picture.width == 144);
  CHECK(look.value().picture.height == 120);
  CHECK(look.value().distance ==
        Approx(lookDistance(pictureOf(exemplar), look.value().picture).value()));
  // Wrong colours are farther than the noise's own.
  MapExemplar dark = exemplar;
  for (float& value : dark.values)
    value *= 0.5f;
  const Result<MethodLook> wrong = lookOf(tilingTrial(dark), exemplar, 1.5);
  REQUIRE(wrong);
  CHECK(wrong.value().distance > 3.0 * look.value().distance);
}

TEST_CASE("a sheet has a row for each trial, in their order, with their costs, and escapes names") {
  const MapExemplar exemplar = threeMaterials(kWidth, kHeight, 5);
  std::vector<MethodTrial> trials{tilingTrial(exemplar)};
  trials.push_back(trialOf(bundleOf(bakeMultipleKernels("b", {&exemplar, 1}, {})), 0.25, 47.0));
  const Result<MethodSheet> sheet = makeMethodSheet("<moss> & \xff", exemplar, trials);
  REQUIRE(sheet);
  const std::vector<MethodRow>& rows = sheet.value().rows;
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].method == Method::tiling);
  CHECK(rows[1].method == Method::multipleKernels);
  CHECK(rows[1].bakeSeconds == 0.25);
  CHECK(rows[1].plainFetches == 47.0);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    std::size_t bytes = 0;
    for (const Table& table : trials[k].bundle.tables)
      bytes += table.texels.size();
    CHECK(rows[k].gpuBytes == bytes);
    CHECK(!rows[k].measures.empty());
    CHECK(rows[k].distance > 0.0);
  }
  std::string page;
  for (const std::byte byte : sheet.value().page)
    page += char(byte);
  CHECK(page.find("&lt;moss&gt; &amp; ") != std::string::npos);
  CHECK(page.find("<moss>") == std::string::npos);
  CHECK(page.find("\xff") == std::string::npos);
  // The exemplar and two noises.
  std::size_t pictures = 0;
  for (std::size_t at = 0; (at = page.find("<img", at)) != std::string::npos; ++at)
    ++pictures;
  CHECK(pictures == 3);
}
