// SPDX-License-Identifier: MIT
// Whole files, through POSIX calls: only they open a file without waiting, say why that failed,
// make unnamed files and flush to disk.
#include <lichen/counted.h>
#include <lichen/files.h>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <fcntl.h>
#include <new>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace lichen {
namespace {

// Linux transfers at most 0x7ffff000 bytes per call.
constexpr std::size_t kMaxTransfer = std::size_t(1) << 30;

class Descriptor {
public:
  explicit Descriptor(int value) : value_(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (value_ >= 0)
      ::close(value_);
  }
  [[nodiscard]] int get() const { return value_; }
  /// Closes now and returns the result of close(), which may be the first call to report a full
  /// disk.
  [[nodiscard]] int close() {
    const int result = ::close(value_);
    value_ = -1;
    return result;
  }

private:
  int value_;
};

std::string reason(int code) { return std::generic_category().message(code); }

ErrorKind writeErrorKind(int code) {
  return code == ENOSPC || code == EDQUOT || code == EFBIG || code == ENOMEM
             ? ErrorKind::resources
             : ErrorKind::environment;
}

bool writeAll(int descriptor, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), std::min(bytes.size(), kMaxTransfer));
    if (written < 0) {
      if (errno == EINTR)
        continue;
      return false;
    }
    bytes = bytes.subspan(std::size_t(written));
  }
  return true;
}

