#version 450
// SPDX-License-Identifier: MIT
// One triangle that covers the whole picture, at infinity.
layout(location = 0) out vec2 clip;

void main() {
  clip = vec2(gl_VertexIndex == 1 ? 3.0 : -1.0, gl_VertexIndex == 2 ? 3.0 : -1.0);
  gl_Position = vec4(clip, 0.0, 1.0); // depth is reversed: 0 is far
}
