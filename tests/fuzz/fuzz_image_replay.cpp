// SPDX-License-Identifier: MIT
// fuzz_image_replay: mutations of valid images of every kind; see replay().
#include "image_samples.h"
#include "mutation.h"

using namespace lichen::fuzz;

int main(int argumentCount, char** arguments) {
  const std::vector<Bytes> files = lichen::samples::everySupportedKind();
  const auto mutated = [&](Random& random) {
    constexpr std::size_t kMostMutations = 4;
    Bytes file = files[below(random, files.size())];
    const std::size_t count = 1 + below(random, kMostMutations);
    for (std::size_t i = 0; i < count; ++i)
      mutateBytes(file, files, random);
    if (random() % 4 != 0) // otherwise few mutations of a PNG get past its checksums
      lichen::samples::correctPngChecksums(file);
    return file;
  };
  return replay({arguments, std::size_t(argumentCount)}, files, mutated);
}
