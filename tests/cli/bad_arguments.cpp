// SPDX-License-Identifier: MIT
// Every wrong argument and every bad file gives one line with the remedy, and the exit code of
// docs/cli.md.
#include "command_run.h"
#include "image_samples.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <limits>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

const std::string kNoiseExtension = "LICHEN_materials_exemplar_noise";

/// A small image and its bundle, made once for all tests of this file.
struct Made {
  Workplace workplace;
  std::string image = workplace.write("stone.png", smooth(16));
  std::string bundle = bake(workplace, image, "stone.glb");
  Arguments bakeOf = {"bake", image, "-o", workplace.path("new.glb")};
  Arguments synthOf = {"synth", bundle, "-o", workplace.path("new.png")};
};

const Made& made() {
  static const Made made;
  return made;
}

void checkNothingWritten() {
  for (const char* name : {"new.glb", "new.png"})
    CHECK(!std::filesystem::exists(made().workplace.path(name)));
}

} // namespace

TEST_CASE("missing, surplus and unknown verbs, options and arguments are errors") {
  const Made& m = made();
  const std::string verbs =
      "expected bake, mix, synth, inspect, check, compare, merge, layer or apply";
  checkRefusals({},
                std::vector<Refused>{
                    {{}, {"a verb is missing; " + verbs, "'lichen --help'"}},
                    {{"chek"}, {"lichen: chek: no such verb; " + verbs + "; see 'lichen --help'"}},
                    {{"--frobnicate"}, {"--frobnicate: no such option; see 'lichen --help'"}},
                    {{"help", "frobnicate"}, {"frobnicate: no such verb; expected bake, mix"}},
                    {{"bake"}, {"INPUT is required; see 'lichen bake --help'"}},
                    {{"bake", m.image}, {"--output is required"}},
                    {{"synth", m.bundle}, {"--output is required"}},
                    {{"check"}, {"BUNDLE is required"}},
                    {{"check", m.bundle, "second.glb"}, {"second.glb: one argument too many"}},
                    {{"bake", m.image, "-o"}, {"--output: a value is missing"}},
                    {{"check", m.bundle, "--json=3"}, {"--json: takes no value"}}});
  for (const Arguments& verb : {m.bakeOf, m.synthOf, Arguments{"check", m.bundle}}) {
    checkRefusal(verb + Arguments{"--frobnicate", "8"}, kUsage, {"--frobnicate: no such option"});
    checkRefusals(
        verb, std::vector<RefusedValues>{
                  {"--threads", {"-1", "100000", "two", "1.5"}, "a whole number from 0 to 1024"}});
  }
}

TEST_CASE("lichen help prints what --help prints") {
  CHECK(succeed({"help"}).output == succeed({"--help"}).output);
  const Ended ofBake = succeed({"help", "bake"});
  CHECK(ofBake.output == succeed({"bake", "--help"}).output);
  CHECK_THAT(ofBake.output, Catch::Contains("Usage: lichen bake"));
}

TEST_CASE("the error for an unknown option value of bake lists the valid ones") {
  checkRefusals(
      made().bakeOf,
      std::vector<RefusedValues>{
          {"--precision", {"9"}, "8 or 16"},
          {"--method",
           {"magic"},
           "tiling, texton, local-random-phase, multiple-kernels or quilting"},
          {"--periodic", {"maybe"}, "auto, yes or no; see 'lichen bake --help'"},
          {"--preview", {"teapot"}, "sphere, plane or none"},
          {"--normal", {"up"}, "gl or dx"},
          {"--alpha", {"yes"}, "ignore or opacity"},
          {"--seed", {"-1", "4294967296", "one", "1.5"}, "a whole number from 0 to 4294967295"},
          {"--tile",
           {"0", "-1", "nan", "inf", "wide", "50cm"},
           "a number of metres from 0.000001 to 1000000"},
          {"--flatten",
           {"3", "16385", "some", "-8", "nan"},
           "none, auto or a number from 4 to 16384"},
          {"--crop",
           {"0,0,0,4", "-1,0,4,4", "0,0,4", "0,0,4,4,4", "a,0,4,4", "0;0;4;4"},
           "X,Y,W,H with whole numbers"},
          {"--size", {"0", "16385", "4x", "x4", "4x0"}, "a size from 1x1 to 16384x16384"}});
  checkRefusals(
      made().bakeOf,
      std::vector<Refused>{
          {{"--name", "caf\xe9"}, {"--name caf", "expected UTF-8 text"}},
          {{"--crop", "8,0,9,4"},
           {"crop 8,0,9,4", "does not fit into the 16 x 16 pixels", "ends at column 17"}},
          {{"--crop", "0,16,1,1"}, {"crop 0,16,1,1"}},
          {{"--order", "3"}, {"--order: belongs to --method texton, which was not given"}},
          {{"--impacts", "20"},
           {"--impacts: belongs to --method texton or multiple-kernels, which was not given"}},
          {{"--impacts", "20", "--method", "quilting"},
           {"--impacts: belongs to --method texton or multiple-kernels, not to quilting"}}});
  checkNothingWritten();
}

