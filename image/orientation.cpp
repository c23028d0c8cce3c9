// SPDX-License-Identifier: MIT
// EXIF block -> orientation, through libexif; stored image -> upright image.
// Source: Exif 2.32 (CIPA DC-008), 4.6.4 A, tag 274.
#include "orientation.h"

#include <lichen/image_io.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <libexif/exif-data.h>
#include <limits>
#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace lichen {
namespace {

constexpr int kUpright = 1;
constexpr int kLastOrientation = 8;

/// Which sides of the upright image the first stored row and column are.
struct Sides {
  bool isTransposed = false; ///< stored rows are columns of the upright image
  bool fromRight = false;
  bool fromBottom = false;
};

// Indexed by orientation - 1.
constexpr std::array<Sides, kLastOrientation> kSides{{{false, false, false},
                                                      {false, true, false},
                                                      {false, true, true},
                                                      {false, false, true},
                                                      {true, false, false},
                                                      {true, true, false},
                                                      {true, true, true},
                                                      {true, false, true}}};

const Sides& sidesOf(int orientation) {
  assert(orientation >= kUpright && orientation <= kLastOrientation);
  return kSides[std::size_t(orientation - kUpright)];
}

template <class AnyImage>
AnyImage reoriented(const AnyImage& stored, const Sides& sides) {
  const auto [width, height] = sides.isTransposed ? std::pair(stored.height, stored.width)
                                                  : std::pair(stored.width, stored.height);
  AnyImage result(width, height, stored.channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int across = sides.fromRight ? width - 1 - x : x;
      const int down = sides.fromBottom ? height - 1 - y : y;
      const float* source =
          sides.isTransposed ? stored.pixel(down, across) : stored.pixel(across, down);
      std::copy_n(source, stored.channels, result.pixel(x, y));
    }
  return result;
}

} // namespace

int exifOrientation(std::span<const std::byte> block) {
  constexpr std::array<unsigned char, 6> kHeader{'E', 'x', 'i', 'f', 0, 0}; // libexif expects it
  if (block.empty() || block.size() > std::numeric_limits<unsigned>::max() - kHeader.size())
    return kUpright;
  std::vector<unsigned char> headed(kHeader.begin(), kHeader.end());
  headed.reserve(kHeader.size() + block.size());
  for (const std::byte value : block)
    headed.push_back(std::to_integer<unsigned char>(value));
  const std::unique_ptr<ExifData, decltype(&exif_data_unref)> data(exif_data_new(),
                                                                   &exif_data_unref);
  if (!data)
    throw std::bad_alloc();
  // Otherwise libexif adds entries that the specification requires and changes ones that it
  // forbids.
  exif_data_unset_option(data.get(), EXIF_DATA_OPTION_FOLLOW_SPECIFICATION);
  exif_data_load_data(data.get(), headed.data(), unsigned(headed.size()));
  const ExifEntry* entry = exif_content_get_entry(data->ifd[EXIF_IFD_0], EXIF_TAG_ORIENTATION);
  if (entry == nullptr || entry->format != EXIF_FORMAT_SHORT || entry->size < sizeof(ExifShort))
    return kUpright;
  const int value = exif_get_short(entry->data, exif_data_get_byte_order(data.get()));
  return value >= kUpright && value <= kLastOrientation ? value : kUpright;
}

ImageFile upright(ImageFile file) {
  if (file.orientation == kUpright)
    return file;
  const Sides& sides = sidesOf(file.orientation);
  std::visit([&](auto& stored) { stored = reoriented(stored, sides); }, file.pixels);
  file.notes.push_back("rotated or mirrored according to its EXIF orientation " +
                       std::to_string(file.orientation));
  file.turnedFrom = file.orientation;
  file.orientation = kUpright;
  return file;
}

std::array<float, 2> uprightDirection(std::array<float, 2> stored, int orientation) {
  const Sides& sides = sidesOf(orientation);
  auto [right, down] = stored;
  if (sides.isTransposed)
    std::swap(right, down);
  return {sides.fromRight ? -right : right, sides.fromBottom ? -down : down};
}

} // namespace lichen
