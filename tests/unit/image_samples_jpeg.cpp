// SPDX-License-Identifier: MIT
// Sample JPEG files through libjpeg.
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
  std::vector<JSAMPLE> row;
  for (int x = 0; x < jpeg.width; ++x)
    for (int c = 0; c < info.input_components; ++c)
      row.push_back(jpeg.codes[std::size_t(c)]);
  for (int y = 0; y < jpeg.height; ++y) {
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

} // namespace lichen::samples
