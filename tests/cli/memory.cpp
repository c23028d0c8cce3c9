// SPDX-License-Identifier: MIT
// availableMemory(), and `lichen bake` on images that need more than that.
#include "command_run.h"

#include <lichen/bake_memory.h>

#include <catch2/catch.hpp>

#include <fstream>

using namespace lichen;
using namespace lichen::cli_test;

namespace {

/// A fake copy of the kernel's files.
class Kernel {
public:
  void write(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = folder_.path() / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  [[nodiscard]] std::optional<std::uint64_t> available() const {
    return availableMemory(folder_ / "proc", folder_ / "cgroup");
  }

private:
  TemporaryFolder folder_;
};

constexpr std::uint64_t kMega = 1u << 20;

} // namespace

TEST_CASE("available memory is the least of the machine's and of each control group's rest") {
  const Kernel kernel;
  CHECK(!kernel.available());
  kernel.write("proc/meminfo", "MemTotal:  4096 kB\nMemFree: 1 kB\nMemAvailable:  3072 kB\n");
  CHECK(kernel.available() == 3 * kMega);
  kernel.write("proc/self/cgroup", "1:name=systemd:/\n0::/slice/job\n");
  kernel.write("cgroup/slice/job/memory.max", "max\n");
  kernel.write("cgroup/slice/job/memory.current", "1048576\n");
  CHECK(kernel.available() == 3 * kMega);
  kernel.write("cgroup/slice/memory.max", "3145728\n");
  kernel.write("cgroup/slice/memory.current", "2097152\n");
  CHECK(kernel.available() == kMega);
  kernel.write("cgroup/slice/memory.stat", "anon 1\ninactive_file 524288\n");
  CHECK(kernel.available() == kMega + kMega / 2);
  kernel.write("cgroup/slice/job/memory.max", "1048576\n");
  CHECK(kernel.available() == 0u);
}

// The sanitizers reserve more address space than any limit here.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_CASE("an image that needs more memory than is available is an error before decoding") {
  const Workplace workplace;
  const std::string large = workplace.write("large.png", SrgbImage(4096, 4096, 1));
  const Limits limits{.memoryBytes = 1024 * kMega};
  const auto bake = [&](const Arguments& more) {
    return runLichen(Arguments{"bake", large, "-o", workplace.path("new.glb")} + more, limits);
  };
  const Ended ended = bake({});
  CHECK(ended.code == kResources);
  CHECK_THAT(ended.errors, Catch::Contains("large.png: 4096 x 4096 pixels need about") &&
                               Catch::Contains("GB are available; use --crop or --size"));
  CHECK(bake({"--size", "32"}).code == 0);
  CHECK(bake({"--crop", "0,0,32,32"}).code == 0);
  const Ended enlarged = runLichen({"bake", workplace.write("small.png", SrgbImage(32, 32, 1)),
                                    "-o", workplace.path("new.glb"), "--size", "4096"},
                                   limits);
  CHECK(enlarged.code == kResources);
  CHECK_THAT(enlarged.errors, Catch::Contains("32 x 32 pixels, enlarged by --size, need about") &&
                                  Catch::Contains("use a smaller --size"));
}
#endif
