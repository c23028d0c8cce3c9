// SPDX-License-Identifier: MIT
// How the format reads and checks a method's data. Each method has a MethodReader in its folder;
// methods.cpp lists them.
#pragma once

#include "extension_reader.h"

#include <span>
#include <string_view>

namespace lichen {

struct MethodReader {
  std::string_view name; ///< in the JSON
  int revision = 1;      ///< that this version reads, writes and evaluates
  /// The members of a map's JSON object that are table indices.
  std::span<const std::string_view> tableMembers;
  /// Reads and checks the members of a noise that its maps share.
  MethodNoise (*readNoise)(ObjectReader& reader, FindingList& findings);
  /// Reads and checks the method's members of one map. `noise` is read up to its maps and `map` up
  /// to its moments; faulty members may be missing from both. A table that could not be read is
  /// empty.
  MethodMap (*readMap)(ObjectReader& reader, const Noise& noise, const NoiseMap& map,
                       const Tables& tables, FindingList& findings);
};

[[nodiscard]] const MethodReader& readerOf(Method method);

} // namespace lichen
