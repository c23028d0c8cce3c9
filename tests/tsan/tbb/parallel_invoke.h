// SPDX-License-Identifier: MIT
// In front of oneTBB's header in builds with ThreadSanitizer; see ../handover.h.
#pragma once
#pragma GCC system_header // #include_next is an extension

#include "../handover.h"

#include_next <tbb/parallel_invoke.h>

namespace tbb {

template <class... Bodies>
void handedOverInvoke(const Bodies&... bodies) {
  lichen::tsan::Handover handover;
  tbb::parallel_invoke([&handover, &bodies] {
    const lichen::tsan::Handover::Task task(handover);
    bodies();
  }...);
}

} // namespace tbb

#define parallel_invoke handedOverInvoke
