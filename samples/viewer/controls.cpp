// SPDX-License-Identifier: MIT
// Step sizes of each quantity, and the texts that describe them.
#include "controls.h"

#include "debug_views.h"

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
constexpr double kMostSteps = 24.0; // a factor of 64
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
  case 'C':
    noise.contrastFactor = stepped(noise.contrastFactor, step);
    break;
  case 'M':
    nextMapping(step);
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

void Controls::nextMapping(int step) {
  constexpr std::array kMappings{NoiseMapping::uv, NoiseMapping::triplanar, NoiseMapping::solid};
  std::optional<std::size_t> current;
  if (look_.noise.mapping)
    current = std::size_t(std::find(kMappings.begin(), kMappings.end(), *look_.noise.mapping) -
                          kMappings.begin());
  const std::optional<std::size_t> next = cycle(current, kMappings.size(), step);
  look_.noise.mapping = next ? std::optional(kMappings[*next]) : std::nullopt;
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
  if (noise.mapping)
    add(*noise.mapping == NoiseMapping::uv ? "mapping uv"
        : *noise.mapping == NoiseMapping::triplanar
            ? "mapping triplanar"
            : "mapping solid (triplanar where unsupported)");
  if (noise.seedStep != 0)
    add(fmt::format("seed {:+d}", std::int32_t(noise.seedStep)));
  addFactor("scale", noise.scaleFactor);
  addFactor("contrast", noise.contrastFactor);
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
         "  C  more contrast\n"
         "  M  mapping: from the file, uv, triplanar, solid\n"
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
