// SPDX-License-Identifier: MIT
// JPEG bytes -> SrgbImage, through libjpeg-turbo.
// Grey, YCbCr, RGB, CMYK and YCCK; ignores colour profiles.
// Sources: ITU-T T.81; Adobe Technical Note 5116 (Adobe programs store CMYK inverted).
#include "claims.h"
#include "codecs.h"
#include "orientation.h"

#include <jpeglib.h>

#include <algorithm>
#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <jerror.h>
#include <string_view>
#include <vector>

namespace lichen {
namespace {

// A block of 8 x 8 pixels costs at least one bit, and odd sampling factors halve the number of
// blocks.
constexpr Expansion kHuffman = {"JPEG", 1024};

// Each scan of a progressive file processes the whole image for only a few bytes of file. Encoders
// write about 10 scans, optimisers fewer than 20.
constexpr int kMaxScans = 64;

constexpr int kExifMarker = JPEG_APP0 + 1; // also used by XMP

/// Owns libjpeg's state. libjpeg reports errors by longjmp, so every member function that calls it
/// sets a new return point and holds no objects that a longjmp must not skip.
class JpegReader {
public:
  explicit JpegReader(std::span<const std::byte> file) : file_(file) {}
  JpegReader(const JpegReader&) = delete;
  JpegReader& operator=(const JpegReader&) = delete;
  ~JpegReader() { jpeg_destroy_decompress(&info_); }

  [[nodiscard]] bool readHeader();
  [[nodiscard]] bool start(J_COLOR_SPACE colourSpace);
  [[nodiscard]] bool readRow(JSAMPROW row);
  /// Reads up to the end-of-image marker.
  [[nodiscard]] bool finish();

  [[nodiscard]] const jpeg_decompress_struct& info() const { return info_; }
  [[nodiscard]] const char* warning() const { return warning_; }
  /// The first EXIF block of the header; empty if there is none. Valid until finish().
  [[nodiscard]] std::span<const std::byte> exif() const;
  [[nodiscard]] Error error(const std::string& name) const;

private:
  static void onError(j_common_ptr info);
  static void onMessage(j_common_ptr info, int level);
  static void onProgress(j_common_ptr info);
  static JpegReader& self(j_common_ptr info) {
    return *static_cast<JpegReader*>(info->client_data);
  }

