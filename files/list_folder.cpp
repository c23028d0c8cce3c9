// SPDX-License-Identifier: MIT
// Lists folders through POSIX calls, because libstdc++'s directory iterator terminates the process
// when memory runs out.
#include <lichen/files.h>

#include <algorithm>
#include <cerrno>
#include <dirent.h>
#include <memory>
#include <string_view>
#include <system_error>

namespace lichen {

Result<std::vector<std::filesystem::path>> listFolder(const std::filesystem::path& folder) {
  const auto exhausted = [&] { return folder.string() + ": not enough memory to list the folder"; };
  using Paths = std::vector<std::filesystem::path>;
  return withinMemory(exhausted, [&]() -> Result<Paths> {
    const auto failure = [&](int code) {
      return Error{code == ENOMEM ? ErrorKind::resources : ErrorKind::badInput,
                   folder.string() +
                       ": cannot be listed: " + std::generic_category().message(code)};
    };
    const auto close = [](DIR* opened) { ::closedir(opened); };
    const std::unique_ptr<DIR, decltype(close)> opened(::opendir(folder.c_str()), close);
    if (!opened)
      return failure(errno);
    Paths entries;
    for (;;) {
      errno = 0; // only errno distinguishes the end from a failure
      const dirent* entry = ::readdir(opened.get());
      if (entry == nullptr && errno != 0)
        return failure(errno);
      if (entry == nullptr)
        break;
      const std::string_view name = entry->d_name;
      if (name != "." && name != "..")
        entries.push_back(folder / name);
    }
    std::sort(entries.begin(), entries.end());
    return entries;
  });
}

} // namespace lichen
