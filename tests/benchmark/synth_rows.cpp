// SPDX-License-Identifier: MIT
// Speed of a synthesis.
#include "exemplars.h"
#include "rows.h"

#include <lichen/synthesize.h>

#include <materials.h>

namespace lichen::bench {

std::vector<Row> synthRows() {
  constexpr int kSide = 2048;
  const Bundle bundle = bakedBundle(exemplars::rust(256));
  SynthesisOptions options;
  options.width = options.height = kSide;
  return {{"synth of 2048 x 2048 pixels, one texel a pixel",
           medianSeconds(3, [&] { return synthesize(bundle, options).ok(); }), 2.0, "s",
           "rust, median of 3"}};
}

} // namespace lichen::bench
