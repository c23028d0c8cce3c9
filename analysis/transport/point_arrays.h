// SPDX-License-Identifier: MIT
// Points as one array per coordinate, for loops over many points at a time.
#pragma once

#include "point.h"

#include <cstddef>
#include <vector>

namespace lichen::transport {

struct PointArrays {
  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> z;

  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] Point operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
  void push_back(const Point& p) {
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  }
};

} // namespace lichen::transport
