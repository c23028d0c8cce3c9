// SPDX-License-Identifier: MIT
// PNG bytes -> SrgbImage, through libpng.
// Skips every chunk except IHDR, PLTE, tRNS, eXIf, IDAT and IEND, so stored values count as sRGB
// codes whatever gamma or profile the file names. A bad checksum in these chunks is an error.
// Source: PNG Specification, third edition, sections 5 (chunks), 11 (IHDR, tRNS, eXIf).
#include "claims.h"
#include "codecs.h"
#include "orientation.h"

#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

namespace lichen {
namespace {

// A deflate match of 258 bytes costs at least two bits.
constexpr Expansion kDeflate = {"PNG", 1032};

constexpr std::size_t kMaxMessage = 160;

/// The fields of IHDR, the first chunk of every PNG.
struct PngHeader {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  unsigned bitDepth = 0;
  unsigned colourType = 0;

  [[nodiscard]] std::uint64_t samplesPerPixel() const {
    switch (colourType) {
    case PNG_COLOR_TYPE_RGB:
      return 3;
    case PNG_COLOR_TYPE_GRAY_ALPHA:
      return 2;
    case PNG_COLOR_TYPE_RGB_ALPHA:
      return 4;
    default:
      return 1;
    }
  }
};

Result<PngHeader> readPngHeader(std::span<const std::byte> file, const std::string& name) {
  constexpr std::size_t kTypeOffset = 12; // after the signature (8) and IHDR's length (4)
  constexpr std::size_t kHeaderEnd = 26;  // up to and including the colour type
  if (file.size() < kHeaderEnd)
    return badInput(name, "truncated: the PNG ends inside its header");
  if (std::memcmp(file.data() + kTypeOffset, "IHDR", 4) != 0)
    return badInput(name, "damaged PNG: the first chunk is not IHDR");
  const auto byte = [&](std::size_t offset) {
    return std::to_integer<std::uint32_t>(file[offset]);
  };
  const auto bigEndian = [&](std::size_t offset) {
    return byte(offset) << 24 | byte(offset + 1) << 16 | byte(offset + 2) << 8 | byte(offset + 3);
  };
  return PngHeader{bigEndian(16), bigEndian(20), byte(24), byte(25)};
}

/// Owns libpng's state. libpng reports errors by longjmp, so every member function that calls it
/// sets a new return point and holds no objects that a longjmp must not skip.
class PngReader {
public:
  explicit PngReader(std::span<const std::byte> file) : rest_(file) {}
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

  /// Reads up to the first IDAT and requests 8 or 16 bits per channel, with palette and tRNS
  /// expanded.
  [[nodiscard]] bool start();
  /// Decodes all rows, then reads up to the end of IEND.
  [[nodiscard]] bool readRows(png_bytepp rows);

  [[nodiscard]] std::size_t rowBytes() const { return png_get_rowbytes(png_, info_); }
  [[nodiscard]] int channels() const { return png_get_channels(png_, info_); }
  [[nodiscard]] int bitDepth() const { return png_get_bit_depth(png_, info_); }
  [[nodiscard]] bool hasTransparentColour() const { return hasTransparentColour_; }
  [[nodiscard]] const char* warning() const { return warning_; }
  /// The EXIF block; empty if there is none. Call after readRows().
  [[nodiscard]] std::span<const std::byte> exif();
  [[nodiscard]] Error error(const std::string& name) const;

private:
  static void onError(png_structp png, png_const_charp message);
  static void onWarning(png_structp png, png_const_charp message);
  static void onRead(png_structp png, png_bytep target, std::size_t size);
  static png_voidp onAllocate(png_structp png, png_alloc_size_t size);
  static void onFree(png_structp, png_voidp memory) { std::free(memory); }
  static PngReader& self(png_voidp pointer) { return *static_cast<PngReader*>(pointer); }

