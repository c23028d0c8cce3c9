// SPDX-License-Identifier: MIT
// The error rates of the choice between tiling and quilting that `lichen bake` makes.
//
// A miss is a picture with a structure that is baked by tiling, a false alarm one without that is
// baked by quilting. Both rates must be below a tenth, at a confidence of 95 %, over pictures of
// these kinds in equal shares, of 180 to 204 pixels.
//
// Nothing may be tuned with these pictures. If a case fails, a threshold may change only because of
// other pictures, such as those of exemplars/structured.h.
#include "quilting_choice.h"

#include <catch2/catch.hpp>

using namespace lichen::test;

namespace {

constexpr double kMostErrors = 0.1;

/// The bound, and what was misjudged, a line each.
std::string reportOf(const ErrorRate& rate) {
  std::string lines = std::to_string(rate.wrong.size()) + " of " + std::to_string(rate.pictures) +
                      " wrong, rate at most " + std::to_string(rate.upperBound()) + "\n";
  for (const std::string& name : rate.wrong)
    lines += name + "\n";
  return lines;
}

} // namespace

TEST_CASE("the upper bound of an error rate is that of tables") {
  CHECK(upperErrorBound(0, 29) == Approx(0.098145).margin(1e-6)); // 1 - 0.05^(1/29)
  CHECK(upperErrorBound(5, 110) == Approx(0.093194).margin(1e-6));
  CHECK(upperErrorBound(10, 10) == 1.0);
}

TEST_CASE("fewer than a tenth of the held-back pictures with a structure are not baked by quilting",
          "[large]") {
  const ErrorRate misses = quiltingMisses();
  INFO(reportOf(misses));
  CHECK(misses.pictures == 110);
  CHECK(misses.upperBound() < kMostErrors);
}

TEST_CASE("fewer than a tenth of the held-back pictures without a structure are baked by quilting",
          "[large]") {
  const ErrorRate alarms = quiltingFalseAlarms();
  INFO(reportOf(alarms));
  CHECK(alarms.pictures == 110);
  CHECK(alarms.upperBound() < kMostErrors);
}
