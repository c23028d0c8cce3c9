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

TEST_CASE("each unreadable JPEG gives an error that says why") {
  const Bytes plain = makeJpeg({});
  const auto withSides = [&](unsigned width, unsigned height) {
    Bytes jpeg = plain;
    patchSides(jpeg, width, height);
    return jpeg;
  };
  const auto withByte = [&](const char* marker, int value) {
    Bytes jpeg = plain;
    jpeg[find(jpeg, marker) + 4] = std::byte(value);
    return jpeg;
  };
  const std::string limit = "; each side must be 1 to 16384";
  const std::string unsupported = "damaged or unsupported JPEG: ";
  const std::string expected = "; expected a baseline or progressive 8-bit file";
  const std::vector<std::pair<Bytes, std::string>> files{
      {withSides(0, 16), "0 x 16 pixels" + limit},
      {withSides(16, 16385), "16 x 16385 pixels" + limit},
      {withSides(65535, 65535), "65535 x 65535 pixels" + limit},
      {withSides(16384, 16384), "claims 268435456 bytes of pixels in a file of " +
                                    std::to_string(plain.size()) +
                                    " bytes; JPEG expands at most 1024 times"},
      {withSides(16, 64), // its scan ends early, with an end marker
       "truncated: the JPEG ends before its last pixel or its end marker"},
      {makeJpeg({.arithmetic = true}), "is an arithmetic-coded JPEG; expected Huffman coding"},
      {withByte("\xff\xc0", 12), unsupported + "Unsupported JPEG data precision 12" + expected},
      {withByte("\xff\xc4", 0x77), unsupported + "Bogus DHT index 103" + expected},
      {makeJpeg({.colour = JpegColour::grey, .scanPerCoefficient = true}), // minutes to decode
       "is a progressive JPEG with more than 64 scans; re-encode it with fewer"}};
  for (const auto& [file, message] : files)
    CHECK(refusal(file) == "file: " + message);
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

TEST_CASE("an unknown JFIF version decodes with a note") {
  Bytes jpeg = makeJpeg({});
  jpeg[find(jpeg, "JFIF") + 5] = std::byte(7);
  CHECK(
      decode(jpeg).notes ==
      std::vector<std::string>{"warning from libjpeg: Warning: unknown JFIF revision number 7.01"});
}
