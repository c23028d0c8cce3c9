// SPDX-License-Identifier: MIT
// The risks that a bake reports for its exemplar, and the effect of --flatten.
#include "command_run.h"

#include <lichen/bundle.h>
#include <lichen/image_io.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

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

nlohmann::json jsonOf(const Workplace& workplace, const Arguments& arguments) {
  Arguments all{"bake", "-o", workplace.path("noise.glb"), "--json", "--transport", "fast"};
  all.insert(all.end(), arguments.begin(), arguments.end());
  const Ended ended = runLichen(all);
  INFO(ended.errors);
  REQUIRE(ended.code == 0);
  return nlohmann::json::parse(ended.output);
}

} // namespace

TEST_CASE("a bake begins with its verdict, and the JSON lists all risks") {
  const Workplace workplace;
  const std::string input = workplace.write("slope.png", slope());
  const Arguments asItIs{input, "--flatten", "none"};
  const Ended ended = runLichen({"bake", input, "-o", workplace.path("noise.glb"), "--flatten",
                                 "none", "--method", "tiling"});
  CHECK(ended.code == 0);
  CHECK_THAT(ended.output, Catch::StartsWith("verdict: unsuitable: the contrast will vary by ") &&
                               Catch::Contains("; what helps: --flatten 21\n"));
  const nlohmann::json verdict = jsonOf(workplace, asItIs).at("verdict");
  CHECK(verdict.at("level") == "unsuitable");
  CHECK(verdict.at("map") == "baseColor");
  CHECK(verdict.at("risk") == "cloudiness");
  const nlohmann::json risks = jsonOf(workplace, asItIs).at("risks");
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
    return jsonOf(workplace, {workplace.write("picture.png", image)}).at("risks");
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
  const std::string color = workplace.write("stone_diff.png", speckled(64, 64, 3));
  const std::string uneven = workplace.write("slope_diff.png", slope());
  const std::string roughness = workplace.write("stone_rough.png", slope());
  const Ended ended = runLichen({"bake", color, roughness, "-o", workplace.path("noise.glb")});
  CHECK(ended.code == 0);
  CHECK_THAT(ended.output,
             Catch::StartsWith("verdict: unsuitable: occlusionRoughnessMetallic: the contrast ") &&
                 Catch::Contains("what helps: --flatten 21\n")); // a third of the side
  const nlohmann::json flattened = jsonOf(workplace, {color, roughness, "--flatten", "21"});
  CHECK(flattened.at("risks")[2].at("level") == "none");
  CHECK(jsonOf(workplace, {color, roughness}).at("risks")[2].at("map") ==
        "occlusionRoughnessMetallic");
  CHECK(jsonOf(workplace, {uneven, roughness, "--flatten", "none"}).at("risks")[2].at("map") ==
        "baseColor");
}

TEST_CASE("an advised period is in pixels of the first map, like --flatten") {
  const Workplace workplace;
  const std::string color = workplace.write("stone_diff.png", speckled(kSide, kSide, 3));
  const auto riskOf = [&](int width, int height, const Arguments& flatten) {
    const std::string roughness = workplace.write("stone_rough.png", slope(width, height));
    Arguments arguments{color, roughness};
    arguments.insert(arguments.end(), flatten.begin(), flatten.end());
    return jsonOf(workplace, arguments).at("risks")[2];
  };
  for (const auto [width, height] :
       {std::array{2 * kSide, 2 * kSide}, std::array{kSide / 2, kSide / 2},
        std::array{kSide, 2 * kSide}}) {
    INFO(width << " x " << height);
    const nlohmann::json risk = riskOf(width, height, {});
    CHECK(risk.at("map") == "occlusionRoughnessMetallic");
    CHECK_THAT(risk.at("remedy").get<std::string>(),
               Catch::StartsWith("--flatten 21, or ")); // a third of the first map's side
    CHECK(riskOf(width, height, {"--flatten", "21"}).at("level") == "none");
  }
}

TEST_CASE("the remedies for opacity do not mention --flatten") {
  const Workplace workplace;
  const std::string color = workplace.write("leaf_diff.png", speckled(64, 64, 3));
  const std::string opacity = workplace.write("leaf_opacity.png", slope());
  const nlohmann::json risk = jsonOf(workplace, {color, opacity}).at("risks")[2];
  CHECK(risk.at("map") == "opacity");
  CHECK(risk.at("level") == "severe");
  CHECK(risk.at("remedy") == "even light");
}

TEST_CASE("light is removed from the base colour only, and a uniform slope of heights is no risk") {
  const Workplace workplace;
  const std::string color = workplace.write("stone_diff.png", slope());
  const std::string height = workplace.write("stone_disp.png", slope());
  const nlohmann::json json = jsonOf(workplace, {color, height});
  CHECK(json.at("risks")[2].at("level") == "none");
  CHECK_THAT(json.at("notes").dump(), Catch::Contains("is removed from the base colour"));
  const Result<Bundle> bundle = readBundle(workplace.path("noise.glb"));
  REQUIRE(bundle.ok());
  CHECK(bundle.value().noises.front().preparation.flattened == std::vector{MapTarget::baseColor});
  const nlohmann::json heightAlone = jsonOf(workplace, {height});
  CHECK(heightAlone.at("notes").dump().find("light") == std::string::npos);
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
  const nlohmann::json json = jsonOf(workplace, {input});
  CHECK(json.at("notes").dump().find("light,") == std::string::npos);
  CHECK(json.at("risks")[2].at("level") == "severe");
  CHECK(json.at("risks")[2].at("remedy").get<std::string>().find("--flatten") == std::string::npos);
}

