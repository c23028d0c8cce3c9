// SPDX-License-Identifier: MIT
// Images -> PNG -> data URIs -> markup.
#include "pictures.h"

#include "markup.h"

#include <lichen/base64.h>
#include <lichen/image_io.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace lichen {
namespace {

/// The style for pictures that are this wide: texels that are magnified are squares.
std::string widthStyle(const ShownWidths& widths, int pixels) {
  constexpr double kPageWidth = 1100.0; // of page_style.cpp [CSS pixels], nearly
  const bool isMagnified = widths.large * kPageWidth > 1.5 * pixels;
  return fmt::format("--small:{:.4f};--large:{:.4f}{}", widths.small, widths.large,
                     isMagnified ? ";image-rendering:pixelated" : "");
}

} // namespace

Result<Picture> encodedPicture(const SrgbImage& image, std::string title, std::string text) {
  const Result<std::vector<std::byte>> png = encodePng(image, 8);
  if (!png)
    return png.error();
  return Picture{"data:image/png;base64," + encodeBase64(png.value()),
                 {image.width, image.height},
                 std::move(title),
                 std::move(text)};
}

Result<std::vector<Picture>> allOf(std::vector<Result<Picture>> made) {
  std::vector<Picture> pictures;
  for (Result<Picture>& picture : made) {
    if (!picture)
      return picture.error();
    pictures.push_back(std::move(picture).value());
  }
  return pictures;
}

std::string imageMarkup(const Picture& picture, const ShownWidths& widths) {
  return fmt::format(R"(<img alt="{}" src="{}" width="{}" height="{}" style="{}"/>)",
                     htmlText(picture.title), picture.uri, picture.extents[0], picture.extents[1],
                     widthStyle(widths, picture.extents[0]));
}

std::string repeatedMarkup(const Picture& picture, const Extents& area, const ShownWidths& widths) {
  const auto [width, height] = area;
  return fmt::format(
      R"(<span class="repeated" role="img" aria-label="Repeated" style="{};aspect-ratio:{}/{};)"
      R"(background:url({}) 0 0 / {:.4f}% {:.4f}%"></span>)",
      widthStyle(widths, width), width, height, picture.uri, 100.0 * picture.extents[0] / width,
      100.0 * picture.extents[1] / height);
}

std::string paneMarkup(std::string_view images, std::string_view caption) {
  return element("details", element("summary", std::string(images) +
                                                   element("span class=\"caption\"", caption))) +
         "\n";
}

Extents pictureExtents(int width, int height, int side) {
  const double shrink = std::min(1.0, side / std::sqrt(double(width) * double(height)));
  Extents extents{std::max(1, int(width * shrink)), std::max(1, int(height * shrink))};
  for (int& extent : extents) // of an image less than a pixel wide
    extent = std::min(extent, side * side);
  return extents;
}

SrgbImage reduced(const SrgbImage& image, int width, int height) {
  SrgbImage small(width, height, image.channels);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int left = x * image.width / width, right = (x + 1) * image.width / width;
      const int top = y * image.height / height, bottom = (y + 1) * image.height / height;
      for (int c = 0; c < image.channels; ++c) {
        double sum = 0.0;
        for (int v = top; v < bottom; ++v)
          for (int u = left; u < right; ++u)
            sum += double(image.pixel(u, v)[c]);
        small.pixel(x, y)[c] = float(sum / (double(right - left) * double(bottom - top)));
      }
    }
  return small;
}

} // namespace lichen
