// SPDX-License-Identifier: MIT
// Bytes -> base64, the text of data URIs. Source: RFC 4648, section 4.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace lichen {

/// Returns the padded base64 text of `bytes`. Throws std::bad_alloc.
[[nodiscard]] inline std::string encodeBase64(std::span<const std::byte> bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      three = three << 8u | (k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[k]) : 0u);
    for (std::size_t digit = 0; digit < 4; ++digit)
      text += i + digit > bytes.size() ? '=' : kDigits[three >> (18u - 6u * digit) & 63u];
  }
  return text;
}

} // namespace lichen
