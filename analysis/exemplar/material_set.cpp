// SPDX-License-Identifier: MIT
// Image files -> maps. The steps, in order: read, crop, fill invisible colours, resample, join.
#include "borders.h"
#include "color_space.h"
#include "frame.h"
#include "invisible_color.h"
#include "map_values.h"
#include "resample.h"
#include "set_files.h"

#include <lichen/material_set.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace lichen {
namespace {

using namespace exemplar;

// The range that docs/baking.md recommends.
constexpr int kGoodPixels = 256;
constexpr int kPlentyOfPixels = 1024;

/// A map and its file's name in messages.
struct NamedMap {
  MapExemplar map;
  std::string name;
};

std::size_t pixelCount(const MapExemplar& map) {
  return std::size_t(map.width) * std::size_t(map.height);
}

const NamedMap& largestOf(const std::vector<NamedMap>& maps) {
  return *std::max_element(maps.begin(), maps.end(), [](const NamedMap& a, const NamedMap& b) {
    return pixelCount(a.map) < pixelCount(b.map);
  });
}

/// The colour channel of a packed file that holds a role.
struct PackedChannel {
  FileRole role{};
  MapChannel channel{};
  int source = 0; ///< 0 red, 1 green, 2 blue
};
constexpr PackedChannel kPacked[] = {{FileRole::occlusion, MapChannel::occlusion, 0},
                                     {FileRole::roughness, MapChannel::roughness, 1},
                                     {FileRole::metallic, MapChannel::metallic, 2}};

/// Returns the channels of a packed file that no other file provides.
Result<MapExemplar> packedDataOf(const NamedImage& image, const SetFile& file,
                                 std::vector<std::string>& notes) {
  std::vector<MapChannel> channels;
  std::vector<int> sources;
  for (const PackedChannel& packed : kPacked) {
    const bool isLeftOut =
        (file.role == FileRole::roughnessMetallic && packed.role == FileRole::occlusion) ||
        std::find(file.leftOut.begin(), file.leftOut.end(), packed.role) != file.leftOut.end();
    if (isLeftOut)
      continue;
    channels.push_back(packed.channel);
    sources.push_back(packed.source);
  }
  return dataMap(image, MapTarget::occlusionRoughnessMetallic, channels, sources, true, notes);
}

/// Returns the data in a file's red, green and blue.
Result<MapExemplar> dataOf(const NamedImage& image, const SetFile& file,
                           std::vector<std::string>& notes) {
  using enum MapChannel;
  const auto data = [&](MapTarget target, std::initializer_list<MapChannel> channels,
                        std::initializer_list<int> sources) {
    return dataMap(image, target, {channels.begin(), channels.size()},
                   {sources.begin(), sources.size()}, false, notes);
  };
  const MapTarget orm = MapTarget::occlusionRoughnessMetallic;
  switch (file.role) {
  case FileRole::occlusion:
    return data(orm, {occlusion}, {0});
  case FileRole::roughness:
    return data(orm, {roughness}, {0});
  case FileRole::metallic:
    return data(orm, {metallic}, {0});
  case FileRole::occlusionRoughnessMetallic:
  case FileRole::roughnessMetallic:
    return packedDataOf(image, file, notes);
  case FileRole::height:
    return data(MapTarget::height, {MapChannel::height}, {0});
  default:
    return data(MapTarget::opacity, {opacity}, {0});
  }
}

Result<MapExemplar> mapOf(const NamedImage& image, const SetFile& file,
                          std::vector<std::string>& notes) {
  switch (file.role) {
  case FileRole::baseColor:
    return colorMap(image, MapTarget::baseColor, notes);
  case FileRole::emissive:
    return colorMap(image, MapTarget::emissive, notes);
  case FileRole::normal:
  case FileRole::normalGl:
    return normalMap(image, false, notes);
  case FileRole::normalDx:
    return normalMap(image, true, notes);
  default:
    return dataOf(image, file, notes);
  }
}

/// Returns the role of an image that is alone. Its name decides, unless its colours contradict it:
/// a photograph may be called "rusty metal".
FileRole loneRole(const NamedImage& image, FileRole named, std::vector<std::string>& notes) {
  if (named == FileRole::baseColor)
    return named;
  const bool isPacked = slotsOf(named).size() > 1;
  const bool isNormal = named == FileRole::normalGl || named == FileRole::normalDx;
  const bool fits = named == FileRole::emissive || hasColors(image) == (isPacked || isNormal);
  const std::string file = std::filesystem::path(image.path).filename().string();
  const std::string slots = fmt::format("{}", fmt::join(slotsOf(named), ", "));
  notes.push_back(fits
                      ? fmt::format("{} is baked as {}, as its name says; rename it to bake it as "
                                    "the base colour",
                                    file, slots)
                      : fmt::format("{} has {}colours, so it is baked as the base colour, although "
                                    "its name says {}",
                                    file, isPacked || isNormal ? "no " : "", slots));
  return fits ? named : FileRole::baseColor;
}

/// Decodes the image of a file.
using Decode = std::function<Result<ImageFile>(const std::filesystem::path&)>;

/// Appends the map of one file, and, if wanted, its alpha as a map.
Result<void> appendMaps(SetFile source, const SetFiles& files, const MaterialSetOptions& options,
                        const Decode& decode, std::vector<NamedMap>& maps,
                        std::vector<std::string>& notes) {
  Result<ImageFile> file = decode(source.path);
  if (!file)
    return file.error();
  const std::string name = files.isSingleImage ? "the image" : source.path.filename().string();
  const NamedImage image{std::move(file).value(), name, source.path.string()};
  for (const std::string& note : image.file.notes)
    notes.push_back(files.isSingleImage ? note : name + ": " + note);
  if (files.isSingleImage)
    source.role = loneRole(image, source.role, notes);
  Result<MapExemplar> map = mapOf(image, source, notes);
  if (!map)
    return map.error();
  maps.push_back({std::move(map).value(), name});
  if (source.role != FileRole::baseColor || options.alpha == AlphaUse::ignore) {
    const bool hasOpacity =
        std::any_of(files.files.begin(), files.files.end(),
                    [](const SetFile& other) { return other.role == FileRole::opacity; });
    noteIgnoredAlpha(image, source.role == FileRole::baseColor && !hasOpacity, notes);
    return {};
  }
  if (std::optional<MapExemplar> alpha = alphaMap(image))
    maps.push_back({std::move(*alpha), "the alpha of " + name});
  else
    notes.push_back(name + " is opaque everywhere; no opacity map is baked");
  return {};
}

/// Refuses a second opacity map. File names cannot reveal one that comes from an alpha channel.
Result<void> checkOneOpacity(const std::vector<NamedMap>& maps) {
  const NamedMap* first = nullptr;
  for (const NamedMap& named : maps) {
    if (named.map.target != MapTarget::opacity)
      continue;
    if (first != nullptr)
      return Error{ErrorKind::badInput, first->name + ": a second opacity beside " + named.name +
                                            "; keep one of them, or ignore alpha"};
    first = &named;
  }
  return {};
}

/// Crops the same part from all maps.
Result<void> crop(std::vector<NamedMap>& maps, const PixelRectangle& part) {
  const NamedMap& largest = largestOf(maps);
  const int width = largest.map.width, height = largest.map.height;
  if (part.x < 0 || part.y < 0 || part.width < 1 || part.height < 1 ||
      part.width > width - part.x || part.height > height - part.y)
    return Error{
        ErrorKind::usage,
        fmt::format("the crop {},{},{},{} (x, y, width, height) does not fit into the {} x "
                    "{} pixels of {}: it ends at column {} and row {}",
                    part.x, part.y, part.width, part.height, width, height, largest.name,
                    std::int64_t(part.x) + part.width, std::int64_t(part.y) + part.height)};
  for (NamedMap& named : maps) {
    const auto range = [](int from, int count, int side, int sideOfLargest) {
      const double scale = double(side) / double(sideOfLargest);
      const int first = std::min(int(std::lround(from * scale)), side - 1);
      const int last = int(std::lround((from + count) * scale));
      return std::array<int, 2>{first, std::max(1, last - first)};
    };
    const auto [x, columns] = range(part.x, part.width, named.map.width, width);
    const auto [y, rows] = range(part.y, part.height, named.map.height, height);
    named.map = cropped(named.map, {x, y, columns, rows});
  }
  return {};
}

const NamedMap* findMap(const std::vector<NamedMap>& maps, MapTarget target) {
  const auto found = std::find_if(maps.begin(), maps.end(), [target](const NamedMap& named) {
    return named.map.target == target;
  });
  return found == maps.end() ? nullptr : &*found;
}

void fillInvisibleColors(std::vector<NamedMap>& maps) {
  const NamedMap* opacity = findMap(maps, MapTarget::opacity);
  if (opacity == nullptr)
    return;
  for (NamedMap& named : maps)
    if (named.map.target == MapTarget::baseColor || named.map.target == MapTarget::emissive)
      fillInvisible(named.map, opacity->map);
}

Result<void> resize(std::vector<NamedMap>& maps, const std::array<int, 2>& size, bool wraps,
                    std::vector<std::string>& notes) {
  const auto [width, height] = size;
  if (std::min(width, height) < 1 || std::max(width, height) > kMaxImageSide)
    return Error{ErrorKind::usage, fmt::format("size {}x{}; expected sides from 1 to {}", width,
                                               height, kMaxImageSide)};
  for (NamedMap& named : maps) {
    if (width > named.map.width || height > named.map.height)
      notes.push_back(fmt::format("{} is enlarged from {} x {}, which adds no detail", named.name,
                                  named.map.width, named.map.height));
    named.map = resampled(named.map, width, height, wraps);
  }
  return {};
}

/// Joins the maps of occlusion, roughness and metallic, and sorts all maps by target.
void joinChannels(std::vector<NamedMap>& maps, bool wraps, std::vector<std::string>& notes) {
  const MapTarget orm = MapTarget::occlusionRoughnessMetallic;
  std::vector<MapExemplar> parts;
  std::string names;
  bool sizesDiffer = false;
  for (const NamedMap& named : maps)
    if (named.map.target == orm) {
      parts.push_back(named.map);
      names += (names.empty() ? "" : ", ") + named.name;
      sizesDiffer = sizesDiffer || parts.front().width != named.map.width ||
                    parts.front().height != named.map.height;
    }
  if (parts.size() > 1) {
    std::erase_if(maps, [=](const NamedMap& named) { return named.map.target == orm; });
    maps.push_back({joined(parts, wraps), names});
    if (sizesDiffer)
      notes.push_back(fmt::format("{} differ in size; they are baked as one map of {} x {}", names,
                                  maps.back().map.width, maps.back().map.height));
  }
  std::sort(maps.begin(), maps.end(),
            [](const NamedMap& a, const NamedMap& b) { return a.map.target < b.map.target; });
}

/// Returns whether no channel varies by more than a rounding step.
bool isConstant(const MapExemplar& map) {
  for (std::size_t c = 0; c < map.channels.size(); ++c) {
    const auto [least, most] = rangeOf(map.values, map.channels.size(), c);
    if (most - least > float(map.quantum))
      return false;
  }
  return true;
}

void noteContent(const std::vector<NamedMap>& maps, std::vector<std::string>& notes) {
  bool varies = false;
  for (const NamedMap& named : maps) {
    if (!isConstant(named.map))
      varies = true;
    else if (named.map.target == MapTarget::baseColor)
      notes.push_back(named.name + " has only one colour, and so will the noise");
    else
      notes.push_back(named.name + " has only one value, and so will the noise");
  }
  const MapExemplar& largest = largestOf(maps).map;
  const auto noteSize = [&](const char* remark) {
    notes.push_back(fmt::format("{} x {} pixels {}; {} to {} per side are best", largest.width,
                                largest.height, remark, kGoodPixels, kPlentyOfPixels));
  };
  if (varies && std::min(largest.width, largest.height) < kGoodPixels)
    noteSize("show little of a material");
  if (std::max(largest.width, largest.height) > kPlentyOfPixels)
    noteSize("take long to bake and need much memory");
}

/// The part inside the frame of the base colour, in pixels of the largest map, with a note.
std::optional<PixelRectangle> withoutFrame(const std::vector<NamedMap>& maps,
                                           const MaterialSetOptions& options,
                                           std::vector<std::string>& notes) {
  const NamedMap* const color = findMap(maps, MapTarget::baseColor);
  if (!options.cutsFrame || options.periodic == Periodic::yes || color == nullptr ||
      findMap(maps, MapTarget::opacity) != nullptr)
    return std::nullopt;
  const std::optional<PixelRectangle> inside = insideOfFrame(color->map);
  if (!inside)
    return std::nullopt;
  const MapExemplar& largest = largestOf(maps).map;
  const double x = double(largest.width) / color->map.width;
  const double y = double(largest.height) / color->map.height;
  const auto first = [](int pixel, double by) { return int(std::ceil(pixel * by)); };
  const auto behind = [](int pixel, double by) { return int(std::floor(pixel * by)); };
  const int left = first(inside->x, x), right = behind(inside->x + inside->width, x);
  const int top = first(inside->y, y), bottom = behind(inside->y + inside->height, y);
  const PixelRectangle part{left, top, right - left, bottom - top};
  notes.push_back(fmt::format("{}: a frame is cut off, which leaves {} x {} pixels from column {} "
                              "and row {} on; a crop of all {} x {} pixels keeps it",
                              color->name, part.width, part.height, part.x, part.y, largest.width,
                              largest.height));
  return part;
}

FileRole plainNormal(const MaterialSetOptions& options) {
  return options.normal == NormalConvention::directX ? FileRole::normalDx : FileRole::normalGl;
}

/// The maps of the files that were found. Throws std::bad_alloc.
Result<MaterialSet> readMaps(const Result<SetFiles>& found, const MaterialSetOptions& options,
                             const Decode& decode) {
  if (!found)
    return found.error();
  const SetFiles& files = found.value();
  MaterialSet set{files.name, {}, options.periodic, {}, files.notes};
  std::vector<NamedMap> maps;
  for (const SetFile& file : files.files)
    if (Result<void> read = appendMaps(file, files, options, decode, maps, set.notes); !read)
      return read.error();
  if (Result<void> checked = checkOneOpacity(maps); !checked)
    return checked.error();
  set.crop = options.crop ? options.crop : withoutFrame(maps, options, set.notes);
  if (set.crop)
    if (Result<void> done = crop(maps, *set.crop); !done)
      return done.error();
  fillInvisibleColors(maps);
  const bool wraps =
      options.periodic == Periodic::yes || (options.periodic == Periodic::detect &&
                                            std::ranges::all_of(maps, isPeriodic, &NamedMap::map));
  if (options.size) {
    if (Result<void> done = resize(maps, *options.size, wraps, set.notes); !done)
      return done.error();
    set.periodic = wraps ? Periodic::yes : Periodic::no;
  }
  joinChannels(maps, wraps, set.notes);
  noteContent(maps, set.notes);
  for (NamedMap& named : maps)
    set.maps.push_back(std::move(named.map));
  return set;
}

} // namespace

