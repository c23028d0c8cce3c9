// SPDX-License-Identifier: MIT
// Reads a cooked bundle; see cooked.h. Input is hostile: every length and nesting depth is checked
// before use.
#include "cooked.h"
#include "extension_reader.h"
#include "json_builder.h"

#include <bit>
#include <cstring>

namespace lichen {
namespace {

using nlohmann::json;

static_assert(std::endian::native == std::endian::little);

std::uint32_t word(std::span<const std::byte> bytes, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

/// Texels inside the file, after the description and one after the other.
class CookedTables : public TableSource {
public:
  CookedTables(std::span<const std::byte> file, std::size_t firstByte)
      : file_(file), end_(firstByte) {}

  [[nodiscard]] std::optional<Table> read(ObjectReader reader, FindingList& findings) override {
    const std::size_t errorsBefore = findings.errorCount();
    const auto side = [&](const char* key, std::uint64_t least) {
      return std::uint32_t(
          reader.integer(key, kMaxTableSide, "table-cooked", least).value_or(least));
    };
    Table table;
    table.name = reader.has("name") ? reader.text("name").value_or("") : "";
    const auto number = reader.integer("vkFormat", std::numeric_limits<std::uint32_t>::max());
    const std::optional<TexelFormat> format = texelFormatFrom(std::uint32_t(number.value_or(0)));
    if (number && !format)
      reader.error("table-cooked", "vkFormat",
                   std::to_string(*number) +
                       "; expected the vkFormat of a format of the extension");
    table.width = side("width", 1);
    table.height = side("height", 1);
    table.depth = side("depth", 0);
    const auto chain =
        std::uint64_t(std::bit_width(std::max({table.width, table.height, table.depth})));
    table.mipLevels =
        std::uint32_t(reader.integer("mipLevels", chain, "table-cooked", 1).value_or(1));
    const auto offset = reader.integer("offset", file_.size(), "table-cooked", end_);
    reader.warnOfUnknown();
    if (findings.errorCount() > errorsBefore)
      return std::nullopt;
    table.format = *format;
    const LevelRange last = levelRange(table, table.mipLevels - 1);
    const std::size_t size = last.offset + last.size;
    if (size > file_.size() - *offset) {
      reader.error("table-cooked", "offset",
                   "the texels end at byte " + std::to_string(*offset + size) +
                       ", the file at byte " + std::to_string(file_.size()) +
                       ": the file is truncated");
      return std::nullopt;
    }
    table.borrowedTexels = file_.subspan(*offset, size);
    end_ = *offset + size;
    if (hasFiniteTexels(table))
      return table;
    findings.error("table-cooked", reader.pointer(),
                   "a texel is NaN or infinite; expected finite values");
    return std::nullopt;
  }

private:
  std::span<const std::byte> file_;
  std::size_t end_; ///< of the texels read so far: tables that shared bytes could claim any memory
};

/// Reads the document. Returns the first byte after it, or nothing and a finding.
std::optional<std::size_t> readDescription(std::span<const std::byte> file, FindingList& findings,
                                           json& document) {
  // Those of a noise take some 2 KiB and 150 values.
  constexpr std::size_t kMostBytes = std::size_t(16) << 20;
  constexpr std::size_t kMostValues = std::size_t(1) << 20;
  constexpr std::size_t kMostDepth = 16;
  const auto fail = [&](const std::string& message) {
    findings.error("cooked", "", message);
    return std::nullopt;
  };
  if (file.size() < kCookedHeaderBytes)
    return fail("the cooked bundle ends inside its header");
  if (const std::uint32_t version = word(file, kCookedMagic.size()); version != kCookedVersion)
    return fail("cooked bundle of version " + std::to_string(version) + "; expected " +
                std::to_string(kCookedVersion) + ": cook it again with this release");
  const std::size_t size = word(file, kCookedMagic.size() + sizeof(std::uint32_t));
  if (size > file.size() - kCookedHeaderBytes || size > kMostBytes)
    return fail("description of " + std::to_string(size) + " bytes; expected at most " +
                std::to_string(std::min(file.size() - kCookedHeaderBytes, kMostBytes)) +
                ", is the file truncated?");
  if (buildJson(file.subspan(kCookedHeaderBytes, size), JsonEncoding::cbor, kMostValues, kMostDepth,
                document) ||
      !document.is_object())
    return fail("the description is not CBOR as lichen cook writes it");
  return kCookedHeaderBytes + size;
}

} // namespace

bool isCooked(std::span<const std::byte> file) {
  const std::string_view text(reinterpret_cast<const char*>(file.data()), file.size());
  return text.starts_with(kCookedMagic);
}

std::optional<Bundle> readCooked(std::span<const std::byte> file, FindingList& findings) {
  struct Document {
    ~Document() { dismantle(value); }
    json value;
  } document;
  const auto firstByte = readDescription(file, findings, document.value);
  if (!firstByte)
    return std::nullopt;
  CookedTables tables(file, *firstByte);
  return readExtension(document.value, tables, findings);
}

} // namespace lichen
