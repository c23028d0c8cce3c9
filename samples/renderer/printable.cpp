// SPDX-License-Identifier: MIT
// Escapes and cuts; see printable.h.
#include "printable.h"

#include <algorithm>
#include <cstdio>

namespace lichen::renderer {
namespace {

unsigned byteOf(char c) { return static_cast<unsigned char>(c); }

bool continuesCharacter(char c) { return byteOf(c) >= 0x80 && byteOf(c) < 0xc0; }

} // namespace

std::string printable(const std::string& text, std::size_t maxLength) {
  std::size_t end = std::min(text.size(), maxLength);
  while (end > 0 && end < text.size() && continuesCharacter(text[end]))
    --end;
  std::string line;
  const auto escape = [&](char c) {
    char escaped[sizeof "\\xNN"];
    std::snprintf(escaped, sizeof escaped, "\\x%02x", byteOf(c));
    line += escaped;
  };
  for (std::size_t i = 0; i < end; ++i) {
    // U+0080 to U+009F are controls too; in UTF-8 they are C2 80 to C2 9F.
    const bool twoByteControl = byteOf(text[i]) == 0xc2 && i + 1 < end &&
                                byteOf(text[i + 1]) >= 0x80 && byteOf(text[i + 1]) <= 0x9f;
    if (twoByteControl) {
      escape(text[i]);
      escape(text[++i]);
    } else if (byteOf(text[i]) < ' ' || byteOf(text[i]) == 0x7f) {
      escape(text[i]);
    } else {
      line += text[i];
    }
  }
  return end < text.size() ? line + "..." : line;
}

} // namespace lichen::renderer
