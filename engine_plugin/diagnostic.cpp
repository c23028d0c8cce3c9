// SPDX-License-Identifier: MIT
// A formatted message as one line of UTF-8; see diagnostic.h.
#include "diagnostic.h"

#include <lichen/escaped.h>

#include <algorithm>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <string_view>

namespace lichen::plugin {

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
