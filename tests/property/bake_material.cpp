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

Photograph photograph(const std::string& name, int channels, int side = 64) {
  const MapExemplar map = test::threeMaterials(side, side, 5);
  SrgbImage image(side, side, channels);
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

TEST_CASE("the borders of a rectified part are measured anew, also after --size measured others") {
  MaterialSet set;
  set.maps = {test::threeMaterials(64, 64, 5)};
  set.periodic = Periodic::no; // as reading leaves it with a size
  ExemplarOptions options{.flattening = {}, .outliers = {.keeps = true}};
  options.set.size = {64, 64};
  const auto prepared = [&] { return prepareExemplar(set, options, false).value(); };
  CHECK(prepared().set.periodic == Periodic::no);
  options.rectification.corners = TileCorners{{{2, 2}, {50, 3}, {51, 48}, {3, 50}}};
  CHECK(prepared().set.periodic == Periodic::detect);
  CHECK(!prepared().preparation.periodic);
  options.set.periodic = Periodic::no;
  CHECK(prepared().set.periodic == Periodic::no);
}

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
  for (const std::string stopped : {"flatten", "outliers", "bake", "judge"}) {
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

TEST_CASE("a bake of a material reports exhausted memory, whichever allocation fails") {
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  tbb::parallel_for(0, 1, [](int) {}); // oneTBB hangs if its first use runs out of memory
  // Large enough for every measure, lit from one side, with a dot that occurs once.
  constexpr int kSide = 132;
  Photograph moss = photograph("moss_diff.png", 3, kSide);
  std::vector<float>& values = std::get<SrgbImage>(moss.image.pixels).values;
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] *= 0.4f + 0.6f * float(i / 3 % kSide) / kSide;
  for (std::size_t i = 0; i < 100; ++i)
    values[3 * ((60 + i / 10) * kSide + 60 + i % 10)] = 1.0f;
  BakeOptions options = fastest();
  options.exemplar.keepsOriginals = true;
  // The next allocation to fail is a share of 1 / `steps` further. With a given period, only
  // flattening differs.
  for (const auto& [flattening, steps] :
       {std::pair{Flattening{.automatic = true}, 16}, {Flattening{.periodPixels = 32.0}, 2}}) {
    options.exemplar.flattening = flattening;
    const MaterialSet set =
        materialSetOf({moss, photograph("moss_rough.png", 1, kSide)}, options.exemplar.set).value();
    for (int failing = 1;; failing += std::max(1, failing / steps)) {
      INFO("allocation " << failing);
      MaterialSet given = set;
      bool reached = false;
      const Result<BakedMaterial> baked = [&] {
        const test::ExhaustedMemory memory(failing);
        auto made = bakeMaterial(std::move(given), options);
        reached = test::ExhaustedMemory::reached();
        return made;
      }();
      if (!reached) {
        REQUIRE(baked);
        CHECK(failing > 1000);
        break;
      }
      REQUIRE(!baked);
      REQUIRE(baked.error().kind == ErrorKind::resources);
    }
  }
}
