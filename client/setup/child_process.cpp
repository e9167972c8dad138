#include "client/setup/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

#include "common/error.h"

namespace prosector {
namespace {

constexpr std::size_t kept_lines = 200;
constexpr std::chrono::milliseconds time_limit{5000}, between_looks{20};

}  // namespace

std::filesystem::path program_folder() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  return error ? std::filesystem::path() : program.parent_path();
}

std::string shell_line(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) {
    const bool plain = !word.empty() && word.find_first_not_of(
                                            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUV"
                                            "WXYZ0123456789-_./:=,@%+") == std::string::npos;
    std::string quoted = word;
    for (std::size_t at = 0; !plain && (at = quoted.find('\'', at)) != std::string::npos; at += 4)
      quoted.replace(at, 1, "'\\''");
    out += fmt::format("{}{}", out.empty() ? "" : " ", plain ? quoted : "'" + quoted + "'");
  }
  return out;
}

ChildProcess::ChildProcess(const std::vector<std::string>& words) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw InputError(fmt::format("no pipe: {}", std::strerror(errno)));
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
  const int error = posix_spawnp(&pid_, arguments[0], &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  close(ends[1]);
  pipe_ = ends[0];
  if (error != 0) {
    close(pipe_);
    throw InputError(fmt::format("cannot start {}: {}", words.front(), std::strerror(error)));
  }
  fcntl(pipe_, F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess() {
  interrupt();
  for (auto waited = std::chrono::milliseconds(0); !status_ && waited < time_limit; waited += between_looks) {
    std::this_thread::sleep_for(between_looks);
    poll();
  }
  if (!status_) {
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  close(pipe_);
}

void ChildProcess::poll() {
  read_output();
  int status = 0;
  if (status_ || waitpid(pid_, &status, WNOHANG) != pid_) return;
  status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  read_output();
}

void ChildProcess::interrupt() {
  if (!status_) kill(pid_, SIGINT);
}

bool ChildProcess::said(const std::string& words) const {
  return std::any_of(lines_.begin(), lines_.end(),
                     [&](const std::string& line) { return line.find(words) != std::string::npos; });
}

void ChildProcess::read_output() {
  std::array<char, 4096> chunk{};
  for (ssize_t got = 0; (got = read(pipe_, chunk.data(), chunk.size())) > 0;) {
    std::fwrite(chunk.data(), 1, static_cast<std::size_t>(got), stdout);
    rest_.append(chunk.data(), static_cast<std::size_t>(got));
  }
  std::fflush(stdout);
  for (std::size_t end = 0; (end = rest_.find('\n')) != std::string::npos; rest_.erase(0, end + 1))
    lines_.push_back(rest_.substr(0, end));
  if (lines_.size() > kept_lines)
    lines_.erase(lines_.begin(), lines_.end() - static_cast<std::ptrdiff_t>(kept_lines));
}

}  // namespace prosector
