// SPDX-License-Identifier: MIT
// Tiling and blending at four points at once, by the shaders' own code:
// shaders_glsl/noise/tiling.glsl.
#define LICHEN_METHODS 1
#define LICHEN_WIDE tilingWide
#include "evaluation/wide_evaluator.h"
