// SPDX-License-Identifier: MIT
// Every wrong argument and every bad file gives one line with the remedy, and the exit code that
// DESIGN.md specifies.
#include "command_run.h"
#include "image_samples.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

constexpr int kUsage = int(ErrorKind::usage);
constexpr int kBadInput = int(ErrorKind::badInput);
constexpr int kEnvironment = int(ErrorKind::environment);

/// A small image and its bundle, made once for all tests of this file.
struct Made {
  Workplace workplace;
  std::string image = workplace.write("stone.png", smooth(16));
  std::string bundle = bake(workplace, image, "stone.glb");
};

const Made& made() {
  static const Made made;
  return made;
}

void checkBakeRefuses(const Arguments& more, int code, const std::vector<std::string>& words) {
  Arguments arguments{"bake", made().image, "-o", made().workplace.path("new.glb")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  checkRefusal(arguments, code, words);
  CHECK(!std::filesystem::exists(made().workplace.path("new.glb")));
}

void checkSynthRefuses(const Arguments& more, int code, const std::vector<std::string>& words) {
  Arguments arguments{"synth", made().bundle, "-o", made().workplace.path("new.png")};
  arguments.insert(arguments.end(), more.begin(), more.end());
  checkRefusal(arguments, code, words);
  CHECK(!std::filesystem::exists(made().workplace.path("new.png")));
}

} // namespace

TEST_CASE("the error for a missing or unknown verb lists the verbs") {
  checkRefusal(
      {}, kUsage,
      {"a verb is missing; expected bake, mix, synth, inspect, check, compare, merge, layer, "
       "cook or apply",
       "'lichen --help'"});
  checkRefusal({"chek"}, kUsage,
               {"lichen: chek: no such verb; expected bake, mix, synth, inspect, check, compare, "
                "merge, layer, "
                "cook or apply; see 'lichen --help'"});
  checkRefusal({"--frobnicate"}, kUsage, {"--frobnicate: no such option; see 'lichen --help'"});
}

TEST_CASE("lichen help prints what --help prints") {
  CHECK(runLichen({"help"}).output == runLichen({"--help"}).output);
  const Ended ofBake = runLichen({"help", "bake"});
  CHECK(ofBake.code == 0);
  CHECK(ofBake.output == runLichen({"bake", "--help"}).output);
  CHECK_THAT(ofBake.output, Catch::Contains("Usage: lichen bake"));
  checkRefusal({"help", "frobnicate"}, kUsage, {"frobnicate: no such verb; expected bake, mix"});
}

TEST_CASE("missing and surplus arguments of a verb are errors") {
  const Made& m = made();
  checkRefusal({"bake"}, kUsage, {"INPUT is required; see 'lichen bake --help'"});
  checkRefusal({"bake", m.image}, kUsage, {"--output is required"});
  checkRefusal({"synth", m.bundle}, kUsage, {"--output is required"});
  checkRefusal({"check"}, kUsage, {"BUNDLE is required"});
  checkRefusal({"check", m.bundle, "second.glb"}, kUsage, {"second.glb: one argument too many"});
  checkRefusal({"bake", m.image, "-o"}, kUsage, {"--output: a value is missing"});
  checkRefusal({"check", m.bundle, "--json=3"}, kUsage, {"--json: takes no value"});
}

TEST_CASE("unknown options and numbers out of range are errors of every verb") {
  const Made& m = made();
  for (const Arguments& verb : {Arguments{"bake", m.image, "-o", m.workplace.path("new.glb")},
                                Arguments{"synth", m.bundle, "-o", m.workplace.path("new.png")},
                                Arguments{"check", m.bundle}}) {
    const auto with = [&](const Arguments& more) {
      Arguments all = verb;
      all.insert(all.end(), more.begin(), more.end());
      return all;
    };
    checkRefusal(with({"--frobnicate", "8"}), kUsage, {"--frobnicate: no such option"});
    for (const std::string threads : {"-1", "100000", "two", "1.5"})
      checkRefusal(with({"--threads", threads}), kUsage,
                   {"--threads " + threads + ": expected a whole number from 0 to 1024"});
  }
}

