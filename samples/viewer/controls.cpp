// SPDX-License-Identifier: MIT
// Step sizes of each quantity, and the texts that describe them.
#include "controls.h"

#include "debug_views.h"
#include "printable.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace lichen::renderer {
namespace {

// Four presses double or halve a factor. Factors are whole powers, so pressing back as often
// restores the value exactly.
constexpr double kStepsToDouble = 4.0;
constexpr double kMostSteps = 24.0; // a factor of 64, the range of every sharpness
constexpr float kExposureStep = 0.25f;
constexpr float kMostExposure = 20.0f;

/// The factor one step away from `factor`.
double stepped(double factor, int step) {
  const double steps = std::round(std::log2(factor) * kStepsToDouble) + step;
  return std::exp2(std::clamp(steps, -kMostSteps, kMostSteps) / kStepsToDouble);
}

/// Cycles through "none" and `count` choices: the choice `step` after `current`.
std::optional<std::size_t> cycle(std::optional<std::size_t> current, std::size_t count, int step) {
  const auto states = std::ptrdiff_t(count) + 1;
  const std::ptrdiff_t state = current ? std::ptrdiff_t(*current) + 1 : 0;
  const std::ptrdiff_t next = (state + step + states) % states;
  return next == 0 ? std::nullopt : std::optional(std::size_t(next - 1));
}

} // namespace

Request Controls::press(Key key) {
  const int step = key.shift ? -1 : 1;
  NoiseChanges& noise = look_.noise;
  switch (key.letter) {
  case 'N':
    noise.seedStep += std::uint32_t(step); // modulo 2^32
    break;
  case 'S':
    noise.scaleFactor = stepped(noise.scaleFactor, step);
    break;
  case 'B':
    noise.blendSharpnessFactor = stepped(noise.blendSharpnessFactor, step);
    break;
  case 'P':
    noise.planeSharpnessFactor = stepped(noise.planeSharpnessFactor, step);
    break;
  case 'C':
    noise.contrastFactor = stepped(noise.contrastFactor, step);
    break;
  case 'A':
    nextTileRotation(step);
    break;
  case 'M':
    nextMapping(step);
    break;
  case 'O':
    nextSpace(step);
    break;
  case 'T':
    nextNoise(step);
    break;
  case 'D':
    nextDebugView(step);
    break;
  case 'E':
    look_.exposureEv =
        std::clamp(look_.exposureEv + float(step) * kExposureStep, -kMostExposure, kMostExposure);
    break;
  case 'R':
    look_ = start_;
    break;
  case 'F':
    return Request::fit;
  case 'W':
    return Request::screenshot;
  case 'H':
    return Request::help;
  case 'Q':
  case kEscape:
    return Request::close;
  default:
    break;
  }
  return Request::none;
}

void Controls::setNoises(std::vector<std::optional<std::string>> noises) {
  noises_ = std::move(noises);
  if (look_.noise.noise && (*look_.noise.noise >= noises_.size() || !noises_[*look_.noise.noise]))
    look_.noise.noise.reset();
}

void Controls::nextNoise(int step) {
  std::optional<std::size_t> next = look_.noise.noise;
  do
    next = cycle(next, noises_.size(), step);
  while (next && !noises_[*next]);
  look_.noise.noise = next ? std::optional(std::uint32_t(*next)) : std::nullopt;
}

void Controls::nextMapping(int step) {
  constexpr std::array kMappings{NoiseMapping::uv, NoiseMapping::triplanar, NoiseMapping::solid};
  std::optional<std::size_t> current;
  if (look_.noise.mapping)
    current = std::size_t(std::find(kMappings.begin(), kMappings.end(), *look_.noise.mapping) -
                          kMappings.begin());
  const std::optional<std::size_t> next = cycle(current, kMappings.size(), step);
  look_.noise.mapping = next ? std::optional(kMappings[*next]) : std::nullopt;
}

