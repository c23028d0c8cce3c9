// SPDX-License-Identifier: MIT
// Formats a message as one line of UTF-8; see diagnostic.h.
#include "diagnostic.h"

#include <lichen/escaped.h>

#include <algorithm>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <string_view>

namespace lichen::plugin {

void writeDiagnostic(LichenDiagnostic* diagnostic, const char* format, ...) noexcept {
  constexpr std::size_t kTextOffset = offsetof(LichenDiagnostic, text);
  if (diagnostic == nullptr || diagnostic->type != LICHEN_STRUCTURE_DIAGNOSTIC ||
      diagnostic->size <= kTextOffset || diagnostic->next != nullptr)
    return;
  // Same size as the diagnostic's text. Escaping only lengthens a message, so a character cut off
  // here would not fit there either.
  char message[sizeof diagnostic->text] = "";
  std::va_list arguments;
  va_start(arguments, format);
  const int written = std::vsnprintf(message, sizeof message, format, arguments);
  va_end(arguments);
  if (written < 0) // the buffer's content is then unspecified
    message[0] = '\0';

  const std::size_t capacity =
      std::min<std::size_t>(diagnostic->size - kTextOffset, sizeof diagnostic->text);
  std::size_t length = 0;
  showEscaped(message, [&](std::string_view shown) {
    if (length + shown.size() >= capacity)
      return false;
    std::memcpy(diagnostic->text + length, shown.data(), shown.size());
    length += shown.size();
    return true;
  });
  diagnostic->text[length] = '\0';
}

} // namespace lichen::plugin
