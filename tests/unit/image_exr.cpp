// SPDX-License-Identifier: MIT
// EXR in and out: every supported kind pixel by pixel, every error with its message.
#include "image_samples.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace lichen;
using namespace lichen::samples;

namespace {

using Notes = std::vector<std::string>;

struct Decoded {
  LinearImage image;
  Notes notes;
};

Decoded decode(const Bytes& bytes) {
  Result<ImageFile> result = decodeImage(bytes, "file");
  INFO((result ? "" : result.error().message));
  REQUIRE(result);
  ImageFile file = std::move(result).value();
  CHECK(file.bitsPerChannel == 32);
  return {std::get<LinearImage>(std::move(file.pixels)), file.notes};
}

/// Checks that channel c of the image is channel source[c] of the sample; -1 means zeros.
void checkPixels(const Decoded& decoded, const Exr& exr, const std::vector<int>& source) {
  const LinearImage& image = decoded.image;
  REQUIRE(image.width == exr.width);
  REQUIRE(image.height == exr.height);
  REQUIRE(std::size_t(image.channels) == source.size());
  for (int y = 0; y < exr.height; ++y)
    for (int x = 0; x < exr.width; ++x)
      for (int c = 0; c < image.channels; ++c) {
        const int from = source[std::size_t(c)];
        if (image.pixel(x, y)[c] != (from < 0 ? 0.0f : exrValue(x, y, from)))
          FAIL("pixel (" << x << ", " << y << ") channel " << c << ": " << image.pixel(x, y)[c]);
      }
}

constexpr int kUint = 0;
constexpr int kHalf = 1;
constexpr int kFloat = 2;

/// With 4 bytes of an attribute's value overwritten, least significant first.
Bytes withWord(Bytes exr, const std::string& nameAndType, std::size_t offset, std::uint32_t value) {
  constexpr std::size_t kSizeBytes = 4;
  const std::size_t at = find(exr, nameAndType) + nameAndType.size() + kSizeBytes + offset;
  REQUIRE(at + 4 <= exr.size());
  for (std::size_t i = 0; i < 4; ++i)
    exr[at + i] = std::byte(value >> (8 * i));
  return exr;
}

const std::string kDataWindow("dataWindow\0box2i\0", 17);
const std::string kTiles("tiles\0tiledesc\0", 15);
const std::string kCompression("compression\0compression\0", 24);

} // namespace

TEST_CASE("half, float and unsigned EXR is read exactly under every lossless compression") {
  for (const int compression : {0, 1, 2, 3, 4})
    for (const int type : {kUint, kHalf, kFloat})
      for (const int tileSide : {0, 16})
        for (const bool decreasingY : {false, true}) {
          const Exr exr = {.width = 37,
                           .height = 41,
                           .channels = {{"R", type}, {"G", type}, {"B", type}, {"A", type}},
                           .compression = compression,
                           .tileSide = tileSide,
                           .decreasingY = decreasingY};
          const Decoded decoded = decode(makeExr(exr));
          checkPixels(decoded, exr, {0, 1, 2, 3});
          CHECK(decoded.notes.empty());
        }
}

TEST_CASE("EXR of the lossy compressions is read") {
  for (const int compression : {5, 6, 7, 8, 9}) {
    const Exr exr = {.width = 37, .height = 41, .compression = compression};
    const Decoded decoded = decode(makeExr(exr));
    REQUIRE(decoded.image.channels == 3);
    double error = 0;
    for (int y = 0; y < exr.height; ++y)
      for (int x = 0; x < exr.width; ++x)
        for (int c = 0; c < 3; ++c)
          error += std::abs(double(decoded.image.pixel(x, y)[c] - exrValue(x, y, c)));
    CHECK(error / double(decoded.image.values.size()) < 1.0); // for values up to 63
  }
}

TEST_CASE("EXR of 1 x 1 and 1 x N is read") {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 300}, {300, 1}})
    for (const int tileSide : {0, 32}) {
      const Exr exr = {.width = width, .height = height, .tileSide = tileSide};
      checkPixels(decode(makeExr(exr)), exr, {0, 1, 2});
    }
}

TEST_CASE("reading a mip-mapped EXR gives its full resolution") {
  const Exr exr = {.width = 50, .height = 33, .tileSide = 16, .mipMapped = true};
  checkPixels(decode(makeExr(exr)), exr, {0, 1, 2});
}

TEST_CASE("the data window is the image, with a note if it differs from the display window") {
  Exr exr = {.width = 20, .height = 30, .xMin = -7, .yMin = 1000};
  const Decoded decoded = decode(makeExr(exr));
  checkPixels(decoded, exr, {0, 1, 2});
  CHECK(decoded.notes.empty());
  exr.wideDisplay = true;
  exr.tileSide = 8;
  const Decoded part = decode(makeExr(exr));
  checkPixels(part, exr, {0, 1, 2});
  CHECK(part.notes == Notes{"the image is the data window, not the display window"});
}

