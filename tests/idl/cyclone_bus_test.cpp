// The Bus over real DDS on lo, several nodes in one process. A domain a test, so that tests can run at once.

#include "idl/cyclone_bus.h"

#include <gtest/gtest.h>

#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <functional>
#include <set>
#include <thread>

#include "common/clock.h"
#include "common/error.h"
#include "idl/host_conflict_monitor.h"
#include "idl/topics.h"
#include "tests/dds_domains.h"
#include "tests/folders.h"
#include "tests/idl/samples.h"

namespace prosector {
namespace {

using namespace std::chrono_literals;

std::unique_ptr<Bus> join(BusEnd end, std::uint32_t domain, std::uint32_t index = 0,
                          const std::string& session = "prosector", bool arm = false) {
  BusConfig config;
  config.arm = arm;
  config.end = end;
  config.domain = domain;
  config.server_index = index;
  config.session = session;
  return make_cyclone_bus(config);
}

/// Takes until `done` says so; false when that lasts longer than `limit`.
bool take_until(Bus& bus, std::chrono::milliseconds limit, const std::function<bool(const Received&)>& done) {
  const std::int64_t deadline = monotonic_ns() + std::chrono::nanoseconds(limit).count();
  std::vector<Received> received;
  while (monotonic_ns() < deadline) {
    bus.wait(20ms);
    bus.take(received);
    for (const Received& r : received)
      if (done(r)) return true;
  }
  return false;
}

template <class M>
std::function<bool(const Received&)> is() {
  return
      [](const Received& r) { return std::holds_alternative<M>(r.message) && r.liveness == Liveness::alive; };
}

TEST(CycloneBus, EveryTopicArrives) {
  const auto server = join(BusEnd::server, test::dds_domain::cyclone_bus);
  const auto client = join(BusEnd::dissector, test::dds_domain::cyclone_bus, 0, "prosector", true);
  ASSERT_TRUE(server->publish(sample_messages()[0]));
  ASSERT_TRUE(take_until(*client, 2s, is<SessionInfo>()));
  FeltPlanes felt;
  felt.participant = 7;
  EXPECT_FALSE(server->publish(felt)) << "before anybody with an arm is here";
  for (const Message& message : sample_messages()) {
    const bool from_server = topics[message.index()].writers == Writers::server;
    Bus& sender = from_server ? *server : *client;
    Bus& receiver = from_server ? *client : *server;
    bool arrived = false;
    for (int attempt = 0; attempt < 40 && !arrived; ++attempt) {
      sender.publish(message);  // best effort may start before the readers match
      arrived =
          take_until(receiver, 50ms, [&](const Received& r) { return r.message.index() == message.index(); });
    }
    EXPECT_TRUE(arrived) << topics[message.index()].name;
  }
  EXPECT_GT(client->counters().bytes_in, 0u);
}

TEST(CycloneBus, ServerIndexTakenIsAnInputError) {
  const auto server = join(BusEnd::server, test::dds_domain::cyclone_bus + 1);
  EXPECT_THROW(join(BusEnd::server, test::dds_domain::cyclone_bus + 1), InputError);
  BusConfig config;
  config.domain = test::dds_domain::cyclone_bus + 1;
  EXPECT_EQ(find_free_server_index(config), 1u);
}

TEST(CycloneBus, SessionsAreListedAndProbed) {
  const auto first = join(BusEnd::server, test::dds_domain::cyclone_bus + 2, 0, "first");
  const auto second = join(BusEnd::server, test::dds_domain::cyclone_bus + 2, 1, "second");
  SessionInfo info{protocol_version, "first", "minimal", {}, 60, 8, 1};
  ASSERT_TRUE(first->publish(info));
  info.session = "second";
  ASSERT_TRUE(second->publish(info));
  BusConfig config;
  config.domain = test::dds_domain::cyclone_bus + 2;
  const auto sessions = list_sessions(config, 600ms);
  ASSERT_EQ(sessions.size(), 2u);
  EXPECT_EQ(sessions[0].session, "first");
  EXPECT_EQ(sessions[1].session, "second");
  config.session = "second";
  EXPECT_TRUE(HostConflictMonitor(config).other(1s).has_value());
  config.session = "third";
  EXPECT_FALSE(HostConflictMonitor(config).other(400ms).has_value());
}

TEST(CycloneBus, LeavingIsHeard) {
  const auto server = join(BusEnd::server, test::dds_domain::cyclone_bus + 3);
  auto client = join(BusEnd::observer, test::dds_domain::cyclone_bus + 3);
  const Presence presence{9, protocol_version, "Ada", Role::observer, ""};
  ASSERT_TRUE(client->publish(presence));
  ASSERT_TRUE(take_until(*server, 2s, is<Presence>()));
  client.reset();
  std::uint64_t writer = 0;
  EXPECT_TRUE(take_until(*server, 2s, [&](const Received& r) {
    writer = r.writer;
    return r.liveness == Liveness::gone && std::get<Presence>(r.message).participant == 9;
  }));
  EXPECT_NE(writer, 0u);
}

/// Milliseconds from starting the second end to the first sample at the client.
double discovery_ms(bool server_first, std::uint32_t domain) {
  const SessionInfo info{protocol_version, "prosector", "minimal", {}, 60, 8, 1};
  std::unique_ptr<Bus> server, client;
  if (server_first)
    server = join(BusEnd::server, domain);
  else
    client = join(BusEnd::observer, domain);
  std::this_thread::sleep_for(450ms);  // out of step with the other's announcements
  const std::int64_t start = monotonic_ns();
  if (server_first)
    client = join(BusEnd::observer, domain);
  else
    server = join(BusEnd::server, domain);
  server->publish(info);
  EXPECT_TRUE(take_until(*client, 5s, is<SessionInfo>()));
  return static_cast<double>(monotonic_ns() - start) / 1e6;
}

TEST(CycloneBus, DiscoveryTakesHalfASecondAtMostWhoeverIsFirst) {
  const double server_first = discovery_ms(true, test::dds_domain::cyclone_bus + 4),
               client_first = discovery_ms(false, test::dds_domain::cyclone_bus + 5);
  EXPECT_LT(server_first, 500);
  EXPECT_LT(client_first, 500);
  RecordProperty("server_first_ms", std::to_string(server_first));
  RecordProperty("client_first_ms", std::to_string(client_first));
}

TEST(CycloneBus, LateJoinerGetsTwentyMegabytes) {
  const auto server = join(BusEnd::server, test::dds_domain::cyclone_bus + 6);
  AssetChunk chunk;
  chunk.chunks = 80;
  chunk.total_bytes = static_cast<std::uint32_t>(chunk.chunks * asset_chunk_bytes);
  chunk.bytes.assign(asset_chunk_bytes, 0x5a);
  for (chunk.chunk = 0; chunk.chunk < chunk.chunks; ++chunk.chunk) ASSERT_TRUE(server->publish(chunk));
  const std::int64_t start = monotonic_ns();
  const auto client = join(BusEnd::observer, test::dds_domain::cyclone_bus + 6);
  std::set<std::uint32_t> got;
  EXPECT_TRUE(take_until(*client, 10s, [&](const Received& r) {
    if (const auto* asset = std::get_if<AssetChunk>(&r.message)) got.insert(asset->chunk);
    return got.size() == 80;
  }));
  const double ms = static_cast<double>(monotonic_ns() - start) / 1e6;
  EXPECT_LT(ms, 2000);
  RecordProperty("late_join_ms", std::to_string(ms));
}

TEST(CycloneBus, AKilledProcessIsNoticed) {
  const auto server = join(BusEnd::server, test::dds_domain::cyclone_bus + 7);
  const pid_t child = fork();
  if (child == 0) {
    const std::string peer = build_path("bin/idl_peer");
    execl(peer.c_str(), peer.c_str(), "announce", "5",
          std::to_string(test::dds_domain::cyclone_bus + 7).c_str(), nullptr);
    _exit(127);
  }
  const bool came = take_until(*server, 10s, is<Presence>());
  kill(child, SIGKILL);
  const std::int64_t killed = monotonic_ns();
  waitpid(child, nullptr, 0);
  ASSERT_TRUE(came);
  EXPECT_TRUE(take_until(*server, 2500ms, [](const Received& r) {
    return r.liveness == Liveness::gone && std::get<Presence>(r.message).participant == 5;
  }));
  RecordProperty("noticed_ms", std::to_string(static_cast<double>(monotonic_ns() - killed) / 1e6));
}

TEST(CycloneBus, SixtyFourClients) {
  const auto server = join(BusEnd::server, test::dds_domain::cyclone_bus + 8);
  ASSERT_TRUE(server->publish(SessionInfo{protocol_version, "prosector", "minimal", {}, 60, 64, 1}));
  std::vector<std::unique_ptr<Bus>> clients;
  for (std::uint64_t i = 0; i < 64; ++i) {
    clients.push_back(
        join(i % 4 == 0 ? BusEnd::observer : BusEnd::dissector, test::dds_domain::cyclone_bus + 8));
    ASSERT_TRUE(clients.back()->publish(Presence{i + 1, protocol_version, "client", Role::dissector, ""}));
  }
  std::set<std::uint64_t> present, writers;
  EXPECT_TRUE(take_until(*server, 20s, [&](const Received& r) {
    if (const auto* presence = std::get_if<Presence>(&r.message)) {
      present.insert(presence->participant);
      writers.insert(r.writer);
    }
    return present.size() == 64;
  }));
  EXPECT_EQ(writers.size(), 64u);
  for (const auto& client : clients) EXPECT_TRUE(take_until(*client, 5s, is<SessionInfo>()));
}

TEST(CycloneBus, TheEnvironmentDoesNotWidenTheDefault) {
  setenv("CYCLONEDDS_URI", "<CycloneDDS><Domain><NoSuchElement/></Domain></CycloneDDS>", 1);
  const auto server = join(BusEnd::server, test::dds_domain::cyclone_bus + 9);
  EXPECT_NE(server, nullptr);
  unsetenv("CYCLONEDDS_URI");
}

TEST(CycloneBus, BadConfigurationsAreNamed) {
  const auto refused = [](auto&& spoil) {
    BusConfig config;
    spoil(config);
    EXPECT_THROW(make_cyclone_bus(config), InputError);
  };
  refused([](BusConfig& c) { c.session = "*"; });
  refused([](BusConfig& c) { c.session = ""; });
  refused([](BusConfig& c) { c.domain = 231; });
  refused([](BusConfig& c) { c.server_index = 10; });
  refused([](BusConfig& c) { c.profile = "/no/such/file.xml"; });
  refused([](BusConfig& c) { c.profile = "lan", c.interface = "no interface"; });
  refused([](BusConfig& c) { c.peers = {"\"/><Peer Address=\"1.2.3.4"}; });
}

}  // namespace
}  // namespace prosector
