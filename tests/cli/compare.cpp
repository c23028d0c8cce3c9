// SPDX-License-Identifier: MIT
// `lichen compare` on results whose distance from their exemplar is known.
#include "bundle_surgery.h"
#include "command_run.h"

#include <lichen/files.h>
#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

constexpr int kFound = 1; // exit code

/// Measures by name, and the exit code of the command.
struct Compared {
  int code = -1;
  std::map<std::string, nlohmann::json> measures;

  [[nodiscard]] double value(const std::string& name) const {
    return measures.at(name).at("value").get<double>();
  }
};

Compared compared(const std::string& exemplar, const std::string& result,
                  const Arguments& more = {}) {
  const Ended ended = runLichen(Arguments{"compare", exemplar, result, "--json"} + more);
  INFO(ended.errors);
  Compared compared{ended.code, {}};
  REQUIRE((ended.code == 0 || ended.code == kFound));
  const nlohmann::json report = nlohmann::json::parse(ended.output);
  for (const nlohmann::json& measure : report.at("measures"))
    compared.measures[measure.at("name").get<std::string>()] = measure;
  return compared;
}

/// What `compare` prints on standard error.
std::string notesOf(const std::string& exemplar, const std::string& result,
                    const Arguments& more = {}) {
  return runLichen(Arguments{"compare", exemplar, result} + more).errors;
}

/// Returns the image repeated `times` times along each side.
SrgbImage repeated(const SrgbImage& image, int times) {
  SrgbImage large(image.width * times, image.height * times, image.channels);
  for (int y = 0; y < large.height; ++y)
    for (int x = 0; x < large.width; ++x)
      std::copy_n(image.pixel(x % image.width, y % image.height), image.channels,
                  large.pixel(x, y));
  return large;
}

/// Returns vertical stripes of random grey.
SrgbImage stripes(int side) {
  SrgbImage image(side, side, 1);
  std::uint32_t state = 1;
  for (int x = 0; x < side; ++x) {
    state = state * 1664525u + 1013904223u;
    for (int y = 0; y < side; ++y)
      image.pixel(x, y)[0] = float(state >> 24u) / 255.0f;
  }
  return image;
}

} // namespace

TEST_CASE("an exemplar compared with itself has distance 0 in every measure") {
  const Workplace workplace;
  const std::string image = workplace.write("moss.png", speckled(64, 64, 3));
  const Compared self = compared(image, image);
  CHECK(self.code == 0);
  CHECK(self.measures.size() == 4);
  CHECK(self.value("color_distance") == 0.0);
  CHECK(self.value("spectrum_distance_db") == 0.0);
  CHECK(self.value("autocovariance_error") == 0.0);
  CHECK(self.value("seam_visibility") == 1.0);
}

TEST_CASE("an image is compared with the photograph as it is, with its frame") {
  const Workplace workplace;
  const SrgbImage image = speckled(64, 64, 3);
  const std::string scan = workplace.write("scan.png", framed(image, 8, 8, 8));
  const Compared without = compared(scan, workplace.write("moss.png", image));
  CHECK(without.value("color_distance") > 0.1); // a third of the pixels are white in one of them
  CHECK_THAT(notesOf(scan, scan), !Catch::Contains("frame"));
}

TEST_CASE("compare gives the verdict of the bake") {
  const Workplace workplace;
  SrgbImage dots(40, 40, 3); // rare ones: a larger result has another colour distance
  std::uint32_t state = 1;
  for (int y = 0; y < dots.height; ++y)
    for (int x = 0; x < dots.width; ++x) {
      state = state * 1664525u + 1013904223u;
      std::fill_n(dots.pixel(x, y), 3,
                  state >> 24u < 8u ? 1.0f : 0.4f + 0.1f * float(state >> 31u));
    }
  for (const SrgbImage& image : {dots, speckled(96, 96, 3), brickwork(96)}) {
    const std::string photograph = workplace.write("photograph.png", image);
    const std::string bundle = workplace.path("noise.glb");
    const nlohmann::json baked = jsonOf({"bake", photograph, "-o", bundle});
    const Ended compared = runLichen({"compare", photograph, bundle, "--json"});
    CHECK(nlohmann::json::parse(compared.output).at("verdict") == baked.at("verdict"));
  }
}

