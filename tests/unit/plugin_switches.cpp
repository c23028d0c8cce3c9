// SPDX-License-Identifier: MIT
// The engine plugin's switches, which leave out of the shaders what no material needs.
#include "plugin_plan.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

using namespace lichen;
using namespace lichen::test;

namespace {

LichenShaderSwitches switchesOf(const std::vector<LichenMaterialParameters>& materials,
                                const LichenPlacement* placement = nullptr) {
  std::vector<const LichenMaterialParameters*> pointers;
  for (const LichenMaterialParameters& material : materials)
    pointers.push_back(&material);
  LichenShaderSwitches switches;
  LICHEN_INIT(switches, LICHEN_STRUCTURE_SHADER_SWITCHES);
  CHECK(lichenGetShaderSwitches(pointers.data(), std::uint32_t(pointers.size()), placement,
                                &switches, nullptr) == LICHEN_SUCCESS);
  return switches;
}

/// What switches must be for some materials, beside the bits of methods and mappings in features.
struct Row {
  const char* name;
  std::vector<LichenMaterialParameters> materials;
  std::uint32_t methods, features;
  std::uint32_t mappings = 1u << LICHEN_MAPPING_UV, roles = 1u << LICHEN_HEIGHT;
};

constexpr std::uint32_t kTiling = 1u << LICHEN_METHOD_TILING;
constexpr std::uint32_t kTexton = 1u << LICHEN_METHOD_TEXTON;
constexpr std::uint32_t kCosines = 1u << LICHEN_METHOD_LOCAL_RANDOM_PHASE;
constexpr std::uint32_t kKernels = 1u << LICHEN_METHOD_MULTIPLE_KERNELS;
constexpr std::uint32_t kQuilting = 1u << LICHEN_METHOD_QUILTING;
constexpr std::uint32_t kUv = 1u << LICHEN_MAPPING_UV;
constexpr std::uint32_t kTriplanar = 1u << LICHEN_MAPPING_TRIPLANAR;
constexpr std::uint32_t kSurface = 1u << LICHEN_MAPPING_SURFACE;
constexpr std::uint32_t kSolid = 1u << LICHEN_MAPPING_SOLID;
constexpr std::uint32_t kColor = 1u << LICHEN_BASE_COLOR;
constexpr std::uint32_t kNormal = 1u << LICHEN_NORMAL;
constexpr std::uint32_t kHeight = 1u << LICHEN_HEIGHT;
constexpr std::uint32_t kTables = LICHEN_FEATURE_TABLES;
constexpr std::uint32_t kNoTable = LICHEN_FEATURE_GAUSSIAN_ONLY;
constexpr std::uint32_t kKernel = LICHEN_FEATURE_RING_KERNELS | LICHEN_FEATURE_PATTERNS;

BundleFile withSquareWindow() {
  BundleFile file = example::smallestKernels();
  file.bundle.noises[0].as<MultipleKernelsNoise>().window = KernelWindow::sinc;
  // Its matrix must be diagonal: the third number of the second texel.
  Table& kernels =
      file.bundle.tables[file.bundle.noises[0].maps[0].as<MultipleKernelsMap>().kernels];
  std::fill_n(kernels.texels.begin() + 6 * sizeof(float), sizeof(float), std::byte(0));
  return file;
}

BundleFile withGrain() {
  BundleFile file = example::smallest();
  file.bundle.noises[0].as<TilingNoise>().grain = Grain::x;
  return file;
}

BundleFile quiltingWithGrain() {
  BundleFile file = example::smallestQuilting();
  file.bundle.noises[0].as<QuiltingNoise>().grain = Grain::x;
  return file;
}

BundleFile withOrder0() {
  BundleFile file = example::smallestTexton();
  file.bundle.noises[0].as<TextonShape>().order = 0;
  return file;
}

BundleFile withValuesAboveOne() {
  BundleFile file = example::smallest();
  NoiseMap& height = file.bundle.noises[0].maps[0];
  height.encoding = ValueEncoding::log2;
  file.bundle.tables[*height.as<TilingMap>().inverseTable] =
      example::patternTable("", TexelFormat::r16Sfloat, 256, 1, 1, 1);
  return file;
}

LichenMaterialParameters mappedAs(LichenMaterialParameters material, LichenMapping mapping) {
  material.mapping = mapping;
  return material;
}

} // namespace