TEST_CASE("the error for an unknown option value of bake lists the valid ones") {
  checkBakeRefuses({"--precision", "9"}, kUsage, {"--precision 9: expected 8 or 16"});
  checkBakeRefuses({"--method", "magic"}, kUsage,
                   {"--method magic: expected tiling, texton, local-random-phase, "
                    "multiple-kernels or quilting"});
  checkBakeRefuses({"--periodic", "maybe"}, kUsage,
                   {"--periodic maybe: expected auto, yes or no; see 'lichen bake --help'"});
  checkBakeRefuses({"--transport", "slow"}, kUsage, {"--transport slow: expected fast or default"});
  checkBakeRefuses({"--preview", "teapot"}, kUsage,
                   {"--preview teapot: expected sphere, plane or none"});
  for (const std::string seed : {"-1", "4294967296", "one", "1.5"})
    checkBakeRefuses({"--seed", seed}, kUsage,
                     {"--seed " + seed + ": expected a whole number from 0 to 4294967295"});
  checkBakeRefuses({"--name", "caf\xe9"}, kUsage, {"--name caf", "expected UTF-8 text"});
  for (const std::string metres : {"0", "-1", "nan", "inf", "wide", "50cm"})
    checkBakeRefuses(
        {"--tile", metres}, kUsage,
        {"--tile " + metres + ": expected a number of metres from 0.000001 to 1000000"});
}

TEST_CASE("the error for a structure or spectrum that no noise can have says what is expected") {
  const auto refuse = [](const std::string& option, const std::string& value,
                         const std::string& expected) {
    checkBakeRefuses({"--method", "local-random-phase", option, value}, kUsage,
                     {option + " " + value + ": expected " + expected});
  };
  for (const std::string share : {"-0.1", "1.5", "some", "nan"}) {
    refuse("--structure", share, "auto or a number from 0 to 1");
    refuse("--guide", share, "auto or a number from 0 to 1");
  }
  for (const std::string tiles : {"-0.1", "1.5", "auto"})
    refuse("--turbulence", tiles, "a number of tiles from 0 to 1");
  for (const std::string parts : {"ring:8", "ring:12:8", "ring:-2:8", "ring:8:nan", "ring:8:12,",
                                  "ring:8:12,band:1", "band:2:1:0:5", "band:0:9999:0:1"})
    refuse("--spectrum", parts, "a picture, or parts such as ring:8:12");
  const std::string white =
      made().workplace.write("white.png", encodePng(SrgbImage(1, 1, 1), 8).value());
  checkBakeRefuses({"--quiet", "--method", "local-random-phase", "--spectrum", white}, kBadInput,
                   {"white.png: black everywhere but in the middle"});
  checkBakeRefuses({"--quiet", "--method", "local-random-phase", "--spectrum", "no such.png"},
                   kBadInput, {"no such.png"});
  checkBakeRefuses({"--quiet", "--method", "local-random-phase", "--spectrum", "ring:8:12",
                    "--structure", "0.5"},
                   kUsage, {"--structure 0.5 with --spectrum"});
  checkBakeRefuses({"--structure", "0.5"}, kUsage, {"--structure", "local-random-phase"});
}

TEST_CASE("the error for a size that synth cannot make states the range") {
  for (const std::string size :
       {"0x0", "abc", "99999x1", "1x99999", "12x", "x12", "1x2x3", "", "12.5x4", "99999999999x1"})
    checkSynthRefuses({"--size", size}, kUsage,
                      {"--size " + size + ": expected a size from 1x1 to 16384x16384"});
}

