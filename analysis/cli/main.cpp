// SPDX-License-Identifier: MIT
// lichen: the verb table. Converts each outcome to an exit code and one line.
#include "command.h"
#include "options.h"

#include <lichen/escaped.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/core.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iterator>
#include <new>
#include <thread>

namespace lichen::cli {
namespace {

struct Verb {
  const char* name;
  const char* help;
  Runner (*add)(CLI::App&, const SharedOptions&);
};
constexpr Verb kVerbs[] = {
    {"bake", "Turn a photograph of a material into noise", addBake},
    {"mix", "Turn several photographs into one noise that changes from the first to the last",
     addMix},
    {"synth", "Write an image of a noise, without a GPU", addSynth},
    {"inspect", "Show what a bundle holds and what it costs", addInspect},
    {"check", "Find faults in a bundle", addCheck},
    {"compare", "Measure a result against its exemplar", addCompare},
    {"merge", "Put several noises into one bundle", addMerge},
    {"layer", "Combine noises into one in which they alternate", addLayer},
    {"apply", "Put a noise on the materials of a scene", addApply},
};

std::string verbNames() {
  std::vector<std::string> names;
  for (const Verb& verb : kVerbs)
    names.push_back(verb.name);
  return alternatives(names);
}

int fail(const Error& error) {
  // Ignores write errors and throws nothing: no fallback remains.
  std::fputs(("lichen: " + escaped(error.message) + "\n").c_str(), stderr);
  return int(error.kind);
}

/// Returns the exit code, or an error if the output did not reach standard output, as on a full
/// disk.
int flushed(int code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0)
    return code;
  return fail({ErrorKind::resources, "standard output: cannot be written"});
}

/// Reports a usage error, and where to read more.
int failUsage(const CLI::App& app, const std::string& message) {
  const auto given = app.get_subcommands();
  return fail(
      {ErrorKind::usage, fmt::format("{}; see 'lichen {}--help'", message,
                                     given.empty() ? "" : given.front()->get_name() + " ")});
}

void addSharedOptions(CLI::App& verb, SharedOptions& options) {
  addFlag(verb, "--json", options.json,
          "Print one JSON object on standard output and nothing else");
  addFlag(verb, "--quiet", options.quiet, "Print errors only: no notes, no progress, no result");
  addValue(verb, "--threads", options.threads, wholeNumber(0, 1024), "0",
           "Number of threads; 0 means one per processor");
}

/// Returns the arguments, quoted for a POSIX shell.
std::string commandLine(int argc, char** argv) {
  constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                      "0123456789_@%+=:,./-";
  std::string line = "lichen";
  for (int i = 1; i < argc; ++i) {
    std::string argument = argv[i];
    if (argument.empty() || argument.find_first_not_of(kPlain) != std::string::npos) {
      for (std::size_t at = 0; (at = argument.find('\'', at)) != std::string::npos; at += 4)
        argument.replace(at, 1, "'\\''");
      argument = "'" + argument + "'";
    }
    line += " " + argument;
  }
  return line;
}

/// Returns the arguments, last first as CLI11 expects them. `help` and `help help` become `--help`,
/// and `help VERB` becomes `VERB --help`.
std::vector<std::string> argumentsOf(int argc, char** argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  if (!arguments.empty() && arguments.front() == "help") {
    const bool isOfVerb = arguments.size() > 1 &&
                          std::any_of(std::begin(kVerbs), std::end(kVerbs),
                                      [&](const Verb& verb) { return verb.name == arguments[1]; });
    arguments.erase(arguments.begin());
    if (arguments == std::vector<std::string>{"help"})
      arguments.clear();
    if (isOfVerb || arguments.empty())
      arguments.emplace_back("--help");
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

int run(int argc, char** argv) {
  CLI::App app{"Lichen turns a photograph of a material into noise: an endless, seamless texture.",
               "lichen"};
  app.set_version_flag("--version", "lichen " LICHEN_VERSION, "Print the version and exit");
  app.set_help_flag("-h,--help", "Print this page and exit");
  app.require_subcommand(0, 1); // 0 is refused below: with 1, CLI11 would not name an unknown verb
  app.formatter(helpFormatter());
  app.option_defaults()->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  SharedOptions shared;
  shared.commandLine = commandLine(argc, argv);
  std::vector<std::pair<const CLI::App*, Runner>> verbs;
  for (const Verb& verb : kVerbs) {
    CLI::App* added = app.add_subcommand(verb.name, verb.help)->group("Verbs");
    verbs.emplace_back(added, verb.add(*added, shared));
    addSharedOptions(*added, shared);
  }
  app.footer("'lichen help VERB' lists the options of a verb."); // later verbs would inherit it
  try {
    app.parse(argumentsOf(argc, argv));
  } catch (const CLI::Success& success) { // --help and --version
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    const std::vector<std::string> rest = app.remaining(true);
    if (!rest.empty() && !rest.front().starts_with("-") && app.get_subcommands().empty())
      return failUsage(app,
                       fmt::format("{}: no such verb; expected {}", rest.front(), verbNames()));
    return failUsage(app, parseFault(app, error));
  }
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism,
                                    shared.threads > 0
                                        ? std::size_t(shared.threads)
                                        : std::max(1u, std::thread::hardware_concurrency()));
  for (const auto& [verb, runner] : verbs)
    if (verb->parsed()) {
      const Result<int> result = runner();
      return result ? result.value() : fail(result.error());
    }
  return failUsage(app, "a verb is missing; expected " + verbNames());
}

} // namespace
} // namespace lichen::cli

int main(int argc, char** argv) {
  // A last resort: libraries report lack of memory by exceptions.
  try {
    return lichen::cli::flushed(lichen::cli::run(argc, argv));
  } catch (const std::bad_alloc&) {
    std::fputs("lichen: not enough memory\n", stderr); // allocates nothing
    return int(lichen::ErrorKind::resources);
  } catch (const std::exception& error) {
    return lichen::cli::fail({lichen::ErrorKind::environment, error.what()});
  }
}
