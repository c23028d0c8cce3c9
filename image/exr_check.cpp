// SPDX-License-Identifier: MIT
// Opens an EXR file in memory with OpenEXR's C library and visits its chunks.
#include "exr_check.h"

#include "claims.h"

#include <OpenEXR/openexr.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace lichen {
namespace {

// OpenEXR allocates whole tiles, even if the image is smaller.
constexpr std::int64_t kMaxTileSide = 4096;

// Maximum expansion of the format's compressions, in the format's order. Deflate: a match of 258
// bytes costs two bits. RLE: 2 bytes encode up to 128. PIZ: 9 bits repeat a 2-byte value 255 times.
// PXR24: deflate over three bytes of every four. B44A: 3 bytes encode 4 x 4 half values. DWA:
// deflate over RLE.
constexpr auto kExpansions = std::to_array<Expansion>({
    {"uncompressed EXR", 1},
    {"EXR's RLE", 64},
    {"EXR's ZIPS", 1032},
    {"EXR's ZIP", 1032},
    {"EXR's PIZ", 454},
    {"EXR's PXR24", 1376},
    {"EXR's B44", 11},
    {"EXR's B44A", 11},
    {"EXR's DWAA", 66048},
    {"EXR's DWAB", 66048},
});

/// A file in memory that OpenEXR's C library has opened.
class OpenExr {
public:
  /// Reads the header. An absent attribute has its default.
  OpenExr(std::span<const std::byte> bytes, const std::string& name) : bytes_(bytes), name_(name) {
    exr_context_initializer_t options = EXR_DEFAULT_CONTEXT_INITIALIZER;
    options.error_handler_fn = keepMessage;
    options.user_data = this;
    options.read_fn = readBytes;
    options.size_fn = [](exr_const_context_t, void* file) {
      return std::int64_t(static_cast<const OpenExr*>(file)->bytes_.size());
    };
    options.flags = EXR_CONTEXT_FLAG_STRICT_HEADER | EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;
    opened_ = exr_start_read(&context_, "EXR", &options);
    if (opened_ == EXR_ERR_MISSING_REQ_ATTR && hasPixelAttributes()) {
      // The library has parsed all attributes strictly. It reads the file with defaults for the
      // absent ones if it is not strict, as its C++ interface does.
      exr_finish(&context_);
      message_.front() = '\0';
      options.flags = EXR_CONTEXT_FLAG_DISABLE_CHUNK_RECONSTRUCTION;
      opened_ = exr_start_read(&context_, "EXR", &options);
    }
  }
  OpenExr(const OpenExr&) = delete;
  OpenExr& operator=(const OpenExr&) = delete;
  ~OpenExr() { exr_finish(&context_); }

  [[nodiscard]] exr_const_context_t context() const { return context_; }
  [[nodiscard]] exr_result_t opened() const { return opened_; }

  /// The error for a call that returned `code`. `what` is "damaged EXR" or the like.
  [[nodiscard]] Error failure(exr_result_t code, const std::string& what) const {
    if (code == EXR_ERR_OUT_OF_MEMORY)
      return outOfMemory(name_, "read the EXR");
    const bool isSilent = message_.front() == '\0';
    return badInput(
        name_,
        what + ": " + printable(isSilent ? exr_get_default_error_message(code) : message_.data()));
  }

  /// The outcome of a call that returned `code`.
  [[nodiscard]] Result<void> outcome(exr_result_t code) const {
    return code == EXR_ERR_SUCCESS ? Result<void>() : failure(code, "damaged EXR");
  }

private:
  /// Whether the attributes are present without which the pixels have no size or no meaning.
  [[nodiscard]] bool hasPixelAttributes() const {
    using namespace std::string_view_literals;
    const std::string_view text(reinterpret_cast<const char*>(bytes_.data()), bytes_.size());
    return text.find("dataWindow\0box2i\0"sv) != text.npos &&
           text.find("compression\0compression\0"sv) != text.npos;
  }

  static std::int64_t readBytes(exr_const_context_t, void* file, void* target, std::uint64_t size,
                                std::uint64_t offset, exr_stream_error_func_ptr_t) {
    const std::span<const std::byte> bytes = static_cast<const OpenExr*>(file)->bytes_;
    const std::size_t begin = std::min<std::uint64_t>(offset, bytes.size());
    const std::size_t count = std::min<std::uint64_t>(size, bytes.size() - begin);
    std::memcpy(target, bytes.data() + begin, count);
    return std::int64_t(count);
  }

  static void keepMessage(exr_const_context_t context, exr_result_t, const char* message) {
    void* file = nullptr;
    if (exr_get_user_data(context, &file) == EXR_ERR_SUCCESS && file != nullptr) {
      std::array<char, 256>& kept = static_cast<OpenExr*>(file)->message_;
      std::snprintf(kept.data(), kept.size(), "%s", message);
    }
  }

