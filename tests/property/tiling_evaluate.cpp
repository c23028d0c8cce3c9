// SPDX-License-Identifier: MIT
// Properties of evaluated tiling noise.
#include "bundle_of.h"
#include "example_exemplar.h"

#include <lichen/image.h>
#include <lichen/synthesize.h>
#include <lichen/tiling.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <exemplar/color_space.h>

using namespace lichen;

namespace {

/// One bundle for the tests that only evaluate.
const Bundle& exampleBundle() {
  static const Bundle bundle = test::bundleOf(bakeTiling(
      "example", std::array{test::threeMaterials(128, 128, 11)}, {.bits = 16, .progress = {}}));
  return bundle;
}

/// The moments of the exemplar's light.
exemplar::Moments exampleLight() {
  std::vector<float> light = test::threeMaterials(128, 128, 11).values;
  std::transform(light.begin(), light.end(), light.begin(), srgbToLinear);
  return exemplar::momentsOf(light, 3);
}

LinearImage synthesized(const SynthesisOptions& options) {
  Result<LinearImage> image = synthesize(exampleBundle(), options);
  REQUIRE(image);
  return std::move(image).value();
}

SynthesisOptions sized(int width, int height) {
  SynthesisOptions options;
  options.width = width;
  options.height = height;
  return options;
}

} // namespace

TEST_CASE("a synthesized image has the exemplar's mean and covariance", "[large]") {
  // Patches of 7 x 7 texels: a value is correlated over sum rho = 49 texels, its square over sum
  // rho^2 = 22. Standard errors over 1536^2 pixels: 0.46 % of a standard deviation for a mean, 0.43
  // % for a variance, and 0.1 % of it from the offsets, (2/3) sqrt(3 x 22 / 128^2) per triangle.
  // Tolerances are at least 4.3 of these: alpha 5e-5 for the three means, and the same for the
  // covariance.
  const LinearImage image = synthesized(sized(1536, 1536));
  const exemplar::Moments found = exemplar::momentsOf(image.values, 3);
  const exemplar::Moments wanted = exampleLight();
  const double deviation = std::sqrt(wanted.covariance.diagonal().maxCoeff());
  CHECK((found.mean - wanted.mean).cwiseAbs().maxCoeff() < 0.02 * deviation);
  CHECK((found.covariance - wanted.covariance).norm() < 0.02 * wanted.covariance.norm());
}

TEST_CASE("with a stride of n an image has every nth pixel of the larger one, bit for bit") {
  const LinearImage whole = synthesized(sized(60, 60));
  SynthesisOptions options = sized(20, 20);
  options.stride = 3;
  const LinearImage sparse = synthesized(options);
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 20; ++x)
      for (int c = 0; c < whole.channels; ++c)
        REQUIRE(sparse.pixel(x, y)[c] == whole.pixel(3 * x, 3 * y)[c]);
  options.tileable = true;
  CHECK(synthesize(exampleBundle(), options).error().kind == ErrorKind::usage);
}

TEST_CASE("seeds give different patterns of one material, and no pattern repeats the exemplar") {
  const LinearImage one = synthesized(sized(256, 256));
  SynthesisOptions options = sized(256, 256);
  options.material.seed = 2;
  const LinearImage two = synthesized(options);
  const exemplar::Moments a = exemplar::momentsOf(one.values, 3);
  const exemplar::Moments b = exemplar::momentsOf(two.values, 3);
  double product = 0.0;
  double shifted = 0.0;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 128; ++x) {
      product +=
          (double(one.pixel(x, y)[0]) - a.mean[0]) * (double(two.pixel(x, y)[0]) - b.mean[0]);
      shifted +=
          (double(one.pixel(x, y)[0]) - a.mean[0]) * (double(one.pixel(x + 128, y)[0]) - a.mean[0]);
    }
  const double variance = a.covariance(0, 0) * 128.0 * 128.0;
  // Patches of 7 x 7 texels: some 340 independent values, standard error 0.054. The limit is four
  // of these, alpha 6e-5 each.
  CHECK(std::abs(product / variance) < 0.22);
  CHECK(std::abs(shifted / variance) < 0.22);
}

TEST_CASE("sizes, origins and maps out of range are errors") {
  const auto refused = [](const SynthesisOptions& options) {
    const Result<LinearImage> image = synthesize(exampleBundle(), options);
    return !image && image.error().kind == ErrorKind::usage;
  };
  CHECK(refused(sized(0, 10)));
  CHECK(refused(sized(10, 16385)));
  SynthesisOptions options = sized(8, 8);
  options.origin = {1e20, 0.0};
  CHECK(refused(options));
  options = sized(8, 8);
  options.map = MapTarget::height;
  CHECK(refused(options));
  options = sized(8, 8);
  options.material.noise = 3;
  CHECK(refused(options));
  for (const double texels : {1e-40, 1e-4, -1.0, 1e30, std::nan("")}) {
    options = sized(8, 8);
    options.texelsPerTile = texels;
    CHECK(refused(options));
  }
  for (const double sharpness : {0.0, 1000.0, std::nan("")}) {
    options = sized(8, 8);
    options.material.blendSharpness = sharpness;
    CHECK(refused(options));
  }
  for (const double contrast : {-0.1, 4.1, std::nan("")}) {
    options = sized(8, 8);
    options.material.contrast = contrast;
    CHECK(refused(options));
  }
  options = sized(63, 128); // less than half of the tile's 128 texels
  options.tileable = true;
  CHECK(refused(options));
  CHECK_FALSE(synthesizePreview(exampleBundle(), MaterialNoise(), MapTarget::baseColor, 0));
  MaterialNoise material;
  material.noise = 1;
  CHECK_FALSE(synthesizePreview(exampleBundle(), material, MapTarget::baseColor, 1));
  material = {};
  material.contrast = 5.0;
  CHECK_FALSE(synthesizePreview(exampleBundle(), material, MapTarget::baseColor, 1));
}