TEST_CASE("the switches are those that some material needs") {
  const OwnedBundle tilings(example::smallest()), grains(withGrain()), lights(withValuesAboveOne()),
      textons(example::smallestTexton()), nearest(withOrder0()), mixes(example::textonMix()),
      swells(example::smallestCosines()), structures(example::smallestStructure()),
      ripples(example::smallestKernels()), squares(withSquareWindow()),
      bricks(example::smallestQuilting()), boards(quiltingWithGrain());
  const LichenMaterialParameters tiling = parametersOf(tilings.handle),
                                 texton = parametersOf(textons.handle),
                                 cosines = parametersOf(swells.handle),
                                 structure = parametersOf(structures.handle),
                                 kernels = parametersOf(ripples.handle),
                                 quilting = parametersOf(bricks.handle);
  LichenMaterialParameters turned = tiling, sharp = tiling, random = texton, stratified;
  turned.tileRotation = 2;
  sharp.blendSharpness = 2.0;
  random.pointProcess = LICHEN_POINT_PROCESS_POISSON;
  const auto mix = got<LichenMaterialParameters>(lichenGetMaterialParameters, mixes.handle, 1);
  stratified = mix;
  stratified.pointProcess = LICHEN_POINT_PROCESS_STRATIFIED;
  constexpr std::uint32_t kMix = LICHEN_FEATURE_MIXES | LICHEN_FEATURE_CUBIC_TEXTONS,
                          kPoisson = LICHEN_FEATURE_POISSON_POINTS,
                          kNearest = LICHEN_FEATURE_NEAREST_TEXTONS,
                          kRotation = LICHEN_FEATURE_TILE_ROTATION,
                          kSharpness = LICHEN_FEATURE_BLEND_SHARPNESS,
                          kAboveOne = LICHEN_FEATURE_VALUES_ABOVE_ONE,
                          kSquare = LICHEN_FEATURE_SQUARE_KERNELS, kBoth = kHeight | kNormal;
  const Row rows[] = {
      {"tiling", {tiling}, kTiling, kTables},
      {"rotated", {turned}, kTiling, kTables | kRotation},
      {"sharp", {sharp}, kTiling, kTables | kSharpness},
      {"both", {turned, sharp}, kTiling, kTables | kRotation | kSharpness},
      {"a grain", {tiling, parametersOf(grains.handle)}, kTiling, kTables | LICHEN_FEATURE_GRAIN},
      {"values above 1", {tiling, parametersOf(lights.handle)}, kTiling, kTables | kAboveOne},
      {"planes", {mappedAs(tiling, LICHEN_MAPPING_TRIPLANAR)}, kTiling, kTables, kTriplanar},
      {"two mappings",
       {mappedAs(tiling, LICHEN_MAPPING_TRIPLANAR), tiling},
       kTiling,
       kTables,
       kTriplanar | kUv},
      {"textons", {texton}, kTexton, kNoTable},
      {"a Poisson process", {random}, kTexton, kNoTable | kPoisson},
      {"order 0", {parametersOf(nearest.handle)}, kTexton, kNoTable | kNearest},
      {"a mix on a surface", {mix}, kTexton, kNoTable | kMix | kPoisson, kSurface, kColor | kBoth},
      {"a stratified mix", {stratified}, kTexton, kNoTable | kMix, kSurface, kColor | kBoth},
      {"cosines", {cosines}, kCosines, kNoTable},
      {"a solid", {mappedAs(cosines, LICHEN_MAPPING_SOLID)}, kCosines, kNoTable, kSolid},
      {"a structure", {cosines, structure}, kCosines, kNoTable | LICHEN_FEATURE_STRUCTURES},
      {"kernels", {kernels}, kKernels, kNoTable | kKernel},
      {"square kernels", {parametersOf(squares.handle)}, kKernels, kNoTable | kKernel | kSquare},
      {"quilting", {quilting}, kQuilting, kNoTable, kUv, kBoth},
      // Its shader always reads the lattice from the material.
      {"its grain", {parametersOf(boards.handle)}, kQuilting, kNoTable, kUv, kBoth},
      {"two bundles and methods", {tiling, cosines}, kTiling | kCosines, kTables | kNoTable},
      {"all methods",
       {tiling, texton, cosines, kernels, quilting},
       kTiling | kTexton | kCosines | kKernels | kQuilting,
       kTables | kNoTable | kKernel,
       kUv,
       kBoth},
  };
  for (const Row& row : rows) {
    INFO(row.name);
    const LichenShaderSwitches found = switchesOf(row.materials);
    const std::uint32_t ofMappings =
        ((row.mappings & kUv) != 0 ? LICHEN_FEATURE_UV : 0u) |
        ((row.mappings & kTriplanar) != 0 ? LICHEN_FEATURE_TRIPLANAR : 0u) |
        ((row.mappings & kSurface) != 0 ? LICHEN_FEATURE_SURFACE : 0u) |
        ((row.mappings & kSolid) != 0 ? LICHEN_FEATURE_SOLID : 0u);
    CHECK(found.methods == row.methods);
    CHECK(found.mappings == row.mappings);
    CHECK(found.roles == row.roles);
    CHECK(found.features == (row.features | row.methods | ofMappings));
    CHECK(found.layers == 1);
    CHECK(found.anisotropic == 0);
  }
}

TEST_CASE("the properties of a noise say which mappings it has") {
  const auto propertiesOf = [](const BundleFile& file) {
    const OwnedBundle bundle(file);
    return got<LichenNoiseProperties>(lichenGetNoiseProperties, bundle.handle, 0);
  };
  constexpr std::uint32_t kInPlanes = kUv | kTriplanar;
  CHECK(propertiesOf(example::smallestKernels()).mappings == kInPlanes);
  const LichenNoiseProperties quilting = propertiesOf(example::smallestQuilting());
  CHECK(quilting.method == LICHEN_NOISE_QUILTING);
  CHECK(quilting.mappings == kInPlanes);
}
