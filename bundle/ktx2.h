// SPDX-License-Identifier: MIT
// The parts of a KTX2 file that reading and writing share, uncompressed formats only. A file has
// the header, level index, data format descriptor and key/value data, then the mip levels, smallest
// first, each aligned to its texel size.
// Sources: KTX File Format Specification 2.0; Khronos Data Format Specification 1.3, section 5.
#pragma once

#include <lichen/table.h>

#include <array>
#include <bit>

namespace lichen {

static_assert(std::endian::native == std::endian::little, "KTX2 and GLB fields are little-endian");

inline constexpr std::array<unsigned char, 12> kKtx2Identifier = {
    0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB, '\r', '\n', 0x1A, '\n'};

/// The header and index of the specification, byte for byte.
struct Ktx2Header {
  std::array<unsigned char, 12> identifier = kKtx2Identifier;
  std::uint32_t vkFormat = 0;
  std::uint32_t typeSize = 1;
  std::uint32_t pixelWidth = 0;
  std::uint32_t pixelHeight = 0;
  std::uint32_t pixelDepth = 0;
  std::uint32_t layerCount = 0;
  std::uint32_t faceCount = 1;
  std::uint32_t levelCount = 1;
  std::uint32_t supercompressionScheme = 0;
  std::uint32_t dfdByteOffset = 0;
  std::uint32_t dfdByteLength = 0;
  std::uint32_t kvdByteOffset = 0;
  std::uint32_t kvdByteLength = 0;
  std::uint64_t sgdByteOffset = 0;
  std::uint64_t sgdByteLength = 0;
};
static_assert(sizeof(Ktx2Header) == 80);

struct Ktx2Level {
  std::uint64_t byteOffset = 0;
  std::uint64_t byteLength = 0;
  std::uint64_t uncompressedByteLength = 0;
};

/// Alignment of a mip level's bytes in the file.
[[nodiscard]] std::size_t ktx2Alignment(TexelFormat format);

/// The data format descriptor with its leading total size: one basic descriptor block (Data Format
/// 1.3, section 5), colour model RGBSDA, BT.709 primaries, straight alpha, one sample per channel.
[[nodiscard]] std::vector<std::uint32_t> describeKtx2(TexelFormat format);

} // namespace lichen