TEST_CASE("the error for an unknown option value of synth lists the valid ones") {
  checkSynthRefuses({"--noise", "granite"}, kUsage,
                    {"--noise granite: ", " has no such noise; expected stone"});
  for (const std::string map : {"depth", "normal"})
    checkSynthRefuses({"--map", map}, kUsage,
                      {"--map " + map + ": noise 'stone' has no such map; expected baseColor"});
  for (const std::string origin : {"5", "a,b", "1,2,3", "nan,0", "inf,0", "1e30,0"})
    checkSynthRefuses({"--origin", origin}, kUsage,
                      {"--origin " + origin + ": expected X,Y with numbers"});
  for (const std::string texels : {"0", "-4", "nan", "inf", "1e30", "many"})
    checkSynthRefuses(
        {"--texels-per-tile", texels}, kUsage,
        {"--texels-per-tile " + texels + ": expected a number from 0.0009765625 to 16777216"});
  for (const std::string sharpness : {"0", "17", "nan"})
    checkSynthRefuses({"--sharpness", sharpness}, kUsage,
                      {"--sharpness " + sharpness + ": expected a number from 0.25 to 16"});
  for (const std::string angles : {"1", "3", "90", "free"})
    checkSynthRefuses({"--tile-rotation", angles}, kUsage,
                      {"--tile-rotation " + angles + ": expected none, 2 or 4"});
  for (const std::string contrast : {"-1", "5", "nan"})
    checkSynthRefuses({"--contrast", contrast}, kUsage,
                      {"--contrast " + contrast + ": expected a number from 0 to 4"});
  for (const std::string seed : {"-1", "4294967296"})
    checkSynthRefuses({"--seed", seed}, kUsage, {"--seed " + seed + ": expected a whole number"});
}

TEST_CASE("the last value counts if an option is given twice") {
  const Made& m = made();
  const std::string picture = m.workplace.path("twice.png");
  const Ended ended = runLichen({"synth", m.bundle, "-o", m.workplace.path("absent/a.png"), "-o",
                                 picture, "--size", "1x1", "--size", "5x4", "--json"});
  CHECK(ended.code == 0);
  CHECK(std::filesystem::exists(picture));
  CHECK_THAT(ended.output, Catch::Contains("\"width\": 5"));
}

TEST_CASE("the help does not show the parser's own type names") {
  for (const Arguments& verb :
       {Arguments{}, {"bake"}, {"synth"}, {"inspect"}, {"check"}, {"compare"}, {"merge"}}) {
    Arguments arguments = verb;
    arguments.push_back("--help");
    const Ended ended = runLichen(arguments);
    CHECK(ended.code == 0);
    for (const char* word :
         {"ENUM", "TEXT:", "UINT", "FLOAT", "INT:", "->", "{", "SUBCOMMAND", " |"})
      CHECK_THAT(ended.output, !Catch::Contains(word));
  }
}

TEST_CASE("an invalid output is an error before the work starts") {
  const Made& m = made();
  const std::string absent = m.workplace.path("absent");
  const std::string missing = absent + ": the folder does not exist; create it first";
  checkRefusal({"bake", m.image, "-o", absent + "/new.glb"}, kEnvironment, {missing});
  checkRefusal({"synth", m.bundle, "-o", absent + "/new.png"}, kEnvironment, {missing});
  checkRefusal({"bake", m.image, "-o", m.image + "/new.glb"}, kEnvironment,
               {m.image + ": is a file; expected a folder"});
  const std::string folder = std::filesystem::path(m.image).parent_path().string();
  checkRefusal({"bake", m.image, "-o", folder}, kUsage,
               {folder + ": is a folder; expected a file"});
  for (const char* name : {"new.png", "new", "new.glb.tmp"})
    checkRefusal({"bake", m.image, "-o", m.workplace.path(name)}, kUsage, {name, ".glb", ".gltf"});
  for (const char* name : {"new.jpg", "new", "new.glb"})
    checkRefusal({"synth", m.bundle, "-o", m.workplace.path(name)}, kUsage, {name, ".png", ".exr"});
}

TEST_CASE("a missing file, a folder, an empty file and a file that is not an image are bad input") {
  const Made& m = made();
  const auto refuses = [&](const std::string& input, const std::vector<std::string>& words) {
    checkRefusal({"bake", input, "-o", m.workplace.path("new.glb")}, kBadInput, words);
    CHECK(!std::filesystem::exists(m.workplace.path("new.glb")));
  };
  refuses(m.workplace.path("absent.png"), {"absent.png", "No such file"});
  refuses(m.workplace.path("."), {"a folder without a map: stone.png (no map)", "nor_gl"});
  refuses(m.workplace.write("empty.png", std::string()), {"empty.png", "empty file", "PNG"});
  refuses(m.workplace.write("text.png", std::string("not an image")), {"text.png", "PNG"});
  refuses(m.bundle, {"stone.glb", "PNG"});
}

