// Cuts from the server's log to clients over a network that loses, delays and reorders: every client ends up
// with the same, or asks.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "client/replica/replica.h"
#include "idl/local_bus.h"
#include "idl/topics.h"
#include "server/session/sending/scene_content.h"
#include "server/session/sending/soft_sender.h"
#include "tests/physics/scenes.h"
#include "tests/session/random_cuts.h"

namespace prosector {
namespace {

using test::CutBody;

/// A server of bodies that are only cut.
struct Cutter : SoftShapes {
  explicit Cutter(const LocalNetworkConfig& config = {}) : network(config), bus(join(BusEnd::server)) {
    bodies.emplace_back(test::make_block({0.1, 0.1, 0.1}, {3, 3, 3}), 0);
    content.surfaces.try_emplace(0, bodies[0].anatomy, bodies[0].numbering, bodies[0].change, SimTime{0, 0});
    content.scene.name = "cut";
    content.scene.bodies.push_back(describe(0, content.surfaces.at(0)));
    SceneBody& described = content.scene.bodies[0];
    TopologyRevision first = content.surfaces.at(0).newest();
    SessionInfo info;
    info.session = "prosector";
    info.scene = "cut";
    info.server_run = 1;
    bus->publish(info);
    for (const Asset& asset : content.surfaces.at(0).keyframe())
      for (const AssetChunk& chunk : chunks_of(asset)) bus->publish(chunk);
    first.mesh = described.mesh = content.surfaces.at(0).keyframe()[0].hash;
    first.map = described.map = content.surfaces.at(0).keyframe()[1].hash;
    bus->publish(content.scene);
    bus->publish(first);
    log.emplace(content, 60);
  }

  Shape shape(BodyId body) const override {
    return {bodies[body].anatomy, bodies[body].numbering, bodies[body].x};
  }
  SceneBody describe(BodyId, const SurfaceLog& surface) const override {
    SceneBody out;
    out.name = "liver";
    out.kind = BodyKind::soft;
    out.points = surface.stream()->points;
    out.chunk_points = surface.stream()->chunk_points;
    return out;
  }

  std::unique_ptr<Bus> join(BusEnd end) {
    BusConfig config;
    config.end = end;
    return network.join(config);
  }
  void say(const std::vector<Outgoing>& out) {
    for (const Outgoing& o : out)
      if (o.dispose)
        bus->dispose(o.message);
      else
        EXPECT_TRUE(bus->publish(o.message)) << topics[o.message.index()].name;
  }

  /// A tick: `changed` are followed, then every body's state is sent.
  void tick(const std::vector<TopologyChange>& changed) {
    ++time.tick;
    std::vector<Outgoing> out;
    log->follow(*this, changed, time, roster, out);
    bus->take(received);
    for (const Received& r : received)
      if (const auto* c = std::get_if<Command>(&r.message)) {
        ++asked;
        log->ask_keyframe(std::get<RequestKeyframe>(c->body).body);
      }
    log->send_keyframes(time, out);
    say(out);
    for (BodyId b = 0; b < bodies.size(); ++b) {
      bodies[b].move(seconds());
      std::vector<Message> states;
      senders.try_emplace(b, b, 60).first->second.update(
          {b, false, log->revision(b), std::make_shared<VecX>(bodies[b].x),
           std::make_shared<VecX>(VecX::Zero(bodies[b].x.size())), log->stream(b)},
          time, false, states);
      for (const Message& m : states) bus->publish(m);
    }
    network.advance(std::chrono::microseconds(16667));
  }
  double seconds() const { return static_cast<double>(std::min(time.tick, last_moving_tick)) / 60; }
  void cut() {
    bodies[0].cut(random, seconds());
    tick({bodies[0].change});
  }
  void cut_piece() {
    bodies[0].cut(random, 0);
    CutBody piece(test::make_block({0.03, 0.03, 0.03}, {1, 1, 1}), static_cast<BodyId>(bodies.size()));
    piece.change.cause = TopologyCause::cut;
    piece.change.piece_of = 0;
    bodies.push_back(piece);
    tick({bodies[0].change, piece.change});
  }

  LocalNetwork network;
  std::unique_ptr<Bus> bus;
  std::mt19937_64 random{31};
  std::vector<CutBody> bodies;
  SceneContent content;
  std::optional<TopologyLog> log;
  Roster roster{SessionRules{}};
  std::map<BodyId, SoftSender> senders;
  std::vector<Received> received;
  SimTime time;
  std::uint64_t last_moving_tick = ~std::uint64_t{0};
  int asked = 0;
};

struct Client {
  explicit Client(Cutter& server) : server(server), bus(server.join(BusEnd::observer)) {}
  Cutter& server;
  std::unique_ptr<Bus> bus;
  Replica replica;
  std::uint64_t sequence = 0;
  std::vector<Received> received;

