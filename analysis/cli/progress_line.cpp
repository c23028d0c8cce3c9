// SPDX-License-Identifier: MIT
// Draws progress over a line of a terminal, with control codes that every terminal supports. Write
// errors are ignored: a closed terminal must not stop the work.
#include "progress_line.h"

#include <fmt/core.h>

#include <cstdio>
#include <unistd.h>

namespace lichen::cli {
namespace {

using namespace std::chrono_literals;
constexpr auto kQuietStart = 1s; // shorter work needs no line
constexpr auto kInterval = 200ms;
/// Below this fraction, the estimate of the time left would jump.
constexpr double kLeastForEstimate = 0.01;

std::string duration(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  return whole < 60 ? fmt::format("{} s", whole)
                    : fmt::format("{} min {} s", whole / 60, whole % 60);
}

} // namespace

ProgressLine::ProgressLine(std::string operation, const SharedOptions& options)
    : operation_(std::move(operation)), wanted_(!options.quiet && ::isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show(double fraction) {
  std::string text = fmt::format("{}: {} %", operation_, int(100.0 * fraction));
  if (fraction >= kLeastForEstimate) {
    const std::chrono::duration<double> gone = Clock::now() - start_;
    text += fmt::format(", {} left", duration(gone.count() * (1.0 - fraction) / fraction));
  }
  write(text);
}

Progress ProgressLine::asProgress() {
  return [this](double fraction) {
    show(fraction);
    return true;
  };
}

void ProgressLine::erase() {
  if (shown_)
    std::fputs("\r\x1b[K", stderr);
  shown_ = false;
}

void ProgressLine::write(const std::string& text) {
  const Clock::time_point now = Clock::now();
  if (!wanted_ || now - start_ < kQuietStart || (shown_ && now - last_ < kInterval))
    return;
  std::fputs(("\r\x1b[K" + text).c_str(), stderr);
  std::fflush(stderr);
  shown_ = true;
  last_ = now;
}

} // namespace lichen::cli
