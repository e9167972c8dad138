#include "server/session/journal/file_claim.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "common/error.h"

namespace prosector {

FileClaim::FileClaim(const std::filesystem::path& file) : handle_(open(file.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (handle_ < 0 || flock(handle_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(handle_);
  throw InputError(fmt::format(
      "{}: another server is writing this journal; end that server, or choose another file", file.string()));
}

FileClaim::~FileClaim() {
  if (handle_ >= 0) close(handle_);
}

}  // namespace prosector
