// SPDX-License-Identifier: MIT
// Union-find on 0 .. n - 1, with path halving.
#pragma once

#include <cstdint>
#include <numeric>
#include <vector>

namespace lichen::direction_field {

class DisjointSets {
public:
  explicit DisjointSets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t(0));
  }

  /// The least element of the set that contains `element`.
  [[nodiscard]] std::uint32_t find(std::uint32_t element) {
    while (parent_[element] != element)
      element = parent_[element] = parent_[parent_[element]];
    return element;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    parent_[a < b ? b : a] = a < b ? a : b;
  }

private:
  std::vector<std::uint32_t> parent_;
};

} // namespace lichen::direction_field
