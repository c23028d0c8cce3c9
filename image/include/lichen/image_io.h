// SPDX-License-Identifier: MIT
// PNG, JPEG and EXR files in and out. Hostile input is expected.
#pragma once

#include <lichen/image.h>
#include <lichen/result.h>

#include <array>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace lichen {

/// Largest accepted side of an image, in pixels.
inline constexpr int kMaxImageSide = 16384;

/// A decoded file. PNG and JPEG give an SrgbImage, EXR a LinearImage.
struct ImageFile {
  std::variant<SrgbImage, LinearImage> pixels;
  int bitsPerChannel = 8; ///< of the file: 8, 16, or 32 for EXR (half or float)
  /// How the pixels have to be turned to be upright: EXIF's number, 1 (not at all) to 8.
  int orientation = 1;
  /// What was done to make the file usable (palette expanded, CMYK converted, negative values
  /// clamped, missing channels filled), one short sentence each, for the user.
  std::vector<std::string> notes;
  /// The orientation from which upright() turned the pixels. It leaves what they say of directions,
  /// as normals do, to uprightDirection().
  int turnedFrom = 1;
};

/// Called once with the size that an image's header tells, before memory is taken for its pixels;
/// an error refuses the image. Empty: each is accepted.
using SizeCheck = std::function<Result<void>(int width, int height)>;

/// Reads a PNG (1 to 16 bit, grey, palette, RGB, alpha), a JPEG (grey, YCbCr, CMYK, YCCK) or a
/// single-part EXR (scan line or tiled, half, float or uint, R G B A, Y A or one other channel).
/// The format is told from the first bytes, not from the name. Palette and low-bit-depth PNG are
/// expanded. Colour profiles and gamma are not looked at. The pixels are as they are stored,
/// whatever the orientation says: to those do a scene's texture coordinates refer. Refused with
/// ErrorKind::badInput: not an image, truncated (a PNG without IEND and a JPEG without its end
/// marker too), zero-sized, a side over kMaxImageSide, a file whose claim cannot fit its size, NaN
/// or infinite values, multi-part, deep or luminance-chroma EXR, arithmetic-coded JPEG.
/// ErrorKind::resources when memory does not suffice. Bytes after the image's end are ignored.
/// `name` is used in messages. Thread-safe.
[[nodiscard]] Result<ImageFile> decodeImage(std::span<const std::byte> file,
                                            const std::string& name, const SizeCheck& check = {});

/// The image turned as its orientation says, which is 1 then, with a note. May throw
/// std::bad_alloc.
[[nodiscard]] ImageFile upright(ImageFile file);

/// A direction, right and down, of pixels that are stored with `orientation`, 1 to 8: as it points
/// once they are upright.
[[nodiscard]] std::array<float, 2> uprightDirection(std::array<float, 2> stored, int orientation);

/// As decodeImage(), and upright: what photographs show.
[[nodiscard]] Result<ImageFile> readImage(const std::filesystem::path& path,
                                          const SizeCheck& check = {});

/// PNG without colour chunks, 1 to 4 channels, `bitsPerChannel` 8 or 16, values clamped to [0, 1]
/// and rounded to the nearest code. The same image gives the same bytes.
/// Errors: usage for other bits, sides or channels; badInput for a value that is not finite.
[[nodiscard]] Result<std::vector<std::byte>> encodePng(const SrgbImage& image, int bitsPerChannel);
[[nodiscard]] Result<std::vector<std::byte>> encodePng(const LinearImage& data, int bitsPerChannel);

/// Scan-line EXR of half floats, ZIP compressed, with channels Y, Y A, R G B or R G B A. Values
/// beyond half's largest, 65504, become it. The same image gives the same bytes.
/// Errors: usage for other sides or channels; badInput for a value that is not finite.
[[nodiscard]] Result<std::vector<std::byte>> encodeExr(const LinearImage& image);

/// Writes the file beside its target and renames it when complete. By extension: .png (8 bit,
/// colour converted to sRGB when the image is linear) or .exr (colour converted to linear).
/// Errors: usage for another extension, environment for a folder that cannot be written,
/// resources for a full disk; the old file stays whole in each case.
[[nodiscard]] Result<void> writeImage(const std::filesystem::path& path, const SrgbImage& image);
[[nodiscard]] Result<void> writeImage(const std::filesystem::path& path, const LinearImage& image);

} // namespace lichen
