// SPDX-License-Identifier: MIT
// Sample PNG files through libpng.
#include "image_samples.h"

#include <png.h>

#include <array>
#include <stdexcept>
#include <zlib.h>

namespace lichen::samples {
namespace {

void appendBytes(png_structp png, png_bytep source, std::size_t size) {
  Bytes& bytes = *static_cast<Bytes*>(png_get_io_ptr(png));
  const auto* first = reinterpret_cast<const std::byte*>(source);
  bytes.insert(bytes.end(), first, first + size);
}

void fail(png_structp, png_const_charp message) { throw std::runtime_error(message); }

int channelCount(int colourType) {
  return colourType == PNG_COLOR_TYPE_RGB          ? 3
         : colourType == PNG_COLOR_TYPE_RGB_ALPHA  ? 4
         : colourType == PNG_COLOR_TYPE_GRAY_ALPHA ? 2
                                                   : 1;
}

std::vector<png_byte> packedRow(const Png& png, int y) {
  std::vector<png_byte> row;
  unsigned bits = 0;
  int bitCount = 0;
  for (int x = 0; x < png.width; ++x)
    for (int c = 0; c < channelCount(png.colourType); ++c) {
      const unsigned code = pngCode(png, x, y, c);
      if (png.bitDepth == 16)
        row.push_back(png_byte(code >> 8));
      if (png.bitDepth >= 8) {
        row.push_back(png_byte(code & 0xff));
        continue;
      }
      bits = bits << png.bitDepth | code;
      bitCount += png.bitDepth;
      if (bitCount == 8 || x == png.width - 1) {
        row.push_back(png_byte(bits << (8 - bitCount)));
        bits = 0;
        bitCount = 0;
      }
    }
  return row;
}

void setChunks(png_structp writer, png_infop info, const Png& png) {
  const bool hasPalette = png.colourType == PNG_COLOR_TYPE_PALETTE;
  const int entries = 1 << std::min(png.bitDepth, 8);
  if (hasPalette) {
    std::vector<png_color> palette;
    for (unsigned i = 0; i < unsigned(entries); ++i)
      palette.push_back(
          {png_byte(paletteCode(i, 0)), png_byte(paletteCode(i, 1)), png_byte(paletteCode(i, 2))});
    png_set_PLTE(writer, info, palette.data(), entries);
  }
  if (png.transparency) {
    const std::array<png_byte, 2> alpha = {255, 128};
    const png_color_16 colour = {0, 1, 1, 1, 1};
    png_set_tRNS(writer, info, hasPalette ? alpha.data() : nullptr, hasPalette ? 2 : 1, &colour);
  }
  if (png.colourChunks) {
    png_set_gAMA(writer, info, 1.0);
    png_set_cHRM(writer, info, 0.3, 0.3, 0.7, 0.2, 0.2, 0.7, 0.1, 0.1);
  }
}

std::uint32_t bigEndian(const Bytes& bytes, std::size_t offset) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i)
    value = value << 8 | std::to_integer<std::uint32_t>(bytes[offset + i]);
  return value;
}

Bytes bigEndian(std::uint32_t value) {
  return {std::byte(value >> 24), std::byte(value >> 16), std::byte(value >> 8), std::byte(value)};
}

std::uint32_t checksum(const std::byte* first, std::size_t size) {
  return std::uint32_t(crc32(0, reinterpret_cast<const Bytef*>(first), uInt(size)));
}

} // namespace

unsigned pngCode(const Png& png, int x, int y, int c) {
  if (png.constant)
    return 0;
  // A step of 257 fills both bytes of 16-bit codes; odd factors reach every code.
  const auto i = unsigned(x + y * png.width) * 257u + unsigned(c) * 91u;
  return i & ((1u << png.bitDepth) - 1u);
}

unsigned paletteCode(unsigned i, int c) { return (i * 37u + unsigned(c) * 101u) & 0xff; }

Bytes makePng(const Png& png) {
  Bytes bytes;
  png_structp writer = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, fail, nullptr);
  png_infop info = png_create_info_struct(writer);
  png_set_write_fn(writer, &bytes, appendBytes, nullptr);
  png_set_IHDR(writer, info, png_uint_32(png.width), png_uint_32(png.height), png.bitDepth,
               png.colourType, png.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  setChunks(writer, info, png);
  png_write_info(writer, info);
  std::vector<std::vector<png_byte>> rows;
  for (int y = 0; y < png.height; ++y)
    rows.push_back(packedRow(png, y));
  std::vector<png_bytep> pointers;
  for (std::vector<png_byte>& row : rows)
    pointers.push_back(row.data());
  png_write_image(writer, pointers.data());
  png_write_end(writer, info);
  png_destroy_write_struct(&writer, &info);
  return bytes;
}

void correctPngChecksums(Bytes& file) {
  constexpr std::size_t kSignatureBytes = 8;
  constexpr std::size_t kFramingBytes = 12; // length, type and checksum
  if (find(file, "\x89PNG") != 0)
    return;
  std::size_t at = kSignatureBytes;
  while (at + kFramingBytes <= file.size()) {
    const std::size_t dataBytes = bigEndian(file, at);
    if (dataBytes > file.size() - at - kFramingBytes)
      return;
    const Bytes crc = bigEndian(checksum(file.data() + at + 4, 4 + dataBytes));
    std::copy(crc.begin(), crc.end(), file.begin() + std::ptrdiff_t(at + 8 + dataBytes));
    at += kFramingBytes + dataBytes;
  }
}

void patchPngHeader(Bytes& png, std::size_t offset, std::uint32_t value) {
  const Bytes bytes = bigEndian(value);
  std::copy(bytes.begin(), bytes.end(), png.begin() + std::ptrdiff_t(offset));
  correctPngChecksums(png);
}

void insertPngChunk(Bytes& png, const std::string& type, const std::string& data) {
  constexpr std::ptrdiff_t kHeaderEnd = 33; // signature (8), IHDR's framing (12) and data (13)
  Bytes chunk = bigEndian(std::uint32_t(data.size()));
  for (const char c : type + data)
    chunk.push_back(std::byte(static_cast<unsigned char>(c)));
  chunk.insert(chunk.end(), 4, std::byte(0)); // placeholder of the checksum
  png.insert(png.begin() + kHeaderEnd, chunk.begin(), chunk.end());
  correctPngChecksums(png);
}

} // namespace lichen::samples
