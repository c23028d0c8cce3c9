// SPDX-License-Identifier: MIT
// The effect of --crop, --size and --alpha on the pixels before they are baked.
#include "bundle_surgery.h"
#include "command_run.h"

#include <lichen/files.h>
#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace lichen;
using namespace lichen::cli_test;
using nlohmann::json;

namespace {

/// Bakes `inputs`, and returns the report.
json reportOf(const Workplace& workplace, const Arguments& inputs, const Arguments& more) {
  return jsonOf(Arguments{"bake"} + inputs +
                Arguments{"-o", workplace.path("out.glb"), "--name", "x"} + more);
}

/// The same without what the bundle says of these options.
std::vector<std::byte> unrecorded(const Workplace& workplace, const Arguments& inputs,
                                  const Arguments& more) {
  (void)reportOf(workplace, inputs, more);
  example::GlbParts parts(readFile(workplace.path("out.glb")).value());
  parts.extension()["noises"][0].erase("preparation");
  return parts.join();
}

SrgbImage part(const SrgbImage& image, int x0, int y0, int width, int height) {
  SrgbImage result(width, height, image.channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      std::copy_n(image.pixel(x0 + x, y0 + y), image.channels, result.pixel(x, y));
  return result;
}

/// An image that is half opaque and greenish, in blobs; the rest, and all its red codes, is
/// invisible.
SrgbImage leaves(int side) {
  const SrgbImage blobs = smoothGrey(side);
  SrgbImage image(side, side, 4);
  for (std::size_t i = 0; i < blobs.values.size(); ++i) {
    const float alpha = std::clamp(0.5f + 6.0f * (blobs.values[i] - 0.5f), 0.0f, 1.0f);
    const bool visible = alpha > 0.0f;
    float* pixel = &image.values[4 * i];
    pixel[0] = visible ? 0.0f : 1.0f;
    pixel[1] = visible ? 0.3f + 0.4f * blobs.values[i] : 0.0f;
    pixel[2] = visible ? 0.1f : 1.0f;
    pixel[3] = alpha;
  }
  return image;
}

double meanAlpha(const SrgbImage& image) { return meanOf(image)[3]; }

} // namespace

TEST_CASE("a frame is cut off like a crop, from all maps, and recorded") {
  const Workplace workplace;
  std::filesystem::create_directory(workplace.path("scan"));
  workplace.write("scan/diff.png", framed(speckled(64, 48, 3), 4, 6, 2));
  workplace.write("scan/rough.png", speckled(32, 24, 1));
  const Arguments scan{workplace.path("scan")};
  const std::string inside = "6,8,54,40"; // without two more pixels beside the frame
  const json report = reportOf(workplace, scan, {});
  const std::string bundle = workplace.read("out.glb");
  CHECK_THAT(report.at("notes").dump(), Catch::Contains("a frame is cut off") &&
                                            Catch::Contains("54 x 40 pixels from column 6"));
  (void)reportOf(workplace, scan, {"--crop", inside});
  CHECK(bundle == workplace.read("out.glb"));
}

TEST_CASE("maps of other sizes lose the frame of the base colour at whole pixels inside of it") {
  const Workplace workplace;
  for (const char* const folder : {"scan", "inside"})
    std::filesystem::create_directory(workplace.path(folder));
  // The frame and two more pixels, 5, are 7.5 of the roughness: 8, and 5.33 of the colour again: 5.
  const SrgbImage color = framed(speckled(64, 48, 3), 3, 0, 3);
  const SrgbImage rough = framed(speckled(96, 72, 1), 4, 0, 4);
  workplace.write("scan/diff.png", color);
  workplace.write("scan/rough.png", rough);
  workplace.write("inside/diff.png", part(color, 5, 0, 54, 48));
  workplace.write("inside/rough.png", part(rough, 8, 0, 80, 72));
  CHECK((unrecorded(workplace, {workplace.path("scan")}, {}) ==
         unrecorded(workplace, {workplace.path("inside")}, {})));
}

TEST_CASE("a frame stays if the whole picture is asked for, or its opacity, period or labels") {
  const Workplace workplace;
  const std::string scan = workplace.write("scan.png", framed(speckled(64, 48, 3), 4, 6, 2));
  SrgbImage halves(64, 48, 3);
  for (int x = 0; x < 32; ++x)
    for (int y = 0; y < 48; ++y)
      halves.pixel(x, y)[0] = 1.0f;
  std::filesystem::create_directory(workplace.path("leaf"));
  std::filesystem::copy_file(scan, workplace.path("leaf/diff.png"));
  workplace.write("leaf/opacity.png", speckled(64, 48, 1));
  const std::pair<Arguments, Arguments> uses[] = {
      {{scan}, {"--crop", "0,0,64,48"}},
      {{scan}, {"--periodic", "yes"}},
      {{scan}, {"--layers", workplace.write("halves.png", halves)}},
      {{workplace.path("leaf")}, {}}};
  for (const auto& [inputs, options] : uses) {
    const json report = reportOf(workplace, inputs, options);
    INFO(report.dump());
    CHECK(report.at("width") == 64);
    CHECK(report.at("height") == 48);
    CHECK_THAT(report.at("notes").dump(), !Catch::Contains("frame"));
  }
}

TEST_CASE("--crop gives the same bake as files with only that part, also of smaller maps") {
  const Workplace workplace;
  std::filesystem::create_directory(workplace.path("whole"));
  std::filesystem::create_directory(workplace.path("cut"));
  const SrgbImage color = speckled(32, 32, 3), rough = speckled(16, 16, 1);
  workplace.write("whole/diff.png", color);
  workplace.write("whole/rough.png", rough);
  workplace.write("cut/diff.png", part(color, 8, 4, 16, 20));
  workplace.write("cut/rough.png", part(rough, 4, 2, 8, 10));
  CHECK((unrecorded(workplace, {workplace.path("whole")}, {"--crop", "8,4,16,20"}) ==
         unrecorded(workplace, {workplace.path("cut")}, {})));
}

TEST_CASE("--size resamples every map, with a note on those that it enlarges") {
  const Workplace workplace;
  std::filesystem::create_directory(workplace.path("set"));
  workplace.write("set/diff.png", speckled(48, 32, 3));
  workplace.write("set/rough.png", speckled(12, 12, 1));
  const Arguments set{workplace.path("set")};
  json report = reportOf(workplace, set, {"--size", "24x16"});
  for (const json& map : report.at("maps")) {
    CHECK(map.at("width") == 24);
    CHECK(map.at("height") == 16);
  }
  const std::string notes = report.at("notes").dump();
  CHECK_THAT(notes, Catch::Contains("rough.png is enlarged from 12 x 12"));
  CHECK_THAT(notes, !Catch::Contains("diff.png is enlarged"));
  report = reportOf(workplace, set, {"--size", "10", "--crop", "0,0,24,24"});
  CHECK(report.at("width") == 10);
  CHECK(report.at("height") == 10);
}

TEST_CASE("--size averages light, and the slopes of normals") {
  const Workplace workplace;
  SrgbImage squares(32, 32, 1), bumps(32, 32, 3);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      const bool first = (x + y) % 2 == 0;
      *squares.pixel(x, y) = first ? 0.0f : 1.0f;
      // Slopes of 0 and 1.5 along x.
      const float length = std::sqrt(1.0f + 1.5f * 1.5f);
      bumps.pixel(x, y)[0] = first ? 0.5f : 0.5f - 0.5f * 1.5f / length;
      bumps.pixel(x, y)[1] = 0.5f;
      bumps.pixel(x, y)[2] = first ? 1.0f : 0.5f + 0.5f / length;
    }
  std::filesystem::create_directory(workplace.path("set"));
  workplace.write("set/diff.png", squares);
  workplace.write("set/normal.png", encodePng(bumps, 16).value());
  (void)reportOf(workplace, {workplace.path("set")}, {"--size", "8"});
  const std::string bundle = workplace.path("out.glb");
  // The cubic filter leaves less than a hundredth of the squares, whose frequency is four times the
  // sampling frequency of the result.
  constexpr double kLeft = 0.01;
  const SrgbImage color = synth(workplace, bundle, {"--size", "8"});
  for (const float value : color.values)
    CHECK(double(srgbToLinear(value)) == Approx(0.5).margin(kLeft));
  succeed({"synth", bundle, "-o", workplace.path("n.exr"), "--map", "normal", "--size", "8"});
  const auto normals = std::get<LinearImage>(readImage(workplace.path("n.exr")).value().pixels);
  for (std::size_t i = 0; i < normals.pixelCount(); ++i) {
    const float* code = normals.pixel(int(i), 0);
    CHECK(-(2.0f * code[0] - 1.0f) / (2.0f * code[2] - 1.0f) == Approx(0.75).margin(1.5 * kLeft));
  }
}