TEST_CASE("a truncated image of every format is bad input") {
  const Made& m = made();
  const std::vector<std::pair<std::string, samples::Bytes>> files = {
      {"half.png", samples::makePng({})},
      {"half.jpg", samples::makeJpeg({})},
      {"half.exr", samples::makeExr({})}};
  for (const auto& [name, whole] : files) {
    const samples::Bytes half(whole.begin(), whole.begin() + std::ptrdiff_t(whole.size() / 2));
    checkRefusal({"bake", m.workplace.write(name, half), "-o", m.workplace.path("new.glb")},
                 kBadInput, {name});
  }
}

TEST_CASE("an image with values that are not numbers is bad input") {
  const Made& m = made();
  samples::Exr exr;
  exr.hasOddValue = true;
  exr.oddValue = std::numeric_limits<float>::quiet_NaN();
  checkRefusal({"bake", m.workplace.write("nan.exr", samples::makeExr(exr)), "-o",
                m.workplace.path("new.glb")},
               kBadInput, {"nan.exr"});
}

TEST_CASE("a file that is not a bundle is an error of synth and check") {
  const Made& m = made();
  const std::string plain =
      m.workplace.write("plain.gltf", std::string(R"({"asset": {"version": "2.0"}})"));
  const std::string half = m.workplace.read("stone.glb");
  const std::string truncated = m.workplace.write("half.glb", half.substr(0, half.size() / 2));
  const std::string output = m.workplace.path("new.png");
  for (const std::string& bundle : {m.workplace.path("absent.glb"), m.image, plain, truncated})
    checkRefusal({"synth", bundle, "-o", output}, kBadInput,
                 {std::filesystem::path(bundle).filename().string()});
  checkRefusal({"check", m.workplace.path("absent.glb")}, kBadInput, {"absent.glb"});
  checkRefusal({"check", m.image}, kBadInput,
               {m.image + ": is a PNG image; expected a .glb or .gltf"});
}

TEST_CASE("check exits with 3 for a truncated file and for a file that is not glTF 2") {
  const Made& m = made();
  const std::string whole = m.workplace.read("stone.glb");
  const std::string text = R"({"asset": {"version": "2.0"}})";
  for (const std::size_t length : {std::size_t(0), std::size_t(3), std::size_t(10), std::size_t(21),
                                   whole.size() / 2, whole.size() - 1})
    checkRefusal({"check", m.workplace.write("half.glb", whole.substr(0, length))}, kBadInput,
                 {"half.glb"});
  for (const std::size_t length : {std::size_t(0), std::size_t(1), text.size() - 1})
    checkRefusal({"check", m.workplace.write("half.gltf", text.substr(0, length))}, kBadInput,
                 {"half.gltf"});
  checkRefusal({"check", m.workplace.write("plain.gltf", std::string("{\"asset\": 1}"))}, kBadInput,
               {"plain.gltf", "/asset/version"});
}

TEST_CASE("check exits with 1 if a glTF has faults") {
  const Made& m = made();
  const std::string extension = "LICHEN_materials_exemplar_noise";
  const std::string faulty =
      m.workplace.write("faulty.gltf", R"({"asset": {"version": "2.0"}, "extensions": {")" +
                                           extension + R"(": {"noises": 1}}})");
  for (const Arguments& more : {Arguments{}, {"--quiet"}, {"--json"}}) {
    Arguments arguments{"check", faulty};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Ended ended = runLichen(arguments);
    CHECK(ended.code == 1);
    CHECK_THAT(ended.output, Catch::Contains("error"));
  }
}

