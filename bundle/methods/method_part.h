// SPDX-License-Identifier: MIT
// What a noise and a material hold for their method: structs of the method's own in own0, own1 and
// own2.
#pragma once

#include <array>
#include <cstring>
#include <lichen_interface.h>

namespace lichen {

template <class Part>
Part partOf(const shader::LichenMaterial& material) {
  const std::array words{material.own0, material.own1, material.own2};
  static_assert(sizeof(Part) <= sizeof words);
  Part part;
  std::memcpy(&part, words.data(), sizeof part);
  return part;
}

template <class Part>
void setPartOf(shader::LichenMaterial& material, const Part& part) {
  std::array<shader::uvec4, 3> words{};
  std::memcpy(words.data(), &part, sizeof part);
  material.own0 = words[0];
  material.own1 = words[1];
  material.own2 = words[2];
}

template <class Part>
Part partOf(const shader::LichenNoise& noise) {
  const std::array words{noise.own0, noise.own1};
  static_assert(sizeof(Part) <= sizeof words);
  Part part;
  std::memcpy(&part, words.data(), sizeof part);
  return part;
}

template <class Part>
void setPartOf(shader::LichenNoise& noise, const Part& part) {
  std::array<shader::uvec4, 2> words{};
  std::memcpy(words.data(), &part, sizeof part);
  noise.own0 = words[0];
  noise.own1 = words[1];
}

} // namespace lichen
