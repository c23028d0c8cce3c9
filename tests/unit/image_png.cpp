// SPDX-License-Identifier: MIT
// PNG in and out: every supported kind pixel by pixel, every error with its message.
#include "image_samples.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace lichen;
using namespace lichen::samples;

namespace {

constexpr std::size_t kWidthOffset = 16;
constexpr std::size_t kHeightOffset = 20;

struct Decoded {
  SrgbImage image;
  int bits = 0;
  std::vector<std::string> notes;
};

Decoded decode(const Bytes& bytes) {
  Result<ImageFile> result = decodeImage(bytes, "file");
  INFO((result ? "" : result.error().message));
  REQUIRE(result);
  ImageFile file = std::move(result).value();
  return {std::get<SrgbImage>(std::move(file.pixels)), file.bitsPerChannel, file.notes};
}

/// Checks a grey, RGB or alpha PNG without tRNS against its original codes.
void checkPixels(const Png& png) {
  const Decoded decoded = decode(makePng(png));
  const SrgbImage& image = decoded.image;
  INFO("colour type " << png.colourType << ", " << png.bitDepth << " bits, " << png.width << " x "
                      << png.height);
  REQUIRE(image.width == png.width);
  REQUIRE(image.height == png.height);
  CHECK(decoded.bits == std::max(png.bitDepth, 8));
  const auto largest = float((1u << png.bitDepth) - 1u);
  for (int y = 0; y < png.height; ++y)
    for (int x = 0; x < png.width; ++x)
      for (int c = 0; c < image.channels; ++c)
        if (image.pixel(x, y)[c] != Approx(float(pngCode(png, x, y, c)) / largest).margin(1e-7))
          FAIL("pixel (" << x << ", " << y << ") channel " << c << ": " << image.pixel(x, y)[c]);
}

} // namespace

TEST_CASE("grey PNG of every bit depth decodes exactly, interlaced or not") {
  for (const bool interlaced : {false, true})
    for (const int bitDepth : {1, 2, 4, 8, 16}) {
      checkPixels({.width = 37,
                   .height = 23,
                   .bitDepth = bitDepth,
                   .colourType = 0,
                   .interlaced = interlaced});
      checkPixels({.width = 1,
                   .height = 1,
                   .bitDepth = bitDepth,
                   .colourType = 0,
                   .interlaced = interlaced});
    }
}

TEST_CASE("colour and alpha PNG of 8 and 16 bits decodes exactly, interlaced or not") {
  for (const bool interlaced : {false, true})
    for (const int bitDepth : {8, 16})
      for (const int colourType : {2, 4, 6}) {
        checkPixels({.width = 37,
                     .height = 23,
                     .bitDepth = bitDepth,
                     .colourType = colourType,
                     .interlaced = interlaced});
        checkPixels({.width = 1,
                     .height = 300,
                     .bitDepth = bitDepth,
                     .colourType = colourType,
                     .interlaced = interlaced});
      }
}

TEST_CASE("a palette expands to RGB, with a note") {
  for (const int bitDepth : {1, 2, 4, 8}) {
    const Png png = {.width = 19, .height = 5, .bitDepth = bitDepth, .colourType = 3};
    const Decoded decoded = decode(makePng(png));
    REQUIRE(decoded.image.channels == 3);
    CHECK(decoded.bits == 8);
    CHECK(decoded.notes == std::vector<std::string>{"palette expanded to RGB"});
    for (int y = 0; y < png.height; ++y)
      for (int x = 0; x < png.width; ++x)
        for (int c = 0; c < 3; ++c)
          CHECK(decoded.image.pixel(x, y)[c] ==
                float(paletteCode(pngCode(png, x, y, 0), c)) / 255.0f);
  }
}

TEST_CASE("transparency of a palette and of a colour becomes an alpha channel, with a note") {
  const Png palette = {.colourType = 3, .transparency = true};
  const Decoded fromPalette = decode(makePng(palette));
  REQUIRE(fromPalette.image.channels == 4);
  CHECK(fromPalette.notes.back() == "transparent colour converted to an alpha channel");
  const Png grey = {.bitDepth = 2, .colourType = 0, .transparency = true};
  const Decoded fromGrey = decode(makePng(grey));
  REQUIRE(fromGrey.image.channels == 2);
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) {
      const bool listed = pngCode(palette, x, y, 0) == 1;
      CHECK(fromPalette.image.pixel(x, y)[3] == (listed ? 128.0f / 255.0f : 1.0f));
      CHECK(fromGrey.image.pixel(x, y)[1] == (pngCode(grey, x, y, 0) == 1 ? 0.0f : 1.0f));
    }
}

TEST_CASE("a note names low bit depths, and plain files have no notes") {
  CHECK(decode(makePng({.bitDepth = 1, .colourType = 0})).notes ==
        std::vector<std::string>{"1-bit grey expanded to 8 bits"});
  CHECK(decode(makePng({})).notes.empty());
}

TEST_CASE("gamma and chromaticity chunks change no pixel") {
  CHECK(decode(makePng({.colourChunks = true})).image.values == decode(makePng({})).image.values);
}

TEST_CASE("a PNG with the largest side decodes") {
  CHECK(decode(makePng({.width = kMaxImageSide, .height = 1})).image.width == kMaxImageSide);
}

