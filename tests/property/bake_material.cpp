// SPDX-License-Identifier: MIT
// bakeMaterial(): maps in memory, its steps, what it refuses, and memory that runs out.
#include "example_exemplar.h"

#include <lichen/bake_material.h>

#include <catch2/catch.hpp>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <exhausted_memory.h>

using namespace lichen;

namespace {

Photograph photograph(const std::string& name, int channels) {
  const MapExemplar map = test::threeMaterials(64, 64, 5);
  SrgbImage image(64, 64, channels);
  for (std::size_t i = 0; i < image.pixelCount(); ++i)
    for (std::size_t c = 0; c < std::size_t(channels); ++c)
      image.values[i * std::size_t(channels) + c] = map.values[3 * i + c];
  Photograph made;
  made.name = name;
  made.image.pixels = std::move(image);
  return made;
}

/// Without an inverse table.
BakeOptions fastest() {
  TilingOptions tiling;
  tiling.gaussian = GaussianOnly::yes;
  BakeOptions options;
  options.method = tiling;
  return options;
}

std::vector<Photograph> moss() {
  return {photograph("moss_diff.png", 3), photograph("moss_rough.png", 1)};
}

} // namespace

TEST_CASE("the names of images in memory say which maps of a material they are") {
  BakeOptions options = fastest();
  const Result<BakedMaterial> baked = bakeMaterial(moss(), options);
  REQUIRE(baked);
  const Noise& noise = baked.value().bundle.noises.front();
  CHECK(noise.name == "moss");
  REQUIRE(noise.maps.size() == 2);
  CHECK(noise.maps[1].channels == std::vector{MapChannel::roughness});
  CHECK(baked.value().judgement.risks.size() == 2);

  const Result<BakedMaterial> twice =
      bakeMaterial({photograph("a_diff.png", 3), photograph("b_diff.png", 3)}, options);
  REQUIRE(!twice);
  CHECK(twice.error().kind == ErrorKind::badInput);
}

TEST_CASE("an observer hears the steps of a bake, and stops it in each that takes long") {
  std::vector<std::string> steps;
  BakeObserver observer;
  observer.progress = [&](std::string_view step, double) {
    if (std::ranges::count(steps, step) == 0)
      steps.emplace_back(step);
    return true;
  };
  BakeOptions options = fastest();
  options.exemplar.flattening = {.periodPixels = 32.0};
  REQUIRE(bakeMaterial(moss(), options, observer));
  CHECK(steps == std::vector<std::string>{"flatten", "outliers", "bake", "judge"});
  for (const std::string stopped : {"flatten", "bake", "judge"}) {
    INFO(stopped);
    observer.progress = [&](std::string_view step, double) { return step != stopped; };
    const Result<BakedMaterial> baked = bakeMaterial(moss(), options, observer);
    REQUIRE(!baked);
    CHECK(baked.error().kind == ErrorKind::environment);
  }
}

TEST_CASE("a bake refuses no images, and layers of a method that cannot have them") {
  const auto refused = [](std::vector<Photograph> images, const BakeOptions& options) {
    const Result<BakedMaterial> baked = bakeMaterial(std::move(images), options);
    return !baked && baked.error().kind == ErrorKind::usage;
  };
  BakeOptions options;
  CHECK(refused({}, options));
  CHECK(!bakeMaterial(MaterialSet{}, options));
  options.layers = 2;
  options.method = QuiltingOptions{};
  CHECK(refused(moss(), options));
}

TEST_CASE("a bake of a material reports exhausted memory") {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  tbb::parallel_for(0, 1, [](int) {}); // oneTBB hangs if its first use runs out of memory
  BakeOptions options = fastest();
  options.exemplar.keepsOriginals = true; // so that bakeMaterial() itself makes large allocations
  const MaterialSet set = materialSetOf(moss(), options.exemplar.set).value();
  constexpr std::size_t kLarge = 16384;
  for (const int failing : {1, 2, 8, 32}) {
    INFO(failing);
    MaterialSet given = set;
    const Result<BakedMaterial> baked = [&] {
      const test::ExhaustedMemory memory(failing, kLarge);
      return bakeMaterial(std::move(given), options);
    }();
    REQUIRE(!baked);
    CHECK(baked.error().kind == ErrorKind::resources);
  }
}
