// SPDX-License-Identifier: MIT
// Ranges of TextonOptions; see option_ranges.h.
#include "option_ranges.h"

#include <string>

namespace lichen::texton {

Result<void> checkTextonOptions(const TextonOptions& options) {
  const auto usage = [](const std::string& what) { return Error{ErrorKind::usage, what}; };
  if (options.support < int(kTextonSupportRange.least) ||
      options.support > int(kTextonSupportRange.most))
    return usage("support " + std::to_string(options.support) + "; expected 4 to " +
                 std::to_string(kMaxTextonSide));
  if (options.order != 0 && options.order != 1 && options.order != 3)
    return usage("order " + std::to_string(options.order) + "; expected 0, 1 or 3");
  if (options.bits != 8 && options.bits != 16)
    return usage(std::to_string(options.bits) + " bits; expected 8 or 16");
  return {};
}

} // namespace lichen::texton
