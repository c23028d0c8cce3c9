// SPDX-License-Identifier: MIT
// The progress line: it appears on a terminal, for long work, and nowhere else.
#include "command_run.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <chrono>
#include <regex>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

/// Work that reports progress this often has lasted well over the silent first second.
constexpr auto kReports = 3;
/// Work of this length must have reported progress; otherwise the test fails and ends.
constexpr auto kLong = std::chrono::seconds(30);
/// Growth of the side per attempt; the time grows with its square.
constexpr double kGrowth = 1.4;

/// Runs of the verbs, sized to last long enough on any machine and build, or to finish almost at
/// once.
struct Made {
  Workplace workplace;
  std::string stamp = workplace.write("stamp.png", smooth(16));
  std::string bundle = bake(workplace, stamp, "stamp.glb");

  /// With --json, because notes would mix with the progress.
  [[nodiscard]] Arguments bakeOf(int side) const {
    return {"bake",      workplace.write("photograph.png", smooth(side)),
            "-o",        workplace.path("new.glb"),
            "--method",  "tiling",
            "--threads", "1",
            "--json"};
  }
  [[nodiscard]] Arguments synthOf(int side) const {
    return {"synth",     bundle, "-o", workplace.path("new.png"), "--size", std::to_string(side),
            "--threads", "1"};
  }
};

const Made& made() {
  static const Made made;
  return made;
}

/// Runs the work on a terminal with growing sides, starting at `side`, until it lasts long enough
/// to report progress. Most machines need one run. Returns the last run, and stores its side in
/// `side`.
template <class Work>
Ended lasting(Work work, int& side) {
  Limits limits;
  limits.terminal = true;
  for (;; side = int(kGrowth * side)) {
    const auto start = std::chrono::steady_clock::now();
    Ended ended = runLichen(work(side), limits);
    const auto lasted = std::chrono::steady_clock::now() - start;
    const auto reports = std::count(ended.errors.begin(), ended.errors.end(), '%');
    if (ended.code != 0 || reports >= kReports || lasted > kLong)
      return ended;
  }
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
  // Only these lines, each drawn over the one before, and the last one erased.
  CHECK(text.ends_with(erase));
  CHECK(text.find('\n') == std::string::npos);
}

} // namespace

TEST_CASE("on a terminal a long bake shows its progress") {
  int side = 300;
  const Ended ended = lasting([](int of) { return made().bakeOf(of); }, side);
  REQUIRE(ended.code == 0);
  checkProgress("bake", ended.errors);
}

TEST_CASE("a long synth shows its progress, on standard error and only on a terminal") {
  const auto work = [](int side) {
    Arguments arguments = made().synthOf(side);
    arguments.push_back("--json");
    return arguments;
  };
  int side = 2600;
  const Ended ended = lasting(work, side);
  REQUIRE(ended.code == 0);
  CHECK(ended.output.front() == '{');
  CHECK(ended.output.find('%') == std::string::npos);
  checkProgress("synth", ended.errors);
  // The same work, which lasted long enough above.
  CHECK(errorsOf(made().synthOf(side), false).empty());
  CHECK(errorsOf(made().synthOf(side), true, "--quiet").empty());
}

TEST_CASE("work of less than a second shows no progress") {
  const Made& m = made();
  CHECK(errorsOf({"synth", m.bundle, "-o", m.workplace.path("new.png"), "--size", "64"}, true)
            .empty());
}
