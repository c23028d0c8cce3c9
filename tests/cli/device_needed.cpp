// SPDX-License-Identifier: MIT
#define CATCH_CONFIG_EXTERNAL_INTERFACES
#include "device_needed.h"

#include "checkout_paths.h"

#include <catch2/catch.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <sys/wait.h>

namespace lichen::cli_test {
namespace {

constexpr int kSkipped = 77;    // SKIP_RETURN_CODE of these tests
constexpr int kEnvironment = 4; // exit code of the programs; docs/cli.md

int skippedCases = 0;

struct Devices {
  int exitCode = -1;
  std::string output; ///< standard output and standard error
};

Devices listedDevices() {
  Devices devices;
  FILE* pipe = ::popen(("'" + programPath("lichen-render") + "' --list-devices 2>&1").c_str(), "r");
  REQUIRE(pipe != nullptr);
  std::array<char, 4096> buffer;
  while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), pipe))
    devices.output.append(buffer.data(), count);
  const int status = ::pclose(pipe);
  devices.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return devices;
}

/// Sets the exit code of a run in which cases were skipped and none failed.
class SkippedRun : public Catch::TestEventListenerBase {
public:
  using TestEventListenerBase::TestEventListenerBase;
  void testRunEnded(const Catch::TestRunStats& run) override {
    if (skippedCases == 0 || !run.totals.testCases.allPassed())
      return;
    std::fprintf(stderr, "skipped: no Vulkan device for %d of %zu cases; the others passed\n",
                 skippedCases, run.totals.testCases.total());
    std::exit(kSkipped);
  }
};
CATCH_REGISTER_LISTENER(SkippedRun)

} // namespace

bool hasDevice() {
  static const Devices devices = listedDevices();
  if (devices.exitCode == 0)
    return true;
  INFO(devices.output);
  REQUIRE(devices.exitCode == kEnvironment);
  REQUIRE(devices.output.find("no Vulkan device") != std::string::npos);
  ++skippedCases;
  return false;
}

} // namespace lichen::cli_test
