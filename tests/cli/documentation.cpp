// SPDX-License-Identifier: MIT
// Compares docs/cli.md with the help of the programs.
#include "checkout_paths.h"
#include "command_run.h"

#include <lichen/files.h>

#include <catch2/catch.hpp>

#include <map>
#include <regex>
#include <set>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

using Options = std::set<std::string>;

Options optionsIn(const std::string& text) {
  static const std::regex option("--[a-z][a-z-]*");
  return {std::sregex_token_iterator(text.begin(), text.end(), option), {}};
}

std::string documentation() {
  const auto bytes = readFile(sourcePath("docs/cli.md")).value();
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Returns the text under the heading `## title`, up to the next heading of that level.
std::string section(const std::string& page, const std::string& title) {
  const std::size_t start = page.find("\n## " + title + "\n");
  REQUIRE(start != std::string::npos);
  return page.substr(start, page.find("\n## ", start + 1) - start);
}

/// Returns the programs of this build and the verbs of `lichen`, each with the arguments before
/// --help.
std::map<std::string, std::pair<std::filesystem::path, Arguments>> commands() {
  const std::filesystem::path bin = programPath("");
  std::map<std::string, std::pair<std::filesystem::path, Arguments>> all;
  for (const char* verb :
       {"bake", "mix", "synth", "inspect", "check", "compare", "merge", "layer", "apply"})
    all[std::string("lichen ") + verb] = {bin / "lichen", {verb}};
  for (const char* program : {"lichen-exemplars", "lichen-render", "lichen-view"})
    if (std::filesystem::exists(bin / program)) // not every build has it
      all[program] = {bin / program, {}};
  return all;
}

std::string helpOf(const std::filesystem::path& program, Arguments arguments) {
  arguments.push_back("--help");
  const Ended ended = run(program, arguments);
  REQUIRE(ended.code == 0);
  REQUIRE(ended.errors.empty());
  return ended.output;
}

} // namespace

TEST_CASE("docs/cli.md has every option that --help has, and no other") {
  const std::string page = documentation();
  const Options everywhere = optionsIn(section(page, "Options of every verb"));
  for (const auto& [title, command] : commands()) {
    INFO(title);
    Options documented = optionsIn(section(page, title));
    if (title.starts_with("lichen "))
      documented.insert(everywhere.begin(), everywhere.end());
    documented.insert("--help");
    CHECK(documented == optionsIn(helpOf(command.first, command.second)));
  }
}

TEST_CASE("bake and apply say in their help that other tools drop the noise") {
  for (const char* verb : {"bake", "apply"})
    CHECK_THAT(helpOf(programPath("lichen"), {verb}),
               Catch::Contains("drop the noise: run 'lichen apply' last"));
}

TEST_CASE("docs/cli.md has every verb that lichen --help lists") {
  const std::string page = documentation();
  const std::string help = helpOf(programPath("lichen"), {});
  const std::size_t list = help.find("Verbs:");
  REQUIRE(list != std::string::npos);
  static const std::regex verbLine("\n  ([a-z]+) ");
  std::size_t verbs = 0;
  for (std::sregex_iterator at(help.begin() + std::ptrdiff_t(list), help.end(), verbLine), end;
       at != end; ++at, ++verbs) {
    const std::string title = "lichen " + at->str(1);
    INFO(title);
    CHECK(commands().count(title) == 1);
    CHECK_THAT(page, Catch::Contains("\n## " + title + "\n"));
  }
  CHECK(verbs > 0);
}