  std::span<const std::byte> rest_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  char message_[kMaxMessage] = "";
  char warning_[kMaxMessage] = "";
  bool truncated_ = false;
  bool outOfMemory_ = false;
  bool hasTransparentColour_ = false;
};

void PngReader::onError(png_structp png, png_const_charp message) {
  std::strncpy(self(png_get_error_ptr(png)).message_, message, kMaxMessage - 1);
  png_longjmp(png, 1);
}

void PngReader::onWarning(png_structp png, png_const_charp message) {
  PngReader& reader = self(png_get_error_ptr(png));
  if (reader.warning_[0] == '\0')
    std::strncpy(reader.warning_, message, kMaxMessage - 1);
}

void PngReader::onRead(png_structp png, png_bytep target, std::size_t size) {
  PngReader& reader = self(png_get_io_ptr(png));
  if (size > reader.rest_.size()) {
    reader.truncated_ = true;
    png_error(png, "truncated");
  }
  std::memcpy(target, reader.rest_.data(), size);
  reader.rest_ = reader.rest_.subspan(size);
}

png_voidp PngReader::onAllocate(png_structp png, png_alloc_size_t size) {
  void* memory = std::malloc(size);
  if (memory == nullptr)
    self(png_get_mem_ptr(png)).outOfMemory_ = true;
  return memory;
}

bool PngReader::start() {
  png_ = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, this, onError, onWarning, this, onAllocate,
                                  onFree);
  if (png_ == nullptr)
    return false;
  if (setjmp(png_jmpbuf(png_)) != 0)
    return false;
  info_ = png_create_info_struct(png_);
  if (info_ == nullptr)
    return false;
  png_set_read_fn(png_, this, onRead);
  png_set_crc_action(png_, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
  // A negative count means every chunk that is not needed to decode the pixels.
  png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
  constexpr png_byte kExif[] = {'e', 'X', 'I', 'f', 0};
  png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_AS_DEFAULT, kExif, 1);
  png_read_info(png_, info_);
  hasTransparentColour_ = png_get_valid(png_, info_, PNG_INFO_tRNS) != 0;
  png_set_expand(png_);
  png_set_swap(png_); // 16-bit values are big-endian in the file
  png_set_interlace_handling(png_);
  png_read_update_info(png_, info_);
  return true;
}

bool PngReader::readRows(png_bytepp rows) {
  if (setjmp(png_jmpbuf(png_)) != 0)
    return false;
  png_read_image(png_, rows);
  png_read_end(png_, info_); // eXIf may follow the pixels
  return true;
}

std::span<const std::byte> PngReader::exif() {
  png_uint_32 size = 0;
  png_bytep data = nullptr;
  if (png_get_eXIf_1(png_, info_, &size, &data) == 0)
    return {};
  return std::as_bytes(std::span(data, size));
}

Error PngReader::error(const std::string& name) const {
  if (outOfMemory_ || png_ == nullptr || info_ == nullptr)
    return outOfMemory(name, "decode the PNG");
  if (truncated_)
    return badInput(name, "truncated: the PNG ends before its IEND chunk is complete");
  return badInput(name, "damaged PNG: " + printable(message_));
}

void describeExpansion(const PngHeader& header, bool transparentColour,
                       std::vector<std::string>& notes) {
  if (header.colourType == PNG_COLOR_TYPE_PALETTE)
    notes.emplace_back("palette expanded to RGB");
  else if (header.bitDepth < 8)
    notes.emplace_back(std::to_string(header.bitDepth) + "-bit grey expanded to 8 bits");
  if (transparentColour)
    notes.emplace_back("transparent colour converted to an alpha channel");
}

} // namespace

Result<ImageFile> decodePng(std::span<const std::byte> file, const std::string& name,
                            const SizeCheck& check) {
  const Result<PngHeader> headerResult = readPngHeader(file, name);
  if (!headerResult)
    return headerResult.error();
  const PngHeader& header = headerResult.value();
  if (Result<void> sides = checkSides(name, header.width, header.height); !sides)
    return sides.error();
  const std::uint64_t bitsPerRow = header.width * header.samplesPerPixel() * header.bitDepth;
  if (Result<void> fits =
          checkExpansion(name, header.height * (bitsPerRow / 8), file.size(), kDeflate);
      !fits)
    return fits.error();
  if (Result<void> wanted = checkWanted(check, header.width, header.height); !wanted)
    return wanted.error();

  PngReader reader(file);
  if (!reader.start())
    return reader.error(name);
  // Not initialised: a truncated file then commits memory only for the rows it has.
  const auto pixels = std::make_unique_for_overwrite<png_byte[]>(reader.rowBytes() * header.height);
  std::vector<png_bytep> rows(header.height);
  for (std::size_t y = 0; y < rows.size(); ++y)
    rows[y] = pixels.get() + y * reader.rowBytes();
  if (!reader.readRows(rows.data()))
    return reader.error(name);

  SrgbImage image(int(header.width), int(header.height), reader.channels());
  if (reader.bitDepth() == 16) {
    const auto* codes = reinterpret_cast<const png_uint_16*>(pixels.get());
    std::transform(codes, codes + image.values.size(), image.values.begin(),
                   [](png_uint_16 code) { return float(code) / 65535.0f; });
  } else {
    std::transform(pixels.get(), pixels.get() + image.values.size(), image.values.begin(),
                   [](png_byte code) { return float(code) / 255.0f; });
  }
  ImageFile result{std::move(image), reader.bitDepth(), exifOrientation(reader.exif()), {}};
  describeExpansion(header, reader.hasTransparentColour(), result.notes);
  if (reader.warning()[0] != '\0')
    result.notes.push_back("warning from libpng: " + printable(reader.warning()));
  return result;
}

} // namespace lichen
