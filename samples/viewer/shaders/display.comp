#version 450
// SPDX-License-Identifier: MIT
// Averages the sum of frames and encodes it as sRGB [IEC 61966-2-1].
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, rgba32f) uniform readonly image2D sum;
layout(set = 0, binding = 1, rgba8) uniform writeonly image2D shown;
layout(push_constant) uniform Block {
  float frames;
} settings;

vec3 srgbCode(vec3 linear) {
  vec3 curve = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
  return mix(curve, 12.92 * linear, lessThanEqual(linear, vec3(0.0031308)));
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(shown))))
    return;
  vec3 average = imageLoad(sum, pixel).rgb / settings.frames;
  imageStore(shown, pixel, vec4(srgbCode(clamp(average, 0.0, 1.0)), 1.0));
}
