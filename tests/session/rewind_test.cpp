// The host rewinds a session in which others look on: everyone follows into the new epoch, and the journal
// repeats it.

#include <gtest/gtest.h>

#include <algorithm>

#include "server/session/replay.h"
#include "tests/physics/scalpel.h"
#include "tests/session/hosted.h"
#include "tests/session/temporary_file.h"

namespace prosector {
namespace {

using test::Guest;
using test::Hosted;

constexpr BodyId block = 1;  // or membrane

enum class Tissue { block, mass_spring, xpbd };

/// So tender, and the blade so long, that nothing is left whole behind it.
SceneDesc tender(Tissue tissue) {
  SceneDesc scene = tissue == Tissue::block         ? test::block_and_scalpel()
                    : tissue == Tissue::mass_spring ? test::membrane_and_scalpel("mass_spring")
                                                    : test::membrane_and_scalpel("xpbd");
  scene.name = "rewound";
  scene.soft[0].toughness = 0;
  scene.rigid[0].edges = {{{0, 0, 0}, {0, -0.2, 0}}};
  return scene;
}

/// A host who cuts, and an observer, over a network that loses and delays.
struct Dissection {
  Dissection(Journal* journal, Tissue tissue) : hosted(network(), journal, 1, tender(tissue)) {
    hosted.tick();
    ada = hosted.guest(1, BusEnd::dissector);
    eve = hosted.guest(2, BusEnd::observer);
    ada.greet("ada", Role::host);
    eve.greet("eve", Role::observer);
    run(20);
    hand_is_there = true;  // where the scalpel is
    for (int i = 0; i < 30 && !holds(); ++i) {
      ada.command(CommandKind::grasp);
      run(1);
    }
    run(20);
  }
  static LocalNetworkConfig network() {
    LocalNetworkConfig config;
    config.stepped = true;
    config.loss = 0.05;
    config.delay = std::chrono::milliseconds(20);
    config.jitter = std::chrono::milliseconds(10);
    return config;
  }
  void run(int ticks, double speed = 0) {
    for (int i = 0; i < ticks; ++i) {
      at.x() += speed;
      if (hand_is_there) ada.bus->publish(ada.hand_at(at));
      hosted.tick();
      for (Guest* guest : {&ada, &eve}) guest->take();
    }
  }
  void rewind(std::uint32_t revision) {
    Command c;
    c.participant = ada.id;
    c.sequence = ++ada.sequence;
    c.kind = CommandKind::rewind;
    c.body = block;
    c.revision = revision;
    ada.bus->publish(c);
  }
  bool holds() const {
    return !hosted.simulation.hands().empty() && hosted.simulation.hands()[0].holding == test::scalpel;
  }
  std::uint64_t mesh() const { return hosted.simulation.soft(block).content_hash(); }

