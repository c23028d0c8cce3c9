// SPDX-License-Identifier: MIT
// What the sample files of all formats have in common.
#include "image_samples.h"

#include <algorithm>

namespace lichen::samples {

std::vector<Bytes> everySupportedKind() {
  std::vector<Bytes> files;
  for (const bool interlaced : {false, true}) {
    for (const int bitDepth : {1, 2, 4, 8, 16})
      files.push_back(makePng({.bitDepth = bitDepth, .colourType = 0, .interlaced = interlaced}));
    for (const int colourType : {2, 4, 6})
      files.push_back(
          makePng({.bitDepth = 16, .colourType = colourType, .interlaced = interlaced}));
    for (const int colourType : {2, 3})
      files.push_back(makePng({.colourType = colourType,
                               .interlaced = interlaced,
                               .transparency = true,
                               .colourChunks = true}));
  }
  for (const bool progressive : {false, true})
    for (const JpegColour colour :
         {JpegColour::grey, JpegColour::ycbcr, JpegColour::cmyk, JpegColour::ycck})
      files.push_back(makeJpeg({.colour = colour, .progressive = progressive}));
  files.push_back(makeJpeg({.width = 24}));
  insertJpegExif(files.back(), exifBlock(6, true));
  files.push_back(makePng({.width = 5}));
  insertPngChunk(files.back(), "eXIf", exifBlock(8, false));
  for (int compression = 0; compression <= 9; ++compression)
    for (const int tileSide : {0, 4})
      files.push_back(makeExr({.compression = compression, .tileSide = tileSide}));
  files.push_back(makeExr({.channels = {{"Y", 2}, {"A", 0}}, .tileSide = 4, .mipMapped = true}));
  files.push_back(makeExr({.xMin = -4, .yMin = 6, .channels = {{"G", 0}, {"Z", 2, 2}}}));
  return files;
}

std::size_t find(const Bytes& bytes, const std::string& pattern) {
  const auto found = std::search(
      bytes.begin(), bytes.end(), pattern.begin(), pattern.end(),
      [](std::byte a, char b) { return a == std::byte(static_cast<unsigned char>(b)); });
  return std::size_t(found - bytes.begin());
}

std::string refusal(const Bytes& bytes, const std::string& name) {
  const Result<ImageFile> result = decodeImage(bytes, name);
  if (result)
    return "(no error)";
  if (result.error().kind != ErrorKind::badInput)
    return "(another kind of error) " + result.error().message;
  return result.error().message;
}

} // namespace lichen::samples
