// SPDX-License-Identifier: MIT
// The textures of a bundle, and their KTX2 files.
#pragma once

#include <lichen/result.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace lichen {

enum class TexelFormat {
  r8Unorm,
  rg8Unorm,
  rgba8Unorm,
  rgba8Srgb,
  r16Sfloat,
  rg16Sfloat,
  rgba16Sfloat,
  r32Sfloat,
  rgba32Sfloat,
};

/// The largest value of a 16-bit texel; larger ones are stored as it.
inline constexpr float kHalfMax = 65504.0f;

/// Texels of a table's longest side.
inline constexpr std::uint32_t kMaxTableSide = 16384;

/// Bytes of one texel, and how many channels it has.
[[nodiscard]] std::size_t texelBytes(TexelFormat format);
[[nodiscard]] int channelCount(TexelFormat format);

/// An uncompressed 2-D texture with mips, or a 3-D texture without: the content of one KTX2 file.
/// Level l has max(1, width >> l) x max(1, height >> l) texels, rows top first, z slowest, tightly
/// packed; levels follow one another from 0 in `texels`.
struct Table {
  std::string name;
  TexelFormat format = TexelFormat::rgba8Unorm;
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint32_t depth = 0;     ///< 0 for a 2-D texture
  std::uint32_t mipLevels = 1; ///< 1 when 3-D
  std::vector<std::byte> texels;
};

/// Offset and size in bytes of one mip level inside Table::texels. `level` < mipLevels.
struct LevelRange {
  std::size_t offset = 0;
  std::size_t size = 0;
};
[[nodiscard]] LevelRange levelRange(const Table& table, std::uint32_t level);

/// One mip level as floats, channelCount interleaved, sRGB decoded to light. Throws std::bad_alloc.
[[nodiscard]] std::vector<float> decodeLevel(const Table& table, std::uint32_t level);
/// Appends float texels, channelCount(format) interleaved, rounded to nearest into `format`; sRGB
/// formats are given light and store its code. Throws std::bad_alloc.
void appendTexels(std::vector<std::byte>& texels, TexelFormat format,
                  std::span<const float> values);

/// KTX2 of a table (throws std::bad_alloc), and back. `name`, of messages, becomes Table::name.
[[nodiscard]] std::vector<std::byte> encodeKtx2(const Table& table);
[[nodiscard]] Result<Table> decodeKtx2(std::span<const std::byte> file, const std::string& name);

} // namespace lichen
