// SPDX-License-Identifier: MIT
// What plain.frag, bare.frag and the peers read; peer_images.cpp creates it.

layout(set = 0, binding = 0) uniform sampler2D exemplar; // 256 x 256, repeats, trilinear
layout(set = 0, binding = 1) uniform sampler2D gaussianImage; // of RGB
layout(set = 0, binding = 2) uniform sampler3D colorTable; // 32 x 32 x 32: Gaussian value -> RGB
layout(set = 0, binding = 3) uniform sampler2D decorrelatedImage; // Gaussian image of the axes below
layout(set = 0, binding = 4) uniform sampler2D axisTable; // 128 x mip levels: value -> its axis
layout(set = 0, binding = 5) uniform PeerParameters {
  vec4 colorOrigin; // RGB = colorOrigin + sum of colorAxes[k] times the k-th decorrelated value
  vec4 colorAxes[3];
  float rotationStrength; // hextile.frag: factor on the angle of a tile
  float contrast; // hextile.frag: r
} peer;

layout(location = 0) in vec2 uv;
layout(location = 0) out vec4 colour;
