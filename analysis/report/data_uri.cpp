// SPDX-License-Identifier: MIT
// Image -> PNG -> base64. Source: RFC 4648, section 4; RFC 2397.
#include "data_uri.h"

#include <lichen/image_io.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace lichen {
namespace {

std::string base64(std::span<const std::byte> bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byteAt = [&](std::size_t k) {
      return k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[k]) : 0u;
    };
    const std::uint32_t three = byteAt(i) << 16u | byteAt(i + 1) << 8u | byteAt(i + 2);
    for (std::size_t digit = 0; digit < 4; ++digit)
      text += i + digit > bytes.size() ? '=' : kDigits[three >> (18u - 6u * digit) & 63u];
  }
  return text;
}

template <class AnyImage>
Result<JsonTree> encoded(const AnyImage& image) {
  const Result<std::vector<std::byte>> png = encodePng(image, 8);
  if (!png)
    return png.error();
  return JsonTree{{"png", "data:image/png;base64," + base64(png.value())}};
}

} // namespace

Result<JsonTree> pictureJson(const SrgbImage& image) { return encoded(image); }
Result<JsonTree> pictureJson(const LinearImage& data) { return encoded(data); }

} // namespace lichen
