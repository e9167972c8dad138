#pragma once
// A program started by the set-up window: a server for hosting, or a client.

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace prosector {

/// Returns the folder that contains the running program, and also Prosector's other programs.
std::filesystem::path program_folder();

/// Returns the words of a command as one line in shell syntax, quoted where needed.
std::string shell_line(const std::vector<std::string>& words);

/// Child process, with its output and exit status. The destructor sends SIGINT, and SIGKILL if the program
/// still runs after five seconds.
class ChildProcess {
 public:
  /// Starts a program: `words` are its file and arguments. Its output is stored, and forwarded to standard
  /// output. Throws InputError with the program's name if it can't be started.
  explicit ChildProcess(const std::vector<std::string>& words);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Reads the program's new output without waiting, and updates lines() and ended().
  void poll();
  /// Asks the program to exit by sending SIGINT, without waiting for it.
  void interrupt();
  /// Returns the program's exit status, or 128 plus the number of the signal that ended it, as in a shell;
  /// nullopt while it runs.
  std::optional<int> ended() const { return status_; }
  /// Returns the last lines that the program has printed, the oldest first.
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
