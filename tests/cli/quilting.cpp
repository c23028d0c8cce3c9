// SPDX-License-Identifier: MIT
// Which exemplars `lichen bake` bakes by quilting, what --rectify makes their tile, and what noises
// of quilting do not have.
#include "command_run.h"

#include <lichen/bundle_files.h>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numbers>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

constexpr int kCutSide =
    150; // of a picture of bricks, 32 x 16 pixels each, some cut by its borders

nlohmann::json bakedAs(const Workplace& workplace, const std::string& input,
                       const Arguments& more = {}) {
  return jsonOf(Arguments{"bake", input, "-o", workplace.path("noise.glb"), "--preview", "none"} +
                more);
}

std::string notesOf(const nlohmann::json& report) { return report.at("notes").dump(); }

SrgbImage cutBricks() {
  const SrgbImage whole = brickwork(256);
  SrgbImage part(kCutSide, kCutSide, 1);
  for (int y = 0; y < kCutSide; ++y)
    std::copy_n(whole.pixel(9, y + 5), kCutSide, part.pixel(0, y));
  return part;
}

/// Bricks turned clockwise, as nearest pixels.
SrgbImage turnedBricks(double degrees) {
  constexpr int kSide = 256;
  const SrgbImage whole = brickwork(kSide);
  const double angle = degrees * std::numbers::pi / 180.0;
  const auto wrapped = [](double pixel) {
    return (int(std::floor(pixel)) % kSide + kSide) % kSide;
  };
  SrgbImage turned(kSide, kSide, 1);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      *turned.pixel(x, y) = *whole.pixel(wrapped(std::cos(angle) * x + std::sin(angle) * y),
                                         wrapped(std::cos(angle) * y - std::sin(angle) * x));
  return turned;
}

} // namespace

TEST_CASE("bricks are baked by quilting, unless an option or their size says otherwise") {
  const Workplace workplace;
  const std::string bricks = workplace.write("bricks.png", brickwork(160));
  const nlohmann::json report = bakedAs(workplace, bricks);
  CHECK(report.at("method") == "quilting");
  CHECK_THAT(notesOf(report), Catch::Contains("the exemplar repeats, so it is baked by quilting") &&
                                  Catch::Contains("--method tiling scatters it"));
  for (const Arguments& more : {Arguments{"--method", "tiling"}, Arguments{"--guide", "0"},
                                Arguments{"--crop", "0,0,120,160"}}) {
    INFO(more[0]);
    const nlohmann::json other = bakedAs(workplace, bricks, more);
    CHECK(other.at("method") == "tiling");
    CHECK_THAT(notesOf(other), !Catch::Contains("baked by quilting"));
  }
  const std::string speckles = workplace.write("speckles.png", speckled(160, 160, 3));
  CHECK(bakedAs(workplace, speckles).at("method") == "tiling");
  CHECK(bakedAs(workplace, speckles, {"--guide", "0.5"}).at("method") == "quilting");
}

TEST_CASE("the tile of bricks that borders cut is whole periods, or what --rectify says") {
  const Workplace workplace;
  const std::string bricks = workplace.write("bricks.png", cutBricks());
  const auto cornersOf = [&] {
    return readBundle(workplace.path("noise.glb")).value().noises[0].preparation.corners;
  };
  // Bricks are of one grey, so that those which a border cuts could pass for ones that fit.
  const Arguments open{"--periodic", "no", "--tile", "3"};
  const nlohmann::json whole = bakedAs(workplace, bricks, open);
  // Two rows of bricks, and one brick along them, are 32 pixels.
  CHECK(whole.at("width") == 128);
  CHECK(whole.at("height") == 128);
  CHECK_THAT(notesOf(whole),
             Catch::Contains("the tile is the part of 128 x 128 pixels that holds whole periods; "
                             "--rectify off keeps the whole picture"));
  // --tile is the width of the photograph.
  CHECK(readBundle(workplace.path("noise.glb")).value().noises[0].tileSizeMetres ==
        Approx(3.0 * 128.0 / kCutSide));
  REQUIRE(cornersOf());
  const TileCorners corners = *cornersOf();
  CHECK(corners[1][0] - corners[0][0] == Approx(128.0).margin(1.0));
  CHECK(corners[3][1] - corners[0][1] == Approx(128.0).margin(1.0));
  // By default compare uses the part that the bundle records.
  const auto comparedWith = [&](const Arguments& more) {
    return runLichen(Arguments{"compare", bricks, workplace.path("noise.glb")} + more).errors;
  };
  const auto other = Catch::Contains("the exemplar is 150 x 150, but was 128 x 128");
  CHECK_THAT(comparedWith({}), !other && Catch::Matches("[^]*--periodic no --rectify [0-9][^]*"));
  CHECK_THAT(comparedWith({"--rectify", "off"}), other);

  const nlohmann::json off = bakedAs(workplace, bricks, {"--periodic", "no", "--rectify", "off"});
  CHECK(off.at("width") == kCutSide);
  CHECK_FALSE(cornersOf());

  const nlohmann::json given =
      bakedAs(workplace, bricks, {"--rectify", "4,6,100,8,102,134,2,132", "--method", "tiling"});
  CHECK(given.at("width") == 98);   // the mean of 96 and 100
  CHECK(given.at("height") == 126); // as long as both sides
  CHECK(cornersOf() == TileCorners{{{4.0, 6.0}, {100.0, 8.0}, {102.0, 134.0}, {2.0, 132.0}}});
}

