// SPDX-License-Identifier: MIT
// Whole files in and out; a failed write leaves the old file whole and no partial one.
#include "temporary_folder.h"

#include <lichen/files.h>

#include <catch2/catch.hpp>

#include <csignal>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace lichen;

namespace {

using Bytes = std::vector<std::byte>;

Bytes patternOf(std::size_t size) {
  Bytes bytes(size);
  for (std::size_t i = 0; i < size; ++i)
    bytes[i] = std::byte(i * 31 % 251);
  return bytes;
}

} // namespace

TEST_CASE("a written file is read back byte for byte, empty ones too") {
  const TemporaryFolder folder;
  for (const std::size_t size : {0u, 1u, 4096u, 1000003u}) {
    REQUIRE(replaceFile(folder / "file", patternOf(size)));
    CHECK(readFile(folder / "file").value() == patternOf(size));
    CHECK(folder.entryCount() == 1);
  }
}

TEST_CASE("a new file has the permissions that the process gives new files") {
  const TemporaryFolder folder;
  const mode_t old = ::umask(0027);
  const Result<void> written = replaceFile(folder / "file", patternOf(10));
  ::umask(old);
  REQUIRE(written);
  struct stat status {};
  REQUIRE(::stat((folder / "file").c_str(), &status) == 0);
  CHECK((status.st_mode & 0777) == 0640);
}

TEST_CASE("what is not a readable regular file is refused with the reason") {
  const TemporaryFolder folder;
  const std::string path = (folder / "absent").string();
  CHECK(readFile(folder / "absent").error().kind == ErrorKind::badInput);
  CHECK(readFile(folder / "absent").error().message ==
        path + ": cannot be read: No such file or directory");
  CHECK(readFile(folder.path()).error().message ==
        folder.path().string() + ": is a folder; a file is accepted");
  CHECK(readFile("/dev/zero").error().message == "/dev/zero: not a regular file");
}

TEST_CASE("a named pipe without a writer is refused instead of waited for") {
  const TemporaryFolder folder;
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  ::alarm(10); // ends the test when it hangs
  CHECK(readFile(folder / "pipe").error().message ==
        (folder / "pipe").string() + ": not a regular file");
  ::alarm(0);
}

TEST_CASE("a file longer than the caller accepts is refused with both sizes") {
  const TemporaryFolder folder;
  REQUIRE(replaceFile(folder / "file", patternOf(100)));
  CHECK(readFile(folder / "file", 100));
  CHECK(readFile(folder / "file", 99).error().message ==
        (folder / "file").string() + ": 100 bytes; at most 99 are accepted");
}

TEST_CASE("the start of a file is read, and a file that is shorter refused with both sizes") {
  const TemporaryFolder folder;
  REQUIRE(replaceFile(folder / "file", patternOf(100)));
  for (const std::size_t size : {0u, 7u, 100u})
    CHECK(readFileStart(folder / "file", size).value() == patternOf(size));
  const Result<Bytes> longer = readFileStart(folder / "file", 101);
  CHECK(longer.error().kind == ErrorKind::badInput);
  CHECK(longer.error().message ==
        (folder / "file").string() + ": 100 bytes; at least 101 are accepted");
}

TEST_CASE("processes that write one file at the same time do not disturb each other") {
  const TemporaryFolder folder;
  std::vector<pid_t> children;
  for (int c = 0; c < 4; ++c) {
    children.push_back(::fork());
    if (children.back() == 0) {
      bool written = true;
      for (int i = 0; i < 50; ++i)
        written = written && replaceFile(folder / "file", patternOf(1000)).ok();
      ::_exit(written ? 0 : 1);
    }
  }
  for (const pid_t child : children) {
    int status = 0;
    REQUIRE(::waitpid(child, &status, 0) == child);
    CHECK(WIFEXITED(status));
    CHECK(WEXITSTATUS(status) == 0);
  }
  CHECK(readFile(folder / "file").value() == patternOf(1000));
  CHECK(folder.entryCount() == 1);
}

TEST_CASE("writing into an absent folder fails as the environment's fault") {
  const TemporaryFolder folder;
  const Result<void> result = replaceFile(folder / "absent/file", patternOf(10));
  CHECK(result.error().kind == ErrorKind::environment);
  CHECK(result.error().message ==
        (folder / "absent/file").string() + ": cannot be written: No such file or directory");
}

TEST_CASE("writing over a folder fails and leaves nothing behind") {
  const TemporaryFolder folder;
  REQUIRE(std::filesystem::create_directory(folder / "target"));
  REQUIRE(replaceFile(folder / "target/inside", patternOf(10)));
  const Result<void> result = replaceFile(folder / "target", patternOf(10));
  CHECK(result.error().kind == ErrorKind::environment);
  CHECK(result.error().message ==
        (folder / "target").string() + ": cannot be written: Is a directory");
  CHECK(readFile(folder / "target/inside").value() == patternOf(10));
  CHECK(folder.entryCount() == 1);
}

TEST_CASE("a write that does not fit leaves the old file whole and no partial one") {
  const TemporaryFolder folder;
  REQUIRE(replaceFile(folder / "file", patternOf(100)));
  // A limit on file size stands for a full disk; in a child, for it cannot be raised again.
  const pid_t child = ::fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit = {4096, 4096};
    if (::setrlimit(RLIMIT_FSIZE, &limit) != 0)
      ::_exit(100);
    const Result<void> result = replaceFile(folder / "file", patternOf(100000));
    const bool asExpected = !result && result.error().kind == ErrorKind::resources &&
                            result.error().message ==
                                (folder / "file").string() + ": cannot be written: File too large";
    ::_exit(asExpected ? 0 : 1);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(readFile(folder / "file").value() == patternOf(100));
  CHECK(folder.entryCount() == 1);
}

TEST_CASE("a process that is killed while it writes leaves the old file whole and no other") {
  const TemporaryFolder folder;
  REQUIRE(replaceFile(folder / "file", patternOf(100)));
  const pid_t child = ::fork();
  if (child == 0) {
    // Without a handler the signal of the write beyond the limit ends the process in its midst.
    std::signal(SIGXFSZ, SIG_DFL);
    const rlimit limit = {4096, 4096};
    const rlimit noCore = {0, 0};
    if (::setrlimit(RLIMIT_CORE, &noCore) == 0 && ::setrlimit(RLIMIT_FSIZE, &limit) == 0)
      static_cast<void>(replaceFile(folder / "file", patternOf(100000)));
    ::_exit(100);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == SIGXFSZ);
  CHECK(readFile(folder / "file").value() == patternOf(100));
  CHECK(folder.entryCount() == 1);
}

TEST_CASE("a folder is listed in order, and what is no folder is refused") {
  const TemporaryFolder folder;
  CHECK(listFolder(folder.path()).value().empty());
  for (const char* name : {"b", "a", ".c"})
    REQUIRE(replaceFile(folder / name, patternOf(1)));
  CHECK(listFolder(folder.path()).value() ==
        std::vector{folder / ".c", folder / "a", folder / "b"});
  for (const auto& path : {folder / "a", folder / "absent"}) {
    const auto refused = listFolder(path);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().kind == ErrorKind::badInput);
    CHECK(refused.error().message.starts_with(path.string() + ": cannot be listed: "));
  }
}
