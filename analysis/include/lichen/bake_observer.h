// SPDX-License-Identifier: MIT
// Lets the caller of a bake follow its steps, stop it, and hear its notes.
#pragma once

#include <lichen/progress.h>
#include <lichen/suitability.h>

#include <functional>
#include <string>
#include <string_view>

namespace lichen {

/// How a caller follows a bake. Functions are called on the thread that called the bake, and may be
/// empty. They must not throw.
struct BakeObserver {
  /// The step under way, such as "outliers", "bake" or "judge", and its finished share, as Progress
  /// has it, first 0. Returns whether to continue.
  std::function<bool(std::string_view step, double fraction)> progress;
  /// A sentence for the user, as soon as it is known.
  std::function<void(const std::string& line)> note;
  /// Puts settings that a sentence names into the words of the program.
  SettingWords words = plainWords;

  /// Begins a step and returns its progress. This object must outlive it.
  [[nodiscard]] Progress of(std::string_view step) const {
    if (!progress)
      return {};
    progress(step, 0.0); // what it returns counts from the next call on
    return [this, step](double fraction) { return progress(step, fraction); };
  }
};

} // namespace lichen
