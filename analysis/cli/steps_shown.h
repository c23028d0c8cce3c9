// SPDX-License-Identifier: MIT
// A bake as the terminal shows it: a progress line for each step, and notes as they arise.
#pragma once

#include "bake_risks.h"
#include "progress_line.h"

#include <lichen/exemplar_preparation.h>

#include <optional>
#include <string>

namespace lichen::cli {

class StepsShown {
public:
  explicit StepsShown(const SharedOptions& options) : options_(options) {}

  /// For an operation that this object outlives.
  [[nodiscard]] BakeObserver observer() {
    return {.progress =
                [this](std::string_view step, double fraction) {
                  if (!line_ || step_ != step) {
                    line_.emplace(step_ = step, options_);
                  }
                  line_->show(fraction);
                  return true;
                },
            .note =
                [this](const std::string& text) {
                  line_.reset();
                  note(options_, text);
                },
            .words = optionOf};
  }

private:
  const SharedOptions& options_;
  std::string step_;
  std::optional<ProgressLine> line_;
};

} // namespace lichen::cli
