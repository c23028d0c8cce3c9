// SPDX-License-Identifier: MIT
// Whether a file has changed since it was read, once whoever writes it has done.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace lichen::renderer {

/// What of a file changes when it is written.
struct FileStamp {
  std::filesystem::file_time_type time;
  std::uintmax_t bytes = 0;
  [[nodiscard]] bool operator==(const FileStamp&) const = default;
};

/// Nothing where there is no file.
[[nodiscard]] std::optional<FileStamp> stampOf(const std::filesystem::path& path);

class FileWatch {
public:
  using Clock = std::chrono::steady_clock;
  /// Between two looks at the file; a file is being written until two looks in turn see it alike.
  static constexpr std::chrono::milliseconds kInterval{200};

  explicit FileWatch(std::optional<FileStamp> read) : read_(read), seen_(read) {}

  /// Whether a look is due.
  [[nodiscard]] bool isDue(Clock::time_point now) const { return now >= nextLook_; }
  enum class Change { none, written, gone };
  /// A look at the file. Tells each change once, when two looks in turn have seen it.
  [[nodiscard]] Change look(std::optional<FileStamp> stamp, Clock::time_point now);

private:
  std::optional<FileStamp> read_;
  std::optional<FileStamp> seen_;
  Clock::time_point nextLook_;
};

} // namespace lichen::renderer
