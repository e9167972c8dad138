// Who speaks in another's name changes nothing, over real DDS on lo and over the in-process network: a
// session fed by a bus, Ada who takes part, and a rogue process that knows Ada's id.

#include <gtest/gtest.h>

#include <thread>

#include "common/clock.h"
#include "idl/cyclone_bus.h"
#include "idl/local_bus.h"
#include "server/session/people/session.h"
#include "tests/dds_domains.h"

namespace prosector {
namespace {

using namespace std::chrono_literals;

constexpr ParticipantId ada_id = 7, rogue_id = 66;

SessionRules rules() {
  SessionRules r;
  r.session = "prosector";
  r.input_timeout = 1000000;
  return r;
}

/// One of the two networks; domains differ from test to test, since tests run at once.
class Network {
 public:
  Network(bool dds, std::uint32_t domain) : dds_(dds), domain_(domain) {}
  std::unique_ptr<Bus> join(BusEnd end) {
    BusConfig config;
    config.end = end;
    config.domain = domain_;
    return dds_ ? make_cyclone_bus(config) : local_.join(config);
  }

 private:
  static LocalNetworkConfig real_time() {
    LocalNetworkConfig config;
    config.stepped = false;
    return config;
  }
  bool dds_;
  std::uint32_t domain_;
  LocalNetwork local_{real_time()};
};

Presence presence_of(ParticipantId id, const std::string& name) {
  Presence p;
  p.participant = id;
  p.name = name;
  p.role = Role::dissector;
  return p;
}

Command command_of(ParticipantId id, const CommandBody& body) {
  return {id, 1, body};
}

HandInput hand_of(ParticipantId id, std::uint64_t sequence, const Vec3& at) {
  HandInput i;
  i.participant = id;
  i.sequence = sequence;
  i.hands[right_hand].tracked = true;
  i.hands[right_hand].pose.p = at;
  return i;
}

/// A session that Ada has joined.
struct Room {
  explicit Room(bool dds, std::uint32_t domain)
      : network(dds, domain), server(network.join(BusEnd::server)), ada(network.join(BusEnd::dissector)) {
    ada->publish(presence_of(ada_id, "ada"));
    EXPECT_TRUE(pump(5000ms, [&] {
      if (!ada_is_in()) ada->publish(command_of(ada_id, Join{}));
      return ada_is_in();
    }));
  }

  Network network;
  Session session{rules()};
  std::unique_ptr<Bus> server, ada;
  std::uint64_t tick = 0;
  std::vector<HandTarget> targets;  // all that were consumed

  bool ada_is_in() const { return session.roster().members().contains(ada_id); }
  std::uint64_t refused() const {
    return server->counters().dropped_total + session.output().dropped_total();
  }

  /// Ticks until `done`, for at most `limit`; what `done` returned last.
  template <class Done>
  bool pump(std::chrono::milliseconds limit, Done done) {
    const std::int64_t deadline = monotonic_ns() + std::chrono::nanoseconds(limit).count();
    std::vector<Received> received;
    while (monotonic_ns() < deadline) {
      server->wait(5ms);
      server->take(received);
      const ConsumedInput in = session.consume(received, ++tick);
      targets.insert(targets.end(), in.input.targets.begin(), in.input.targets.end());
      if (done()) return true;
      std::this_thread::sleep_for(5ms);
    }
    return false;
  }
  /// Waits, without ticking, until the server would hear this end.
  static void wait_until_heard(Bus& bus) {
    for (int i = 0; i < 400 && !bus.publish(command_of(rogue_id, Leave{})); ++i)
      std::this_thread::sleep_for(10ms);
    std::this_thread::sleep_for(100ms);
  }
};

class Forgery : public testing::TestWithParam<bool> {};  // true: DDS

TEST_P(Forgery, AHandInAnothersNameIsRefused) {
  Room room(GetParam(), test::dds_domain::forgery);
  const auto rogue = room.network.join(BusEnd::dissector);
  Room::wait_until_heard(*rogue);
  const Vec3 hers(0.1, 0.2, 0.3), forged(0.9, 0.9, 0.9);
  std::uint64_t sequence = 0;
  EXPECT_TRUE(room.pump(5000ms, [&] {
    room.ada->publish(hand_of(ada_id, ++sequence, hers));
    room.pump(20ms, [] { return false; });
    rogue->publish(hand_of(ada_id, 1000000 + sequence, forged));
    return room.targets.size() >= 5 && room.refused() >= 5;
  }));
  for (const HandTarget& target : room.targets) EXPECT_LT((target.target.p - hers).norm(), 1e-6);
}

TEST_P(Forgery, ARogueCannotEndAnothersPresenceNorHideItsEnd) {
  Room room(GetParam(), test::dds_domain::forgery + 1);
  const auto rogue = room.network.join(BusEnd::dissector);
  Room::wait_until_heard(*rogue);
  EXPECT_TRUE(room.pump(5000ms, [&] {
    rogue->dispose(presence_of(ada_id, "ada"));
    return room.refused() > 0;
  }));
  room.pump(200ms, [] { return false; });
  EXPECT_TRUE(room.ada_is_in());
  room.ada.reset();  // the instance was ended already, as far as DDS knows
  EXPECT_TRUE(room.pump(4000ms, [&] { return !room.ada_is_in(); }));
}

TEST_P(Forgery, AForgedPresenceThatEndsTakesNobodyAlong) {
  Room room(GetParam(), test::dds_domain::forgery + 2);
  auto rogue = room.network.join(BusEnd::dissector);
  Room::wait_until_heard(*rogue);
  rogue->publish(presence_of(ada_id, "ada"));
  EXPECT_TRUE(room.pump(5000ms, [&] {
    return room.session.output().dropped().contains("Presence: another process's participant");
  }));
  rogue.reset();
  room.pump(500ms, [] { return false; });
  EXPECT_TRUE(room.ada_is_in());
  room.ada.reset();
  EXPECT_TRUE(room.pump(4000ms, [&] { return !room.ada_is_in(); }));
}

TEST_P(Forgery, AProcessThatIsGoneBeforeItIsHeardEndsNobody) {
  Room room(GetParam(), test::dds_domain::forgery + 3);
  auto rogue = room.network.join(BusEnd::dissector);
  Room::wait_until_heard(*rogue);
  rogue->publish(presence_of(rogue_id, "rogue"));
  rogue->publish(command_of(rogue_id, Join{}));
  rogue->publish(hand_of(ada_id, 1000000, {0.9, 0.9, 0.9}));
  rogue->dispose(presence_of(ada_id, "ada"));
  std::this_thread::sleep_for(200ms);
  rogue.reset();
  std::this_thread::sleep_for(300ms);
  room.pump(200ms, [] { return false; });
  EXPECT_TRUE(room.ada_is_in());
  EXPECT_TRUE(room.targets.empty());
  EXPECT_FALSE(room.session.roster().members().contains(rogue_id));
  EXPECT_GT(room.refused(), 0u);
}

INSTANTIATE_TEST_SUITE_P(Networks, Forgery, testing::Bool(),
                         [](const auto& info) { return std::string(info.param ? "Dds" : "InProcess"); });

}  // namespace
}  // namespace prosector
