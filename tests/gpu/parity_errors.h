// SPDX-License-Identifier: MIT
// The differences of a shader from its CPU twin: 99.9 % within 1/1024 and all within 1/255.
#pragma once

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace lichen::test {

class ParityErrors {
public:
  void add(double error) {
    largest_ = std::max(largest_, std::abs(error));
    beyond_ += std::size_t(std::abs(error) > 1.0 / 1024.0);
    ++count_;
  }
  void add(const std::array<float, 4>& found, const std::array<float, 4>& expected) {
    for (std::size_t c = 0; c < 4; ++c)
      add(double(found[c]) - double(expected[c]));
  }
  void check() const {
    CHECK(largest_ <= 1.0 / 255.0);
    CHECK(double(beyond_) <= 0.001 * double(count_));
  }

private:
  double largest_ = 0.0;
  std::size_t beyond_ = 0, count_ = 0;
};

} // namespace lichen::test
