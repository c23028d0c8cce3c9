// SPDX-License-Identifier: MIT
// Options whose text is read by rules of our own, so that help and messages speak of options and
// not of the parser's types. Its headers are not included: each file that does compiles all its
// validators again, which takes longer than a verb.
#pragma once

#include <lichen/bundle_writer.h>

#include <array>
#include <cassert>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CLI {
class App;
class FormatterBase;
class Option;
} // namespace CLI

namespace lichen::cli {

/// What the text of an option may be.
template <class Value>
struct Accepted {
  std::string placeholder; ///< as help shows it: "N", "auto|yes|no"
  std::string sentence;    ///< as a message names it: "a number from 0 to 4", "auto, yes or no"
  std::function<std::optional<Value>(const std::string& text)> read; ///< nothing: not accepted
};

/// "a", "a or b", "a, b or c".
[[nodiscard]] std::string alternatives(const std::vector<std::string>& words);

/// A number in these bounds.
[[nodiscard]] Accepted<int> wholeNumber(int smallest, int largest);
[[nodiscard]] Accepted<double> number(NumberRange range);
/// Any 32 bits.
[[nodiscard]] Accepted<std::uint32_t> seedNumber();
/// "none" -> 0, "4" -> 4 steps of a turn, "free" -> as many as there are.
[[nodiscard]] Accepted<std::uint32_t> tileRotation();
/// "1024x768" -> {1024, 768}; "512" -> {512, 512}. Sides in [1, largest].
[[nodiscard]] Accepted<std::array<int, 2>> imageSize(int largest);
/// "10,-2.5" -> {10.0, -2.5}. Both in `range`.
[[nodiscard]] Accepted<std::array<double, 2>> coordinates(NumberRange range);
/// "0.2,0.5,0.3" -> {0.2, 0.5, 0.3}: 1 to `most` numbers in `range`.
[[nodiscard]] Accepted<std::vector<double>> numbers(NumberRange range, std::size_t most);
/// "16,0,256,128" -> {16, 0, 256, 128}: a corner from 0 and a size from 1 to `largest`.
[[nodiscard]] Accepted<std::array<int, 4>> pixelRectangle(int largest);

/// The same for an option whose absence means something.
template <class Value>
[[nodiscard]] Accepted<std::optional<Value>> optional(Accepted<Value> accepted) {
  const auto read = [read = accepted.read](const std::string& text) {
    const std::optional<Value> value = read(text);
    return value ? std::make_optional(value) : std::nullopt;
  };
  return {accepted.placeholder, accepted.sentence, read};
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

/// An option that has been declared, and what else can be said of it.
class Option {
public:
  explicit Option(CLI::Option* option) : option_(option) {}

  /// The parse fails without it.
  const Option& required() const;
  /// The heading of help under which it stands.
  const Option& group(const std::string& heading) const;

private:
  CLI::Option* option_;
};

/// Declares an option of which `take` reads the text; where it returns false, the parse ends with
/// CLI::ValidationError("NAME TEXT: SENTENCE is accepted").
Option addReadOption(CLI::App& verb, const std::string& name, const std::string& placeholder,
                     const std::string& sentence, std::function<bool(const std::string& text)> take,
                     const std::string& preset, const std::string& help);

/// Declares an option of a verb. `value`, which must outlive the parse, is set to what `preset`
/// says, unless that is empty, and to what the user says.
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

/// An option or argument that is taken as it stands.
Option addText(CLI::App& verb, const std::string& name, std::string& value,
               const std::string& placeholder, const std::string& help);

/// As above, for an argument that may be given again and again.
Option addTexts(CLI::App& verb, const std::string& name, std::vector<std::string>& values,
                const std::string& placeholder, const std::string& help);

/// An option without a value, which sets `flag`.
void addFlag(CLI::App& verb, const std::string& name, bool& flag, const std::string& help);

/// --preview of the verbs that write a scene.
void addPreviewShape(CLI::App& verb, PreviewShape& shape);

/// The first option of this group that was given, or nothing.
[[nodiscard]] std::optional<std::string> givenOf(const CLI::App& verb, const std::string& group);

/// Help with placeholders in the left column, defaults and requirements in the right one.
[[nodiscard]] std::shared_ptr<CLI::FormatterBase> helpFormatter();

} // namespace lichen::cli
