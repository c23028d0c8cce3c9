// SPDX-License-Identifier: MIT
// Sample EXR files, written with OpenEXR.
#include "image_samples.h"

#include <OpenEXR/ImfArray.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>

#include <Imath/half.h>
#include <cstring>

namespace lichen::samples {
namespace {

class ByteStream : public Imf::OStream {
public:
  explicit ByteStream(Bytes& bytes) : OStream("sample"), bytes_(bytes) {}
  void write(const char* source, int size) override {
    bytes_.resize(std::max(bytes_.size(), offset_ + std::size_t(size)));
    std::memcpy(bytes_.data() + offset_, source, std::size_t(size));
    offset_ += std::size_t(size);
  }
  uint64_t tellp() override { return offset_; }
  void seekp(uint64_t position) override { offset_ = std::size_t(position); }

private:
  Bytes& bytes_;
  std::size_t offset_ = 0;
};

/// Samples of one channel inside the data window, in the file's type.
std::vector<char> channelSamples(const Exr& exr, std::size_t c) {
  const int sampling = exr.channels[c].sampling;
  std::vector<char> samples;
  const auto append = [&](auto sample) {
    const auto* first = reinterpret_cast<const char*>(&sample);
    samples.insert(samples.end(), first, first + sizeof(sample));
  };
  for (int y = 0; y < exr.height; y += sampling)
    for (int x = 0; x < exr.width; x += sampling) {
      const bool odd = exr.hasOddValue && c == 0 && x == 0 && y == 0;
      const float value = odd ? exr.oddValue : exrValue(x, y, int(c));
      if (exr.channels[c].type == Imf::HALF)
        append(half(value));
      else if (exr.channels[c].type == Imf::FLOAT)
        append(value);
      else
        append(std::uint32_t(value));
    }
  return samples;
}

} // namespace

float exrValue(int x, int y, int c) { return float((x * 3 + y * 5 + c * 7) % 64); }

Bytes makeExr(const Exr& exr) {
  const Imath::Box2i data({exr.xMin, exr.yMin},
                          {exr.xMin + exr.width - 1, exr.yMin + exr.height - 1});
  const Imath::Box2i display =
      exr.wideDisplay ? Imath::Box2i({-10, -10}, {data.max.x + 10, data.max.y + 10}) : data;
  Imf::Header header(display, data);
  header.compression() = Imf::Compression(exr.compression);
  header.lineOrder() = exr.decreasingY ? Imf::DECREASING_Y : Imf::INCREASING_Y;
  std::vector<std::vector<char>> samples;
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < exr.channels.size(); ++c) {
    const ExrChannel& channel = exr.channels[c];
    const auto type = Imf::PixelType(channel.type);
    header.channels().insert(channel.name, Imf::Channel(type, channel.sampling, channel.sampling));
    samples.push_back(channelSamples(exr, c));
    const std::size_t sampleBytes = type == Imf::HALF ? 2 : 4;
    const int perRow = (exr.width + channel.sampling - 1) / channel.sampling;
    frame.insert(channel.name, Imf::Slice::Make(type, samples.back().data(), data, sampleBytes,
                                                sampleBytes * std::size_t(perRow), channel.sampling,
                                                channel.sampling));
  }
  Bytes bytes;
  ByteStream stream(bytes);
  if (exr.tileSide == 0) {
    Imf::OutputFile file(stream, header, 0);
    file.setFrameBuffer(frame);
    file.writePixels(exr.height);
    return bytes;
  }
  const auto side = unsigned(exr.tileSide);
  header.setTileDescription(
      Imf::TileDescription(side, side, exr.mipMapped ? Imf::MIPMAP_LEVELS : Imf::ONE_LEVEL));
  Imf::TiledOutputFile file(stream, header, 0);
  file.setFrameBuffer(frame); // large enough for every level; smaller levels show its corner
  for (int level = 0; level < file.numLevels(); ++level)
    file.writeTiles(0, file.numXTiles(level) - 1, 0, file.numYTiles(level) - 1, level);
  return bytes;
}

Bytes makeMultiPartExr() {
  std::vector<Imf::Header> headers;
  for (const char* name : {"left", "right"}) {
    Imf::Header header(4, 4);
    header.setName(name);
    header.setType(Imf::SCANLINEIMAGE);
    header.channels().insert("Y", Imf::Channel(Imf::HALF));
    headers.push_back(header);
  }
  Bytes bytes;
  ByteStream stream(bytes);
  Imf::MultiPartOutputFile file(stream, headers.data(), 2, false, 0);
  const std::vector<half> values(16, half(0.5f));
  Imf::FrameBuffer frame;
  frame.insert("Y", Imf::Slice::Make(Imf::HALF, values.data(), headers[0].dataWindow()));
  for (int part = 0; part < 2; ++part) {
    Imf::OutputPart output(file, part);
    output.setFrameBuffer(frame);
    output.writePixels(4);
  }
  return bytes;
}

Bytes makeDeepExr() {
  Imf::Header header(2, 2);
  header.setType(Imf::DEEPSCANLINE);
  header.compression() = Imf::ZIPS_COMPRESSION;
  header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
  Bytes bytes;
  ByteStream stream(bytes);
  Imf::DeepScanLineOutputFile file(stream, header, 0);
  std::vector<unsigned> counts(4, 1);
  std::vector<float> depths = {1, 2, 3, 4};
  std::vector<float*> pointers = {&depths[0], &depths[1], &depths[2], &depths[3]};
  Imf::DeepFrameBuffer frame;
  frame.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data()),
                                          sizeof(unsigned), 2 * sizeof(unsigned)));
  frame.insert("Z", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(pointers.data()),
                                   sizeof(float*), 2 * sizeof(float*), sizeof(float)));
  file.setFrameBuffer(frame);
  file.writePixels(2);
  return bytes;
}

Bytes makeLuminanceChromaExr() {
  Bytes bytes;
  ByteStream stream(bytes);
  Imf::Header header(8, 8);
  Imf::RgbaOutputFile file(stream, header, Imf::WRITE_YC, 0);
  const std::vector<Imf::Rgba> pixels(64, Imf::Rgba(0.25f, 0.5f, 0.75f));
  file.setFrameBuffer(pixels.data(), 1, 8);
  file.writePixels(8);
  return bytes;
}

} // namespace lichen::samples
