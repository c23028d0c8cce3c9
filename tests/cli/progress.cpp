// SPDX-License-Identifier: MIT
// The progress line: on a terminal, for what lasts, and nowhere else.
#include "command_run.h"

#include <catch2/catch.hpp>

#include <regex>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

/// The verbs' work that lasts over a second on one core of any machine, or else nearly none.
struct Made {
  Workplace workplace;
  std::string photograph = workplace.write("photograph.png", smooth(512));
  std::string stamp = workplace.write("stamp.png", smooth(16));
  std::string bundle = bake(workplace, stamp, "stamp.glb");

  /// With --json, since notes would stand among the progress.
  [[nodiscard]] Arguments longBake() const {
    return {"bake", photograph, "-o", workplace.path("new.glb"), "--threads", "1", "--json"};
  }
  [[nodiscard]] Arguments longSynth() const {
    return {"synth", bundle, "-o", workplace.path("new.png"), "--size", "3200", "--threads", "1"};
  }
};

const Made& made() {
  static const Made made;
  return made;
}

std::string errorsOf(Arguments arguments, bool terminal, const char* option = nullptr) {
  if (option != nullptr)
    arguments.push_back(option);
  Limits limits;
  limits.terminal = terminal;
  const Ended ended = runLichen(arguments, limits);
  INFO(ended.errors);
  CHECK(ended.code == 0);
  return ended.errors;
}

void checkProgress(const std::string& verb, const std::string& text) {
  INFO(text);
  static const std::string erase = "\r\x1b[K";
  const std::regex line(verb + ": ([0-9]+) %(, ([0-9]+ min )?[0-9]+ s left)?\r");
  int lines = 0, last = 0, withTime = 0;
  for (std::sregex_iterator at(text.begin(), text.end(), line), end; at != end; ++at, ++lines) {
    const int percent = std::stoi(at->str(1));
    CHECK(percent >= last);
    CHECK(percent <= 100);
    last = percent;
    withTime += at->str(2).empty() ? 0 : 1;
  }
  CHECK(lines > 0);
  CHECK(withTime > 0);
  // Nothing but these lines, each drawn over the one before, the last one erased.
  CHECK(text.ends_with(erase));
  CHECK(text.find('\n') == std::string::npos);
}

} // namespace

TEST_CASE("on a terminal a long bake tells how far it is") {
  checkProgress("bake", errorsOf(made().longBake(), true));
}

TEST_CASE("on a terminal a long synth tells how far it is, apart from its JSON") {
  Arguments arguments = made().longSynth();
  arguments.push_back("--json");
  Limits limits;
  limits.terminal = true;
  const Ended ended = runLichen(arguments, limits);
  CHECK(ended.code == 0);
  CHECK(ended.output.front() == '{');
  CHECK(ended.output.find('%') == std::string::npos);
  checkProgress("synth", ended.errors);
}

TEST_CASE("no progress is told where standard error is no terminal, or with --quiet") {
  CHECK(errorsOf(made().longSynth(), false).empty());
  CHECK(errorsOf(made().longSynth(), true, "--quiet").empty());
}

TEST_CASE("no progress is told of what takes less than a second") {
  const Made& m = made();
  CHECK(errorsOf({"synth", m.bundle, "-o", m.workplace.path("new.png"), "--size", "64"}, true)
            .empty());
}
