// The host rewinds a session in which others look on: everyone follows into the new epoch, and the journal
// repeats it.

#include <gtest/gtest.h>

#include <algorithm>

#include "server/session/journal/replay.h"
#include "tests/session/dissection.h"
#include "tests/session/temporary_file.h"

namespace prosector {
namespace {

using test::cut_body;
using test::Dissection;
using test::error;
using test::Guest;
using test::Hosted;
using test::tender;
using test::Tissue;

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
    while (hosted.simulation.revision(cut_body) < 4 && room.at.x() < 0.05) room.run(1, 0.0016);
    const std::uint32_t half = hosted.simulation.revision(cut_body);
    const std::uint64_t half_mesh = room.mesh();
    ASSERT_EQ(half, 4u);
    while (room.at.x() < 0.13) room.run(1, 0.0016);
    const std::uint32_t whole = hosted.simulation.revision(cut_body);
    ASSERT_EQ(hosted.simulation.body_count(), 3u);

    room.rewind(half);
    room.run(60);
    EXPECT_TRUE(room.ada.answer().accepted) << room.ada.answer().reason;
    EXPECT_EQ(hosted.simulation.time().epoch, 1u);
    EXPECT_EQ(hosted.simulation.revision(cut_body), whole + 1);
    EXPECT_EQ(room.mesh(), half_mesh);
    room.rewind(whole + 40);
    room.run(10);
    EXPECT_FALSE(room.ada.answer().accepted);
    EXPECT_NE(room.ada.answer().reason.find("0 to"), std::string::npos) << room.ada.answer().reason;
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
      EXPECT_EQ(seen.bodies().topology_hash(), room.ada.replica.bodies().topology_hash());
      EXPECT_EQ(guest->replica.bodies().soft(cut_body)->revision(), hosted.simulation.revision(cut_body));
      for (const BodyId body : {cut_body, BodyId{2}}) EXPECT_LT(error(hosted.simulation, *guest, body), 1e-4);
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
