// SPDX-License-Identifier: MIT
// What the verbs of the command line share: how they are declared, run and ended.
#pragma once

#include <lichen/json_tree.h>
#include <lichen/result.h>

#include <nlohmann/json_fwd.hpp>

#include <array>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
} // namespace CLI

namespace lichen::cli {

/// Exit codes beside those of ErrorKind.
inline constexpr int kDone = 0;
inline constexpr int kFound = 1; ///< check or compare found something

/// Options that every verb has.
struct SharedOptions {
  bool json = false;
  bool quiet = false;
  int threads = 0;         ///< 0: as many as there are processors
  std::string commandLine; ///< the whole, as a shell takes it
};

/// Declares the options of a verb. When the verb was given, the returned function runs it: the exit
/// code, or the error that ended it. `shared`, whose options main.cpp declares, outlives both.
using Runner = std::function<Result<int>()>;
[[nodiscard]] Runner addApply(CLI::App& verb, const SharedOptions& shared);
[[nodiscard]] Runner addBake(CLI::App& verb, const SharedOptions& shared);
[[nodiscard]] Runner addCheck(CLI::App& verb, const SharedOptions& shared);
[[nodiscard]] Runner addCompare(CLI::App& verb, const SharedOptions& shared);
[[nodiscard]] Runner addInspect(CLI::App& verb, const SharedOptions& shared);
[[nodiscard]] Runner addMerge(CLI::App& verb, const SharedOptions& shared);
[[nodiscard]] Runner addMix(CLI::App& verb, const SharedOptions& shared);
[[nodiscard]] Runner addSynth(CLI::App& verb, const SharedOptions& shared);

/// What is under the options of a verb that writes a bundle for others to use.
inline constexpr const char* kDroppedByOthers =
    "Tools that rewrite glTF files, such as Blender and optimizers, drop the noise: run 'lichen "
    "apply' last.";

/// What can be refused before the work is done: a name with none of the two extensions (usage), a
/// folder that is absent (environment).
[[nodiscard]] Result<void> checkOutput(const std::filesystem::path& output,
                                       const std::array<std::string, 2>& extensions);

/// The members of an object and those of another behind them, as part of a report with --json.
[[nodiscard]] nlohmann::ordered_json joined(nlohmann::ordered_json object, const JsonTree& more);
/// "a, b, c, d and 23 others": the first four, which a message has room for.
[[nodiscard]] std::string shortList(std::vector<std::string> items);
/// Indented JSON; bytes that are not UTF-8, as file names may have, are replaced.
[[nodiscard]] std::string toText(const nlohmann::ordered_json& json);

/// `text` and a line's end on standard output. Where that takes no more, main.cpp finds out.
void printLine(const std::string& text);
/// One line on standard output unless `quiet` or `json`.
void say(const SharedOptions& options, const std::string& line);
/// One line on standard error unless `quiet`.
void note(const SharedOptions& options, const std::string& line);

} // namespace lichen::cli
