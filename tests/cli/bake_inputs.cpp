// SPDX-License-Identifier: MIT
// Every kind of image that docs/cli.md lists: it bakes, the bundle passes `check`, and an
// image synthesized from it has the exemplar's mean colour.
#include "command_run.h"
#include "image_samples.h"

#include <lichen/image_io.h>

#include <catch2/catch.hpp>

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

/// Bakes and checks.
std::string soundBake(const Workplace& workplace, const std::string& input,
                      const Arguments& more = {}) {
  const std::string bundle = bake(workplace, input, "noise.glb", more);
  CHECK_THAT(succeed({"check", bundle}).output, Catch::EndsWith("0 errors, 0 warnings\n"));
  return bundle;
}

std::vector<std::string> notesOf(const std::string& input) {
  const Workplace output;
  return jsonOf({"bake", input, "-o", output.path("n.glb"), "--method", "tiling"}).at("notes");
}

} // namespace

TEST_CASE("images of every kind keep their colour") {
  struct Kind {
    std::string name;
    SrgbImage image;
    std::vector<std::byte> file = {}; ///< of the image; by its name where this is empty
    Arguments options = {};
    std::string size = "128";
  };
  const SrgbImage square = speckled(16, 16, 3);
  const std::vector<std::byte> deep = encodePng(square, 16).value();
  std::vector<Kind> kinds{{"deep.png", square, deep},
                          {"precise.png", square, deep, {"--precision", "16"}},
                          {"pixel.png", speckled(1, 1, 3), {}, {}, "256"},
                          {"row.png", speckled(64, 1, 3), {}, {}, "256"},
                          {"column.png", speckled(1, 64, 3), {}, {}, "256"}};
  for (int channels = 1; channels <= 4; ++channels)
    kinds.push_back({std::to_string(channels) + ".png", speckled(24, 16, channels)});
  const Workplace workplace;
  for (const Kind& kind : kinds) {
    INFO(kind.name);
    const std::string input = kind.file.empty() ? workplace.write(kind.name, kind.image)
                                                : workplace.write(kind.name, kind.file);
    const std::string bundle = soundBake(workplace, input, kind.options);
    const SrgbImage drawn = synth(workplace, bundle, {"--size", kind.size});
    REQUIRE(drawn.channels == 3);
    const std::vector<double> mean = meanOf(kind.image);
    for (std::size_t c = 0; c < 3; ++c)
      CHECK(meanOf(drawn)[c] == Approx(mean[mean.size() < 3 ? 0 : c]).margin(kMeanTolerance));
  }
}

TEST_CASE("palette and CMYK images, and opposite extremes side by side, bake cleanly") {
  const Workplace workplace;
  samples::Png palette;
  palette.colourType = 3;
  soundBake(workplace, workplace.write("palette.png", samples::makePng(palette)));
  samples::Jpeg cmyk;
  cmyk.colour = samples::JpegColour::cmyk;
  soundBake(workplace, workplace.write("cmyk.jpg", samples::makeJpeg(cmyk)));
  SrgbImage squares(16, 16, 3), stripes(16, 16, 3);
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      for (int c = 0; c < 3; ++c) {
        squares.pixel(x, y)[c] = (x + y) % 2 == 0 ? 0.2f : 0.8f;
        stripes.pixel(x, y)[c] = y % 2 == 0 ? 0.2f : 0.8f;
      }
  soundBake(workplace, workplace.write("squares.png", squares));
  soundBake(workplace, workplace.write("stripes.png", stripes));
}

TEST_CASE("a constant JPEG keeps its colour everywhere") {
  const Workplace workplace;
  const std::string input = workplace.write("constant.jpg", samples::makeJpeg({}));
  const SrgbImage image = synth(workplace, bake(workplace, input), {"--size", "40x30"});
  const ImageFile file = readImage(input).value();
  const float* expected = std::get<SrgbImage>(file.pixels).pixel(0, 0);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    REQUIRE(std::abs(image.values[i] - expected[i % 3]) < 1.5f / 255.0f);
}

