#include "common/regular_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "common/error.h"

namespace prosector {
namespace {

/// An open file, closed by the destructor.
class OpenFile {
 public:
  explicit OpenFile(int handle) : handle_(handle) {}
  ~OpenFile() {
    if (handle_ >= 0) ::close(handle_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  int get() const { return handle_; }

 private:
  int handle_;
};

const char* kind_in_words(mode_t mode) {
  if (S_ISDIR(mode)) return "a folder";
  if (S_ISFIFO(mode)) return "a pipe";
  if (S_ISSOCK(mode)) return "a socket";
  return "a device";
}

[[noreturn]] void refuse_unreadable(const std::filesystem::path& file, int error) {
  throw InputError(fmt::format("{}: cannot be read: {}", file.string(), std::strerror(error)));
}

[[noreturn]] void refuse_kind(const std::filesystem::path& file, mode_t mode) {
  throw InputError(fmt::format("{}: is {}; allowed: a regular file", file.string(), kind_in_words(mode)));
}

[[noreturn]] void refuse_larger(const std::filesystem::path& file, std::size_t max_bytes) {
  throw InputError(fmt::format("{}: too large; allowed: at most {} bytes", file.string(), max_bytes));
}

}  // namespace

void require_regular_file(const std::filesystem::path& file) {
  struct stat status {};
  if (::stat(file.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) refuse_kind(file, status.st_mode);
}

std::string read_regular_file(const std::filesystem::path& file, std::size_t max_bytes) {
  // Without O_NONBLOCK, opening a pipe blocks until a writer opens it.
  const OpenFile in(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
  struct stat status {};
  if (in.get() < 0 || ::fstat(in.get(), &status) != 0) refuse_unreadable(file, errno);
  if (!S_ISREG(status.st_mode)) refuse_kind(file, status.st_mode);
  const auto said = static_cast<std::size_t>(status.st_size);
  if (said > max_bytes) refuse_larger(file, max_bytes);
  // One byte more than the file's stated size, so that its end is detected without another allocation.
  constexpr std::size_t min_growth = 1 << 16;
  std::string bytes;
  std::size_t filled = 0;
  for (;;) {
    if (filled == bytes.size()) bytes.resize(filled == 0 ? said + 1 : filled + std::max(filled, min_growth));
    const ssize_t got = ::read(in.get(), bytes.data() + filled, bytes.size() - filled);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) refuse_unreadable(file, errno);
    if (got == 0) break;
    filled += static_cast<std::size_t>(got);
    if (filled > max_bytes) refuse_larger(file, max_bytes);
  }
  bytes.resize(filled);
  return bytes;
}

}  // namespace prosector
