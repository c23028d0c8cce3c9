// SPDX-License-Identifier: MIT
// The output of the command: files, lines and JSON. Files are deterministic, and complete or
// absent.
#include "command_run.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <random>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

using Names = std::vector<std::string>;

/// Returns an image of independent values with this distribution.
SrgbImage grain(int width, int height, auto distribution) {
  SrgbImage image(width, height, 3);
  std::mt19937 random(3);
  std::generate(image.values.begin(), image.values.end(), [&] { return distribution(random); });
  return image;
}

} // namespace

TEST_CASE("bake writes one file, and synth and check need nothing else") {
  const Workplace workplace;
  const std::string input = workplace.write("moss.png", smoothGrey(16));
  bake(workplace, input, "moss.glb");
  CHECK(workplace.names() == Names{"moss.glb", "moss.png"});
  std::filesystem::remove(input);
  succeed({"check", workplace.path("moss.glb")});
  const SrgbImage image = synth(workplace, workplace.path("moss.glb"), {"--size", "40x24"});
  CHECK(image.width == 40);
  CHECK(image.height == 24);
  CHECK(image.channels == 3);
}

TEST_CASE("every preview shape and form of file gives a bundle without findings") {
  const Workplace workplace;
  const std::string input = workplace.write("moss.png", smoothGrey(16));
  for (const char* shape : {"sphere", "plane", "none"})
    for (const char* name : {"moss.glb", "moss.gltf"}) {
      const std::string bundle = bake(workplace, input, name, {"--preview", shape});
      succeed({"check", bundle});
      CHECK(synth(workplace, bundle, {"--size", "16"}).width == 16);
    }
}

TEST_CASE("an EXR stores the light whose sRGB code a PNG stores") {
  const Workplace workplace;
  const std::string bundle = bake(workplace, workplace.write("moss.png", smoothGrey(16)));
  const SrgbImage png = synth(workplace, bundle, {"--size", "32x32"});
  succeed({"synth", bundle, "-o", workplace.path("light.exr"), "--size", "32x32"});
  const SrgbImage exr =
      toSrgb(std::get<LinearImage>(readImage(workplace.path("light.exr")).value().pixels));
  for (std::size_t i = 0; i < png.values.size(); ++i)
    REQUIRE(png.values[i] == Approx(exr.values[i]).margin(1.0 / 255.0));
}

TEST_CASE("--json prints one object and nothing else") {
  const Workplace workplace;
  const std::string input = workplace.write("moss.png", smooth(16));
  const std::string bundle = workplace.path("moss.glb");

  const nlohmann::json baked = jsonOf({"bake", input, "-o", bundle});
  CHECK(baked.at("output") == bundle);
  CHECK(baked.at("name") == "moss");
  CHECK(baked.at("method") == "tiling");
  CHECK(baked.at("width") == 16);
  CHECK(baked.at("dimensions") == 3);
  CHECK(baked.at("tableBytes") > 0);

  const nlohmann::json checked = jsonOf({"check", bundle});
  CHECK(checked.at("errors") == 0);
  CHECK(checked.at("warnings") == 0);
  CHECK(checked.at("findings").empty());

  const std::string picture = workplace.path("picture.png");
  const nlohmann::json made = jsonOf({"synth", bundle, "-o", picture, "--size", "20x10"});
  CHECK(made.at("output") == picture);
  CHECK(made.at("width") == 20);
  CHECK(made.at("height") == 10);
}

