// prosector-server as a process over real DDS on lo: what it says, how it ends, who may share a host.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "client/replica/replica.h"
#include "common/clock.h"
#include "idl/cyclone_bus.h"

namespace prosector {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

const char* const scene_text = R"(
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

/// A place for the test's files, and a DDS domain of its own, since tests run at once.
struct Folder {
  std::uint32_t domain;
  fs::path path;
  explicit Folder(std::uint32_t domain)
      : domain(domain),
        path(fs::temp_directory_path() /
             ("prosector-process." + std::to_string(domain) + "." + std::to_string(getpid()))) {
    fs::remove_all(path);
    fs::create_directories(path);
    std::ofstream(path / "box.toml") << scene_text;
  }
  ~Folder() { fs::remove_all(path); }
};

/// A server started with `arguments`, its output in a file.
class Server {
 public:
  Server(const Folder& folder, std::vector<std::string> arguments)
      : output_(folder.path / ("output" + std::to_string(++count_))) {
    arguments.insert(arguments.begin(), PROSECTOR_SERVER);
    arguments.insert(arguments.end(),
                     {"--domain", std::to_string(folder.domain), "--cache", folder.path / "cache"});
    pid_ = fork();
    if (pid_ != 0) return;
    if (freopen(output_.c_str(), "w", stdout) == nullptr || dup2(1, 2) < 0) _exit(99);
    std::vector<char*> argv;
    for (std::string& a : arguments) argv.push_back(a.data());
    argv.push_back(nullptr);
    execv(PROSECTOR_SERVER, argv.data());
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
  bool says(const std::string& what) const {
    for (int i = 0; i < 500; ++i) {
      if (output().find(what) != std::string::npos) return true;
      std::this_thread::sleep_for(20ms);
    }
    return false;
  }

 private:
  static inline int count_ = 0;
  fs::path output_;
  pid_t pid_;
};

std::unique_ptr<Bus> join_network(const Folder& folder, BusEnd end) {
  BusConfig config;
  config.end = end;
  config.domain = folder.domain;
  return make_cyclone_bus(config);
}

bool feed_until(Bus& bus, Replica& replica, const std::function<bool()>& done) {
  const std::int64_t deadline = monotonic_ns() + 5'000'000'000;
  std::vector<Received> received;
  while (!done()) {
    if (monotonic_ns() > deadline) return false;
    bus.wait(20ms);
    bus.take(received);
    for (const Received& r : received) replica.apply(r);
  }
  return true;
}

TEST(ServerProcess, HostsSummarisesReplaysAndResumes) {
  const Folder folder(94);
  const std::string journal = folder.path / "journal", summary = folder.path / "summary.json";
  {
    Server server(folder, {folder.path / "box.toml", "--journal", journal, "--summary", summary});
    ASSERT_TRUE(server.says("is open on this machine")) << server.output();
    const auto bus = join_network(folder, BusEnd::dissector);
    Replica replica;
    ASSERT_TRUE(feed_until(*bus, replica, [&] { return replica.complete(); })) << replica.missing();
    Presence ada;
    ada.participant = 7;
    ada.name = "ada";
    ada.role = Role::dissector;
    bus->publish(ada);
    Command join;
    join.participant = 7;
    while (!bus->publish(join)) std::this_thread::sleep_for(5ms);
    EXPECT_TRUE(feed_until(*bus, replica, [&] { return replica.roster().count(7) == 1; }));
    EXPECT_TRUE(server.says("ada joins as dissector"));

    Server second(folder, {folder.path / "box.toml"});
    EXPECT_EQ(second.wait(), 2);
    Server other(folder, {folder.path / "box.toml", "--session", "other", "--seconds", "1"});
    EXPECT_EQ(other.wait(), 0);  // at the next index

    server.signal(SIGTERM);
    EXPECT_EQ(server.wait(), 0);
    EXPECT_TRUE(feed_until(*bus, replica, [&] { return replica.server_gone(); }));
  }
  const nlohmann::json figures = nlohmann::json::parse(std::ifstream(summary));
  EXPECT_EQ(figures["scene"], "box");
  EXPECT_EQ(figures["participants"], 1);
  EXPECT_EQ(figures["invalid_dropped"], 0);
  EXPECT_GT(figures["real_time_factor"], 0.9);
  const std::string last_hash = figures["state_hash"];

  Server replay(folder, {"--replay", journal});
  EXPECT_EQ(replay.wait(), 0);
  EXPECT_NE(replay.output().find(last_hash), std::string::npos) << replay.output();
  Server resume(folder, {"--resume", journal, "--seconds", "0.5"});
  EXPECT_EQ(resume.wait(), 0);
  EXPECT_NE(resume.output().find(last_hash), std::string::npos) << resume.output();
  Server again(folder, {"--replay", journal});
  EXPECT_EQ(again.wait(), 0) << again.output();
}

TEST(ServerProcess, ARestartAfterAKillIsSeenAsAnotherRun) {
  const Folder folder(95);
  const auto bus = join_network(folder, BusEnd::observer);
  Replica replica;
  std::uint64_t first = 0;
  {
    Server server(folder, {folder.path / "box.toml"});
    ASSERT_TRUE(feed_until(*bus, replica, [&] { return replica.complete(); }));
    first = replica.session()->server_run;
    server.signal(SIGKILL);
    EXPECT_EQ(server.wait(), -1);
  }
  Server server(folder, {folder.path / "box.toml"});
  const auto another = [&] { return replica.session() && replica.session()->server_run != first; };
  if (!server.says("is open")) GTEST_FAIL() << server.output();
  EXPECT_TRUE(feed_until(*bus, replica, another));
}

struct Mistake {
  std::vector<std::string> arguments;
  const char* says;
};

TEST(ServerProcess, MistakesGetOneLineAndStatusTwo) {
  const Folder folder(96);
  std::ofstream(folder.path / "bad.toml") << "name = \"x\"\ncolour = 3\n";
  std::ofstream(folder.path / "garbage") << "no journal";
  const std::vector<Mistake> mistakes = {
      {{}, "SCENE"},
      {{folder.path / "nowhere.toml"}, "cannot be read"},
      {{folder.path / "bad.toml"}, "colour"},
      {{folder.path / "box.toml", "--seconds", "-1"}, "--seconds"},
      {{folder.path / "box.toml", "--index", "10"}, "--index"},
      {{folder.path / "box.toml", "--no-such-thing"}, "--no-such-thing"},
      {{"--replay", folder.path / "garbage"}, "garbage"},
      {{folder.path / "box.toml", "--replay", "x"}, "--replay"},
      {{folder.path / "box.toml", "--journal", folder.path / "garbage"}, "exists already"},
  };
  for (const Mistake& mistake : mistakes) {
    Server server(folder, mistake.arguments);
    EXPECT_EQ(server.wait(), 2) << mistake.says;
    EXPECT_NE(server.output().find(mistake.says), std::string::npos) << server.output();
  }
}

TEST(ServerProcess, CheckSaysWhatASceneCosts) {
  const Folder folder(97);
  Server server(folder, {folder.path / "box.toml", "--check"});
  EXPECT_EQ(server.wait(), 0);
  EXPECT_NE(server.output().find("2 rigid and 0 soft bodies"), std::string::npos) << server.output();
}

}  // namespace
}  // namespace prosector
