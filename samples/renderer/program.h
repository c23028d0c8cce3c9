// SPDX-License-Identifier: MIT
// Argument parsing, messages and exit codes shared by the renderer's programs.
#pragma once

#include <lichen/result.h>
#include <lichen/vulkan_device.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
} // namespace CLI

namespace lichen::renderer {

/// Adds --help and --version to `app`, which is named after its program, and parses the arguments.
/// Returns the text that --help or --version prints, or nullopt. Errors: usage.
[[nodiscard]] Result<std::optional<std::string>> parseArguments(CLI::App& app, int argc,
                                                                const char* const* argv);

/// A usage error whose message refers to the program's --help.
[[nodiscard]] Error usageError(const std::string& program, const std::string& message);

/// `text` with control characters escaped, so that it stays on one line.
[[nodiscard]] std::string oneLine(const std::string& text);

/// Writes each note to standard error as a line that starts with "note: ".
void writeNotes(const std::vector<std::string>& notes);

/// Errors: environment if there are any messages, after writing them to standard error.
[[nodiscard]] Result<void> checkMessages(const ValidationMessages& messages);

/// Calls `run` and returns the exit code. Writes one line to standard error if `run` fails or
/// standard output cannot be written.
[[nodiscard]] int runProgram(const char* name, const std::function<Result<void>()>& run);

} // namespace lichen::renderer
