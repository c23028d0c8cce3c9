// SPDX-License-Identifier: MIT
// Whole files in and out over POSIX calls, which report the reason of a failure.
#include <lichen/files.h>

#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <new>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace lichen {
namespace {

// Linux transfers at most 0x7ffff000 bytes a call; a round limit below it keeps the loop simple.
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
  /// Closes now and returns what close() said: a full disk may be reported only here.
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

/// A name no other call of this or another process uses at the same time.
std::filesystem::path temporaryBeside(const std::filesystem::path& path) {
  static std::atomic<unsigned> counter{0};
  std::filesystem::path temporary = path;
  temporary += ".part-" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
  return temporary;
}

/// A new file without a name, which vanishes with the process however that ends; -1 where the
/// system has none, as on NFS and FAT.
int openNameless([[maybe_unused]] const std::filesystem::path& folder) {
#ifdef O_TMPFILE
  if (::access("/proc/self/fd", X_OK) == 0) // needed to name it later
    return ::open(folder.empty() ? "." : folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666);
#endif
  return -1;
}

/// Names a nameless file. No call names it over another file, so a name of its own comes first.
bool giveName(int descriptor, const std::filesystem::path& name) {
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  return ::linkat(AT_FDCWD, link.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
}

} // namespace

Result<std::vector<std::byte>> readFile(const std::filesystem::path& path, std::size_t maxBytes) {
  // Without O_NONBLOCK, opening a named pipe waits for its writer.
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0)
    return Error{ErrorKind::badInput, path.string() + ": cannot be read: " + reason(errno)};
  struct stat status {};
  if (::fstat(file.get(), &status) != 0)
    return Error{ErrorKind::badInput, path.string() + ": cannot be read: " + reason(errno)};
  if (!S_ISREG(status.st_mode))
    return Error{ErrorKind::badInput, path.string() + ": not a regular file"};
  const auto size = std::size_t(status.st_size);
  if (size > maxBytes)
    return Error{ErrorKind::badInput, path.string() + ": " + std::to_string(size) +
                                          " bytes; at most " + std::to_string(maxBytes) +
                                          " are accepted"};
  std::vector<std::byte> bytes;
  try {
    bytes.resize(size);
  } catch (const std::bad_alloc&) {
    return Error{ErrorKind::resources,
                 path.string() + ": not enough memory for its " + std::to_string(size) + " bytes"};
  }
  std::size_t done = 0;
  while (done < size) {
    const ssize_t got =
        ::read(file.get(), bytes.data() + done, std::min(size - done, kMaxTransfer));
    if (got < 0 && errno == EINTR)
      continue;
    if (got < 0)
      return Error{ErrorKind::badInput, path.string() + ": cannot be read: " + reason(errno)};
    if (got == 0)
      break; // another process has shortened the file
    done += std::size_t(got);
  }
  bytes.resize(done);
  return bytes;
}

Result<void> replaceFile(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  const std::filesystem::path temporary = temporaryBeside(path);
  const auto failure = [&](int code) {
    ::unlink(temporary.c_str());
    return Error{writeErrorKind(code), path.string() + ": cannot be written: " + reason(code)};
  };
  const int nameless = openNameless(path.parent_path());
  const bool named = nameless < 0;
  Descriptor file(named ? ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)
                        : nameless);
  if (file.get() < 0)
    return Error{writeErrorKind(errno), path.string() + ": cannot be written: " + reason(errno)};
  if (!writeAll(file.get(), bytes) || ::fsync(file.get()) != 0)
    return failure(errno);
  if (!named && !giveName(file.get(), temporary))
    return failure(errno);
  if (file.close() != 0)
    return failure(errno);
  if (::rename(temporary.c_str(), path.c_str()) != 0)
    return failure(errno);
  return {};
}

} // namespace lichen
