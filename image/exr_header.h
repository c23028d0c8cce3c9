// SPDX-License-Identifier: MIT
// Reads the header of an EXR file without OpenEXR, which allocates the sizes that a header claims
// before it compares them with the file.
// file -> windows, channels and tiling, after checking that every attribute and every chunk lies
// inside the file.
// Source: "OpenEXR File Layout", openexr.com, and "Technical Introduction to OpenEXR".
#pragma once

#include <lichen/result.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lichen {

struct ExrChannel {
  std::string name;
  std::uint32_t bytesPerSample = 0; ///< 2 for half, 4 for float and unsigned integer
  std::int64_t xSampling = 1;
  std::int64_t ySampling = 1;
};

/// Bounds in pixels, inclusive.
struct ExrWindow {
  std::int64_t xMin = 0;
  std::int64_t yMin = 0;
  std::int64_t xMax = -1;
  std::int64_t yMax = -1;

  [[nodiscard]] std::int64_t width() const { return xMax - xMin + 1; }
  [[nodiscard]] std::int64_t height() const { return yMax - yMin + 1; }
  bool operator==(const ExrWindow&) const = default;
};

struct ExrHeader {
  ExrWindow dataWindow;
  ExrWindow displayWindow;
  std::vector<ExrChannel> channels;
  unsigned compression = 0; ///< index into the format's list of compressions
  bool tiled = false;
  std::int64_t tileWidth = 0;
  std::int64_t tileHeight = 0;
  std::size_t chunkTable = 0; ///< byte offset of the table of chunk offsets
};

/// Errors: badInput for another version, a multi-part or deep file, invalid sides, an incomplete
/// attribute or chunk, and a chunk that cannot expand to its pixels.
[[nodiscard]] Result<ExrHeader> readExrHeader(std::span<const std::byte> file,
                                              const std::string& name);

} // namespace lichen
