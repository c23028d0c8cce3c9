// SPDX-License-Identifier: MIT
// Polling also works for editors that replace the file and for network folders.
#include "file_watch.h"

namespace lichen::renderer {

std::optional<FileStamp> stampOf(const std::filesystem::path& path) {
  std::error_code error;
  FileStamp stamp;
  stamp.time = std::filesystem::last_write_time(path, error);
  if (error)
    return std::nullopt;
  stamp.bytes = std::filesystem::file_size(path, error);
  return error ? std::nullopt : std::optional(stamp);
}

FileWatch::Change FileWatch::look(std::optional<FileStamp> stamp, Clock::time_point now) {
  nextLook_ = now + kInterval;
  const bool isStable = stamp == seen_;
  seen_ = stamp;
  if (!isStable || stamp == read_)
    return Change::none;
  read_ = stamp;
  return stamp ? Change::written : Change::gone;
}

} // namespace lichen::renderer
