// SPDX-License-Identifier: MIT
// Texts and numbers -> HTML.
#include "markup.h"

#include <lichen/escaped.h>

#include <fmt/format.h>

namespace lichen {

std::string htmlText(std::string_view text) {
  constexpr std::string_view kReplacement = "\xEF\xBF\xBD"; // U+FFFD
  std::string safe;
  while (!text.empty()) {
    const std::size_t bytes = std::max<std::size_t>(characterBytes(text), 1);
    switch (text[0]) {
    case '&':
      safe += "&amp;";
      break;
    case '<':
      safe += "&lt;";
      break;
    case '>':
      safe += "&gt;";
      break;
    case '"':
      safe += "&quot;";
      break;
    case '\t':
    case '\n':
      safe += text[0];
      break;
    default:
      safe += characterBytes(text) > 0 ? text.substr(0, bytes) : kReplacement;
    }
    text.remove_prefix(bytes);
  }
  return safe;
}

std::string element(std::string_view tag, std::string_view content) {
  return fmt::format("<{}>{}</{}>", tag, content, tag.substr(0, tag.find(' ')));
}

std::string shownNumber(double value, std::string_view unit) {
  const double rounded = std::stod(fmt::format("{:.2e}", value));
  return fmt::format("{}{}{}", rounded, unit.empty() ? "" : " ", unit);
}

} // namespace lichen
