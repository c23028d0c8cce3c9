// SPDX-License-Identifier: MIT
// Colours and opacity -> colours, through a pyramid that halves both sides down to one pixel.
#include "invisible_color.h"

#include "resample.h"
#include "value_encoding.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lichen::exemplar {
namespace {

struct Level {
  int width = 0;
  int height = 0;
  std::vector<float> light;    ///< 3 per pixel, of the covered part
  std::vector<float> coverage; ///< 1 per pixel, [0, 1]: weight of the light

  /// Wraps at the borders: an exemplar that tiles must still do so afterwards, and one that does
  /// not gets plausible colours too.
  [[nodiscard]] std::size_t at(int x, int y) const {
    return std::size_t((y + height) % height) * std::size_t(width) +
           std::size_t((x + width) % width);
  }
};

/// Pull: averages light weighted by coverage, and adds coverage up to at most 1.
Level halved(const Level& fine) {
  Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}, {}};
  for (int y = 0; y < coarse.height; ++y)
    for (int x = 0; x < coarse.width; ++x) {
      float sum = 0.0f;
      std::array<float, 3> light{};
      for (int k = 0; k < 4; ++k) {
        const int fx = 2 * x + k % 2, fy = 2 * y + k / 2;
        if (fx >= fine.width || fy >= fine.height)
          continue;
        const std::size_t i = fine.at(fx, fy);
        sum += fine.coverage[i];
        for (std::size_t c = 0; c < 3; ++c)
          light[c] += fine.coverage[i] * fine.light[3 * i + c];
      }
      coarse.coverage.push_back(std::min(1.0f, sum));
      for (const float value : light)
        coarse.light.push_back(sum > 0.0f ? value / sum : 0.0f);
    }
  return coarse;
}

/// Push: interpolates the uncovered share of a pixel bilinearly from the coarser level.
void fillFrom(const Level& coarse, Level& fine) {
  for (int y = 0; y < fine.height; ++y)
    for (int x = 0; x < fine.width; ++x) {
      const std::size_t i = fine.at(x, y);
      const float own = fine.coverage[i];
      if (own >= 1.0f)
        continue;
      // The centre of a fine pixel is a quarter of a coarse pixel from the nearest coarse centre.
      const int nearX = x / 2, nearY = y / 2;
      const int farX = nearX + (x % 2 == 0 ? -1 : 1), farY = nearY + (y % 2 == 0 ? -1 : 1);
      for (std::size_t c = 0; c < 3; ++c) {
        const auto light = [&](int column, int row) {
          return coarse.light[3 * coarse.at(column, row) + c];
        };
        const float around = 0.75f * (0.75f * light(nearX, nearY) + 0.25f * light(farX, nearY)) +
                             0.25f * (0.75f * light(nearX, farY) + 0.25f * light(farX, farY));
        float& value = fine.light[3 * i + c];
        value = own * value + (1.0f - own) * around;
      }
    }
}

} // namespace

void fillInvisible(MapExemplar& color, const MapExemplar& opacity) {
  Level whole{color.width, color.height, color.values,
              resampled(opacity, color.width, color.height, false).values};
  const float most = *std::max_element(whole.coverage.begin(), whole.coverage.end());
  if (most <= 0.0f)
    return; // nothing is visible, so no colour is better than another
  for (float& value : whole.coverage)
    value /= most;
  for (float& value : whole.light)
    value = decoded(value, color.encoding);
  std::vector<Level> pyramid{std::move(whole)};
  while (pyramid.back().width > 1 || pyramid.back().height > 1)
    pyramid.push_back(halved(pyramid.back()));
  for (std::size_t l = pyramid.size() - 1; l-- > 0;)
    fillFrom(pyramid[l + 1], pyramid[l]);
  for (std::size_t i = 0; i < color.values.size(); ++i)
    if (pyramid[0].coverage[i / 3] < 1.0f) // the others do not change
      color.values[i] = encoded(pyramid[0].light[i], color.encoding);
}

} // namespace lichen::exemplar
