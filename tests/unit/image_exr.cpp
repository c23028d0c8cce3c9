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

/// Overwrites 4 bytes of an attribute's value, least significant first.
void patchAttribute(Bytes& exr, const std::string& nameAndType, std::size_t offset,
                    std::uint32_t value) {
  constexpr std::size_t kSizeBytes = 4;
  const std::size_t at = find(exr, nameAndType) + nameAndType.size() + kSizeBytes + offset;
  REQUIRE(at + 4 <= exr.size());
  for (std::size_t i = 0; i < 4; ++i)
    exr[at + i] = std::byte(value >> (8 * i));
}

const std::string kDataWindow("dataWindow\0box2i\0", 17);
const std::string kTiles("tiles\0tiledesc\0", 15);

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

TEST_CASE("the error for NaN and infinite EXR values states their position") {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  Exr exr = {.hasOddValue = true, .oddValue = std::numeric_limits<float>::quiet_NaN()};
  CHECK(refusal(makeExr(exr)) ==
        "file: NaN in channel R of pixel (0, 0); all values must be finite");
  for (const float value : {kInfinity, -kInfinity}) {
    exr.oddValue = value;
    CHECK(refusal(makeExr(exr)) ==
          "file: infinity in channel R of pixel (0, 0); all values must be finite");
  }
}

TEST_CASE("the errors for multi-part, deep and luminance-chroma EXR name the kind") {
  CHECK(refusal(makeMultiPartExr()) == "file: is a multi-part EXR; expected a single-part file");
  CHECK(refusal(makeDeepExr()) ==
        "file: is a deep EXR; expected a flat file (scan lines or tiles)");
  CHECK(refusal(makeLuminanceChromaExr()) ==
        "file: is a luminance-chroma EXR (channels BY, RY, Y); expected R, G, B, or Y alone");
}

TEST_CASE("the errors for unsupported EXR channels name them") {
  CHECK(refusal(makeExr({.channels = {{"N.X"}, {"Z"}}})) ==
        "file: EXR with channels N.X, Z; expected R, G, B, or Y, or a single channel");
  CHECK(refusal(makeExr({.channels = {{"B"}, {"G"}, {"R", kHalf, 2}}})) ==
        "file: EXR channel R is subsampled 2 x 2; expected 1 x 1");
}

TEST_CASE("an EXR with a side of 0 or over the limit is an error") {
  Bytes exr = makeExr({});
  patchAttribute(exr, kDataWindow, 8, std::uint32_t(-1));
  CHECK(refusal(exr) == "file: damaged EXR: Invalid data window (0, 0 - -1, 7)");
  patchAttribute(exr, kDataWindow, 8, 16384);
  CHECK(refusal(exr) == "file: 16385 x 8 pixels; each side must be 1 to 16384");
  patchAttribute(exr, kDataWindow, 0, 0x80000000u);
  patchAttribute(exr, kDataWindow, 8, 0x7fffffffu);
  CHECK(refusal(exr) == "file: damaged EXR: Invalid data window (-2147483648, 0 - 2147483647, 7)");
}

TEST_CASE("an EXR that claims more than its compression can produce is an error before decoding") {
  Bytes wide = makeExr({});
  patchAttribute(wide, kDataWindow, 8, 16383);
  CHECK(refusal(wide).starts_with("file: claims 786432 bytes of pixels in a file of "));
  CHECK(refusal(wide).ends_with("; EXR's ZIP expands at most 1032 times"));
  Bytes tall = makeExr({.compression = 0});
  patchAttribute(tall, kDataWindow, 12, 16383);
  CHECK(refusal(tall).starts_with(
      "file: truncated or damaged EXR: chunk table size (131072) too big for file size "));
}

TEST_CASE("EXR tiles far larger than the image are an error") {
  Bytes exr = makeExr({.tileSide = 4});
  patchAttribute(exr, kTiles, 0, 5000);
  CHECK(refusal(exr) ==
        "file: EXR tiles of 5000 x 4; each side must be at most 4096, or the image's own");
  patchAttribute(exr, kTiles, 0, 0);
  CHECK(refusal(exr) == "file: damaged EXR: Invalid tile description size (0 x 4)");
}

