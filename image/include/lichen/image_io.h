// SPDX-License-Identifier: MIT
// Reads and writes PNG and EXR, and reads JPEG. Input may be hostile.
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

/// Maximum width and height of an image, in pixels.
inline constexpr int kMaxImageSide = 16384;

/// A decoded file: an SrgbImage from PNG and JPEG, a LinearImage from EXR.
struct ImageFile {
  std::variant<SrgbImage, LinearImage> pixels;
  int bitsPerChannel = 8; ///< of the file: 8, 16, or 32 for EXR (half or float)
  /// EXIF orientation, 1 (upright) to 8: how to rotate or mirror the stored pixels to make them
  /// upright.
  int orientation = 1;
  /// Conversions applied while reading (palette expanded, CMYK converted, negative values clamped,
  /// missing channels filled), one short sentence each, for the user.
  std::vector<std::string> notes;
  /// The orientation before upright(). upright() moves pixels only; for values that are directions,
  /// such as normals, use uprightDirection().
  int turnedFrom = 1;
};

/// Called once with the size that an image's header claims, before memory is taken for its pixels;
/// an error refuses the image. Empty: every size is valid.
using SizeCheck = std::function<Result<void>(int width, int height)>;

/// Decodes a PNG (1 to 16 bit; grey, palette, RGB, alpha), a JPEG (grey, YCbCr, CMYK, YCCK) or a
/// single-part EXR (scan line or tiled; half, float or uint; R G B A, Y A or one other channel).
/// Detects the format from the first bytes, not from the file name. Expands palettes and low bit
/// depths. Ignores colour profiles and gamma, and any bytes after the image's end.
/// Returns pixels as stored, whatever the orientation: a scene's texture coordinates refer to
/// stored pixels.
/// Errors: badInput for a file that is not an image, is truncated (including a PNG without IEND and
/// a JPEG without end marker), has zero size or a side over kMaxImageSide, claims more pixels than
/// its bytes can encode, contains NaN or infinity, or is a multi-part, deep or luminance-chroma EXR
/// or an arithmetic-coded JPEG; resources if memory does not suffice.
/// Messages start with `name`. Thread-safe.
[[nodiscard]] Result<ImageFile> decodeImage(std::span<const std::byte> file,
                                            const std::string& name, const SizeCheck& check = {});

/// Rotates or mirrors the image according to its orientation, adds a note, and sets the orientation
/// to 1. May throw std::bad_alloc.
[[nodiscard]] ImageFile upright(ImageFile file);

/// Converts a direction (right, down) from stored pixels with `orientation`, 1 to 8, to upright
/// pixels.
[[nodiscard]] std::array<float, 2> uprightDirection(std::array<float, 2> stored, int orientation);

/// Reads and decodes a file, and makes it upright, the way photographs are displayed.
[[nodiscard]] Result<ImageFile> readImage(const std::filesystem::path& path,
                                          const SizeCheck& check = {});

/// Encodes a PNG without colour chunks, with 1 to 4 channels and 8 or 16 bits per channel. Clamps
/// values to [0, 1] and rounds to the nearest code. The result is deterministic. Errors: usage for
/// other bit depths, sizes or channel counts; badInput for a value that is not finite.
[[nodiscard]] Result<std::vector<std::byte>> encodePng(const SrgbImage& image, int bitsPerChannel);
[[nodiscard]] Result<std::vector<std::byte>> encodePng(const LinearImage& data, int bitsPerChannel);

/// Encodes a scan-line EXR of half floats, ZIP-compressed, with channels Y, Y A, R G B or R G B A.
/// Clamps values to the range of half floats, +-65504. The result is deterministic. Errors: usage
/// for other sizes or channel counts; badInput for a value that is not finite.
[[nodiscard]] Result<std::vector<std::byte>> encodeExr(const LinearImage& image);

/// Writes an image atomically, with replaceFile(). The extension selects the format: .png (8 bit;
/// converts linear colour to sRGB) or .exr (converts sRGB to linear). Errors: usage for another
/// extension, environment for a folder that is not writable, resources for a full disk; on any
/// error the old file is unchanged.
[[nodiscard]] Result<void> writeImage(const std::filesystem::path& path, const SrgbImage& image);
[[nodiscard]] Result<void> writeImage(const std::filesystem::path& path, const LinearImage& image);

} // namespace lichen
