// SPDX-License-Identifier: MIT
// Maps keys to changes of the view and to requests. No window, no device.
#pragma once

#include "noise_changes.h"

#include <string>
#include <string_view>

namespace lichen::renderer {

/// The settings of the view that keys change.
struct Look {
  NoiseChanges noise;
  std::string debugView; ///< empty, or one of debugViewNames()
  float exposureEv = 0.0f;
  [[nodiscard]] bool operator==(const Look&) const = default;
};

/// What a key asks the viewer to do besides changing the look.
enum class Request { none, fit, screenshot, help, close };

inline constexpr char kEscape = '\x1b';

/// A key: its upper-case letter, or kEscape.
struct Key {
  char letter = 0;
  bool shift = false; ///< reverses the direction of the change
};

class Controls {
public:
  explicit Controls(const Look& start) : start_(start), look_(start) {}

  /// Changes the look, or returns a request. Unassigned keys do nothing.
  Request press(Key key);
  [[nodiscard]] const Look& look() const { return look_; }

  /// Differences from the file, such as "seed +1, scale x1.19"; empty if there are none.
  [[nodiscard]] std::string summary() const;
  /// The help text, with one line per key.
  [[nodiscard]] static std::string_view help();

private:
  void nextMapping(int step);
  void nextDebugView(int step);

  Look start_;
  Look look_;
};

} // namespace lichen::renderer
