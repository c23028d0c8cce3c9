// SPDX-License-Identifier: MIT
// Held-back pictures -> what the bake finds in each -> the names of those it misjudges.
#include "quilting_choice.h"

#include "prepared_exemplar.h"
#include "quilting_held_back.h"

#include <tbb/parallel_for.h>

#include <cstdio>

namespace lichen::test {
namespace {

/// "12 knit, noisy (outlines 0.12, strength 0.80)", or nothing if the choice is right.
std::string mistakeAbout(int index, const HeldBackPicture& picture, bool hasStructure) {
  const Structure found = structureOfPrepared(preparedExemplar(picture.image));
  if (found.isClear() == hasStructure)
    return {};
  char numbers[64];
  std::snprintf(numbers, sizeof numbers, " (outlines %.2f, strength %.2f)", found.outlines,
                found.strength);
  return std::to_string(index) + " " + picture.name + numbers;
}

ErrorRate rateOf(int pictures, HeldBackPicture (*draw)(int index), bool hasStructure) {
  std::vector<std::string> mistakes(static_cast<std::size_t>(pictures));
  tbb::parallel_for(0, pictures, [&](int index) {
    mistakes[std::size_t(index)] = mistakeAbout(index, draw(index), hasStructure);
  });
  std::erase(mistakes, "");
  return {pictures, std::move(mistakes)};
}

} // namespace

ErrorRate quiltingMisses() { return rateOf(kStructuredHeldBack, structuredHeldBack, true); }

ErrorRate quiltingFalseAlarms() { return rateOf(kStochasticHeldBack, stochasticHeldBack, false); }

} // namespace lichen::test