  /// `spoil` may change what arrived.
  template <class Spoil>
  void take(const Spoil& spoil) {
    bus->take(received);
    for (Received& r : received)
      if (spoil(r)) replica.apply(r);
    for (const BodyId body : replica.bodies().take_keyframe_requests(server.network.now_ns())) {
      bus->publish(Command{9, ++sequence, RequestKeyframe{body}});
    }
  }
  void take() {
    take([](Received&) { return true; });
  }
  /// Largest distance between what is drawn of a body and what the server has, m; 1e9: not the same
  /// triangles.
  float error(BodyId body) {
    SoftReplica* soft = replica.bodies().soft(body);
    if (soft == nullptr) return 1e9f;
    soft->sample(static_cast<double>(server.time.tick) + 1, 1.0 / 60);
    return test::largest_difference(
        test::facets(soft->rest().triangles, [&](std::uint32_t v) { return soft->surface()[v]; }),
        test::facets_of(server.bodies[body]));
  }
};

LocalNetworkConfig stepped(double loss = 0, int delay_ms = 0) {
  LocalNetworkConfig config;
  config.stepped = true;
  config.loss = loss;
  config.delay = std::chrono::milliseconds(delay_ms);
  config.jitter = std::chrono::milliseconds(delay_ms / 2);
  return config;
}

TEST(Topology, EveryClientSeesTheSameCutsOverABadNetwork) {
  Cutter server(stepped(0.3, 40));
  Client early(server);
  for (int n = 0; n < 40; ++n) {
    server.cut();
    early.take();
  }
  Client late(server);
  server.last_moving_tick = server.time.tick + 20;
  for (int n = 0; n < 150; ++n) {
    server.tick({});
    early.take();
    late.take();
  }
  ASSERT_TRUE(early.replica.complete());
  ASSERT_TRUE(late.replica.complete()) << late.replica.missing();
  EXPECT_EQ(early.replica.bodies().topology_hash(), late.replica.bodies().topology_hash());
  EXPECT_EQ(early.replica.bodies().soft(0)->revision(), 40u);
  EXPECT_EQ(late.replica.bodies().soft(0)->revision(), 40u);
  EXPECT_LT(early.error(0), 1e-4f);
  EXPECT_LT(late.error(0), 1e-4f);
  EXPECT_EQ(early.replica.refused() + late.replica.refused(), 0u);
  EXPECT_EQ(server.asked, 0);
}

TEST(Topology, SurfacesFollowWithinTheTickThatCut) {
  Cutter server(stepped());
  Client client(server);
  server.tick({});
  client.take();
  for (int n = 0; n < 40; ++n) {
    server.cut();
    client.take();
    ASSERT_LT(client.error(0), 1e-4f) << "cut " << n;
  }
}

TEST(Topology, ALateJoinerGetsAKeyframeAndOnlyTheRevisionsAfterIt) {
  Cutter server(stepped());
  for (int n = 0; n < 37; ++n) server.cut();
  Client late(server);
  std::vector<std::uint32_t> seen;
  for (int n = 0; n < 40; ++n) {
    server.tick({});
    late.take([&](Received& r) {
      if (const auto* revision = std::get_if<TopologyRevision>(&r.message))
        seen.push_back(revision->revision);
      return true;
    });
  }
  EXPECT_EQ(seen, (std::vector<std::uint32_t>{32, 33, 34, 35, 36, 37}));
  EXPECT_EQ(late.replica.bodies().soft(0)->revision(), 37u);
  EXPECT_LT(late.error(0), 1e-4f);
}

TEST(Topology, PiecesAppearAsBodiesOfTheirOwn) {
  Cutter server(stepped());
  Client client(server);
  server.tick({});
  client.take();
  ASSERT_TRUE(client.replica.complete());
  server.cut_piece();
  server.cut_piece();
  client.take();
  Client late(server);
  server.tick({});
  client.take();
  for (int n = 0; n < 40; ++n) {
    server.tick({});
    late.take();
    client.take();
  }
  for (Client* c : {&client, &late}) {
    ASSERT_EQ(c->replica.scene()->bodies.size(), 3u);
    EXPECT_EQ(c->replica.scene()->bodies[1].name, "liver piece 1");
    EXPECT_EQ(c->replica.scene()->bodies[2].name, "liver piece 2");
    for (const BodyId body : {0u, 1u, 2u}) EXPECT_LT(c->error(body), 1e-4f) << "body " << body;
  }
  EXPECT_EQ(client.replica.bodies().topology_hash(), late.replica.bodies().topology_hash());
}

TEST(Topology, OrderAndRepetitionDoNotMatter) {
  Cutter server(stepped());
  Client plain(server), shuffled(server);
  server.tick({});
  plain.take();
  shuffled.take();
  std::vector<Received> revisions;
  for (int n = 0; n < 10; ++n) {
    server.cut();
    plain.take();
    shuffled.take([&](Received& r) {
      if (!std::holds_alternative<TopologyRevision>(r.message)) return true;
      revisions.push_back(r);
      return false;
    });
    EXPECT_EQ(shuffled.replica.bodies().soft(0)->revision(), 0u) << "the old surface stays";
  }
  for (const std::size_t n : {3, 9, 0, 3, 1, 2, 5, 4, 8, 0, 7, 6}) shuffled.replica.apply(revisions[n]);
  EXPECT_EQ(shuffled.replica.bodies().soft(0)->revision(), 10u);
  EXPECT_EQ(shuffled.replica.bodies().topology_hash(), plain.replica.bodies().topology_hash());
  EXPECT_EQ(shuffled.replica.refused(), 0u);
  server.tick({});
  shuffled.take();
  EXPECT_LT(shuffled.error(0), 1e-4f);
}

TEST(Topology, WhatDoesNotProveRightIsNotShownAndAKeyframeAskedFor) {
  const std::vector<void (*)(TopologyRevision&)> spoils = {
      [](TopologyRevision& m) { m.patch.triangles.pop_back(); },       // a surface of another hash
      [](TopologyRevision& m) { m.patch.vertices.back().slot += 3; },  // that doesn't fit
      [](TopologyRevision& m) { m.content_hash ^= 1; },                // a chain that is broken
      [](TopologyRevision& m) {
        m.previous_hash ^= 1;
        m.chain_hash = chain_hash_of(m);
      },  // of another past
  };
  for (std::size_t spoil = 0; spoil < spoils.size(); ++spoil) {
    Cutter server(stepped());
    Client client(server);
    server.tick({});
    client.take();
    for (std::uint32_t n = 0; n < 4; ++n) {
      server.cut();
      client.take([&](Received& r) {
        auto* revision = std::get_if<TopologyRevision>(&r.message);
        if (revision != nullptr && revision->revision == 3) spoils[spoil](*revision);
        return true;
      });
      EXPECT_EQ(client.replica.bodies().soft(0)->revision(), n < 2 ? n + 1u : n == 2 ? 2u : 4u);
    }
    EXPECT_GE(client.replica.refused(), 1u);
    for (int n = 0; n < 40; ++n) {
      server.tick({});
      client.take();
    }
    EXPECT_EQ(client.replica.bodies().soft(0)->revision(), 4u) << "spoil " << spoil;
    EXPECT_LT(client.error(0), 1e-4f);
    EXPECT_EQ(server.asked, 1) << "asked once, and answered";
  }
}

TEST(Topology, ALostRevisionIsMissedAfterAWhile) {
  Cutter server(stepped());
  Client client(server);
  server.tick({});
  client.take();
  for (int n = 0; n < 3; ++n) {
    server.cut();
    client.take([](Received& r) {
      const auto* revision = std::get_if<TopologyRevision>(&r.message);
      return revision == nullptr || revision->revision != 2;
    });
  }
  for (int n = 0; n < 30; ++n) {
    server.tick({});
    client.take();
  }
  EXPECT_EQ(client.replica.bodies().soft(0)->revision(), 1u);
  EXPECT_EQ(server.asked, 0) << "it may still come";
  for (int n = 0; n < 60; ++n) {
    server.tick({});
    client.take();
  }
  EXPECT_EQ(client.replica.bodies().soft(0)->revision(), 3u);
  EXPECT_EQ(server.asked, 1);
}

TEST(Topology, KeyframesAreSentOnceASecondHoweverOftenTheyAreAskedFor) {
  Cutter server(stepped());
  server.cut();
  std::size_t keyframes = 0;
  for (int n = 0; n < 180; ++n) {
    server.log->ask_keyframe(0);
    server.log->ask_keyframe(77);  // there is none: ignored
    std::vector<Outgoing> out;
    ++server.time.tick;
    server.log->send_keyframes(server.time, out);
    for (const Outgoing& o : out) {
      const auto* revision = std::get_if<TopologyRevision>(&o.message);
      keyframes += revision != nullptr && !o.dispose;
    }
  }
  EXPECT_EQ(keyframes, 3u);
}

TEST(SceneContent, PiecesAreNumberedInEachLanguage) {
  SceneBody liver;
  liver.name = "liver";
  liver.names = {{"de", "Leber"}, {"tr", std::string(max_name_length, 'x')}};
  SceneInfo scene;
  scene.bodies = {liver};
  for (const std::string number : {" 1", " 2"}) {
    SceneBody piece = liver;
    name_piece(piece, scene);
    EXPECT_EQ(piece.name, "liver piece" + number);
    EXPECT_EQ(piece.names[0].name, "Leber" + number);
    EXPECT_EQ(piece.names[1].name, std::string(max_name_length - 2, 'x') + number);
    scene.bodies.push_back(piece);
  }
  SceneBody first = liver;
  name_piece(first, SceneInfo{});
  EXPECT_EQ(first.name, "liver");
  EXPECT_EQ(first.names, liver.names);
}

}  // namespace
}  // namespace prosector
