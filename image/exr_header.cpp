// SPDX-License-Identifier: MIT
// Reads the attributes of a single-part EXR file; exr_chunks.cpp checks the chunks.
#include "exr_header.h"

#include "claims.h"
#include "exr_chunks.h"

#include <lichen/image_io.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

namespace lichen {
namespace {

constexpr std::size_t kVersionOffset = 4;
constexpr std::size_t kFirstAttribute = 8;
constexpr std::uint32_t kVersion = 2; // the low byte of the version field; flags are above it
constexpr std::uint32_t kTiledFlag = 0x200;
constexpr std::uint32_t kLongNamesFlag = 0x400;
constexpr std::uint32_t kDeepFlag = 0x800;
constexpr std::uint32_t kMultiPartFlag = 0x1000;
constexpr std::size_t kMaxNameLength = 255; // with the long-names flag; 31 without it

// OpenEXR allocates whole tiles, even if the image is smaller.
constexpr std::int64_t kMaxTileSide = 4096;

/// Reads little-endian values. After reading past the end, ok() is false and values are zero.
class Reader {
public:
  Reader(std::span<const std::byte> bytes, std::size_t offset) : bytes_(bytes), offset_(offset) {}

  [[nodiscard]] bool ok() const { return ok_; }
  [[nodiscard]] bool atEnd() const { return offset_ == bytes_.size(); }
  [[nodiscard]] std::size_t offset() const { return offset_; }