  std::span<const std::byte> file_;
  jpeg_decompress_struct info_ = {};
  jpeg_error_mgr errors_ = {};
  jpeg_progress_mgr progress_ = {};
  std::jmp_buf returnPoint_ = {};
  char warning_[JMSG_LENGTH_MAX] = "";
  char message_[JMSG_LENGTH_MAX] = "";
  bool tooManyScans_ = false;
};

void JpegReader::onError(j_common_ptr info) {
  JpegReader& reader = self(info);
  info->err->format_message(info, reader.message_);
  std::longjmp(reader.returnPoint_, 1);
}

void JpegReader::onMessage(j_common_ptr info, int level) {
  if (level >= 0) // trace message
    return;
  const int code = info->err->msg_code;
  const bool harmless = code == JWRN_EXTRANEOUS_DATA || code == JWRN_JFIF_MAJOR ||
                        code == JWRN_ADOBE_XFORM || code == JWRN_BOGUS_ICC;
  if (!harmless)
    onError(info);
  info->err->format_message(info, self(info).warning_);
}

void JpegReader::onProgress(j_common_ptr info) {
  JpegReader& reader = self(info);
  if (reader.info_.input_scan_number <= kMaxScans)
    return;
  reader.tooManyScans_ = true;
  std::longjmp(reader.returnPoint_, 1);
}

bool JpegReader::readHeader() {
  info_.err = jpeg_std_error(&errors_);
  errors_.error_exit = onError;
  errors_.emit_message = onMessage;
  info_.client_data = this;
  if (setjmp(returnPoint_) != 0)
    return false;
  jpeg_create_decompress(&info_); // preserves err and client_data
  progress_.progress_monitor = onProgress;
  info_.progress = &progress_;
  jpeg_mem_src(&info_, reinterpret_cast<const unsigned char*>(file_.data()), file_.size());
  constexpr unsigned kWhole = 0xffff;
  jpeg_save_markers(&info_, kExifMarker, kWhole);
  jpeg_read_header(&info_, TRUE);
  return true;
}

bool JpegReader::start(J_COLOR_SPACE colourSpace) {
  if (setjmp(returnPoint_) != 0)
    return false;
  info_.out_color_space = colourSpace;
  jpeg_start_decompress(&info_);
  return true;
}

bool JpegReader::readRow(JSAMPROW row) {
  if (setjmp(returnPoint_) != 0)
    return false;
  return jpeg_read_scanlines(&info_, &row, 1) == 1;
}

bool JpegReader::finish() {
  if (setjmp(returnPoint_) != 0)
    return false;
  return jpeg_finish_decompress(&info_) != FALSE;
}

std::span<const std::byte> JpegReader::exif() const {
  constexpr std::string_view kName("Exif\0\0", 6);
  for (const jpeg_marker_struct* marker = info_.marker_list; marker; marker = marker->next) {
    const std::span data(marker->data, marker->data_length);
    if (marker->marker == kExifMarker && data.size() >= kName.size() &&
        std::equal(kName.begin(), kName.end(), data.begin()))
      return std::as_bytes(data.subspan(kName.size()));
  }
  return {};
}

Error JpegReader::error(const std::string& name) const {
  if (tooManyScans_)
    return badInput(name, "is a progressive JPEG with more than " + std::to_string(kMaxScans) +
                              " scans; re-encode it with fewer");
  switch (errors_.msg_code) {
  case JERR_OUT_OF_MEMORY:
    return outOfMemory(name, "decode the JPEG");
  case JWRN_JPEG_EOF:
  case JWRN_HIT_MARKER:
    return badInput(name, "truncated: the JPEG ends before its last pixel or its end marker");
  case JERR_EMPTY_IMAGE:
  case JERR_IMAGE_TOO_BIG:
    if (Result<void> sides = checkSides(name, info_.image_width, info_.image_height); !sides)
      return sides.error();
    break;
  default:
    break;
  }
  return badInput(name, "damaged or unsupported JPEG: " + printable(message_) +
                            "; expected a baseline or progressive 8-bit file");
}

Result<void> checkHeader(const JpegReader& reader, std::size_t fileBytes, const std::string& name) {
  const jpeg_decompress_struct& info = reader.info();
  if (Result<void> sides = checkSides(name, info.image_width, info.image_height); !sides)
    return sides;
  // Arithmetic coding has no useful lower bound of bytes per block, and almost no program writes
  // it.
  if (info.arith_code)
    return badInput(name, "is an arithmetic-coded JPEG; expected Huffman coding");
  if (info.jpeg_color_space == JCS_UNKNOWN)
    return badInput(name, "JPEG with " + std::to_string(info.num_components) +
                              " components; expected 1 (grey), 3 (colour) or 4 (CMYK)");
  const std::uint64_t pixels = std::uint64_t(info.image_width) * info.image_height;
  return checkExpansion(name, pixels, fileBytes, kHuffman);
}

/// Converts ink to light without a colour profile: each ink and black absorb independently. With an
/// Adobe marker, the file stores the light that each ink transmits.
void convertCmykRow(const std::vector<JSAMPLE>& row, bool inverted, float* rgb) {
  constexpr float kScale = 1.0f / (255.0f * 255.0f);
  const auto transmitted = [&](JSAMPLE code) { return float(inverted ? code : 255 - code); };
  for (std::size_t i = 0; i < row.size(); i += 4)
    for (std::size_t c = 0; c < 3; ++c)
      *rgb++ = transmitted(row[i + c]) * transmitted(row[i + 3]) * kScale;
}

} // namespace

Result<ImageFile> decodeJpeg(std::span<const std::byte> file, const std::string& name,
                             const SizeCheck& check) {
  JpegReader reader(file);
  if (!reader.readHeader())
    return reader.error(name);
  if (Result<void> header = checkHeader(reader, file.size(), name); !header)
    return header.error();
  const jpeg_decompress_struct& info = reader.info();
  if (Result<void> wanted = checkWanted(check, info.image_width, info.image_height); !wanted)
    return wanted.error();
  const int orientation = exifOrientation(reader.exif());
  const bool grey = info.num_components == 1;
  const bool cmyk = info.num_components == 4;
  if (!reader.start(grey ? JCS_GRAYSCALE : cmyk ? JCS_CMYK : JCS_RGB))
    return reader.error(name);

  SrgbImage image(int(info.output_width), int(info.output_height), grey ? 1 : 3);
  std::vector<JSAMPLE> row(std::size_t(info.output_width) * std::size_t(info.output_components));
  for (int y = 0; y < image.height; ++y) {
    if (!reader.readRow(row.data()))
      return reader.error(name);
    float* target = image.pixel(0, y);
    if (cmyk)
      convertCmykRow(row, info.saw_Adobe_marker != FALSE, target);
    else
      std::transform(row.begin(), row.end(), target,
                     [](JSAMPLE code) { return float(code) / 255.0f; });
  }
  if (!reader.finish())
    return reader.error(name);

  ImageFile result{std::move(image), 8, orientation, {}};
  if (cmyk)
    result.notes.emplace_back("CMYK converted to RGB without a colour profile");
  if (reader.warning()[0] != '\0')
    result.notes.push_back("warning from libjpeg: " + printable(reader.warning()));
  return result;
}

} // namespace lichen
