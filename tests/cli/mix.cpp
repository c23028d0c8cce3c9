// SPDX-License-Identifier: MIT
// `lichen mix`: the noise it makes from photographs, and the other verbs on that noise.
#include "apply_run.h"
#include "bundle_example.h"

#include <lichen/bundle.h>
#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>

using namespace lichen;
using namespace lichen::cli_test;
using nlohmann::json;

namespace {

/// Returns colours near `level`, with a fraction of the variation of `of`.
SrgbImage about(float level, SrgbImage of) {
  for (float& value : of.values)
    value = level + 0.3f * (value - 0.5f);
  return of;
}

/// Two photographs and their mix, made once.
struct Made {
  Workplace workplace;
  std::string dark = workplace.write("dark.png", about(0.3f, smooth(24)));
  std::string light = workplace.write("light.png", about(0.7f, speckled(24, 24, 3)));
  std::string grey = workplace.write("rough_roughness.png", smoothGrey(24));
  std::string bundle = mixed("mix.glb");

  [[nodiscard]] std::string mixed(const std::string& output, const Arguments& more = {}) const {
    succeed(Arguments{"mix", dark, light, "-o", workplace.path(output), "--support", "8", "--steps",
                      "5", "--preview", "none"} +
            more);
    return workplace.path(output);
  }
};

const Made& made() {
  static const Made made;
  return made;
}

json noiseOf(const std::string& bundle) { return jsonOf({"inspect", bundle}).at("noises").at(0); }

/// Returns the mean of a channel over columns [from, to) of a PNG, in code values from 0 to 1.
double meanOf(const std::string& file, int from, int to) {
  const auto image = std::get<SrgbImage>(readImage(file).value().pixels);
  double sum = 0.0;
  for (int y = 0; y < image.height; ++y)
    for (int x = from; x < to; ++x)
      sum += double(image.pixel(x, y)[0]);
  return sum / double(image.height * (to - from));
}

} // namespace

TEST_CASE("mix writes a valid bundle whose first and last steps match the photographs") {
  const Made& m = made();
  CHECK(jsonOf({"check", m.bundle}).at("warnings") == 0);
  const json noise = noiseOf(m.bundle);
  CHECK(noise.at("name") == "dark-light");
  CHECK(noise.at("texton").at("steps") == 5);
  const json& map = noise.at("maps").at(0);
  REQUIRE(map.at("laterSteps").size() == 4);
  const auto mean = [](const SrgbImage& image) { // of the roots of light
    double sum = 0.0;
    for (std::size_t i = 0; i < image.pixelCount(); ++i)
      sum += std::sqrt(double(srgbToLinear(image.values[3 * i])));
    return sum / double(image.pixelCount());
  };
  constexpr double kRounding = 1.0 / 255.0;
  CHECK(map.at("mean")[0].get<double>() == Approx(mean(about(0.3f, smooth(24)))).margin(kRounding));
  CHECK(map.at("laterSteps")[3].at("mean")[0].get<double>() ==
        Approx(mean(about(0.7f, speckled(24, 24, 3)))).margin(kRounding));
  CHECK(noise.at("materials")[0].at("mix").at("source") == "direction");
}

TEST_CASE("mix reports its result as JSON") {
  const Made& m = made();
  const json report = jsonOf({"mix", m.dark, m.light, m.dark, "-o", m.workplace.path("three.glb"),
                              "--support", "8", "--steps", "5", "--preview", "none"});
  CHECK(report.at("steps") == 9);
  CHECK(report.at("modelErrors").size() == 9);
  CHECK(report.at("largestStep") > 0.0);
  CHECK(report.at("width") == 24);
  CHECK(report.at("inputs").size() == 3);
  CHECK(report.at("maps") == std::vector<std::string>{"baseColor"});
}

TEST_CASE("the note on an input that is not a Gaussian texture names it and a remedy") {
  // Squares of two values, a third of them dark: two thirds of a standard deviation from a
  // Gaussian.
  SrgbImage spots = speckled(64, 64, 3);
  for (int y = 0; y < spots.height; ++y)
    for (int x = 0; x < spots.width; ++x)
      for (int c = 0; c < 3; ++c)
        spots.pixel(x, y)[c] = (x / 4 * 7 + y / 4 * 11 + x / 4 * (y / 4)) % 5 < 2 ? 0.2f : 0.8f;
  const Workplace workplace;
  const std::string input = workplace.write("spots.png", spots);
  CHECK_THAT(succeed({"mix", input, made().dark, "-o", workplace.path("mix.glb"), "--support", "8",
                      "--steps", "2", "--preview", "none"})
                 .errors,
             Catch::Contains("spots.png: histogram (severe): the histogram differs") &&
                 Catch::Contains("what helps: lichen bake --method tiling for this input alone") &&
                 !Catch::Contains("dark.png: histogram"));
}