  Hosted hosted;
  Guest ada, eve;
  Vec3 at{-0.12, 0.14, 0.02};
  bool hand_is_there = false;
};

/// Largest distance of what a client draws from what the server has, m.
double error(Hosted& hosted, Guest& guest, BodyId body) {
  SoftReplica* soft = guest.replica.soft(body);
  if (soft == nullptr) return 1;
  soft->sample(static_cast<double>(hosted.simulation.time().tick) + 1, 1.0 / 60);
  const Anatomy& anatomy = hosted.simulation.soft(body).anatomy();
  const double* x = hosted.simulation.soft_state(body).motion.x.data();
  double worst = 0;
  std::vector<Vec3> drawn;
  for (const auto& triangle : soft->rest().triangles)
    if (triangle[0] != triangle[1])
      for (const std::uint32_t corner : triangle) drawn.push_back(soft->surface()[corner].cast<double>());
  EXPECT_EQ(drawn.size(), 3 * anatomy.surface.triangles.size());
  for (std::size_t v = 0; v < anatomy.embedding.rows.size(); ++v) {
    const Vec3 there = anatomy.embedding.apply(v, x);
    double nearest = 1;
    for (const Vec3& point : drawn) nearest = std::min(nearest, (point - there).norm());
    worst = std::max(worst, nearest);
  }
  return worst;
}

class RewoundSession : public testing::TestWithParam<Tissue> {};

TEST_P(RewoundSession, EveryoneFollowsIntoTheNewEpochAndTheJournalRepeatsIt) {
  const SceneDesc scene = tender(GetParam());
  const test::TemporaryFile file("rewound");
  std::uint64_t last_hash = 0;
  {
    const Simulation compiled(scene, test::options());
    const auto journal = Journal::create(
        file.path, {"scene.toml", "name = \"rewound\"", "prosector", compiled.content_hash(), {}},
        JournalLimits{});
    Dissection room(journal.get(), GetParam());
    Hosted& hosted = room.hosted;
    const std::uint64_t uncut = room.mesh();
    ASSERT_TRUE(room.holds());
    while (hosted.simulation.revision(block) < 4 && room.at.x() < 0.05) room.run(1, 0.0016);
    const std::uint32_t half = hosted.simulation.revision(block);
    const std::uint64_t half_mesh = room.mesh();
    ASSERT_EQ(half, 4u);
    while (room.at.x() < 0.13) room.run(1, 0.0016);
    const std::uint32_t whole = hosted.simulation.revision(block);
    ASSERT_EQ(hosted.simulation.body_count(), 3u);

    room.rewind(half);
    room.run(60);
    EXPECT_TRUE(room.ada.results.back().accepted) << room.ada.results.back().reason;
    EXPECT_EQ(hosted.simulation.time().epoch, 1u);
    EXPECT_EQ(hosted.simulation.revision(block), whole + 1);
    EXPECT_EQ(room.mesh(), half_mesh);
    room.rewind(whole + 40);
    room.run(10);
    EXPECT_FALSE(room.ada.results.back().accepted);
    EXPECT_NE(room.ada.results.back().reason.find("0 to"), std::string::npos)
        << room.ada.results.back().reason;
    room.rewind(0);
    room.run(10);
    EXPECT_EQ(room.mesh(), uncut);
    room.rewind(whole);  // forward again: what was rewound is in the log, too
    room.run(60);
    EXPECT_FALSE(hosted.simulation.surface(2).triangles.empty());
    Guest late = hosted.guest(3, BusEnd::observer);
    late.greet("late", Role::observer);
    for (int i = 0; i < 150; ++i) {
      room.run(1);
      late.take();
    }
    const auto scalpel_off = [&](const Guest& guest) {
      const double tick = static_cast<double>(hosted.simulation.time().tick);
      return (guest.replica.rigid_pose(test::scalpel, tick).p -
              hosted.simulation.rigid_state(test::scalpel).pose.p)
          .norm();
    };
    constexpr double near = 1e-3;  // m
    // What comes to rest may have been lost on its way: it is sent again now and then.
    for (int i = 0;
         i < 120 && std::max({scalpel_off(room.ada), scalpel_off(room.eve), scalpel_off(late)}) >= near;
         ++i) {
      room.run(1);
      late.take();
    }
    for (Guest* guest : {&room.ada, &room.eve, &late}) {
      SCOPED_TRACE(testing::Message() << "client " << guest->id);
      const Replica& seen = guest->replica;
      ASSERT_TRUE(seen.complete()) << seen.missing();
      EXPECT_EQ(seen.refused(), 0u);
      EXPECT_EQ(seen.topology_hash(), room.ada.replica.topology_hash());
      EXPECT_EQ(guest->replica.soft(block)->revision(), hosted.simulation.revision(block));
      for (const BodyId body : {block, BodyId{2}}) EXPECT_LT(error(hosted, *guest, body), 1e-4);
      EXPECT_LT(scalpel_off(*guest), near);
    }
    hosted.loop.finish();
    last_hash = hosted.simulation.state_hash();
  }
  Simulation again(scene, test::options(2));
  const ReplayResult result = replay(JournalReader(file.path), again, {});
  EXPECT_TRUE(result) << *result.first_difference;
  EXPECT_EQ(result.last_hash, last_hash);
}

INSTANTIATE_TEST_SUITE_P(Tissues, RewoundSession,
                         testing::Values(Tissue::block, Tissue::mass_spring, Tissue::xpbd));

}  // namespace
}  // namespace prosector
