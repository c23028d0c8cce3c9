// SPDX-License-Identifier: MIT
// Files of the kernel -> available bytes. Sources: proc(5); Linux,
// Documentation/admin-guide/cgroup-v2.rst.
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

/// Returns the least memory left in the process's group and its ancestors. File pages that the
/// kernel reclaims first count as left.
Bytes leftInGroups(const std::filesystem::path& proc, const std::filesystem::path& cgroup) {
  std::ifstream file(proc / "self/cgroup");
  Bytes left;
  for (std::string line; std::getline(file, line);) // "0::/slice/job"
    for (std::size_t end = line.starts_with("0::") ? line.size() : std::string::npos;
         end != std::string::npos; end = line.rfind('/', end - 1)) {
      const std::filesystem::path folder = cgroup.string() + line.substr(3, end - 3);
      const Bytes limit = numberIn(folder / "memory.max");
      const Bytes used = numberIn(folder / "memory.current");
      const std::uint64_t cache = numberOf("inactive_file", folder / "memory.stat").value_or(0);
      if (limit && used)
        left = least(left, difference(*limit, difference(*used, cache)));
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
