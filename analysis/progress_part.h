// SPDX-License-Identifier: MIT
// The share of an operation's progress that belongs to one of its steps.
#pragma once

#include <lichen/progress.h>
#include <lichen/result.h>

#include <string>

namespace lichen {

/// Thrown inside an operation when its caller stops it. unlessInterrupted() catches it.
struct Interrupted {};

/// Maps the progress of one step to its share of the whole operation. Small: pass it by value. The
/// Progress must outlive it.
class ProgressPart {
public:
  /// Reports to nobody.
  ProgressPart() = default;
  explicit ProgressPart(const Progress& whole) : progress_(&whole) {}

  /// The part of this step between the fractions `begin` and `end` of it, both in [0, 1].
  [[nodiscard]] ProgressPart part(double begin, double end) const {
    ProgressPart inner = *this;
    inner.begin_ = begin_ + (end_ - begin_) * begin;
    inner.end_ = begin_ + (end_ - begin_) * end;
    return inner;
  }

  /// Reports that `fraction` of the step is done. Call it on the operation's thread only. Throws
  /// Interrupted if the caller stops the operation.
  void reach(double fraction) const {
    if (progress_ != nullptr && *progress_ && !(*progress_)(begin_ + (end_ - begin_) * fraction))
      throw Interrupted{};
  }

private:
  const Progress* progress_ = nullptr;
  double begin_ = 0.0;
  double end_ = 1.0;
};

/// Runs `operation`, which returns a Result. Returns an environment error, "`what`: interrupted",
/// if the caller stops it.
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