  std::span<const std::byte> bytes_;
  const std::string& name_;
  std::array<char, 256> message_{}; ///< OpenEXR's last
  exr_context_t context_ = nullptr;
  exr_result_t opened_;
};

Result<void> checkTiles(const OpenExr& exr, const exr_attr_box2i_t& window,
                        const std::string& name) {
  std::uint32_t width = 0, height = 0;
  if (Result<void> known =
          exr.outcome(exr_get_tile_descriptor(exr.context(), 0, &width, &height, nullptr, nullptr));
      !known)
    return known;
  const auto fits = [](std::int64_t tile, std::int64_t least, std::int64_t most) {
    return tile <= std::max(kMaxTileSide, most - least + 1);
  };
  if (fits(width, window.min.x, window.max.x) && fits(height, window.min.y, window.max.y))
    return {};
  return badInput(name, "EXR tiles of " + std::to_string(width) + " x " + std::to_string(height) +
                            "; each side must be at most " + std::to_string(kMaxTileSide) +
                            ", or the image's own");
}

/// Checks the chunks of the full-resolution image, whose size is in range.
Result<void> checkChunks(const OpenExr& exr, const exr_attr_box2i_t& window,
                         const std::string& name) {
  const exr_const_context_t context = exr.context();
  exr_storage_t storage{};
  exr_compression_t compression{};
  if (Result<void> known = exr.outcome(exr_get_storage(context, 0, &storage)); !known)
    return known;
  if (Result<void> known = exr.outcome(exr_get_compression(context, 0, &compression)); !known)
    return known;
  const bool isTiled = storage == EXR_STORAGE_TILED;
  if (!isTiled && storage != EXR_STORAGE_SCANLINE)
    return badInput(name, "is a deep EXR; expected a flat file (scan lines or tiles)");
  if (std::size_t(compression) >= kExpansions.size())
    return badInput(name, "has the unknown EXR compression " + std::to_string(compression) +
                              "; save it with ZIP or PIZ");
  std::int32_t chunkWidth = kMaxImageSide, chunkHeight = 0;
  if (Result<void> tiles = isTiled ? checkTiles(exr, window, name) : Result<void>(); !tiles)
    return tiles;
  const exr_result_t sized = isTiled
                                 ? exr_get_tile_sizes(context, 0, 0, 0, &chunkWidth, &chunkHeight)
                                 : exr_get_scanlines_per_chunk(context, 0, &chunkHeight);
  if (Result<void> known = exr.outcome(sized); !known)
    return known;
  if (chunkWidth < 1 || chunkHeight < 1)
    return badInput(name, "damaged EXR: chunks without pixels");
  int row = 0;
  for (std::int64_t y = window.min.y; y <= window.max.y; y += chunkHeight, ++row) {
    int column = 0;
    for (std::int64_t x = window.min.x; x <= window.max.x; x += chunkWidth, ++column) {
      exr_chunk_info_t chunk{};
      const exr_result_t found =
          isTiled ? exr_read_tile_chunk_info(context, 0, column, row, 0, 0, &chunk)
                  : exr_read_scanline_chunk_info(context, 0, int(y), &chunk);
      if (found != EXR_ERR_SUCCESS)
        return exr.failure(found, "truncated or damaged EXR");
      if (Result<void> expansion = checkExpansion(name, chunk.unpacked_size, chunk.packed_size,
                                                  kExpansions[compression]);
          !expansion)
        return expansion;
    }
  }
  return {};
}

} // namespace

Result<void> checkExr(std::span<const std::byte> file, const std::string& name) {
  constexpr std::size_t kFlags = 5; // the second byte of the version
  constexpr std::byte kMultiPart{0x10};
  if (file.size() > kFlags && (file[kFlags] & kMultiPart) != std::byte{})
    return badInput(name, "is a multi-part EXR; expected a single-part file");
  const OpenExr exr(file, name);
  if (exr.opened() == EXR_ERR_READ_IO)
    return badInput(name, "truncated: the EXR ends inside its header");
  if (exr.opened() != EXR_ERR_SUCCESS)
    return exr.failure(exr.opened(), "damaged EXR");
  exr_attr_box2i_t window{};
  if (Result<void> known = exr.outcome(exr_get_data_window(exr.context(), 0, &window)); !known)
    return known;
  const auto side = [](std::int64_t least, std::int64_t most) {
    return std::uint64_t(most - least + 1);
  };
  if (Result<void> sides =
          checkSides(name, side(window.min.x, window.max.x), side(window.min.y, window.max.y));
      !sides)
    return sides;
  return checkChunks(exr, window, name);
}

} // namespace lichen
