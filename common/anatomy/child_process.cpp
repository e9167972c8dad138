#include "common/anatomy/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "common/clock.h"

extern char** environ;

namespace prosector {
namespace {

/// A pipe whose ends are closed in every started program, except one that is passed on explicitly.
struct Pipe {
  std::array<int, 2> end{-1, -1};
  Pipe() {
    if (::pipe2(end.data(), O_CLOEXEC) != 0) end = {-1, -1};
  }
  ~Pipe() {
    close(0);
    close(1);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  void close(std::size_t which) {
    if (end[which] >= 0) ::close(end[which]);
    end[which] = -1;
  }
};

/// Starts the program. Returns 0 or an errno value.
int start(const std::filesystem::path& program, const std::vector<std::string>& arguments, int output,
          pid_t& child) {
  std::vector<std::string> words = {program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
  const int error = ::posix_spawn(&child, program.c_str(), &files, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  return error;
}

/// Reads until the other end is closed. Returns an empty string, or the limit that was exceeded.
std::string read_output(int from, const ChildLimits& limits, std::vector<std::uint8_t>& out) {
  const std::int64_t deadline = monotonic_ns() + static_cast<std::int64_t>(1e9 * limits.seconds);
  std::array<std::uint8_t, 1 << 16> buffer;
  for (;;) {
    const std::int64_t left_ms = (deadline - monotonic_ns()) / 1'000'000;
    if (left_ms <= 0) return fmt::format("timed out after {} s", limits.seconds);
    pollfd wait{from, POLLIN, 0};
    if (::poll(&wait, 1, static_cast<int>(std::min<std::int64_t>(left_ms, 1000))) <= 0) continue;
    const ssize_t got = ::read(from, buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return "";
    if (out.size() + static_cast<std::size_t>(got) > limits.output_bytes)
      return fmt::format("wrote more than {} bytes", limits.output_bytes);
    out.insert(out.end(), buffer.begin(), buffer.begin() + got);
  }
}

std::string end_in_words(int status) {
  if (WIFSIGNALED(status)) return fmt::format("crashed ({})", ::strsignal(WTERMSIG(status)));
  if (WEXITSTATUS(status) != 0) return fmt::format("ended with exit code {}", WEXITSTATUS(status));
  return "";
}

}  // namespace

ChildOutcome run_child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                       const ChildLimits& limits) {
  Pipe pipe;
  pid_t child = -1;
  if (const int error = pipe.end[0] < 0 ? errno : start(program, arguments, pipe.end[1], child))
    return {{}, fmt::format("cannot be started ({})", std::strerror(error))};
  pipe.close(1);
  ChildOutcome out;
  out.error = read_output(pipe.end[0], limits, out.output);
  if (!out.error.empty()) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (out.error.empty()) out.error = end_in_words(status);
  return out;
}

}  // namespace prosector
