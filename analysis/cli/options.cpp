// SPDX-License-Identifier: MIT
// Texts of options -> values, and the text that --help prints.
#include "options.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>

#include <cctype>
#include <charconv>
#include <limits>
#include <string_view>
#include <type_traits>

namespace lichen::cli {
namespace {

/// Wide enough for most placeholders; after a longer one the description starts on the next line.
constexpr std::size_t kLeftColumn = 32;

template <class Number>
std::optional<Number> parseNumber(std::string_view text) {
  Number value{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

/// As above, in [smallest, largest]; NaN lies outside every range.
template <class Number>
std::optional<Number> parseNumber(std::string_view text, Number smallest, Number largest) {
  const std::optional<Number> value = parseNumber<Number>(text);
  return value && *value >= smallest && *value <= largest ? value : std::nullopt;
}

/// Returns the digits without an exponent, for example "0.000001".
template <class Number>
std::string plain(Number value) {
  constexpr std::size_t kMostDigits = 512; // fixed notation of a double has at most 327
  std::array<char, kMostDigits> digits{};
  char* const begin = digits.data();
  char* const end = begin + digits.size();
  if constexpr (std::is_integral_v<Number>)
    return {begin, std::to_chars(begin, end, value).ptr};
  else
    return {begin, std::to_chars(begin, end, value, std::chars_format::fixed).ptr};
}

template <class Number>
Accepted<Number> numberBetween(const std::string& kind, Number smallest, Number largest) {
  return {"N", fmt::format("{} from {} to {}", kind, plain(smallest), plain(largest)),
          [=](const std::string& text) { return parseNumber(text, smallest, largest); }};
}

class HelpFormatter : public CLI::Formatter {
public:
  std::string make_option_opts(const CLI::Option* option) const override {
    return option->get_type_name().empty() ? "" : " " + option->get_type_name();
  }

  std::string make_option_desc(const CLI::Option* option) const override {
    std::string text = option->get_description();
    if (!option->get_default_str().empty())
      text += fmt::format(" [default: {}]", option->get_default_str());
    if (option->get_required() && option->nonpositional())
      text += " (required)";
    return text;
  }
};

} // namespace

std::string alternatives(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t w = 0; w < words.size(); ++w)
    text += (w == 0 ? "" : w + 1 == words.size() ? " or " : ", ") + words[w];
  return text;
}

Accepted<int> wholeNumber(int smallest, int largest) {
  return numberBetween("a whole number", smallest, largest);
}

Accepted<double> number(NumberRange range, const std::string& unit) {
  Accepted<double> accepted = numberBetween(
      unit.empty() ? std::string("a number") : "a number of " + unit, range.least, range.most);
  if (!unit.empty()) {
    accepted.placeholder = unit;
    for (char& letter : accepted.placeholder)
      letter = char(std::toupper(static_cast<unsigned char>(letter)));
  }
  return accepted;
}

Accepted<std::uint32_t> seedNumber() {
  return numberBetween("a whole number", std::uint32_t(0),
                       std::numeric_limits<std::uint32_t>::max());
}

Accepted<std::array<int, 2>> imageSize(int largest) {
  return {
      "WxH|N", fmt::format("a size from 1x1 to {0}x{0}, or one number for a square", largest),
      [=](const std::string& text) -> std::optional<std::array<int, 2>> {
        if (const std::optional<int> side = parseNumber(text, 1, largest))
          return std::array<int, 2>{*side, *side};
        const std::size_t cross = std::min(text.find('x'), text.size() - 1);
        const auto width = parseNumber(std::string_view(text).substr(0, cross), 1, largest);
        const auto height = parseNumber(std::string_view(text).substr(cross + 1), 1, largest);
        return width && height ? std::optional(std::array<int, 2>{*width, *height}) : std::nullopt;
      }};
}

Accepted<std::array<double, 2>> coordinates(NumberRange range) {
  return {"X,Y",
          fmt::format("X,Y with numbers from {} to {}", plain(range.least), plain(range.most)),
          [=](const std::string& text) { return numbersFrom<2>(text, range); }};
}

std::optional<std::vector<double>> numbersFrom(std::string_view text, NumberRange range,
                                               std::size_t least, std::size_t most,
                                               std::string_view separators) {
  std::vector<double> values;
  for (std::size_t begin = 0, end = 0; end != std::string_view::npos; begin = end + 1) {
    end = text.find_first_of(separators, begin);
    const auto value = parseNumber(text.substr(begin, end - begin), range.least, range.most);
    if (!value || values.size() == most)
      return std::nullopt;
    values.push_back(*value);
  }
  return values.size() >= least ? std::optional(std::move(values)) : std::nullopt;
}

Accepted<std::vector<double>> numbers(NumberRange range, std::size_t most) {
  return {"N,N,...",
          fmt::format("1 to {} numbers from {} to {}, with commas between them", most,
                      plain(range.least), plain(range.most)),
          [=](const std::string& text) { return numbersFrom(text, range, 1, most); }};
}

const Option& Option::required() const {
  option_->required();
  return *this;
}

const Option& Option::group(const std::string& heading) const {
  option_->group(heading);
  return *this;
}

const Option& Option::shownDefault(const std::string& words) const {
  option_->default_str(words);
  return *this;
}

Option addReadOption(CLI::App& verb, const std::string& name, const std::string& placeholder,
                     const std::string& sentence, std::function<bool(const std::string&)> take,
                     const std::string& preset, const std::string& help) {
  const auto read = [=](const std::string& text) {
    if (!take(text))
      throw CLI::ValidationError(name + " " + text, "expected " + sentence);
  };
  return Option(verb.add_option_function<std::string>(name, read, help)
                    ->type_name(placeholder)
                    ->default_str(preset));
}

Option addText(CLI::App& verb, const std::string& name, std::string& value,
               const std::string& placeholder, const std::string& help) {
  return Option(verb.add_option(name, value, help)->type_name(placeholder));
}

Option addTexts(CLI::App& verb, const std::string& name, std::vector<std::string>& values,
                const std::string& placeholder, const std::string& help) {
  return Option(verb.add_option(name, values, help)
                    ->type_name(placeholder)
                    ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll));
}

void addFlag(CLI::App& verb, const std::string& name, bool& flag, const std::string& help) {
  verb.add_flag(name, flag, help)->disable_flag_override();
}

void addPreviewShape(CLI::App& verb, PreviewShape& shape) {
  const Choices<PreviewShape> shapes{{"sphere", PreviewShape::sphere},
                                     {"plane", PreviewShape::plane},
                                     {"none", PreviewShape::none}};
  addValue(verb, "--preview", shape, oneOf(shapes), "sphere", "Scene that shows the material");
}

std::optional<std::string> givenOf(const CLI::App& verb, const std::string& group) {
  for (const CLI::Option* option : verb.get_options())
    if (option->get_group() == group && option->count() > 0)
      return option->get_name();
  return std::nullopt;
}

bool isGiven(const CLI::App& verb, const std::string& name) { return verb.count(name) > 0; }

std::string parseFault(const CLI::App& app, const CLI::ParseError& error) {
  const std::string text = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    const std::string first = app.remaining(true).front();
    return first + (first.starts_with("-") ? ": no such option" : ": one argument too many");
  }
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) == nullptr)
    return text;
  const std::size_t colon = text.find(':');
  return colon != std::string::npos ? text.substr(0, colon) + ": a value is missing"
                                    : "--" + text.substr(0, text.find(' ')) + ": takes no value";
}

std::shared_ptr<CLI::FormatterBase> helpFormatter() {
  auto formatter = std::make_shared<HelpFormatter>();
  formatter->column_width(kLeftColumn);
  formatter->label("Positionals", "Arguments");
  formatter->label("SUBCOMMAND", "VERB");
  return formatter;
}

} // namespace lichen::cli