/// Creates an unnamed file, which disappears when the process ends in any way. Returns -1 if the
/// file system does not support it, such as NFS and FAT.
int openUnnamed([[maybe_unused]] const std::filesystem::path& folder) {
#ifdef O_TMPFILE
  if (::access("/proc/self/fd", X_OK) == 0) // giveName() needs it
    return ::open(folder.empty() ? "." : folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
#endif
  return -1;
}

/// Gives an unnamed file a name. linkat() cannot replace an existing file, so the name must be new.
bool giveName(int descriptor, const std::filesystem::path& name) {
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  return ::linkat(AT_FDCWD, link.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

/// Calls `make` with names next to `path` until it succeeds, and stores that name in `name`.
/// Returns 0 or the errno of the failure. Names are random, because processes in other PID
/// namespaces or on other machines may write to the same folder.
template <class Make>
int makeTemporary(const std::filesystem::path& path, std::filesystem::path& name,
                  const Make& make) {
  constexpr int kMostNames = 16; // of 2^64; a collision means that something else is wrong
  int code = EEXIST;
  for (int attempt = 0; attempt < kMostNames && code == EEXIST; ++attempt) {
    std::uint64_t bits = 0;
    if (::getentropy(&bits, sizeof bits) != 0)
      return errno;
    std::filesystem::path candidate = path;
    candidate += ".part-" + std::to_string(bits);
    code = make(candidate) ? 0 : errno;
    if (code == 0)
      name = std::move(candidate);
  }
  return code;
}

Error unreadable(const std::filesystem::path& path, int code) {
  return Error{ErrorKind::badInput, path.string() + ": cannot be read: " + reason(code)};
}

/// The message for when even a name or a message does not fit into memory.
auto exhausted(const std::filesystem::path& path) {
  return [&path] { return path.string() + ": not enough memory"; };
}

/// Reads `bytes.size()` bytes, or up to the end of the file. Returns the number of bytes read, or
/// -1 with errno.
ssize_t readAll(int descriptor, std::span<std::byte> bytes) {
  std::size_t total = 0;
  while (total < bytes.size()) {
    const std::size_t wanted = std::min(bytes.size() - total, kMaxTransfer);
    const ssize_t count = ::read(descriptor, bytes.data() + total, wanted);
    if (count < 0 && errno == EINTR)
      continue;
    if (count < 0)
      return -1;
    if (count == 0)
      break;
    total += std::size_t(count);
  }
  return ssize_t(total);
}

/// Reads as many bytes of a file as `sizeToRead` returns for the file's size, unless it returns an
/// error; fewer if another process shortens the file meanwhile.
template <class SizeToRead>
Result<std::vector<std::byte>> openAndRead(const std::filesystem::path& path,
                                           const SizeToRead& sizeToRead) {
  // Without O_NONBLOCK, opening a named pipe would wait for a writer.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  struct stat status {};
  const bool isOpen = file.get() >= 0 && ::fstat(file.get(), &status) == 0;
  if (!isOpen && errno != ENXIO) // a socket cannot be opened
    return unreadable(path, errno);
  if (!S_ISREG(status.st_mode))
    return Error{ErrorKind::badInput,
                 path.string() + (S_ISDIR(status.st_mode) ? ": is a folder; expected a file"
                                                          : ": is not a regular file")};
  const Result<std::size_t> size = sizeToRead(std::size_t(status.st_size));
  if (!size)
    return size.error();
  std::vector<std::byte> bytes;
  try {
    bytes.resize(size.value());
  } catch (const std::bad_alloc&) {
    return memoryError([&] {
      return path.string() + ": not enough memory for its " + std::to_string(size.value()) +
             " bytes";
    });
  }
  const ssize_t count = readAll(file.get(), bytes);
  if (count < 0)
    return unreadable(path, errno);
  bytes.resize(std::size_t(count));
  return bytes;
}

Error wrongSize(const std::filesystem::path& path, std::size_t size, const char* bound,
                std::size_t expected) {
  return Error{ErrorKind::badInput, path.string() + ": has " + counted(size, "byte") +
                                        "; expected at " + bound + " " + std::to_string(expected)};
}

/// Like replaceFile(), but throws std::bad_alloc.
Result<void> replace(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  std::filesystem::path temporary; // empty until the file has a name
  const auto failure = [&](int code) {
    if (!temporary.empty())
      ::unlink(temporary.c_str());
    return Error{writeErrorKind(code), path.string() + ": cannot be written: " + reason(code)};
  };
  int descriptor = openUnnamed(path.parent_path());
  const bool unnamed = descriptor >= 0;
  const auto create = [&](const std::filesystem::path& name) {
    descriptor = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    return descriptor >= 0;
  };
  if (const int code = unnamed ? 0 : makeTemporary(path, temporary, create); code != 0)
    return failure(code);
  Descriptor file(descriptor);
  if (!writeAll(file.get(), bytes) || ::fsync(file.get()) != 0)
    return failure(errno);
  const auto link = [&](const std::filesystem::path& name) { return giveName(file.get(), name); };
  if (const int code = unnamed ? makeTemporary(path, temporary, link) : 0; code != 0)
    return failure(code);
  if (file.close() != 0)
    return failure(errno);
  if (::rename(temporary.c_str(), path.c_str()) != 0)
    return failure(errno);
  return {};
}

} // namespace

Result<std::vector<std::byte>> readFile(const std::filesystem::path& path, std::size_t maxBytes) {
  return withinMemory(exhausted(path), [&] {
    return openAndRead(path, [&](std::size_t size) -> Result<std::size_t> {
      return size > maxBytes ? Result<std::size_t>(wrongSize(path, size, "most", maxBytes)) : size;
    });
  });
}

Result<std::vector<std::byte>> readFileStart(const std::filesystem::path& path, std::size_t size) {
  return withinMemory(exhausted(path), [&] {
    return openAndRead(path, [&](std::size_t available) -> Result<std::size_t> {
      return available < size ? Result<std::size_t>(wrongSize(path, available, "least", size))
                              : size;
    });
  });
}

Result<void> checkFolder(const std::filesystem::path& folder) {
  return withinMemory(exhausted(folder), [&]() -> Result<void> {
    struct stat status {};
    const int code = ::stat(folder.empty() ? "." : folder.c_str(), &status) == 0 ? 0 : errno;
    if (code == 0 && S_ISDIR(status.st_mode))
      return {};
    return Error{ErrorKind::environment,
                 folder.string() + (code == 0 ? ": is a file; expected a folder"
                                    : code == ENOENT
                                        ? ": the folder does not exist; create it first"
                                        : ": cannot be used: " + reason(code))};
  });
}

Result<void> replaceFile(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  return withinMemory(exhausted(path), [&] { return replace(path, bytes); });
}

} // namespace lichen
