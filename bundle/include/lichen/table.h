// SPDX-License-Identifier: MIT
// The textures of a bundle, and their decoding from KTX2.
#pragma once

#include <lichen/result.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace lichen {

enum class TexelFormat {
  r8Unorm,
  rg8Unorm,
  rgba8Unorm,
  r16Sfloat,
  rg16Sfloat,
  rgba16Sfloat,
  r32Sfloat,
  rgba32Sfloat,
};

/// The largest finite half float. Larger values are clamped to it.
inline constexpr float kHalfMax = 65504.0f;

/// Maximum side of a table in texels.
inline constexpr std::uint32_t kMaxTableSide = 16384;

/// The number of the VkFormat, and back; nothing for other formats.
[[nodiscard]] std::uint32_t vkFormatOf(TexelFormat format);
[[nodiscard]] std::optional<TexelFormat> texelFormatFrom(std::uint32_t vkFormat);

/// Bytes per texel, and number of channels.
[[nodiscard]] std::size_t texelBytes(TexelFormat format);
[[nodiscard]] int channelCount(TexelFormat format);

/// An uncompressed 2-D or 3-D texture with mip levels: the content of one KTX2 file. Mip level l
/// has sides of max(1, side >> l) texels, tightly packed; the top row comes first, and z varies
/// slowest. `texels` holds all mip levels, starting with level 0.
struct Table {
  std::string name;
  TexelFormat format = TexelFormat::rgba8Unorm;
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  std::uint32_t depth = 0; ///< 0 for a 2-D texture
  std::uint32_t mipLevels = 1;
  std::vector<std::byte> texels;
};

/// Offset and size in bytes of one mip level inside Table::texels. Precondition: `level` <
/// mipLevels.
struct LevelRange {
  std::size_t offset = 0;
  std::size_t size = 0;
};
[[nodiscard]] LevelRange levelRange(const Table& table, std::uint32_t level);

/// Whether no texel is NaN or infinite.
[[nodiscard]] bool hasFiniteTexels(const Table& table);

/// Decodes one mip level to floats, channelCount(format) interleaved. Throws std::bad_alloc.
[[nodiscard]] std::vector<float> decodeLevel(const Table& table, std::uint32_t level);
/// Appends texels, given as floats with channelCount(format) interleaved, rounded to the nearest
/// value of `format`. Throws std::bad_alloc.
void appendTexels(std::vector<std::byte>& texels, TexelFormat format,
                  std::span<const float> values);

/// Decodes a KTX2 file, uncompressed formats only. `name` becomes Table::name and appears in
/// messages. Errors: badInput; resources when memory does not suffice.
[[nodiscard]] Result<Table> decodeKtx2(std::span<const std::byte> file, const std::string& name);

} // namespace lichen
