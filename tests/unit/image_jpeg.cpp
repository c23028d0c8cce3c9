// SPDX-License-Identifier: MIT
// JPEG in: every supported kind, every error with its message.
#include "image_samples.h"

#include <catch2/catch.hpp>

using namespace lichen;
using namespace lichen::samples;

namespace {

// One code for rounding YCbCr, one for rounding the transform.
constexpr double kCodeTolerance = 2.0 / 255.0;

ImageFile decode(const Bytes& bytes) {
  Result<ImageFile> result = decodeImage(bytes, "file");
  INFO((result ? "" : result.error().message));
  REQUIRE(result);
  return std::move(result).value();
}

void checkConstant(const ImageFile& file, const std::vector<double>& expected) {
  const SrgbImage& image = std::get<SrgbImage>(file.pixels);
  REQUIRE(std::size_t(image.channels) == expected.size());
  CHECK(file.bitsPerChannel == 8);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    CHECK(double(image.values[i]) == Approx(expected[i % expected.size()]).margin(kCodeTolerance));
}

/// Overwrites width and height in the frame header.
void patchSides(Bytes& jpeg, unsigned width, unsigned height) {
  const std::size_t frame = find(jpeg, "\xff\xc0");
  REQUIRE(frame < jpeg.size());
  jpeg[frame + 5] = std::byte(height >> 8);
  jpeg[frame + 6] = std::byte(height);
  jpeg[frame + 7] = std::byte(width >> 8);
  jpeg[frame + 8] = std::byte(width);
}

} // namespace

TEST_CASE("grey and colour JPEG of any size decode, baseline and progressive") {
  for (const bool progressive : {false, true})
    for (const auto& [width, height] : {std::pair(16, 16), {1, 1}, {1, 100}, {37, 23}}) {
      const ImageFile grey = decode(makeJpeg({.width = width,
                                              .height = height,
                                              .colour = JpegColour::grey,
                                              .progressive = progressive}));
      checkConstant(grey, {200.0 / 255});
      CHECK(grey.notes.empty());
      const ImageFile colour =
          decode(makeJpeg({.width = width, .height = height, .progressive = progressive}));
      checkConstant(colour, {200.0 / 255, 100.0 / 255, 50.0 / 255});
      CHECK(std::get<SrgbImage>(colour.pixels).width == width);
      CHECK(std::get<SrgbImage>(colour.pixels).height == height);
    }
}

TEST_CASE("Adobe's inverted CMYK and YCCK become RGB, with a note") {
  // 255 means no ink: the light is the product of what each ink and black transmit.
  const std::vector<double> expected = {200.0 * 220 / 65025, 100.0 * 220 / 65025,
                                        50.0 * 220 / 65025};
  for (const JpegColour colour : {JpegColour::cmyk, JpegColour::ycck}) {
    const ImageFile file = decode(makeJpeg({.colour = colour}));
    checkConstant(file, expected);
    CHECK(file.notes == std::vector<std::string>{"CMYK converted to RGB without a colour profile"});
  }
}

TEST_CASE("CMYK without Adobe's marker has 255 for full ink") {
  checkConstant(decode(makeJpeg({.colour = JpegColour::cmyk, .adobeMarker = false})),
                {55.0 * 35 / 65025, 155.0 * 35 / 65025, 205.0 * 35 / 65025});
}

TEST_CASE("a JPEG with a side of 0 or over the limit is an error") {
  Bytes jpeg = makeJpeg({});
  patchSides(jpeg, 0, 16);
  CHECK(refusal(jpeg) == "file: 0 x 16 pixels; each side must be 1 to 16384");
  patchSides(jpeg, 16, 16385);
  CHECK(refusal(jpeg) == "file: 16 x 16385 pixels; each side must be 1 to 16384");
  patchSides(jpeg, 65535, 65535);
  CHECK(refusal(jpeg) == "file: 65535 x 65535 pixels; each side must be 1 to 16384");
}

TEST_CASE("a JPEG that claims more pixels than its bits can encode is an error") {
  Bytes jpeg = makeJpeg({});
  patchSides(jpeg, 16384, 16384);
  CHECK(refusal(jpeg) == "file: claims 268435456 bytes of pixels in a file of " +
                             std::to_string(jpeg.size()) +
                             " bytes; JPEG expands at most 1024 times");
}

TEST_CASE("a JPEG whose scan ends early is an error, even with an end marker") {
  Bytes jpeg = makeJpeg({});
  patchSides(jpeg, 16, 64);
  CHECK(refusal(jpeg) == "file: truncated: the JPEG ends before its last pixel or its end marker");
}

TEST_CASE("a JPEG without only its end marker is an error") {
  // Whether the pixel decoder reaches the end depends on the last bits.
  for (int code = 0; code < 256; ++code) {
    Bytes jpeg = makeJpeg({.width = 8,
                           .height = 8 + code % 64,
                           .colour = JpegColour::grey,
                           .codes = {static_cast<unsigned char>(code)}});
    jpeg.resize(jpeg.size() - 2);
    CHECK(refusal(jpeg) ==
          "file: truncated: the JPEG ends before its last pixel or its end marker");
  }
}

TEST_CASE("the errors for arithmetic-coded, 2-component and 12-bit JPEG name the kind") {
  CHECK(refusal(makeJpeg({.arithmetic = true})) ==
        "file: is an arithmetic-coded JPEG; expected Huffman coding");
  Bytes deep = makeJpeg({});
  deep[find(deep, "\xff\xc0") + 4] = std::byte(12);
  CHECK(refusal(deep) == "file: damaged or unsupported JPEG: Unsupported JPEG data precision 12; "
                         "expected a baseline or progressive 8-bit file");
}

TEST_CASE("a damaged JPEG is an error") {
  Bytes tables = makeJpeg({});
  tables[find(tables, "\xff\xc4") + 4] = std::byte(0x77); // not a class of Huffman table
  CHECK(refusal(tables) == "file: damaged or unsupported JPEG: Bogus DHT index 103; "
                           "expected a baseline or progressive 8-bit file");
}

TEST_CASE("a progressive JPEG with very many scans is an error instead of decoding for minutes") {
  CHECK(refusal(makeJpeg({.colour = JpegColour::grey, .scanPerCoefficient = true})) ==
        "file: is a progressive JPEG with more than 64 scans; re-encode it with fewer");
}

TEST_CASE("an unknown JFIF version decodes with a note") {
  Bytes jpeg = makeJpeg({});
  jpeg[find(jpeg, "JFIF") + 5] = std::byte(7);
  CHECK(
      decode(jpeg).notes ==
      std::vector<std::string>{"warning from libjpeg: Warning: unknown JFIF revision number 7.01"});
}
