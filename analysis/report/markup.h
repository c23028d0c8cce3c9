// SPDX-License-Identifier: MIT
// Text, numbers and elements of the report page. The page is HTML that is well-formed XML too.
#pragma once

#include <string>
#include <string_view>

namespace lichen {

/// The text as it stands in an element or in a quoted attribute. Bytes that are not UTF-8, and
/// control characters other than tab and line feed, become U+FFFD.
[[nodiscard]] std::string htmlText(std::string_view text);

/// An element with this content, which is markup. `tag` is the name and, after a blank, the
/// attributes.
[[nodiscard]] std::string element(std::string_view tag, std::string_view content);

/// A number with three significant digits, and its unit: "0.0123 dB".
[[nodiscard]] std::string shownNumber(double value, std::string_view unit = {});

} // namespace lichen
