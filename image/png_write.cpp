// SPDX-License-Identifier: MIT
// Image -> PNG bytes without colour chunks, through libpng.
#include "claims.h"

#include <lichen/image_io.h>

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <new>
#include <zlib.h>

namespace lichen {
namespace {

const char* const kName = "PNG";

/// Owns libpng's state. libpng reports errors by longjmp, so every member function that calls it
/// sets a new return point and holds no objects that a longjmp must not skip.
class PngWriter {
public:
  explicit PngWriter(std::vector<std::byte>& bytes) : bytes_(bytes) {}
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;
  ~PngWriter() { png_destroy_write_struct(&png_, &info_); }

  [[nodiscard]] bool start(int width, int height, int channels, int bits);
  [[nodiscard]] bool writeRow(png_const_bytep row);
  [[nodiscard]] bool finish();

private:
  static void onError(png_structp png, png_const_charp) { png_longjmp(png, 1); }
  static void onWarning(png_structp, png_const_charp) {}
  static void onWrite(png_structp png, png_bytep source, std::size_t size);
  static void onFlush(png_structp) {}

  std::vector<std::byte>& bytes_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
};

void PngWriter::onWrite(png_structp png, png_bytep source, std::size_t size) {
  std::vector<std::byte>& bytes = static_cast<PngWriter*>(png_get_io_ptr(png))->bytes_;
  bool written = true;
  try {
    const std::size_t end = bytes.size();
    bytes.resize(end + size);
    std::memcpy(bytes.data() + end, source, size);
  } catch (const std::bad_alloc&) {
    written = false;
  }
  if (!written) // outside the handler, because a longjmp must not leave it
    png_error(png, "out of memory");
}

bool PngWriter::start(int width, int height, int channels, int bits) {
  constexpr std::array<int, 4> kColourTypes = {PNG_COLOR_TYPE_GRAY, PNG_COLOR_TYPE_GRAY_ALPHA,
                                               PNG_COLOR_TYPE_RGB, PNG_COLOR_TYPE_RGB_ALPHA};
  png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, onError, onWarning);
  if (png_ == nullptr)
    return false;
  if (setjmp(png_jmpbuf(png_)) != 0)
    return false;
  info_ = png_create_info_struct(png_);
  if (info_ == nullptr)
    return false;
  png_set_write_fn(png_, this, onWrite, onFlush);
  // Noise hardly repeats within deflate's window: a longer search takes twice the time, and files
  // are as large.
  png_set_compression_level(png_, Z_BEST_SPEED);
  png_set_IHDR(png_, info_, png_uint_32(width), png_uint_32(height), bits,
               kColourTypes[std::size_t(channels - 1)], PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png_, info_);
  return true;
}

bool PngWriter::writeRow(png_const_bytep row) {
  if (setjmp(png_jmpbuf(png_)) != 0)
    return false;
  png_write_row(png_, row);
  return true;
}

bool PngWriter::finish() {
  if (setjmp(png_jmpbuf(png_)) != 0)
    return false;
  png_write_end(png_, info_);
  return true;
}

/// Quantizes one row of values to bytes or big-endian 16-bit codes.
void quantizeRow(std::span<const float> values, int bits, std::vector<png_byte>& row) {
  const float largest = bits == 16 ? 65535.0f : 255.0f;
  auto target = row.begin();
  for (const float value : values) {
    const auto code = unsigned(std::clamp(value, 0.0f, 1.0f) * largest + 0.5f);
    if (bits == 16)
      *target++ = png_byte(code >> 8);
    *target++ = png_byte(code & 0xff);
  }
}

template <class AnyImage>
Result<std::vector<std::byte>> encode(const AnyImage& image, int bits) {
  const auto exhausted = [] { return outOfMemory(kName, "encode the image"); };
  try {
    if (Result<void> encodable =
            checkEncodable(kName, image.width, image.height, image.channels, image.values);
        !encodable)
      return encodable.error();
    if (bits != 8 && bits != 16)
      return Error{ErrorKind::usage,
                   "PNG: " + std::to_string(bits) + " bits per channel; expected 8 or 16"};
    std::vector<std::byte> bytes;
    const std::size_t valuesPerRow = std::size_t(image.width) * std::size_t(image.channels);
    std::vector<png_byte> row(valuesPerRow * std::size_t(bits / 8));
    PngWriter writer(bytes);
    if (!writer.start(image.width, image.height, image.channels, bits))
      return exhausted();
    for (int y = 0; y < image.height; ++y) {
      quantizeRow({image.pixel(0, y), valuesPerRow}, bits, row);
      if (!writer.writeRow(row.data()))
        return exhausted();
    }
    if (!writer.finish())
      return exhausted();
    return bytes;
  } catch (const std::bad_alloc&) {
    return exhausted();
  }
}

} // namespace

Result<std::vector<std::byte>> encodePng(const SrgbImage& image, int bitsPerChannel) {
  return encode(image, bitsPerChannel);
}

Result<std::vector<std::byte>> encodePng(const LinearImage& data, int bitsPerChannel) {
  return encode(data, bitsPerChannel);
}

} // namespace lichen
