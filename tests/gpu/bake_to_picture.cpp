// SPDX-License-Identifier: MIT
// The shortest path through everything, by each method: a bake, its bundle, a picture of it.
#include "../property/example_exemplar.h"
#include "baked_noises.h"
#include "glb_of.h"
#include "rendered.h"

#include <array>
#include <cmath>

using namespace lichen;
using namespace lichen::test;

namespace {

constexpr int kPictureSide = 96;
// The plane has so many tiles that a pixel is a texel, and nothing is filtered.
constexpr double kTilesAcross = double(kPictureSide) / kExemplarWidth;
constexpr double kPatchTexels = 10.0; // a side of the exemplar's patches of one material, or less

/// The exemplar's light, as the picture holds it.
std::vector<float> lightOf(const MapExemplar& exemplar) {
  std::vector<float> light;
  for (const float code : exemplar.values)
    light.push_back(srgbToLinear(code));
  return light;
}

/// The colours of a plane that fills the picture.
LinearImage pictureOf(const BundleFile& file) {
  GltfScene scene(glbOf(file));
  const std::size_t positions = scene.addFloats({-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, 3);
  const std::size_t normals = scene.addFloats({0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
  const std::size_t texCoords = scene.addFloats({0, 1, 1, 1, 1, 0, 0, 0}, 2);
  scene.addMesh({{"POSITION", positions}, {"NORMAL", normals}, {"TEXCOORD_0", texCoords}},
                scene.addIndices({0, 1, 2, 0, 2, 3}, 1), 0);
  scene.addCamera(1.0f, 2.0f * std::atan(1.0f));
  renderer::RenderSettings settings = settingsOf(kPictureSide, kPictureSide, 1);
  settings.debugView = "base-color";
  return render(scene.glb(), settings);
}

struct Moments {
  double mean = 0.0, deviation = 0.0;
};

/// The moments of every third value from `channel` on.
Moments momentsOf(const std::vector<float>& values, std::size_t channel) {
  double sum = 0.0, squares = 0.0;
  const double count = double(values.size()) / 3.0;
  for (std::size_t i = channel; i < values.size(); i += 3) {
    sum += double(values[i]) / count;
    squares += double(values[i]) * double(values[i]) / count;
  }
  return {sum, std::sqrt(std::max(squares - sum * sum, 0.0))};
}

void checkLooksLike(const LinearImage& picture, const MapExemplar& exemplar) {
  const std::vector<float> light = lightOf(exemplar);
  for (std::size_t c = 0; c < 3; ++c) {
    const Moments drawn = momentsOf(picture.values, c), wanted = momentsOf(light, c);
    INFO("channel " << c);
    // Each patch has independent colours: four deviations of their mean.
    const double patches = kTilesAcross * kExemplarWidth / kPatchTexels * kTilesAcross *
                           kExemplarHeight / kPatchTexels;
    CHECK(drawn.mean == Approx(wanted.mean).margin(4.0 * wanted.deviation / std::sqrt(patches)));
    CHECK(drawn.deviation > 0.5 * wanted.deviation);
    CHECK(drawn.deviation < 1.5 * wanted.deviation);
  }
}

} // namespace

TEST_CASE("a small bake by each method is drawn with the colours of its exemplar") {
  for (const Method method : allMethods()) {
    INFO(nameOf(method));
    const Baked kind{.method = method};
    BundleFile file = baked(kind);
    file.bundle.materials[0]->scale = 1.0 / kTilesAcross;
    checkLooksLike(pictureOf(file), threeMaterials(kExemplarWidth, kExemplarHeight, kind.exemplar));
  }
}
