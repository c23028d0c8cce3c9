// SPDX-License-Identifier: MIT
#include "landscape.h"
#include "materials.h"

#include <lichen/fft.h>
#include <lichen/gltf_container.h>
#include <lichen/spectrum.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>
#include <string>

using namespace lichen;
using exemplars::kMaterials;
using exemplars::Material;

namespace {

constexpr int kSide = 512;

/// Generates each material once for all tests.
const SrgbImage& exemplar(const Material& material) {
  static std::map<std::string, SrgbImage> made;
  const auto [place, isNew] = made.try_emplace(material.name);
  if (isNew)
    place->second = material.generate(kSide);
  return place->second;
}

/// 64-bit FNV-1a of the image's 8-bit values.
std::uint64_t fingerprint(const SrgbImage& image) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const float value : image.values)
    hash = (hash ^ std::uint64_t(std::lround(value * 255.0f))) * 0x100000001b3u;
  return hash;
}

/// Mean absolute difference of luminance between columns x and x + 1, with wraparound; or rows.
double step(const std::vector<float>& plane, int at, bool columns) {
  double sum = 0.0;
  for (int k = 0; k < kSide; ++k) {
    const int next = (at + 1) % kSide;
    const std::size_t a = columns ? std::size_t(k * kSide + at) : std::size_t(at * kSide + k);
    const std::size_t b = columns ? std::size_t(k * kSide + next) : std::size_t(next * kSide + k);
    sum += std::abs(double(plane[b]) - double(plane[a]));
  }
  return sum / kSide;
}

/// The deepest valley of the histogram of `values`: 1 minus the valley over the lower of the peaks
/// on its two sides. The histogram is smoothed with a Gaussian of 0.15 standard deviations; then a
/// normal sample of this size has no valley deeper than 0.05.
double deepestValley(const std::vector<float>& values) {
  constexpr int kBins = 256;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  double mean = 0.0, squares = 0.0;
  std::vector<double> histogram(kBins, 0.0);
  for (const float value : values) {
    const double t = (double(value) - double(*low)) / (double(*high) - double(*low));
    histogram[std::size_t(std::min(kBins - 1, int(t * kBins)))] += 1.0;
    mean += t / double(values.size());
    squares += t * t / double(values.size());
  }
  const double sigma = 0.15 * std::sqrt(squares - mean * mean) * kBins;
  std::vector<double> smooth(kBins, 0.0);
  for (int i = 0; i < kBins; ++i)
    for (int j = 0; j < kBins; ++j)
      smooth[std::size_t(i)] +=
          histogram[std::size_t(j)] * std::exp(-0.5 * (i - j) * (i - j) / (sigma * sigma));
  double deepest = 0.0;
  const double floor = 0.02 * *std::max_element(smooth.begin(), smooth.end());
  for (int i = 1; i + 1 < kBins; ++i) {
    const auto middle = smooth.begin() + i;
    const double left = *std::max_element(smooth.begin(), middle);
    const double right = *std::max_element(middle + 1, smooth.end());
    const double lower = std::min(left, right);
    if (lower > floor)
      deepest = std::max(deepest, 1.0 - *middle / lower);
  }
  return deepest;
}

/// Luminance, red minus blue, and green minus magenta.
std::array<std::vector<float>, 3> opponentPlanes(const SrgbImage& image) {
  std::array<std::vector<float>, 3> planes{luminancePlane(image), {}, {}};
  for (std::size_t i = 0; i < image.pixelCount(); ++i) {
    const float* p = image.values.data() + 3 * i;
    planes[1].push_back(p[0] - p[2]);
    planes[2].push_back(p[1] - 0.5f * (p[0] + p[2]));
  }
  return planes;
}

} // namespace

TEST_CASE("every exemplar has the same bytes on every run and machine") {
  // Recorded from the generators. They change only when a material is changed on purpose.
  const std::map<std::string, std::uint64_t> expected{
      {"granite", 0x9df5416b37c7cd82u}, {"lichen_on_stone", 0xf785353a6c12a436u},
      {"moss", 0xcd673f2c5085c7aau},    {"rust", 0x7d9d1f2d7b0ec06fu},
      {"sand", 0x2c23e81269a770f9u},    {"terrazzo", 0x1deb40914e40c83fu},
  };
  for (const Material& material : kMaterials) {
    INFO(material.name);
    CHECK(fingerprint(material.generate(96)) == expected.at(material.name));
  }
}

