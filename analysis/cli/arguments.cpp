// SPDX-License-Identifier: MIT
// Reading arguments and writing lines.
#include "command.h"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cstdio>

namespace lichen::cli {
namespace {

template <class Number>
std::optional<Number> parseNumber(std::string_view text) {
  Number value{};
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc{} || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

} // namespace

void addSharedOptions(CLI::App& verb, SharedOptions& options) {
  verb.add_flag("--json", options.json, "One JSON object on standard output, nothing else there");
  verb.add_flag("--quiet", options.quiet, "No notes; errors only");
  verb.add_option("--threads", options.threads, "Threads to use; 0 for one a processor")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
}

CLI::Validator numberIn(double smallest, double largest) {
  const std::string range = fmt::format("number from {} to {}", smallest, largest);
  return {[=](std::string& text) {
            const std::optional<double> value = parseNumber<double>(text);
            const bool inside = value && *value >= smallest && *value <= largest;
            return inside ? std::string() : fmt::format("{} is no {}", text, range);
          },
          range};
}

Result<std::array<int, 2>> parseSize(const std::string& text) {
  const std::size_t cross = text.find('x');
  const std::optional<int> width = parseNumber<int>(std::string_view(text).substr(0, cross));
  const std::optional<int> height =
      cross == std::string::npos ? width
                                 : parseNumber<int>(std::string_view(text).substr(cross + 1));
  if (!width || !height)
    return Error{
        ErrorKind::usage,
        fmt::format("--size {}: WIDTHxHEIGHT in pixels is accepted, such as 1024x768", text)};
  return std::array<int, 2>{*width, *height};
}

Result<std::array<double, 2>> parsePair(const std::string& option, const std::string& text) {
  const std::size_t comma = text.find(',');
  const std::optional<double> first = parseNumber<double>(std::string_view(text).substr(0, comma));
  const std::optional<double> second =
      comma == std::string::npos ? std::nullopt
                                 : parseNumber<double>(std::string_view(text).substr(comma + 1));
  if (!first || !second)
    return Error{ErrorKind::usage,
                 fmt::format("{} {}: two numbers X,Y are accepted, such as 10,-2.5", option, text)};
  return std::array<double, 2>{*first, *second};
}

Result<void> checkOutput(const std::filesystem::path& output,
                         const std::array<std::string, 2>& extensions) {
  const std::string extension = output.extension().string();
  if (extension != extensions[0] && extension != extensions[1])
    return Error{ErrorKind::usage, fmt::format("{}: the extension {} or {} is accepted",
                                               output.string(), extensions[0], extensions[1])};
  const std::filesystem::path folder = output.has_parent_path() ? output.parent_path() : ".";
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored))
    return Error{ErrorKind::environment,
                 fmt::format("{}: the folder {} does not exist; make it first", output.string(),
                             folder.string())};
  return {};
}

std::string toText(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

void say(const SharedOptions& options, const std::string& line) {
  if (!options.quiet && !options.json)
    fmt::print("{}\n", line);
}

void note(const SharedOptions& options, const std::string& line) {
  if (!options.quiet)
    fmt::print(stderr, "note: {}\n", line);
}

} // namespace lichen::cli
