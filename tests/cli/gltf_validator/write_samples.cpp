// SPDX-License-Identifier: MIT
// write_validator_samples FOLDER: bundles of every kind of map, in every preview shape and both
// file forms.
#include "bundle_example.h"

#include <cstdio>

int main(int argumentCount, char** arguments) {
  using namespace lichen;
  if (argumentCount != 2) {
    std::fprintf(stderr, "usage: write_validator_samples FOLDER\n");
    return 2;
  }
  struct Sample {
    const char* name;
    PreviewShape shape;
  };
  constexpr std::array<Sample, 4> kSamples = {{{"sphere.glb", PreviewShape::sphere},
                                               {"plane.glb", PreviewShape::plane},
                                               {"none.glb", PreviewShape::none},
                                               {"separate.gltf", PreviewShape::sphere}}};
  for (const Sample& sample : kSamples) {
    BundleFile file = example::everyMap();
    file.shape = sample.shape;
    const Result<void> written =
        writeBundle(std::filesystem::path(arguments[1]) / sample.name, file);
    if (!written) {
      std::fprintf(stderr, "%s\n", written.error().message.c_str());
      return 1;
    }
  }
  return 0;
}