TEST_CASE("a good verdict beside a missed target explains the exit code") {
  const Workplace workplace;
  SrgbImage grains(128, 128, 3); // nearly Gaussian, without any feature
  std::uint32_t state = 1;
  for (float& value : grains.values) {
    value = 0.3f;
    for (int k = 0; k < 4; ++k) {
      state = state * 1664525u + 1013904223u;
      value += 0.1f * float(state >> 8u) / float(1u << 24u);
    }
  }
  const std::string photograph = workplace.write("grains.png", grains);
  const std::string bundle = bake(workplace, photograph);
  const Ended equal = runLichen({"compare", photograph, bundle});
  CHECK(equal.code == 0);
  CHECK_THAT(equal.output, Catch::StartsWith("verdict: good\n"));
  // A shift of red by d is a colour distance of d / sqrt(3): above the target, but not visible.
  constexpr float kShift = 2.0f / 255.0f;
  for (std::size_t i = 0; i < grains.values.size(); i += 3)
    grains.values[i] += kShift;
  const Ended shifted = runLichen({"compare", workplace.write("red.png", grains), bundle});
  CHECK(shifted.code == kFound);
  CHECK_THAT(shifted.output,
             Catch::StartsWith("verdict: good; exit code 1, as a target is missed: targets are "
                               "stricter than the verdict\n"));
}

TEST_CASE("the result may have another size than the exemplar, which gives a note") {
  const Workplace workplace;
  const SrgbImage image = speckled(64, 64, 3);
  const std::string moss = workplace.write("moss.png", image);
  const std::string wall = workplace.write("wall.png", repeated(image, 3));
  CHECK(compared(moss, wall).value("color_distance") == 0.0);
  CHECK_THAT(notesOf(moss, wall),
             Catch::Contains("note: ") &&
                 Catch::Contains("wall.png is 192 x 192 pixels and the exemplar 64 x 64"));
  CHECK_THAT(notesOf(moss, moss), !Catch::Contains("same scale"));
}

TEST_CASE("compare synthesizes a bundle and adds its lattice visibility") {
  const Workplace workplace;
  const std::string image = workplace.write("moss.png", smooth(64));
  const std::string bundle = bake(workplace, image);
  const Compared first = compared(image, bundle);
  REQUIRE(first.measures.size() == 5);
  CHECK(first.measures.at("lattice_visibility").at("target") == 0.03);
  CHECK(first.value("lattice_visibility") >= 0.0);
  CHECK(first.value("color_distance") < 0.02);
  // The same image that synth makes from the bundle, up to rounding to 8 bits.
  synth(workplace, bundle, {"--size", "256x256"});
  const Compared again = compared(image, workplace.path("synth.png"));
  CHECK(again.value("color_distance") == Approx(first.value("color_distance")).margin(0.5 / 255.0));
  CHECK(again.value("autocovariance_error") ==
        Approx(first.value("autocovariance_error")).margin(0.01));
}

TEST_CASE("textons are measured against the exemplar's Gaussian version, not its colours") {
  const Workplace workplace;
  // Few colours, which no Gaussian texture can reproduce.
  const std::string image = workplace.write("moss.png", speckled(128, 128, 3));
  const std::string bundle =
      bake(workplace, image, "noise.glb", {"--method", "texton", "--support", "32"});
  const Compared texton = compared(image, bundle);
  CHECK(texton.code == 0);
  CHECK(texton.value("color_distance") > 0.02);
  CHECK(texton.measures.at("color_distance").at("target").is_null());
  CHECK(texton.measures.at("spectrum_distance_db").at("target").is_null());
  CHECK(texton.measures.at("gaussian_spectrum_distance_db").at("target") == 0.5);
  CHECK(texton.value("gaussian_spectrum_distance_db") < 0.5);
  CHECK(texton.measures.count("lattice_visibility") == 0);
  CHECK(texton.value("model_error") > 0.0);
  CHECK(texton.value("model_error") < 1.0);
  CHECK(texton.value("flatness") > 1.0);
}

TEST_CASE("cosines without a structure are measured against the exemplar's Gaussian version") {
  const Workplace workplace;
  const std::string image = workplace.write("moss.png", speckled(128, 128, 3));
  const auto measured = [&](const std::string& name, const Arguments& options) {
    return compared(
        image, bake(workplace, image, name, Arguments{"--method", "local-random-phase"} + options));
  };
  const Compared cosines = measured("cosines.glb", {"--structure", "0"});
  CHECK(cosines.value("color_distance") < 0.02);
  CHECK(cosines.measures.at("color_distance").at("target") == 0.003);
  CHECK(cosines.measures.at("spectrum_distance_db").at("target").is_null());
  CHECK(cosines.measures.at("gaussian_spectrum_distance_db").at("target") == 1.0);
  CHECK(cosines.value("gaussian_spectrum_distance_db") < 1.0);
  // One cosine has not the spectrum of anything else.
  CHECK(measured("one.glb", {"--structure", "0", "--cosines", "1"})
            .value("gaussian_spectrum_distance_db") > 1.0);
  const Compared given = measured("given.glb", {"--spectrum", "ring:8:12"});
  CHECK(given.measures.count("gaussian_spectrum_distance_db") == 0);
  for (const char* name : {"spectrum_distance_db", "seam_visibility"})
    CHECK(given.measures.at(name).at("target").is_null());
  const Compared structure = measured("structure.glb", {"--structure", "0.5"});
  CHECK(structure.measures.count("gaussian_spectrum_distance_db") == 0);
  CHECK(structure.measures.at("spectrum_distance_db").at("target") == 0.6);
}