void Controls::nextSpace(int step) {
  std::optional<std::size_t> current; // 0: world, 1: object
  if (look_.noise.inObjectSpace)
    current = *look_.noise.inObjectSpace ? 1 : 0;
  const std::optional<std::size_t> next = cycle(current, 2, step);
  look_.noise.inObjectSpace = next ? std::optional(*next == 1) : std::nullopt;
}

void Controls::nextTileRotation(int step) {
  constexpr std::array<std::uint32_t, 3> kSteps{0, 2, 4};
  std::optional<std::size_t> current;
  if (look_.noise.tileRotation)
    current = std::size_t(std::find(kSteps.begin(), kSteps.end(), *look_.noise.tileRotation) -
                          kSteps.begin());
  const std::optional<std::size_t> next = cycle(current, kSteps.size(), step);
  look_.noise.tileRotation = next ? std::optional(kSteps[*next]) : std::nullopt;
}

void Controls::nextDebugView(int step) {
  const std::vector<std::string_view> names = debugViewNames();
  std::optional<std::size_t> current;
  if (!look_.debugView.empty())
    current = std::size_t(std::find(names.begin(), names.end(), look_.debugView) - names.begin());
  const std::optional<std::size_t> next = cycle(current, names.size(), step);
  look_.debugView = next ? std::string(names[*next]) : std::string();
}

std::string Controls::summary() const {
  const NoiseChanges& noise = look_.noise;
  std::string text;
  const auto add = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  const auto addFactor = [&](const char* name, double factor) {
    if (factor != 1.0)
      add(fmt::format("{} x{:.3g}", name, factor));
  };
  if (noise.noise)
    add("noise " + (noises_[*noise.noise]->empty() ? std::to_string(*noise.noise)
                                                   : printable(*noises_[*noise.noise])));
  if (noise.mapping)
    add(*noise.mapping == NoiseMapping::uv ? "mapping uv"
        : *noise.mapping == NoiseMapping::triplanar
            ? "mapping triplanar"
            : "mapping solid (triplanar where unsupported)");
  if (noise.inObjectSpace)
    add(*noise.inObjectSpace ? "object space" : "world space");
  if (noise.seedStep != 0)
    add(fmt::format("seed {:+d}", std::int32_t(noise.seedStep)));
  addFactor("scale", noise.scaleFactor);
  addFactor("blend sharpness", noise.blendSharpnessFactor);
  addFactor("plane sharpness", noise.planeSharpnessFactor);
  addFactor("contrast", noise.contrastFactor);
  if (noise.tileRotation)
    add(*noise.tileRotation == 0 ? "tile rotation none"
        : *noise.tileRotation == 2
            ? "tile rotation half turns"
            : "tile rotation quarter turns (half where tiles are not square)");
  if (look_.exposureEv != 0.0f)
    add(fmt::format("exposure {:+g}", look_.exposureEv));
  if (!look_.debugView.empty())
    add("debug view " + look_.debugView);
  return text;
}

std::string_view Controls::help() {
  return "Keys (Shift reverses the direction):\n"
         "  N  next seed\n"
         "  S  larger scale\n"
         "  B  sharper blending between tiles\n"
         "  P  sharper blending between the planes of triplanar mapping\n"
         "  C  more contrast\n"
         "  A  tile rotation: from the file, none, half turns, quarter turns\n"
         "  M  mapping: from the file, uv, triplanar, solid\n"
         "  O  space of all mappings but uv: from the file, world, object\n"
         "  T  noise: from the file, then each noise of the bundle\n"
         "  D  next debug view\n"
         "  E  more exposure\n"
         "  R  reset all of these\n"
         "  F  reset the camera; with Shift, frame the scene\n"
         "  W  write a screenshot once all frames are rendered\n"
         "  H  print this help\n"
         "  Q  quit, like Escape\n"
         "Mouse: left button orbits, middle or right button pans, wheel zooms\n";
}

} // namespace lichen::renderer