TEST_CASE("a bake omits the inverse table of Gaussian exemplars only") {
  const Workplace workplace;
  const SrgbImage gaussian = grain(64, 64, std::normal_distribution<float>(0.5f, 0.05f));
  const SrgbImage uniform = grain(64, 64, std::uniform_real_distribution<float>(0.2f, 0.8f));
  constexpr std::size_t kTableBytes =
      4 * (32 * 32 * 32 + 16 * 16 * 16 + 8 * 8 * 8 + 4 * 4 * 4 + 2 * 2 * 2);
  const std::string bundle = workplace.path("kinds.glb");
  for (const auto& [image, table, fetches, bytes] :
       {std::tuple{gaussian, "none", 3, std::size_t(0)}, {uniform, "joint", 4, kTableBytes}}) {
    INFO(table);
    const nlohmann::json report =
        jsonOf({"bake", workplace.write("grain.png", image), "-o", bundle});
    CHECK(report.at("table") == table);
    // In addition, 64 x 64 texels of four bytes and their mip levels, up to a third more.
    const std::size_t stored = report.at("tableBytes").get<std::size_t>() - bytes;
    CHECK((stored > 64 * 64 * 4 && stored < 64 * 64 * 4 * 4 / 3 + 16));
    succeed({"check", bundle});
    synth(workplace, bundle, {"--size", "32"});
    const nlohmann::json map = jsonOf({"inspect", bundle}).at("noises")[0].at("maps")[0];
    CHECK(map.at("table") == table);
    CHECK(map.at("fetchesPerPixel") == fetches);
  }
}

TEST_CASE("--quiet prints nothing, not even notes") {
  const Workplace workplace;
  const std::string input = workplace.write("holed.png", speckled(16, 16, 4));
  const std::string bundle = workplace.path("holed.glb");
  for (const Arguments& arguments :
       {Arguments{"bake", input, "-o", bundle, "--quiet"}, Arguments{"check", bundle, "--quiet"},
        Arguments{"synth", bundle, "-o", workplace.path("p.png"), "--size", "8x8", "--quiet"}}) {
    const Ended ended = succeed(arguments);
    CHECK((ended.output + ended.errors).empty());
  }
}

TEST_CASE("bake, mix and synth write the same bytes on one thread, on two and again") {
  const Workplace workplace;
  const std::string input = workplace.write("moss.png", speckled(40, 24, 3)),
                    other = workplace.write("rust.png", speckled(24, 40, 3)),
                    bundle = workplace.path("moss.glb"), report = workplace.path("moss.html");
  std::vector<Arguments> all{{"mix", input, other, "--support", "8", "--steps", "3"}};
  for (const char* method :
       {"tiling", "quilting", "texton", "local-random-phase", "multiple-kernels"})
    all.push_back({"bake", input, "--report", report, "--method", method});
  for (const Arguments& arguments : all) {
    INFO(arguments.back());
    std::string first;
    for (const std::string threads : {"1", "2", "2"}) {
      succeed(arguments + Arguments{"-o", bundle, "--threads", threads});
      synth(workplace, bundle, {"--size", "200x150", "--threads", threads});
      std::string bytes = workplace.read("moss.glb") + workplace.read("synth.png");
      if (arguments.front() == "bake") { // the rest of the page shows the command and the time
        const std::string page = workplace.read("moss.html");
        const std::size_t begin = page.find("<main>"), end = page.find("<footer>");
        REQUIRE(end - begin > 10000);
        bytes += page.substr(begin, end - begin);
      }
      if (first.empty())
        first = bytes;
      CHECK((bytes == first));
    }
  }
}

TEST_CASE("a bake that is interrupted while it works ends at once and leaves the old bundle") {
  const Workplace workplace;
  const std::string input = workplace.write("moss.png", speckled(512, 512, 3));
  const std::string bundle = workplace.write("moss.glb", std::string("the old one"));
  Limits limits;
  limits.killedAfterMs = 500; // the bake takes seconds
  limits.signal = SIGINT;
  const Ended ended = runLichen({"bake", input, "-o", bundle, "--threads", "1"}, limits);
  CHECK(ended.code == -1); // ended by the signal, so that a script that called it stops too
  CHECK(workplace.read("moss.glb") == "the old one");
  CHECK(workplace.names() == Names{"moss.glb", "moss.png"});
}

