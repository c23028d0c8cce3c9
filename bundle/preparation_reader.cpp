// SPDX-License-Identifier: MIT
// Reads how the exemplar of a noise was made.
#include "extension_reader.h"

#include <algorithm>

namespace lichen {
namespace {

template <std::size_t N>
using Pixels = std::array<std::uint32_t, N>;

/// An array of N integers from `least` to kMaxTableSide.
template <std::size_t N>
std::optional<Pixels<N>> readPixels(ObjectReader& reader, const char* key,
                                    const std::array<double, N>& least) {
  const auto values = reader.numbers(key, {0.0, double(kMaxTableSide)});
  if (!values)
    return std::nullopt;
  Pixels<N> pixels{};
  const auto fits = [](double value, double smallest) {
    return value >= smallest && value == double(std::uint32_t(value));
  };
  if (values->size() != N || !std::ranges::equal(*values, least, fits)) {
    reader.error("preparation-pixels", key,
                 "expected " + std::to_string(N) + " whole numbers" +
                     (least.back() > 0.0 ? ", sides at least 1" : ""));
    return std::nullopt;
  }
  std::ranges::transform(*values, pixels.begin(),
                         [](double value) { return std::uint32_t(value); });
  return pixels;
}

template <std::size_t N>
std::optional<Pixels<N>> readPixelsIfAny(ObjectReader& reader, const char* key,
                                         const std::array<double, N>& least) {
  return reader.has(key) ? readPixels(reader, key, least) : std::nullopt;
}

/// Whether the member has the only value that it may have.
bool readChoice(ObjectReader& reader, const char* key, std::string_view only) {
  if (!reader.has(key))
    return false;
  const std::optional<std::string> name = reader.text(key);
  if (name && *name != only)
    reader.error("preparation-choice", key, quoted(*name) + "; expected " + std::string(only));
  return name == only;
}

void readFlattened(ObjectReader reader, Preparation& preparation) {
  preparation.flattenPeriod = reader.number("period", kFlattenPeriodRange).value_or(0.0);
  const nlohmann::json* maps = reader.array("maps", kMaxMaps);
  for (std::size_t i = 0; maps != nullptr && i < maps->size(); ++i) {
    const nlohmann::json& name = (*maps)[i];
    const std::string* text = name.is_string() ? name.get_ptr<const std::string*>() : nullptr;
    const std::optional<MapTarget> target = text != nullptr ? mapTargetFrom(*text) : std::nullopt;
    if (target && target != MapTarget::opacity &&
        std::ranges::count(preparation.flattened, *target) == 0)
      preparation.flattened.push_back(*target);
    else
      reader.error("preparation-maps", ("maps/" + std::to_string(i)).c_str(),
                   (text != nullptr ? quoted(*text) : std::string(name.type_name())) +
                       "; expected another target but opacity");
  }
  reader.warnOfUnknown();
}

void readFilled(ObjectReader& reader, FindingList& findings, Preparation& preparation) {
  const nlohmann::json* places = reader.array("filled", kMaxFilledPlaces);
  for (std::size_t i = 0; places != nullptr && i < places->size(); ++i) {
    ObjectReader place((*places)[i], reader.pointerTo("filled") + "/" + std::to_string(i),
                       findings);
    const auto replaced = readPixels<4>(place, "place", {0.0, 0.0, 1.0, 1.0});
    const auto from = readPixels<2>(place, "from", {0.0, 0.0});
    if (replaced && from)
      preparation.filled.push_back({*replaced, *from});
    place.warnOfUnknown();
  }
}

/// Eight numbers, x and y of each.
std::optional<TileCorners> readCorners(ObjectReader& reader) {
  const auto numbers = reader.numbers("corners", {0.0, double(kMaxTableSide)});
  if (!numbers)
    return std::nullopt;
  TileCorners corners{};
  for (std::size_t k = 0; k < numbers->size() && k < 2 * corners.size(); ++k)
    corners[k / 2][k % 2] = (*numbers)[k];
  if (numbers->size() == 2 * corners.size() && areConvex(corners))
    return corners;
  reader.error("preparation-corners", "corners",
               "expected x and y of upper left, upper right, lower right and lower left corner of "
               "a convex quadrilateral");
  return std::nullopt;
}

} // namespace

Preparation readPreparation(ObjectReader& noise, FindingList& findings) {
  Preparation preparation;
  const nlohmann::json* member = noise.optional("preparation");
  if (member == nullptr)
    return preparation;
  ObjectReader reader(*member, noise.pointerTo("preparation"), findings);
  preparation.crop = readPixelsIfAny<4>(reader, "crop", {0.0, 0.0, 1.0, 1.0});
  preparation.size = readPixelsIfAny<2>(reader, "size", {1.0, 1.0});
  preparation.isGreenDown = readChoice(reader, "normals", "directX");
  preparation.usesAlpha = readChoice(reader, "alpha", "opacity");
  if (const nlohmann::json* periodic = reader.optional("periodic")) {
    if (periodic->is_boolean())
      preparation.periodic = periodic->get<bool>();
    else
      reader.error("type", "periodic", std::string(periodic->type_name()) + "; expected a boolean");
  }
  if (const nlohmann::json* flattened = reader.optional("flattened"))
    readFlattened(ObjectReader(*flattened, reader.pointerTo("flattened"), findings), preparation);
  if (reader.has("filled"))
    readFilled(reader, findings, preparation);
  if (reader.has("corners"))
    preparation.corners = readCorners(reader);
  reader.warnOfUnknown();
  return preparation;
}

} // namespace lichen
