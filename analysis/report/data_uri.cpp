// SPDX-License-Identifier: MIT
// Image -> PNG -> data URI. Source: RFC 2397.
#include "data_uri.h"

#include <lichen/base64.h>
#include <lichen/image_io.h>

namespace lichen {
namespace {

template <class AnyImage>
Result<JsonTree> encoded(const AnyImage& image) {
  const Result<std::vector<std::byte>> png = encodePng(image, 8);
  if (!png)
    return png.error();
  return JsonTree{{"png", "data:image/png;base64," + encodeBase64(png.value())}};
}

} // namespace

Result<JsonTree> pictureJson(const SrgbImage& image) { return encoded(image); }
Result<JsonTree> pictureJson(const LinearImage& data) { return encoded(data); }

} // namespace lichen