TEST_CASE("an EXR keeps its mean light, up to 1 and above") {
  for (const float brightest : {1.0f, 8.0f}) {
    const Workplace workplace;
    LinearImage light = toLinear(speckled(32, 32, 3));
    const auto meanLight = [](const LinearImage& image) {
      double sum = 0.0;
      for (const float value : image.values)
        sum += double(value);
      return sum / double(image.values.size());
    };
    for (float& value : light.values)
      value *= brightest;
    const std::string input = workplace.write("light.exr", light);
    succeed({"synth", soundBake(workplace, input), "-o", workplace.path("s.exr"), "--size", "192"});
    const ImageFile drawn = readImage(workplace.path("s.exr")).value();
    // Linear light, whose standard deviation is about its mean: the standard error is 1 /
    // sqrt(18000), or 0.75 %. The tolerance is 4 standard errors, alpha 6e-5.
    CHECK(meanLight(std::get<LinearImage>(drawn.pixels)) == Approx(meanLight(light)).epsilon(0.03));
  }
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
    const std::string notes = succeed({"bake", input, "-o", workplace.path("sun.glb")}).errors;
    return std::pair(workplace.read("sun.glb"), notes);
  };
  const auto [most, silence] = bakeWith(65504.0f);
  CHECK(silence.find("65504") == std::string::npos);
  for (const auto& [value, text] :
       {std::pair{65536.0f, "65536"}, {std::numeric_limits<float>::max(), "3.40282e+38"}}) {
    const auto [bundle, notes] = bakeWith(value);
    CHECK((bundle == most));
    CHECK_THAT(notes,
               Catch::Contains("note: the image has light above 65504 in 1 of 64 pixels, up to " +
                               std::string(text) + "; clamped to 65504\n"));
  }
  succeed({"check", workplace.path("sun.glb")});
  succeed({"synth", workplace.path("sun.glb"), "-o", workplace.path("s.exr"), "--size", "64"});
  CHECK(readImage(workplace.path("s.exr"))); // which refuses values that are not finite
}

TEST_CASE("alpha gives a note unless it is all opaque") {
  const Workplace workplace;
  SrgbImage image = speckled(8, 8, 4);
  for (std::size_t i = 0; i < image.pixelCount(); ++i)
    image.values[i * 4 + 3] = 1.0f;
  const std::size_t opaque = notesOf(workplace.write("opaque.png", image)).size();
  image.values[3] = 0.5f;
  const std::vector<std::string> holed = notesOf(workplace.write("holed.png", image));
  CHECK(holed.size() == opaque + 1);
  CHECK(std::ranges::count(holed, "the image has an alpha channel that is not all opaque; it is "
                                  "ignored unless alpha is read as opacity") == 1);
}

TEST_CASE("an image with one colour or few pixels gives a note, a good image gives none") {
  const Workplace workplace;
  SrgbImage grey(100, 100, 3);
  grey.values.assign(grey.values.size(), 0.4f);
  const auto only = [&](const SrgbImage& image) {
    const std::vector<std::string> notes = notesOf(workplace.write("image.png", image));
    return notes.size() == 1 ? notes[0] : std::to_string(notes.size());
  };
  CHECK_THAT(only(SrgbImage(1, 1, 3)), Catch::Contains("one colour"));
  CHECK_THAT(only(grey), Catch::Contains("one colour"));
  CHECK_THAT(only(smooth(16)), Catch::Contains("16 x 16 pixels show little"));
  CHECK_THAT(only(smoothGrey(255)), Catch::Contains("256 to 1024 per side are best"));
  CHECK(only(smoothGrey(256)) == "0");
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
  CHECK(std::ranges::count(notesOf(rotated),
                           "rotated or mirrored according to its EXIF orientation 6") == 1);
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
  const std::string blobs = workplace.write("blobs.png", smoothGrey(64));
  const auto isPeriodic = [&](const std::string& input, const Arguments& more) {
    return jsonOf(Arguments{"bake", input, "-o", workplace.path("o.glb")} + more)
        .at("periodic")
        .get<bool>();
  };
  REQUIRE(isPeriodic(tiles, {}));
  for (const char* size : {"64", "16", "40x24"})
    CHECK(isPeriodic(tiles, {"--size", size}));
  CHECK_FALSE(isPeriodic(tiles, {"--size", "16", "--periodic", "no"}));
  CHECK(isPeriodic(blobs, {"--size", "16"}));
  CHECK_FALSE(isPeriodic(blobs, {"--size", "16", "--crop", "0,0,40,64"}));
}

TEST_CASE("a file name that is not UTF-8 becomes a valid noise name") {
  const Workplace workplace;
  for (const auto& [file, name] : {std::pair{"caf\xe9", "caf_"}, {"caf\xc3\xa9", "caf\xc3\xa9"}}) {
    const std::string input = workplace.write(std::string(file) + ".png", smoothGrey(16));
    CHECK(synth(workplace, bake(workplace, input), {"--noise", name, "--size", "8"}).width == 8);
  }
}
