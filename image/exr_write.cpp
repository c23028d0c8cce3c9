// SPDX-License-Identifier: MIT
// LinearImage -> EXR bytes: scan lines of half floats, ZIP-compressed, through OpenEXR.
#include "claims.h"

#include <lichen/image_io.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>

#include <Imath/half.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <new>

namespace lichen {
namespace {

const char* const kName = "EXR";

class MemoryStream : public Imf::OStream {
public:
  explicit MemoryStream(std::vector<std::byte>& bytes) : OStream(kName), bytes_(bytes) {}

  void write(const char* source, int size) override {
    const std::size_t end = offset_ + std::size_t(size);
    if (end > bytes_.size())
      bytes_.resize(end);
    std::copy_n(reinterpret_cast<const std::byte*>(source), size,
                bytes_.begin() + std::ptrdiff_t(offset_));
    offset_ = end;
  }
  uint64_t tellp() override { return offset_; }
  void seekp(uint64_t position) override { offset_ = std::size_t(position); }

private:
  std::vector<std::byte>& bytes_;
  std::size_t offset_ = 0;
};

std::vector<half> toHalf(const LinearImage& image) {
  std::vector<half> values(image.values.size());
  std::transform(image.values.begin(), image.values.end(), values.begin(), [](float value) {
    constexpr float kLargest = HALF_MAX; // half() would round larger values to infinity
    return half(std::clamp(value, -kLargest, kLargest));
  });
  return values;
}

/// Throws OpenEXR's exceptions and std::bad_alloc.
std::vector<std::byte> encode(const LinearImage& image) {
  constexpr std::array<std::string_view, 4> kChannelNames = {"Y", "YA", "RGB", "RGBA"};
  const std::vector<half> values = toHalf(image);
  const auto channels = std::size_t(image.channels);
  Imf::Header header(image.width, image.height);
  header.compression() = Imf::ZIP_COMPRESSION;
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < channels; ++c) {
    const std::string channel(1, kChannelNames[channels - 1][c]);
    header.channels().insert(channel, Imf::Channel(Imf::HALF));
    frame.insert(channel, Imf::Slice::Make(Imf::HALF, values.data() + c, header.dataWindow(),
                                           channels * sizeof(half),
                                           channels * sizeof(half) * std::size_t(image.width)));
  }
  std::vector<std::byte> bytes;
  MemoryStream stream(bytes);
  {
    Imf::OutputFile output(stream, header, 0);
    output.setFrameBuffer(frame);
    output.writePixels(image.height);
  } // the destructor completes the file
  return bytes;
}

} // namespace

Result<std::vector<std::byte>> encodeExr(const LinearImage& image) {
  const auto exhausted = [] { return "EXR: not enough memory to encode the image"; };
  return withinMemory(exhausted, [&]() -> Result<std::vector<std::byte>> {
    if (Result<void> encodable =
            checkEncodable(kName, image.width, image.height, image.channels, image.values);
        !encodable)
      return encodable.error();
    try {
      return encode(image);
    } catch (const std::bad_alloc&) {
      throw; // also derives from std::exception
    } catch (const std::exception& problem) {
      return Error{ErrorKind::resources,
                   std::string("EXR: cannot encode the image: ") + printable(problem.what())};
    }
  });
}

} // namespace lichen