TEST_CASE("the note on a tile that is rotated by nearly too much to be found asks for a check") {
  const Workplace workplace;
  const auto notesOf = [&](double degrees) {
    const std::string bricks = workplace.write("bricks.png", turnedBricks(degrees));
    return bakedAs(workplace, bricks, {"--periodic", "no"}).at("notes").dump();
  };
  const auto doubt = Catch::Contains("; this is at the limit of what is found, so check the tile: "
                                     "if it is wrong, give its four corners to --rectify");
  CHECK_THAT(notesOf(10.0), Catch::Contains("rotated by 1") && !doubt);
  CHECK_THAT(notesOf(18.0), Catch::Matches("[^]*rotated by 1[78][^]*") && doubt);
}

TEST_CASE("the risk of cuts says what was found in the exemplar") {
  const Workplace workplace;
  const auto textOf = [&](const SrgbImage& image) {
    const nlohmann::json report =
        bakedAs(workplace, workplace.write("picture.png", image), {"--method", "quilting"});
    for (const nlohmann::json& risk : report.at("risks"))
      if (risk.at("name") == "cuts")
        return risk.dump();
    return std::string();
  };
  CHECK_THAT(textOf(brickwork(128)), Catch::Contains("the exemplar repeats or has clear outlines"));
  CHECK_THAT(textOf(speckled(160, 160, 3)),
             Catch::Contains("the exemplar neither repeats nor has clear outlines"));
  CHECK_THAT(textOf(brickwork(96)), Catch::Contains("too small to show whether it repeats"));
}

TEST_CASE("a bake with --guide 0 says why it is by tiling, unless the method is given") {
  const Workplace workplace;
  const std::string bricks = workplace.write("bricks.png", brickwork(128));
  const auto reason = Catch::Contains("--guide 0: tiles are placed anywhere, so the noise is baked "
                                      "by tiling; --method quilting");
  CHECK_THAT(bakedAs(workplace, bricks, {"--guide", "0"}).at("notes").dump(), reason);
  const nlohmann::json given = bakedAs(workplace, bricks, {"--guide", "0", "--method", "quilting"});
  CHECK(given.at("method") == "quilting");
  CHECK_THAT(given.at("notes").dump(), !reason);
}

TEST_CASE("the maps of a set are quilted together") {
  const Workplace workplace;
  const std::string color = workplace.write("bricks_color.png", brickwork(160));
  const std::string roughness = workplace.write("bricks_roughness.png", brickwork(160));
  const nlohmann::json report = bakedAs(workplace, color, {roughness});
  CHECK(report.at("method") == "quilting");
  CHECK(readBundle(workplace.path("noise.glb")).value().noises[0].maps.size() == 2);
}

TEST_CASE("textures that do not hold whole exemplars of a quilting have a note with a size") {
  const Workplace workplace;
  (void)bakedAs(workplace, workplace.write("bricks.png", brickwork(160)));
  const auto notedAt = [&](const std::string& size) {
    return succeed({"synth", workplace.path("noise.glb"), "-o", workplace.path("tiles.png"),
                    "--tileable", "--size", size})
        .errors;
  };
  CHECK_THAT(notedAt("400x300"), Catch::Contains("2.5 x 1.875 exemplars break the rows of what "
                                                 "repeats; whole numbers of them keep the rows: "
                                                 "--size 480x320"));
  CHECK_THAT(notedAt("320x160"), !Catch::Contains("break the rows"));
}

TEST_CASE("corners that are outside the picture, not four or not convex are refused") {
  const Workplace workplace;
  const std::string bricks = workplace.write("bricks.png", cutBricks());
  const std::string output = workplace.path("noise.glb");
  const Arguments bakeOf{"bake", bricks, "-o", output};
  checkRefusal(bakeOf + Arguments{"--rectify", "0,0,151,0,150,150,0,150"}, kUsage,
               {"--rectify: the corner 151,0 is outside the 150 x 150 pixels"});
  checkRefusals(
      bakeOf,
      std::vector<RefusedValues>{
          {"--rectify",
           {"0,0,100,0,100,100", "0,0,100,100,100,0,0,100", "whole"},
           "auto, off, or 8 numbers from 0 with commas between them: X,Y of the upper left, upper "
           "right, lower right and lower left corner"}});
  // Verbs that do not look for whole periods refuse to.
  for (const Arguments& verb : {Arguments{"compare"}, Arguments{"mix", "-o", output}})
    checkRefusals(verb + Arguments{bricks, bricks},
                  std::vector<RefusedValues>{{"--rectify", {"auto"}, "off, or 8 numbers"}});
}

TEST_CASE("a quilting has neither rotated tiles nor a mix, and the message says which noise does") {
  const Workplace workplace;
  const std::string bricks = bake(workplace, workplace.write("bricks.png", brickwork(128)),
                                  "bricks.glb", {"--method", "quilting"});
  for (const Arguments& verb : {Arguments{"synth", bricks, "-o", workplace.path("new.png")},
                                Arguments{"apply", bricks, "--noise", bricks, "--material", "0",
                                          "-o", workplace.path("new.glb")}})
    checkRefusals(
        verb,
        std::vector<Refused>{
            {{"--tile-rotation", "4"},
             {"--tile-rotation: belongs to the method tiling", "noise 'bricks'",
              "is of the method quilting", "bake it with --method tiling"}},
            {{"--mix", "0.5"},
             {"--mix: noise 'bricks' is not a mix; expected one made by 'lichen mix', which blends "
              "photographs"}}});
}
