// SPDX-License-Identifier: MIT
// Every kind of image that DESIGN.md section 7 accepts: it bakes, the bundle passes `check`, and an
// image synthesized from it has the exemplar's mean colour.
#include "command_run.h"
#include "image_samples.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

/// Tolerance of a mean over 128 x 128 pixels of speckles with a standard deviation of 0.13 and an
/// area of 4 texels: the standard error is 0.13 / sqrt(128 * 128 / 4) = 0.002, and 8-bit codes add
/// half of 1/255. More pixels, or narrower exemplars, which repeat more often, give a smaller
/// error.
constexpr double kMeanTolerance = 0.01;

/// Bakes, checks and synthesizes. `mean` is the exemplar's mean colour in sRGB code values.
void checkColour(const Workplace& workplace, const std::string& input,
                 const std::vector<double>& mean) {
  INFO(input);
  const std::string bundle = bake(workplace, input);
  const Ended checked = runLichen({"check", bundle});
  INFO(checked.output);
  CHECK(checked.code == 0);
  CHECK_THAT(checked.output, Catch::EndsWith("0 errors, 0 warnings\n"));
  const SrgbImage image = synth(workplace, bundle, {"--size", "128x128"});
  REQUIRE(image.channels == 3);
  const std::vector<double> got = meanOf(image);
  for (std::size_t c = 0; c < 3; ++c) {
    INFO("channel " << c);
    CHECK(got[c] == Approx(mean[c]).margin(kMeanTolerance));
  }
}

std::vector<double> greyMean(const SrgbImage& image) {
  return std::vector<double>(3, meanOf(image)[0]);
}

std::vector<double> colourMean(const SrgbImage& image) {
  std::vector<double> mean = meanOf(image);
  mean.resize(3);
  return mean;
}

std::vector<nlohmann::json> notesOf(const Workplace& workplace, const std::string& input) {
  const Ended ended =
      runLichen({"bake", input, "-o", workplace.path("noted.glb"), "--method", "tiling", "--json"});
  REQUIRE(ended.code == 0);
  return nlohmann::json::parse(ended.output).at("notes");
}

} // namespace

TEST_CASE("8-bit PNG of every colour type keeps its colour") {
  const Workplace workplace;
  for (int channels = 1; channels <= 4; ++channels) {
    const SrgbImage image = speckled(24, 16, channels);
    checkColour(workplace, workplace.write(std::to_string(channels) + ".png", image),
                channels <= 2 ? greyMean(image) : colourMean(image));
  }
}

TEST_CASE("16-bit PNG keeps its colour, in tables of either precision") {
  const Workplace workplace;
  const SrgbImage image = speckled(16, 16, 3);
  const std::string input = workplace.write("deep.png", encodePng(image, 16).value());
  checkColour(workplace, input, colourMean(image));
  const std::string bundle = bake(workplace, input, "fine.glb", {"--precision", "16"});
  CHECK(runLichen({"check", bundle}).code == 0);
  const std::vector<double> got = meanOf(synth(workplace, bundle, {"--size", "128x128"}));
  for (std::size_t c = 0; c < 3; ++c)
    CHECK(got[c] == Approx(meanOf(image)[c]).margin(kMeanTolerance));
}

TEST_CASE("palette and CMYK images bake cleanly") {
  const Workplace workplace;
  samples::Png palette;
  palette.colourType = 3;
  samples::Jpeg cmyk;
  cmyk.colour = samples::JpegColour::cmyk;
  for (const auto& [name, bytes] : {std::pair{"palette.png", samples::makePng(palette)},
                                    std::pair{"cmyk.jpg", samples::makeJpeg(cmyk)}}) {
    INFO(name);
    const std::string bundle = bake(workplace, workplace.write(name, bytes));
    CHECK(runLichen({"check", bundle}).code == 0);
  }
}

TEST_CASE("a constant JPEG keeps its colour everywhere") {
  const Workplace workplace;
  const samples::Jpeg jpeg;
  const std::string input = workplace.write("constant.jpg", samples::makeJpeg(jpeg));
  const std::string bundle = bake(workplace, input);
  const SrgbImage image = synth(workplace, bundle, {"--size", "40x30"});
  const ImageFile file = readImage(input).value();
  const float* expected = std::get<SrgbImage>(file.pixels).pixel(0, 0);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    REQUIRE(std::abs(image.values[i] - expected[i % 3]) < 1.5f / 255.0f);
}

TEST_CASE("an EXR of light up to 1 keeps its colour") {
  const Workplace workplace;
  const SrgbImage image = speckled(16, 16, 3);
  checkColour(workplace, workplace.write("light.exr", toLinear(image)), colourMean(image));
}

