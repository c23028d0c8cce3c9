// SPDX-License-Identifier: MIT
// The texton options that `bake` and `mix` share.
#pragma once

#include <lichen/bundle.h>
#include <lichen/texton.h>

namespace CLI {
class App;
} // namespace CLI

namespace lichen::cli {

/// Declares them; not --impacts and --precision.
void addTextonOptions(CLI::App& verb, TextonOptions& texton, MaterialNoise& material);

} // namespace lichen::cli
