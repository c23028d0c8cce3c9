// SPDX-License-Identifier: MIT
// The risks that a bake reports for its exemplar, and the effect of --flatten.
#include "command_run.h"

#include <lichen/bundle_files.h>
#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <tuple>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

constexpr int kSide = 64;

/// Grain on light from one side: a hash per pixel plus a ramp.
SrgbImage slope(int width = kSide, int height = kSide) {
  SrgbImage image(width, height, 1);
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    state = state * 1664525u + 1013904223u; // Numerical Recipes, section 7.1
    const float grain = float(state >> 8u) * 0x1p-24f;
    image.values[i] = 0.3f + 0.4f * float(int(i) % width) / float(width) + 0.2f * grain;
  }
  return image;
}

/// The report of a bake.
nlohmann::json bakedOf(const Workplace& workplace, const Arguments& arguments) {
  return jsonOf(Arguments{"bake", "-o", workplace.path("noise.glb"), "--method", "tiling"} +
                arguments);
}

nlohmann::json lowFrequency(const nlohmann::json& report) { return report.at("risks").at(2); }

} // namespace

TEST_CASE("a bake begins with its verdict, and the JSON lists all risks") {
  const Workplace workplace;
  const std::string input = workplace.write("slope.png", slope());
  CHECK_THAT(succeed({"bake", input, "-o", workplace.path("noise.glb"), "--flatten", "none",
                      "--method", "tiling"})
                 .output,
             Catch::StartsWith("verdict: unsuitable: the contrast will vary by ") &&
                 Catch::Contains("; what helps: --flatten 21\n"));
  const nlohmann::json report = bakedOf(workplace, {input, "--flatten", "none"});
  const nlohmann::json& verdict = report.at("verdict");
  CHECK(verdict.at("level") == "unsuitable");
  CHECK(verdict.at("map") == "baseColor");
  CHECK(verdict.at("risk") == "cloudiness");
  const nlohmann::json& risks = report.at("risks");
  REQUIRE(risks.size() == 5);
  for (const nlohmann::json& risk : risks) {
    CHECK(risk.at("map") == "baseColor");
    CHECK(risk.at("score").is_number());
    CHECK(risk.at("sentence").get<std::string>().size() > 10);
    CHECK((risk.at("level") == "none") == (risk.at("remedy") == ""));
  }
  CHECK(risks[2].at("name") == "low-frequency");
  CHECK(risks[2].at("level") == "severe");
  CHECK(risks[3].at("name") == "clipping");
  CHECK(risks[3].at("level") == "none");
}

TEST_CASE("a picture with few colours gets a note on the colours and no advice on exposure") {
  const Workplace workplace;
  SrgbImage dither(kSide, kSide, 1), soft(kSide, kSide, 1);
  std::uint32_t state = 1;
  for (std::size_t i = 0; i < dither.values.size(); ++i) {
    state = state * 1664525u + 1013904223u; // Numerical Recipes, section 7.1
    soft.values[i] = float(state >> 8u) * 0x1p-24f;
    dither.values[i] = soft.values[i] < 0.5f ? 0.0f : 1.0f;
  }
  const auto risks = [&](const SrgbImage& image) {
    return bakedOf(workplace, {workplace.write("picture.png", image)}).at("risks");
  };
  const nlohmann::json hard = risks(dither);
  CHECK(hard[1].at("level") == "severe");
  CHECK_THAT(hard[1].at("sentence").get<std::string>(),
             Catch::Contains("only 2 colours") && Catch::Contains("ragged"));
  CHECK(hard[3].at("level") == "none");
  CHECK(risks(soft)[1].at("level") == "none");
}

