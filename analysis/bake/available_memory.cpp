// SPDX-License-Identifier: MIT
// Files of the kernel -> available bytes. Sources: proc(5); Linux,
// Documentation/admin-guide/cgroup-v2.rst and cgroup-v1/memory.rst.
#include <lichen/bake_memory.h>

#include <algorithm>
#include <fstream>
#include <string>

#if defined(__linux__)
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace lichen {
namespace {

using Bytes = std::optional<std::uint64_t>;

Bytes least(Bytes a, Bytes b) { return a && b ? std::min(*a, *b) : a ? a : b; }

std::uint64_t difference(std::uint64_t a, std::uint64_t b) { return a > b ? a - b : 0; }

/// Returns the number in a file that contains nothing else; nothing for "max".
Bytes numberIn(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::uint64_t number = 0;
  return file >> number ? Bytes(number) : std::nullopt;
}

/// Returns the number after a key at the start of a line.
Bytes numberOf(const std::string& key, const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string word;
  std::uint64_t number = 0;
  while (file >> word)
    if (word == key && file >> number)
      return number;
  return std::nullopt;
}

/// The file names of a control group version.
struct GroupFiles {
  const char* limit;
  const char* used;
  const char* cache; ///< in memory.stat: file pages that the kernel reclaims first
};
constexpr GroupFiles kVersion1{"memory.limit_in_bytes", "memory.usage_in_bytes",
                               "total_inactive_file"};
constexpr GroupFiles kVersion2{"memory.max", "memory.current", "inactive_file"};

/// Returns the least memory left in a group and its ancestors.
Bytes leftIn(const std::filesystem::path& root, std::string group, const GroupFiles& files) {
  Bytes left;
  for (;; group.erase(group.rfind('/'))) {
    const std::filesystem::path folder = root.string() + group;
    const Bytes limit = numberIn(folder / files.limit), used = numberIn(folder / files.used);
    const std::uint64_t cache = numberOf(files.cache, folder / "memory.stat").value_or(0);
    if (limit && used)
      left = least(left, difference(*limit, difference(*used, cache)));
    if (group.rfind('/') == std::string::npos)
      return left;
  }
}

/// Parses lines "number:controllers:group"; version 2 writes "0::group".
Bytes leftInGroups(const std::filesystem::path& proc, const std::filesystem::path& cgroup) {
  std::ifstream file(proc / "self/cgroup");
  Bytes left;
  for (std::string line; std::getline(file, line);) {
    const std::size_t first = line.find(':'), second = line.find(':', first + 1);
    if (second == std::string::npos)
      continue;
    const std::string controllers = "," + line.substr(first + 1, second - first - 1) + ",";
    const std::string group = line.substr(second + 1);
    if (controllers == ",,")
      left = least(left, leftIn(cgroup, group, kVersion2));
    else if (controllers.find(",memory,") != std::string::npos)
      left = least(left, leftIn(cgroup / "memory", group, kVersion1));
  }
  return left;
}

/// Returns what is left of the process's address space; nothing if it is not limited.
Bytes leftInAddressSpace([[maybe_unused]] const std::filesystem::path& proc) {
#if defined(__linux__)
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
    return std::nullopt;
  const Bytes pages = numberIn(proc / "self/statm");
  return difference(limit.rlim_cur,
                    pages.value_or(0) * std::uint64_t(std::max(0L, sysconf(_SC_PAGESIZE))));
#else
  return std::nullopt;
#endif
}

} // namespace

std::optional<std::uint64_t> availableMemory(const std::filesystem::path& proc,
                                             const std::filesystem::path& cgroup) {
  constexpr std::uint64_t kKibi = 1024;
  Bytes available = numberOf("MemAvailable:", proc / "meminfo");
  if (available)
    *available *= kKibi;
  return least(least(available, leftInGroups(proc, cgroup)), leftInAddressSpace(proc));
}

} // namespace lichen
