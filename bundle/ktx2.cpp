// SPDX-License-Identifier: MIT
// KTX2 container -> table; see ktx2.h. Input is hostile: every field is checked before use.
#include "ktx2.h"

#include <lichen/counted.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>

namespace lichen {
namespace {

struct FormatEntry {
  TexelFormat format;
  std::uint32_t vkFormat; ///< value of VkFormat
  std::uint32_t typeSize; ///< bytes per component
  bool isFloat;
};
constexpr std::array<FormatEntry, 8> kFormats = {{{TexelFormat::r8Unorm, 9, 1, false},
                                                  {TexelFormat::rg8Unorm, 16, 1, false},
                                                  {TexelFormat::rgba8Unorm, 37, 1, false},
                                                  {TexelFormat::r16Sfloat, 76, 2, true},
                                                  {TexelFormat::rg16Sfloat, 83, 2, true},
                                                  {TexelFormat::rgba16Sfloat, 97, 2, true},
                                                  {TexelFormat::r32Sfloat, 100, 4, true},
                                                  {TexelFormat::rgba32Sfloat, 109, 4, true}}};

const FormatEntry& entryOf(TexelFormat format) { return kFormats[std::size_t(format)]; }

template <class T>
T read(std::span<const std::byte> bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

Error refusal(const std::string& name, const std::string& what) {
  return Error{ErrorKind::badInput, name + ": KTX2: " + what};
}

bool contains(std::size_t size, std::uint64_t offset, std::uint64_t length) {
  return offset <= size && length <= size - offset;
}

/// Checks everything in the header that does not depend on the rest of the file. Returns a table
/// without texels.
Result<Table> tableFromHeader(const Ktx2Header& header, const std::string& name) {
  const std::optional<TexelFormat> format = texelFormatFrom(header.vkFormat);
  if (!format)
    return refusal(name, "vkFormat " + std::to_string(header.vkFormat) +
                             "; expected 9, 16, 37, 76, 83, 97, 100 or 109 (R8, RG8, RGBA8, "
                             "R16F, RG16F, RGBA16F, R32F or RGBA32F)");
  const std::uint32_t typeSize = entryOf(*format).typeSize;
  if (header.typeSize != typeSize)
    return refusal(name, "typeSize " + std::to_string(header.typeSize) + "; vkFormat " +
                             std::to_string(header.vkFormat) + " has " + std::to_string(typeSize));
  for (const std::uint32_t side : {header.pixelWidth, header.pixelHeight})
    if (side == 0 || side > kMaxTableSide)
      return refusal(name, "side of " + std::to_string(side) + " texels; expected 1 to " +
                               std::to_string(kMaxTableSide));
  if (header.pixelDepth > kMaxTableSide)
    return refusal(name, "depth of " + std::to_string(header.pixelDepth) +
                             " texels; expected at most " + std::to_string(kMaxTableSide));
  if (header.layerCount != 0 || header.faceCount != 1)
    return refusal(name, counted(header.layerCount, "layer") + " and " +
                             counted(header.faceCount, "face") +
                             "; expected a single 2-D or 3-D image (0 and 1)");
  const auto mostLevels = std::uint32_t(
      std::bit_width(std::max({header.pixelWidth, header.pixelHeight, header.pixelDepth})));
  if (header.levelCount == 0 || header.levelCount > mostLevels)
    return refusal(name, std::to_string(header.levelCount) + " mip levels; expected 1 to " +
                             std::to_string(mostLevels) + " for this size");
  if (header.supercompressionScheme != 0 || header.sgdByteOffset != 0 || header.sgdByteLength != 0)
    return refusal(name, "supercompression scheme " +
                             std::to_string(header.supercompressionScheme) +
                             "; expected uncompressed data (0, without global data)");
  Table table;
  table.name = name;
  table.format = *format;
  table.width = header.pixelWidth;
  table.height = header.pixelHeight;
  table.depth = header.pixelDepth;
  table.mipLevels = header.levelCount;
  return table;
}

/// Whether a descriptor equals the format's, except for primaries, flags and version. The transfer
/// function and the samples must match, because they define what the texels mean.
bool descriptorMatches(std::span<const std::byte> descriptor, TexelFormat format) {
  const std::vector<std::uint32_t> expected = describeKtx2(format);
  const auto expectedBytes = std::as_bytes(std::span(expected));
  if (descriptor.size() != expectedBytes.size())
    return false;
  constexpr std::array<std::size_t, 4> kFree = {8, 9, 13, 15}; // version, primaries, flags
  for (std::size_t i = 0; i < descriptor.size(); ++i)
    if (descriptor[i] != expectedBytes[i] &&
        std::find(kFree.begin(), kFree.end(), i) == kFree.end())
      return false;
  return true;
}

/// The fault of the key/value data; empty if it is well-formed and neither reorients nor swizzles
/// the image.
std::string keyValueFault(std::span<const std::byte> data, bool is3d) {
  while (!data.empty()) {
    if (data.size() < sizeof(std::uint32_t))
      return "key/value data ends inside a length";
    const auto length = read<std::uint32_t>(data, 0);
    data = data.subspan(sizeof(std::uint32_t));
    const std::size_t padded = (std::size_t(length) + 3) / 4 * 4;
    if (padded > data.size())
      return "key/value entry of " + counted(length, "byte") + " passes the end of its data";
    std::string text(length, '\0');
    std::memcpy(text.data(), data.data(), length);
    data = data.subspan(padded);
    const std::size_t keyEnd = text.find('\0');
    if (keyEnd == std::string::npos || keyEnd == 0)
      return "key/value entry without a key";
    const std::string key = text.substr(0, keyEnd);
    std::string value = text.substr(keyEnd + 1);
    if (!value.empty() && value.back() == '\0')
      value.pop_back();
    if (key == "KTXorientation" && value != (is3d ? "rdi" : "rd"))
      return std::string("KTXorientation other than ") + (is3d ? "rdi" : "rd");
    if (key == "KTXswizzle" && value != "rgba")
      return "KTXswizzle other than rgba";
  }
  return {};
}

/// Copies the mip levels from the file. They must be smallest first, aligned, after `firstByte`,
/// and end at the end of the file.
Result<Table> readLevels(Table table, std::span<const std::byte> file, std::size_t firstByte) {
  const std::size_t alignment = ktx2Alignment(table.format);
  std::uint64_t end = firstByte;
  for (std::uint32_t level = table.mipLevels; level-- > 0;) {
    const auto entry = read<Ktx2Level>(file, sizeof(Ktx2Header) + level * sizeof(Ktx2Level));
    const std::string which = "mip level " + std::to_string(level);
    const std::size_t size = levelRange(table, level).size;
    if (entry.byteLength != size || entry.uncompressedByteLength != size)
      return refusal(table.name, which + " of " + counted(entry.byteLength, "byte") +
                                     "; expected " + std::to_string(size));
    if (entry.byteOffset % alignment != 0 || entry.byteOffset < end ||
        entry.byteOffset - end >= alignment)
      return refusal(table.name, which + " at byte " + std::to_string(entry.byteOffset) +
                                     "; expected at the next multiple of " +
                                     std::to_string(alignment) + " from " + std::to_string(end));
    if (!contains(file.size(), entry.byteOffset, entry.byteLength))
      return refusal(table.name,
                     which + " passes the end of the file at byte " + std::to_string(file.size()));
    end = entry.byteOffset + entry.byteLength;
  }
  if (end != file.size())
    return refusal(table.name,
                   counted(file.size() - end, "byte") + " after the last mip level; expected none");
  const LevelRange last = levelRange(table, table.mipLevels - 1);
  table.texels.resize(last.offset + last.size);
  for (std::uint32_t level = 0; level < table.mipLevels; ++level) {
    const auto entry = read<Ktx2Level>(file, sizeof(Ktx2Header) + level * sizeof(Ktx2Level));
    const LevelRange range = levelRange(table, level);
    std::memcpy(table.texels.data() + range.offset, file.data() + entry.byteOffset, range.size);
  }
  return table;
}

Result<Table> decode(std::span<const std::byte> file, const std::string& name) {
  if (file.size() < sizeof(Ktx2Header))
    return refusal(name, counted(file.size(), "byte") + "; a header has " +
                             std::to_string(sizeof(Ktx2Header)));
  const auto header = read<Ktx2Header>(file, 0);
  if (header.identifier != kKtx2Identifier)
    return refusal(name, "the file identifier is absent");
  Result<Table> table = tableFromHeader(header, name);
  if (!table)
    return table;
  const std::size_t indexEnd = sizeof(Ktx2Header) + table.value().mipLevels * sizeof(Ktx2Level);
  if (file.size() < indexEnd)
    return refusal(name, "the file ends inside its level index");
  if (header.dfdByteOffset != indexEnd ||
      !contains(file.size(), header.dfdByteOffset, header.dfdByteLength) ||
      !descriptorMatches(file.subspan(header.dfdByteOffset, header.dfdByteLength),
                         table.value().format))
    return refusal(name, "the data format descriptor does not describe vkFormat " +
                             std::to_string(header.vkFormat));
  std::size_t metadataEnd = std::size_t(header.dfdByteOffset) + header.dfdByteLength;
  if (header.kvdByteLength > 0) {
    if (header.kvdByteOffset != metadataEnd ||
        !contains(file.size(), header.kvdByteOffset, header.kvdByteLength))
      return refusal(name, "the key/value data is not between the descriptor and the levels");
    const std::string fault = keyValueFault(
        file.subspan(header.kvdByteOffset, header.kvdByteLength), header.pixelDepth > 0);
    if (!fault.empty())
      return refusal(name, fault);
    metadataEnd += header.kvdByteLength;
  } else if (header.kvdByteOffset != 0) {
    return refusal(name, "key/value data at an offset but without a length");
  }
  Result<Table> complete = readLevels(std::move(table).value(), file, metadataEnd);
  if (complete && !hasFiniteTexels(complete.value()))
    return refusal(name, "a texel is NaN or infinite; expected finite values");
  return complete;
}

} // namespace

std::size_t ktx2Alignment(TexelFormat format) {
  return std::lcm(texelBytes(format), std::size_t(4));
}

std::vector<std::uint32_t> describeKtx2(TexelFormat format) {
  constexpr std::uint32_t kVersion1_3 = 2;
  constexpr std::uint32_t kModelRgbsda = 1;
  constexpr std::uint32_t kPrimariesBt709 = 1;
  constexpr std::uint32_t kTransferLinear = 1;
  constexpr std::uint32_t kChannelAlpha = 15;
  constexpr std::uint32_t kQualifierSigned = 0x40;
  constexpr std::uint32_t kQualifierFloat = 0x80;
  const FormatEntry& entry = entryOf(format);
  const auto channels = std::uint32_t(channelCount(format));
  const std::uint32_t blockBytes = 24 + 16 * channels;
  std::vector<std::uint32_t> words = {blockBytes + 4, // total size, with this word
                                      0,              // Khronos, basic format
                                      kVersion1_3 | blockBytes << 16u,
                                      kModelRgbsda | kPrimariesBt709 << 8u | kTransferLinear << 16u,
                                      0, // texel block of 1 x 1 x 1 x 1
                                      std::uint32_t(texelBytes(format)), // bytes of plane 0
                                      0};
  for (std::uint32_t channel = 0; channel < channels; ++channel) {
    const bool alpha = channel == 3;
    const std::uint32_t bits = 8 * entry.typeSize;
    std::uint32_t type = alpha ? kChannelAlpha : channel;
    if (entry.isFloat)
      type |= kQualifierFloat | kQualifierSigned;
    words.push_back(channel * bits | (bits - 1) << 16u | type << 24u);
    words.push_back(0); // sample position
    // The values of black and white: the full range of UNORM, -1 to 1 for floats.
    words.push_back(entry.isFloat ? std::bit_cast<std::uint32_t>(-1.0f) : 0u);
    words.push_back(entry.isFloat ? std::bit_cast<std::uint32_t>(1.0f) : 255u);
  }
  return words;
}

std::uint32_t vkFormatOf(TexelFormat format) { return entryOf(format).vkFormat; }

std::optional<TexelFormat> texelFormatFrom(std::uint32_t vkFormat) {
  for (const FormatEntry& entry : kFormats)
    if (entry.vkFormat == vkFormat)
      return entry.format;
  return std::nullopt;
}

Result<Table> decodeKtx2(std::span<const std::byte> file, const std::string& name) {
  return withinMemory([&] { return name + ": not enough memory for its texels"; },
                      [&] { return decode(file, name); });
}

} // namespace lichen