TEST_CASE("check names the faults of a broken bundle and exits with 1") {
  const Made& m = made();
  std::string broken = m.workplace.read("stone.glb");
  const std::size_t at = broken.find("\"inverseTable\":");
  REQUIRE(at != std::string::npos);
  broken[at + std::string("\"inverseTable\":").size()] = '9';
  const std::string path = m.workplace.write("broken.glb", broken);
  const Ended ended = runLichen({"check", path});
  CHECK(ended.code == 1);
  CHECK_THAT(ended.output, Catch::Contains("error: ") && Catch::Contains("inverseTable"));
  CHECK_THAT(ended.output, Catch::EndsWith(": 1 error, 0 warnings\n"));
  CHECK(ended.errors.empty());
  const Ended quiet = runLichen({"check", path, "--quiet"});
  CHECK_THAT(quiet.output, Catch::StartsWith("error: ") && !Catch::Contains("warning"));
}

TEST_CASE("a noise of a later revision is a warning of check and an error of synth") {
  const Made& m = made();
  std::string later = m.workplace.read("stone.glb");
  const std::string revision = "\"revision\":";
  const std::size_t at = later.find(revision + "1");
  REQUIRE(at != std::string::npos);
  later[at + revision.size()] = '2';
  const std::string path = m.workplace.write("later.glb", later);
  checkRefusal({"synth", path, "-o", m.workplace.path("new.png")}, kBadInput,
               {"later.glb", "'stone' has revision 2 of tiling; this version knows 1"});
  const Ended ended = runLichen({"check", path});
  CHECK(ended.code == 0);
  CHECK_THAT(ended.output,
             Catch::StartsWith("warning: revision 2 of tiling; this version knows 1"));
  CHECK_THAT(ended.output, Catch::EndsWith(": 0 errors, 1 warning\n"));
}

TEST_CASE(
    "synth uses the first noise, and prefers a known noise to an ignored one of the same name") {
  const Workplace workplace;
  const std::string grey = workplace.write("grey.png", smoothGrey(16));
  const std::string known = bake(workplace, grey, "stone.gltf", {"--name", "stone"});
  auto file = nlohmann::json::parse(workplace.read("stone.gltf"));
  nlohmann::json& noises = file["extensions"]["LICHEN_materials_exemplar_noise"]["noises"];
  const auto writeWith = [&](const std::string& name, bool first) {
    nlohmann::json changed = file;
    nlohmann::json later = noises[0];
    later["name"] = name;
    later["revision"] = 2;
    nlohmann::json& list = changed["extensions"]["LICHEN_materials_exemplar_noise"]["noises"];
    list.insert(first ? list.begin() : list.end(), later);
    return workplace.write("later.gltf", changed.dump());
  };
  const auto refuse = [&](const std::string& path, Arguments more, const std::string& words) {
    more.insert(more.begin(), {"synth", path, "-o", workplace.path("new.png")});
    checkRefusal(more, kBadInput, {words});
  };
  const Arguments small{"--size", "32"};
  const Arguments named{"--size", "32", "--noise", "stone"};
  const SrgbImage expected = synth(workplace, known, small);

  const std::string first = writeWith("moss", true);
  const std::string refusal =
      "noise 'moss' has revision 2 of tiling; this version knows 1; use the version of lichen that "
      "wrote it, or choose --noise stone";
  refuse(first, {}, refusal);
  refuse(first, {"--noise", "moss"}, refusal);
  CHECK((synth(workplace, first, named).values == expected.values));

  const std::string second = writeWith("moss", false);
  CHECK((synth(workplace, second, small).values == expected.values));
  refuse(second, {"--noise", "moss"}, refusal);

  const std::string alike = writeWith("stone", true);
  CHECK((synth(workplace, alike, named).values == expected.values));
}

TEST_CASE("check prints warnings, except with --quiet, and exits with 0") {
  const Made& m = made();
  const std::string plain =
      m.workplace.write("plain.gltf", std::string(R"({"asset": {"version": "2.0"}})"));
  const Ended ended = runLichen({"check", plain});
  CHECK(ended.code == 0);
  CHECK_THAT(ended.output, Catch::StartsWith("warning: the file has no noise: "));
  CHECK_THAT(ended.output, Catch::EndsWith(": 0 errors, 1 warning\n"));
  const Ended quiet = runLichen({"check", plain, "--quiet"});
  CHECK(quiet.code == 0);
  CHECK(quiet.output.empty());
  checkRefusal({"inspect", plain}, kBadInput, {"plain.gltf: has no noise"});
}
