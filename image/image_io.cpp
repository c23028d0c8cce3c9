// SPDX-License-Identifier: MIT
// Detects the format of a file from its first bytes, and of a path from its extension.
#include "claims.h"
#include "codecs.h"

#include <lichen/files.h>
#include <lichen/image_io.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <new>

namespace lichen {
namespace {

constexpr std::array<unsigned char, 8> kPngSignature = {0x89, 'P',  'N',  'G',
                                                        '\r', '\n', 0x1a, '\n'};
constexpr std::array<unsigned char, 3> kJpegSignature = {0xff, 0xd8, 0xff};
constexpr std::array<unsigned char, 4> kExrSignature = {0x76, 0x2f, 0x31, 0x01};

template <std::size_t kSize>
bool startsWith(std::span<const std::byte> file,
                const std::array<unsigned char, kSize>& signature) {
  return file.size() >= kSize &&
         std::equal(signature.begin(), signature.end(), file.begin(),
                    [](unsigned char a, std::byte b) { return std::byte(a) == b; });
}

/// A format identified by `bytes` at byte offset `at`.
struct OtherFormat {
  std::size_t at;
  std::string_view bytes;
  const char* name; ///< with article
};

// Signatures from the formats' IANA registrations. HEIF containers name their content in bytes 4 to
// 11.
constexpr OtherFormat kOtherFormats[] = {
    {8, "WEBP", "a WebP"},
    {0, "GIF8", "a GIF"},
    {0, std::string_view("II*\0", 4), "a TIFF"},
    {0, std::string_view("MM\0*", 4), "a TIFF"},
    {0, "8BPS", "a Photoshop"},
    {4, "ftypavif", "an AVIF"},
    {4, "ftypavis", "an AVIF"},
    {4, "ftyphei", "a HEIC"},
    {4, "ftyphev", "a HEIC"},
    {4, "ftypmif1", "a HEIF"},
    {4, "ftypmsf1", "a HEIF"},
    {0, "\xff\x0a", "a JPEG XL"},
    {4, "JXL \r\n\x87\n", "a JPEG XL"},
    {4, "jP  \r\n\x87\n", "a JPEG 2000"},
    {0, "glTF", "a binary glTF"},
    {0, "#?RADIANCE", "a Radiance HDR"},
    {0, "DDS ", "a DDS"},
    {1, "KTX ", "a KTX"},
};

bool hasSignature(std::span<const std::byte> file, const OtherFormat& format) {
  return file.size() >= format.at + format.bytes.size() &&
         std::equal(format.bytes.begin(), format.bytes.end(),
                    file.begin() + std::ptrdiff_t(format.at),
                    [](char a, std::byte b) { return std::byte(a) == b; });
}

/// The error for a file that is not a PNG, JPEG or EXR; names its format or its first bytes.
Error notAnImage(std::span<const std::byte> file, const std::string& name) {
  if (file.empty())
    return badInput(name, "empty file; expected a PNG, JPEG or EXR image");
  for (const OtherFormat& format : kOtherFormats)
    if (hasSignature(file, format))
      return badInput(name, "is " + std::string(format.name) + " file; expected PNG, JPEG or EXR");
  constexpr const char* kDigits = "0123456789abcdef";
  std::string start;
  for (const std::byte b : file.first(std::min<std::size_t>(file.size(), 4))) {
    start += ' ';
    start += kDigits[std::to_integer<unsigned>(b) >> 4];
    start += kDigits[std::to_integer<unsigned>(b) & 0xf];
  }
  return badInput(name, "is not a PNG, JPEG or EXR image (starts with" + start + ")");
}

std::string lowerCaseExtension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

/// Encodes by extension: PNG stores sRGB codes, EXR linear light.
template <class AnyImage>
Result<void> write(const std::filesystem::path& path, const AnyImage& image) {
  try {
    const std::string extension = lowerCaseExtension(path);
    if (extension != ".png" && extension != ".exr")
      return Error{ErrorKind::usage, path.string() +
                                         (extension.empty() ? ": missing extension"
                                                            : ": unknown extension " + extension) +
                                         "; use .png or .exr"};
    const auto encoded = [&]() -> Result<std::vector<std::byte>> {
      constexpr int kBits = 8;
      if constexpr (AnyImage::encoding == Encoding::srgb)
        return extension == ".png" ? encodePng(image, kBits) : encodeExr(toLinear(image));
      else
        return extension == ".png" ? encodePng(toSrgb(image), kBits) : encodeExr(image);
    }();
    if (!encoded)
      return Error{encoded.error().kind, path.string() + ": " + encoded.error().message};
    return replaceFile(path, encoded.value());
  } catch (const std::bad_alloc&) {
    return memoryError([&] { return path.string() + ": not enough memory to convert the image"; });
  }
}

} // namespace

Result<ImageFile> decodeImage(std::span<const std::byte> file, const std::string& name,
                              const SizeCheck& check) {
  try {
    if (startsWith(file, kPngSignature))
      return decodePng(file, name, check);
    if (startsWith(file, kJpegSignature))
      return decodeJpeg(file, name, check);
    if (startsWith(file, kExrSignature))
      return decodeExr(file, name, check);
    return notAnImage(file, name);
  } catch (const std::bad_alloc&) {
    return outOfMemory(name, "decode the image");
  }
}

Result<ImageFile> readImage(const std::filesystem::path& path, const SizeCheck& check) {
  try {
    const Result<std::vector<std::byte>> file = readFile(path);
    if (!file)
      return file.error();
    Result<ImageFile> stored = decodeImage(file.value(), path.string(), check);
    if (!stored)
      return stored;
    return upright(std::move(stored).value());
  } catch (const std::bad_alloc&) { // while rotating pixels, or for a message or a name
    return memoryError([&] { return path.string() + ": not enough memory to read the image"; });
  }
}

Result<void> writeImage(const std::filesystem::path& path, const SrgbImage& image) {
  return write(path, image);
}

Result<void> writeImage(const std::filesystem::path& path, const LinearImage& image) {
  return write(path, image);
}

} // namespace lichen
