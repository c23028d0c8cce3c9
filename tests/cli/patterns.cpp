// SPDX-License-Identifier: MIT
// `lichen bake --method multiple-kernels` with patterns, and with spectra in words and colours.
#include "command_run.h"

#include <lichen/bundle_files.h>

#include <catch2/catch.hpp>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

struct Baked {
  MultipleKernelsNoise noise;
  std::string notes;
};

struct Photograph {
  Workplace workplace;
  Arguments bakeOf{"bake",      workplace.write("photograph.png", speckled(256, 256, 3)),
                   "-o",        workplace.path("noise.glb"),
                   "--method",  "multiple-kernels",
                   "--preview", "none"};

  /// The noise of a bake with these options.
  [[nodiscard]] Baked bake(const Arguments& more) const {
    const std::string notes = succeed(bakeOf + more).errors;
    return {
        readBundle(workplace.path("noise.glb")).value().noises.front().as<MultipleKernelsNoise>(),
        notes};
  }
};

} // namespace

TEST_CASE("the note of a bake says its kernels, its pattern, and what fewer kernels would do") {
  const Photograph photograph;
  const Baked baked = photograph.bake({"--pattern", "cosines:8", "--perturb", "0.5"});
  CHECK(baked.noise.cosines == 8);
  CHECK(!baked.noise.hasGivenSpectrum);
  CHECK_THAT(baked.notes, Catch::Contains("a pattern of 8 cosines") &&
                              Catch::Contains("dB from that asked for; with 2 kernels"));
}

TEST_CASE("patterns are taken from parts and from pictures") {
  const Photograph photograph;
  const Baked waves = photograph.bake({"--pattern", "wave:5:3,wave:5:-3:0.5:0.25"});
  CHECK(waves.noise.cosines == 2);
  CHECK(waves.noise.hasGivenSpectrum);
  CHECK(photograph.bake({"--pattern", "spline:0:4:1:0:0.5"}).noise.cosines == 2); // the third is 0
  SrgbImage dots(8, 8, 1);
  dots.values[0] = 1.0f;
  const std::string picture = photograph.workplace.write("dots.png", dots);
  CHECK(photograph.bake({"--pattern", picture + ":3"}).noise.cosines > 8);
}

TEST_CASE("a pattern that cannot be is refused") {
  const Photograph photograph;
  checkRefusals(photograph.bakeOf,
                std::vector<RefusedValues>{
                    {"--pattern",
                     {"cosines:97", "cosines:0", "wave:0:0", "wave:1.5:2", "wave:600:2",
                      "spline:0:4:1", "wave:1:2,stripes", "dots.png:65", "dots.png:"},
                     "cosines:N with N from 1 to 96"},
                    {"--perturb", {"17"}, "a number from 0 to 16"}});
  const std::string grey = photograph.workplace.write("grey.png", SrgbImage(8, 8, 1));
  for (const std::string pattern : {grey.c_str(), "wave:8:0,wave:8:0:1:0.5"})
    checkRefusal(photograph.bakeOf + Arguments{"--pattern", pattern}, kBadInput,
                 {"the pattern does not vary"});
}

TEST_CASE("without a pattern its strength has no effect, and a note says so") {
  const Photograph photograph;
  CHECK_THAT(photograph.bake({"--perturb", "2"}).notes,
             Catch::Contains("--perturb has no effect without --pattern"));
}

TEST_CASE("spectra are given by lobes and by coloured pictures") {
  const Photograph photograph;
  CHECK(photograph.bake({"--spectrum", "lobe:10:4:2,ring:3:4"}).noise.hasGivenSpectrum);
  checkRefusal(photograph.bakeOf + Arguments{"--spectrum", "lobe:10:4:0"}, kUsage, {"lobe:12:5:3"});
  SrgbImage colored(33, 33, 3);
  for (std::size_t i = 0; i < 33 * 33; ++i)
    colored.values[3 * i + (i % 33 < 16 ? 0 : 2)] = 0.8f;
  CHECK(photograph.bake({"--spectrum", photograph.workplace.write("colored.png", colored)})
            .noise.hasGivenSpectrum);
}