TEST_CASE("an EXR of light above 1 keeps its mean light") {
  const Workplace workplace;
  LinearImage light = toLinear(speckled(32, 32, 3));
  double mean = 0.0;
  for (float& value : light.values) {
    value *= 8.0f;
    mean += double(value) / double(light.values.size());
  }
  const std::string input = workplace.write("bright.exr", light);
  const std::vector<nlohmann::json> notes = notesOf(workplace, input);
  REQUIRE(notes.size() >= 1);
  const std::string bundle = bake(workplace, input);
  CHECK(runLichen({"check", bundle}).code == 0);
  REQUIRE(runLichen({"synth", bundle, "-o", workplace.path("s.exr"), "--size", "192x192"}).code ==
          0);
  const ImageFile file = readImage(workplace.path("s.exr")).value();
  const auto& image = std::get<LinearImage>(file.pixels);
  double got = 0.0;
  for (const float value : image.values)
    got += double(value) / double(image.values.size());
  // Linear light, whose standard deviation is about its mean: the standard error is 1 /
  // sqrt(18000), or 0.75 %. The tolerance is 4 standard errors, alpha 6e-5.
  CHECK(got == Approx(mean).epsilon(0.03));
}

TEST_CASE("light beyond the range of the tables is clamped, with a note") {
  const Workplace workplace;
  samples::Exr exr;
  for (samples::ExrChannel& channel : exr.channels)
    channel.type = 2; // float
  exr.hasOddValue = true;
  const auto bakeWith = [&](float value) {
    exr.oddValue = value;
    const std::string input = workplace.write("sun.exr", samples::makeExr(exr));
    const Ended ended = runLichen({"bake", input, "-o", workplace.path("sun.glb")});
    CHECK(ended.code == 0);
    return std::pair(workplace.read("sun.glb"), ended.errors);
  };
  const auto [most, silence] = bakeWith(65504.0f);
  CHECK(silence.find("65504") == std::string::npos);
  for (const auto& [value, text] : {std::pair{65536.0f, "65536"},
                                    {1e30f, "1e+30"},
                                    {std::numeric_limits<float>::max(), "3.40282e+38"}}) {
    const auto [bundle, notes] = bakeWith(value);
    CHECK((bundle == most));
    CHECK_THAT(notes,
               Catch::Contains("note: the image has light above 65504 in 1 of 64 pixels, up to " +
                               std::string(text) + "; clamped to 65504\n"));
  }
  CHECK(runLichen({"check", workplace.path("sun.glb")}).code == 0);
  REQUIRE(runLichen({"synth", workplace.path("sun.glb"), "-o", workplace.path("s.exr"), "--size",
                     "64x64"})
              .code == 0);
  // readImage() refuses values that are not finite.
  CHECK(readImage(workplace.path("s.exr")));
}

TEST_CASE("images of one row, one column and one pixel bake cleanly and keep their colour") {
  const Workplace workplace;
  for (const auto& [width, height] : {std::pair{1, 1}, std::pair{64, 1}, std::pair{1, 64}}) {
    const SrgbImage image = speckled(width, height, 3);
    const std::string name = std::to_string(width) + "x" + std::to_string(height) + ".png";
    const std::string bundle = bake(workplace, workplace.write(name, image));
    INFO(name);
    CHECK(runLichen({"check", bundle}).code == 0);
    const SrgbImage result = synth(workplace, bundle, {"--size", "256x256"});
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(meanOf(result)[c] == Approx(meanOf(image)[c]).margin(kMeanTolerance));
  }
}

TEST_CASE("an exemplar whose neighbouring texels are opposite extremes bakes cleanly") {
  const Workplace workplace;
  SrgbImage squares(16, 16, 3), stripes(16, 16, 3);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      for (int c = 0; c < 3; ++c) {
        squares.pixel(x, y)[c] = (x + y) % 2 == 0 ? 0.2f : 0.8f;
        stripes.pixel(x, y)[c] = y % 2 == 0 ? 0.2f : 0.8f;
      }
  for (const auto& [name, image] :
       {std::pair{"squares.png", squares}, std::pair{"stripes.png", stripes}}) {
    INFO(name);
    const std::string bundle = bake(workplace, workplace.write(name, image));
    CHECK(runLichen({"check", bundle}).code == 0);
  }
}

TEST_CASE("alpha gives a note unless it is all opaque") {
  const Workplace workplace;
  SrgbImage image = speckled(8, 8, 4);
  for (std::size_t i = 0; i < image.pixelCount(); ++i)
    image.values[i * 4 + 3] = 1.0f;
  const std::vector<nlohmann::json> opaque =
      notesOf(workplace, workplace.write("opaque.png", image));
  image.values[3] = 0.5f;
  const std::vector<nlohmann::json> holed = notesOf(workplace, workplace.write("holed.png", image));
  CHECK(holed.size() == opaque.size() + 1);
  const Ended ended =
      runLichen({"bake", workplace.path("holed.png"), "-o", workplace.path("a.glb")});
  CHECK_THAT(ended.errors,
             Catch::Contains("note: the image has an alpha channel that is not all opaque; it "
                             "is ignored unless alpha is read as opacity\n"));
}

