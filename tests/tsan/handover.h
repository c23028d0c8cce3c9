// SPDX-License-Identifier: MIT
// Tells ThreadSanitizer what oneTBB synchronises, which Debian's uninstrumented library hides: a
// task sees what its spawner did before, and who waits for the tasks sees what they did. Nothing
// orders the tasks among themselves, so a race between them is reported.
// Used by the headers of tbb/, for parallel_for over indices and parallel_invoke. oneTBB's other
// algorithms (parallel_reduce, parallel_sort, task_group and so on) are not covered:
// ThreadSanitizer would report races in their tasks where there are none. Who needs one adds a
// header there.
#pragma once

#include <sanitizer/tsan_interface.h>

namespace lichen::tsan {

class Handover {
public:
  Handover() { __tsan_release(&given_); }
  Handover(const Handover&) = delete;
  Handover& operator=(const Handover&) = delete;
  ~Handover() { __tsan_acquire(&returned_); }

  /// Lives while a task runs.
  class Task {
  public:
    explicit Task(Handover& handover) : handover_(handover) { __tsan_acquire(&handover_.given_); }
    Task(const Task&) = delete;
    Task& operator=(const Task&) = delete;
    ~Task() { __tsan_release(&handover_.returned_); }

  private:
    Handover& handover_;
  };

private:
  char given_ = 0;
  char returned_ = 0;
};

} // namespace lichen::tsan
