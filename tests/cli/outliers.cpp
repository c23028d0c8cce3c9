// SPDX-License-Identifier: MIT
// What a bake does with parts of a photograph that occur once.
#include "command_run.h"

#include <lichen/bundle_files.h>
#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <array>
#include <string>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

/// Grain with a red square of 16 pixels at column 40, row 70, if it `hasSquare`.
SrgbImage grain(bool hasSquare = true) {
  constexpr int kSide = 160;
  SrgbImage image(kSide, kSide, 3);
  std::uint32_t state = 1;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      state = state * 1664525u + 1013904223u; // Numerical Recipes, section 7.1
      const bool isRed = hasSquare && x >= 40 && x < 56 && y >= 70 && y < 86;
      for (int c = 0; c < 3; ++c)
        image.pixel(x, y)[c] =
            0.3f + 0.2f * float(state >> 8u) * 0x1p-24f + (isRed && c == 0 ? 0.4f : 0.0f);
    }
  return image;
}

struct Bake {
  std::string notes;
  Preparation preparation;
};

Bake baked(const Workplace& workplace, const Arguments& arguments) {
  const std::string notes =
      jsonOf(Arguments{"bake", "-o", workplace.path("noise.glb")} + arguments).at("notes").dump();
  return {notes, readBundle(workplace.path("noise.glb")).value().noises.front().preparation};
}

} // namespace

TEST_CASE("what occurs once is filled, with a note, and compare fills it again") {
  const Workplace workplace;
  const std::string input = workplace.write("grain.png", grain());
  const Bake bake = baked(workplace, {input});
  CHECK_THAT(bake.notes, Catch::Contains("pixels, occurs once and is filled from the rest; "
                                         "--keep-outliers keeps it"));
  REQUIRE(bake.preparation.filled.size() == 1);
  const auto [x, y, width, height] = bake.preparation.filled.front().place;
  CHECK((x <= 40 && y <= 70 && x + width >= 56 && y + height >= 86));
  CHECK((width < 48 && height < 48));
  CHECK_THAT(bake.notes, Catch::Contains("at " + std::to_string(x) + "," + std::to_string(y)));
  CHECK_THAT(runLichen({"compare", input, workplace.path("noise.glb")}).errors,
             Catch::Contains("as the bundle was baked: 1 part filled"));

  // The comparison is with the filled exemplar: without the square its colours are nearer.
  const auto distanceOf = [&](const Arguments& more) {
    const Arguments arguments{"compare", input, workplace.path("noise.glb"), "--json"};
    const nlohmann::json measures = nlohmann::json::parse(runLichen(arguments + more).output);
    for (const nlohmann::json& measure : measures.at("measures"))
      if (measure.at("name") == "color_distance")
        return measure.at("value").get<double>();
    FAIL("no color_distance");
    return 0.0;
  };
  CHECK(distanceOf({}) < 0.5 * distanceOf({"--keep-outliers"}));

  const Bake kept = baked(workplace, {input, "--keep-outliers"});
  CHECK(kept.preparation.filled.empty());
  CHECK(kept.notes.find("occurs once") == std::string::npos);
}

TEST_CASE("places are in pixels of the photograph") {
  const Workplace workplace;
  const std::string input = workplace.write("grain.png", grain());
  const Bake whole = baked(workplace, {input});
  const Bake cropped = baked(workplace, {input, "--crop", "8,16,144,144"});
  REQUIRE(cropped.preparation.filled.size() == 1);
  const auto place = cropped.preparation.filled.front().place;
  CHECK_THAT(cropped.notes, Catch::Contains("at " + std::to_string(place[0] + 8) + "," +
                                            std::to_string(place[1] + 16)));
  const Bake even = baked(workplace, {workplace.write("even.png", grain(false))});
  CHECK(even.preparation.filled.empty());
}

TEST_CASE("the crop that is advised leaves out what is too large to fill") {
  const Workplace workplace;
  SrgbImage image = grain(false);
  for (int i = 0; i < 70; ++i) // a stroke down to the right
    for (int k = 0; k < 8; ++k)
      image.pixel(10 + i + k, 10 + i)[0] = 0.9f;
  const std::string input = workplace.write("stroke.png", image);
  const Bake bake = baked(workplace, {input});
  CHECK(bake.preparation.filled.empty());
  CHECK_THAT(bake.notes, Catch::Contains("too large to fill"));
  const std::size_t from = bake.notes.find("--crop ");
  REQUIRE(from != std::string::npos);
  const std::string crop = bake.notes.substr(from + 7, bake.notes.find(" leaves") - from - 7);
  INFO(crop);
  const Bake mended = baked(workplace, {input, "--crop", crop});
  CHECK(mended.notes.find("occurs once") == std::string::npos);
}

TEST_CASE("a record of places beyond the photograph is an error that names them") {
  const Workplace workplace;
  const std::string input = workplace.write("grain.png", grain());
  static_cast<void>(baked(workplace, {input}));
  const std::string small = workplace.write("small.png", SrgbImage(32, 32, 3));
  checkRefusal({"compare", small, workplace.path("noise.glb")}, kUsage,
               {"expected both inside the exemplar's 32 x 32", "was baked with 1 part filled"});
}
