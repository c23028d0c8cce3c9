// SPDX-License-Identifier: MIT
// The engine plugin's switches, which leave out of the shaders what no material needs.
#include "plugin_plan.h"

#include <catch2/catch.hpp>

using namespace lichen;
using namespace lichen::test;

namespace {

std::string switchesOf(const std::vector<LichenMaterialParameters>& materials,
                       const LichenPlacement* placement = nullptr) {
  std::vector<const LichenMaterialParameters*> pointers;
  for (const LichenMaterialParameters& material : materials)
    pointers.push_back(&material);
  char text[LICHEN_SWITCH_BYTES] = "";
  CHECK(lichenGetShaderSwitches(pointers.data(), std::uint32_t(pointers.size()), placement, text,
                                sizeof text, nullptr) == LICHEN_SUCCESS);
  return text;
}

} // namespace

TEST_CASE("the switches leave out what no material needs") {
  const OwnedBundle tiling(example::smallest());
  const LichenMaterialParameters plain = parametersOf(tiling.handle);
  const std::string left =
      " -DLICHEN_METHODS=1 -DLICHEN_VALUES_ABOVE_ONE=0 -DLICHEN_OMIT_TRIPLANAR";
  CHECK(switchesOf({plain}) ==
        "-DLICHEN_ROLES=16" + left +
            " -DLICHEN_GAUSSIAN_ONLY=0 -DLICHEN_TILE_ROTATION=0 -DLICHEN_BLEND_SHARPNESS=0"
            " -DLICHEN_GRAIN=0 -DLICHEN_PERIODIC_LATTICE=0");
  LichenMaterialParameters turned = plain;
  turned.tileRotation = 2;
  turned.blendSharpness = 2.0;
  LichenPlacement placement = atOrigin();
  placement.periodTiles[0] = placement.periodTiles[1] = 2.0;
  placement.maxAnisotropy = 8.0f;
  CHECK(switchesOf({plain, turned}, &placement) ==
        "-DLICHEN_ROLES=16" + left +
            " -DLICHEN_GAUSSIAN_ONLY=0 -DLICHEN_GRAIN=0 -DLICHEN_ANISOTROPIC=1");
  BundleFile oak = example::smallest();
  oak.bundle.noises[0].as<TilingNoise>().grain = Grain::x;
  const OwnedBundle grained(oak);
  CHECK(switchesOf({plain, parametersOf(grained.handle)}).find("GRAIN") == std::string::npos);
  auto noise = got<LichenNoiseProperties>(lichenGetNoiseProperties, grained.handle, 0);
  CHECK(noise.hasGrain == 1);
  // Of quilting the shader always reads the lattice from the material.
  BundleFile boards = example::smallestQuilting();
  boards.bundle.noises[0].as<QuiltingNoise>().grain = Grain::x;
  const OwnedBundle quilted(boards);
  CHECK(switchesOf({plain, parametersOf(quilted.handle)}).find("-DLICHEN_GRAIN=0") !=
        std::string::npos);
  REQUIRE(lichenGetNoiseProperties(tiling.handle, 0, &noise) == LICHEN_SUCCESS);
  CHECK(noise.hasGrain == 0);
  LichenMaterialParameters inPlanes = plain;
  inPlanes.mapping = LICHEN_MAPPING_TRIPLANAR;
  CHECK(switchesOf({inPlanes}).find(" -DLICHEN_OTHER_MAPPINGS=0 ") != std::string::npos);
  CHECK(switchesOf({inPlanes, plain}).find("MAPPINGS") == std::string::npos);
  // Of two bundles and methods.
  const OwnedBundle textons(example::textonMix());
  auto mixed = got<LichenMaterialParameters>(lichenGetMaterialParameters, textons.handle, 1);
  const std::string both = switchesOf({plain, mixed});
  CHECK(both.find(" -DLICHEN_METHODS=3") != std::string::npos);
  CHECK(both.find("MIXED_TEXTONS") == std::string::npos);
  CHECK(switchesOf({mixed}).find(" -DLICHEN_METHODS=2") != std::string::npos);
  mixed.pointProcess = LICHEN_POINT_PROCESS_STRATIFIED;
  CHECK(switchesOf({mixed}).find(" -DLICHEN_POISSON_POINTS=0") != std::string::npos);
  mixed.pointProcess = LICHEN_POINT_PROCESS_POISSON;
  CHECK(switchesOf({mixed}).find("POISSON") == std::string::npos);
}

