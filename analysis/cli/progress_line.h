// SPDX-License-Identifier: MIT
// Tells on a terminal how far an operation is that lasts.
#pragma once

#include "command.h"

#include <lichen/progress.h>

#include <chrono>
#include <string>

namespace lichen::cli {

/// One line on standard error, written again and again: "bake: 42 %, 13 s left". Only where that is
/// a terminal, only after the first second, and never with --quiet. Gone when the object is.
class ProgressLine {
public:
  ProgressLine(std::string operation, const SharedOptions& options);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { erase(); }

  /// Shows a part in [0, 1] of the work and the time that the rest will take.
  void show(double fraction);
  /// What an operation tells its progress to. The line outlives it.
  [[nodiscard]] Progress asProgress();
  /// Makes room for other lines.
  void erase();

private:
  using Clock = std::chrono::steady_clock;

  /// The line, if it is time for one.
  void write(const std::string& text);

  std::string operation_;
  bool wanted_ = false;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

} // namespace lichen::cli