TEST_CASE("names select the channels, and notes list missing and ignored ones") {
  Exr exr = {.channels = {{"Y"}}};
  Decoded decoded = decode(makeExr(exr));
  checkPixels(decoded, exr, {0});
  CHECK(decoded.notes.empty());

  exr.channels = {{"A"}, {"Y", kFloat}};
  checkPixels(decode(makeExr(exr)), exr, {1, 0});

  exr.channels = {{"R"}, {"B"}};
  decoded = decode(makeExr(exr));
  checkPixels(decoded, exr, {0, -1, 1});
  CHECK(decoded.notes == Notes{"missing channels set to 0: G"});

  exr.channels = {{"G", kFloat}};
  decoded = decode(makeExr(exr));
  checkPixels(decoded, exr, {-1, 0, -1});
  CHECK(decoded.notes == Notes{"missing channels set to 0: R, B"});

  exr.channels = {{"height"}};
  decoded = decode(makeExr(exr));
  checkPixels(decoded, exr, {0});
  CHECK(decoded.notes == Notes{"channel height read as grey"});

  exr.channels = {{"B"}, {"G"}, {"R"}, {"Z", kFloat, 2}, {"diffuse.R"}};
  decoded = decode(makeExr(exr));
  checkPixels(decoded, exr, {2, 1, 0});
  CHECK(decoded.notes == Notes{"ignored channels: Z, diffuse.R"});
}

TEST_CASE("negative EXR values become 0, with a note") {
  for (const float value : {-2.5f, -0x1p-20f}) {
    Exr exr = {.hasOddValue = true, .oddValue = value};
    const Decoded decoded = decode(makeExr(exr));
    CHECK(decoded.image.values[0] == 0.0f);
    CHECK(decoded.notes == Notes{"1 negative value set to 0"});
  }
}

