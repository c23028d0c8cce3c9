// SPDX-License-Identifier: MIT
// What all formats share: detection, truncation, exhausted memory, and files on disk.
#include "child_process.h"
#include "image_samples.h"
#include "temporary_folder.h"

#include <lichen/files.h>

#include <catch2/catch.hpp>

#include <array>
#include <fstream>
#include <malloc.h>

using namespace lichen;
using namespace lichen::samples;
using namespace std::string_literals;

namespace {

Bytes bytesOf(const std::string& text) {
  Bytes bytes;
  for (const char c : text)
    bytes.push_back(std::byte(static_cast<unsigned char>(c)));
  return bytes;
}

} // namespace

TEST_CASE("the error for a file that is not an image quotes its first bytes") {
  CHECK(refusal({}) == "file: empty file; expected a PNG, JPEG or EXR image");
  CHECK(refusal(bytesOf("<html>")) ==
        "file: is not a PNG, JPEG or EXR image (starts with 3c 68 74 6d)");
  CHECK(refusal(bytesOf("\xff")) == "file: is not a PNG, JPEG or EXR image (starts with ff)");
}

TEST_CASE("the error for another image format names it") {
  // The first bytes of files that libwebp, ImageMagick, libtiff, libheif and libjxl write.
  const std::pair<std::string, const char*> files[] = {
      {"RIFF\x24\0\0\0WEBPVP8 "s, "a WebP"},
      {"GIF89a", "a GIF"},
      {"GIF87a", "a GIF"},
      {"II*\0\x08\0\0\0"s, "a TIFF"},
      {"MM\0*\0\0\0\x08"s, "a TIFF"},
      {"8BPS\0\1"s, "a Photoshop"},
      {"\0\0\0\030ftypheic\0\0\0\0"s, "a HEIC"},
      {"\0\0\0\034ftypmif1\0\0\0\0"s, "a HEIF"},
      {"\0\0\0\040ftypavif\0\0\0\0"s, "an AVIF"},
      {"\xff\x0a\xfa\x1f", "a JPEG XL"},
      {"\0\0\0\x0cJXL \r\n\x87\n"s, "a JPEG XL"},
  };
  for (const auto& [start, format] : files) {
    CHECK(refusal(bytesOf(start)) ==
          "file: is " + std::string(format) + " file; expected PNG, JPEG or EXR");
    const Bytes cut = bytesOf(start.substr(0, 1));
    CHECK(refusal(cut).starts_with("file: is not a PNG, JPEG or EXR image (starts with "));
  }
  // WAV files also start with RIFF.
  CHECK(refusal(bytesOf("RIFF\x24\0\0\0WAVEfmt "s)).starts_with("file: is not a PNG"));
}

TEST_CASE("every kind of sample decodes, even with bytes after its end") {
  for (Bytes file : everySupportedKind()) {
    CHECK(refusal(file) == "(no error)");
    file.insert(file.end(), 100, std::byte(0x5a));
    CHECK(refusal(file) == "(no error)");
  }
}

TEST_CASE("a size check is called once for every kind of image, and can refuse it") {
  for (const Bytes& file : everySupportedKind()) {
    std::vector<std::array<int, 2>> sizes;
    const auto check = [&](int width, int height) -> Result<void> {
      sizes.push_back({width, height});
      return Error{ErrorKind::resources, "too large"};
    };
    const Result<ImageFile> refused = decodeImage(file, "file", check);
    REQUIRE(!refused);
    CHECK(refused.error().kind == ErrorKind::resources);
    CHECK(refused.error().message == "too large");
    const Result<ImageFile> decoded = decodeImage(file, "file");
    REQUIRE(decoded);
    std::visit(
        [&](const auto& pixels) {
          CHECK(sizes == std::vector{std::array{pixels.width, pixels.height}});
        },
        decoded.value().pixels);
  }
}

TEST_CASE("every truncated length of every kind of file gives a one-line error") {
  for (const Bytes& file : everySupportedKind()) {
    // The smaller levels of a mip-mapped EXR come last and are never read.
    const bool mipMapped = find(file, std::string("\x04\0\0\0\x04\0\0\0\x01", 9)) < file.size();
    for (std::size_t size = 0; size < file.size(); ++size) {
      const std::string message = refusal(Bytes(file.begin(), file.begin() + std::ptrdiff_t(size)));
      const bool refused = message.starts_with("file: ") && message.find('\n') == std::string::npos;
      if (!refused && !(mipMapped && message == "(no error)"))
        FAIL(size << " of " << file.size() << " bytes: " << message);
    }
  }
}

TEST_CASE("a truncated file is called truncated") {
  const auto withoutLastByte = [](Bytes file) {
    file.pop_back();
    return refusal(file);
  };
  CHECK(withoutLastByte(makePng({})) ==
        "file: truncated: the PNG ends before its IEND chunk is complete");
  CHECK(withoutLastByte(makeJpeg({})) ==
        "file: truncated: the JPEG ends before its last pixel or its end marker");
  CHECK(withoutLastByte(makeExr({})).starts_with("file: truncated or damaged EXR: Preparing "));
  const Bytes exr = makeExr({});
  CHECK(refusal(Bytes(exr.begin(), exr.begin() + 100)) ==
        "file: truncated: the EXR ends inside its header");
}