  std::uint32_t byte() {
    const auto one = take(1);
    return one.empty() ? 0 : std::to_integer<std::uint32_t>(one[0]);
  }
  std::uint32_t word() {
    const std::uint32_t b0 = byte();
    const std::uint32_t b1 = byte();
    const std::uint32_t b2 = byte();
    return b0 | b1 << 8 | b2 << 16 | byte() << 24;
  }
  std::int64_t signedWord() { return std::int32_t(word()); }
  std::string text() {
    std::string result;
    for (std::uint32_t c = byte(); c != 0; c = byte()) {
      result += char(c);
      if (result.size() > kMaxNameLength)
        ok_ = false;
      if (!ok_)
        break;
    }
    return result;
  }
  std::span<const std::byte> take(std::size_t size) {
    ok_ = ok_ && size <= bytes_.size() - offset_;
    if (!ok_)
      return {};
    offset_ += size;
    return bytes_.subspan(offset_ - size, size);
  }

private:
  std::span<const std::byte> bytes_;
  std::size_t offset_;
  bool ok_ = true;
};

/// Sizes of the attribute types with a fixed size. OpenEXR reads that many bytes whatever the
/// file's size field says; a different size field would make the two readers disagree.
const std::map<std::string_view, std::size_t>& fixedSizes() {
  static const std::map<std::string_view, std::size_t> sizes = {
      {"box2i", 16},      {"box2f", 16},   {"chromaticities", 32},
      {"compression", 1}, {"double", 8},   {"envmap", 1},
      {"float", 4},       {"int", 4},      {"keycode", 28},
      {"lineOrder", 1},   {"m33f", 36},    {"m33d", 72},
      {"m44f", 64},       {"m44d", 128},   {"rational", 8},
      {"tiledesc", 9},    {"timecode", 8}, {"v2i", 8},
      {"v2f", 8},         {"v2d", 16},     {"v3i", 12},
      {"v3f", 12},        {"v3d", 24},     {"deepImageState", 1}};
  return sizes;
}

bool isWholePreview(std::span<const std::byte> value) {
  Reader reader(value, 0);
  const std::uint64_t width = reader.word();
  const std::uint64_t height = reader.word();
  constexpr std::uint64_t kBytesPerPixel = 4;
  constexpr std::uint64_t kHeaderBytes = 8;
  return reader.ok() && width <= value.size() && height <= value.size() &&
         kHeaderBytes + kBytesPerPixel * width * height == value.size();
}

bool isWholeStringVector(std::span<const std::byte> value) {
  Reader reader(value, 0);
  while (reader.ok() && !reader.atEnd())
    (void)reader.take(reader.word());
  return reader.ok();
}

std::optional<std::vector<ExrChannel>> readChannels(std::span<const std::byte> value) {
  constexpr std::uint32_t kHalf = 1;
  constexpr std::uint32_t kFloat = 2;
  std::vector<ExrChannel> channels;
  Reader reader(value, 0);
  for (std::string name = reader.text(); !name.empty(); name = reader.text()) {
    ExrChannel channel;
    channel.name = name;
    const std::uint32_t type = reader.word();
    channel.bytesPerSample = type == kHalf ? 2 : 4;
    (void)reader.word(); // perceptual flag and padding
    channel.xSampling = reader.signedWord();
    channel.ySampling = reader.signedWord();
    if (!reader.ok() || type > kFloat || channel.xSampling < 1 || channel.ySampling < 1)
      return std::nullopt;
    channels.push_back(std::move(channel));
  }
  if (!reader.ok() || !reader.atEnd())
    return std::nullopt;
  return channels;
}

ExrWindow readWindow(std::span<const std::byte> value) {
  Reader reader(value, 0);
  ExrWindow window;
  window.xMin = reader.signedWord();
  window.yMin = reader.signedWord();
  window.xMax = reader.signedWord();
  window.yMax = reader.signedWord();
  return window;
}

/// Which of the required attributes the header contains.
struct FoundAttributes {
  bool dataWindow = false;
  bool displayWindow = false;
  bool channels = false;
  bool compression = false;
  bool tiles = false;
};

/// Stores one attribute in `header`. Returns false if its value is malformed.
bool readAttribute(const std::string& attribute, const std::string& type,
                   std::span<const std::byte> value, ExrHeader& header, FoundAttributes& found) {
  const auto fixed = fixedSizes().find(type);
  if (fixed != fixedSizes().end() && fixed->second != value.size())
    return false;
  if (type == "preview" && !isWholePreview(value))
    return false;
  if (type == "stringvector" && !isWholeStringVector(value))
    return false;
  if (type == "floatvector" && value.size() % sizeof(float) != 0)
    return false;
  if (attribute == "dataWindow" && type == "box2i") {
    header.dataWindow = readWindow(value);
    found.dataWindow = true;
  } else if (attribute == "displayWindow" && type == "box2i") {
    header.displayWindow = readWindow(value);
    found.displayWindow = true;
  } else if (attribute == "compression" && type == "compression") {
    header.compression = std::to_integer<unsigned>(value[0]);
    found.compression = true;
  } else if (attribute == "tiles" && type == "tiledesc") {
    Reader reader(value, 0);
    header.tileWidth = reader.word();
    header.tileHeight = reader.word();
    found.tiles = true;
  } else if (type == "chlist") {
    std::optional<std::vector<ExrChannel>> channels = readChannels(value);
    if (!channels)
      return false;
    if (attribute == "channels") {
      header.channels = *std::move(channels);
      found.channels = true;
    }
  }
  return true;
}

Result<void> checkVersion(std::uint32_t version, const std::string& name) {
  constexpr std::uint32_t kKnownFlags = kTiledFlag | kLongNamesFlag | kDeepFlag | kMultiPartFlag;
  if ((version & 0xff) != kVersion || (version & ~(kKnownFlags | 0xff)) != 0)
    return badInput(name, "unknown EXR version " + std::to_string(version) + "; expected 2");
  if ((version & kMultiPartFlag) != 0)
    return badInput(name, "is a multi-part EXR; expected a single-part file");
  if ((version & kDeepFlag) != 0)
    return badInput(name, "is a deep EXR; expected a flat file (scan lines or tiles)");
  return {};
}

Result<void> checkValues(const ExrHeader& header, const FoundAttributes& found,
                         const std::string& name) {
  const auto missing = [&](const char* attribute) {
    return badInput(name, std::string("damaged EXR: missing attribute ") + attribute);
  };
  if (!found.dataWindow)
    return missing("dataWindow");
  if (!found.displayWindow)
    return missing("displayWindow");
  if (!found.compression)
    return missing("compression");
  if (!found.channels || header.channels.empty())
    return missing("channels");
  if (header.tiled && !found.tiles)
    return missing("tiles");
  const ExrWindow& window = header.dataWindow;
  const auto side = [](std::int64_t length) {
    return std::uint64_t(std::max<std::int64_t>(length, 0));
  };
  if (Result<void> sides = checkSides(name, side(window.width()), side(window.height())); !sides)
    return sides;
  const auto tileFits = [](std::int64_t tile, std::int64_t image) {
    return tile >= 1 && tile <= std::max(kMaxTileSide, image);
  };
  if (header.tiled && (!tileFits(header.tileWidth, window.width()) ||
                       !tileFits(header.tileHeight, window.height())))
    return badInput(name, "EXR tiles of " + std::to_string(header.tileWidth) + " x " +
                              std::to_string(header.tileHeight) + "; each side must be 1 to " +
                              std::to_string(kMaxTileSide) + ", or at most the image's own");
  return {};
}

} // namespace

Result<ExrHeader> readExrHeader(std::span<const std::byte> file, const std::string& name) {
  const Error truncated = badInput(name, "truncated: the EXR ends inside its header");
  Reader version(file, kVersionOffset);
  const std::uint32_t versionAndFlags = version.word();
  if (!version.ok())
    return truncated;
  if (Result<void> supported = checkVersion(versionAndFlags, name); !supported)
    return supported.error();

  ExrHeader header;
  header.tiled = (versionAndFlags & kTiledFlag) != 0;
  FoundAttributes found;
  Reader reader(file, kFirstAttribute);
  for (std::string attribute = reader.text(); !attribute.empty(); attribute = reader.text()) {
    const std::string type = reader.text();
    const std::span<const std::byte> value = reader.take(reader.word());
    if (!reader.ok())
      return truncated;
    if (!readAttribute(attribute, type, value, header, found))
      return badInput(name, "damaged EXR: attribute " + printable(attribute) + " is not a valid " +
                                printable(type));
  }
  if (!reader.ok())
    return truncated;
  header.chunkTable = reader.offset();
  if (Result<void> values = checkValues(header, found, name); !values)
    return values.error();
  if (Result<void> chunks = checkExrChunks(file, header, name); !chunks)
    return chunks.error();
  return header;
}

} // namespace lichen