TEST_CASE("each unreadable PNG gives an error that says why") {
  const Bytes plain = makePng({}), transparency = makePng({.transparency = true});
  const auto withWord = [](Bytes png, std::size_t offset, std::uint32_t value) {
    patchPngHeader(png, offset, value);
    return png;
  };
  const auto withFlip = [](Bytes png, std::size_t at) {
    png[at] ^= std::byte(1);
    return png;
  };
  const std::string limit = "; each side must be 1 to 16384";
  const std::vector<std::pair<Bytes, std::string>> files{
      {makePng({.width = kMaxImageSide + 1, .height = 1}), "16385 x 1 pixels" + limit},
      {withWord(plain, kHeightOffset, 0xffffffffu), "8 x 4294967295 pixels" + limit},
      {withWord(plain, kWidthOffset, 0), "0 x 8 pixels" + limit},
      {withWord(withWord(plain, kWidthOffset, kMaxImageSide), kHeightOffset, kMaxImageSide),
       "claims 805306368 bytes of pixels in a file of " + std::to_string(plain.size()) +
           " bytes; PNG expands at most 1032 times"},
      {withWord(plain, kHeightOffset, 9), "damaged PNG: Not enough image data"},
      {withFlip(plain, find(plain, "IDAT") + 6), "damaged PNG: IDAT: CRC error"},
      {withFlip(transparency, find(transparency, "tRNS") + 4), "damaged PNG: tRNS: CRC error"},
      {withFlip(plain, 12), "damaged PNG: the first chunk is not IHDR"},
      {withWord(plain, 24, 0x07020000), "damaged PNG: Invalid IHDR data"}}; // 7 bits
  for (const auto& [file, message] : files)
    CHECK(refusal(file) == "file: " + message);
}

TEST_CASE("a constant PNG, close to deflate's limit, decodes") {
  const Bytes png = makePng({.width = 2048, .height = 2048, .colourType = 0, .constant = true});
  CHECK(png.size() * 900 < std::size_t(2048) * 2048);
  CHECK(decode(png).image.values == std::vector<float>(std::size_t(2048) * 2048, 0.0f));
}

TEST_CASE("a message quotes a file's bytes as printable ASCII only") {
  Bytes png = makePng({});
  insertPngChunk(png, "\n\x1b[A", "");
  const std::string message = refusal(png);
  for (const char c : message)
    CHECK((c >= ' ' && c <= '~'));
}

TEST_CASE("decoding skips unknown chunks and a wrong profile") {
  Bytes png = makePng({});
  insertPngChunk(png, "liCh", std::string(1000, 'x'));
  insertPngChunk(png, "iCCP", "not a profile");
  insertPngChunk(png, "zTXt", "not compressed");
  CHECK(decode(png).image.values == decode(makePng({})).image.values);
  CHECK(decode(png).notes.empty()); // libpng would warn about chunks that it parses
}

TEST_CASE("an encoded PNG has only the chunks it needs, and decodes to the nearest codes") {
  for (const int bits : {8, 16})
    for (const int channels : {1, 2, 3, 4}) {
      SrgbImage image(13, 7, channels);
      for (std::size_t i = 0; i < image.values.size(); ++i)
        image.values[i] = float(i) / 70.0f - 0.25f; // includes values below 0 and above 1
      const Result<Bytes> png = encodePng(image, bits);
      REQUIRE(png);
      for (const char* chunk : {"gAMA", "sRGB", "iCCP", "cHRM", "tEXt", "tIME"})
        CHECK(find(png.value(), chunk) == png.value().size());
      const Decoded decoded = decode(png.value());
      REQUIRE(decoded.image.channels == channels);
      CHECK(decoded.bits == bits);
      const float largest = bits == 8 ? 255.0f : 65535.0f;
      for (std::size_t i = 0; i < image.values.size(); ++i) {
        const float wanted = std::round(std::clamp(image.values[i], 0.0f, 1.0f) * largest);
        CHECK(decoded.image.values[i] * largest == Approx(wanted).margin(0.01));
      }
      CHECK(encodePng(image, bits).value() == png.value());
    }
}

TEST_CASE("writing linear data to PNG does not convert it") {
  LinearImage data(2, 1, 1);
  data.values = {0.2f, 0.8f};
  CHECK(decode(encodePng(data, 8).value()).image.values == std::vector<float>{0.2f, 0.8f});
}

TEST_CASE("encoding an image that PNG cannot store is an error") {
  CHECK(encodePng(SrgbImage(1, 1, 1), 12).error().message ==
        "PNG: 12 bits per channel; expected 8 or 16");
  CHECK(encodePng(SrgbImage(1, 1, 5), 8).error().message == "PNG: 5 channels; expected 1 to 4");
  CHECK(encodePng(SrgbImage(0, 1, 1), 8).error().message ==
        "PNG: 0 x 1 pixels; each side must be 1 to 16384");
  SrgbImage image(2, 2, 1);
  image.values[3] = std::numeric_limits<float>::quiet_NaN();
  CHECK(encodePng(image, 8).error().message == "PNG: value 3 is nan; all values must be finite");
  image.values.pop_back();
  CHECK(encodePng(image, 8).error().message == "PNG: 3 values; the image's size requires 4");
}
