#pragma once
// prosector-server as a process over real DDS, on lo alone, and a client's end to listen with.

#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "client/replica/server_choice.h"
#include "common/clock.h"
#include "idl/cyclone_bus.h"
#include "tests/folders.h"

namespace prosector::test {

/// A place for the test's files, and a DDS domain that no other test has, since tests run at once and find
/// each other's servers.
struct Folder {
  std::uint32_t domain;
  std::filesystem::path path;
  explicit Folder(std::uint32_t domain)
      : domain(domain),
        path(std::filesystem::temp_directory_path() /
             ("prosector-process." + std::to_string(domain) + "." + std::to_string(getpid()))) {
    std::filesystem::remove_all(path);
    std::filesystem::create_directories(path);
  }
  ~Folder() { std::filesystem::remove_all(path); }
};

/// One with the scene of a cube over a table.
struct BoxFolder : Folder {
  explicit BoxFolder(std::uint32_t domain) : Folder(domain) {
    std::ofstream(path / "box.toml") << R"(
name = "box"
[[rigid]]
name = "table"
fixed = true
[[rigid.part]]
shape = "box"
size = [1, 0.1, 1]
[[rigid]]
name = "cube"
position = [0, 0.4, 0]
[[rigid.part]]
shape = "box"
size = [0.1, 0.1, 0.1]
)";
  }
};

/// A server started with `arguments`, its output in a file.
class Server {
 public:
  Server(const Folder& folder, std::vector<std::string> arguments)
      : output_(folder.path / ("output" + std::to_string(++count_))) {
    arguments.insert(arguments.begin(), build_path("bin/prosector-server"));
    arguments.insert(arguments.end(),
                     {"--domain", std::to_string(folder.domain), "--cache", folder.path / "cache"});
    pid_ = fork();
    if (pid_ != 0) return;
    if (freopen(output_.c_str(), "w", stdout) == nullptr || dup2(1, 2) < 0) _exit(99);
    std::vector<char*> argv;
    for (std::string& a : arguments) argv.push_back(a.data());
    argv.push_back(nullptr);
    execv(argv[0], argv.data());
    _exit(98);
  }
  ~Server() {
    if (pid_ > 0) {
      kill(pid_, SIGKILL);
      wait();
    }
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  void signal(int number) const { kill(pid_, number); }
  /// The exit status, −1 when a signal ended it.
  int wait() {
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  std::string output() const {
    std::ifstream in(output_);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
  }
  bool runs() const {
    siginfo_t info{};
    waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOHANG | WNOWAIT);
    return info.si_pid == 0;
  }
  bool says(const std::string& what) const {
    for (int i = 0; i < 500; ++i) {
      if (output().find(what) != std::string::npos) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return false;
  }

 private:
  static inline int count_ = 0;
  std::filesystem::path output_;
  pid_t pid_;
};

inline std::unique_ptr<Bus> join_network(const Folder& folder, BusEnd end) {
  BusConfig config;
  config.end = end;
  config.domain = folder.domain;
  return make_cyclone_bus(config);
}

/// `replica` is a Replica or a ServerChoice. False: not within that long.
template <class Taker>
bool feed_until(Bus& bus, Taker& replica, const std::function<bool()>& done,
                std::chrono::seconds time_limit = std::chrono::seconds(5)) {
  const std::int64_t deadline = monotonic_ns() + std::chrono::nanoseconds(time_limit).count();
  std::vector<Received> received;
  while (!done()) {
    if (monotonic_ns() > deadline) return false;
    bus.wait(std::chrono::milliseconds(20));
    bus.take(received);
    for (const Received& r : received) replica.apply(r);
  }
  return true;
}

}  // namespace prosector::test
