// SPDX-License-Identifier: MIT
// Every wrong argument and every bad file: one line with the cure, and DESIGN.md's exit code.
#include "command_run.h"
#include "image_samples.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

constexpr int kUsage = int(ErrorKind::usage);
constexpr int kBadInput = int(ErrorKind::badInput);
constexpr int kEnvironment = int(ErrorKind::environment);

/// A small image and its bundle, made once for all the tests of this file.
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

TEST_CASE("a missing or unknown verb is refused with where to read more") {
  checkRefusal({}, kUsage, {"lichen --help"});
  checkRefusal({"frobnicate"}, kUsage, {"frobnicate", "lichen --help"});
  checkRefusal({"--frobnicate"}, kUsage, {"--frobnicate", "lichen --help"});
}

TEST_CASE("a verb without its arguments, or with too many, is refused") {
  const Made& m = made();
  checkRefusal({"bake"}, kUsage, {"lichen VERB --help"});
  checkRefusal({"bake", m.image}, kUsage, {"--output"});
  checkRefusal({"synth", m.bundle}, kUsage, {"--output"});
  checkRefusal({"check"}, kUsage, {"BUNDLE"});
  checkRefusal({"check", m.bundle, m.bundle}, kUsage, {m.bundle});
  checkRefusal({"bake", m.image, "-o"}, kUsage, {"--output"});
}

TEST_CASE("unknown options and numbers outside their range are refused by every verb") {
  const Made& m = made();
  for (const Arguments& verb : {Arguments{"bake", m.image, "-o", m.workplace.path("new.glb")},
                                Arguments{"synth", m.bundle, "-o", m.workplace.path("new.png")},
                                Arguments{"check", m.bundle}}) {
    const auto with = [&](const Arguments& more) {
      Arguments all = verb;
      all.insert(all.end(), more.begin(), more.end());
      return all;
    };
    checkRefusal(with({"--frobnicate"}), kUsage, {"--frobnicate"});
    checkRefusal(with({"--threads", "-1"}), kUsage, {"--threads", "-1"});
    checkRefusal(with({"--threads", "100000"}), kUsage, {"--threads", "100000"});
    checkRefusal(with({"--threads", "two"}), kUsage, {"--threads", "two"});
  }
}

TEST_CASE("bake refuses option values that it does not know") {
  checkBakeRefuses({"--precision", "9"}, kUsage, {"--precision", "9", "8", "16"});
  checkBakeRefuses({"--transport", "slow"}, kUsage, {"--transport", "slow", "fast", "exact"});
  checkBakeRefuses({"--method", "magic"}, kUsage, {"--method", "magic", "tiling"});
  checkBakeRefuses({"--periodic", "maybe"}, kUsage, {"--periodic", "maybe", "auto"});
  checkBakeRefuses({"--preview", "teapot"}, kUsage, {"--preview", "teapot", "sphere"});
  for (const char* seed : {"-1", "4294967296", "one", "1.5"})
    checkBakeRefuses({"--seed", seed}, kUsage, {"--seed", seed});
  for (const char* metres : {"0", "-1", "nan", "inf", "wide"})
    checkBakeRefuses({"--tile", metres}, kUsage, {"--tile", metres});
}

TEST_CASE("synth refuses sizes that are not two numbers from 1 to 16384") {
  for (const char* size :
       {"0x0", "abc", "99999x1", "1x99999", "12x", "x12", "1x2x3", "", "12.5x4", "99999999999x1"})
    checkSynthRefuses({"--size", size}, kUsage, {"size", size});
}

TEST_CASE("synth refuses option values that it does not know") {
  checkSynthRefuses({"--noise", "granite"}, kUsage, {"--noise granite", "stone"});
  checkSynthRefuses({"--map", "depth"}, kUsage, {"--map depth", "baseColor"});
  checkSynthRefuses({"--map", "normal"}, kUsage, {"normal", "stone"});
  checkSynthRefuses({"--blend", "add"}, kUsage, {"--blend", "add", "histogram"});
  for (const char* origin : {"5", "a,b", "1,2,3", "nan,0", "inf,0", "1e30,0"})
    checkSynthRefuses({"--origin", origin}, kUsage, {"origin"});
  for (const char* texels : {"0", "-4", "nan", "inf", "1e30", "many"})
    checkSynthRefuses({"--texels-per-tile", texels}, kUsage, {"texels"});
  for (const char* sharpness : {"0", "17", "nan"})
    checkSynthRefuses({"--sharpness", sharpness}, kUsage, {"--sharpness", sharpness});
  for (const char* contrast : {"-1", "5", "nan"})
    checkSynthRefuses({"--contrast", contrast}, kUsage, {"--contrast", contrast});
  for (const char* seed : {"-1", "4294967296"})
    checkSynthRefuses({"--seed", seed}, kUsage, {"--seed", seed});
}

TEST_CASE("an output that cannot be is refused before the work, with the cure") {
  const Made& m = made();
  const std::string absent = m.workplace.path("absent/new");
  checkRefusal({"bake", m.image, "-o", absent + ".glb"}, kEnvironment, {absent, "does not exist"});
  checkRefusal({"synth", m.bundle, "-o", absent + ".png"}, kEnvironment,
               {absent, "does not exist"});
  for (const char* name : {"new.png", "new", "new.glb.tmp"})
    checkRefusal({"bake", m.image, "-o", m.workplace.path(name)}, kUsage, {name, ".glb", ".gltf"});
  for (const char* name : {"new.jpg", "new", "new.glb"})
    checkRefusal({"synth", m.bundle, "-o", m.workplace.path(name)}, kUsage, {name, ".png", ".exr"});
}

TEST_CASE("an input that is absent, a folder, empty, or not an image is bad input") {
  const Made& m = made();
  const auto refuses = [&](const std::string& input, const std::vector<std::string>& words) {
    checkRefusal({"bake", input, "-o", m.workplace.path("new.glb")}, kBadInput, words);
    CHECK(!std::filesystem::exists(m.workplace.path("new.glb")));
  };
  refuses(m.workplace.path("absent.png"), {"absent.png", "No such file"});
  refuses(m.workplace.path("."), {"folder", "image"});
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

TEST_CASE("synth and check refuse what is not a bundle") {
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
}

TEST_CASE("check names the faults of a broken bundle and ends with 1") {
  const Made& m = made();
  std::string broken = m.workplace.read("stone.glb");
  const std::size_t at = broken.find("\"inverseTable\":");
  REQUIRE(at != std::string::npos);
  broken[at + std::string("\"inverseTable\":").size()] = '9';
  const std::string path = m.workplace.write("broken.glb", broken);
  const Ended ended = runLichen({"check", path});
  CHECK(ended.code == 1);
  CHECK_THAT(ended.output, Catch::Contains("error: ") && Catch::Contains("inverseTable"));
  CHECK(ended.errors.empty());
}
