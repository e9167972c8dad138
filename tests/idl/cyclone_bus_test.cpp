// The Bus over real DDS on lo, several nodes in one process. A domain a test, so that tests can run at once.

#include "idl/cyclone_bus.h"

#include <gtest/gtest.h>

#include <functional>
#include <set>

#include "common/clock.h"
#include "common/error.h"
#include "idl/topics.h"
#include "tests/idl/samples.h"

namespace prosector {
namespace {

using namespace std::chrono_literals;

std::unique_ptr<Bus> join(BusEnd end, std::uint32_t domain, std::uint32_t index = 0,
                          const std::string& session = "prosector") {
  BusConfig config;
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
  const auto server = join(BusEnd::server, 61);
  const auto client = join(BusEnd::dissector, 61);
  ASSERT_TRUE(server->publish(sample_messages()[0]));
  ASSERT_TRUE(take_until(*client, 2s, is<SessionInfo>()));
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
  const auto server = join(BusEnd::server, 62);
  EXPECT_THROW(join(BusEnd::server, 62), InputError);
  BusConfig config;
  config.domain = 62;
  EXPECT_EQ(free_server_index(config), 1u);
}

TEST(CycloneBus, SessionsAreListedAndProbed) {
  const auto first = join(BusEnd::server, 63, 0, "first");
  const auto second = join(BusEnd::server, 63, 1, "second");
  SessionInfo info{protocol_version, "first", "minimal", {}, 60, 8, 1};
  ASSERT_TRUE(first->publish(info));
  info.session = "second";
  ASSERT_TRUE(second->publish(info));
  BusConfig config;
  config.domain = 63;
  const auto sessions = list_sessions(config, 600ms);
  ASSERT_EQ(sessions.size(), 2u);
  EXPECT_EQ(sessions[0].session, "first");
  EXPECT_EQ(sessions[1].session, "second");
  config.session = "second";
  EXPECT_TRUE(probe_session(config, 1s).has_value());
  config.session = "third";
  EXPECT_FALSE(probe_session(config, 400ms).has_value());
}

TEST(CycloneBus, LeavingIsHeard) {
  const auto server = join(BusEnd::server, 64);
  auto client = join(BusEnd::observer, 64);
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

}  // namespace
}  // namespace prosector
