// SPDX-License-Identifier: MIT
// Painted picture -> labels, one for each colour.
#include <lichen/layers.h>
#include <lichen/spectrum.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <utility>

namespace lichen {
namespace {

using Codes = std::array<int, 3>; ///< of 8 bits: red, green, blue

/// The largest difference of two channels.
int difference(const Codes& a, const Codes& b) {
  int most = 0;
  for (std::size_t c = 0; c < a.size(); ++c)
    most = std::max(most, std::abs(a[c] - b[c]));
  return most;
}

double luminance(const Codes& color) {
  double sum = 0.0;
  for (std::size_t c = 0; c < color.size(); ++c)
    sum += double(kLuminanceWeights[c]) * color[c];
  return sum;
}

std::vector<Codes> codesOf(const SrgbImage& picture) {
  std::vector<Codes> codes(picture.pixelCount());
  const bool isGrey = picture.channels < 3;
  for (std::size_t i = 0; i < codes.size(); ++i)
    for (std::size_t c = 0; c < codes[i].size(); ++c) {
      const float value = picture.values[i * std::size_t(picture.channels) + (isGrey ? 0 : c)];
      codes[i][c] = int(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
    }
  return codes;
}

/// A colour and how many pixels have it.
struct CountedColor {
  Codes color;
  std::size_t pixels;
};

/// The colours of the pixels that `counts` takes, most frequent first.
template <class Counts>
std::vector<CountedColor> countedColors(const std::vector<Codes>& codes, const Counts& counts) {
  std::map<Codes, std::size_t> all;
  for (std::size_t i = 0; i < codes.size(); ++i)
    if (counts(i))
      ++all[codes[i]];
  std::vector<CountedColor> colors;
  for (const auto& [color, pixels] : all)
    colors.push_back({color, pixels});
  std::stable_sort(colors.begin(), colors.end(), [](const CountedColor& a, const CountedColor& b) {
    return a.pixels > b.pixels;
  });
  return colors;
}

/// Whether a pixel's neighbours have nearly its colour. At the edge of an area, smoothing and JPEG
/// mix the colours of both sides.
bool isFlat(const std::vector<Codes>& codes, int width, int height, std::size_t pixel) {
  constexpr int kNearly = 24; // the noise of a JPEG of quality 75 away from edges
  const int x = int(pixel % std::size_t(width)), y = int(pixel / std::size_t(width));
  for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
    if (x + dx >= 0 && x + dx < width && y + dy >= 0 && y + dy < height)
      if (const std::size_t other = pixel + std::size_t(dy * width + dx);
          difference(codes[pixel], codes[other]) > kNearly)
        return false;
  return true;
}

/// The most frequent colours of flat areas, each with those within a distance of it.
std::vector<CountedColor> areaColors(const std::vector<Codes>& codes, int width, int height) {
  constexpr int kSameColor = 40; // layers.h states it
  std::vector<CountedColor> areas;
  for (const CountedColor& one :
       countedColors(codes, [&](std::size_t i) { return isFlat(codes, width, height, i); })) {
    const auto nearest = std::min_element(
        areas.begin(), areas.end(), [&](const CountedColor& a, const CountedColor& b) {
          return difference(a.color, one.color) < difference(b.color, one.color);
        });
    if (nearest != areas.end() && difference(nearest->color, one.color) <= kSameColor)
      nearest->pixels += one.pixels;
    else
      areas.push_back(one);
  }
  return areas;
}

Result<LabelImage> labelsOf(const SrgbImage& picture, const std::string& name) {
  const std::vector<Codes> codes = codesOf(picture);
  std::vector<CountedColor> colors = countedColors(codes, [](std::size_t) { return true; });
  if (colors.size() > std::size_t(kMostLabels))
    colors = areaColors(codes, picture.width, picture.height);
  std::erase_if(colors, [&](const CountedColor& color) {
    return double(color.pixels) < kLeastLabelShare * double(codes.size());
  });
  if (colors.size() < std::size_t(kFewestLabels) || colors.size() > std::size_t(kMostLabels))
    return Error{ErrorKind::badInput,
                 name + ": " + std::to_string(colors.size()) +
                     (colors.size() == 1 ? " colour covers" : " colours cover") +
                     " 1 % of the pixels or more; paint 2 to 4 colours, one for each material"};
  std::sort(colors.begin(), colors.end(), [](const CountedColor& a, const CountedColor& b) {
    return std::pair(luminance(a.color), a.color) < std::pair(luminance(b.color), b.color);
  });

  LabelImage labels{picture.width, picture.height, int(colors.size()), {}};
  labels.labels.reserve(codes.size());
  std::map<Codes, std::uint8_t> nearest;
  for (const Codes& code : codes) {
    const auto [place, isNew] = nearest.try_emplace(code, std::uint8_t(0));
    if (isNew)
      for (std::size_t k = 1; k < colors.size(); ++k)
        if (difference(code, colors[k].color) < difference(code, colors[place->second].color))
          place->second = std::uint8_t(k);
    labels.labels.push_back(place->second);
  }
  return labels;
}

} // namespace

Result<LabelImage> labelsFromPicture(const SrgbImage& picture, const std::string& name) {
  return withinMemory([&] { return name + ": not enough memory to read its labels"; },
                      [&] { return labelsOf(picture, name); });
}

} // namespace lichen