TEST_CASE("the note on an exemplar of another size names the options that correct it") {
  const Workplace workplace;
  const std::string image = workplace.write("moss.png", smooth(64));
  const std::string bundle = bake(workplace, image, "noise.glb", {"--size", "32"});
  CHECK_THAT(notesOf(image, bundle, {"--size", "64"}),
             Catch::Contains("note: ") && Catch::Contains("64 x 64") &&
                 Catch::Contains("32 x 32") && Catch::Contains("--size"));
  CHECK_THAT(notesOf(image, bundle, {"--size", "32"}), !Catch::Contains("64 x 64"));
  const nlohmann::json report =
      nlohmann::json::parse(runLichen({"compare", image, bundle, "--size", "64", "--json"}).output);
  CHECK_THAT(report.at("notes").dump(), Catch::Contains("64 x 64"));
}

TEST_CASE("the smaller maps of a set of textons are compared at the size of the largest, without a "
          "note") {
  const Workplace workplace;
  std::filesystem::create_directory(workplace.path("rock"));
  // The same picture twice, once at half the size.
  const SrgbImage large = smoothGrey(64);
  SrgbImage small(32, 32, 1);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      *small.pixel(x, y) = (*large.pixel(2 * x, 2 * y) + *large.pixel(2 * x + 1, 2 * y) +
                            *large.pixel(2 * x, 2 * y + 1) + *large.pixel(2 * x + 1, 2 * y + 1)) /
                           4.0f;
  workplace.write("rock/rock_color.png", large);
  workplace.write("rock/rock_rough.png", small);
  const std::string rock = workplace.path("rock");
  const std::string bundle =
      bake(workplace, rock, "noise.glb", {"--method", "texton", "--support", "16"});
  const auto errorOf = [&](const std::string& map) {
    const Compared one = compared(rock, bundle, {"--map", map});
    const nlohmann::json& spectrum = one.measures.at("gaussian_spectrum_distance_db");
    CHECK(spectrum.at("target").is_null() == (map != "baseColor"));
    return one.value("autocovariance_error");
  };
  // Compared at its own scale, the smaller map would give another error.
  CHECK(errorOf("occlusionRoughnessMetallic") == Approx(errorOf("baseColor")).epsilon(0.1));
  CHECK_THAT(notesOf(rock, bundle), !Catch::Contains("when it was baked"));
  CHECK_THAT(notesOf(rock, bundle, {"--size", "32"}),
             Catch::Contains("the exemplar is 32 x 32, but was 64 x 64 when it was baked"));
}

TEST_CASE("--noise compares another noise of the bundle") {
  const Workplace workplace;
  const std::string moss = workplace.write("moss.png", smooth(32));
  const std::string grey = workplace.write("grey.png", smoothGrey(32));
  const std::string both = workplace.path("both.glb");
  succeed({"merge", bake(workplace, moss, "a.glb"), bake(workplace, grey, "b.glb"), "-o", both});
  CHECK(compared(grey, both, {"--noise", "grey"}).value("color_distance") <
        compared(grey, both).value("color_distance"));
  checkRefusal({"compare", grey, both, "--noise", "rust"}, kUsage,
               {"--noise rust: ", "expected moss or grey"});
  checkRefusal({"compare", grey, moss, "--noise", "grey"}, kUsage,
               {"--noise grey: ", "is an image"});
}

TEST_CASE("an exemplar with a strong grain has the wider spectrum target") {
  const Workplace workplace;
  const std::string wood = workplace.write("wood.png", stripes(64));
  const Compared self = compared(wood, wood);
  CHECK(self.measures.at("spectrum_distance_db").at("target") == 1.2);
  CHECK_THAT(self.measures.at("spectrum_distance_db").at("remark").get<std::string>(),
             Catch::Contains("anisotropic"));
  const std::string moss = workplace.write("moss.png", speckled(64, 64, 1));
  CHECK(compared(moss, moss).measures.at("spectrum_distance_db").at("target") == 0.6);
}

