// SPDX-License-Identifier: MIT
// Descriptions in a line of text: parts with commas between them, each a name and numbers with
// colons between them, such as ring:8:12,band:0:2:20:40.
#pragma once

#include "../options.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lichen::cli {

/// "ring:8:12" -> 8 and 12; nothing unless `name` begins the text and `least` to `most` numbers in
/// `range` follow.
[[nodiscard]] inline std::optional<std::vector<double>>
numbersAfter(std::string_view name, std::string_view text, NumberRange range, std::size_t least,
             std::size_t most) {
  if (!text.starts_with(name) || text.substr(name.size(), 1) != ":")
    return std::nullopt;
  return numbersFrom(text.substr(name.size() + 1), range, least, most, ":");
}
[[nodiscard]] inline std::optional<std::vector<double>>
numbersAfter(std::string_view name, std::string_view text, NumberRange range, std::size_t count) {
  return numbersAfter(name, text, range, count, count);
}

/// The parts that `read` makes of the text between commas; nothing if it does of one.
template <class Part, class Read>
[[nodiscard]] std::optional<std::vector<Part>> partsFrom(std::string_view text, const Read& read) {
  std::vector<Part> parts;
  for (;;) {
    const std::size_t comma = text.find(',');
    const std::optional<Part> part = read(text.substr(0, comma));
    if (!part)
      return std::nullopt;
    parts.push_back(*part);
    if (comma == std::string_view::npos)
      return parts;
    text.remove_prefix(comma + 1);
  }
}

} // namespace lichen::cli
