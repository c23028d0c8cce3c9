// SPDX-License-Identifier: MIT
// Checks and output that the verbs share.
#include "command.h"

#include "options.h"

#include <lichen/escaped.h>
#include <lichen/files.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace lichen::cli {

Result<void> checkOutput(const std::filesystem::path& output,
                         const std::vector<std::string>& extensions) {
  std::error_code none;
  if (std::filesystem::is_directory(output, none))
    return Error{ErrorKind::usage,
                 fmt::format("{}: is a folder; expected a file name with the extension {}",
                             output.string(), alternatives(extensions))};
  const std::string extension = output.extension().string();
  if (std::find(extensions.begin(), extensions.end(), extension) == extensions.end())
    return Error{ErrorKind::usage, fmt::format("{}: expected the extension {}", output.string(),
                                               alternatives(extensions))};
  return checkFolder(output.parent_path());
}

std::string toText(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string wordsOf(const nlohmann::ordered_json& value) {
  if (value.is_string())
    return value.get<std::string>();
  if (value.is_number_float())
    return fmt::format("{:.6g}", value.get<double>());
  if (!value.is_structured())
    return value.dump();
  std::string list;
  for (const auto& [name, each] : value.items())
    list += (list.empty() ? "" : ", ") + (value.is_object() ? name + " " : "") + wordsOf(each);
  return list;
}

std::vector<std::string> linesOf(const nlohmann::ordered_json& object) {
  std::vector<std::string> lines;
  for (const auto& [name, value] : object.items()) {
    const bool isObject = value.is_object();
    const bool hasObjects = value.is_array() && !value.empty() && value.front().is_object();
    if (value.empty()) // null too
      continue;
    lines.push_back(name + ":" + (isObject || hasObjects ? "" : " " + wordsOf(value)));
    if (isObject)
      for (const std::string& line : linesOf(value))
        lines.push_back("  " + line);
    for (const auto& element : hasObjects ? value : nlohmann::ordered_json::array())
      for (std::string mark = "  - "; const std::string& line : linesOf(element))
        lines.push_back(std::exchange(mark, "    ") + line);
  }
  return lines;
}

// Not fmt::print, which throws if the stream cannot be written.
void printLine(const std::string& text) { std::fputs((text + "\n").c_str(), stdout); }

void say(const SharedOptions& options, const std::string& line) {
  if (!options.quiet && !options.json)
    printLine(escaped(line));
}

void note(const SharedOptions& options, const std::string& line) {
  if (!options.quiet && !options.json)
    std::fputs(("note: " + escaped(line) + "\n").c_str(), stderr);
}

} // namespace lichen::cli