TEST_CASE("mix with --weights makes one texton between all inputs") {
  const Made& m = made();
  const std::string bundle = m.workplace.path("between.gltf");
  succeed({"mix", m.dark, m.light, "-o", bundle, "--support", "8", "--weights", "3,1"});
  const json noise = noiseOf(bundle), ends = noiseOf(m.bundle).at("maps")[0];
  CHECK(noise.at("texton").at("steps") == 1);
  CHECK(noise.at("maps")[0].at("mean")[0].get<double>() ==
        Approx(0.75 * ends.at("mean")[0].get<double>() +
               0.25 * ends.at("laterSteps")[3].at("mean")[0].get<double>()));
}

TEST_CASE("mix reads folders with the same maps and rejects folders with other maps") {
  const Workplace workplace;
  const auto folder = [&](const std::string& name, bool hasRoughness) {
    std::filesystem::create_directory(workplace.path(name));
    workplace.write(name + "/color.png", smooth(16));
    if (hasRoughness)
      workplace.write(name + "/roughness.png", smoothGrey(8));
    return workplace.path(name);
  };
  const std::string green = folder("moss", true), rock = folder("rock", true),
                    sand = folder("sand", false);
  const std::string output = workplace.path("sets.glb");
  const json report = jsonOf({"mix", green, rock, "-o", output, "--support", "6", "--steps", "3"});
  CHECK(report.at("maps") == Arguments{"baseColor", "occlusionRoughnessMetallic"});
  CHECK(report.at("name") == "moss-rock");
  succeed({"check", output});
  checkRefusal({"mix", green, sand, "-o", output}, kBadInput,
               {"sand: has no occlusionRoughnessMetallic, which", "moss has",
                "expected the same maps in all exemplars"});
}

TEST_CASE("mix reports what it cannot mix and leaves no file") {
  const Made& m = made();
  const std::string output = m.workplace.path("new.glb");
  checkRefusals(
      {"mix", "-o", output},
      std::vector<Refused>{
          {{m.dark}, {"INPUT: 1 given; expected 2 to 16"}},
          {Arguments(17, m.dark), {"INPUT: 17 given; expected 2 to 16"}},
          {{}, {"INPUT"}},
          {{m.dark, m.light, m.dark, "--steps", "33"},
           {"steps from an exemplar to the next: 33", "expected 2 to 32 for 3 exemplars"}},
          {{m.dark, m.workplace.path("absent.png")}, {"absent.png"}, kBadInput},
          {{m.dark, m.workplace.write("no.png", std::string("no image"))}, {"no.png"}, kBadInput},
          {{m.bundle, m.bundle},
           {"mix.glb: is a bundle; expected photographs or folders",
            "'lichen layer' combines bundles of the methods tiling, texton"},
           kUsage}});
  const Arguments two{"mix", m.dark, m.light, "-o", output};
  checkRefusals(two, std::vector<RefusedValues>{
                         {"--steps", {"1", "65"}, "a whole number from 2 to 64"},
                         {"--weights", {"1,-2", "1,"}, "1 to 16 numbers from 0 to 1000000"}});
  checkRefusals(two,
                std::vector<Refused>{
                    {{"--weights", "1,2,3"}, {"--weights: 3 for 2 inputs; expected one per input"}},
                    {{"--weights", "0,0"}, {"--weights: all are 0; expected a sum above 0"}},
                    {{"--weights", "1,2", "--steps", "5"},
                     {"--steps: given with --weights, which makes one texton"}}});
  CHECK(!std::filesystem::exists(output));
  checkRefusal({"mix", m.dark, m.light, "-o", m.workplace.path("new.png")}, kUsage,
               {"new.png", ".glb or .gltf"});
}

TEST_CASE("compare measures a mix at the weight of --mix") {
  const Made& m = made();
  const auto measured = [&](const std::string& exemplar, const Arguments& more) {
    const Ended ended = runLichen(Arguments{"compare", exemplar, m.bundle, "--json"} + more);
    INFO(ended.errors);
    std::map<std::string, double> values;
    const json report = json::parse(ended.output);
    for (const json& measure : report.at("measures"))
      if (measure.at("value").is_number())
        values[measure.at("name").get<std::string>()] = measure.at("value").get<double>();
    return values;
  };
  // The means of the inputs differ by 0.4 in each channel. One texton has blobs, the other has
  // speckles, so each is closer to its own input.
  for (const auto& [exemplar, own, other] :
       {std::tuple(m.dark, "0", "1"), std::tuple(m.light, "1", "0")}) {
    const auto right = measured(exemplar, {"--mix", own});
    const auto wrong = measured(exemplar, {"--mix", other});
    CHECK(right.at("color_distance") < 0.1);
    CHECK(wrong.at("color_distance") > 0.2);
    CHECK(right.at("model_error") < 0.95 * wrong.at("model_error"));
  }
  CHECK(measured(m.dark, {}) == measured(m.dark, {"--mix", "0"}));
  checkRefusal({"compare", m.dark, moss(), "--mix", "1"}, kUsage,
               {"--mix: noise 'moss' is not a mix"});
  checkRefusal({"compare", m.dark, m.light, "--mix", "1"}, kUsage, {"--mix 1:", "is an image"});
  checkRefusal({"compare", m.dark, m.bundle, "--mix", "2"}, kUsage, {"--mix 2:"});
}

