// prosector-server as a process over real DDS on lo: what it says, how it ends, who may share a host.

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "tests/dds_domains.h"
#include "tests/session/server_process.h"

namespace prosector {
namespace {

using namespace std::chrono_literals;
using Folder = test::BoxFolder;
using test::feed_until;
using test::join_network;
using test::Server;

TEST(ServerProcess, HostsSummarisesReplaysAndResumes) {
  const Folder folder(test::dds_domain::process);
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
  const Folder folder(test::dds_domain::process + 1);
  const auto bus = join_network(folder, BusEnd::observer);
  ServerChoice choice;
  std::uint64_t first = 0;
  {
    Server server(folder, {folder.path / "box.toml"});
    ASSERT_TRUE(feed_until(*bus, choice, [&] { return choice.replica().complete(); }));
    first = choice.replica().session()->server_run;
    server.signal(SIGKILL);
    EXPECT_EQ(server.wait(), -1);
  }
  Server server(folder, {folder.path / "box.toml"});
  const auto another = [&] { return choice.replica().session()->server_run != first; };
  if (!server.says("is open")) GTEST_FAIL() << server.output();
  EXPECT_TRUE(feed_until(*bus, choice, another));
}

std::vector<HandRef> holders(const Replica& replica, BodyId body) {
  const PartState* part = replica.part(body);
  return part != nullptr ? part->holders : std::vector<HandRef>{};
}

/// A process that joins, takes hold of the cube, and holds it until it is killed.
pid_t start_holder(const Folder& folder) {
  const pid_t child = fork();
  if (child != 0) return child;
  const auto bus = join_network(folder, BusEnd::dissector);
  Presence ada;
  ada.participant = 7;
  ada.name = "ada";
  ada.role = Role::dissector;
  Command command;
  command.participant = 7;
  HandInput input;
  input.participant = 7;
  input.hands[right_hand].tracked = true;
  input.hands[right_hand].pose.p = {0, 0.18, 0.045};  // over the cube, once that lies on the table
  Replica replica;
  for (int i = 0;; ++i) {
    if (i % 30 == 0) {
      if (replica.roster().count(7) == 0) bus->publish(ada);
      command.body = replica.roster().count(7) == 0 ? CommandBody(Join{}) : CommandBody(Grasp{});
      ++command.sequence;
      bus->publish(command);
    }
    ++input.sequence;
    bus->publish(input);
    feed_until(*bus, replica, [] { return true; });
    std::vector<Received> received;
    bus->take(received);
    for (const Received& r : received) replica.apply(r);
    std::this_thread::sleep_for(15ms);
  }
}

TEST(ServerProcess, WhatAKilledProcessHeldIsFreeWithinTwoSeconds) {
  const Folder folder(test::dds_domain::process + 4);
  const pid_t holder = start_holder(folder);
  ASSERT_GT(holder, 0);
  Server server(folder, {folder.path / "box.toml"});
  const auto bus = join_network(folder, BusEnd::observer);
  Replica replica;
  constexpr BodyId cube = 1;
  EXPECT_TRUE(feed_until(
      *bus, replica, [&] { return !holders(replica, cube).empty(); }, 20s))
      << server.output();
  if (!holders(replica, cube).empty()) {
    EXPECT_EQ(holders(replica, cube)[0].participant, 7U);
    EXPECT_EQ(holders(replica, cube)[0].hand, right_hand);
  }
  kill(holder, SIGKILL);
  waitpid(holder, nullptr, 0);
  EXPECT_TRUE(feed_until(
      *bus, replica, [&] { return holders(replica, cube).empty(); }, 2s));
  EXPECT_TRUE(feed_until(
      *bus, replica, [&] { return replica.roster().count(7) == 0; }, 2s));
}

struct Mistake {
  std::vector<std::string> arguments;
  const char* says;
};

TEST(ServerProcess, MistakesGetOneLineAndStatusTwo) {
  const Folder folder(test::dds_domain::process + 2);
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
      {{folder.path / "box.toml", "--journal", folder.path / "garbage"}, "already exists"},
  };
  for (const Mistake& mistake : mistakes) {
    Server server(folder, mistake.arguments);
    EXPECT_EQ(server.wait(), 2) << mistake.says;
    EXPECT_NE(server.output().find(mistake.says), std::string::npos) << server.output();
  }
}

TEST(ServerProcess, CheckSaysWhatASceneCosts) {
  const Folder folder(test::dds_domain::process + 3);
  Server server(folder, {folder.path / "box.toml", "--check"});
  EXPECT_EQ(server.wait(), 0);
  EXPECT_NE(server.output().find("2 rigid and 0 soft bodies"), std::string::npos) << server.output();
}

}  // namespace
}  // namespace prosector
