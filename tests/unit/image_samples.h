// SPDX-License-Identifier: MIT
// Sample image files of every kind, made directly with libpng, libjpeg and OpenEXR, so that they do
// not depend on the code under test.
#pragma once

#include <lichen/image_io.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace lichen::samples {

using Bytes = std::vector<std::byte>;

struct Png {
  int width = 8;
  int height = 8;
  int bitDepth = 8;
  int colourType = 2;    ///< as in IHDR: 0 grey, 2 RGB, 3 palette, 4 grey + alpha, 6 RGB + alpha
  bool constant = false; ///< every code is 0
  bool interlaced = false;
  bool transparency = false; ///< a tRNS chunk: code 1 (palette: alpha 128 for entry 1)
  bool colourChunks = false; ///< gAMA and cHRM that would change every pixel if they were applied
};
/// The code of channel c (palette: the index) at (x, y); all codes of the bit depth occur.
[[nodiscard]] unsigned pngCode(const Png& png, int x, int y, int c);
/// The 8-bit colour of palette entry i.
[[nodiscard]] unsigned paletteCode(unsigned i, int c);
[[nodiscard]] Bytes makePng(const Png& png);

/// Overwrites 4 bytes at `offset`, most significant first, and corrects the checksums.
void patchPngHeader(Bytes& png, std::size_t offset, std::uint32_t value);
/// Corrects the checksum of every complete chunk; leaves other files unchanged.
void correctPngChecksums(Bytes& file);
/// An EXIF block whose IFD 0 only has an orientation, as a short in either byte order.
[[nodiscard]] std::string exifBlock(int orientation, bool bigEndian);
/// Inserts an EXIF APP1 marker after the first marker.
void insertJpegExif(Bytes& jpeg, const std::string& block);

/// Inserts a chunk with a correct checksum after IHDR.
void insertPngChunk(Bytes& png, const std::string& type, const std::string& data);

enum class JpegColour { grey, ycbcr, cmyk, ycck };
struct Jpeg {
  int width = 16;
  int height = 16;
  JpegColour colour = JpegColour::ycbcr;
  bool progressive = false;
  bool scanPerCoefficient = false; ///< progressive grey: 1 + 63 + 63 scans, all legal
  bool arithmetic = false;
  bool darkFirstBlock = false;                            ///< the first 8 x 8 pixels have code 0
  bool adobeMarker = true;                                ///< for CMYK and YCCK
  std::vector<unsigned char> codes = {200, 100, 50, 220}; ///< of every pixel, channel by channel
};
[[nodiscard]] Bytes makeJpeg(const Jpeg& jpeg);

struct ExrChannel {
  std::string name;
  int type = 1; ///< 0 unsigned, 1 half, 2 float
  int sampling = 1;
};
struct Exr {
  int width = 8;
  int height = 8;
  int xMin = 0;
  int yMin = 0;
  std::vector<ExrChannel> channels = {{"R"}, {"G"}, {"B"}};
  int compression = 3; ///< as in the format: 0 none, 3 ZIP, 4 PIZ
  int tileSide = 0;    ///< 0: scan lines
  bool mipMapped = false;
  bool decreasingY = false;
  bool wideDisplay = false; ///< display window differs from the data window
  /// Replaces the value of the first channel at the first pixel.
  bool hasOddValue = false;
  float oddValue = 0.0f;
};
/// The value of channel c (in the order of Exr::channels) at (x, y); exact in half and unsigned.
[[nodiscard]] float exrValue(int x, int y, int c);
[[nodiscard]] Bytes makeExr(const Exr& exr);
[[nodiscard]] Bytes makeMultiPartExr();
[[nodiscard]] Bytes makeDeepExr();
[[nodiscard]] Bytes makeLuminanceChromaExr();

/// Small valid files of every supported kind.
[[nodiscard]] std::vector<Bytes> everySupportedKind();

/// Offset of the first occurrence of `pattern` in `bytes`; the size if there is none.
[[nodiscard]] std::size_t find(const Bytes& bytes, const std::string& pattern);

/// The message of decoding's badInput error; for any other outcome, a text in parentheses that no
/// message has.
[[nodiscard]] std::string refusal(const Bytes& bytes, const std::string& name = "file");

} // namespace lichen::samples
