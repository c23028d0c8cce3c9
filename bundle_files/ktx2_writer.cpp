// SPDX-License-Identifier: MIT
// Table -> KTX2 file; see ktx2.h.
#include "ktx2.h"

#include <lichen/bundle_writer.h>

#include <cstring>

namespace lichen {
namespace {

template <class T>
void append(std::vector<std::byte>& bytes, const T& value) {
  const auto view = std::as_bytes(std::span(&value, 1));
  bytes.insert(bytes.end(), view.begin(), view.end());
}

void padTo(std::vector<std::byte>& bytes, std::size_t alignment) {
  bytes.resize((bytes.size() + alignment - 1) / alignment * alignment);
}

std::vector<std::byte> keyValueData() {
  constexpr std::string_view kWriter("KTXwriter\0lichen\0", 17);
  std::vector<std::byte> bytes;
  append(bytes, std::uint32_t(kWriter.size()));
  const auto text = std::as_bytes(std::span(kWriter));
  bytes.insert(bytes.end(), text.begin(), text.end());
  padTo(bytes, 4);
  return bytes;
}

} // namespace

std::vector<std::byte> encodeKtx2(const Table& table) {
  const std::vector<std::uint32_t> descriptor = describeKtx2(table.format);
  const std::vector<std::byte> keyValues = keyValueData();
  const std::size_t indexBytes = table.mipLevels * sizeof(Ktx2Level);
  Ktx2Header header;
  header.vkFormat = vkFormatOf(table.format);
  header.typeSize =
      std::uint32_t(texelBytes(table.format)) / std::uint32_t(channelCount(table.format));
  header.pixelWidth = table.width;
  header.pixelHeight = table.height;
  header.pixelDepth = table.depth;
  header.levelCount = table.mipLevels;
  header.dfdByteOffset = std::uint32_t(sizeof(Ktx2Header) + indexBytes);
  header.dfdByteLength = std::uint32_t(descriptor.size() * sizeof(std::uint32_t));
  header.kvdByteOffset = header.dfdByteOffset + header.dfdByteLength;
  header.kvdByteLength = std::uint32_t(keyValues.size());

  std::vector<std::byte> file;
  append(file, header);
  file.resize(sizeof(Ktx2Header) + indexBytes);
  const auto descriptorBytes = std::as_bytes(std::span(descriptor));
  file.insert(file.end(), descriptorBytes.begin(), descriptorBytes.end());
  file.insert(file.end(), keyValues.begin(), keyValues.end());
  for (std::uint32_t level = table.mipLevels; level-- > 0;) {
    padTo(file, ktx2Alignment(table.format));
    const LevelRange range = levelRange(table, level);
    const Ktx2Level entry{file.size(), range.size, range.size};
    std::memcpy(file.data() + sizeof(Ktx2Header) + level * sizeof(Ktx2Level), &entry, sizeof entry);
    const auto texels = std::span(table.texels).subspan(range.offset, range.size);
    file.insert(file.end(), texels.begin(), texels.end());
  }
  return file;
}

} // namespace lichen
