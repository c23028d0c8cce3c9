// SPDX-License-Identifier: MIT
// Local random-phase noise at four points at once, by the shaders' own code:
// shaders_glsl/noise/local_random_phase.glsl.
#define LICHEN_METHODS 4
#define LICHEN_WIDE localRandomPhaseWide
#include "evaluation/wide_evaluator.h"
