// SPDX-License-Identifier: MIT
// The result of a bake -> a bundle with its noise alone.
#pragma once

#include <lichen/bundle.h>
#include <lichen/result.h>

#include <catch2/catch.hpp>

#include <utility>

namespace lichen::test {

/// Fails the test if the bake failed.
template <class Bake>
Bundle bundleOf(Result<Bake> bake) {
  REQUIRE(bake);
  Bundle bundle;
  bundle.tables = std::move(bake.value().tables);
  bundle.noises = {std::move(bake.value().noise)};
  return bundle;
}

} // namespace lichen::test
