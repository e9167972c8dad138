#include "common/process_limits.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>

#include "common/error.h"

namespace prosector {
namespace {

constexpr rlim_t least_files = 64;
constexpr rlim_t least_addresses = 1'000'000'000;  // bytes

}  // namespace

void check_process_limits() {
  rlimit files{}, addresses{};
  if (getrlimit(RLIMIT_NOFILE, &files) == 0) {
    if (files.rlim_max < least_files)
      throw InputError(fmt::format("only {} files may be open at once: allow at least {} (ulimit -n {})",
                                   files.rlim_max, least_files, least_files));
    files.rlim_cur = std::max(files.rlim_cur, std::min<rlim_t>(files.rlim_max, 4096));
    setrlimit(RLIMIT_NOFILE, &files);
  }
  if (getrlimit(RLIMIT_AS, &addresses) == 0 && addresses.rlim_cur < least_addresses)
    throw InputError(fmt::format("only {} MB of memory may be reserved: allow at least {} (ulimit -v {})",
                                 addresses.rlim_cur / 1'000'000, least_addresses / 1'000'000,
                                 least_addresses / 1024));
}

}  // namespace prosector