TEST_CASE("the switches of local random-phase noise leave out what only other methods have") {
  const OwnedBundle cosines(example::smallestCosines());
  CHECK(switchesOf({parametersOf(cosines.handle)}) ==
        "-DLICHEN_ROLES=16 -DLICHEN_METHODS=4 -DLICHEN_VALUES_ABOVE_ONE=0 -DLICHEN_OMIT_TRIPLANAR"
        " -DLICHEN_TABLES=0 -DLICHEN_STRUCTURE=0 -DLICHEN_OMIT_SOLID -DLICHEN_PERIODIC_LATTICE=0");
  LichenMaterialParameters solid = parametersOf(cosines.handle);
  solid.mapping = LICHEN_MAPPING_SOLID;
  CHECK(switchesOf({solid}).find("OMIT_SOLID") == std::string::npos);
  const OwnedBundle structure(example::smallestStructure());
  CHECK(switchesOf({parametersOf(cosines.handle), parametersOf(structure.handle)})
            .find("STRUCTURE") == std::string::npos);
  const OwnedBundle tiling(example::smallest());
  const std::string both = switchesOf({parametersOf(cosines.handle), parametersOf(tiling.handle)});
  CHECK(both.find(" -DLICHEN_METHODS=5") != std::string::npos);
  CHECK(both.find("TABLES=0") == std::string::npos);
  CHECK(both.find("GAUSSIAN_ONLY") == std::string::npos);
}

TEST_CASE("the switches of multiple-kernels noise leave out kinds of kernels that there are not") {
  const OwnedBundle kernels(example::smallestKernels());
  auto noise = got<LichenNoiseProperties>(lichenGetNoiseProperties, kernels.handle, 0);
  CHECK(noise.kernelKinds == (LICHEN_KERNELS_RINGS | LICHEN_KERNELS_PATTERN));
  CHECK(noise.mappings == (1u << LICHEN_MAPPING_UV | 1u << LICHEN_MAPPING_TRIPLANAR));
  CHECK(switchesOf({parametersOf(kernels.handle)}) ==
        "-DLICHEN_ROLES=16 -DLICHEN_METHODS=8 -DLICHEN_VALUES_ABOVE_ONE=0 -DLICHEN_OMIT_TRIPLANAR"
        " -DLICHEN_OMIT_SURFACE -DLICHEN_TABLES=0 -DLICHEN_SQUARE_KERNELS=0 -DLICHEN_OMIT_SOLID"
        " -DLICHEN_PERIODIC_LATTICE=0");
}

TEST_CASE("the switches of quilting leave out what only other methods have") {
  const OwnedBundle quilting(example::smallestQuilting());
  auto noise = got<LichenNoiseProperties>(lichenGetNoiseProperties, quilting.handle, 0);
  CHECK(noise.method == LICHEN_NOISE_QUILTING);
  CHECK(noise.mappings == (1u << LICHEN_MAPPING_UV | 1u << LICHEN_MAPPING_TRIPLANAR));
  CHECK(switchesOf({parametersOf(quilting.handle)}) ==
        "-DLICHEN_ROLES=18 -DLICHEN_METHODS=16 -DLICHEN_VALUES_ABOVE_ONE=0"
        " -DLICHEN_OMIT_TRIPLANAR -DLICHEN_TABLES=0 -DLICHEN_PERIODIC_LATTICE=0");
}

