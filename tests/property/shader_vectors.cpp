// SPDX-License-Identifier: MIT
// The extension's published test vectors, from an independent implementation of its specification,
// against the shader library's own functions and the constants that hosts give them: impacts in the
// plane and in space, and the planes of triplanar noise.
#define LICHEN_METHODS 15
#include "checkout_paths.h"
#include "evaluation/shader_library.h"
#include "synthetic_texton.h"

#include <lichen/shader_parameters.h>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <fstream>

using namespace lichen;
using namespace lichen::test;

namespace {

using Library = glsl::ShaderLibrary;
using nlohmann::json;

const json& vectors() {
  static const json file = [] {
    std::ifstream stream(sourcePath("docs/gltf_extension/test_vectors.json"));
    return json::parse(stream);
  }();
  return file;
}

/// The cell of an impact, modulo 2^32.
std::uint32_t cellOf(const json& v, std::size_t axis) {
  return std::uint32_t(std::int64_t(v["cell"][axis]));
}
bool isPoisson(const json& v) { return v["process"] == "poisson"; }

/// Checks `impacts` in this order: signs, and places in their cell, of `axes` coordinates.
void checkImpacts(const json& v, const std::vector<std::array<float, 4>>& impacts,
                  std::size_t axes) {
  INFO(v.dump());
  REQUIRE(impacts.size() == v["impacts"].size());
  for (std::size_t k = 0; k < impacts.size(); ++k) {
    CHECK(impacts[k][3] == float(v["impacts"][k]["sign"]));
    for (std::size_t axis = 0; axis < axes; ++axis)
      CHECK(impacts[k][axis] == float(v["impacts"][k]["place"][axis]));
  }
}

/// A texton noise whose tiles have these texels.
Bundle textonsOf(const json& v) {
  return syntheticTextonBundle(
             {.texelsPerTileX = v["texelsPerTile"][0], .texelsPerTileY = v["texelsPerTile"][1]})
      .bundle;
}

} // namespace

TEST_CASE("Poisson counts match the published test vectors") {
  for (const json& v : vectors()["poissonCount"])
    CHECK(Library().lichenPoissonCount(v["word"]) == v["count"].get<std::uint32_t>());
}

TEST_CASE("impacts in the plane match the published test vectors") {
  Library library;
  CHECK(vectors()["impacts"].size() > 20);
  for (const json& v : vectors()["impacts"]) {
    shader::LichenMaterial host{};
    shader::LichenTextonMaterial part{};
    part.pointProcess = isPoisson(v) ? LICHEN_POINTS_POISSON : LICHEN_POINTS_STRATIFIED;
    setPart(host, part);
    const auto material = std::bit_cast<Library::LichenMaterial>(host);
    Library::LichenImpacts window{}; // of one cell, with every position in reach
    window.firstCell = glsl::ivec2(int(cellOf(v, 0)), int(cellOf(v, 1)));
    window.seedWord = latticeSeed(v["seed"], v["plane"]);
    window.cellTexels = glsl::vec2(1.0f);
    window.end = glsl::vec2(-0.5f);
    window.radius = glsl::vec2(2.0f);
    std::vector<std::array<float, 4>> found;
    Library::LichenWalk walk = library.lichenFirstImpact(window, material);
    while (library.lichenHasImpact(walk, window)) {
      library.lichenStep(walk, window, material, {});
      if (walk.isReached)
        found.push_back({-walk.offset.x.v, -walk.offset.y.v, 0.0f, walk.sign.v});
    }
    checkImpacts(v, found, 2);
  }
}

TEST_CASE("impacts in space and the grid of textons there match the published test vectors") {
  Library library;
  CHECK(vectors()["surfaceImpacts"].size() > 20);
  for (const json& v : vectors()["surfaceImpacts"]) {
    const glsl::uvec3 cell(cellOf(v, 0), cellOf(v, 1), cellOf(v, 2));
    Library::LichenSurfaceCubes cubes = library.lichenSurfaceCubesAt(
        glsl::vec3(0.0f), cell, glsl::mat3(0.5f), glsl::vec3(0.0f), glsl::vec3(2.0f),
        latticeSeed(v["seed"], kSurfacePlane), isPoisson(v));
    cubes.firstColumn = cubes.lastColumn = glsl::vec2(0.0f);
    std::vector<std::array<float, 4>> found;
    Library::LichenSurfaceWalk walk = library.lichenFirstSurfaceImpact(cubes);
    while (library.lichenHasImpact(walk, cubes)) {
      library.lichenSurfaceStep(walk, cubes);
      // Offsets are half a place; the weight is 1 - z / 2.
      const float weight = std::abs(walk.weight.v);
      if (walk.isReached && walk.cell == cell)
        found.push_back({-2.0f * walk.offset.x.v, -2.0f * walk.offset.y.v, 2.0f * (1.0f - weight),
                         walk.weight.v / weight});
    }
    checkImpacts(v, found, 3);
  }
  for (const json& v : vectors()["surfaceGrid"]) {
    Bundle bundle = textonsOf(v);
    TextonShape& shape = bundle.noises[0].as<TextonShape>();
    shape.coefficientsX = v["coefficients"][0];
    shape.coefficientsY = v["coefficients"][1];
    shape.order = v["order"];
    MaterialNoise material;
    material.impacts = v["impacts"];
    material.mapping = Mapping::surface;
    const double cells = v["cells"];
    const shader::LichenMaterial block = shaderMaterial(bundle, material, {}).material;
    CHECK(double(block.columnsPerTile) == cells);
    const auto part = partOf<shader::LichenTextonMaterial>(block);
    CHECK(part.surfaceCubeTexels == float(double(shape.texelsPerTileX) / cells));
    CHECK(double(part.amplitude) == Approx(double(v["amplitude"])).epsilon(1e-6));
  }
}

