// SPDX-License-Identifier: MIT
#include "materials.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <map>
#include <string>

using namespace lichen;
using exemplars::kMaterials;
using exemplars::Material;

namespace {

/// 64-bit FNV-1a of the image's 8-bit values.
std::uint64_t fingerprint(const SrgbImage& image) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const float value : image.values)
    hash = (hash ^ std::uint64_t(std::lround(value * 255.0f))) * 0x100000001b3u;
  return hash;
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
