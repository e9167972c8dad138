#pragma once
// A program that the set-up window starts: a server to host, a client to take part.

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace prosector {

/// Returns the folder of the running program: others of Prosector's are beside it.
std::filesystem::path program_folder();

/// Returns a command as people would type it in a shell.
std::string shell_line(const std::vector<std::string>& words);

/// Ends with it: the program gets SIGINT, and SIGKILL if it is still there after five seconds.
class ChildProcess {
 public:
  /// Starts a program; what it writes is kept, and passed on to this one's standard output. Throws InputError
  /// naming it where it can't be started.
  explicit ChildProcess(const std::vector<std::string>& words);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Reads what it wrote since, without waiting, and looks whether it is still there.
  void poll();
  /// Asks it to end, and goes on.
  void interrupt();
  /// Returns how it ended, as shells count it; none while it runs.
  std::optional<int> ended() const { return status_; }
  /// Returns the last lines that it wrote, oldest first.
  const std::vector<std::string>& lines() const { return lines_; }
  bool said(const std::string& words) const;

 private:
  pid_t pid_ = 0;
  int pipe_ = -1;
  std::optional<int> status_;
  std::string rest_;  // of a line that isn't over
  std::vector<std::string> lines_;

  void read_output();
};

}  // namespace prosector