TEST_CASE("a set reports each risk for the base colour, or for a map with a higher score") {
  const Workplace workplace;
  const std::string color = workplace.write("stone_diff.png", speckled(kSide, kSide, 3));
  const std::string uneven = workplace.write("slope_diff.png", slope());
  const std::string roughness = workplace.write("stone_rough.png", slope());
  CHECK_THAT(succeed({"bake", color, roughness, "-o", workplace.path("noise.glb")}).output,
             Catch::StartsWith("verdict: unsuitable: occlusionRoughnessMetallic: the contrast ") &&
                 Catch::Contains("what helps: --flatten 21\n")); // a third of the side
  CHECK(lowFrequency(bakedOf(workplace, {uneven, roughness, "--flatten", "none"})).at("map") ==
        "baseColor");
  // --flatten cannot help opacity.
  const std::string opacity = workplace.write("leaf_opacity.png", slope());
  const nlohmann::json risk = lowFrequency(bakedOf(workplace, {color, opacity}));
  CHECK(risk.at("map") == "opacity");
  CHECK(risk.at("level") == "severe");
  CHECK(risk.at("remedy") == "even light");
}

TEST_CASE("an advised period is in pixels of the first map, like --flatten") {
  const Workplace workplace;
  const std::string color = workplace.write("stone_diff.png", speckled(kSide, kSide, 3));
  for (const auto& [width, height] :
       {std::pair{kSide, kSide}, {kSide / 2, kSide / 2}, {kSide, 2 * kSide}}) {
    INFO(width << " x " << height);
    const Arguments set{color, workplace.write("stone_rough.png", slope(width, height))};
    const nlohmann::json risk = lowFrequency(bakedOf(workplace, set));
    CHECK(risk.at("map") == "occlusionRoughnessMetallic");
    CHECK_THAT(risk.at("remedy").get<std::string>(),
               Catch::StartsWith("--flatten 21, or ")); // a third of the first map's side
    CHECK(lowFrequency(bakedOf(workplace, set + Arguments{"--flatten", "21"})).at("level") ==
          "none");
  }
}

TEST_CASE("light is removed from the base colour only, and a uniform slope of heights is no risk") {
  const Workplace workplace;
  const std::string color = workplace.write("stone_diff.png", slope());
  const std::string height = workplace.write("stone_disp.png", slope());
  const nlohmann::json report = bakedOf(workplace, {color, height});
  CHECK(lowFrequency(report).at("level") == "none");
  CHECK_THAT(report.at("notes").dump(), Catch::Contains("is removed from the base colour"));
  const Result<Bundle> bundle = readBundle(workplace.path("noise.glb"));
  REQUIRE(bundle.ok());
  CHECK(bundle.value().noises.front().preparation.flattened == std::vector{MapTarget::baseColor});
  CHECK_THAT(bakedOf(workplace, {height}).at("notes").dump(), !Catch::Contains("light"));
}

TEST_CASE("a large object is not light, and no period is advised") {
  const Workplace workplace;
  SrgbImage disc = speckled(128, 128, 3);
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x)
      for (int c = 0; c < 3; ++c)
        disc.pixel(x, y)[c] =
            0.2f * disc.pixel(x, y)[c] + (std::hypot(x - 64.0, y - 64.0) < 40.0 ? 0.7f : 0.1f);
  const std::string input = workplace.write("disc.png", disc);
  const nlohmann::json report = bakedOf(workplace, {input});
  CHECK_THAT(report.at("notes").dump(), !Catch::Contains("light,"));
  CHECK(lowFrequency(report).at("level") == "severe");
  CHECK_THAT(lowFrequency(report).at("remedy").get<std::string>(), !Catch::Contains("--flatten"));
}