TEST_CASE("the error for a structure or spectrum that no noise can have says what is expected") {
  const Arguments cosines = made().bakeOf + Arguments{"--quiet", "--method", "local-random-phase"};
  const Arguments shares{"-0.1", "1.5", "some", "nan"};
  checkRefusals(cosines,
                std::vector<RefusedValues>{
                    {"--structure", shares, "auto or a number from 0 to 1"},
                    {"--guide", shares, "auto or a number from 0 to 1"},
                    {"--turbulence", {"-0.1", "1.5", "auto"}, "a number of tiles from 0 to 1"},
                    {"--spectrum",
                     {"ring:8", "ring:12:8", "ring:-2:8", "ring:8:nan", "ring:8:12,",
                      "ring:8:12,band:1", "band:2:1:0:5", "band:0:9999:0:1"},
                     "a picture, or parts such as ring:8:12"}});
  const std::string white =
      made().workplace.write("white.png", encodePng(SrgbImage(1, 1, 1), 8).value());
  checkRefusals(
      cosines,
      std::vector<Refused>{
          {{"--spectrum", white}, {"white.png: black everywhere but in the middle"}, kBadInput},
          {{"--spectrum", "no such.png"}, {"no such.png"}, kBadInput},
          {{"--spectrum", "ring:8:12", "--structure", "0.5"},
           {"--structure 0.5 with --spectrum"}}});
  checkRefusal(made().bakeOf + Arguments{"--structure", "0.5"}, kUsage,
               {"--structure", "local-random-phase"});
  checkNothingWritten();
}

TEST_CASE("the error for an unknown option value of synth lists the valid ones") {
  checkRefusals(
      made().synthOf,
      std::vector<RefusedValues>{
          {"--size",
           {"0x0", "abc", "99999x1", "1x99999", "12x", "x12", "1x2x3", "", "12.5x4",
            "99999999999x1"},
           "a size from 1x1 to 16384x16384"},
          {"--origin", {"5", "a,b", "1,2,3", "nan,0", "inf,0", "1e30,0"}, "X,Y with numbers"},
          {"--texels-per-tile",
           {"0", "-4", "nan", "inf", "1e30", "many"},
           "a number from 0.0009765625 to 16777216"},
          {"--sharpness", {"0", "17", "nan"}, "a number from 0.25 to 16"},
          {"--tile-rotation", {"1", "3", "90", "free"}, "none, 2 or 4"},
          {"--contrast", {"-1", "5", "nan"}, "a number from 0 to 4"},
          {"--impacts", {"0.5"}, "a number from 1 to 1000"},
          {"--points", {"blue"}, "stratified or poisson"},
          {"--seed", {"-1", "4294967296"}, "a whole number"}});
  const std::string other = "noise 'stone' has no such map; expected baseColor";
  checkRefusals(made().synthOf,
                std::vector<Refused>{{{"--noise", "granite"},
                                      {"--noise granite: ", " has no such noise; expected stone"}},
                                     {{"--map", "depth"}, {"--map depth: " + other}},
                                     {{"--map", "normal"}, {"--map normal: " + other}}});
  checkNothingWritten();
}