TEST_CASE("light is removed unless --flatten says otherwise, and a note says what was removed") {
  const Workplace workplace;
  const std::string input = workplace.write("slope.png", slope());
  for (const Arguments& given : {Arguments{}, Arguments{"--flatten", "auto"}}) {
    Arguments arguments{input};
    arguments.insert(arguments.end(), given.begin(), given.end());
    const nlohmann::json json = jsonOf(workplace, arguments);
    CHECK(json.at("risks")[2].at("level") == "none");
    CHECK_THAT(json.at("notes").dump(), Catch::Contains("uneven light, from ") &&
                                            Catch::Contains("--flatten none keeps it"));
  }
  const nlohmann::json by24 = jsonOf(workplace, {input, "--flatten", "24"});
  CHECK(by24.at("risks")[2].at("level") == "none");
  CHECK_THAT(by24.at("notes").dump(),
             Catch::Contains("--flatten removes variation slower than 24"));
  const nlohmann::json untouched = jsonOf(workplace, {input, "--flatten", "none"});
  CHECK(untouched.at("risks")[2].at("level") == "severe");
  CHECK(untouched.at("notes").dump().find("remove") == std::string::npos);
}

TEST_CASE("cosines keep the structure of bricks, which no warning then calls lost") {
  const Workplace workplace;
  const std::string bricks = workplace.write("bricks.png", brickwork(128));
  const auto notesOf = [&](const Arguments& more) {
    Arguments arguments{
        "bake", bricks, "-o", workplace.path("bricks.glb"), "--method", "local-random-phase"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = runLichen(arguments);
    return ended.output + ended.errors;
  };
  const auto lost = Catch::Contains("outlines will be lost; what helps: --structure 1");
  CHECK_THAT(notesOf({}), !lost && Catch::Contains("the exemplar repeats, so "));
  CHECK_THAT(notesOf({"--structure", "0"}), lost);
  CHECK_THAT(notesOf({"--structure", "0", "--turbulence", "0.1"}),
             Catch::Contains("--turbulence has no effect"));
  CHECK_THAT(notesOf({"--spectrum", "ring:8:12"}), !lost);
  CHECK_THAT(jsonOf(workplace, {bricks}).at("verdict").at("sentence").get<std::string>(),
             Catch::EndsWith("what helps: --method quilting"));
}

TEST_CASE("--flatten takes none, auto or a period in range") {
  for (const char* value : {"3", "16385", "some", "-8", "nan"})
    checkRefusal({"bake", "a.png", "-o", "a.glb", "--flatten", value}, 2,
                 {std::string("--flatten ") + value, "none, auto or a number from 4 to 16384"});
}

TEST_CASE("a texton bake says what its fit lacks, and the verdict what every texton does") {
  const Workplace workplace;
  const std::string fine = workplace.write("fine.png", speckled(64, 64, 1));
  const std::string slow = workplace.write("slow.png", smoothGrey(64));
  const auto bake = [&](const std::string& input, const Arguments& more) {
    Arguments arguments{"bake", input, "--method", "texton", "-o", workplace.path("t.glb")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = runLichen(arguments);
    CHECK(ended.code == 0);
    return ended;
  };
  const auto notesOf = [&](const std::string& input, const Arguments& more) {
    return bake(input, more).errors;
  };
  const auto close = Catch::Contains("close to the spectrum");
  const auto few = Catch::Contains("impacts are few: --impacts");
  const auto cut = Catch::Contains("which limits the texton");
  CHECK_THAT(notesOf(fine, {"--support", "16"}), !close && !few && !cut);
  CHECK_THAT(notesOf(fine, {"--support", "16", "--impacts", "5"}),
             !close && Catch::Contains("note: 5 impacts are few"));
  // Blobs as wide as the support have most of their variation in slower waves.
  CHECK_THAT(notesOf(slow, {"--support", "4"}),
             Catch::Contains("the texton is not close to the spectrum, with the colours and "
                             "outlines of Gaussian noise: ") &&
                 Catch::Contains("what helps: a larger --support, or --method tiling"));
  CHECK_THAT(notesOf(fine, {"--support", "65"}), !close && !cut);
  CHECK_THAT(notesOf(fine, {"--support", "66"}),
             !close && cut && Catch::Contains("--support 66: the exemplar has 64 x 64 pixels"));
  CHECK_THAT(bake(workplace.write("bricks.png", brickwork(64)), {}).output,
             Catch::StartsWith("verdict: unsuitable: ") &&
                 Catch::Contains("what helps: --method tiling"));
}

TEST_CASE("a texton of a set is judged by its worst channel, which the note names") {
  const Workplace workplace;
  const std::string color = workplace.write("stone_diff.png", speckled(64, 64, 3));
  const auto noteOf = [&](const SrgbImage& height) {
    const Ended ended =
        runLichen({"bake", color, workplace.write("stone_disp.png", height), "--method", "texton",
                   "--support", "8", "-o", workplace.path("t.glb"), "--preview", "none"});
    CHECK(ended.code == 0);
    return ended.errors;
  };
  // The channels' speckles are unrelated, so all four together have a larger error than each alone.
  CHECK_THAT(noteOf(speckled(64, 64, 1)), !Catch::Contains("close to the spectrum"));
  // Blobs as wide as the support.
  CHECK_THAT(noteOf(smoothGrey(64)),
             Catch::Contains("the texton is not close to the spectrum, with the colours and "
                             "outlines of Gaussian noise: ") &&
                 Catch::Contains(" (height); "));
}
