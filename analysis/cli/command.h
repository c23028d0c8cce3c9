// SPDX-License-Identifier: MIT
// The parts that all verbs share: how they are declared, how they run and how they end.
#pragma once

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

/// Exit codes in addition to ErrorKind's.
inline constexpr int kDone = 0;
inline constexpr int kFound = 1; ///< check or compare reports a problem

/// The options of every verb.
struct SharedOptions {
  bool json = false;
  bool quiet = false;
  int threads = 0;         ///< 0: one per processor
  std::string commandLine; ///< all arguments, quoted for a POSIX shell
};

/// Declares the options of a verb. If the user chose the verb, main.cpp calls the returned
/// function, which runs it and returns the exit code or an error. main.cpp declares the options in
/// `shared`, which must outlive both.
using Runner = std::function<Result<int>()>;
[[nodiscard]] Runner addApply(CLI::App& verb, const SharedOptions& shared);
[[nodiscard]] Runner addBake(CLI::App& verb, const SharedOptions& shared);
[[nodiscard]] Runner addCheck(CLI::App& verb, const SharedOptions& shared);
[[nodiscard]] Runner addCompare(CLI::App& verb, const SharedOptions& shared);
[[nodiscard]] Runner addInspect(CLI::App& verb, const SharedOptions& shared);
[[nodiscard]] Runner addLayer(CLI::App& verb, const SharedOptions& shared);
[[nodiscard]] Runner addMerge(CLI::App& verb, const SharedOptions& shared);
[[nodiscard]] Runner addMix(CLI::App& verb, const SharedOptions& shared);
[[nodiscard]] Runner addSynth(CLI::App& verb, const SharedOptions& shared);

/// The footer in the help of each verb that writes a bundle for other tools.
inline constexpr const char* kDroppedByOthers =
    "Tools that rewrite glTF files, such as Blender and optimizers, drop the noise: run 'lichen "
    "apply' last.";

/// Finds errors in the output path before the work starts. Errors: usage if the name has neither of
/// the extensions, environment if the folder does not exist.
[[nodiscard]] Result<void> checkOutput(const std::filesystem::path& output,
                                       const std::vector<std::string>& extensions);

/// Returns indented JSON. Replaces bytes that are not UTF-8, which file names may contain.
[[nodiscard]] std::string toText(const nlohmann::ordered_json& json);

/// Words for a value: lists have commas, numbers up to six digits.
[[nodiscard]] std::string wordsOf(const nlohmann::ordered_json& value);
/// An object for people to read, as YAML has it: a member a line, an object's indented below
/// its name, and a "-" before each object of a list. Null and what is empty is left out.
[[nodiscard]] std::vector<std::string> linesOf(const nlohmann::ordered_json& object);

/// Prints `text` and a newline to standard output. main.cpp detects write errors.
void printLine(const std::string& text);
/// Prints one line to standard output unless `quiet` or `json`.
void say(const SharedOptions& options, const std::string& line);
/// Prints one line to standard error unless `quiet` or `json`: the JSON report has the notes.
void note(const SharedOptions& options, const std::string& line);

} // namespace lichen::cli
