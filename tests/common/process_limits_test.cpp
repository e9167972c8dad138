#include "common/process_limits.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <string>

#include "common/error.h"

namespace prosector {
namespace {

/// Sets a limit of a process of its own, checks, and ends it: with 0 if all is well, with 1 if a message
/// names `remedy`, else with 2.
[[noreturn]] void check_within(__rlimit_resource_t what, rlim_t soft, rlim_t hard,
                               const std::string& remedy) {
  const rlimit limit{soft, hard};
  if (setrlimit(what, &limit) != 0) _exit(3);
  try {
    check_process_limits();
  } catch (const InputError& error) {
    _exit(std::string(error.what()).find(remedy) != std::string::npos ? 1 : 2);
  }
  rlimit now{};
  getrlimit(RLIMIT_NOFILE, &now);
  _exit(now.rlim_cur >= 64 ? 0 : 2);
}

using testing::ExitedWithCode;

TEST(ProcessLimits, RaiseTheNumberOfFilesAsFarAsIsPermitted) {
  EXPECT_EXIT(check_within(RLIMIT_NOFILE, 16, 64, ""), ExitedWithCode(0), "");
  EXPECT_EXIT(check_within(RLIMIT_NOFILE, 64, 64, ""), ExitedWithCode(0), "");
}

TEST(ProcessLimits, TooFewFilesAreRefusedWithARemedy) {
  EXPECT_EXIT(check_within(RLIMIT_NOFILE, 16, 63, "ulimit -n 64"), ExitedWithCode(1), "");
}

TEST(ProcessLimits, TooLittleMemoryIsRefusedWithARemedy) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the address sanitizer reserves terabytes";
#endif
  EXPECT_EXIT(check_within(RLIMIT_AS, 900'000'000, RLIM_INFINITY, "ulimit -v"), ExitedWithCode(1), "");
  EXPECT_EXIT(check_within(RLIMIT_AS, 2'000'000'000, RLIM_INFINITY, ""), ExitedWithCode(0), "");
}

}  // namespace
}  // namespace prosector
