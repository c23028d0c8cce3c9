// SPDX-License-Identifier: MIT
// How an operation that may last tells its caller how far it is, and how the caller stops it.
#pragma once

#include <functional>

namespace lichen {

/// Called now and then on the thread that called the operation, with the part of the expected time
/// that has passed, in [0, 1] and never falling: with `seconds` gone, about
/// seconds * (1 - fraction) / fraction are left. Returns whether to go on; after false the
/// operation ends at once with the Error `environment`, "interrupted", and nothing is made. An
/// empty function is never called. It must not throw.
using Progress = std::function<bool(double fraction)>;

/// For a step that takes an operation from one fraction of it to another.
[[nodiscard]] inline Progress partOf(const Progress& whole, double begin, double end) {
  if (!whole)
    return {};
  return [=](double fraction) { return whole(begin + (end - begin) * fraction); };
}

} // namespace lichen
