// SPDX-License-Identifier: MIT
// Escaping and truncation; see printable.h.
#include "printable.h"

#include <lichen/escaped.h>

#include <algorithm>

namespace lichen::renderer {
namespace {

/// Whether `c` is a UTF-8 continuation byte, 10xxxxxx [RFC 3629].
bool continuesCharacter(char c) { return (static_cast<unsigned char>(c) & 0xc0u) == 0x80u; }

} // namespace

std::string printable(const std::string& text, std::size_t maxLength) {
  std::size_t end = std::min(text.size(), maxLength);
  while (end > 0 && end < text.size() && continuesCharacter(text[end]))
    --end;
  const std::string line = escaped(std::string_view(text).substr(0, end));
  return end < text.size() ? line + "..." : line;
}

} // namespace lichen::renderer
