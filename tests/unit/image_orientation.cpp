// SPDX-License-Identifier: MIT
// EXIF orientation of PNG and JPEG: the position of every pixel, according to the drawings of the
// specification, and EXIF blocks without an orientation.
#include "image_samples.h"

#include <catch2/catch.hpp>

#include <fstream>
#include <temporary_folder.h>

using namespace lichen;
using namespace lichen::samples;

namespace {

/// Writes the bytes to a file and reads it.
ImageFile read(const Bytes& bytes) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "file", std::ios::binary)
      .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  Result<ImageFile> result = readImage(folder.path() / "file");
  INFO((result ? "" : result.error().message));
  REQUIRE(result);
  return std::move(result).value();
}

const SrgbImage& pixelsOf(const ImageFile& file) { return std::get<SrgbImage>(file.pixels); }

std::vector<std::string> orientationNote(int orientation) {
  return {"rotated or mirrored according to its EXIF orientation " + std::to_string(orientation)};
}

/// Spells a grey PNG of 3 x 2 pixels, stored as the rows "abc" and "def", row by row.
std::vector<std::string> spelled(const ImageFile& file) {
  constexpr Png kPng{.width = 3, .height = 2, .colourType = 0};
  const SrgbImage& image = pixelsOf(file);
  std::vector<std::string> rows;
  for (int y = 0; y < image.height; ++y) {
    rows.emplace_back();
    for (int x = 0; x < image.width; ++x)
      for (int i = 0; i < 6; ++i)
        if (image.pixel(x, y)[0] == Approx(float(pngCode(kPng, i % 3, i / 3, 0)) / 255.0f))
          rows.back() += char('a' + i);
  }
  return rows;
}

Bytes pngWithExif(const std::string& block) {
  Bytes png = makePng({.width = 3, .height = 2, .colourType = 0});
  insertPngChunk(png, "eXIf", block);
  return png;
}

} // namespace

TEST_CASE("each of the eight orientations moves every pixel to its position") {
  // Drawn by hand from Exif 2.32, which names the sides of the first stored row and column. For 6,
  // row 0 is the right-hand side and column 0 the top.
  const std::vector<std::vector<std::string>> drawn{{"abc", "def"},      // 1: top, left
                                                    {"cba", "fed"},      // 2: top, right
                                                    {"fed", "cba"},      // 3: bottom, right
                                                    {"def", "abc"},      // 4: bottom, left
                                                    {"ad", "be", "cf"},  // 5: left, top
                                                    {"da", "eb", "fc"},  // 6: right, top
                                                    {"fc", "eb", "da"},  // 7: right, bottom
                                                    {"cf", "be", "ad"}}; // 8: left, bottom
  for (const bool bigEndian : {false, true})
    for (int orientation = 1; orientation <= 8; ++orientation) {
      INFO("orientation " << orientation);
      const ImageFile file = read(pngWithExif(exifBlock(orientation, bigEndian)));
      CHECK(spelled(file) == drawn[std::size_t(orientation - 1)]);
      CHECK(file.orientation == 1);
      CHECK(file.notes ==
            (orientation == 1 ? std::vector<std::string>{} : orientationNote(orientation)));
    }
}

TEST_CASE("reading rotates a JPEG according to its EXIF block") {
  for (int orientation = 1; orientation <= 8; ++orientation) {
    INFO("orientation " << orientation);
    Bytes jpeg = makeJpeg({.width = 24, .colour = JpegColour::grey, .darkFirstBlock = true});
    insertJpegExif(jpeg, exifBlock(orientation, true));
    const ImageFile file = read(jpeg);
    const SrgbImage& image = pixelsOf(file);
    const bool isTransposed = orientation >= 5;
    REQUIRE(image.width == (isTransposed ? 16 : 24));
    REQUIRE(image.height == (isTransposed ? 24 : 16));
    // The first stored row and column meet in this corner of the upright image.
    const bool isRight = orientation % 4 == 2 || orientation % 4 == 3;
    const bool isBottom = orientation % 4 == 3 || orientation % 4 == 0;
    for (const bool right : {false, true})
      for (const bool bottom : {false, true}) {
        const float code =
            image.pixel(right ? image.width - 1 : 0, bottom ? image.height - 1 : 0)[0];
        CHECK((code < 0.1f) == (right == isRight && bottom == isBottom));
      }
    CHECK(file.notes ==
          (orientation == 1 ? std::vector<std::string>{} : orientationNote(orientation)));
  }
}

TEST_CASE("an EXIF block after the pixels of a PNG counts as well") {
  Bytes png = makePng({.width = 3, .height = 2, .colourType = 0});
  Bytes end(png.end() - 12, png.end()); // IEND
  Bytes other = pngWithExif(exifBlock(6, true));
  constexpr std::ptrdiff_t kHeaderEnd = 33;
  const auto chunkBytes = std::ptrdiff_t(other.size() - png.size());
  png.insert(png.end() - 12, other.begin() + kHeaderEnd, other.begin() + kHeaderEnd + chunkBytes);
  CHECK(spelled(read(png)) == std::vector<std::string>{"da", "eb", "fc"});
}

TEST_CASE("decoding alone keeps pixels as stored, as a scene's textures require") {
  const ImageFile file = decodeImage(pngWithExif(exifBlock(6, false)), "file").value();
  CHECK(file.orientation == 6);
  CHECK(spelled(file) == std::vector<std::string>{"abc", "def"});
}

TEST_CASE("EXIF that is unreadable or has no valid orientation changes nothing") {
  const std::string whole = exifBlock(6, true);
  std::vector<std::string> blocks{exifBlock(0, true), exifBlock(9, true), exifBlock(65535, true),
                                  std::string(whole.size(), '\xff')};
  std::string cyclic = whole; // the next IFD of IFD 0 is IFD 0
  cyclic.back() = 8;
  for (std::size_t size = 0; size < 20; ++size) // 20 bytes end with the orientation
    blocks.push_back(whole.substr(0, size));
  for (const std::string& block : blocks) {
    Bytes jpeg = makeJpeg({.width = 24, .colour = JpegColour::grey});
    insertJpegExif(jpeg, block);
    const ImageFile file = read(jpeg);
    CHECK(pixelsOf(file).width == 24);
    CHECK(file.notes.empty());
  }
  Bytes jpeg = makeJpeg({.width = 24});
  insertJpegExif(jpeg, cyclic);
  CHECK(pixelsOf(read(jpeg)).height == 24); // rotated exactly once
}
