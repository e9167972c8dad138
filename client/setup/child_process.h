#pragma once
// A program started by the set-up window: a server for hosting, or a client.

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace prosector {

/// Returns the folder of the running program, which contains Prosector's other programs.
std::filesystem::path program_folder();

/// Returns a command in shell syntax.
std::string shell_line(const std::vector<std::string>& words);

/// A child process. The destructor sends SIGINT, and SIGKILL if the program still runs after five seconds.
class ChildProcess {
 public:
  /// Starts a program. Its output is stored, and forwarded to standard output. Throws InputError with the
  /// program's name if it can't be started.
  explicit ChildProcess(const std::vector<std::string>& words);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Reads new output without waiting, and checks whether the program has ended.
  void poll();
  /// Sends SIGINT without waiting.
  void interrupt();
  /// Returns the exit status in the shell's convention; nullopt while it runs.
  std::optional<int> ended() const { return status_; }
  /// Returns the last lines of output, oldest first.
  const std::vector<std::string>& lines() const { return lines_; }
  bool said(const std::string& words) const;

 private:
  pid_t pid_ = 0;
  int pipe_ = -1;
  std::optional<int> status_;
  std::string rest_;  // an incomplete line
  std::vector<std::string> lines_;

  void read_output();
};

}  // namespace prosector
