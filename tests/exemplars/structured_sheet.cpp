// SPDX-License-Identifier: MIT
// Points of a sheet -> noise, cells and wood; see structured_sheet.h.
#include "structured_sheet.h"

#include "space_noise.h"

#include <lichen/lattice.h>

#include <algorithm>
#include <cmath>

namespace lichen::exemplars {

float Sheet::noise(Point p, Point period, std::uint32_t channel) const {
  if (extent.x == 0.0f)
    return planeNoise({p.x / period.x, p.y / period.y}, {0, 0}, seed + channel * 7919u);
  const int columns = std::max(1, int(extent.x / period.x + 0.5f));
  const int rows = std::max(1, int(extent.y / period.y + 0.5f));
  return planeNoise({p.x * float(columns) / extent.x, p.y * float(rows) / extent.y},
                    {columns, rows}, seed + channel * 7919u);
}

float Sheet::fractal(Point p, Point period, int octaves, std::uint32_t channel) const {
  constexpr float kGain = 0.6f;
  float sum = 0.0f, amplitude = 1.0f;
  for (int octave = 0; octave < octaves; ++octave) {
    sum += amplitude * noise(p, period, channel + 101u * std::uint32_t(octave));
    amplitude *= kGain;
    period = {0.5f * period.x, 0.5f * period.y};
  }
  return sum;
}

float Sheet::hashed(int column, int row, std::uint32_t channel) const {
  return float(channelOf(column, row, channel) >> 8u) * 0x1p-24f;
}

std::uint32_t Sheet::channelOf(int column, int row, std::uint32_t channel) const {
  return pcg3d({std::uint32_t(column), std::uint32_t(row), seed + channel})[0];
}

int Sheet::wrapped(int index, float pitch, Axis axis) const {
  const float length = axis == Axis::x ? extent.x : extent.y;
  if (length == 0.0f)
    return index;
  const int count = int(length / pitch + 0.5f);
  return (index % count + count) % count;
}

Point Sheet::uneven(Point p, Point pitch) const {
  const Point period{2.5f * pitch.x, 2.5f * pitch.y};
  return {p.x + irregularity * pitch.x * noise(p, period, 11),
          p.y + irregularity * pitch.y * noise(p, period, 12)};
}

Slot Sheet::slot(float x, float pitch, float start, Axis axis, int row) const {
  const auto borderOf = [&](int i) {
    const float off = hashed(wrapped(i, pitch, axis), row, axis == Axis::x ? 13 : 14) - 0.5f;
    return pitch * (float(i) + start + 2.0f * irregularity * off);
  };
  int i = int(std::floor(x / pitch - start));
  if (x < borderOf(i))
    --i;
  else if (x >= borderOf(i + 1))
    ++i;
  return {wrapped(i, pitch, axis), x - borderOf(i), borderOf(i + 1) - x};
}

float insideBox(const Slot& x, const Slot& y, float radius) {
  const float dx = std::min(x.before, x.after), dy = std::min(y.before, y.after);
  if (dx >= radius || dy >= radius)
    return std::min(dx, dy);
  const float cx = radius - dx, cy = radius - dy;
  return radius - std::sqrt(cx * cx + cy * cy);
}

float wave(float turns) {
  const float t = 2.0f * (turns - std::floor(turns)) - 1.0f; // [-1, 1]
  return -4.0f * t * (1.0f - std::abs(t));
}

Surface wood(Point p, const Sheet& sheet, Axis along, std::uint32_t channel, const Color& dark,
             const Color& light) {
  const auto stretched = [along](float length, float width) {
    return along == Axis::x ? Point{length, width} : Point{width, length};
  };
  // Year rings, cut at a slant: wide in the middle of some boards, fine in others.
  const float across = along == Axis::x ? p.y : p.x;
  const float extent = along == Axis::x ? sheet.extent.y : sheet.extent.x;
  float density = 0.06f + 0.16f * sheet.hashed(int(channel >> 16), 1, 21);
  if (extent > 0.0f) // a whole number of rings, so that they meet where the sheet repeats
    density = std::floor(density * extent + 0.5f) / extent;
  const float bend = sheet.fractal(p, stretched(190.0f, 26.0f), 2, channel);
  const float rings = across * density + 1.6f * bend;
  const float late = rings - std::floor(rings); // pale in spring, then dark at once
  const float ring = late * late * (1.0f - smoothStep(0.88f, 1.0f, late));
  const float fibre = sheet.fractal(p, stretched(60.0f, 2.4f), 2, channel + 1);
  const float pore = smoothStep(0.45f, 0.8f, sheet.noise(p, stretched(18.0f, 1.3f), channel + 5));
  const float cloud = sheet.noise(p, stretched(120.0f, 40.0f), channel + 3);
  const float t = 0.62f - 0.55f * ring + 0.16f * fibre + 0.12f * cloud;
  Surface surface;
  surface.color = scaled(mix(dark, light, t), 1.0f - 0.22f * pore);
  surface.height = 0.12f * fibre - 0.3f * pore - 0.1f * ring;
  surface.gloss = 0.12f;
  return surface;
}

} // namespace lichen::exemplars
