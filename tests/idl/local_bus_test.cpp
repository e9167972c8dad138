// The in-process network: the same semantics as over DDS, decided by its seed.

#include "idl/local_bus.h"

#include <gtest/gtest.h>

#include "common/error.h"
#include "idl/topics.h"
#include "tests/idl/samples.h"

namespace prosector {
namespace {

using namespace std::chrono_literals;

BusConfig config_of(BusEnd end) {
  BusConfig config;
  config.end = end;
  return config;
}

RigidState rigid_state(BodyId body, std::uint64_t tick) {
  RigidState m;
  m.body = body;
  m.time.tick = tick;
  return m;
}

/// Ticks that reach a client when the server sends 1,000 states, one a millisecond.
std::vector<std::uint64_t> arriving_ticks(const LocalNetworkConfig& network_config) {
  LocalNetwork network(network_config);
  const auto server = network.join(config_of(BusEnd::server));
  const auto client = network.join(config_of(BusEnd::observer));
  std::vector<std::uint64_t> ticks;
  std::vector<Received> received;
  for (std::uint64_t tick = 0; tick < 1100; ++tick) {
    if (tick < 1000) server->publish(rigid_state(1, tick));
    network.advance(1ms);
    client->take(received);
    for (const Received& r : received) ticks.push_back(std::get<RigidState>(r.message).time.tick);
  }
  return ticks;
}

Command grasp_number(std::uint64_t sequence) {
  return {7, sequence, Grasp{}};
}

TEST(LocalBus, EveryTopicArrivesAtTheEndsThatReadIt) {
  LocalNetwork network({});
  const auto server = network.join(config_of(BusEnd::server));
  BusConfig with_arm = config_of(BusEnd::dissector);
  with_arm.arm = true;
  const auto dissector = network.join(with_arm);
  const auto observer = network.join(config_of(BusEnd::observer));
  std::vector<Received> received;
  for (const Message& message : sample_messages()) {
    const bool from_server = topics[message.index()].writers == Writers::server;
    observer->take(received);
    EXPECT_EQ(server->publish(message), from_server);
    EXPECT_EQ(dissector->publish(message), !from_server);
    dissector->take(received);
    EXPECT_EQ(received.size(), from_server ? 1u : 0u);
    server->take(received);
    EXPECT_EQ(received.size(), from_server ? 0u : 1u);
    observer->take(received);
    EXPECT_EQ(received.size(), from_server && !topics[message.index()].for_arms ? 1u : 0u)
        << "without an arm";
  }
  // An observer may be made a dissector while it is here: its hands arrive, and the session says if they
  // count.
  EXPECT_TRUE(observer->publish(HandInput{
      .participant = 1, .sequence = 0, .time_ns = 0, .head_tracked = false, .head = {}, .hands = {}}));
  server->take(received);
  EXPECT_EQ(received.size(), 1u);
}

TEST(LocalBus, SameSeedSameFate) {
  LocalNetworkConfig config{.seed = 5, .loss = 0.1, .delay = 20ms, .jitter = 5ms, .stepped = true};
  const auto first = arriving_ticks(config), second = arriving_ticks(config);
  EXPECT_EQ(first, second);
  config.seed = 6;
  EXPECT_NE(first, arriving_ticks(config));
}

TEST(LocalBus, BestEffortLosesButNeverGoesBack) {
  const auto ticks = arriving_ticks({.seed = 1, .loss = 0.1, .delay = 20ms, .jitter = 5ms, .stepped = true});
  EXPECT_LT(ticks.size(), 900u);
  EXPECT_GT(ticks.size(), 100u);
  EXPECT_TRUE(std::ranges::is_sorted(ticks));
}

TEST(LocalBus, ReliableLosesNothingAndKeepsOrder) {
  LocalNetwork network({.seed = 3, .loss = 0.2, .delay = 20ms, .jitter = 15ms, .stepped = true});
  const auto server = network.join(config_of(BusEnd::server));
  const auto client = network.join(config_of(BusEnd::dissector));
  std::vector<std::uint64_t> numbers;
  std::vector<Received> received;
  for (std::uint64_t i = 0; i < 300; ++i) {
    client->publish(grasp_number(i));
    network.advance(40ms);
    server->take(received);
    for (const Received& r : received) numbers.push_back(std::get<Command>(r.message).sequence);
  }
  network.advance(10s);
  server->take(received);
  for (const Received& r : received) numbers.push_back(std::get<Command>(r.message).sequence);
  ASSERT_EQ(numbers.size(), 300u);
  for (std::uint64_t i = 0; i < 300; ++i) EXPECT_EQ(numbers[i], i);
}

TEST(LocalBus, LateJoinerGetsWhatIsKept) {
  LocalNetwork network({});
  const auto server = network.join(config_of(BusEnd::server));
  for (const Message& message : sample_messages()) server->publish(message);
  const auto late = network.join(config_of(BusEnd::observer));
  std::vector<Received> received;
  late->take(received);
  std::size_t kept = 0;
  for (const TopicSpec& spec : topics) kept += spec.writers == Writers::server && spec.transient_local;
  EXPECT_EQ(received.size(), kept);
  for (const Received& r : received) EXPECT_TRUE(topics[r.message.index()].transient_local);
}

TEST(LocalBus, SlowReaderSeesTheNewestOfEachInstance) {
  LocalNetwork network({});
  const auto server = network.join(config_of(BusEnd::server));
  const auto client = network.join(config_of(BusEnd::observer));
  for (std::uint64_t tick = 0; tick < 10; ++tick)
    for (BodyId body = 0; body < 3; ++body) server->publish(rigid_state(body, tick));
  std::vector<Received> received;
  client->take(received);
  ASSERT_EQ(received.size(), 3u);
  for (const Received& r : received) EXPECT_EQ(std::get<RigidState>(r.message).time.tick, 9u);
}

TEST(LocalBus, LeavingAndCrashingAreNoticed) {
  LocalNetwork network({});
  const auto server = network.join(config_of(BusEnd::server));
  auto leaver = network.join(config_of(BusEnd::observer));
  const auto victim = network.join(config_of(BusEnd::dissector));
  leaver->publish(Presence{1, protocol_version, "leaver", Role::observer, ""});
  victim->publish(Presence{2, protocol_version, "victim", Role::dissector, ""});
  std::vector<Received> received;
  server->take(received);
  ASSERT_EQ(received.size(), 2u);
  leaver.reset();
  network.crash(*victim);
  server->take(received);
  ASSERT_EQ(received.size(), 1u);
  EXPECT_EQ(received[0].liveness, Liveness::gone);
  EXPECT_EQ(std::get<Presence>(received[0].message).participant, 1u);
  network.advance(1s);
  server->take(received);
  ASSERT_EQ(received.size(), 1u);
  EXPECT_EQ(std::get<Presence>(received[0].message).participant, 2u);
}

TEST(LocalBus, FloodsAreCutToTheRateOfTheTopic) {
  LocalNetwork network({});
  const auto server = network.join(config_of(BusEnd::server));
  const auto client = network.join(config_of(BusEnd::dissector));
  std::vector<Received> received;
  std::size_t taken = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    client->publish(grasp_number(i));
    network.advance(1ms);
    server->take(received);
    taken += received.size();
  }
  EXPECT_NEAR(static_cast<double>(taken), 50 + 2 * 50, 3);
  EXPECT_EQ(server->counters().dropped.at("Command: too many per second"), 2000 - taken);
}

TEST(LocalBus, SecondServerWithTheSameIndexIsRefused) {
  LocalNetwork network({});
  const auto server = network.join(config_of(BusEnd::server));
  EXPECT_THROW(network.join(config_of(BusEnd::server)), InputError);
}

}  // namespace
}  // namespace prosector