namespace {

MaterialNoise triplanarMaterial(double rotation) {
  MaterialNoise material;
  material.mapping = Mapping::triplanar;
  material.rotation = rotation;
  return material;
}

/// A noise of kernels, whose points tell the tile, and its material.
struct Kernels {
  Kernels(const MaterialNoise& use, double tileSize, const std::array<int, 2>& texels) {
    shader::LichenNoise host{};
    host.method = LICHEN_METHOD_MULTIPLE_KERNELS;
    host.tileTexelsX = float(texels[0]);
    host.tileTexelsY = float(texels[1]);
    host.tileAspect = host.tileTexelsX / host.tileTexelsY;
    host.tileSizeMetres = float(tileSize);
    noise = std::bit_cast<Library::LichenNoise>(host);
    planes = std::bit_cast<Library::LichenTriplanarMaterial>(shaderMaterial(host, use, {}));
  }
  Library::LichenNoise noise;
  Library::LichenTriplanarMaterial planes;
};

} // namespace

TEST_CASE("weights of planes match the published test vectors") {
  Library library;
  for (const json& v : vectors()["planeWeights"]) {
    Library::LichenMaterial material{};
    material.planeSharpness = v["planeSharpness"].get<float>();
    const auto normal = v["normal"].get<std::array<float, 3>>();
    const glsl::vec3 weights =
        library.lichenPlaneWeights({normal[0], normal[1], normal[2]}, material);
    for (int axis = 0; axis < 3; ++axis)
      CHECK(double(weights[axis].v) ==
            Approx(v["weights"][std::size_t(axis)].get<double>()).margin(1e-5));
  }
}

TEST_CASE("positions on planes match the published test vectors") {
  Library library;
  for (const json& v : vectors()["planePlaces"]) {
    MaterialNoise use = triplanarMaterial(v["rotation"]);
    use.scale = v["scale"];
    const Kernels kernels(use, v["tileSize"], v["texelsPerTile"].get<std::array<int, 2>>());
    const auto position = v["position"].get<std::array<float, 3>>();
    const glsl::vec3 none(0.0f);
    const Library::LichenShadingPoint shading =
        library.lichenPointTriplanarGrad({position[0], position[1], position[2]}, none, none,
                                         glsl::vec3(1.0f), kernels.planes, kernels.noise);
    for (int rank = 0; rank < 3; ++rank) {
      const Library::LichenPlanePoint plane =
          library.lichenPlanePoint(shading.triplanar, rank, shading.point, kernels.noise);
      const Library::LichenKernelsPoint& point = plane.point.multipleKernels;
      for (int k = 0; k < 2; ++k)
        CHECK(
            LICHEN_KERNEL_TILES * (point.group[k] + double(point.inside[k].v)) ==
            Approx(v["tiles"][std::size_t(plane.axis)][std::size_t(k)].get<double>()).margin(1e-5));
    }
  }
}

TEST_CASE("gradients in space of the slopes of planes match the published test vectors") {
  Library library;
  for (const json& v : vectors()["planeGradients"]) {
    const Kernels kernels(triplanarMaterial(v["rotation"]), 1.0, {64, 64});
    const auto slopes = v["slopes"].get<std::array<float, 2>>();
    for (int axis = 0; axis < 3; ++axis) {
      const glsl::vec3 gradient =
          library.lichenSlopesToSpace({slopes[0], slopes[1]}, axis, kernels.planes.material);
      for (int k = 0; k < 3; ++k)
        CHECK(double(gradient[k].v) ==
              Approx(v["gradients"][std::size_t(axis)][std::size_t(k)].get<double>()).margin(1e-6));
    }
  }
}

TEST_CASE("the origins of planes match the published test vectors") {
  for (const json& v : vectors()["planeOrigins"]) {
    MaterialNoise material = triplanarMaterial(v["rotation"]);
    material.offset = v["offset"].get<std::array<double, 2>>();
    Placement placement;
    placement.tileOriginX = v["tileOrigin"][0];
    placement.tileOriginY = v["tileOrigin"][1];
    placement.tileOriginZ = v["tileOrigin"][2];
    const shader::LichenTriplanarMaterial use = shaderMaterial(textonsOf(v), material, placement);
    const shader::LichenMaterial& x = use.material;
    const shader::LichenPlane planes[] = {
        {x.cellI, x.cellJ, x.offsetX, x.offsetY, x.seedWord, 0, 0, 0}, use.planeY, use.planeZ};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      INFO("tileOrigin " << v["tileOrigin"] << ", plane " << axis);
      const json& expected = v["planes"][axis];
      const auto tile = expected["tile"].get<std::array<std::int64_t, 2>>();
      // A tile is a whole number of cells, counted modulo 2^32.
      CHECK(std::uint32_t(planes[axis].cellI) ==
            std::uint32_t(std::uint64_t(tile[0]) * std::uint64_t(x.columnsPerTile)));
      CHECK(std::uint32_t(planes[axis].cellJ) ==
            std::uint32_t(std::uint64_t(tile[1]) * std::uint64_t(x.rowsPerTile)));
      // Origins of 1.3e8 tiles in doubles.
      CHECK(double(planes[axis].offsetX) == Approx(expected["rest"][0].get<double>()).margin(2e-7));
      CHECK(double(planes[axis].offsetY) == Approx(expected["rest"][1].get<double>()).margin(2e-7));
      CHECK(planes[axis].seedWord == latticeSeed(material.seed, std::uint32_t(axis)));
    }
  }
}
