// SPDX-License-Identifier: MIT
// A part of an operation's progress, for the step that does that part.
#pragma once

#include <lichen/progress.h>
#include <lichen/result.h>

#include <string>

namespace lichen {

/// Thrown through the steps of an operation whose caller stopped it; caught where it was called.
struct Interrupted {};

/// Maps a step's own progress to its share of the whole. Small, to be passed by value; the Progress
/// outlives it.
class ProgressPart {
public:
  /// Of an operation that nobody watches.
  ProgressPart() = default;
  explicit ProgressPart(const Progress& whole) : progress_(&whole) {}

  /// The part of this step from one fraction of it to another.
  [[nodiscard]] ProgressPart part(double begin, double end) const {
    ProgressPart inner = *this;
    inner.begin_ = begin_ + (end_ - begin_) * begin;
    inner.end_ = begin_ + (end_ - begin_) * end;
    return inner;
  }

  /// Tells that `fraction` of the step is done. On the operation's thread only. Throws Interrupted
  /// if the caller wants no more.
  void reach(double fraction) const {
    if (progress_ != nullptr && *progress_ && !(*progress_)(begin_ + (end_ - begin_) * fraction))
      throw Interrupted{};
  }

private:
  const Progress* progress_ = nullptr;
  double begin_ = 0.0;
  double end_ = 1.0;
};

/// Runs `operation`, which returns a Result, with Interrupted turned into the Error of `what` it is
/// that was stopped.
template <class Operation>
[[nodiscard]] auto unlessInterrupted(const std::string& what, const Operation& operation)
    -> decltype(operation()) {
  try {
    return operation();
  } catch (const Interrupted&) {
    return Error{ErrorKind::environment, what + ": interrupted"};
  }
}

} // namespace lichen