TEST_CASE("the switches keep values above 1 for a noise that has them") {
  BundleFile file = example::smallest();
  NoiseMap& height = file.bundle.noises[0].maps[0];
  height.encoding = ValueEncoding::log2;
  file.bundle.tables[*height.as<TilingMap>().inverseTable] =
      example::patternTable("", TexelFormat::r16Sfloat, 256, 1, 1, 1);
  const OwnedBundle above(file), below(example::smallest());
  const LichenMaterialParameters high = parametersOf(above.handle);
  const LichenMaterialParameters low = parametersOf(below.handle);
  CHECK(switchesOf({high}).find("VALUES_ABOVE_ONE") == std::string::npos);
  CHECK(switchesOf({low, high}).find("VALUES_ABOVE_ONE") == std::string::npos);
  CHECK(switchesOf({low}).find(" -DLICHEN_VALUES_ABOVE_ONE=0") != std::string::npos);
}

TEST_CASE("the longest text of switches fits") {
  // Materials of all methods, in three planes, with an anisotropic sampler. Each switch that is
  // missing excludes longer ones.
  const OwnedBundle tiling(example::smallest()), textons(example::smallestTexton()),
      cosines(example::smallestCosines()), kernels(example::smallestKernels()),
      quilting(example::smallestQuilting());
  std::vector<LichenMaterialParameters> materials{
      parametersOf(tiling.handle), parametersOf(textons.handle), parametersOf(cosines.handle),
      parametersOf(kernels.handle), parametersOf(quilting.handle)};
  for (LichenMaterialParameters& material : materials)
    material.mapping = LICHEN_MAPPING_TRIPLANAR;
  LichenPlacement placement = atOrigin();
  placement.maxAnisotropy = 8.0f;
  const std::string text = switchesOf(materials, &placement);
  CHECK(text == "-DLICHEN_ROLES=18 -DLICHEN_METHODS=31 -DLICHEN_VALUES_ABOVE_ONE=0"
                " -DLICHEN_OTHER_MAPPINGS=0 -DLICHEN_OMIT_SURFACE -DLICHEN_MIXED_TEXTONS=0 "
                "-DLICHEN_POISSON_POINTS=0 -DLICHEN_CUBIC_TEXTONS=0"
                " -DLICHEN_NEAREST_TEXTONS=0 -DLICHEN_TILE_ROTATION=0"
                " -DLICHEN_BLEND_SHARPNESS=0 -DLICHEN_GRAIN=0 -DLICHEN_STRUCTURE=0"
                " -DLICHEN_SQUARE_KERNELS=0"
                " -DLICHEN_OMIT_SOLID -DLICHEN_PERIODIC_LATTICE=0 -DLICHEN_ANISOTROPIC=1");
  const std::string others = " -DLICHEN_GAUSSIAN_ONLY=0 -DLICHEN_RING_KERNELS=0"
                             " -DLICHEN_KERNEL_PATTERN=0 -DLICHEN_OMIT_TRIPLANAR";
  CHECK(text.size() + others.size() < LICHEN_SWITCH_BYTES);
}

TEST_CASE("a buffer that is too small for the switches is an error") {
  const OwnedBundle bundle(example::smallest());
  const LichenMaterialParameters parameters = parametersOf(bundle.handle);
  const LichenMaterialParameters* const pointer = &parameters;
  char text[8] = "before";
  LichenDiagnostic diagnostic;
  LICHEN_INIT(diagnostic, LICHEN_STRUCTURE_DIAGNOSTIC);
  CHECK(lichenGetShaderSwitches(&pointer, 1, nullptr, text, sizeof text, &diagnostic) ==
        LICHEN_ERROR_USAGE);
  CHECK(std::string(diagnostic.text) == "textBytes 8 is too small; expected at least 1024");
  CHECK(std::string(text) == "before");
  CHECK(lichenGetShaderSwitches(nullptr, 1, nullptr, text, sizeof text, nullptr) ==
        LICHEN_ERROR_USAGE);
  CHECK(lichenGetShaderSwitches(&pointer, 0, nullptr, text, sizeof text, nullptr) ==
        LICHEN_ERROR_USAGE);
}
