// SPDX-License-Identifier: MIT
// Images and tables -> PNG -> data URIs -> markup.
#include "pictures.h"

#include "markup.h"

#include <lichen/base64.h>
#include <lichen/image_io.h>
#include <lichen/inverse_table.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace lichen {
namespace {

template <class AnyImage>
Result<Picture> encoded(const AnyImage& image, std::string title, std::string text) {
  const Result<std::vector<std::byte>> png = encodePng(image, 8);
  if (!png)
    return png.error();
  return Picture{"data:image/png;base64," + encodeBase64(png.value()),
                 {image.width, image.height},
                 std::move(title),
                 std::move(text)};
}

template <Encoding kEncoding>
Image<kEncoding> blockMeans(const Image<kEncoding>& image, int width, int height) {
  Image<kEncoding> small(width, height, image.channels);
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

/// The style for pictures that are this wide: texels that are magnified are squares.
std::string widthStyle(const ShownWidths& widths, int pixels) {
  constexpr double kPageWidth = 1100.0; // of page_style.cpp [CSS pixels], nearly
  const bool isMagnified = widths.large * kPageWidth > 1.5 * pixels;
  return fmt::format("--small:{:.4f};--large:{:.4f}{}", widths.small, widths.large,
                     isMagnified ? ";image-rendering:pixelated" : "");
}

/// One level of an inverse table, decoded. A table of one row is shown as a band.
LinearImage slicesPicture(const Table& table, std::uint32_t level, std::size_t channels,
                          ValueEncoding encoding) {
  constexpr std::size_t kWidthOverBand = 8;
  const auto side = [level](std::uint32_t size) {
    return std::size_t(std::max(1u, size >> level));
  };
  const std::size_t width = side(table.width), height = side(table.height);
  const std::size_t slices = side(table.depth);
  const auto columns = std::bit_ceil(std::size_t(std::ceil(std::sqrt(double(slices)))));
  const std::size_t shown = std::max({height, height == 1 ? width / kWidthOverBand : 1});
  std::vector<float> texels = decodeLevel(table, level);
  if (encoding == ValueEncoding::root)
    for (float& value : texels)
      value *= value;
  const auto stored = std::size_t(channelCount(table.format));
  LinearImage image(int(width * columns), int(shown * ((slices + columns - 1) / columns)),
                    int(channels));
  for (std::size_t z = 0; z < slices; ++z)
    for (std::size_t y = 0; y < shown; ++y)
      for (std::size_t x = 0; x < width; ++x)
        std::copy_n(&texels[((z * height + y * height / shown) * width + x) * stored],
                    std::min(channels, stored),
                    image.pixel(int(z % columns * width + x), int(z / columns * shown + y)));
  return image;
}

} // namespace

Result<Picture> encodedPicture(const SrgbImage& image, std::string title, std::string text) {
  return encoded(image, std::move(title), std::move(text));
}

Result<Picture> encodedPicture(const LinearImage& data, std::string title, std::string text) {
  return encoded(data, std::move(title), std::move(text));
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

std::string panesMarkup(const std::vector<Picture>& pictures, double small) {
  std::string panes;
  for (const Picture& picture : pictures)
    panes += paneMarkup(imageMarkup(picture, {.small = small}),
                        element("b", htmlText(picture.title)) + htmlText(picture.text));
  return element("div class=\"panes\"", panes);
}

Extents pictureExtents(int width, int height, int side) {
  const double shrink = std::min(1.0, side / std::sqrt(double(width) * double(height)));
  Extents extents{std::max(1, int(width * shrink)), std::max(1, int(height * shrink))};
  for (int& extent : extents) // of an image less than a pixel wide
    extent = std::min(extent, side * side);
  return extents;
}

SrgbImage reduced(const SrgbImage& image, int width, int height) {
  return blockMeans(image, width, height);
}

LinearImage reduced(const LinearImage& image, int width, int height) {
  return blockMeans(image, width, height);
}

LinearImage levelPicture(const Table& table, std::size_t channels, int side) {
  std::uint32_t level = 0;
  const auto extent = [&](std::uint32_t whole) { return std::max(1u, whole >> level); };
  while (level + 1 < table.mipLevels &&
         double(extent(table.width)) * extent(table.height) > double(side) * side)
    ++level;
  const std::vector<float> texels = decodeLevel(table, level);
  const auto stored = std::size_t(channelCount(table.format));
  LinearImage image(int(extent(table.width)), int(extent(table.height)), int(channels));
  for (std::size_t i = 0; i < image.pixelCount(); ++i)
    std::copy_n(&texels[i * stored], channels, &image.values[i * channels]);
  return image;
}

Result<std::vector<Picture>> inverseTablePictures(const Bundle& bundle, const NoiseMap& map,
                                                  const MapLook& look) {
  std::vector<Result<Picture>> levels;
  const std::optional<std::size_t> index = decodingTableOf(map);
  for (std::uint32_t level = 0; index && level < bundle.tables[*index].mipLevels; ++level) {
    const double amplitude = 1.0 - double(level) / kMostTableLevels;
    levels.push_back(encodedPicture(
        look.picture(
            slicesPicture(bundle.tables[*index], level, map.channels.size(), map.encoding)),
        fmt::format("Level {}", level),
        fmt::format(": {:.0f} % of the variance lost", 100.0 * (1.0 - amplitude * amplitude))));
  }
  return allOf(std::move(levels));
}

} // namespace lichen
