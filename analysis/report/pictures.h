// SPDX-License-Identifier: MIT
// Pictures of the report page, each shown at two sizes.
#pragma once

#include <lichen/image.h>
#include <lichen/map_picture.h>
#include <lichen/result.h>

#include <array>
#include <string>
#include <vector>

namespace lichen {

using Extents = std::array<int, 2>; ///< width and height

/// A picture and the words below it.
struct Picture {
  std::string uri; ///< an 8-bit PNG as a data URI [RFC 2397]
  Extents extents{};
  std::string title;
  std::string text; ///< what follows the title, with its punctuation
};

/// Errors as encodePng().
[[nodiscard]] Result<Picture> encodedPicture(const SrgbImage& image, std::string title,
                                             std::string text = {});

/// The pictures, or the first error.
[[nodiscard]] Result<std::vector<Picture>> allOf(std::vector<Result<Picture>> made);

/// The widths of a picture as shares of the page's: at first, and after a click.
struct ShownWidths {
  double small = 0.0;
  double large = 1.0;
};

[[nodiscard]] std::string imageMarkup(const Picture& picture, const ShownWidths& widths);
/// An area of this size, filled with the picture again and again.
[[nodiscard]] std::string repeatedMarkup(const Picture& picture, const Extents& area,
                                         const ShownWidths& widths);
/// Images with a caption below. A click on them changes their size.
[[nodiscard]] std::string paneMarkup(std::string_view images, std::string_view caption);

/// The size of the picture of width x height pixels: their proportions, and at most side^2 pixels.
[[nodiscard]] Extents pictureExtents(int width, int height, int side);

/// The image with at most its own width and height; each pixel is the mean of the block of pixels
/// under it.
[[nodiscard]] SrgbImage reduced(const SrgbImage& image, int width, int height);

} // namespace lichen
