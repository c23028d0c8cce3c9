// SPDX-License-Identifier: MIT
// Sample JPEG files, written with libjpeg.
#include "image_samples.h"

#include <jpeglib.h>

#include <cstdio>
#include <cstdlib>

namespace lichen::samples {
namespace {

/// DC, then every coefficient without its last bit, then the last bit of every coefficient.
std::vector<jpeg_scan_info> scanOfEachCoefficient() {
  std::vector<jpeg_scan_info> scans = {{1, {0}, 0, 0, 0, 0}};
  for (const int refined : {0, 1})
    for (int coefficient = 1; coefficient < DCTSIZE2; ++coefficient)
      scans.push_back({1, {0}, coefficient, coefficient, refined, 1 - refined});
  return scans;
}

} // namespace

Bytes makeJpeg(const Jpeg& jpeg) {
  jpeg_compress_struct info = {};
  jpeg_error_mgr errors = {};
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char* buffer = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &buffer, &size);
  info.image_width = JDIMENSION(jpeg.width);
  info.image_height = JDIMENSION(jpeg.height);
  const bool grey = jpeg.colour == JpegColour::grey;
  const bool ink = jpeg.colour == JpegColour::cmyk || jpeg.colour == JpegColour::ycck;
  info.input_components = grey ? 1 : ink ? 4 : 3;
  info.in_color_space = grey ? JCS_GRAYSCALE : ink ? JCS_CMYK : JCS_RGB;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, 100, TRUE);
  if (jpeg.colour == JpegColour::ycck)
    jpeg_set_colorspace(&info, JCS_YCCK);
  if (ink && !jpeg.adobeMarker)
    info.write_Adobe_marker = FALSE;
  info.arith_code = jpeg.arithmetic ? TRUE : FALSE;
  const std::vector<jpeg_scan_info> scans = scanOfEachCoefficient();
  if (jpeg.progressive)
    jpeg_simple_progression(&info);
  if (jpeg.scanPerCoefficient) {
    info.scan_info = scans.data();
    info.num_scans = int(scans.size());
  }
  jpeg_start_compress(&info, TRUE);
  for (int y = 0; y < jpeg.height; ++y) {
    std::vector<JSAMPLE> row;
    for (int x = 0; x < jpeg.width; ++x)
      for (int c = 0; c < info.input_components; ++c) {
        const bool isDark = jpeg.darkFirstBlock && x < DCTSIZE && y < DCTSIZE;
        row.push_back(isDark ? JSAMPLE(0) : jpeg.codes[std::size_t(c)]);
      }
    JSAMPROW pointer = row.data();
    jpeg_write_scanlines(&info, &pointer, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  const auto* first = reinterpret_cast<const std::byte*>(buffer);
  Bytes bytes(first, first + size);
  std::free(buffer);
  return bytes;
}

std::string exifBlock(int orientation, bool bigEndian) {
  std::string block = bigEndian ? "MM" : "II";
  const auto append = [&](unsigned value, unsigned bytes) {
    for (unsigned b = 0; b < bytes; ++b)
      block += char(value >> 8 * (bigEndian ? bytes - 1 - b : b) & 0xff);
  };
  append(42, 2); // TIFF
  append(8, 4);  // offset of IFD 0
  append(1, 2);  // its entries: tag, type SHORT, count, value, 2 bytes of padding
  append(0x112, 2);
  append(3, 2);
  append(1, 4);
  append(unsigned(orientation), 2);
  append(0, 2);
  append(0, 4); // no other IFD
  return block;
}

void insertJpegExif(Bytes& jpeg, const std::string& block) {
  constexpr std::size_t kStart = 2; // SOI
  // The length of the first segment counts itself but not the marker before it.
  const std::size_t at = kStart + 2 +
                         (std::to_integer<std::size_t>(jpeg[kStart + 2]) << 8 |
                          std::to_integer<std::size_t>(jpeg[kStart + 3]));
  const std::string data = std::string("Exif\0\0", 6) + block;
  Bytes marker{std::byte(0xff), std::byte(0xe1), std::byte((data.size() + 2) >> 8),
               std::byte(data.size() + 2)};
  for (const char c : data)
    marker.push_back(std::byte(static_cast<unsigned char>(c)));
  jpeg.insert(jpeg.begin() + std::ptrdiff_t(at), marker.begin(), marker.end());
}

} // namespace lichen::samples