TEST_CASE("an image with one colour or few pixels gives a note, a good image gives none") {
  const Workplace workplace;
  SrgbImage grey(100, 100, 3);
  grey.values.assign(grey.values.size(), 0.4f);
  const auto only = [&](const std::string& name, const SrgbImage& image) {
    const auto notes = notesOf(workplace, workplace.write(name, image));
    return notes.size() == 1 ? notes[0].get<std::string>() : std::to_string(notes.size());
  };
  CHECK_THAT(only("pixel.png", SrgbImage(1, 1, 3)), Catch::Contains("one colour"));
  CHECK_THAT(only("grey.png", grey), Catch::Contains("one colour"));
  CHECK_THAT(only("stamp.png", smooth(16)), Catch::Contains("16 x 16 pixels show little"));
  CHECK_THAT(only("small.png", smoothGrey(255)), Catch::Contains("256 to 1024 per side are best"));
  CHECK(only("good.png", smoothGrey(256)) == "0");
}

TEST_CASE("a photograph is baked upright, as its EXIF orientation says") {
  const Workplace workplace;
  // The rows of the stored picture, from the bottom up, are the columns of the upright one:
  // orientation 6 is a rotation to the right.
  samples::Png stored{.width = 16, .height = 24, .colourType = 0};
  samples::Bytes file = samples::makePng(stored);
  samples::insertPngChunk(file, "eXIf", samples::exifBlock(6, true));
  SrgbImage upright(24, 16, 1);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 24; ++x)
      *upright.pixel(x, y) = float(samples::pngCode(stored, y, 23 - x, 0)) / 255.0f;
  const std::string rotated = workplace.write("stored.png", file);
  bake(workplace, rotated, "a.glb", {"--name", "x"});
  bake(workplace, workplace.write("upright.png", upright), "b.glb", {"--name", "x"});
  CHECK((workplace.read("a.glb") == workplace.read("b.glb")));
  const std::vector<nlohmann::json> notes = notesOf(workplace, rotated);
  CHECK(std::find(notes.begin(), notes.end(),
                  "rotated or mirrored according to its EXIF orientation 6") != notes.end());
}

TEST_CASE("an exemplar that tiles also tiles after resizing") {
  const Workplace workplace;
  // Grain hides a ramp of 16 pixels at the borders until it is averaged out.
  constexpr int kSide = 128, kSlope = 16;
  SrgbImage image(kSide, kSide, 1);
  std::uint32_t state = 1;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      state = state * 1664525u + 1013904223u; // Numerical Recipes, eq. 7.1.6
      const float fromSeam = float(x < kSide / 2 ? x : x - kSide) + 0.5f;
      const float rise = std::clamp(fromSeam / float(kSlope), -0.5f, 0.5f);
      const float fall = 2.0f * fromSeam / float(kSide);
      *image.pixel(x, y) =
          0.5f + 0.2f * (rise - 0.5f * fall) + 0.4f * (float(state >> 8u) * 0x1p-24f - 0.5f);
    }
  const std::string tiles = workplace.write("tiles.png", image);
  const auto isPeriodic = [&](const std::string& input, Arguments more) {
    more.insert(more.begin(), {"bake", input, "-o", workplace.path("o.glb"), "--json"});
    const Ended ended = runLichen(more);
    REQUIRE(ended.code == 0);
    return nlohmann::json::parse(ended.output).at("periodic").get<bool>();
  };
  REQUIRE(isPeriodic(tiles, {}));
  for (const char* size : {"64", "32", "16", "40x24"})
    CHECK(isPeriodic(tiles, {"--size", size}));
  CHECK_FALSE(isPeriodic(tiles, {"--size", "16", "--periodic", "no"}));
  const std::string blobs = workplace.write("blobs.png", smoothGrey(64));
  CHECK(isPeriodic(blobs, {"--size", "16"}));
  CHECK_FALSE(isPeriodic(blobs, {"--size", "16", "--crop", "0,0,40,64"}));
}

TEST_CASE("a file name that is not UTF-8 becomes a valid noise name") {
  const Workplace workplace;
  const std::string input = workplace.write("caf\xe9.png", smoothGrey(16));
  const std::string bundle = bake(workplace, input, "noise.glb");
  CHECK(synth(workplace, bundle, {"--noise", "caf_", "--size", "8"}).width == 8);
  const std::string accented = workplace.write("caf\xc3\xa9.png", smoothGrey(16));
  bake(workplace, accented, "noise.glb");
  CHECK(synth(workplace, bundle, {"--noise", "caf\xc3\xa9", "--size", "8"}).width == 8);
}
