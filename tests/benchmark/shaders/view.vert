#version 450
// SPDX-License-Identifier: MIT
// A rectangle that covers the screen: parallel to it, or a floor that recedes towards the top.
// gl_VertexIndex (0 to 3, a strip) -> texture coordinates.

layout(push_constant) uniform View {
  vec2 uvPerScreen; // at the near edge
  float farDistance; // of the top edge, in units of the near edge's; 1 for a parallel view
} view;

layout(location = 0) out vec2 uv;

void main() {
  vec2 corner = vec2(gl_VertexIndex & 1, gl_VertexIndex >> 1); // y = 1: the near edge, below
  float w = mix(view.farDistance, 1.0, corner.y);
  uv = vec2((corner.x - 0.5) * w, w) * view.uvPerScreen;
  if (view.farDistance == 1.0)
    uv = corner * view.uvPerScreen;
  gl_Position = vec4((2.0 * corner - 1.0) * w, 0.0, w);
}
