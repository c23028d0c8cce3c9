// SPDX-License-Identifier: MIT
// EXR bytes -> LinearImage, through OpenEXR, after exr_header.cpp has checked the whole file.
// The image is the data window. Colours stay premultiplied by alpha, as EXR stores them.
#include "claims.h"
#include "codecs.h"
#include "exr_header.h"

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string_view>

namespace lichen {
namespace {

class MemoryStream : public Imf::IStream {
public:
  explicit MemoryStream(std::span<const std::byte> bytes) : IStream("EXR"), bytes_(bytes) {}

  bool read(char* target, int size) override {
    if (size < 0 || std::size_t(size) > bytes_.size() - offset_)
      throw std::runtime_error("unexpected end of file");
    std::memcpy(target, bytes_.data() + offset_, std::size_t(size));
    offset_ += std::size_t(size);
    return offset_ < bytes_.size();
  }
  uint64_t tellg() override { return offset_; }
  void seekg(uint64_t position) override {
    if (position > bytes_.size())
      throw std::runtime_error("unexpected end of file");
    offset_ = std::size_t(position);
  }

private:
  std::span<const std::byte> bytes_;
  std::size_t offset_ = 0;
};

const ExrChannel* findChannel(const ExrHeader& header, const std::string& channel) {
  const auto found = std::find_if(header.channels.begin(), header.channels.end(),
                                  [&](const ExrChannel& c) { return c.name == channel; });
  return found == header.channels.end() ? nullptr : &*found;
}

std::string joined(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names)
    result += (result.empty() ? "" : ", ") + name;
  return printable(result);
}

std::vector<std::string> namesOf(const ExrHeader& header) {
  std::vector<std::string> names;
  for (const ExrChannel& channel : header.channels)
    names.push_back(channel.name);
  return names;
}

/// The file's channels to read, in the order of the image's channels. A name that the file lacks
/// stands for zeros.
Result<std::vector<std::string>> chooseChannels(const ExrHeader& header, const std::string& name) {
  const bool alpha = findChannel(header, "A") != nullptr;
  const bool colour = findChannel(header, "R") != nullptr || findChannel(header, "G") != nullptr ||
                      findChannel(header, "B") != nullptr;
  std::vector<std::string> chosen;
  if (!colour && (findChannel(header, "RY") != nullptr || findChannel(header, "BY") != nullptr))
    return badInput(name, "is a luminance-chroma EXR (channels " + joined(namesOf(header)) +
                              "); expected R, G, B, or Y alone");
  if (colour)
    chosen = {"R", "G", "B"};
  else if (findChannel(header, "Y") != nullptr)
    chosen = {"Y"};
  else if (header.channels.size() == 1)
    chosen = {header.channels.front().name}; // unambiguous
  else
    return badInput(name, "EXR with channels " + joined(namesOf(header)) +
                              "; expected R, G, B, or Y, or a single channel");
  if (alpha && chosen.front() != "A")
    chosen.emplace_back("A");
  for (const std::string& channel : chosen)
    if (const ExrChannel* found = findChannel(header, channel);
        found != nullptr && (found->xSampling != 1 || found->ySampling != 1))
      return badInput(name, "EXR channel " + printable(channel) + " is subsampled " +
                                std::to_string(found->xSampling) + " x " +
                                std::to_string(found->ySampling) + "; expected 1 x 1");
  return chosen;
}

void describeChannels(const ExrHeader& header, const std::vector<std::string>& chosen,
                      std::vector<std::string>& notes) {
  std::vector<std::string> missing;
  for (const std::string& channel : chosen)
    if (findChannel(header, channel) == nullptr)
      missing.push_back(channel);
  if (!missing.empty())
    notes.push_back("missing channels set to 0: " + joined(missing));
  std::vector<std::string> ignored;
  for (const ExrChannel& channel : header.channels)
    if (std::find(chosen.begin(), chosen.end(), channel.name) == chosen.end())
      ignored.push_back(channel.name);
  if (!ignored.empty())
    notes.push_back("ignored channels: " + joined(ignored));
  if (chosen.size() == 1 && chosen.front() != "Y")
    notes.push_back("channel " + printable(chosen.front()) + " read as grey");
  if (header.dataWindow != header.displayWindow)
    notes.emplace_back("the image is the data window, not the display window");
}

/// Throws std::bad_alloc where OpenEXR 3.1 would crash: its DWA decoder allocates several copies of
/// a chunk while decoding, without checking for failure.
void requireScratch(const ExrHeader& header) {
  constexpr unsigned kFirstDwa = 8;
  constexpr std::int64_t kMostLinesPerChunk = 256;
  constexpr std::size_t kCopies = 4;
  if (header.compression < kFirstDwa)
    return;
  const std::int64_t pixels =
      header.tiled
          ? header.tileWidth * header.tileHeight
          : header.dataWindow.width() * std::min(header.dataWindow.height(), kMostLinesPerChunk);
  std::size_t bytesPerPixel = 0;
  for (const ExrChannel& channel : header.channels)
    bytesPerPixel += channel.bytesPerSample;
  const std::vector<char> scratch(kCopies * bytesPerPixel * std::size_t(pixels));
}

void readPixels(std::span<const std::byte> file, const ExrHeader& header,
                const std::vector<std::string>& chosen, LinearImage& image) {
  MemoryStream stream(file);
  Imf::InputFile input(stream, 0);
  const Imath::Box2i window = input.header().dataWindow();
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < chosen.size(); ++c)
    frame.insert(chosen[c],
                 Imf::Slice::Make(Imf::FLOAT, image.values.data() + c, window,
                                  chosen.size() * sizeof(float),
                                  chosen.size() * sizeof(float) * std::size_t(image.width)));
  input.setFrameBuffer(frame);
  requireScratch(header);
  input.readPixels(window.min.y, window.max.y);
}

