// SPDX-License-Identifier: MIT
// What a test does in a process of its own, because it cannot be undone.
#pragma once

#include <catch2/catch.hpp>

#include <csignal>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lichen {

/// Runs `operation`, which returns an exit code, in a child process. Returns what waitpid() says: 0
/// if the code is 0.
template <class Operation>
int childStatus(const Operation& operation) {
  const pid_t child = ::fork();
  if (child == 0)
    ::_exit(operation());
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  return status;
}

/// Limits the sizes of files, which simulates a full disk.
inline bool limitFiles(rlim_t bytes) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit = {bytes, bytes};
  return ::setrlimit(RLIMIT_FSIZE, &limit) == 0;
}

} // namespace lichen
