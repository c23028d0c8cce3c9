// SPDX-License-Identifier: MIT
// Lets a long operation report its progress and lets the caller stop it.
#pragma once

#include <functional>

namespace lichen {

/// Called now and then on the thread that called the operation. `fraction` is the part of the
/// expected time that has passed, in [0, 1]; it never decreases. After `seconds`, about
/// seconds * (1 - fraction) / fraction remain. Returns whether to continue; after false the
/// operation ends at once with the Error `environment`, "interrupted", and creates nothing. An
/// empty function is never called. It must not throw.
using Progress = std::function<bool(double fraction)>;

/// The progress of a step that takes an operation from fraction `begin` to fraction `end`.
[[nodiscard]] inline Progress partOf(const Progress& whole, double begin, double end) {
  if (!whole)
    return {};
  return [=](double fraction) { return whole(begin + (end - begin) * fraction); };
}

} // namespace lichen
