// SPDX-License-Identifier: MIT
// Detects that a file has changed since it was read, once its writer has finished.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace lichen::renderer {

/// The properties of a file that a write changes.
struct FileStamp {
  std::filesystem::file_time_type time;
  std::uintmax_t bytes = 0;
  [[nodiscard]] bool operator==(const FileStamp&) const = default;
};

/// nullopt if the file does not exist.
[[nodiscard]] std::optional<FileStamp> stampOf(const std::filesystem::path& path);

class FileWatch {
public:
  using Clock = std::chrono::steady_clock;
  /// Interval between polls. A file counts as completely written when two polls in a row find the
  /// same stamp.
  static constexpr std::chrono::milliseconds kInterval{200};

  explicit FileWatch(std::optional<FileStamp> read) : read_(read), seen_(read) {}

  /// Whether the next poll is due.
  [[nodiscard]] bool isDue(Clock::time_point now) const { return now >= nextLook_; }
  enum class Change { none, written, gone };
  /// Evaluates one poll. Reports each change once, after two polls in a row have found the same
  /// stamp.
  [[nodiscard]] Change look(std::optional<FileStamp> stamp, Clock::time_point now);

private:
  std::optional<FileStamp> read_;
  std::optional<FileStamp> seen_;
  Clock::time_point nextLook_;
};

} // namespace lichen::renderer
