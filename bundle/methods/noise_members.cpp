// SPDX-License-Identifier: MIT
// Members of a noise -> whose spectrum it has, its grain, sizes.
#include "noise_members.h"

#include <cmath>
#include <string>

namespace lichen {

std::optional<bool> readGivenSpectrum(ObjectReader& reader) {
  const std::string spectrum =
      reader.has("spectrum") ? reader.text("spectrum").value_or("exemplar") : "exemplar";
  if (spectrum == "exemplar" || spectrum == "given")
    return spectrum == "given";
  reader.error("spectrum", "spectrum", quoted(spectrum) + "; expected exemplar or given");
  return std::nullopt;
}

Grain readGrain(ObjectReader& reader) {
  if (!reader.has("grain"))
    return Grain::none;
  const std::optional<std::string> name = reader.text("grain");
  const std::optional<Grain> grain = name ? grainFrom(*name) : std::nullopt;
  if (name && !grain)
    reader.error("noise-grain", "grain", quoted(*name) + "; expected x or y");
  return grain.value_or(Grain::none);
}

std::optional<std::array<int, 2>> readSize(ObjectReader& reader, const char* key, int most) {
  const auto values = reader.pair(key, {1.0, double(most)});
  if (!values)
    return std::nullopt;
  for (const double value : *values)
    if (value != std::floor(value)) {
      reader.error("type", key, nlohmann::json(value).dump() + "; expected an integer");
      return std::nullopt;
    }
  return std::array{int((*values)[0]), int((*values)[1])};
}

} // namespace lichen