TEST_CASE("a failed write to standard output is an error of one line") {
  const Workplace workplace;
  const std::string input = workplace.write("moss.png", smoothGrey(16));
  const std::string bundle = bake(workplace, input);
  const std::string picture = workplace.path("p.png");
  Limits limits;
  limits.fullOutput = true;
  for (const Arguments& arguments :
       {Arguments{"bake", input, "-o", bundle, "--json"}, Arguments{"bake", input, "-o", bundle},
        Arguments{"check", bundle}, Arguments{"check", bundle, "--json"},
        Arguments{"synth", bundle, "-o", picture, "--size", "8x8", "--json"}, Arguments{"--help"},
        Arguments{"--version"}}) {
    const Ended ended = runLichen(arguments, limits);
    CHECK(ended.code == kResources);
    // Notes may precede it.
    CHECK_THAT(ended.errors, Catch::EndsWith("lichen: standard output: cannot be written\n"));
    CHECK(ended.errors.find("lichen:") == ended.errors.rfind("lichen:"));
  }
}

TEST_CASE("control characters in names are escaped on the terminal, other characters are not") {
  const Workplace workplace;
  const std::string hostile = "m\x1b[31m\xc2\x9b\x7f\nf\xc3\xbc";
  const std::string shown = "m\\x1b[31m\\xc2\\x9b\\x7f\\x0af\xc3\xbc";
  const std::string input = workplace.write("moss.png", smoothGrey(16));
  const auto checkShown = [&](const std::string& text, const std::string& expected) {
    CHECK_THAT(text, Catch::Contains(expected));
    CHECK(std::count(text.begin(), text.end(), '\n') == 1);
    CHECK(std::none_of(text.begin(), text.end(), [](char c) {
      return (static_cast<unsigned char>(c) < 0x20 && c != '\n') || c == '\x7f';
    }));
    CHECK(text.find("\xc2\x9b") == std::string::npos);
  };

  const std::string bundle = workplace.path(hostile + ".glb");
  const Ended baked = runLichen({"bake", input, "-o", bundle, "--name", hostile});
  CHECK(baked.code == 0);
  checkShown(baked.output.substr(baked.output.find('\n') + 1), shown + ".glb: "); // verdict before
  checkShown(runLichen({"check", workplace.path(hostile)}).errors, shown + ": cannot be read");
  checkShown(
      runLichen({"synth", bundle, "-o", workplace.path("p.png"), "--noise", "absent"}).errors,
      "expected " + shown);

  checkShown(runLichen({"check", workplace.path("latin f\xfc.glb")}).errors, "latin f\\xfc.glb: ");

  // A finding: the file of a buffer is missing.
  const std::string text = workplace.read(
      std::filesystem::path(bake(workplace, input, "moss.gltf")).filename().string());
  nlohmann::json gltf = nlohmann::json::parse(text);
  gltf["buffers"][0]["uri"] = "m%1B%5B31m%C2%9B%7F%0Af%C3%BC";
  const Ended checked = runLichen({"check", workplace.write("broken.gltf", gltf.dump()), "--json"});
  CHECK(nlohmann::json::parse(checked.output)["findings"][0]["code"] == "buffer-uri");
  const std::string lines = runLichen({"check", workplace.path("broken.gltf")}).output;
  checkShown(lines.substr(0, lines.find('\n') + 1), shown);
}

TEST_CASE("blended borders give a note with --periodic auto, not with --periodic no") {
  const Workplace workplace;
  SrgbImage ramp(32, 32, 3);
  for (int i = 0; i < 32 * 32 * 3; ++i)
    ramp.values[std::size_t(i)] = float(i / 3 % 32) / 31.0f;
  const std::string input = workplace.write("ramp.png", ramp);
  const auto errorsWith = [&](const char* periodic) {
    return runLichen({"bake", input, "-o", workplace.path("ramp.glb"), "--periodic", periodic})
        .errors;
  };
  CHECK_THAT(errorsWith("auto"), Catch::Contains("borders do not fit together"));
  CHECK(errorsWith("no").find("borders") == std::string::npos);
  CHECK(errorsWith("yes").find("borders") == std::string::npos);
}