TEST_CASE("each unreadable EXR gives an error that says why") {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const auto withValue = [](float value) {
    return makeExr({.hasOddValue = true, .oddValue = value});
  };
  const auto withByte = [](Bytes exr, std::size_t at, int value) {
    exr[at] = std::byte(value);
    return exr;
  };
  const auto without = [&](const std::string& attribute) { // an unknown one with a known type
    const Bytes exr = makeExr({.tileSide = 4});
    return withByte(exr, find(exr, attribute), 'x');
  };
  const Bytes plain = makeExr({}), tiled = makeExr({.tileSide = 4});
  const std::size_t channelsSize = find(plain, std::string("chlist\0", 7)) + 7;
  // Ends with 8 chunks: 4 bytes y, 4 bytes size, 8 pixels of 3 halves. Their offsets are before.
  const Bytes flat = makeExr({.compression = 0});
  const std::size_t chunkBytes = 8 + 8 * 3 * 2, sizeAt = flat.size() - chunkBytes + 4;
  Bytes longer = withByte(flat, sizeAt, 49), interrupted = flat;
  longer.push_back(std::byte(0));
  std::fill_n(interrupted.end() - std::ptrdiff_t(8 * chunkBytes) - 8, 8, std::byte(0));
  Bytes damaged = makeExr({.width = 64, .height = 64});
  std::fill_n(damaged.end() - 40, 40, std::byte(0x55));
  const std::vector<std::pair<Bytes, std::string>> files{
      {withValue(std::numeric_limits<float>::quiet_NaN()),
       "NaN in channel R of pixel (0, 0); all values must be finite"},
      {withValue(kInfinity), "infinity in channel R of pixel (0, 0); all values must be finite"},
      {withValue(-kInfinity), "infinity in channel R of pixel (0, 0); all values must be finite"},
      {makeMultiPartExr(), "is a multi-part EXR; expected a single-part file"},
      {makeDeepExr(), "is a deep EXR; expected a flat file (scan lines or tiles)"},
      {makeLuminanceChromaExr(),
       "is a luminance-chroma EXR (channels BY, RY, Y); expected R, G, B, or Y alone"},
      {makeExr({.channels = {{"N.X"}, {"Z"}}}),
       "EXR with channels N.X, Z; expected R, G, B, or Y, or a single channel"},
      {makeExr({.channels = {{"B"}, {"G"}, {"R", kHalf, 2}}}),
       "EXR channel R is subsampled 2 x 2; expected 1 x 1"},
      {withWord(plain, kDataWindow, 8, std::uint32_t(-1)),
       "damaged EXR: Invalid data window (0, 0 - -1, 7)"},
      {withWord(plain, kDataWindow, 8, 16384), "16385 x 8 pixels; each side must be 1 to 16384"},
      {withWord(withWord(plain, kDataWindow, 0, 0x80000000u), kDataWindow, 8, 0x7fffffffu),
       "damaged EXR: Invalid data window (-2147483648, 0 - 2147483647, 7)"},
      {withWord(plain, kDataWindow, 8, 16383),
       "claims 786432 bytes of pixels in a file of ~; EXR's ZIP expands at most 1032 times"},
      {withWord(flat, kDataWindow, 12, 16383),
       "truncated or damaged EXR: chunk table size (131072) too big for file size ~"},
      {withWord(tiled, kTiles, 0, 5000),
       "EXR tiles of 5000 x 4; each side must be at most 4096, or the image's own"},
      {withWord(tiled, kTiles, 0, 0), "damaged EXR: Invalid tile description size (0 x 4)"},
      {withByte(plain, find(plain, kDataWindow) + kDataWindow.size(), 20),
       "damaged EXR: Attribute 'dataWindow': Invalid size 20 (exp 'box2i' size 4 * 4 (16))"},
      {withByte(plain, channelsSize, std::to_integer<int>(plain[channelsSize]) ^ 2),
       "damaged EXR: Out of data parsing 'channels', last channel 'R'"},
      {without("channels"), "damaged EXR: 'channels' attribute ~ not found"},
      {without("tiles"), "damaged EXR: 'tiles' attribute ~ not found"},
      {without("dataWindow"), "damaged EXR: ~"}, // these two have defaults in the library
      {without("compression"), "damaged EXR: ~"},
      {withByte(plain, 4, 3), "damaged EXR: File is of an unsupported version: 3,~"},
      {withByte(plain, find(plain, kCompression) + kCompression.size() + 4, 10),
       "damaged EXR: Attribute 'compression' (type 'compression'): Invalid value 10 (max allowed "
       "10)"},
      {interrupted, "truncated or damaged EXR: Corrupt chunk offset table: scanline 7, chunk index "
                    "7 recorded at file offset 0"},
      {longer, "~packed data size says 49, must be between 0 and 48"},
      {withByte(longer, sizeAt, 0), "truncated or damaged EXR: Invalid packed size of 0"},
      {withByte(longer, sizeAt, 47), "claims 48 bytes of pixels in a file of 47 bytes; "
                                     "uncompressed EXR expands at most 1 time"},
      {damaged, "damaged EXR: ~"}};
  for (const auto& [file, wanted] : files) {
    const std::string message = refusal(file);
    INFO(message << "; expected " << wanted);
    const std::size_t gap = wanted.find('~');
    CHECK(message.starts_with("file: " + wanted.substr(0, gap)));
    CHECK(message.ends_with(gap < wanted.size() ? wanted.substr(gap + 1) : "file: " + wanted));
  }
}

TEST_CASE("an EXR without attributes that have a default is read, as other programs do") {
  const Exr exr = {.width = 64, .height = 64, .tileSide = 16};
  Bytes bytes = makeExr(exr);
  for (const std::string attribute : {"lineOrder", "pixelAspectRatio", "screenWindowCenter",
                                      "screenWindowWidth", "displayWindow"}) {
    bytes[find(bytes, attribute)] = std::byte('x');
    const Decoded decoded = decode(bytes);
    checkPixels(decoded, exr, {0, 1, 2});
    CHECK(decoded.notes.empty());
  }
}

TEST_CASE("an encoded EXR with 1 to 4 channels decodes to the values rounded to half") {
  for (const int channels : {1, 2, 3, 4}) {
    LinearImage image(13, 27, channels);
    for (std::size_t i = 0; i < image.values.size(); ++i)
      image.values[i] = float(i) * 0.37f;
    image.values[0] = 1e9f; // above the largest half
    const Result<Bytes> exr = encodeExr(image);
    REQUIRE(exr);
    const Decoded decoded = decode(exr.value());
    REQUIRE(decoded.image.channels == channels);
    CHECK(decoded.notes.empty());
    CHECK(decoded.image.values[0] == 65504.0f);
    for (std::size_t i = 1; i < image.values.size(); ++i) // half has 11 bits
      CHECK(decoded.image.values[i] == Approx(image.values[i]).epsilon(1.0 / 2048));
    CHECK(encodeExr(image).value() == exr.value());
  }
}

TEST_CASE("encoding an image that EXR cannot store is an error") {
  CHECK(encodeExr(LinearImage(1, 1, 0)).error().message == "EXR: 0 channels; expected 1 to 4");
  LinearImage image(1, 1, 1);
  image.values[0] = std::numeric_limits<float>::infinity();
  CHECK(encodeExr(image).error().message == "EXR: value 0 is inf; all values must be finite");
}