TEST_CASE("every exemplar tiles: the step across the border is one of the steps inside",
          "[large]") {
  for (const Material& material : kMaterials) {
    const std::vector<float> plane = luminancePlane(exemplar(material));
    for (const bool columns : {true, false}) {
      double smallest = 1.0, largest = 0.0;
      for (int at = 0; at + 1 < kSide; ++at) {
        smallest = std::min(smallest, step(plane, at, columns));
        largest = std::max(largest, step(plane, at, columns));
      }
      const double border = step(plane, kSide - 1, columns);
      INFO(material.name << (columns ? ", columns" : ", rows"));
      CHECK(border >= smallest);
      CHECK(border <= largest);
    }
  }
}

TEST_CASE("the colours of an exemplar have more than one mode", "[large]") {
  for (const Material& material : kMaterials) {
    double deepest = 0.0;
    for (const std::vector<float>& plane : opponentPlanes(exemplar(material)))
      deepest = std::max(deepest, deepestValley(plane));
    INFO(material.name);
    CHECK(deepest > 0.3);
  }
}

TEST_CASE("an exemplar has little energy below four cycles a side", "[large]") {
  for (const Material& material : kMaterials) {
    const HalfSpectrum spectrum = forwardFft(luminancePlane(exemplar(material)), kSide, kSide);
    double low = 0.0, all = 0.0;
    for (int v = 0; v < kSide; ++v) {
      for (int u = 0; u < spectrum.columns(); ++u) {
        const double radius = std::hypot(double(u), double(v <= kSide / 2 ? v : v - kSide));
        if (radius == 0.0)
          continue;
        const double energy = spectrum.multiplicity(u) * double(std::norm(spectrum.at(u, v)));
        all += energy;
        low += radius < 4.0 ? energy : 0.0;
      }
    }
    INFO(material.name);
    // 0.036 for terrazzo, with its large chips; at most 0.015 for the others.
    CHECK(low / all < 0.05);
  }
}

TEST_CASE("the landscape has a million triangles that all face upwards, and rock has blended edges",
          "[large]") {
  const std::vector<std::byte> glb = exemplars::landscapeGlb();
  const auto opened = openGltf(glb);
  const auto& file = std::get<GltfContainer>(opened);
  const auto values = [&](std::size_t accessor, auto sample) {
    const auto& view =
        file.document["bufferViews"]
                     [file.document["accessors"][accessor]["bufferView"].get<std::size_t>()];
    std::vector<decltype(sample)> result(view["byteLength"].get<std::size_t>() / sizeof sample);
    std::memcpy(result.data(), file.binaryChunk->data() + view["byteOffset"].get<std::size_t>(),
                result.size() * sizeof sample);
    return result;
  };
  const auto& parts = file.document["meshes"][0]["primitives"];
  const auto positions =
      values(parts[0]["attributes"]["POSITION"].get<std::size_t>(), std::array<float, 3>());
  const auto colors =
      values(parts[0]["attributes"]["COLOR_0"].get<std::size_t>(), std::array<std::uint8_t, 4>());
  REQUIRE(parts.size() == 3);
  REQUIRE(colors.size() == positions.size());
  CHECK(file.document["materials"][2]["alphaMode"] == "BLEND");
  std::set<std::array<std::uint32_t, 3>> ground;
  std::size_t triangles = 0, downwards = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto indices =
        values(parts[k]["indices"].get<std::size_t>(), std::array<std::uint32_t, 3>());
    CHECK(indices.size() > 20'000);
    if (k == 0)
      ground.insert(indices.begin(), indices.end());
    if (k < 2)
      triangles += indices.size();
    for (const auto& triangle : indices) {
      // Layers of rock lie on ground. A vertex is rock if it would show none of the ground.
      const auto isWhole = [&](std::uint32_t vertex) { return colors[vertex][3] == 255; };
      if (k == 1)
        REQUIRE(std::all_of(triangle.begin(), triangle.end(), isWhole));
      if (k == 2)
        REQUIRE(ground.contains(triangle));
    }
    for (const auto& [a, b, c] : indices) {
      const auto &p = positions[a], &q = positions[b], &r = positions[c];
      downwards += (q[2] - p[2]) * (r[0] - p[0]) - (q[0] - p[0]) * (r[2] - p[2]) <= 0.0f;
    }
  }
  CHECK(triangles == 1'000'000);
  CHECK(downwards == 0);
}