TEST_CASE("a measure that needs larger images is omitted, with the reason") {
  const Workplace workplace;
  const std::string small = workplace.write("small.png", smooth(16));
  CHECK_THAT(succeed({"compare", small, small}).output,
             Catch::Contains("spectrum_distance_db  not measured: the exemplar is 16 x 16; "
                             "expected sides of at least 32 pixels"));
}

TEST_CASE("light above 1 is compared by its logarithm, also with a PNG") {
  const Workplace workplace;
  LinearImage light(40, 40, 3);
  for (std::size_t i = 0; i < light.values.size(); ++i)
    light.values[i] = float((i * 37) % 101) / 25.0f;
  const std::string exemplar = workplace.write("lamp.exr", light);
  CHECK(compared(exemplar, exemplar).value("color_distance") == 0.0);
  const std::string dark = workplace.write("dark.png", SrgbImage(40, 40, 3));
  CHECK(compared(exemplar, dark).value("color_distance") > 0.1);
}

TEST_CASE(
    "compare prints one line per measure with value, target and verdict in columns, and nothing "
    "with --quiet") {
  const Workplace workplace;
  const std::string image = workplace.write("moss.png", speckled(64, 64, 3));
  const std::string dark = workplace.write("dark.png", SrgbImage(64, 64, 3));
  const std::string page = runLichen({"compare", image, image}).output;
  CHECK_THAT(page, Catch::Contains("color_distance") && Catch::Contains("target 0.003   met\n"));
  // The values are "0", "0 dB", "0" and "1", the targets "0.003", "0.6 dB", "0.2" and "1.1".
  std::istringstream lines(page);
  std::vector<std::pair<std::size_t, std::size_t>> columns;
  for (std::string line; std::getline(lines, line);)
    if (const std::size_t target = line.find("target "); target != std::string::npos)
      columns.emplace_back(target, std::min(line.find(" met"), line.find(" MISSED")));
  REQUIRE(columns.size() == 4);
  CHECK(std::ranges::count(columns, columns.front()) == 4);
  CHECK_THAT(runLichen({"compare", image, dark}).output,
             Catch::Contains("target 0.003   MISSED\n"));
  const Ended quiet = runLichen({"compare", image, dark, "--quiet"});
  CHECK(quiet.code == kFound);
  CHECK((quiet.output + quiet.errors).empty());
}

TEST_CASE("the errors for channels that do not fit name them") {
  const Workplace workplace;
  const std::string image = workplace.write("moss.png", smooth(16));
  const auto bytes = readFile(bake(workplace, image)).value();
  for (const std::vector<std::string>& channels :
       {std::vector<std::string>{"red"}, {"red", "green", "metallic"}, {"slopeX", "slopeY"}}) {
    example::GlbParts parts(bytes);
    parts.map(0, 0)["channels"] = channels;
    checkRefusal({"compare", image, workplace.write("other.glb", parts.join())}, kBadInput,
                 {"other.glb: ",
                  "/maps/0/channels: not the channels of baseColor; expected red, green, blue"});
  }
  for (const char* folder : {"one", "two"})
    std::filesystem::create_directory(workplace.path(folder));
  for (const char* map : {"one/rough.png", "two/rough.png", "two/ao.png"})
    workplace.write(map, smoothGrey(16));
  checkRefusal(
      {"compare", workplace.path("two"), bake(workplace, workplace.path("one"), "one.glb")},
      kBadInput,
      {"one.glb: the map occlusionRoughnessMetallic of noise 'one' has the channels roughness; the "
       "exemplar has occlusion, roughness"});
}

TEST_CASE("the error of compare for broken images and bundles is one line") {
  const Workplace workplace;
  const std::string image = workplace.write("moss.png", smooth(16));
  const std::string bundle = bake(workplace, image);
  const auto halfOf = [&](const std::string& name) {
    const std::string whole = workplace.read(name);
    return workplace.write("half_" + name, whole.substr(0, whole.size() / 2));
  };
  const std::string half = halfOf("noise.glb"), cut = halfOf("moss.png");
  checkRefusals(
      {"compare"},
      std::vector<Refused>{{{image, half}, {"half_noise.glb: "}, kBadInput},
                           {{image, cut}, {"half_moss.png"}, kBadInput},
                           {{cut, bundle}, {"half_moss.png"}, kBadInput},
                           {{workplace.path("absent.png"), bundle}, {"absent.png"}, kBadInput},
                           {{bundle, image}, {"noise.glb: is a bundle; expected a photograph"}},
                           {{image}, {"RESULT|BUNDLE is required"}}});
}
