// SPDX-License-Identifier: MIT
// JPEG in: every accepted kind, every refused one with its message.
#include "image_samples.h"

#include <catch2/catch.hpp>

using namespace lichen;
using namespace lichen::samples;

namespace {

// One code for the rounding of YCbCr, one for that of the transform.
constexpr double kCodeTolerance = 2.0 / 255.0;

ImageFile decode(const Bytes& bytes) {
  Result<ImageFile> result = decodeImage(bytes, "file");
  INFO((result ? "" : result.error().message));
  REQUIRE(result);
  return std::move(result).value();
}

void checkConstant(const ImageFile& file, const std::vector<double>& wanted) {
  const SrgbImage& image = std::get<SrgbImage>(file.pixels);
  REQUIRE(std::size_t(image.channels) == wanted.size());
  CHECK(file.bitsPerChannel == 8);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    CHECK(double(image.values[i]) == Approx(wanted[i % wanted.size()]).margin(kCodeTolerance));
}

/// Overwrites the sides in the frame header.
void patchSides(Bytes& jpeg, unsigned width, unsigned height) {
  const std::size_t frame = find(jpeg, "\xff\xc0");
  REQUIRE(frame < jpeg.size());
  jpeg[frame + 5] = std::byte(height >> 8);
  jpeg[frame + 6] = std::byte(height);
  jpeg[frame + 7] = std::byte(width >> 8);
  jpeg[frame + 8] = std::byte(width);
}

} // namespace

TEST_CASE("grey and colour JPEG is read, baseline and progressive, of any size") {
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
  // 255 means no ink: the light left is the product of what each ink and black let through.
  const std::vector<double> wanted = {200.0 * 220 / 65025, 100.0 * 220 / 65025, 50.0 * 220 / 65025};
  for (const JpegColour colour : {JpegColour::cmyk, JpegColour::ycck}) {
    const ImageFile file = decode(makeJpeg({.colour = colour}));
    checkConstant(file, wanted);
    CHECK(file.notes == std::vector<std::string>{"CMYK converted to RGB without a colour profile"});
  }
}

TEST_CASE("CMYK without Adobe's marker has 255 for full ink") {
  checkConstant(decode(makeJpeg({.colour = JpegColour::cmyk, .adobeMarker = false})),
                {55.0 * 35 / 65025, 155.0 * 35 / 65025, 205.0 * 35 / 65025});
}

TEST_CASE("a JPEG with a side of 0 or over the limit is refused") {
  Bytes jpeg = makeJpeg({});
  patchSides(jpeg, 0, 16);
  CHECK(refusal(jpeg) == "file: 0 x 16 pixels; 1 to 16384 on a side are accepted");
  patchSides(jpeg, 16, 16385);
  CHECK(refusal(jpeg) == "file: 16 x 16385 pixels; 1 to 16384 on a side are accepted");
  patchSides(jpeg, 65535, 65535);
  CHECK(refusal(jpeg) == "file: 65535 x 65535 pixels; 1 to 16384 on a side are accepted");
}

TEST_CASE("a JPEG that claims more pixels than its bits can code is refused") {
  Bytes jpeg = makeJpeg({});
  patchSides(jpeg, 16384, 16384);
  CHECK(refusal(jpeg) == "file: claims 268435456 bytes of pixels in a file of " +
                             std::to_string(jpeg.size()) + "; JPEG expands at most 1024 times");
}

TEST_CASE("a JPEG whose scan stops early is refused, though it has an end marker") {
  Bytes jpeg = makeJpeg({});
  patchSides(jpeg, 16, 64);
  CHECK(refusal(jpeg) == "file: truncated: the JPEG ends before its pixels or its end marker");
}

TEST_CASE("a JPEG that lacks only its end marker is refused, though its pixels are there") {
  // Whether the decoder of pixels runs into the end depends on how the last bits fall.
  for (int code = 0; code < 256; ++code) {
    Bytes jpeg = makeJpeg({.width = 8,
                           .height = 8 + code % 64,
                           .colour = JpegColour::grey,
                           .codes = {static_cast<unsigned char>(code)}});
    jpeg.resize(jpeg.size() - 2);
    CHECK(refusal(jpeg) == "file: truncated: the JPEG ends before its pixels or its end marker");
  }
}

TEST_CASE("arithmetic-coded, 2-component and 12-bit JPEG are refused by name") {
  CHECK(refusal(makeJpeg({.arithmetic = true})) ==
        "file: arithmetic-coded JPEG; Huffman-coded files are accepted");
  Bytes deep = makeJpeg({});
  deep[find(deep, "\xff\xc0") + 4] = std::byte(12);
  CHECK(refusal(deep) == "file: damaged or unsupported JPEG: Unsupported JPEG data precision 12; "
                         "baseline and progressive 8-bit files are accepted");
}

TEST_CASE("a damaged JPEG is refused") {
  Bytes tables = makeJpeg({});
  tables[find(tables, "\xff\xc4") + 4] = std::byte(0x77); // no class of Huffman table
  CHECK(refusal(tables) == "file: damaged or unsupported JPEG: Bogus DHT index 103; "
                           "baseline and progressive 8-bit files are accepted");
}

TEST_CASE("a progressive JPEG of very many scans is refused instead of decoded for minutes") {
  CHECK(refusal(makeJpeg({.colour = JpegColour::grey, .scanPerCoefficient = true})) ==
        "file: progressive JPEG of more than 64 scans; 64 are accepted");
}

TEST_CASE("an unknown JFIF version is accepted with a note") {
  Bytes jpeg = makeJpeg({});
  jpeg[find(jpeg, "JFIF") + 5] = std::byte(7);
  CHECK(decode(jpeg).notes ==
        std::vector<std::string>{"libjpeg warns: Warning: unknown JFIF revision number 7.01"});
}
