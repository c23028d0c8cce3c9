// SPDX-License-Identifier: MIT
// Checks every chunk of an EXR file against the size of its pixels.
#include "exr_chunks.h"

#include "claims.h"

#include <algorithm>
#include <array>

namespace lichen {
namespace {

struct Compression {
  Expansion expansion;
  std::int64_t linesPerChunk;
};

// Maximum expansion of the format's ten compressions, in the format's order. Deflate: a match of
// 258 bytes costs two bits. RLE: 2 bytes encode up to 128. PIZ: 9 bits repeat a 2-byte value 255
// times. PXR24: deflate over three bytes of every four. B44A: 3 bytes encode 4 x 4 half values.
// DWA: deflate over RLE.
constexpr std::array<Compression, 10> kCompressions = {{
    {{"uncompressed EXR", 1}, 1},
    {{"EXR's RLE", 64}, 1},
    {{"EXR's ZIPS", 1032}, 1},
    {{"EXR's ZIP", 1032}, 16},
    {{"EXR's PIZ", 454}, 32},
    {{"EXR's PXR24", 1376}, 16},
    {{"EXR's B44", 11}, 32},
    {{"EXR's B44A", 11}, 32},
    {{"EXR's DWAA", 66048}, 32},
    {{"EXR's DWAB", 66048}, 256},
}};

constexpr std::size_t kTableEntryBytes = 8;

std::uint64_t littleEndian(std::span<const std::byte> bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i > 0; --i)
    value = value << 8 | std::to_integer<std::uint64_t>(bytes[i - 1]);
  return value;
}

/// Number of multiples of `sampling` in [low, high].
std::int64_t sampleCount(std::int64_t sampling, std::int64_t low, std::int64_t high) {
  const auto floorDivide = [sampling](std::int64_t value) {
    return value >= 0 ? value / sampling : -((sampling - 1 - value) / sampling);
  };
  return floorDivide(high) - floorDivide(low - 1);
}

std::uint64_t bytesOfPixels(const ExrHeader& header, const ExrWindow& window) {
  std::uint64_t bytes = 0;
  for (const ExrChannel& channel : header.channels)
    bytes += std::uint64_t(sampleCount(channel.xSampling, window.xMin, window.xMax)) *
             std::uint64_t(sampleCount(channel.ySampling, window.yMin, window.yMax)) *
             channel.bytesPerSample;
  return bytes;
}

/// Checks one chunk: `coordinateBytes` bytes of coordinates, then its size, then its data.
Result<void> checkChunk(std::span<const std::byte> file, std::uint64_t offset,
                        std::size_t coordinateBytes, std::uint64_t pixelBytes,
                        const Compression& compression, const std::string& name) {
  constexpr std::size_t kSizeBytes = 4;
  const std::size_t prefix = coordinateBytes + kSizeBytes;
  const auto truncated = [&] {
    return badInput(name, "truncated: the EXR chunk at byte " + std::to_string(offset) +
                              " exceeds the file of " + std::to_string(file.size()) + " bytes");
  };
  if (offset == 0)
    return badInput(name, "incomplete EXR: some chunks were never written");
  if (offset > file.size() || file.size() - offset < prefix)
    return truncated();
  const std::uint64_t size =
      littleEndian(file.subspan(std::size_t(offset) + coordinateBytes, kSizeBytes));
  if (size > file.size() - offset - prefix)
    return truncated();
  if (size > pixelBytes || (size == 0 && pixelBytes > 0))
    return badInput(name, "damaged EXR: a chunk for " + std::to_string(pixelBytes) +
                              " bytes of pixels has " + std::to_string(size) + " bytes");
  return checkExpansion(name, pixelBytes, size, compression.expansion);
}

} // namespace

Result<void> checkExrChunks(std::span<const std::byte> file, const ExrHeader& header,
                            const std::string& name) {
  if (header.compression >= kCompressions.size())
    return badInput(name, "unknown EXR compression " + std::to_string(header.compression) +
                              "; expected 0 to " + std::to_string(kCompressions.size() - 1));
  const Compression& compression = kCompressions[header.compression];
  const ExrWindow& window = header.dataWindow;
  const std::int64_t chunkWidth = header.tiled ? header.tileWidth : window.width();
  const std::int64_t chunkHeight = header.tiled ? header.tileHeight : compression.linesPerChunk;
  const std::size_t coordinateBytes = header.tiled ? 16 : 4;
  const std::int64_t columns = (window.width() + chunkWidth - 1) / chunkWidth;
  const std::int64_t rows = (window.height() + chunkHeight - 1) / chunkHeight;

  const std::span<const std::byte> table = file.subspan(header.chunkTable);
  if (std::uint64_t(columns * rows) > table.size() / kTableEntryBytes)
    return badInput(name, "truncated: the table of " + std::to_string(columns * rows) +
                              " EXR chunks exceeds the file's last " +
                              std::to_string(table.size()) + " bytes");
  for (std::int64_t row = 0; row < rows; ++row)
    for (std::int64_t column = 0; column < columns; ++column) {
      ExrWindow chunk;
      chunk.xMin = window.xMin + column * chunkWidth;
      chunk.yMin = window.yMin + row * chunkHeight;
      chunk.xMax = std::min(chunk.xMin + chunkWidth - 1, window.xMax);
      chunk.yMax = std::min(chunk.yMin + chunkHeight - 1, window.yMax);
      const auto index = std::size_t(row * columns + column);
      const std::uint64_t offset =
          littleEndian(table.subspan(index * kTableEntryBytes, kTableEntryBytes));
      if (Result<void> checked = checkChunk(file, offset, coordinateBytes,
                                            bytesOfPixels(header, chunk), compression, name);
          !checked)
        return checked;
    }
  return {};
}

} // namespace lichen
