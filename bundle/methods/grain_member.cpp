// SPDX-License-Identifier: MIT
// The member `grain` -> Grain: `x`, `y` or absent.
#include "grain_member.h"

#include <optional>
#include <string>

namespace lichen {

Grain readGrain(ObjectReader& reader) {
  if (!reader.has("grain"))
    return Grain::none;
  const std::optional<std::string> name = reader.text("grain");
  const std::optional<Grain> grain = name ? grainFrom(*name) : std::nullopt;
  if (name && !grain)
    reader.error("noise-grain", "grain", quoted(*name) + "; expected x or y");
  return grain.value_or(Grain::none);
}

} // namespace lichen
