// SPDX-License-Identifier: MIT
// Image -> PNG -> data URI. Source: RFC 2397.
#include "data_uri.h"

#include <lichen/base64.h>
#include <lichen/image_io.h>

#include <nlohmann/json.hpp>

namespace lichen {
namespace {

using Json = nlohmann::ordered_json;

template <class AnyImage>
Result<Json> encoded(const AnyImage& image) {
  const Result<std::vector<std::byte>> png = encodePng(image, 8);
  if (!png)
    return png.error();
  return Json{{"png", "data:image/png;base64," + encodeBase64(png.value())}};
}

} // namespace

Result<Json> pictureJson(const SrgbImage& image) { return encoded(image); }
Result<Json> pictureJson(const LinearImage& data) { return encoded(data); }

} // namespace lichen