TEST_CASE("the last value counts if an option is given twice") {
  const Made& m = made();
  const std::string picture = m.workplace.path("twice.png");
  CHECK(jsonOf({"synth", m.bundle, "-o", m.workplace.path("absent/a.png"), "-o", picture, "--size",
                "1x1", "--size", "5x4"})
            .at("width") == 5);
  CHECK(std::filesystem::exists(picture));
}

TEST_CASE("the help does not show the parser's own type names") {
  for (const Arguments& verb :
       {Arguments{}, {"bake"}, {"synth"}, {"inspect"}, {"check"}, {"compare"}, {"merge"}})
    for (const char* word :
         {"ENUM", "TEXT:", "UINT", "FLOAT", "INT:", "->", "{", "SUBCOMMAND", " |"})
      CHECK_THAT(succeed(verb + Arguments{"--help"}).output, !Catch::Contains(word));
}

TEST_CASE("an invalid output is an error before the work starts") {
  const Made& m = made();
  const std::string absent = m.workplace.path("absent");
  const std::string missing = absent + ": the folder does not exist; create it first";
  const std::string folder = std::filesystem::path(m.image).parent_path().string();
  checkRefusal({"synth", m.bundle, "-o", absent + "/new.png"}, kEnvironment, {missing});
  checkRefusals(
      {"bake", m.image, "-o"},
      std::vector<Refused>{
          {{absent + "/new.glb"}, {missing}, kEnvironment},
          {{m.image + "/new.glb"}, {m.image + ": is a file; expected a folder"}, kEnvironment},
          {{folder}, {folder + ": is a folder; expected a file"}}});
  for (const char* name : {"new.png", "new", "new.glb.tmp"})
    checkRefusal({"bake", m.image, "-o", m.workplace.path(name)}, kUsage, {name, ".glb", ".gltf"});
  for (const char* name : {"new.jpg", "new", "new.glb"})
    checkRefusal({"synth", m.bundle, "-o", m.workplace.path(name)}, kUsage, {name, ".png", ".exr"});
}

TEST_CASE("an input that is not an image is bad input") {
  const Made& m = made();
  const samples::Bytes whole = samples::makePng({});
  const samples::Bytes half(whole.begin(), whole.begin() + std::ptrdiff_t(whole.size() / 2));
  samples::Exr exr;
  exr.hasOddValue = true;
  exr.oddValue = std::numeric_limits<float>::quiet_NaN();
  const Refused rows[] = {
      {{m.workplace.path("absent.png")}, {"absent.png", "No such file"}},
      {{m.workplace.path(".")}, {"a folder without a map: ", "stone.png (no map)", "nor_gl"}},
      {{m.workplace.write("empty.png", std::string())}, {"empty.png", "empty file", "PNG"}},
      {{m.workplace.write("text.png", std::string("not an image"))}, {"text.png", "PNG"}},
      {{m.workplace.write("half.png", half)}, {"half.png: truncated"}},
      {{m.workplace.write("nan.exr", samples::makeExr(exr))}, {"nan.exr"}},
      {{m.bundle}, {"stone.glb", "PNG"}}};
  for (const Refused& row : rows)
    checkRefusal({"bake", row.arguments[0], "-o", m.workplace.path("new.glb")}, kBadInput,
                 row.words);
  checkNothingWritten();
}

TEST_CASE("a file that is not a bundle is an error of the verbs that read one") {
  const Made& m = made();
  const std::string whole = m.workplace.read("stone.glb");
  const std::string files[] = {m.workplace.path("absent.glb"), m.image,
                               m.workplace.write("half.glb", whole.substr(0, whole.size() / 2)),
                               m.workplace.write("plain.gltf", std::string("{\"asset\": 1}"))};
  for (const std::string& file : files) {
    const std::string name = std::filesystem::path(file).filename().string();
    for (const Arguments& verb : {Arguments{"check"}, {"inspect"}, {"synth"}})
      checkRefusal(
          verb + Arguments{file} +
              (verb[0] == "synth" ? Arguments{"-o", m.workplace.path("new.png")} : Arguments{}),
          kBadInput, {name});
  }
  checkRefusal({"check", m.image}, kBadInput,
               {m.image + ": is a PNG image; expected a .glb or .gltf"});
  checkRefusal({"check", files[3]}, kBadInput, {"/asset/version"});
}

