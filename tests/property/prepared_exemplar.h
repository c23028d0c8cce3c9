// SPDX-License-Identifier: MIT
// A photograph -> the exemplar that `lichen bake` makes of it with its default options.
#pragma once

#include <lichen/exemplar.h>
#include <lichen/image.h>
#include <lichen/regularity.h>
#include <lichen/result.h>

#include <stdexcept>
#include <utility>
#include <vector>

namespace lichen::test {

/// An error is thrown as a std::runtime_error.
template <class Value>
Value valueOf(Result<Value> result) {
  if (!result)
    throw std::runtime_error(result.error().message);
  return std::move(result).value();
}

/// The base colour (RGB) without a frame, in even light, and with what occurs once filled. An error
/// is thrown as a std::runtime_error.
[[nodiscard]] std::vector<MapExemplar> preparedExemplar(const SrgbImage& photograph);

/// What repeats in such an exemplar. If isClear(), a bake without --method is by quilting. Errors
/// are thrown as above.
[[nodiscard]] Regularity regularityOfPrepared(const std::vector<MapExemplar>& exemplar);

/// The part of it that a bake by quilting uses: what holds whole periods, or all of it. Errors are
/// thrown as above.
[[nodiscard]] std::vector<MapExemplar> wholePeriodsOf(std::vector<MapExemplar> exemplar,
                                                      const Regularity& regularity);

} // namespace lichen::test