TEST_CASE("light is removed unless --flatten says otherwise, and a note says what was removed") {
  const Workplace workplace;
  const std::string input = workplace.write("slope.png", slope());
  const std::string kept = "uneven light, from ",
                    period = "--flatten removes variation slower than 24";
  const std::tuple<Arguments, const char*, std::string> rows[] = {
      {{}, "none", kept},
      {{"--flatten", "auto"}, "none", kept},
      {{"--flatten", "24"}, "none", period},
      {{"--flatten", "none"}, "severe", ""}};
  for (const auto& [options, level, note] : rows) {
    INFO(level << ": " << note);
    const nlohmann::json report = bakedOf(workplace, Arguments{input} + options);
    CHECK(lowFrequency(report).at("level") == level);
    CHECK_THAT(report.at("notes").dump(), Catch::Contains(note));
    CHECK((report.at("notes").dump().find("remove") == std::string::npos) == note.empty());
  }
}

TEST_CASE("cosines keep the structure of bricks, which no warning then calls lost") {
  const Workplace workplace;
  const std::string bricks = workplace.write("bricks.png", brickwork(128));
  const auto notesOf = [&](const Arguments& more) {
    const Ended ended = succeed(Arguments{"bake", bricks, "-o", workplace.path("bricks.glb"),
                                          "--method", "local-random-phase"} +
                                more);
    return ended.output + ended.errors;
  };
  const auto lost = Catch::Contains("outlines will be lost; what helps: --structure 1");
  CHECK_THAT(notesOf({}), !lost && Catch::Contains("the exemplar repeats, so "));
  CHECK_THAT(notesOf({"--structure", "0", "--turbulence", "0.1"}),
             lost && Catch::Contains("--turbulence has no effect"));
  CHECK_THAT(notesOf({"--spectrum", "ring:8:12"}), !lost);
  CHECK_THAT(bakedOf(workplace, {bricks}).at("verdict").at("sentence").get<std::string>(),
             Catch::EndsWith("what helps: --method quilting"));
}

TEST_CASE("a texton bake says what its fit lacks, and the verdict what every texton does") {
  const Workplace workplace;
  const std::string fine = workplace.write("fine.png", speckled(64, 64, 1));
  const std::string color = workplace.write("stone_diff.png", speckled(64, 64, 3));
  const auto bakeBy = [&](const Arguments& arguments) {
    return succeed(Arguments{"bake", "--method", "texton", "--preview", "none", "-o",
                             workplace.path("t.glb")} +
                   arguments);
  };
  const auto close = Catch::Contains("the texton is not close to the spectrum, with the colours "
                                     "and outlines of Gaussian noise: ");
  const auto few = Catch::Contains("impacts are few: --impacts");
  const auto cut = Catch::Contains("which limits the texton");
  CHECK_THAT(bakeBy({fine, "--support", "16"}).errors, !close && !few && !cut);
  CHECK_THAT(bakeBy({fine, "--support", "16", "--impacts", "5"}).errors,
             !close && Catch::Contains("note: 5 impacts are few"));
  // Blobs as wide as the support have most of their variation in slower waves.
  CHECK_THAT(bakeBy({workplace.write("slow.png", smoothGrey(64)), "--support", "4"}).errors,
             close && Catch::Contains("what helps: a larger --support, or --method tiling"));
  CHECK_THAT(bakeBy({fine, "--support", "65"}).errors, !close && !cut);
  CHECK_THAT(bakeBy({fine, "--support", "66"}).errors,
             !close && cut && Catch::Contains("--support 66: the exemplar has 64 x 64 pixels"));
  CHECK_THAT(bakeBy({workplace.write("bricks.png", brickwork(64))}).output,
             Catch::StartsWith("verdict: unsuitable: ") &&
                 Catch::Contains("what helps: --method tiling"));
  // A set is judged by its worst channel. The channels' speckles are unrelated, so all four
  // together have a larger error than each alone.
  const auto noteOf = [&](const SrgbImage& height) {
    return bakeBy({color, workplace.write("stone_disp.png", height), "--support", "8"}).errors;
  };
  CHECK_THAT(noteOf(speckled(64, 64, 1)), !close);
  CHECK_THAT(noteOf(smoothGrey(64)), close && Catch::Contains(" (height); "));
}
