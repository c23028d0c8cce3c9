// SPDX-License-Identifier: MIT
// lichen-exemplars: its files, and its error messages, which match the lichen command's.
#include "checkout_paths.h"
#include "command_run.h"

#include <catch2/catch.hpp>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

Ended runExemplars(const Arguments& arguments) {
  return run(programPath("lichen-exemplars"), arguments);
}

} // namespace

TEST_CASE("lichen-exemplars writes the exemplars that are named") {
  const Workplace workplace;
  const Ended ended =
      runExemplars({workplace.path("out"), "rust", "terrain", "scan", "bricks", "--size", "64"});
  CHECK(ended.code == 0);
  CHECK(ended.output == workplace.path("out/rust.png") + "\n" + workplace.path("out/bricks.png") +
                            "\n" + workplace.path("out/scan.glb") + "\n" +
                            workplace.path("out/terrain.glb") + "\n" +
                            workplace.path("out/terrain_mask.png") + "\n");
}

TEST_CASE("lichen-exemplars escapes control characters in paths") {
  const Workplace workplace;
  const Ended written = runExemplars({workplace.path("m\x1b[31m"), "rust", "--size", "64"});
  CHECK(written.code == 0);
  CHECK(written.output == workplace.path("m\\x1b[31m") + "/rust.png\n");
  const Ended refused = runExemplars({workplace.path("out"), "m\x1b[31m"});
  CHECK(refused.code == kUsage);
  CHECK_THAT(refused.errors, Catch::StartsWith("lichen-exemplars: m\\x1b[31m: no such exemplar"));
}

TEST_CASE("lichen-exemplars reports wrong arguments in one line with the valid ones") {
  const Workplace workplace;
  const std::string out = workplace.path("out");
  const std::vector<std::pair<Arguments, std::string>> cases{
      {{out, "foo"}, "foo: no such exemplar; expected granite, "},
      {{out, "--size", "63"}, "--size 63: expected a whole number from 64 to 2048"},
      {{out, "--size"}, "--size: a value is missing"},
      {{out, "--large"}, "--large: no such option"},
      {{}, "OUTDIR is required"}};
  for (const auto& [arguments, words] : cases) {
    const Ended ended = runExemplars(arguments);
    CHECK(ended.code == kUsage);
    CHECK(ended.output.empty());
    CHECK_THAT(ended.errors, Catch::StartsWith("lichen-exemplars: " + words) &&
                                 Catch::EndsWith("; see 'lichen-exemplars --help'\n"));
  }
  CHECK(workplace.names().empty());
}

TEST_CASE("the help of lichen-exemplars does not show the parser's type names") {
  const Ended ended = runExemplars({"--help"});
  CHECK(ended.code == 0);
  CHECK_THAT(ended.output, Catch::Contains("Arguments:") && Catch::Contains("[default: 512]"));
  for (const char* jargon : {"TEXT", "INT", "{", "Positionals"})
    CHECK_THAT(ended.output, !Catch::Contains(jargon));
}