TEST_CASE("an image written to disk reads back in its own encoding or the other one") {
  const TemporaryFolder folder;
  SrgbImage srgb(3, 2, 3);
  for (std::size_t i = 0; i < srgb.values.size(); ++i)
    srgb.values[i] = float(i * 15) / 255.0f;
  const LinearImage linear = toLinear(srgb);

  for (const char* name : {"srgb.png", "SRGB.PNG"}) {
    REQUIRE(writeImage(folder / name, srgb));
    const Result<ImageFile> file = readImage(folder / name);
    REQUIRE(file);
    CHECK(std::get<SrgbImage>(file.value().pixels).values == srgb.values);
  }
  REQUIRE(writeImage(folder / "linear.png", linear));
  CHECK(std::get<SrgbImage>(readImage(folder / "linear.png").value().pixels).values == srgb.values);
  REQUIRE(writeImage(folder / "srgb.exr", srgb));
  REQUIRE(writeImage(folder / "linear.exr", linear));
  CHECK(readFile(folder / "srgb.exr").value() == readFile(folder / "linear.exr").value());
  const LinearImage back = std::get<LinearImage>(readImage(folder / "linear.exr").value().pixels);
  for (std::size_t i = 0; i < linear.values.size(); ++i)
    CHECK(back.values[i] == Approx(linear.values[i]).epsilon(1.0 / 2048));
}

TEST_CASE("a failed write gives the reason and leaves the old file unchanged") {
  const TemporaryFolder folder;
  const SrgbImage image(2, 2, 3);
  const Result<void> extension = writeImage(folder / "image.bmp", image);
  CHECK(extension.error().kind == ErrorKind::usage);
  CHECK(extension.error().message ==
        (folder / "image.bmp").string() + ": unknown extension .bmp; use .png or .exr");
  CHECK(writeImage(folder / "image", image).error().message ==
        (folder / "image").string() + ": missing extension; use .png or .exr");
  const Result<void> absent = writeImage(folder / "absent/image.png", image);
  CHECK(absent.error().kind == ErrorKind::environment);
  CHECK(absent.error().message ==
        (folder / "absent/image.png").string() + ": cannot be written: No such file or directory");
  REQUIRE(writeImage(folder / "old.png", image));
  CHECK(writeImage(folder / "old.png", SrgbImage(2, 2, 7)).error().message ==
        (folder / "old.png").string() + ": PNG: 7 channels; expected 1 to 4");
  CHECK(readImage(folder / "old.png"));
  CHECK(folder.entryCount() == 1);
}

// The sanitizers reserve the address space that this test limits.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

namespace {

/// Runs `operation` in a child process that may allocate only `spare` more bytes, and returns the
/// kind of its error; 0 for success.
template <class Operation>
int errorKindWithLittleMemory(std::size_t spare, Operation operation) {
  const int status = childStatus([&] {
    ::malloc_trim(0); // otherwise memory that the parent has freed would count as spare
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t limit = pages * std::size_t(::sysconf(_SC_PAGESIZE)) + spare;
    const rlimit limits = {limit, limit};
    if (::setrlimit(RLIMIT_AS, &limits) != 0)
      return 100;
    const auto result = operation();
    return result ? 0 : int(result.error().kind);
  });
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace

TEST_CASE("with any amount of memory, decoding succeeds or reports exhausted memory") {
  constexpr int kSide = 1024;
  constexpr std::size_t kStep = std::size_t(128) << 10; // less than most chunks
  constexpr std::size_t kEnough = std::size_t(256) << 20;
  const std::vector<Bytes> files = {
      makePng({.width = kSide, .height = kSide}), makeJpeg({.width = kSide, .height = kSide}),
      makeJpeg({.width = kSide, .height = kSide, .progressive = true}),
      makeExr({.width = kSide, .height = kSide, .compression = 3}),
      makeExr({.width = kSide, .height = kSide, .compression = 4, .tileSide = 256})};
  for (const Bytes& file : files) {
    const auto decode = [&] { return decodeImage(file, "file"); };
    std::size_t spare = 0;
    int kind = int(ErrorKind::resources);
    for (; kind == int(ErrorKind::resources) && spare < kEnough; spare += kStep)
      kind = errorKindWithLittleMemory(spare, decode);
    INFO("with " << spare << " bytes to spare");
    CHECK(kind == 0);
    CHECK(spare > 3 * kSide * kSide); // otherwise no allocation ever failed
  }
}

TEST_CASE("exhausted memory inside OpenEXR's DWA decoder is an error") {
  constexpr int kSide = 2048;
  constexpr std::size_t kImageBytes = std::size_t(kSide) * kSide * 3 * sizeof(float);
  constexpr std::size_t kChunkBytes = std::size_t(kSide) * 32 * 3 * 2;
  const Bytes file = makeExr({.width = kSide, .height = kSide, .compression = 8});
  const auto decode = [&] { return decodeImage(file, "file"); };
  for (std::size_t spare = kImageBytes; spare < kImageBytes + 8 * kChunkBytes;
       spare += kChunkBytes / 4) {
    const int kind = errorKindWithLittleMemory(spare, decode);
    CHECK((kind == 0 || kind == int(ErrorKind::resources)));
  }
}

TEST_CASE("encoders report exhausted memory and write nothing") {
  constexpr int kSide = 2048;
  const SrgbImage codes(kSide, kSide, 1);
  const LinearImage light(kSide, kSide, 1);
  const TemporaryFolder folder;
  const auto encode = [&] { return encodeExr(light); };
  const auto convert = [&] { return writeImage(folder / "image.exr", codes); };
  for (std::size_t spare = 1; spare <= std::size_t(4) << 20; spare *= 4) {
    CHECK(errorKindWithLittleMemory(spare, encode) == int(ErrorKind::resources));
    CHECK(errorKindWithLittleMemory(spare, convert) == int(ErrorKind::resources));
  }
  CHECK(folder.entryCount() == 0);
}

#endif
