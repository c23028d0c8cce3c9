// SPDX-License-Identifier: MIT
// A formatted message as one line of UTF-8; see diagnostic.h.
#include "diagnostic.h"

#include <algorithm>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string_view>

namespace lichen::plugin {
namespace {

/// Bytes of the UTF-8 character with which a text begins; 0 for a control character, and for what
/// is no character [RFC 3629].
std::size_t characterBytes(std::string_view text) {
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
  // The least code that needs so many bytes; U+0080 to U+009F are control characters.
  constexpr std::uint32_t kLeast[] = {0, 0, 0xa0, 0x800, 0x10000}, kMost = 0x10ffff,
                          kFirstSurrogate = 0xd800, kLastSurrogate = 0xdfff;
  const bool isCharacter =
      code >= kLeast[length] && code <= kMost && (code < kFirstSurrogate || code > kLastSurrogate);
  return isCharacter ? length : 0;
}

} // namespace

void say(LichenDiagnostic* diagnostic, const char* format, ...) noexcept {
  constexpr std::size_t kTextOffset = offsetof(LichenDiagnostic, text);
  if (diagnostic == nullptr || diagnostic->type != LICHEN_STRUCTURE_DIAGNOSTIC ||
      diagnostic->size <= kTextOffset || diagnostic->next != nullptr)
    return;
  // As long as the text may be: escapes make it longer, never shorter, so that a character cut here
  // does not fit there either.
  char message[sizeof diagnostic->text] = "";
  std::va_list arguments;
  va_start(arguments, format);
  const int written = std::vsnprintf(message, sizeof message, format, arguments);
  va_end(arguments);
  if (written < 0) // what stands in the buffer is then not specified
    message[0] = '\0';

  const std::size_t capacity =
      std::min<std::size_t>(diagnostic->size - kTextOffset, sizeof diagnostic->text);
  std::size_t length = 0;
  for (std::string_view rest = message; !rest.empty();) {
    const std::size_t whole = characterBytes(rest);
    char escaped[sizeof "\\xNN"];
    std::snprintf(escaped, sizeof escaped, "\\x%02x", static_cast<unsigned char>(rest[0]));
    const std::string_view shown = whole != 0 ? rest.substr(0, whole) : std::string_view(escaped);
    if (length + shown.size() >= capacity)
      break;
    std::memcpy(diagnostic->text + length, shown.data(), shown.size());
    length += shown.size();
    rest.remove_prefix(std::max<std::size_t>(whole, 1));
  }
  diagnostic->text[length] = '\0';
}

} // namespace lichen::plugin
