// SPDX-License-Identifier: MIT
// Shows the progress of a long operation on a terminal.
#pragma once

#include "command.h"

#include <lichen/progress.h>

#include <chrono>
#include <string>

namespace lichen::cli {

/// One line on standard error that is overwritten as the work proceeds: "bake: 42 %, 13 s left".
/// Appears only on a terminal, only after the first second, and never with --quiet. The destructor
/// erases it.
class ProgressLine {
public:
  ProgressLine(std::string operation, const SharedOptions& options);
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { erase(); }

  /// Shows the finished share of the work, in [0, 1], and the estimated time left.
  void show(double fraction);
  /// Returns the callback for an operation. This object must outlive it.
  [[nodiscard]] Progress asProgress();
  /// Erases the line, so that other lines can be printed.
  void erase();

private:
  using Clock = std::chrono::steady_clock;

  /// Writes the line, unless the last one is too recent.
  void write(const std::string& text);

  std::string operation_;
  bool wanted_ = false;
  bool shown_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

} // namespace lichen::cli
