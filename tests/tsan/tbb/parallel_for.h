// SPDX-License-Identifier: MIT
// In front of oneTBB's header in builds with ThreadSanitizer; see ../handover.h.
#pragma once
#pragma GCC system_header // #include_next is an extension

#include "../handover.h"

#include_next <tbb/parallel_for.h>

namespace tbb {

template <class Index, class Body>
void handedOverFor(Index first, Index last, const Body& body) {
  lichen::tsan::Handover handover;
  tbb::parallel_for(first, last, [&](Index i) {
    const lichen::tsan::Handover::Task task(handover);
    body(i);
  });
}

} // namespace tbb

#define parallel_for handedOverFor
