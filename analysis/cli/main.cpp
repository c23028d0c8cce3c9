// SPDX-License-Identifier: MIT
// lichen: the verbs, and how each way of ending becomes an exit code and one line.
#include "command.h"

#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <CLI/Validators.hpp>
#include <fmt/core.h>
#include <tbb/global_control.h>

#include <cstdio>
#include <exception>
#include <new>
#include <thread>

namespace lichen::cli {
namespace {

struct Verb {
  const char* name;
  Runner (*add)(CLI::App&);
};
constexpr Verb kVerbs[] = {{"bake", addBake}, {"synth", addSynth}, {"check", addCheck}};

int fail(const Error& error) {
  fmt::print(stderr, "lichen: {}\n", error.message);
  return int(error.kind);
}

/// The first line of what CLI11 says, with where to read more.
int failUsage(const CLI::ParseError& error) {
  std::string message = error.what();
  for (char& character : message)
    character = character == '\n' ? ' ' : character;
  return fail({ErrorKind::usage, message + "; see 'lichen --help' or 'lichen VERB --help'"});
}

int run(int argc, char** argv) {
  CLI::App app{"Lichen turns a photograph of a material into noise: an endless, seamless texture."};
  app.set_version_flag("--version", std::string("lichen ") + kVersion);
  app.require_subcommand(0, 1); // none is refused below: CLI11 would not name an unknown one
  std::vector<Runner> runners;
  for (const Verb& verb : kVerbs)
    runners.push_back(verb.add(app));
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) { // --help and --version
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return failUsage(error);
  }
  if (app.get_subcommands().empty())
    return failUsage(CLI::RequiredError("A verb"));
  const auto threads = app.get_subcommands().front()->get_option("--threads")->as<std::size_t>();
  const tbb::global_control control(
      tbb::global_control::max_allowed_parallelism,
      threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency()));
  for (std::size_t v = 0; v < runners.size(); ++v)
    if (app.got_subcommand(kVerbs[v].name)) {
      const Result<int> result = runners[v]();
      return result ? result.value() : fail(result.error());
    }
  return kDone;
}

} // namespace
} // namespace lichen::cli

int main(int argc, char** argv) {
  // A last net: libraries report lack of memory by exceptions.
  try {
    return lichen::cli::run(argc, argv);
  } catch (const std::bad_alloc&) {
    return lichen::cli::fail({lichen::ErrorKind::resources, "not enough memory"});
  } catch (const std::exception& error) {
    return lichen::cli::fail({lichen::ErrorKind::environment, error.what()});
  }
}
