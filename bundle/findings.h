// SPDX-License-Identifier: MIT
// Collects the faults of one file during reading.
#pragma once

#include <lichen/bundle.h>

#include <algorithm>

namespace lichen {

class FindingList {
public:
  void error(std::string code, std::string pointer, std::string message) {
    add({Finding::Severity::error, std::move(code), std::move(pointer), std::move(message)});
  }
  void warn(std::string code, std::string pointer, std::string message) {
    add({Finding::Severity::warning, std::move(code), std::move(pointer), std::move(message)});
  }
  /// Records an existing finding, unless the list already has one with the same pointer and code.
  void repeat(const Finding& known) {
    if (std::none_of(findings_.begin(), findings_.end(), [&](const Finding& each) {
          return each.pointer == known.pointer && each.code == known.code;
        }))
      add(known);
  }
  [[nodiscard]] std::size_t errorCount() const { return errors_; }
  /// The first error, or null.
  [[nodiscard]] const Finding* firstError() const {
    const auto first = std::find_if(findings_.begin(), findings_.end(), [](const Finding& each) {
      return each.severity == Finding::Severity::error;
    });
    return first == findings_.end() ? nullptr : &*first;
  }
  [[nodiscard]] const std::vector<Finding>& all() const { return findings_; }

private:
  void add(Finding finding) {
    // Limits the memory for a file with millions of faults. Errors and warnings have separate
    // limits, so that warnings never hide the first error.
    constexpr std::size_t kMostOfEach = 500;
    std::size_t& count = finding.severity == Finding::Severity::error ? errors_ : warnings_;
    if (count++ < kMostOfEach)
      findings_.push_back(std::move(finding));
  }

  std::vector<Finding> findings_;
  std::size_t errors_ = 0;
  std::size_t warnings_ = 0;
};

/// "TITLE: POINTER: MESSAGE"; resources if the code is "memory", otherwise badInput.
[[nodiscard]] Error asError(const Finding& finding, const std::string& title);

/// Text from a file, in quotes, on one line, in ASCII, truncated to about 60 characters.
[[nodiscard]] std::string quoted(const std::string& text);

} // namespace lichen
