// SPDX-License-Identifier: MIT
// EXR bytes -> LinearImage, through OpenEXR, after exr_check.cpp has checked the whole file.
// The image is the data window. Colours stay premultiplied by alpha, as EXR stores them.
#include "claims.h"
#include "codecs.h"
#include "exr_check.h"

#include <lichen/counted.h>

#include <OpenEXR/ImfChannelList.h>
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

std::string joined(const std::vector<std::string>& names) {
  std::string result;
  for (const std::string& name : names)
    result += (result.empty() ? "" : ", ") + name;
  return printable(result);
}

std::vector<std::string> namesOf(const Imf::ChannelList& channels) {
  std::vector<std::string> names;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel)
    names.emplace_back(channel.name());
  return names;
}

/// The file's channels to read, in the order of the image's channels. A name that the file lacks
/// stands for zeros.
Result<std::vector<std::string>> chooseChannels(const Imf::ChannelList& channels,
                                                const std::string& name) {
  const auto has = [&](const char* channel) { return channels.findChannel(channel) != nullptr; };
  const bool colour = has("R") || has("G") || has("B");
  const std::vector<std::string> names = namesOf(channels);
  std::vector<std::string> chosen;
  if (!colour && (has("RY") || has("BY")))
    return badInput(name, "is a luminance-chroma EXR (channels " + joined(names) +
                              "); expected R, G, B, or Y alone");
  if (colour)
    chosen = {"R", "G", "B"};
  else if (has("Y"))
    chosen = {"Y"};
  else if (names.size() == 1)
    chosen = names; // unambiguous
  else
    return badInput(name, "EXR with channels " + joined(names) +
                              "; expected R, G, B, or Y, or a single channel");
  if (has("A") && chosen.front() != "A")
    chosen.emplace_back("A");
  for (const std::string& channel : chosen)
    if (const Imf::Channel* found = channels.findChannel(channel);
        found != nullptr && (found->xSampling != 1 || found->ySampling != 1))
      return badInput(name, "EXR channel " + printable(channel) + " is subsampled " +
                                std::to_string(found->xSampling) + " x " +
                                std::to_string(found->ySampling) + "; expected 1 x 1");
  return chosen;
}

void describeChannels(const Imf::Header& header, const std::vector<std::string>& chosen,
                      std::vector<std::string>& notes) {
  std::vector<std::string> missing;
  for (const std::string& channel : chosen)
    if (header.channels().findChannel(channel) == nullptr)
      missing.push_back(channel);
  if (!missing.empty())
    notes.push_back("missing channels set to 0: " + joined(missing));
  std::vector<std::string> ignored;
  for (const std::string& channel : namesOf(header.channels()))
    if (std::find(chosen.begin(), chosen.end(), channel) == chosen.end())
      ignored.push_back(channel);
  if (!ignored.empty())
    notes.push_back("ignored channels: " + joined(ignored));
  if (chosen.size() == 1 && chosen.front() != "Y")
    notes.push_back("channel " + printable(chosen.front()) + " read as grey");
  if (header.dataWindow() != header.displayWindow())
    notes.emplace_back("the image is the data window, not the display window");
}

/// Throws std::bad_alloc where OpenEXR 3.1 would crash: its DWA decoder allocates several copies of
/// a chunk while decoding, without checking for failure.
void requireScratch(const Imf::Header& header) {
  constexpr std::size_t kMostLinesPerChunk = 256;
  constexpr std::size_t kCopies = 4;
  if (header.compression() < Imf::DWAA_COMPRESSION)
    return;
  std::size_t bytes = 0;
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel)
    bytes += channel.channel().type == Imf::HALF ? 2u : 4u;
  const Imath::V2i size = header.dataWindow().size() + Imath::V2i(1);
  bytes *= header.hasTileDescription()
               ? std::size_t(header.tileDescription().xSize) * header.tileDescription().ySize
               : std::size_t(size.x) * std::min(std::size_t(size.y), kMostLinesPerChunk);
  const std::vector<char> scratch(kCopies * bytes);
}

void readPixels(Imf::InputFile& input, const std::vector<std::string>& chosen, LinearImage& image) {
  const Imath::Box2i window = input.header().dataWindow();
  Imf::FrameBuffer frame;
  for (std::size_t c = 0; c < chosen.size(); ++c)
    frame.insert(chosen[c],
                 Imf::Slice::Make(Imf::FLOAT, image.values.data() + c, window,
                                  chosen.size() * sizeof(float),
                                  chosen.size() * sizeof(float) * std::size_t(image.width)));
  input.setFrameBuffer(frame);
  requireScratch(input.header());
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
    notes.push_back(counted(negative, "negative value") + " set to 0");
  return {};
}

/// Like decodeExr(), but throws what OpenEXR throws.
Result<ImageFile> decode(std::span<const std::byte> file, const std::string& name,
                         const SizeCheck& check) {
  MemoryStream stream(file);
  Imf::InputFile input(stream, 0);
  const Imf::Header& header = input.header();
  const Result<std::vector<std::string>> chosenResult = chooseChannels(header.channels(), name);
  if (!chosenResult)
    return chosenResult.error();
  const std::vector<std::string>& chosen = chosenResult.value();
  const Imath::V2i size = header.dataWindow().size() + Imath::V2i(1);
  if (Result<void> wanted = checkWanted(check, std::uint64_t(size.x), std::uint64_t(size.y));
      !wanted)
    return wanted.error();
  ImageFile result;
  result.bitsPerChannel = 32;
  LinearImage image(size.x, size.y, int(chosen.size()));
  readPixels(input, chosen, image);
  describeChannels(header, chosen, result.notes);
  if (Result<void> values = checkValues(chosen, image, result.notes, name); !values)
    return values.error();
  result.pixels = std::move(image);
  return result;
}

} // namespace

Result<ImageFile> decodeExr(std::span<const std::byte> file, const std::string& name,
                            const SizeCheck& check) {
  if (Result<void> checked = checkExr(file, name); !checked)
    return checked.error();
  try {
    return decode(file, name, check);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& problem) {
    if (meansOutOfMemory(problem.what()))
      return outOfMemory(name, "decode the EXR");
    return badInput(name, "damaged EXR: " + printable(problem.what()));
  }
}

} // namespace lichen
