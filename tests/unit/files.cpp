// SPDX-License-Identifier: MIT
// Reads and writes whole files; a failed write leaves the old file intact and no temporary file.
#include "child_process.h"
#include "temporary_folder.h"

#include <lichen/files.h>

#include <catch2/catch.hpp>

#include <string>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

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

TEST_CASE("a written file reads back byte for byte, even an empty one") {
  const TemporaryFolder folder;
  for (const std::size_t size : {0u, 1u, 4096u, 1000003u}) {
    REQUIRE(replaceFile(folder / "file", patternOf(size)));
    CHECK(readFile(folder / "file").value() == patternOf(size));
    CHECK(folder.entryCount() == 1);
  }
}

TEST_CASE("a new file has the process's default permissions") {
  const TemporaryFolder folder;
  const mode_t old = ::umask(0027);
  const Result<void> written = replaceFile(folder / "file", patternOf(10));
  ::umask(old);
  REQUIRE(written);
  struct stat status {};
  REQUIRE(::stat((folder / "file").c_str(), &status) == 0);
  CHECK((status.st_mode & 0777) == 0640);
}

TEST_CASE("reading anything except a readable regular file is an error with the reason") {
  const TemporaryFolder folder;
  const std::string path = (folder / "absent").string();
  CHECK(readFile(folder / "absent").error().kind == ErrorKind::badInput);
  CHECK(readFile(folder / "absent").error().message ==
        path + ": cannot be read: No such file or directory");
  CHECK(readFile(folder.path()).error().message ==
        folder.path().string() + ": is a folder; expected a file");
  CHECK(readFile("/dev/zero").error().message == "/dev/zero: is not a regular file");
  REQUIRE(replaceFile(folder / "file", patternOf(10)));
  CHECK(readFile(folder / "file/inside").error().message ==
        (folder / "file/inside").string() + ": cannot be read: Not a directory");
  std::filesystem::create_symlink("link", folder / "link");
  CHECK(readFile(folder / "link").error().message ==
        (folder / "link").string() + ": cannot be read: Too many levels of symbolic links");
}

TEST_CASE("a file that the user may not read is an error that says so") {
  const TemporaryFolder folder;
  REQUIRE(replaceFile(folder / "file", patternOf(10)));
  REQUIRE(::chmod((folder / "file").c_str(), 0) == 0);
  const int status = childStatus([&] { // gives up the permissions of root, if it has them
    constexpr uid_t kNobody = 65534;
    if (::geteuid() == 0 && (::chmod(folder.path().c_str(), 0755) != 0 || ::seteuid(kNobody) != 0))
      return 100;
    const Result<Bytes> read = readFile(folder / "file");
    const std::string message = (folder / "file").string() + ": cannot be read: Permission denied";
    return !read && read.error().message == message ? 0 : 1;
  });
  CHECK(status == 0);
}

TEST_CASE("a named pipe without a writer is an error, without waiting") {
  const TemporaryFolder folder;
  REQUIRE(::mkfifo((folder / "pipe").c_str(), 0600) == 0);
  ::alarm(10); // kills the test if it hangs
  CHECK(readFile(folder / "pipe").error().message ==
        (folder / "pipe").string() + ": is not a regular file");
  ::alarm(0);
}

TEST_CASE("reading a socket is an error") {
  const TemporaryFolder folder;
  const std::string path = (folder / "socket").string();
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  REQUIRE(path.size() < sizeof(address.sun_path));
  path.copy(address.sun_path, path.size());
  const int socket = ::socket(AF_UNIX, SOCK_STREAM, 0);
  REQUIRE(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) == 0);
  CHECK(readFile(path).error().message == path + ": is not a regular file");
  ::close(socket);
}

TEST_CASE("the error for a file that is too long states both sizes") {
  const TemporaryFolder folder;
  REQUIRE(replaceFile(folder / "file", patternOf(100)));
  CHECK(readFile(folder / "file", 100));
  CHECK(readFile(folder / "file", 99).error().message ==
        (folder / "file").string() + ": has 100 bytes; expected at most 99");
}

TEST_CASE("readFileStart() reads the start, and its error for a shorter file states both sizes") {
  const TemporaryFolder folder;
  REQUIRE(replaceFile(folder / "file", patternOf(100)));
  for (const std::size_t size : {0u, 7u, 100u})
    CHECK(readFileStart(folder / "file", size).value() == patternOf(size));
  const Result<Bytes> longer = readFileStart(folder / "file", 101);
  CHECK(longer.error().kind == ErrorKind::badInput);
  CHECK(longer.error().message ==
        (folder / "file").string() + ": has 100 bytes; expected at least 101");
}

TEST_CASE("processes that write the same file at the same time do not interfere") {
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

TEST_CASE("the error for a folder that cannot take output says why") {
  const TemporaryFolder folder;
  REQUIRE(replaceFile(folder / "file", patternOf(10)));
  CHECK(checkFolder(folder.path()));
  CHECK(checkFolder(""));
  for (const auto& [name, reason] :
       {std::pair("absent", ": the folder does not exist; create it first"),
        {"file", ": is a file; expected a folder"},
        {"file/inside", ": cannot be used: Not a directory"}}) {
    const Result<void> checked = checkFolder(folder / name);
    REQUIRE_FALSE(checked);
    CHECK(checked.error().kind == ErrorKind::environment);
    CHECK(checked.error().message == (folder / name).string() + reason);
  }
}

TEST_CASE("writing into a folder that does not exist is an environment error") {
  const TemporaryFolder folder;
  const Result<void> result = replaceFile(folder / "absent/file", patternOf(10));
  CHECK(result.error().kind == ErrorKind::environment);
  CHECK(result.error().message ==
        (folder / "absent/file").string() + ": cannot be written: No such file or directory");
}

TEST_CASE("writing over a folder fails and leaves no temporary file") {
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

TEST_CASE("a write that does not fit leaves the old file intact and no temporary file") {
  const TemporaryFolder folder;
  REQUIRE(replaceFile(folder / "file", patternOf(100)));
  const int status = childStatus([&] {
    if (!limitFiles(4096))
      return 100;
    const Result<void> result = replaceFile(folder / "file", patternOf(100000));
    const std::string message = (folder / "file").string() + ": cannot be written: File too large";
    return !result && result.error().kind == ErrorKind::resources &&
                   result.error().message == message
               ? 0
               : 1;
  });
  CHECK(status == 0);
  CHECK(readFile(folder / "file").value() == patternOf(100));
  CHECK(folder.entryCount() == 1);
}

TEST_CASE("a process killed while writing leaves the old file intact and no temporary file") {
  const TemporaryFolder folder;
  REQUIRE(replaceFile(folder / "file", patternOf(100)));
  const int status = childStatus([&] {
    // Without a handler, the signal of the write beyond the limit kills the process in mid-write.
    const rlimit noCore = {0, 0};
    if (::setrlimit(RLIMIT_CORE, &noCore) == 0 && limitFiles(4096)) {
      std::signal(SIGXFSZ, SIG_DFL);
      static_cast<void>(replaceFile(folder / "file", patternOf(100000)));
    }
    return 100;
  });
  REQUIRE(WIFSIGNALED(status));
  CHECK(WTERMSIG(status) == SIGXFSZ);
  CHECK(readFile(folder / "file").value() == patternOf(100));
  CHECK(folder.entryCount() == 1);
}

TEST_CASE("listFolder() sorts the entries, and fails for anything except a folder") {
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
