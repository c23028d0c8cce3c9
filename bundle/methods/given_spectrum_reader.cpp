// SPDX-License-Identifier: MIT
// "exemplar" or "given" -> a flag.
#include "given_spectrum_reader.h"

namespace lichen {

std::optional<bool> readGivenSpectrum(ObjectReader& reader) {
  const std::string spectrum =
      reader.has("spectrum") ? reader.text("spectrum").value_or("exemplar") : "exemplar";
  if (spectrum == "exemplar" || spectrum == "given")
    return spectrum == "given";
  reader.error("spectrum", "spectrum", quoted(spectrum) + "; expected exemplar or given");
  return std::nullopt;
}

} // namespace lichen
