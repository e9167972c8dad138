// Real processes that are killed, and two servers that start at the same moment.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <optional>
#include <string>
#include <thread>

#include "tests/dds_domains.h"
#include "tests/session/server_process.h"

namespace prosector {
namespace {

using namespace std::chrono_literals;
using Folder = test::BoxFolder;
using test::feed_until;
using test::join_network;
using test::Server;

constexpr ParticipantId first_id = 7;

/// Somebody with a hand, who asks to be let in whenever the followed server does not know them.
struct Person {
  std::unique_ptr<Bus> bus;
  Presence presence;
  ServerChoice choice;
  std::uint64_t sequence = 0, last_tick = 0;
  std::optional<CommandResult> answer;
  std::int64_t asked_ns = 0;

  Person(const Folder& folder, ParticipantId id) : bus(join_network(folder, BusEnd::dissector)) {
    presence.participant = id;
    presence.name = "ada";
    presence.role = Role::dissector;
  }
  bool is_in() { return choice.replica().roster().contains(presence.participant); }
  /// Moves the hand, and takes what arrived; `last_tick` is the newest at which the server showed it.
  void live() {
    if (!is_in() && monotonic_ns() - asked_ns > 300'000'000) {
      asked_ns = monotonic_ns();
      bus->publish(presence);
      Command join;
      join.participant = presence.participant;
      join.sequence = ++sequence;
      bus->publish(join);
    }
    HandInput input;
    input.participant = presence.participant;
    input.sequence = ++sequence;
    input.hands[right_hand].tracked = true;
    input.hands[right_hand].pose.p = {0, 0.3, 0.001 * static_cast<double>(sequence % 100)};
    bus->publish(input);
    bus->wait(10ms);
    std::vector<Received> received;
    bus->take(received);
    for (const Received& r : received) {
      choice.apply(r);
      if (r.writer != choice.followed()) continue;
      if (const auto* state = std::get_if<UserState>(&r.message)) last_tick = state->time.tick;
      const auto* result = std::get_if<CommandResult>(&r.message);
      if (result != nullptr && result->participant == presence.participant) answer = *result;
    }
  }
  template <class Done>
  bool live_until(Done done, std::chrono::milliseconds time_limit) {
    const std::int64_t deadline = monotonic_ns() + std::chrono::nanoseconds(time_limit).count();
    while (!done() && monotonic_ns() < deadline) live();
    return done();
  }
};

TEST(Survival, WhatPeopleSawBeforeTheServerWasKilledIsThereWhenItGoesOn) {
  const Folder folder(test::dds_domain::survival);
  const std::string journal = folder.path / "journal";
  Person ada(folder, first_id);
  std::optional<Server> server(std::in_place, folder,
                               std::vector<std::string>{folder.path / "box.toml", "--journal", journal});
  ASSERT_TRUE(ada.live_until([&] { return ada.is_in() && ada.last_tick > 60; }, 20s)) << server->output();
  const std::uint64_t run = ada.choice.replica().session()->server_run;
  server->signal(SIGKILL);
  server->wait();
  while (ada.bus->wait(1ms)) ada.live();  // what was still on its way
  const std::uint64_t seen = ada.last_tick;
  const std::int64_t killed_ns = monotonic_ns();
  server.emplace(folder, std::vector<std::string>{"--resume", journal});
  const auto goes_on = [&] {
    const Replica& replica = ada.choice.replica();
    return replica.session()->server_run != run && ada.is_in() && ada.last_tick > seen;
  };
  EXPECT_TRUE(ada.live_until(goes_on, 10s)) << server->output();
  const double seconds = 1e-9 * static_cast<double>(monotonic_ns() - killed_ns);
  const std::string said = server->output(), word = "resumed at tick ";
  ASSERT_NE(said.find(word), std::string::npos) << said;
  const std::uint64_t resumed = std::stoull(said.substr(said.find(word) + word.size()));
  EXPECT_GE(resumed, seen);
  RecordProperty("seconds_until_people_go_on", std::to_string(seconds));
  fmt::print("people went on after {:.2f} s; last tick seen {}, resumed at {}\n", seconds, seen, resumed);
}

TEST(Survival, WhoIsKilledAndComesBackAtOnceIsLetIn) {
  const Folder folder(test::dds_domain::survival + 1);
  const Server server(folder, {folder.path / "box.toml"});
  const pid_t child = fork();
  if (child == 0) {
    Person ada(folder, first_id);
    while (true) ada.live();
  }
  const auto bus = join_network(folder, BusEnd::observer);
  ServerChoice choice;
  ASSERT_TRUE(feed_until(
      *bus, choice, [&] { return choice.replica().roster().contains(first_id); }, 20s))
      << server.output();
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  Person again(folder, first_id + 1);
  EXPECT_TRUE(again.live_until([&] { return again.answer.has_value(); }, 10s));
  EXPECT_TRUE(again.answer && again.answer->accepted) << (again.answer ? again.answer->reason : "no answer");
}

struct DoubleStart {
  int hosting = 0;
  std::string said;  // by the one that ended
};

/// Two servers of one session, started together; what is left of them once one has given way, or after 5 s.
DoubleStart start_two(const Folder& folder) {
  const Server one(folder, {folder.path / "box.toml"});
  const Server two(folder, {folder.path / "box.toml"});
  const std::int64_t deadline = monotonic_ns() + 5'000'000'000;
  while (one.runs() && two.runs() && monotonic_ns() < deadline) std::this_thread::sleep_for(10ms);
  // The other one goes on: it is not that both yield.
  std::this_thread::sleep_for(300ms);
  return {int{one.runs()} + int{two.runs()}, one.runs() ? two.output() : one.output()};
}

TEST(Survival, OfTwoServersThatStartTogetherOneGivesWayInWords) {
  const char* rounds = std::getenv("PROSECTOR_DOUBLE_STARTS");
  for (int i = 0; i < (rounds != nullptr ? std::atoi(rounds) : 3); ++i) {
    const Folder folder(test::dds_domain::survival + 2);
    const DoubleStart result = start_two(folder);
    EXPECT_EQ(result.hosting, 1) << "round " << i;
    const bool in_words = result.said.find("at the same time and hosts it") != std::string::npos ||
                          result.said.find("is already hosted by another server") != std::string::npos ||
                          result.said.find("is in use") != std::string::npos;
    EXPECT_TRUE(in_words) << result.said;
  }
}

}  // namespace
}  // namespace prosector