TEST_CASE("compare cuts a frame off the photograph of a mix, as the mix did") {
  const Workplace workplace;
  const std::string dark =
      workplace.write("dark.png", framed(about(0.3f, speckled(32, 32, 3)), 2, 2, 2));
  const std::string light = workplace.write("light.png", about(0.7f, speckled(28, 30, 3)));
  const std::string bundle = workplace.path("mix.glb");
  succeed({"mix", dark, light, "-o", bundle, "--support", "8", "--preview", "none"});
  CHECK_THAT(runLichen({"compare", dark, bundle}).errors, Catch::Contains("a frame is cut off"));
}

TEST_CASE("synth shows a mix at one weight or along a ramp") {
  const Made& m = made();
  const Arguments base{"synth", m.bundle, "-o", m.workplace.path("s.png"), "--size", "256x64"};
  const auto synth = [&](const Arguments& more) {
    succeed(base + more);
    return m.workplace.path("s.png");
  };
  // Means of at least 16 x 64 pixels, with a standard deviation of 0.3 of the full range: within
  // 0.1.
  const std::string ramp = synth({});
  CHECK(meanOf(ramp, 0, 16) == Approx(0.3).margin(0.1));
  CHECK(meanOf(ramp, 240, 256) == Approx(0.7).margin(0.1));
  CHECK(meanOf(synth({"--mix", "1"}), 0, 128) == Approx(0.7).margin(0.06));
  CHECK(meanOf(synth({"--mix", "0.5", "--tileable"}), 0, 256) == Approx(0.5).margin(0.06));
  CHECK(meanOf(synth({"--tileable"}), 0, 256) == Approx(0.5).margin(0.06));
  const std::string back = synth({"--mix", "1,0"});
  CHECK(meanOf(back, 0, 16) > meanOf(back, 240, 256) + 0.2);
  checkRefusals(
      base,
      std::vector<Refused>{
          {{"--mix", "1.5"}, {"--mix 1.5: expected a weight from 0 to 1"}},
          {{"--mix", "0,1,0"}, {"--mix 0,1,0: expected a weight from 0 to 1, or two"}},
          {{"--mix", "0,1", "--tileable"}, {"mix 0,1 of a tileable image; expected one weight"}}});
  checkRefusal({"synth", moss(), "-o", m.workplace.path("new.png"), "--mix", "0.5"}, kUsage,
               {"--mix: noise 'moss' is not a mix"});
}

TEST_CASE("apply sets the weight of a mix from every source") {
  const Made& m = made();
  Apply apply;
  apply.primitive()["attributes"]["COLOR_1"] =
      apply.scene.addFloats(std::vector<float>(std::size_t(4 * 4), 0.5f), "VEC4", 4);
  const auto mixOf = [&](const Arguments& more) {
    const json document = apply.document(m.bundle, "wood", more);
    return document["materials"][0]["extensions"][kExtension].value("mix", json());
  };
  CHECK(mixOf({}).at("source") == "direction"); // the bundle's own direction
  CHECK(mixOf({"--mix", "0.25"}) == json{{"source", "constant"}, {"weight", 0.25}});
  CHECK(mixOf({"--mix-direction", "0,1,2,1"}) ==
        json{{"source", "direction"}, {"start", {0.0, 1.0}}, {"end", {2.0, 1.0}}});
  CHECK(mixOf({"--mix-vertex-color", "1", "--mix-channel", "alpha"}) ==
        json{{"source", "vertexColor"}, {"set", 1}, {"channel", 3}});
  CHECK(mixOf({"--mix-texture", m.grey, "--mix-channel", "green"}) ==
        json{{"source", "texture"}, {"texture", {{"index", 0}}}, {"channel", 1}});
  const json document = apply.output();
  REQUIRE(document["textures"].size() == 1);
  const json& image = document["images"][document["textures"][0]["source"].get<std::size_t>()];
  CHECK(image.at("mimeType") == "image/png");
  // If the texture repeated, the last column would get half the weight of the first.
  constexpr int kClampToEdge = 33071;
  CHECK(document["samplers"][document["textures"][0]["sampler"].get<std::size_t>()] ==
        json{{"wrapS", kClampToEdge}, {"wrapT", kClampToEdge}});
  // A mask belongs to its scene: texture indices of another bundle mean other textures.
  const std::string merged = apply.workplace.path("merged.glb");
  CHECK_THAT(
      succeed({"merge", apply.workplace.path("out.glb"), "-o", merged, "--preview", "none"}).errors,
      Catch::Contains("the mask of its mix is not copied"));
  CHECK(noiseOf(merged).at("materials")[0].at("mix").at("source") == "constant");
}

