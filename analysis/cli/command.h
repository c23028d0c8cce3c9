// SPDX-License-Identifier: MIT
// What the verbs of the command line share: how they are declared, run and ended.
#pragma once

#include <lichen/result.h>

#include <CLI/App.hpp>
#include <nlohmann/json_fwd.hpp>

#include <array>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace lichen::cli {

inline constexpr const char* kVersion = "0.1.0";

/// Exit codes beside those of ErrorKind.
inline constexpr int kDone = 0;
inline constexpr int kFound = 1; ///< check or compare found something

/// Options that every verb has.
struct SharedOptions {
  bool json = false;
  bool quiet = false;
  int threads = 0; ///< 0: as many as there are processors
};
void addSharedOptions(CLI::App& verb, SharedOptions& options);

/// Declares a verb on `app`. When the verb was given, the returned function runs it: the exit code,
/// or the error that ended it.
using Runner = std::function<Result<int>()>;
[[nodiscard]] Runner addBake(CLI::App& app);
[[nodiscard]] Runner addCheck(CLI::App& app);
[[nodiscard]] Runner addSynth(CLI::App& app);

/// Accepts numbers in [smallest, largest]. CLI::Range accepts NaN too.
[[nodiscard]] CLI::Validator numberIn(double smallest, double largest);

/// "1024x768" -> {1024, 768}; "512" -> {512, 512}. Errors: usage.
[[nodiscard]] Result<std::array<int, 2>> parseSize(const std::string& text);
/// "10,-2.5" -> {10.0, -2.5}. Errors: usage.
[[nodiscard]] Result<std::array<double, 2>> parsePair(const std::string& option,
                                                      const std::string& text);

/// What can be refused before the work is done: a name with none of the two extensions (usage), a
/// folder that is absent (environment).
[[nodiscard]] Result<void> checkOutput(const std::filesystem::path& output,
                                       const std::array<std::string, 2>& extensions);

/// Indented JSON; bytes that are not UTF-8, as file names may have, are replaced.
[[nodiscard]] std::string toText(const nlohmann::ordered_json& json);

/// One line on standard output unless `quiet` or `json`.
void say(const SharedOptions& options, const std::string& line);
/// One line on standard error unless `quiet`.
void note(const SharedOptions& options, const std::string& line);

} // namespace lichen::cli
