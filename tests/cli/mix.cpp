// SPDX-License-Identifier: MIT
// `lichen mix`: the noise it makes from photographs, and the other verbs on that noise.
#include "bundle_example.h"
#include "command_run.h"

#include <lichen/bundle.h>
#include <lichen/files.h>
#include <lichen/gltf_scene.h>
#include <lichen/image_io.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <tiny_scene.h>

using namespace lichen;
using namespace lichen::cli_test;
using nlohmann::json;

namespace {

constexpr int kUsage = int(ErrorKind::usage);
constexpr int kBadInput = int(ErrorKind::badInput);
constexpr const char* kExtension = "LICHEN_materials_exemplar_noise";

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

  [[nodiscard]] Ended mix(const std::string& output, const Arguments& more = {}) const {
    Arguments arguments{"mix",       dark, light,     "-o", workplace.path(output),
                        "--support", "8",  "--steps", "5",  "--preview",
                        "none"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runLichen(arguments);
  }
  [[nodiscard]] std::string mixed(const std::string& output, const Arguments& more = {}) const {
    const Ended ended = mix(output, more);
    INFO(ended.errors);
    REQUIRE(ended.code == 0);
    return workplace.path(output);
  }
};

const Made& made() {
  static const Made made;
  return made;
}

void checkMixRefuses(const Arguments& more, int code, const std::vector<std::string>& words) {
  const Made& m = made();
  Arguments arguments{"mix", "-o", m.workplace.path("new.glb"), "--support", "8"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  checkRefusal(arguments, code, words);
  CHECK(!std::filesystem::exists(m.workplace.path("new.glb")));
}

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
  const Ended checked = runLichen({"check", m.bundle, "--json"});
  CHECK(checked.code == 0);
  CHECK(json::parse(checked.output).at("warnings") == 0);
  const json noise =
      json::parse(runLichen({"inspect", m.bundle, "--json"}).output).at("noises").at(0);
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
  const std::string page = runLichen({"inspect", m.bundle}).output;
  for (const char* words : {"; 5 steps", "at the last step mean", "mix along (-1, 0) to (2, 0)"})
    CHECK_THAT(page, Catch::Contains(words));
}

TEST_CASE("mix makes the same bytes on any number of threads") {
  const Made& m = made();
  for (const char* threads : {"1", "3"}) {
    (void)m.mixed("again.glb", {"--threads", threads});
    CHECK(m.workplace.read("again.glb") == m.workplace.read("mix.glb"));
  }
}

TEST_CASE("mix reports its result as text and as JSON") {
  const Made& m = made();
  const Ended ended = m.mix("reported.glb", {"--json", m.dark});
  const json report = json::parse(ended.output);
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
  const Ended ended = runLichen({"mix", input, made().dark, "-o", workplace.path("mix.glb"),
                                 "--support", "8", "--steps", "2", "--preview", "none"});
  INFO(ended.errors);
  REQUIRE(ended.code == 0);
  CHECK_THAT(ended.errors, Catch::Contains("spots.png: histogram (severe): the histogram differs"));
  CHECK_THAT(ended.errors,
             Catch::Contains("what helps: lichen bake --method tiling for this input alone"));
  CHECK_THAT(ended.errors, !Catch::Contains("dark.png: histogram"));
}

TEST_CASE("mix with --weights makes one texton between all inputs") {
  const Made& m = made();
  const std::string bundle = m.workplace.path("between.gltf");
  const Ended ended =
      runLichen({"mix", m.dark, m.light, "-o", bundle, "--support", "8", "--weights", "3,1"});
  INFO(ended.errors);
  REQUIRE(ended.code == 0);
  const json noise =
      json::parse(runLichen({"inspect", bundle, "--json"}).output).at("noises").at(0);
  CHECK(noise.at("texton").at("steps") == 1);
  const json ends =
      json::parse(runLichen({"inspect", m.bundle, "--json"}).output).at("noises")[0].at("maps")[0];
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
  const std::string moss = folder("moss", true), rock = folder("rock", true),
                    sand = folder("sand", false);
  const std::string output = workplace.path("sets.glb");
  const Ended ended =
      runLichen({"mix", moss, rock, "-o", output, "--support", "6", "--steps", "3", "--json"});
  INFO(ended.errors);
  REQUIRE(ended.code == 0);
  CHECK(json::parse(ended.output).at("maps") ==
        std::vector<std::string>{"baseColor", "occlusionRoughnessMetallic"});
  CHECK(json::parse(ended.output).at("name") == "moss-rock");
  CHECK(runLichen({"check", output}).code == 0);
  checkRefusal({"mix", moss, sand, "-o", output}, kBadInput,
               {"sand: has no occlusionRoughnessMetallic, which", "moss has",
                "expected the same maps in all exemplars"});
}

TEST_CASE("mix reports what it cannot mix and leaves no file") {
  const Made& m = made();
  checkMixRefuses({m.dark}, kUsage, {"INPUT: 1 given; expected 2 to 16"});
  checkMixRefuses(Arguments(17, m.dark), kUsage, {"INPUT: 17 given; expected 2 to 16"});
  checkMixRefuses({}, kUsage, {"INPUT"});
  checkMixRefuses({m.dark, m.light, "--steps", "1"}, kUsage,
                  {"--steps 1: expected a whole number from 2 to 64"});
  checkMixRefuses({m.dark, m.light, "--steps", "65"}, kUsage,
                  {"--steps 65: expected a whole number from 2 to 64"});
  checkMixRefuses({m.dark, m.light, m.dark, "--steps", "33"}, kUsage,
                  {"steps from an exemplar to the next: 33", "expected 2 to 32 for 3 exemplars"});
  checkMixRefuses({m.dark, m.light, "--weights", "1,2,3"}, kUsage,
                  {"--weights: 3 for 2 inputs; expected one per input"});
  checkMixRefuses({m.dark, m.light, "--weights", "0,0"}, kUsage,
                  {"--weights: all are 0; expected a sum above 0"});
  checkMixRefuses({m.dark, m.light, "--weights", "1,-2"}, kUsage,
                  {"--weights 1,-2: expected 1 to 16 numbers from 0 to 1000000"});
  checkMixRefuses({m.dark, m.light, "--weights", "1,"}, kUsage, {"--weights 1,:"});
  checkMixRefuses({m.dark, m.light, "--weights", "1,2", "--steps", "5"}, kUsage,
                  {"--steps: given with --weights, which makes one texton"});
  checkMixRefuses({m.dark, m.workplace.path("absent.png")}, kBadInput, {"absent.png"});
  checkMixRefuses({m.dark, m.workplace.write("no.png", std::string("no image"))}, kBadInput,
                  {"no.png"});
  checkRefusal({"mix", m.dark, m.light, "-o", m.workplace.path("new.png")}, kUsage,
               {"new.png", ".glb or .gltf"});
}

TEST_CASE("compare measures a mix at the weight of --mix") {
  const Made& m = made();
  const auto measured = [&](const std::string& exemplar, const Arguments& more) {
    Arguments arguments{"compare", exemplar, m.bundle, "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = runLichen(arguments);
    INFO(ended.errors);
    std::map<std::string, double> values;
    const json report = json::parse(ended.output);
    for (const json& measure : report.at("measures"))
      if (measure.at("value").is_number())
        values[measure.at("name").get<std::string>()] = measure.at("value").get<double>();
    return values;
  };
  // The means of the inputs differ by 0.4 in each channel. The texton of one has blobs, that of the
  // other speckles, so each is closer to its own input.
  for (const auto& [exemplar, own, other] :
       {std::tuple(m.dark, "0", "1"), std::tuple(m.light, "1", "0")}) {
    const auto right = measured(exemplar, {"--mix", own});
    const auto wrong = measured(exemplar, {"--mix", other});
    CHECK(right.at("color_distance") < 0.1);
    CHECK(wrong.at("color_distance") > 0.2);
    CHECK(right.at("model_error") < 0.95 * wrong.at("model_error"));
  }
  CHECK(measured(m.dark, {}) == measured(m.dark, {"--mix", "0"}));
  const std::string plain =
      bake(m.workplace, m.workplace.write("plain.png", smoothGrey(8)), "plain.glb");
  checkRefusal({"compare", m.dark, plain, "--mix", "1"}, kUsage,
               {"--mix: noise 'plain' is not a mix"});
  checkRefusal({"compare", m.dark, m.light, "--mix", "1"}, kUsage, {"--mix 1:", "is an image"});
  checkRefusal({"compare", m.dark, m.bundle, "--mix", "2"}, kUsage, {"--mix 2:"});
}

TEST_CASE("compare cuts a frame off the photograph of a mix, as the mix did") {
  const Workplace workplace;
  const std::string dark =
      workplace.write("dark.png", framed(about(0.3f, speckled(32, 32, 3)), 2, 2, 2));
  const std::string light = workplace.write("light.png", about(0.7f, speckled(28, 30, 3)));
  const std::string bundle = workplace.path("mix.glb");
  REQUIRE(
      runLichen({"mix", dark, light, "-o", bundle, "--support", "8", "--preview", "none"}).code ==
      0);
  const Ended ended = runLichen({"compare", dark, bundle});
  CHECK_THAT(ended.errors, Catch::Contains("a frame is cut off"));
}

TEST_CASE("synth shows a mix at one weight or along a ramp") {
  const Made& m = made();
  const auto synth = [&](const Arguments& more) {
    Arguments arguments{"synth", m.bundle, "-o", m.workplace.path("s.png"), "--size", "256x64"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = runLichen(arguments);
    INFO(ended.errors);
    REQUIRE(ended.code == 0);
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
  const Arguments base{"synth", m.bundle, "-o", m.workplace.path("new.png")};
  const auto refuses = [&](Arguments more, const std::vector<std::string>& words) {
    more.insert(more.begin(), base.begin(), base.end());
    checkRefusal(more, kUsage, words);
  };
  refuses({"--mix", "1.5"}, {"--mix 1.5: expected a weight from 0 to 1"});
  refuses({"--mix", "0,1,0"}, {"--mix 0,1,0: expected a weight from 0 to 1, or two"});
  refuses({"--mix", "0,1", "--tileable"}, {"mix 0,1 of a tileable image; expected one weight"});
  const Workplace other;
  const std::string plain = bake(other, other.write("stone.png", smooth(16)), "stone.glb");
  checkRefusal({"synth", plain, "-o", other.path("new.png"), "--mix", "0.5"}, kUsage,
               {"--mix: noise 'stone' is not a mix"});
  checkRefusal({"mix", plain, plain, "-o", other.path("new.glb")}, kUsage,
               {"stone.glb: is a bundle; expected photographs or folders",
                "'lichen layer' combines bundles of the methods tiling, texton"});
}

TEST_CASE("apply sets the weight of a mix from every source") {
  const Made& m = made();
  const Workplace workplace;
  example::TinyScene scene = example::tableScene();
  const std::size_t colors =
      scene.addFloats(std::vector<float>(std::size_t(4 * 4), 0.5f), "VEC4", 4);
  scene.json["meshes"][0]["primitives"][0]["attributes"]["COLOR_1"] = colors;
  const std::string file = workplace.write("scene.glb", scene.glb());
  const auto arguments = [&](const Arguments& more) {
    Arguments all{"apply",      file,   "--noise", m.bundle,
                  "--material", "wood", "-o",      workplace.path("out.glb")};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const auto mixOf = [&](const Arguments& more) {
    const Ended ended = runLichen(arguments(more));
    INFO(ended.errors);
    REQUIRE(ended.code == 0);
    const Ended checked = runLichen({"check", workplace.path("out.glb")});
    INFO(checked.output);
    CHECK(checked.code == 0);
    const json document = GltfScene::open(workplace.path("out.glb")).value().document();
    return document["materials"][0]["extensions"][kExtension].value("mix", json());
  };
  CHECK(mixOf({}).at("source") == "direction"); // the bundle's own direction
  CHECK(mixOf({"--mix", "0.25"}) == json{{"source", "constant"}, {"weight", 0.25}});
  CHECK(mixOf({"--mix-direction", "0,1,2,1"}) ==
        json{{"source", "direction"}, {"start", {0.0, 1.0}}, {"end", {2.0, 1.0}}});
  CHECK(mixOf({"--mix-vertex-color", "1", "--mix-channel", "alpha"}) ==
        json{{"source", "vertexColor"}, {"set", 1}, {"channel", 3}});
  const json mask = mixOf({"--mix-texture", m.grey, "--mix-channel", "green"});
  CHECK(mask == json{{"source", "texture"}, {"texture", {{"index", 0}}}, {"channel", 1}});
  const json document = GltfScene::open(workplace.path("out.glb")).value().document();
  REQUIRE(document["textures"].size() == 1);
  const json& image = document["images"][document["textures"][0]["source"].get<std::size_t>()];
  CHECK(image.at("mimeType") == "image/png");
  // If the texture repeated, the last column would get half the weight of the first.
  constexpr int kClampToEdge = 33071;
  CHECK(document["samplers"][document["textures"][0]["sampler"].get<std::size_t>()] ==
        json{{"wrapS", kClampToEdge}, {"wrapT", kClampToEdge}});
  // A mask belongs to its scene: texture indices of another bundle mean other textures.
  const Ended merged = runLichen({"merge", workplace.path("out.glb"), "-o",
                                  workplace.path("merged.glb"), "--preview", "none"});
  CHECK(merged.code == 0);
  CHECK_THAT(merged.errors, Catch::Contains("the mask of its mix is not copied"));
  CHECK(json::parse(runLichen({"inspect", workplace.path("merged.glb"), "--json"}).output)
            .at("noises")[0]
            .at("materials")[0]
            .at("mix")
            .at("source") == "constant");
  const auto refuses = [&](const Arguments& more, int code, const std::vector<std::string>& words) {
    checkRefusal(arguments(more), code, words);
  };
  refuses({"--mix", "2"}, kUsage, {"--mix 2: expected a number from 0 to 1"});
  refuses({"--mix", "0.5", "--mix-vertex-color", "1"}, kUsage,
          {"--mix, --mix-vertex-color: 2 sources of the weight"});
  refuses({"--mix-channel", "red"}, kUsage, {"--mix-channel: no texture and no vertex colours"});
  refuses({"--mix-direction", "0,0,0,0"}, kUsage, {"two places 0.000001 or more apart"});
  refuses({"--mix-direction", "0,0,0,1e-200"}, kUsage, {"two places 0.000001 or more apart"});
  refuses({"--mix-direction", "0,0,1"}, kUsage, {"--mix-direction 0,0,1:"});
  refuses({"--mix-vertex-color", "2"}, kBadInput, {"has no COLOR_2, which --mix-vertex-color"});
  refuses({"--mix-texture", m.grey, "--mix-channel", "alpha"}, kBadInput,
          {"has no alpha, which --mix-channel asks for"});
  refuses({"--mix-texture", "3"}, kUsage, {"--mix-texture 3:", "has 0 textures"});
  refuses({"--mix-texture", workplace.path("absent.png")}, kBadInput, {"absent.png"});
  for (const char* text : {"no image", "", "\x76\x2f\x31\x01 an EXR"})
    refuses({"--mix-texture", workplace.write("no.png", std::string(text))}, kBadInput,
            {"no.png: not a PNG or JPEG", "index of a texture"});
  refuses({"--mix-texture", workplace.write("no.png", std::string("\x89PNG, but"))}, kBadInput,
          {"no.png"});
  const std::string plain = bake(workplace, workplace.write("stone.png", smooth(16)), "stone.glb");
  checkRefusal({"apply", file, "--noise", plain, "--material", "wood", "-o",
                workplace.path("new.glb"), "--mix", "0.5"},
               kUsage, {"--mix: noise 'stone' is not a mix"});
  checkRefusal({"apply", file, "--noise", plain, "--material", "wood", "-o",
                workplace.path("new.glb"), "--mix-texture", m.grey},
               kUsage, {"--mix-texture: noise 'stone' is not a mix"});
}

TEST_CASE("a note names a mesh that exceeds the mask of a mix, with its range") {
  const Workplace workplace;
  const std::string mask = workplace.write("mask.png", smoothGrey(16));
  const auto errorsOf = [&](const example::TinyScene& scene, const std::string& texture) {
    const std::string file = workplace.write("scene.glb", scene.glb());
    const Ended ended = runLichen({"apply", file, "--noise", made().bundle, "--material", "wood",
                                   "--mix-texture", texture, "-o", workplace.path("out.glb")});
    INFO(ended.errors);
    CHECK(ended.code == 0);
    return ended.errors;
  };
  example::TinyScene scene = example::tableScene();
  auto& attributes = scene.json["meshes"][0]["primitives"][0]["attributes"];
  const auto cover = [&](float least, float most) {
    attributes["TEXCOORD_0"] =
        scene.addFloats({least, 0.0f, most, 0.0f, most, 1.0f, least, 1.0f}, "VEC2", 2);
  };
  cover(0.0f, 1.0f);
  CHECK_THAT(errorsOf(scene, mask), !Catch::Contains("TEXCOORD_0"));
  cover(-20.0f, 20.5f);
  CHECK_THAT(errorsOf(scene, mask),
             Catch::Contains("scene.glb: primitive 0 of mesh 'table': TEXCOORD_0 from (-20, 0) to "
                             "(20.5, 1) exceeds 0 to 1, the range of the mask; outside, its "
                             "border continues"));
  // A texture of the scene uses its own sampler; without one it repeats.
  const std::size_t view = scene.addView(example::tinyPng());
  scene.json["images"] = {{{"mimeType", "image/png"}, {"bufferView", view}}};
  scene.json["textures"] = {{{"source", 0}}, {{"source", 0}, {"sampler", 0}}};
  scene.json["samplers"] = {{{"wrapS", 33071}}};
  CHECK_THAT(errorsOf(scene, "0"),
             Catch::Contains("exceeds 0 to 1") && Catch::Contains("outside, it repeats"));
  CHECK_THAT(errorsOf(scene, "1"), Catch::Contains("outside, its border continues"));
}

TEST_CASE("the direction of a mix needs texture coordinates also with mapping surface") {
  const Workplace workplace;
  const std::string file = workplace.write("scene.glb", example::tableScene().glb());
  const auto onSurface = [&](const Arguments& more, const char* out) {
    Arguments all{"apply",     file,      "--noise", made().bundle,
                  "--mapping", "surface", "-o",      workplace.path(out)};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  // The pyramid, made of glass, has no texture coordinates; the bundle's own weight follows a
  // direction.
  checkRefusal(onSurface({"--material", "glass", "--mix-direction", "0,1,2,1"}, "new.glb"),
               kBadInput,
               {"has no TEXCOORD_0, which --mix-direction needs; use --mix or --mix-vertex-color"});
  checkRefusal(onSurface({"--material", "glass"}, "new.glb"), kBadInput,
               {"has no TEXCOORD_0, which the bundle's mix direction needs"});
  CHECK(runLichen(onSurface({"--material", "glass", "--mix", "0.5"}, "out.glb")).code == 0);
  CHECK(runLichen(onSurface({"--material", "wood"}, "out.glb")).code == 0);
}

TEST_CASE("all materials skips those whose meshes lack what the weight of a mix needs") {
  const Workplace workplace;
  const std::string file = workplace.write("scene.glb", example::tableScene().glb());
  const auto onAll = [&](const Arguments& more, const char* out) {
    Arguments all{"apply",     file, "--noise",           made().bundle, "--mapping",
                  "triplanar", "-o", workplace.path(out), "--material",  "all"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  for (const Arguments& more : {Arguments{"--mix-direction", "0,0,1,1"}, Arguments{},
                                Arguments{"--mix-texture", made().grey}}) {
    const Ended ended = runLichen(onAll(more, "out.glb"));
    INFO(ended.errors);
    REQUIRE(ended.code == 0);
    CHECK_THAT(ended.errors, Catch::Contains("skipped material 'glass': primitive 1 of mesh "
                                             "'table' has no TEXCOORD_0, which") &&
                                 Catch::Contains("use --mix or --mix-vertex-color there"));
    const json materials =
        GltfScene::open(workplace.path("out.glb")).value().document()["materials"];
    CHECK(materials[0]["extensions"].contains(kExtension));
    CHECK(!materials[1].contains("extensions"));
  }
  checkRefusal(onAll({"--mix-vertex-color", "0"}, "new.glb"), kBadInput,
               {"has no COLOR_0, which --mix-vertex-color needs; use --mix, --mix-direction or "
                "--mix-texture"});
}

TEST_CASE("a note names a mesh on which the direction of a mix is short or ends outside") {
  const Workplace workplace;
  example::TinyScene scene = example::tableScene();
  scene.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] =
      scene.addFloats({0.0f, 0.0f, 20.0f, 0.0f, 20.0f, 1.0f, 0.0f, 1.0f}, "VEC2", 2);
  const std::string file = workplace.write("scene.glb", scene.glb());
  const auto errorsOf = [&](const char* direction) {
    const Ended ended = runLichen({"apply", file, "--noise", made().bundle, "--material", "wood",
                                   "--mix-direction", direction, "-o", workplace.path("out.glb")});
    INFO(ended.errors);
    CHECK(ended.code == 0);
    return ended.errors;
  };
  CHECK_THAT(errorsOf("0,0,1,0"),
             Catch::Contains("scene.glb: primitive 0 of mesh 'table': --mix-direction spans 5 % of "
                             "TEXCOORD_0 from (0, 0) to (20, 1); elsewhere the weight is 0 or 1"));
  CHECK_THAT(errorsOf("21,0,22,0"),
             Catch::Contains("TEXCOORD_0 from (0, 0) to (20, 1) lies outside --mix-direction, so "
                             "the weight is 0 everywhere"));
  CHECK_THAT(errorsOf("-1,0,-2,0"), Catch::Contains("so the weight is 0 everywhere"));
  CHECK_THAT(errorsOf("-2,0,-1,0"), Catch::Contains("so the weight is 1 everywhere"));
  for (const char* direction : {"20,0,0,0", "0,0,2,0", "0,0,0,1", "5,0,15,0"})
    CHECK_THAT(errorsOf(direction), !Catch::Contains("mix-direction"));
}
