// SPDX-License-Identifier: MIT
// Arguments in the style of the lichen command, one-line messages, and the exit codes of result.h.
#include "program.h"

#include "failure.h"
#include "printable.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include <cstdio>
#include <exception>
#include <new>
#include <options.h>
#include <sstream>

namespace lichen::renderer {
namespace {

int fail(const char* program, const Error& error) {
  std::fprintf(stderr, "%s: %s\n", program, oneLine(error.message).c_str());
  return int(error.kind);
}

} // namespace

Result<std::optional<std::string>> parseArguments(CLI::App& app, int argc,
                                                  const char* const* argv) {
  app.set_version_flag("--version", app.get_name() + " " LICHEN_VERSION,
                       "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this page and exit");
  app.formatter(cli::helpFormatter());
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) { // --help and --version
    std::ostringstream text;
    app.exit(success, text);
    return std::optional(text.str());
  } catch (const CLI::ParseError& fault) {
    return usageError(app.get_name(), cli::parseFault(app, fault));
  }
  return std::optional<std::string>();
}

Error usageError(const std::string& program, const std::string& message) {
  return Error{ErrorKind::usage, message + "; see '" + program + " --help'"};
}

std::string oneLine(const std::string& text) { return printable(text, std::string::npos); }

void writeNotes(const std::vector<std::string>& notes) {
  for (const std::string& line : notes)
    std::fprintf(stderr, "note: %s\n", oneLine(line).c_str());
}

Result<void> checkMessages(const ValidationMessages& messages) {
  const std::vector<std::string> texts = messages.texts();
  if (texts.empty())
    return {};
  for (const std::string& text : texts)
    std::fprintf(stderr, "%s\n", text.c_str());
  const bool isOne = texts.size() == 1;
  return Error{ErrorKind::environment,
               std::to_string(texts.size()) + (isOne ? " message" : " messages") +
                   " from the Vulkan validation layers; please report " + (isOne ? "it" : "them")};
}

int runProgram(const char* name, const std::function<Result<void>()>& run) {
  try {
    if (const Result<void> done = run(); !done)
      return fail(name, done.error());
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
      return fail(name, {ErrorKind::resources, "standard output: cannot be written"});
    return 0;
  } catch (const Failure& failure) {
    return fail(name, failure.error);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "%s: not enough memory\n", name); // allocates nothing
    return int(ErrorKind::resources);
  } catch (const std::exception& fault) {
    return fail(name, {ErrorKind::environment, fault.what()});
  }
}

} // namespace lichen::renderer
