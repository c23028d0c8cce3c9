// SPDX-License-Identifier: MIT
// Any text -> valid UTF-8; see noise_name.h.
#include "noise_name.h"

#include "command.h"

#include <nlohmann/json.hpp>

namespace lichen::cli {

std::string asUtf8(const std::string& text) {
  constexpr std::string_view kReplacement = "\xEF\xBF\xBD"; // U+FFFD, which toText() inserts
  std::string valid = nlohmann::json::parse(toText(text));
  if (valid == text)
    return text;
  for (std::size_t at; (at = valid.find(kReplacement)) != std::string::npos;)
    valid.replace(at, kReplacement.size(), "_");
  return valid;
}

Accepted<std::string> nameText() {
  return {"NAME", "UTF-8 text", [](const std::string& text) {
            return asUtf8(text) == text ? std::optional(text) : std::nullopt;
          }};
}

} // namespace lichen::cli