TEST_CASE("EXR attributes with a wrong size are an error") {
  const std::string sizeOfWindow = std::string("dataWindow\0box2i\0", 17);
  Bytes longer = makeExr({});
  longer[find(longer, sizeOfWindow) + sizeOfWindow.size()] = std::byte(20);
  CHECK(refusal(longer) ==
        "file: damaged EXR: Attribute 'dataWindow': Invalid size 20 (exp 'box2i' size 4 * 4 (16))");
  Bytes channels = makeExr({});
  channels[find(channels, std::string("chlist\0", 7)) + 7] ^= std::byte(2);
  CHECK(refusal(channels) == "file: damaged EXR: Out of data parsing 'channels', last channel 'R'");
}

TEST_CASE("the error for a missing EXR attribute without a default names it") {
  for (const std::string attribute : {"channels", "tiles"}) {
    Bytes exr = makeExr({.tileSide = 4});
    exr[find(exr, attribute)] = std::byte('x'); // an unknown attribute with a known type
    CHECK(refusal(exr).starts_with("file: damaged EXR: '" + attribute + "' attribute "));
    CHECK(refusal(exr).ends_with(" not found"));
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
  for (const std::string attribute : {"dataWindow", "compression"}) { // the library has defaults
    Bytes incomplete = makeExr(exr);
    incomplete[find(incomplete, attribute)] = std::byte('x');
    CHECK(refusal(incomplete).starts_with("file: damaged EXR: "));
  }
}

TEST_CASE("an unknown EXR version or compression is an error") {
  Bytes version = makeExr({});
  version[4] = std::byte(3);
  CHECK(refusal(version).starts_with("file: damaged EXR: File is of an unsupported version: 3,"));
  Bytes compression = makeExr({});
  const std::string attribute("compression\0compression\0", 24);
  compression[find(compression, attribute) + attribute.size() + 4] = std::byte(10);
  CHECK(refusal(compression) == "file: damaged EXR: Attribute 'compression' (type 'compression'): "
                                "Invalid value 10 (max allowed 10)");
}

TEST_CASE("an EXR whose writer was interrupted is an error") {
  Bytes exr = makeExr({.compression = 0});
  // The table of 8 chunk offsets ends where the first chunk starts: 4 bytes y, 4 bytes size.
  const std::size_t chunkBytes = 8 + 8 * 3 * 2;
  const std::size_t tableEnd = exr.size() - 8 * chunkBytes;
  std::fill_n(exr.begin() + std::ptrdiff_t(tableEnd) - 8, 8, std::byte(0));
  CHECK(refusal(exr) == "file: truncated or damaged EXR: Corrupt chunk offset table: scanline 7, "
                        "chunk index 7 recorded at file offset 0");
}

TEST_CASE("an EXR chunk with more or fewer bytes than its pixels need is an error") {
  // The last chunk of an uncompressed file: 4 bytes y, 4 bytes size, 8 pixels of 3 halves.
  Bytes exr = makeExr({.compression = 0});
  const std::size_t sizeOffset = exr.size() - 8 * 3 * 2 - 4;
  exr[sizeOffset] = std::byte(49);
  exr.push_back(std::byte(0));
  CHECK(refusal(exr).ends_with("packed data size says 49, must be between 0 and 48"));
  exr[sizeOffset] = std::byte(0);
  CHECK(refusal(exr) == "file: truncated or damaged EXR: Invalid packed size of 0");
  exr[sizeOffset] = std::byte(47);
  CHECK(refusal(exr) ==
        "file: claims 48 bytes of pixels in a file of 47 bytes; uncompressed EXR expands "
        "at most 1 time");
}

TEST_CASE("damaged EXR pixels are an error") {
  Bytes exr = makeExr({.width = 64, .height = 64});
  for (std::size_t i = exr.size() - 40; i < exr.size(); ++i)
    exr[i] = std::byte(0x55);
  CHECK(refusal(exr).starts_with("file: damaged EXR: "));
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