TEST_CASE("sources of a mix's weight that do not exist or do not vary are errors") {
  const Made& m = made();
  const Apply apply;
  const auto file = [&](const char* name, const std::string& text) {
    return apply.workplace.write(name, text);
  };
  const std::string noImage = "no.png: not a PNG or JPEG", index = "index of a texture";
  const Refused rows[] = {
      {{"--mix", "2"}, {"--mix 2: expected a number from 0 to 1"}},
      {{"--mix", "0.5", "--mix-vertex-color", "1"},
       {"--mix, --mix-vertex-color: 2 sources of the weight"}},
      {{"--mix-channel", "red"}, {"--mix-channel: no texture and no vertex colours"}},
      {{"--mix-direction", "0,0,0,0"}, {"two places 0.000001 or more apart"}},
      {{"--mix-direction", "0,0,0,1e-200"}, {"two places 0.000001 or more apart"}},
      {{"--mix-direction", "0,0,1"}, {"--mix-direction 0,0,1:"}},
      {{"--mix-vertex-color", "2"}, {"has no COLOR_2, which --mix-vertex-color"}, kBadInput},
      {{"--mix-texture", m.grey, "--mix-channel", "alpha"},
       {"has no alpha, which --mix-channel asks for"},
       kBadInput},
      {{"--mix-texture", "3"}, {"--mix-texture 3:", "has 0 textures"}},
      {{"--mix-texture", apply.workplace.path("absent.png")}, {"absent.png"}, kBadInput},
      {{"--mix-texture", file("1_no.png", "no image")}, {noImage, index}, kBadInput},
      {{"--mix-texture", file("2_no.png", "")}, {noImage, index}, kBadInput},
      {{"--mix-texture", file("3_no.png", "\x76\x2f\x31\x01 an EXR")}, {noImage, index}, kBadInput},
      {{"--mix-texture", file("4_no.png", "\x89PNG, but")}, {"no.png"}, kBadInput}};
  for (const Refused& row : rows)
    apply.refuses(m.bundle, "wood", row.arguments, row.words, row.code);
  apply.refuses(moss(), "wood", {"--mix", "0.5"}, {"--mix: noise 'moss' is not a mix"});
  apply.refuses(moss(), "wood", {"--mix-texture", m.grey},
                {"--mix-texture: noise 'moss' is not a mix"});
}

TEST_CASE("the direction of a mix needs texture coordinates also with mapping surface") {
  const Apply apply;
  const Arguments surface{"--mapping", "surface"};
  // The pyramid, made of glass, has no texture coordinates; the bundle's own weight follows a
  // direction.
  apply.refuses(made().bundle, "glass", surface + Arguments{"--mix-direction", "0,1,2,1"},
                {"has no TEXCOORD_0, which --mix-direction needs; use --mix or --mix-vertex-color"},
                kBadInput);
  apply.refuses(made().bundle, "glass", surface,
                {"has no TEXCOORD_0, which the bundle's mix direction needs"}, kBadInput);
  CHECK(apply.run(made().bundle, "glass", surface + Arguments{"--mix", "0.5"}).code == 0);
  CHECK(apply.run(made().bundle, "wood", surface).code == 0);
}

TEST_CASE("all materials skips those whose meshes lack what the weight of a mix needs") {
  const Apply apply;
  const Arguments triplanar{"--mapping", "triplanar"};
  for (const Arguments& more : {Arguments{"--mix-direction", "0,0,1,1"}, Arguments{},
                                Arguments{"--mix-texture", made().grey}}) {
    CHECK_THAT(apply.notes(made().bundle, "all", triplanar + more),
               Catch::Contains("skipped material 'glass': primitive 1 of mesh 'table' has no "
                               "TEXCOORD_0, which") &&
                   Catch::Contains("use --mix or --mix-vertex-color there"));
    const json materials = apply.output()["materials"];
    CHECK(materials[0]["extensions"].contains(kExtension));
    CHECK(!materials[1].contains("extensions"));
  }
  apply.refuses(made().bundle, "all", triplanar + Arguments{"--mix-vertex-color", "0"},
                {"has no COLOR_0, which --mix-vertex-color needs; use --mix, --mix-direction or "
                 "--mix-texture"},
                kBadInput);
}
