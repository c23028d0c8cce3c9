// SPDX-License-Identifier: MIT
// Keys -> what is shown and what is to be done. No window, no device.
#pragma once

#include "noise_changes.h"

#include <string>
#include <string_view>
#include <vector>

namespace lichen::renderer {

/// What keys change of how the scene is shown.
struct Look {
  NoiseChanges noise;
  std::string debugView; ///< empty, or one of debugViewNames()
  float exposureEv = 0.0f;
  [[nodiscard]] bool operator==(const Look&) const = default;
};

/// What a key asks of the viewer beside a change of the look.
enum class Request { none, fit, screenshot, help, close };

inline constexpr char kEscape = '\x1b';

/// A key: its letter in upper case, or kEscape.
struct Key {
  char letter = 0;
  bool shift = false; ///< the other way
};

class Controls {
public:
  /// `noises` are the names of the bundle's.
  Controls(std::vector<std::string> noises, const Look& start)
      : noises_(std::move(noises)), start_(start), look_(start) {}

  /// Changes the look or returns what to do. A key without a meaning does nothing.
  Request press(Key key);
  [[nodiscard]] const Look& look() const { return look_; }
  /// For a file that has changed: a noise that is no longer there is no longer chosen.
  void setNoises(std::vector<std::string> noises);

  /// What differs from the file, such as "seed +1, scale x1.19"; empty where nothing does.
  [[nodiscard]] std::string summary() const;
  /// A line for each key.
  [[nodiscard]] static std::string_view help();

private:
  void nextNoise(int step);
  void nextMapping(int step);
  void nextSpace(int step);
  void nextTileRotation(int step);
  void nextDebugView(int step);

  std::vector<std::string> noises_;
  Look start_;
  Look look_;
};

} // namespace lichen::renderer
