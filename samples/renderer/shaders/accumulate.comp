#version 450
// SPDX-License-Identifier: MIT
// Adds one frame to the sum of frames, tone-mapped or as linear light. [Khronos PBR Neutral Tone
// Mapper 2024, KhronosGroup/ToneMapping, PBR_Neutral/README.md]: base colours up to 0.8 are
// unchanged; brighter light is compressed and desaturates toward white. All its constants are from
// that page.
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0) uniform sampler2D frameColor;
layout(set = 0, binding = 1, rgba32f) uniform image2D sum;
layout(push_constant) uniform Block {
  float exposure; // factor of the light
  int toneMap; // 1 for display values in [0, 1], 0 for linear light
  int first;      // 1 for the first frame, which starts the sum
} settings;

const float kF90 = 0.04; // reflection of a dielectric in a white environment, subtracted first
const float kStartCompression = 0.8 - kF90;
const float kDesaturation = 0.15;
const float kMaxHalf = 65504.0;

vec3 neutral(vec3 light) {
  float least = min(light.r, min(light.g, light.b));
  // If the darkest channel is below 2 F90, the offset falls smoothly to 0 with it.
  float offset = least < 2.0 * kF90 ? least - least * least / (4.0 * kF90) : kF90;
  light -= offset;
  float peak = max(light.r, max(light.g, light.b));
  if (peak < kStartCompression)
    return light;
  const float d = 1.0 - kStartCompression;
  float newPeak = 1.0 - d * d / (peak + d - kStartCompression);
  light *= newPeak / peak;
  float g = 1.0 - 1.0 / (kDesaturation * (peak - newPeak) + 1.0);
  return mix(light, vec3(newPeak), g);
}

void main() {
  ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
  if (any(greaterThanEqual(pixel, imageSize(sum))))
    return;
  vec3 radiance = texelFetch(frameColor, pixel, 0).rgb;
  // A light reflected in a mirror may exceed the range of half floats.
  vec3 light = min(radiance, vec3(kMaxHalf)) * settings.exposure;
  vec4 value = vec4(settings.toneMap == 1 ? neutral(light) : light, 1.0);
  // min and max of NaN are undefined. Keep NaN, so that shading faults are visible in the picture.
  if (any(isnan(radiance)))
    value.rgb = radiance;
  if (settings.first == 0)
    value += imageLoad(sum, pixel);
  imageStore(sum, pixel, value);
}
