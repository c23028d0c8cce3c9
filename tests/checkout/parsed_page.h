// SPDX-License-Identifier: MIT
// Reads a report page strictly: as XML of elements, quoted attributes and text, without comments
// and without entities other than the four that texts need. Anything else fails the test.
#pragma once

#include "bundle/data_uri.h"

#include <lichen/escaped.h>
#include <lichen/image_io.h>

#include <catch2/catch.hpp>

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace lichen::test {

struct PageElement {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string ownText; ///< up to the first child
  std::string text;    ///< of this and of all inside it
  std::vector<PageElement> children;

  /// All elements inside with this name, and with this attribute if one is given, in order.
  [[nodiscard]] std::vector<PageElement> all(const std::string& kind, const std::string& key = {},
                                             const std::string& value = {}) const {
    std::vector<PageElement> found;
    for (const PageElement& child : children) {
      const auto attribute = child.attributes.find(key);
      if ((kind.empty() || child.name == kind) &&
          (key.empty() || (attribute != child.attributes.end() && attribute->second == value)))
        found.push_back(child);
      for (PageElement& inner : child.all(kind, key, value))
        found.push_back(std::move(inner));
    }
    return found;
  }
};

class PageParser {
public:
  explicit PageParser(std::string_view page) : rest_(page) {}

  [[nodiscard]] PageElement element() {
    PageElement made;
    expect("<");
    made.name = word();
    while (skipSpace(), rest_.front() != '>' && rest_.front() != '/') {
      const std::string key = word();
      expect("=\"");
      REQUIRE(made.attributes.emplace(key, textUntil('"')).second);
      expect("\"");
    }
    if (accept("/>"))
      return made;
    expect(">");
    while (true) {
      made.text += textUntil('<');
      if (made.children.empty())
        made.ownText = made.text;
      if (accept("</"))
        break;
      made.children.push_back(element());
      made.text += made.children.back().text;
    }
    expect(made.name + ">");
    return made;
  }
  void expect(std::string_view part) {
    INFO("before " << rest_.substr(0, 60));
    REQUIRE(accept(part));
  }
  void skipSpace() { rest_.remove_prefix(std::min(rest_.find_first_not_of(" \n"), rest_.size())); }
  [[nodiscard]] bool isAtEnd() const { return rest_.empty(); }

private:
  [[nodiscard]] bool accept(std::string_view part) {
    const bool isNext = rest_.starts_with(part);
    rest_.remove_prefix(isNext ? part.size() : 0);
    return isNext;
  }
  [[nodiscard]] std::string word() {
    const std::size_t length =
        rest_.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-");
    INFO("before " << rest_.substr(0, 60));
    REQUIRE((length > 0 && length < rest_.size()));
    const std::string name(rest_.substr(0, length));
    rest_.remove_prefix(length);
    return name;
  }
  [[nodiscard]] std::string textUntil(char end) {
    const std::string_view raw = rest_.substr(0, rest_.find(end));
    REQUIRE(raw.size() < rest_.size());
    std::string text;
    for (std::size_t at = 0; at < raw.size();) {
      const std::string_view here = raw.substr(at);
      const std::size_t bytes =
          here[0] == '\n' || here[0] == '\t' ? 1 : characterBytes(here.substr(0, 4));
      const std::size_t length = here[0] == '&' ? here.find(';') + 1 : bytes;
      if (bytes == 0 || here[0] == '<')
        FAIL("at " << here.substr(0, 60));
      static const std::map<std::string_view, char> entities{
          {"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}};
      text += here[0] == '&' ? std::string(1, entities.at(here.substr(0, length)))
                             : std::string(here.substr(0, length));
      at += length;
    }
    rest_.remove_prefix(raw.size());
    return text;
  }

  std::string_view rest_;
};

/// The elements of a part of a page, inside one element without a name.
[[nodiscard]] inline PageElement parsedMarkup(std::string_view markup) {
  PageElement whole;
  for (PageParser parser(markup); parser.skipSpace(), !parser.isAtEnd();)
    whole.children.push_back(parser.element());
  return whole;
}

[[nodiscard]] inline PageElement parsedPage(std::string_view page) {
  constexpr std::string_view kType = "<!DOCTYPE html>\n";
  REQUIRE(page.starts_with(kType));
  return parsedMarkup(page.substr(kType.size()));
}

/// The picture of an element, which an attribute holds as a data URI.
[[nodiscard]] inline SrgbImage pictureOf(const PageElement& element) {
  constexpr std::string_view kStart = "data:image/png;base64,";
  for (const auto& [key, value] : element.attributes)
    if (const std::size_t at = value.find(kStart); at != std::string::npos) {
      const auto file = readDataUri(value.substr(at, value.find(')', at) - at));
      REQUIRE(file);
      return std::get<SrgbImage>(decodeImage(file.value(), "picture").value().pixels);
    }
  FAIL("no picture in " << element.name);
  return {};
}

/// The elements that show pictures: images, and the repetition.
[[nodiscard]] inline std::vector<PageElement> picturesIn(const PageElement& page) {
  std::vector<PageElement> pictures = page.all("img");
  for (PageElement& repeated : page.all("span", "class", "repeated"))
    pictures.push_back(std::move(repeated));
  return pictures;
}

} // namespace lichen::test
