// SPDX-License-Identifier: MIT
// Splits a GLB so that a test can break one part, and joins it again.
#pragma once

#include <nlohmann/json.hpp>

#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace lichen::example {

struct GlbParts {
  nlohmann::json json;
  std::vector<std::byte> binary;

  explicit GlbParts(std::span<const std::byte> glb) {
    const std::uint32_t textBytes = word(glb, 12);
    const auto* text = reinterpret_cast<const char*>(glb.data() + 20);
    json = nlohmann::json::parse(text, text + textBytes);
    const auto rest = glb.subspan(20 + textBytes + 8);
    binary.assign(rest.begin(), rest.end());
  }

  [[nodiscard]] std::vector<std::byte> join() const { return join(json.dump()); }

  /// Joins with any text in place of the JSON.
  [[nodiscard]] std::vector<std::byte> join(std::string text) const {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    std::vector<std::byte> glb;
    for (const std::size_t value :
         {std::size_t(0x46546C67), std::size_t(2), 28 + text.size() + binary.size(), text.size(),
          std::size_t(0x4E4F534A)})
      append(glb, value);
    const auto bytes = std::as_bytes(std::span(text));
    glb.insert(glb.end(), bytes.begin(), bytes.end());
    append(glb, binary.size());
    append(glb, 0x004E4942);
    glb.insert(glb.end(), binary.begin(), binary.end());
    return glb;
  }

  nlohmann::json& extension() { return json["extensions"]["LICHEN_materials_exemplar_noise"]; }
  nlohmann::json& map(std::size_t noise, std::size_t index) {
    return extension()["noises"][noise]["maps"][index];
  }
  nlohmann::json& use(std::size_t material) {
    return json["materials"][material]["extensions"]["LICHEN_materials_exemplar_noise"];
  }
  /// Offset of table `index` in the binary chunk.
  std::size_t tableOffset(std::size_t index) {
    const std::size_t view = extension()["tables"][index]["bufferView"];
    return json["bufferViews"][view]["byteOffset"];
  }
  /// Overwrites a little-endian word of a table's KTX2 file.
  void setTableWord(std::size_t table, std::size_t offset, std::uint32_t value) {
    std::memcpy(binary.data() + tableOffset(table) + offset, &value, sizeof value);
  }

  static std::uint32_t word(std::span<const std::byte> bytes, std::size_t offset) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
  }
  static void append(std::vector<std::byte>& bytes, std::size_t value) {
    const auto narrow = std::uint32_t(value);
    const auto view = std::as_bytes(std::span(&narrow, 1));
    bytes.insert(bytes.end(), view.begin(), view.end());
  }
};

} // namespace lichen::example