TEST_CASE("--alpha opacity bakes a map whose mean is the same at every distance") {
  const Workplace workplace;
  const SrgbImage image = leaves(32);
  const std::string input = workplace.write("leaves.png", encodePng(image, 8).value());
  CHECK(reportOf(workplace, {input}, {}).at("maps").size() == 1);
  const json report = reportOf(workplace, {input}, {"--alpha", "opacity"});
  REQUIRE(report.at("maps").size() == 2);
  CHECK(report.at("maps")[1].at("target") == "opacity");
  for (const int texels : {32, 8, 1}) {
    INFO(texels << " texels a tile");
    const SrgbImage opacity =
        synth(workplace, workplace.path("out.glb"),
              {"--map", "opacity", "--size", "256", "--texels-per-tile", std::to_string(texels)});
    // At least 64 tiles of blobs a third of a tile wide, with a standard deviation of 0.45: the
    // standard error is 0.45 / sqrt(64 * 9) = 0.019. The margin is two of them, and half an 8-bit
    // code.
    CHECK(meanOf(opacity)[0] == Approx(meanAlpha(image)).margin(0.04));
  }
}

TEST_CASE("colours under zero opacity do not appear in the noise") {
  const Workplace workplace;
  const SrgbImage image = leaves(32);
  const auto mostRed = [&](const Arguments& inputs, const Arguments& more) {
    (void)reportOf(workplace, inputs, more);
    const SrgbImage color = synth(workplace, workplace.path("out.glb"), {"--size", "128"});
    float most = 0.0f;
    for (std::size_t i = 0; i < color.values.size(); i += 3)
      most = std::max(most, color.values[i]);
    return most;
  };
  const std::string input = workplace.write("leaves_diff.png", encodePng(image, 8).value());
  CHECK(mostRed({input}, {}) > 0.5f);
  CHECK(mostRed({input}, {"--alpha", "opacity"}) < 0.02f);
  // A separate opacity file has the same effect.
  SrgbImage alpha(32, 32, 1);
  for (std::size_t i = 0; i < alpha.values.size(); ++i)
    alpha.values[i] = image.values[4 * i + 3];
  const std::string opacity = workplace.write("leaves_opacity.png", alpha);
  CHECK(mostRed({input, opacity}, {}) < 0.02f);
  checkRefusal({"bake", input, opacity, "-o", workplace.path("new.glb"), "--alpha", "opacity"},
               kBadInput, {"leaves_diff.png", "leaves_opacity.png", "opacity"});
}

TEST_CASE("--alpha opacity gives a note for an opaque image and changes nothing") {
  const Workplace workplace;
  const std::string input = workplace.write("opaque.png", speckled(16, 16, 3));
  const json report = reportOf(workplace, {input}, {"--alpha", "opacity"});
  const std::string bundle = workplace.read("out.glb");
  CHECK_THAT(report.at("notes").dump(), Catch::Contains("opaque everywhere"));
  (void)reportOf(workplace, {input}, {});
  CHECK((bundle == workplace.read("out.glb")));
}
