// SPDX-License-Identifier: MIT
// What the renderer's programs have in common: how they read arguments, speak, and end.
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

/// Adds --help and --version to an app named as its program, and parses. Returns the text that one
/// of the two asked for, or nothing. Errors: usage.
[[nodiscard]] Result<std::optional<std::string>> parseArguments(CLI::App& app, int argc,
                                                                const char* const* argv);

/// A usage error that points at the program's help.
[[nodiscard]] Error usageError(const std::string& program, const std::string& message);

/// The text on one line, whatever names of files it holds.
[[nodiscard]] std::string oneLine(const std::string& text);

/// Each on a line of standard error, after "note: ".
void writeNotes(const std::vector<std::string>& notes);

/// Errors: environment where there are messages, which are then on standard error.
[[nodiscard]] Result<void> checkMessages(const ValidationMessages& messages);

/// Runs it; one line on standard error where it fails or standard output cannot be written. Returns
/// the exit code.
[[nodiscard]] int runProgram(const char* name, const std::function<Result<void>()>& run);

} // namespace lichen::renderer
