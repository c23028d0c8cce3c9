// SPDX-License-Identifier: MIT
// The tables and the picture of the example bundles; see bundle_example.h.
#include "bundle_example.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>

namespace lichen::example {

Table patternTable(const std::string& name, TexelFormat format, std::uint32_t width,
                   std::uint32_t height, std::uint32_t depth, std::uint32_t mipLevels) {
  Table table{name, format, width, height, depth, mipLevels, {}};
  const LevelRange last = levelRange(table, mipLevels - 1);
  const std::size_t texels = (last.offset + last.size) / texelBytes(format);
  std::vector<float> values(texels * std::size_t(channelCount(format)));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = float(i * 37 % 256) / 255.0f;
  appendTexels(table.texels, format, values);
  return table;
}

std::uint32_t fullMipChain(std::uint32_t width, std::uint32_t height) {
  return std::uint32_t(std::bit_width(std::max(width, height)));
}

Table gaussianTable(const std::string& name, TexelFormat format, std::uint32_t width,
                    std::uint32_t height) {
  Table table = patternTable(name, format, width, height, 0, fullMipChain(width, height));
  std::vector<float> losses;
  for (std::uint32_t level = 0; level < table.mipLevels; ++level)
    losses.push_back(float(level) / float(table.mipLevels));
  setLosses(table, losses);
  return table;
}

Table constantTable(TexelFormat format, std::uint32_t side, float value) {
  Table table = patternTable("", format, side, side, 0, fullMipChain(side, side));
  std::vector<float> values;
  for (std::uint32_t level = 0; level < table.mipLevels; ++level) {
    const std::vector<float> own = decodeLevel(table, level);
    values.resize(values.size() + own.size(), value);
  }
  table.texels.clear();
  appendTexels(table.texels, format, values);
  return table;
}

void setChannel(Table& table, std::size_t channel, const std::vector<float>& valueOfLevel) {
  const auto channels = std::size_t(channelCount(table.format));
  std::vector<std::byte> texels;
  for (std::uint32_t level = 0; level < table.mipLevels; ++level) {
    std::vector<float> values = decodeLevel(table, level);
    for (std::size_t i = channel; i < values.size(); i += channels)
      values[i] = valueOfLevel[level];
    appendTexels(texels, table.format, values);
  }
  table.texels = std::move(texels);
}

void setLosses(Table& gaussian, const std::vector<float>& losses) {
  setChannel(gaussian, std::size_t(channelCount(gaussian.format)) - 1, losses);
}

Table tableWithMips() {
  return patternTable("mips", TexelFormat::rg16Sfloat, 8, 4, 0, fullMipChain(8, 4));
}

std::vector<std::byte> tinyPng() {
  // 2 x 2, 8-bit RGB, (128, 128, 255) four times: flat as a normal map.
  constexpr std::array<unsigned char, 73> kFile = {
      0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49, 0x48, 0x44,
      0x52, 0x00, 0x00, 0x00, 0x02, 0x00, 0x00, 0x00, 0x02, 0x08, 0x02, 0x00, 0x00, 0x00, 0xfd,
      0xd4, 0x9a, 0x73, 0x00, 0x00, 0x00, 0x10, 0x49, 0x44, 0x41, 0x54, 0x78, 0xda, 0x63, 0x68,
      0x68, 0xf8, 0x0f, 0x44, 0x0c, 0x10, 0x0a, 0x00, 0x35, 0xf6, 0x07, 0xfd, 0xa1, 0x29, 0xec,
      0x43, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
  const auto bytes = std::as_bytes(std::span(kFile));
  return {bytes.begin(), bytes.end()};
}

} // namespace lichen::example
