// SPDX-License-Identifier: MIT
#include "checkout_paths.h"

namespace lichen {

std::string sourcePath(std::string_view relative) {
  return LICHEN_SOURCE_DIR "/" + std::string(relative);
}

std::string programPath(std::string_view name) { return LICHEN_PROGRAM_DIR "/" + std::string(name); }

} // namespace lichen
