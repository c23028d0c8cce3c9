// SPDX-License-Identifier: MIT
// Escapes text from files, folders and users so that it stays on one line and cannot control the
// terminal: control characters (C0, DEL and C1) and invalid UTF-8 become \xNN; all other characters
// are unchanged.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace lichen {

/// Length in bytes of the UTF-8 character at the start of a non-empty text; 0 for a control
/// character or invalid UTF-8 [RFC 3629].
[[nodiscard]] inline std::size_t characterBytes(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) {
    return std::uint32_t(static_cast<unsigned char>(text[i]));
  };
  constexpr std::uint32_t kDelete = 0x7f, kFirstContinuation = 0x80, kFirstOfTwo = 0xc0,
                          kFirstOfThree = 0xe0, kFirstOfFour = 0xf0, kFirstOfNone = 0xf8;
  constexpr int kContinuationBits = 6;
  const std::uint32_t first = byte(0);
  if (first < kFirstContinuation)
    return first >= ' ' && first != kDelete ? 1 : 0;
  if (first < kFirstOfTwo || first >= kFirstOfNone)
    return 0;
  const std::size_t length = first < kFirstOfThree ? 2 : first < kFirstOfFour ? 3 : 4;
  if (text.size() < length)
    return 0;
  std::uint32_t code = first & (kDelete >> length);
  for (std::size_t i = 1; i < length; ++i) {
    if (byte(i) < kFirstContinuation || byte(i) >= kFirstOfTwo)
      return 0;
    code = code << kContinuationBits | (byte(i) - kFirstContinuation);
  }
  // The smallest valid code point for each length; U+0080 to U+009F are control characters.
  constexpr std::uint32_t kLeast[] = {0, 0, 0xa0, 0x800, 0x10000}, kMost = 0x10ffff,
                          kFirstSurrogate = 0xd800, kLastSurrogate = 0xdfff;
  const bool isCharacter =
      code >= kLeast[length] && code <= kMost && (code < kFirstSurrogate || code > kLastSurrogate);
  return isCharacter ? length : 0;
}

/// Calls `show` with each character or escaped byte in turn, until it returns false.
template <class Show>
void showEscaped(std::string_view text, const Show& show) {
  while (!text.empty()) {
    const std::size_t length = characterBytes(text);
    char byte[sizeof "\\xNN"];
    std::snprintf(byte, sizeof byte, "\\x%02x", static_cast<unsigned char>(text[0]));
    if (!show(length != 0 ? text.substr(0, length) : std::string_view(byte)))
      return;
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
}

[[nodiscard]] inline std::string escaped(std::string_view text) {
  std::string line;
  showEscaped(text, [&](std::string_view shown) {
    line += shown;
    return true;
  });
  return line;
}

} // namespace lichen
