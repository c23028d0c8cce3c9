// SPDX-License-Identifier: MIT
// Options that parse their own text, so that help and messages describe the option and not CLI11's
// types. This header does not include CLI11: every file that does compiles all its validators
// again, which takes longer than compiling a verb.
#pragma once

#include <lichen/bundle_writer.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace CLI {
class App;
class FormatterBase;
class Option;
class ParseError;
} // namespace CLI

namespace lichen::cli {

/// What an option accepts.
template <class Value>
struct Accepted {
  std::string placeholder; ///< in the help: "N", "auto|yes|no"
  std::string sentence;    ///< in messages: "a number from 0 to 4", "auto, yes or no"
  std::function<std::optional<Value>(const std::string& text)> read; ///< nothing if invalid
};

/// Returns "a", "a or b", or "a, b or c".
[[nodiscard]] std::string alternatives(const std::vector<std::string>& words);

/// A number in [smallest, largest], or in `range`. `unit` is a plural such as "metres": the help
/// and the messages name it.
[[nodiscard]] Accepted<int> wholeNumber(int smallest, int largest);
[[nodiscard]] Accepted<double> number(NumberRange range, const std::string& unit = {});
/// Any unsigned 32-bit number.
[[nodiscard]] Accepted<std::uint32_t> seedNumber();
/// "1024x768" -> {1024, 768}; "512" -> {512, 512}. Both sides in [1, largest].
[[nodiscard]] Accepted<std::array<int, 2>> imageSize(int largest);
/// "10,-2.5" -> {10.0, -2.5}. Both numbers in `range`.
[[nodiscard]] Accepted<std::array<double, 2>> coordinates(NumberRange range);
/// The `least` to `most` numbers in `range` that the text consists of, with one of `separators`
/// between two of them; nothing for other texts.
[[nodiscard]] std::optional<std::vector<double>> numbersFrom(std::string_view text,
                                                             NumberRange range, std::size_t least,
                                                             std::size_t most,
                                                             std::string_view separators = ",");
/// The same for exactly `Count` numbers.
template <std::size_t Count>
[[nodiscard]] std::optional<std::array<double, Count>>
numbersFrom(std::string_view text, NumberRange range, std::string_view separators = ",") {
  const auto values = numbersFrom(text, range, Count, Count, separators);
  if (!values)
    return std::nullopt;
  std::array<double, Count> numbers{};
  std::copy(values->begin(), values->end(), numbers.begin());
  return numbers;
}
/// "0.2,0.5,0.3" -> {0.2, 0.5, 0.3}: 1 to `most` numbers in `range`.
[[nodiscard]] Accepted<std::vector<double>> numbers(NumberRange range, std::size_t most);
/// The same for an option whose absence has a meaning.
template <class Value>
[[nodiscard]] Accepted<std::optional<Value>> optional(Accepted<Value> accepted) {
  const auto read = [read = accepted.read](const std::string& text) {
    const std::optional<Value> value = read(text);
    return value ? std::make_optional(value) : std::nullopt;
  };
  return {accepted.placeholder, accepted.sentence, read};
}

/// The same or "auto", which reads as nothing.
template <class Value>
[[nodiscard]] Accepted<std::optional<Value>> orAuto(const Accepted<Value>& accepted) {
  const auto read = [read = optional(accepted).read](const std::string& text) {
    return text == "auto" ? std::optional<std::optional<Value>>(std::in_place) : read(text);
  };
  return {"auto|" + accepted.placeholder, "auto or " + accepted.sentence, read};
}

template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

template <class Value>
[[nodiscard]] Accepted<Value> oneOf(const Choices<Value>& choices) {
  std::vector<std::string> names;
  std::string placeholder;
  for (const auto& [name, value] : choices) {
    names.push_back(name);
    placeholder += (placeholder.empty() ? "" : "|") + name;
  }
  return {placeholder, alternatives(names),
          [choices](const std::string& text) -> std::optional<Value> {
            for (const auto& [name, value] : choices)
              if (name == text)
                return value;
            return std::nullopt;
          }};
}

/// A declared option, with the properties that can still be set.
class Option {
public:
  explicit Option(CLI::Option* option) : option_(option) {}

  /// Makes the parse fail if the option is absent.
  const Option& required() const;
  /// Sets the heading under which the help lists the option.
  const Option& group(const std::string& heading) const;
  /// Sets what the help shows as the default, where other things than the preset decide.
  const Option& shownDefault(const std::string& words) const;

private:
  CLI::Option* option_;
};

/// Declares an option whose text `take` reads. If `take` returns false, the parse ends with
/// CLI::ValidationError("NAME TEXT: expected SENTENCE").
Option addReadOption(CLI::App& verb, const std::string& name, const std::string& placeholder,
                     const std::string& sentence, std::function<bool(const std::string& text)> take,
                     const std::string& preset, const std::string& help);

/// Declares an option of a verb. Sets `value` to `preset`, unless that is empty, and then to the
/// user's value. `value` must outlive the parse.
template <class Value>
Option addValue(CLI::App& verb, const std::string& name, Value& value,
                const Accepted<Value>& accepted, const std::string& preset,
                const std::string& help) {
  const auto take = [&value, read = accepted.read](const std::string& text) {
    const std::optional<Value> result = read(text);
    if (result)
      value = *result;
    return result.has_value();
  };
  [[maybe_unused]] const bool presetIsAccepted = preset.empty() || take(preset);
  assert(presetIsAccepted);
  return addReadOption(verb, name, accepted.placeholder, accepted.sentence, take, preset, help);
}

/// Declares an option or argument whose text is used unchanged.
Option addText(CLI::App& verb, const std::string& name, std::string& value,
               const std::string& placeholder, const std::string& help);

/// As above, for an argument that may be repeated.
Option addTexts(CLI::App& verb, const std::string& name, std::vector<std::string>& values,
                const std::string& placeholder, const std::string& help);

/// Declares an option without a value; it sets `flag` to true.
void addFlag(CLI::App& verb, const std::string& name, bool& flag, const std::string& help);

/// Declares --preview, for the verbs that write a scene.
void addPreviewShape(CLI::App& verb, PreviewShape& shape);

/// Returns the first option of this group that the user gave, or nothing.
[[nodiscard]] std::optional<std::string> givenOf(const CLI::App& verb, const std::string& group);

/// Whether the user gave an option of a verb.
[[nodiscard]] bool isGiven(const CLI::App& verb, const std::string& name);

/// What is wrong with the arguments, in the words of these programs: for CLI11's "--option: 1
/// required TYPE missing" and "flag was given a disallowed flag override".
[[nodiscard]] std::string parseFault(const CLI::App& app, const CLI::ParseError& error);

/// Formats the help: placeholders in the left column, defaults and requirements in the right one.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> helpFormatter();

} // namespace lichen::cli