/// OpenEXR reports a failed allocation as its own exception type, so only the text identifies it.
bool meansOutOfMemory(std::string_view text) {
  return text.find("std::bad_alloc") != text.npos || text.find("allocate memory") != text.npos;
}

/// Rejects NaN and infinity, and clamps negative values to 0.
Result<void> checkValues(const std::vector<std::string>& chosen, LinearImage& image,
                         std::vector<std::string>& notes, const std::string& name) {
  std::size_t negative = 0;
  for (std::size_t i = 0; i < image.values.size(); ++i) {
    float& value = image.values[i];
    if (!std::isfinite(value)) {
      const std::size_t pixel = i / chosen.size();
      const auto width = std::size_t(image.width);
      return badInput(name, std::string(std::isnan(value) ? "NaN" : "infinity") + " in channel " +
                                printable(chosen[i % chosen.size()]) + " of pixel (" +
                                std::to_string(pixel % width) + ", " +
                                std::to_string(pixel / width) + "); all values must be finite");
    }
    if (value < 0.0f) {
      value = 0.0f;
      ++negative;
    }
  }
  if (negative > 0)
    notes.push_back(std::to_string(negative) + " negative values set to 0");
  return {};
}

} // namespace

Result<ImageFile> decodeExr(std::span<const std::byte> file, const std::string& name,
                            const SizeCheck& check) {
  const Result<ExrHeader> headerResult = readExrHeader(file, name);
  if (!headerResult)
    return headerResult.error();
  const ExrHeader& header = headerResult.value();
  const Result<std::vector<std::string>> chosenResult = chooseChannels(header, name);
  if (!chosenResult)
    return chosenResult.error();
  const std::vector<std::string>& chosen = chosenResult.value();
  const auto width = header.dataWindow.width(), height = header.dataWindow.height();
  if (Result<void> wanted = checkWanted(check, std::uint64_t(width), std::uint64_t(height));
      !wanted)
    return wanted.error();

  ImageFile result;
  result.bitsPerChannel = 32;
  LinearImage image(int(width), int(height), int(chosen.size()));
  try {
    readPixels(file, header, chosen, image);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& problem) {
    if (meansOutOfMemory(problem.what()))
      return outOfMemory(name, "decode the EXR");
    return badInput(name, "damaged EXR: " + printable(problem.what()));
  }
  describeChannels(header, chosen, result.notes);
  if (Result<void> values = checkValues(chosen, image, result.notes, name); !values)
    return values.error();
  result.pixels = std::move(image);
  return result;
}

} // namespace lichen
