#include "common/process_limits.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>

#include "common/error.h"

namespace prosector {
namespace {

constexpr rlim_t min_open_files = 64;
constexpr rlim_t min_address_space = 1'000'000'000;  // bytes

}  // namespace

void check_process_limits() {
  rlimit files{}, addresses{};
  if (getrlimit(RLIMIT_NOFILE, &files) == 0) {
    if (files.rlim_max < min_open_files)
      throw InputError(
          fmt::format("the system lets this program open at most {} files at the same time: allow at least "
                      "{} (ulimit -n {})",
                      files.rlim_max, min_open_files, min_open_files));
    files.rlim_cur = std::max(files.rlim_cur, std::min<rlim_t>(files.rlim_max, 4096));
    setrlimit(RLIMIT_NOFILE, &files);
  }
  if (getrlimit(RLIMIT_AS, &addresses) == 0 && addresses.rlim_cur < min_address_space)
    throw InputError(fmt::format(
        "the system lets this program reserve only {} MB of memory: allow at least {} MB (ulimit -v {})",
        addresses.rlim_cur / 1'000'000, min_address_space / 1'000'000, min_address_space / 1024));
}

}  // namespace prosector
