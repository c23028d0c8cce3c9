#version 450
#extension GL_GOOGLE_include_directive : require
// SPDX-License-Identifier: MIT
// Evaluates one map of a quilting noise at a list of texture coordinates; see evaluate.glsl.
#define LICHEN_METHODS 16
#include "evaluate_uv.glsl"
