// SPDX-License-Identifier: MIT
// A square result of a bundle's first noise, and results without which there is nothing to measure.
#pragma once

#include <lichen/bundle.h>
#include <lichen/image.h>
#include <lichen/result.h>
#include <lichen/synthesize.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace lichen::bench {

/// The value; an error ends the program with its message.
template <class T>
[[nodiscard]] T require(Result<T> result) {
  if (!result) {
    std::fprintf(stderr, "lichen-bench: %s\n", result.error().message.c_str());
    std::exit(int(result.error().kind));
  }
  return std::move(result).value();
}

/// The base colour in side^2 pixels, one texel per pixel.
[[nodiscard]] inline SrgbImage synthesized(const Bundle& bundle, int side, std::uint32_t seed) {
  SynthesisOptions options;
  options.material.seed = seed;
  options.width = options.height = side;
  return toSrgb(require(synthesize(bundle, options)));
}

} // namespace lichen::bench
