// SPDX-License-Identifier: MIT
// Any bytes -> decodeImage() and upright(): the image or the error satisfies its contract.
#include "contract.h"

#include <lichen/image_io.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

using namespace lichen;
using fuzz::isOneLine;
using fuzz::require;

namespace {

template <class AnyImage>
void checkImage(const AnyImage& image) {
  require(image.width >= 1 && image.width <= kMaxImageSide, "width out of range");
  require(image.height >= 1 && image.height <= kMaxImageSide, "height out of range");
  require(image.channels >= 1 && image.channels <= 4, "channels out of range");
  require(image.values.size() == image.pixelCount() * std::size_t(image.channels),
          "number of values");
  constexpr bool kCodes = AnyImage::encoding == Encoding::srgb;
  require(std::all_of(image.values.begin(), image.values.end(),
                      [](float value) {
                        return std::isfinite(value) && value >= 0.0f && (!kCodes || value <= 1.0f);
                      }),
          "a value out of range");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto* bytes = reinterpret_cast<const std::byte*>(data);
  Result<ImageFile> result = decodeImage({bytes, size}, "file");
  if (!result) {
    require(isOneLine(result.error().message), "an error message that is not one line");
    return 0;
  }
  const ImageFile file = upright(std::move(result).value());
  std::visit([](const auto& image) { checkImage(image); }, file.pixels);
  for (const std::string& note : file.notes)
    require(isOneLine(note), "a note of more or less than one line");
  return 0;
}
