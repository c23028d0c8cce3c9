// SPDX-License-Identifier: MIT
#include "gltf_mutation.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

namespace lichen::fuzz {
namespace {

constexpr std::array<std::uint32_t, 10> kEdges = {
    0, 1, 3, 0xff, 0xffff, 0x4000, 0x7fffffff, 0x80000000, 0xfffffffc, 0xffffffff};

/// Plausible values, valid or not, of members of glTF or of the extension.
const nlohmann::json& replacement(Random& random) {
  static const std::array<nlohmann::json, 27> values = {nullptr,
                                                        true,
                                                        0,
                                                        1,
                                                        2,
                                                        3,
                                                        4,
                                                        -1,
                                                        0.5,
                                                        -0.25,
                                                        1e300,
                                                        3e38,
                                                        5121,
                                                        5125,
                                                        5126,
                                                        4294967296u,
                                                        18446744073709551615u,
                                                        "",
                                                        "uv",
                                                        "surface",
                                                        "texton",
                                                        "SCALAR",
                                                        "VEC3",
                                                        "MAT4",
                                                        nlohmann::json::array(),
                                                        nlohmann::json::object(),
                                                        std::string(100, 'x')};
  return values[below(random, values.size())];
}

/// Descends to a random value of the document.
nlohmann::json& anyValue(nlohmann::json& root, Random& random) {
  constexpr std::size_t kStopsOneIn = 8;
  nlohmann::json* value = &root;
  while (value->is_structured() && !value->empty() && below(random, kStopsOneIn) != 0) {
    auto child = value->begin();
    std::advance(child, std::ptrdiff_t(below(random, value->size())));
    value = &*child;
  }
  return *value;
}

} // namespace

std::size_t below(Random& random, std::size_t limit) { return std::size_t(random() % limit); }

void mutateBytes(Bytes& file, Random& random) {
  if (file.size() < 8)
    return;
  const std::size_t at = below(random, file.size() - 4);
  const auto position = file.begin() + std::ptrdiff_t(at);
  switch (random() % 4) {
  case 0:
    *position ^= std::byte(1u << (random() % 8));
    break;
  case 1:
    std::memcpy(&*position, &kEdges[below(random, kEdges.size())], 4);
    break;
  case 2:
    file.resize(at);
    break;
  default:
    file.erase(position, position + std::ptrdiff_t(below(random, 4)));
    break;
  }
}

void mutateJson(nlohmann::json& root, Random& random) {
  nlohmann::json& value = anyValue(root, random);
  switch (random() % 5) {
  case 0:
    if (value.is_array() && !value.empty())
      value.push_back(nlohmann::json(value.front()));
    break;
  case 1:
    if (value.is_structured() && !value.empty())
      value.erase(std::next(value.begin(), std::ptrdiff_t(below(random, value.size()))));
    break;
  case 2:
    value = nlohmann::json(anyValue(root, random));
    break;
  default:
    value = replacement(random);
    break;
  }
}

} // namespace lichen::fuzz