Result<MaterialSet> readMaterialSet(std::span<const std::filesystem::path> inputs,
                                    const MaterialSetOptions& options) {
  const auto exhausted = [&] {
    return (inputs.empty() ? std::string() : inputs.front().string() + ": ") +
           "not enough memory to read the images";
  };
  const auto decode = [&](const std::filesystem::path& path) {
    SizeCheck check;
    if (options.sizeCheck)
      check = [&](int width, int height) { return options.sizeCheck(path, width, height); };
    return readImage(path, check);
  };
  return withinMemory(exhausted, [&] {
    return readMaps(findSetFiles(inputs, plainNormal(options)), options, decode);
  });
}

Result<MaterialSet> materialSetOf(std::vector<Photograph> photographs,
                                  const MaterialSetOptions& options) {
  // Images of the same name have the same role, which is refused.
  const auto decode = [&](const std::filesystem::path& name) -> Result<ImageFile> {
    return std::move(std::ranges::find(photographs, name.string(), &Photograph::name)->image);
  };
  return withinMemory([] { return "not enough memory for the images"; },
                      [&] {
                        std::vector<std::filesystem::path> names;
                        for (const Photograph& photograph : photographs)
                          names.emplace_back(photograph.name);
                        return readMaps(chooseSetFiles(names, plainNormal(options)), options,
                                        decode);
                      });
}

} // namespace lichen
