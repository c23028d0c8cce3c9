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

// Not fmt::print, which throws if the stream cannot be written.
void printLine(const std::string& text) { std::fputs((text + "\n").c_str(), stdout); }

void say(const SharedOptions& options, const std::string& line) {
  if (!options.quiet && !options.json)
    printLine(escaped(line));
}

void note(const SharedOptions& options, const std::string& line) {
  if (!options.quiet)
    std::fputs(("note: " + escaped(line) + "\n").c_str(), stderr);
}

} // namespace lichen::cli