TEST_CASE("check names the faults of a bundle and exits with 1") {
  const Made& m = made();
  std::string broken = m.workplace.read("stone.glb");
  const std::size_t at = broken.find("\"inverseTable\":");
  REQUIRE(at != std::string::npos);
  broken[at + std::string("\"inverseTable\":").size()] = '9';
  const std::string path = m.workplace.write("broken.glb", broken);
  const Ended ended = runLichen({"check", path});
  CHECK(ended.code == 1);
  CHECK_THAT(ended.output, Catch::Contains("error: ") && Catch::Contains("inverseTable") &&
                               Catch::EndsWith(": 1 error, 0 warnings\n"));
  CHECK(ended.errors.empty());
  const Ended quiet = runLichen({"check", path, "--quiet"}),
              json = runLichen({"check", path, "--json"});
  CHECK(quiet.code == 1);
  CHECK_THAT(quiet.output, Catch::StartsWith("error: ") && !Catch::Contains("warning"));
  CHECK(json.code == 1);
  CHECK(nlohmann::json::parse(json.output).at("errors") == 1);
}

TEST_CASE("check prints warnings, except with --quiet, and exits with 0") {
  const Made& m = made();
  const std::string plain =
      m.workplace.write("plain.gltf", std::string(R"({"asset": {"version": "2.0"}})"));
  CHECK_THAT(succeed({"check", plain}).output,
             Catch::StartsWith("warning: the file has no noise: ") &&
                 Catch::EndsWith(": 0 errors, 1 warning\n"));
  CHECK(succeed({"check", plain, "--quiet"}).output.empty());
  checkRefusal({"inspect", plain}, kBadInput, {"plain.gltf: has no noise"});
}

TEST_CASE("a noise of a later revision is a warning of check, and synth uses another only if it is "
          "asked to") {
  const Workplace workplace;
  const std::string known = bake(workplace, workplace.write("grey.png", smoothGrey(16)),
                                 "stone.gltf", {"--name", "stone"});
  const auto file = nlohmann::json::parse(workplace.read("stone.gltf"));
  const auto writeWith = [&](const std::string& name, bool first) {
    nlohmann::json changed = file;
    nlohmann::json& list = changed["extensions"][kNoiseExtension]["noises"];
    nlohmann::json later = list[0];
    later.update({{"name", name}, {"revision", 2}});
    list.insert(first ? list.begin() : list.end(), later);
    return workplace.write("later.gltf", changed.dump());
  };
  const auto refuse = [&](const std::string& path, const Arguments& more,
                          const std::string& words) {
    checkRefusal(Arguments{"synth", path, "-o", workplace.path("new.png")} + more, kBadInput,
                 {words});
  };
  const Arguments small{"--size", "32"}, named = small + Arguments{"--noise", "stone"};
  const SrgbImage expected = synth(workplace, known, small);

  const std::string first = writeWith("moss", true);
  const std::string refusal =
      "noise 'moss' has revision 2 of tiling; this version knows 1; use the version of lichen that "
      "wrote it, or choose --noise stone";
  CHECK_THAT(succeed({"check", first}).output,
             Catch::StartsWith("warning: revision 2 of tiling; this version knows 1") &&
                 Catch::EndsWith(": 0 errors, 1 warning\n"));
  refuse(first, {}, refusal);
  refuse(first, {"--noise", "moss"}, refusal);
  CHECK((synth(workplace, first, named).values == expected.values));

  const std::string second = writeWith("moss", false);
  CHECK((synth(workplace, second, small).values == expected.values));
  refuse(second, {"--noise", "moss"}, refusal);

  const std::string alike = writeWith("stone", true);
  CHECK((synth(workplace, alike, named).values == expected.values));
}
