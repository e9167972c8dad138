// Tissue that a held scalpel cuts: through the whole simulation.

#include <gtest/gtest.h>

#include <algorithm>

#include "common/error.h"
#include "server/physics/mechanics/organs/cut_records.h"
#include "server/physics/mechanics/organs/organ.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scalpel.h"

namespace prosector::test {
namespace {

double all_mass(const Simulation& simulation, std::size_t bodies) {
  double sum = 0;
  for (BodyId body = 1; body <= bodies; ++body) sum += simulation.soft(body).total_mass();
  return sum;
}

TEST(Organ, HeldScalpelCutsABlockInTwo) {
  Simulation simulation(block_and_scalpel(), options());
  const double mass = simulation.soft(1).total_mass();
  Vec3 at = take(simulation);
  const std::vector<TopologyChange> changes = draw(simulation, at, 150);
  ASSERT_EQ(simulation.body_count(), 3U);
  EXPECT_NEAR(all_mass(simulation, 2), mass, 1e-12 * mass);
  EXPECT_GT(simulation.soft(2).total_mass(), 0.4 * mass);
  EXPECT_GT(simulation.soft(1).total_mass(), 0.4 * mass);
  EXPECT_EQ(simulation.name(2), "block piece 1");
  ASSERT_FALSE(changes.empty());
  for (const TopologyChange& change : changes) {
    EXPECT_EQ(change.author, somebody);
    EXPECT_EQ(change.cause, TopologyCause::cut);
    EXPECT_EQ(change.piece_of.has_value(), change.body == 2 && change.revision == 0);
  }
  EXPECT_EQ(simulation.revision(1),
            static_cast<std::uint32_t>(std::count_if(changes.begin(), changes.end(),
                                                     [](const TopologyChange& c) { return c.body == 1; })));
}

TEST(Organ, ToughTissueIsDrawnAlongInsteadOfCut) {
  for (const double toughness : {10.0, 1e5}) {
    SceneDesc scene = block_and_scalpel();
    scene.soft[0].material.toughness = toughness;
    Simulation simulation(scene, options());
    const std::size_t elements = tet_count(simulation);
    Vec3 at = take(simulation);
    draw(simulation, at, 60);  // 2.6 cm into it
    if (toughness > 1000) {
      EXPECT_GT(simulation.max_displacement(1), 0.01);
      EXPECT_LT(tet_count(simulation), elements + elements / 20);  // at its edges the blade slips past
    } else {
      EXPECT_LT(simulation.max_displacement(1), 0.005);
      EXPECT_GT(tet_count(simulation), elements + elements / 10);
    }
  }
}

TEST(Organ, AMeshThatCannotBeCutSaysSoAndTheRunGoesOn) {
  CompileOptions flat = options();
  const auto made = flat.anatomy;
  flat.anatomy = [&](const SoftDesc& desc) {
    auto anatomy = made(desc);
    const std::array<std::uint32_t, 4> tet = anatomy->tets.tets.front();
    anatomy->tets.tets.push_back({tet[0], tet[1], tet[2], tet[2]});
    return anatomy;
  };
  Simulation simulation(block_and_scalpel(), flat);
  Vec3 at = take(simulation);
  std::string note;
  for (int i = 0; i < 80; ++i) {
    at.x() += 0.0016;
    for (const BodyReport& row : simulation.step(target(at)).bodies)
      if (row.note.find("cutting") != std::string::npos) note = row.note;
  }
  EXPECT_NE(note, "") << "nobody was told";
  EXPECT_EQ(simulation.revision(1), 0U);
}

TEST(Organ, ACutWhosePiecesCannotBeSolvedIsTakenBackAndToldOf) {
  CompileOptions least_fragment = options();
  const auto made = least_fragment.anatomy;
  least_fragment.anatomy =
      [&](const SoftDesc& desc) {  // a flat tetrahedron by itself: no body can be made of it
        auto anatomy = made(desc);
        const auto n = static_cast<std::uint32_t>(anatomy->tets.positions.size());
        for (const Vec3& x : {Vec3(0, 0, 0), Vec3(0.01, 0, 0), Vec3(0, 0.01, 0), Vec3(0.003, 0.003, 1e-6)})
          anatomy->tets.positions.push_back(Vec3(0, 0.03, 0.03) + x);
        anatomy->tets.tets.push_back({n, n + 1, n + 2, n + 3});
        return anatomy;
      };
  Simulation simulation(block_and_scalpel(), least_fragment);
  const std::uint64_t uncut = simulation.soft(1).content_hash();
  Vec3 at = take(simulation);
  std::string note;
  for (int i = 0; i < 80; ++i) {
    at.x() += 0.0016;
    const StepReport& report = simulation.step(target(at));
    EXPECT_TRUE(report.topology.empty());
    for (const BodyReport& row : report.bodies)
      if (row.note.find("the cut was undone") != std::string::npos) note = row.body + ": " + row.note;
  }
  EXPECT_EQ(note.rfind("block: ", 0), 0U) << note;
  EXPECT_EQ(simulation.revision(1), 0U);
  EXPECT_EQ(simulation.body_count(), 2U);
  EXPECT_EQ(simulation.soft(1).content_hash(), uncut);
  const std::vector<std::uint8_t> saved = simulation.checkpoint();
  Simulation restored(block_and_scalpel(), least_fragment);
  restored.restore(saved);
  EXPECT_EQ(restored.state_hash(), simulation.state_hash());
}

TEST(Organ, GoesBackToAMarkBitForBit) {
  const Simulation simulation(block_and_scalpel(), options());
  const soft::SoftBody& body = simulation.soft(1);
  organs::Organ organ(0, body.anatomy(), body.desc().material.density),
      other(0, body.anatomy(), body.desc().material.density);
  const auto bytes = [](const organs::Organ& o) {
    ByteWriter out;
    RecordWriter io(out);
    organs::entry(io, o.log());
    organs::entry(io, o.mark().pieces);
    return out.bytes();
  };
  const auto cut_at = [](organs::Organ& o, double z, std::uint64_t number) {
    std::vector<Vec3> x(o.complex().node_end());
    for (cutting::NodeId n = 0; n < x.size(); ++n) x[n] = o.complex().rest(n);
    const std::vector<Vec3> from = {{-0.1, -0.1, z}, {-0.1, 0.2, z}}, to = {{0.1, -0.1, z}, {0.1, 0.2, z}};
    cutting::BladeStroke stroke = cutting::begin_stroke(from);
    const cutting::CutResult result = o.cut(x, to, stroke, somebody, number);
    EXPECT_FALSE(result.ops.empty());
    return o.regroup(o.pieces().size()).bodies;
  };
  cut_at(organ, 0.001, 1);
  cut_at(other, 0.001, 1);
  const organs::Organ::Mark mark = organ.mark();
  const auto before = bytes(organ);
  const auto bodies = cut_at(organ, 0.03, 2);
  ASSERT_NE(bytes(organ), before);
  organ.back_to(mark, 2);
  EXPECT_EQ(bytes(organ), before);
  EXPECT_EQ(cutting::content_hash(organ.complex()), cutting::content_hash(other.complex()));
  EXPECT_EQ(cut_at(organ, 0.03, 2), bodies);
  cut_at(other, 0.03, 2);
  EXPECT_EQ(bytes(organ), bytes(other));
}

TEST(Organ, RefusesALogThatSkipsTheIdOfATetrahedron) {
  const Simulation simulation(block_and_scalpel(), options());
  const soft::SoftBody& body = simulation.soft(1);
  const auto uncut = [&] { return organs::Organ(0, body.anatomy(), body.desc().material.density); };
  const organs::Organ organ = uncut();
  const cutting::TetComplex& complex = organ.complex();
  cutting::SplitEdge split;
  split.a = complex.corners(0)[0];
  split.b = complex.corners(0)[1];
  split.t = 0.5;
  split.node = static_cast<cutting::NodeId>(complex.node_end());
  split.first = static_cast<cutting::TetId>(complex.tet_end());
  split.count = static_cast<std::uint32_t>(std::ranges::count_if(
      complex.star(split.a), [&](cutting::TetId tet) { return cutting::has_corner(complex, tet, split.b); }));
  cutting::TetId lowest = 0;  // of the tetrahedra that remain
  while (cutting::has_corner(complex, lowest, split.a) && cutting::has_corner(complex, lowest, split.b))
    ++lowest;
  const auto restore = [&](const cutting::SplitEdge& op) {
    organs::OrganLog log(1);
    log[0].ops = {op};
    uncut().restore(std::move(log), {{0, lowest}}, 1);
  };
  EXPECT_NO_THROW(restore(split));
  ++split.first;
  try {
    restore(split);
    ADD_FAILURE() << "restored";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("no edge split created"), std::string::npos) << error.what();
  }
}

TEST(Organ, WhatACutTakesAllTiesFromFallsAlsoThePieceThatKeepsTheName) {
  SceneDesc scene = block_and_scalpel();
  scene.gravity = Vec3(0, -9.81, 0);
  scene.soft[0].gravity = false;  // imaged as it hangs there
  scene.soft[0].attach = {{{0, 0.03, 0.05}, 0.03, 1e7}};
  scene.soft[0].material.toughness = 0;
  scene.rigid[0].pose.p.z() = 0.015;  // nearer to the ties: what they hold is the smaller piece
  Simulation simulation(scene, options());
  Vec3 at(-0.12, 0.14, 0.035);
  simulation.step(appear(at));
  simulation.step(event(HandEvent::Kind::grasp, at));
  ASSERT_EQ(simulation.hands()[0].holding, std::optional<BodyId>(scalpel));
  draw(simulation, at, 150);
  ASSERT_EQ(simulation.body_count(), 3U);
  EXPECT_GT(simulation.soft(1).total_mass(), simulation.soft(2).total_mass());
  for (int i = 0; i < 20; ++i) simulation.step(target(at));
  EXPECT_GT(simulation.max_displacement(1), 0.05);
  EXPECT_LT(simulation.max_displacement(2), 0.03);
}

// The surface that is touched changes with the first cut, from the finer one to the boundary's: what lies on
// it, away from the blade, must hardly notice.
TEST(Organ, WhatLiesOnItStaysWhereItIsWithTheFirstCut) {
  SceneDesc scene = block_and_scalpel();
  scene.gravity = {0, -9.81, 0};
  scene.rigid[0].balanced = true;
  SoftDesc& loaf = scene.soft[0];
  loaf.geometry.shape = "ball";
  loaf.geometry.size = {0.14, 0.06, 0.12};
  loaf.geometry.cell = 0.018;
  loaf.geometry.surface_cell = 0.009;
  loaf.gravity = false;
  constexpr BodyId weights = 5, tissue = 1 + weights;
  for (const Vec3& at : {Vec3(0.005, 0.067, 0), Vec3(0, 0.066, 0.022), Vec3(0, 0.066, -0.022),
                         Vec3(0.026, 0.066, 0.01), Vec3(0.026, 0.066, -0.014)}) {
    scene.rigid.push_back(part_body("weight", "box", {0.012, 0.01, 0.012}, at));
    scene.rigid.back().contact.friction = 1;
  }
  loaf.contact.friction = 1;
  CompileOptions from_shape = options();
  from_shape.anatomy = {};
  Simulation simulation(scene, from_shape);
  Vec3 at = take(simulation);
  run(simulation, 150, target(at));
  std::vector<Vec3> lay(1 + weights);
  const auto look = [&] {
    for (BodyId body = 1; body <= weights; ++body) lay[body] = simulation.rigid_state(body).pose.p;
  };
  look();
  for (int i = 0; i < 60 && draw(simulation, at, 1).empty(); ++i) look();
  ASSERT_EQ(simulation.revision(tissue), 1U);
  double moved = 0;
  for (int i = 0; i < 20; ++i) {
    simulation.step(target(at));
    for (BodyId body = 1; body <= weights; ++body)
      moved = std::max(moved, std::abs(simulation.rigid_state(body).pose.p.y() - lay[body].y()));
  }
  RecordProperty("mm", std::to_string(1000 * moved));
  EXPECT_LT(moved, 0.3e-3);
}

TEST(Organ, UndoGivesBackTheMeshThatWasCut) {
  Simulation simulation(block_and_scalpel(), options());
  const std::uint64_t uncut = simulation.soft(1).content_hash();
  const std::size_t triangles = simulation.surface(1).triangles.size();
  Vec3 at = take(simulation);
  draw(simulation, at, 150);
  ASSERT_EQ(simulation.body_count(), 3U);
  EXPECT_NE(simulation.soft(1).content_hash(), uncut);
  const StepReport& report = simulation.step(undo());
  ASSERT_EQ(report.cut_answers, std::vector<Refusal>(1));
  EXPECT_EQ(simulation.soft(1).content_hash(), uncut);
  EXPECT_EQ(simulation.surface(1).triangles.size(), triangles);
  EXPECT_TRUE(simulation.surface(2).triangles.empty());
  for (int i = 0; i < 120; ++i) simulation.step({});
  EXPECT_LT(simulation.max_displacement(1), 0.002);
  EXPECT_NE(simulation.step(undo()).cut_answers, std::vector<Refusal>(1)) << "undone twice";
}

// Each row: how high the ties are, so which piece falls, and where the blade comes.
TEST(Organ, UndoPutsAPieceBackThatHasFallenAndLiesThere) {
  for (const bool larger_falls : {false, true}) {
    SceneDesc scene = block_and_scalpel();
    scene.gravity = Vec3(0, -9.81, 0);
    scene.soft[0].gravity = false;
    scene.soft[0].attach = {{{0, 0.03, larger_falls ? 0.05 : -0.05}, 0.03, 1e7}};
    scene.soft[0].material.toughness = 0;
    scene.rigid[0].pose.p.z() = 0.015;
    Simulation simulation(scene, options());
    const std::uint64_t uncut = simulation.soft(1).content_hash();
    Vec3 at(-0.12, 0.14, 0.035);
    simulation.step(appear(at));
    simulation.step(event(HandEvent::Kind::grasp, at));
    draw(simulation, at, 150);
    ASSERT_EQ(simulation.body_count(), 3U);
    const BodyId falls = larger_falls ? 1 : 2;
    for (int i = 0; i < 60; ++i) simulation.step(target(at));
    ASSERT_GT(simulation.max_displacement(falls), 0.5) << "it should have fallen";
    ASSERT_EQ(simulation.step(undo()).cut_answers, std::vector<Refusal>(1));
    EXPECT_EQ(simulation.soft(1).content_hash(), uncut);
    EXPECT_LT(simulation.max_displacement(1), 0.01) << "beside where it came off, larger " << larger_falls;
    double fastest = 0;
    for (int i = 0; i < 60; ++i) {
      simulation.step({});
      fastest = std::max(fastest, simulation.soft_state(1).motion.v.cwiseAbs().maxCoeff());
    }
    EXPECT_LT(fastest, 1) << "it was pulled there";
    EXPECT_LT(simulation.max_displacement(1), 0.002);
  }
}

TEST(Organ, UndoTakesBackOnesOwnCutUnderALaterOneOrSaysWhyNot) {
  SceneDesc scene = block_and_scalpel();
  scene.rigid.push_back(scene.rigid[0]);
  scene.rigid[1].name = "second";
  for (const double second_at : {0.03, 0.004}) {  // beside the first cut; along it
    scene.rigid[1].pose.p.z() = second_at;
    scene.rigid[1].pose.p.x() = -0.16;
    Simulation simulation(scene, options());
    const auto topology = [&] {  // of all pieces
      std::uint64_t sum = 0;
      for (BodyId body = 2; body < simulation.body_count(); ++body)
        if (!simulation.surface(body).triangles.empty()) sum += simulation.soft(body).content_hash();
      return sum;
    };
    const std::uint64_t uncut = topology();
    const auto cut_with = [&](ParticipantId who, Vec3 at) {
      TickInput input;
      for (const auto kind : {HandEvent::Kind::appear, HandEvent::Kind::grasp}) {
        input.targets = {{who, right_hand, {at, Quat::Identity()}, {}}};
        input.events = {{kind, who, right_hand, 0}};
        simulation.step(input);
      }
      EXPECT_TRUE(simulation.hands().front().holding);
      input.events.clear();
      for (int i = 0; i < 190; ++i) {
        at.x() += 0.0016;
        input.targets[0].target.p = at;
        simulation.step(input);
      }
      input.events = {{HandEvent::Kind::vanish, who, right_hand, 0}};
      input.targets.clear();
      simulation.step(input);
    };
    cut_with(1, {-0.12, 0.14, 0.02});
    const std::uint64_t first_cut = topology();
    EXPECT_NE(first_cut, uncut);
    cut_with(2, {-0.16, 0.14, second_at + 0.02});
    EXPECT_NE(topology(), first_cut);
    const auto undo_of = [&](ParticipantId who) {
      TickInput input;
      input.cuts = {{CutEvent::Kind::undo, who, 0, 0}};
      return simulation.step(input).cut_answers.at(0).why();
    };
    const std::string answer = undo_of(1);
    EXPECT_TRUE(answer.empty() || answer.find("depends on it") != std::string::npos) << answer;
    EXPECT_EQ(undo_of(2), "");
    if (!answer.empty()) {
      EXPECT_EQ(topology(), first_cut) << "the refused undo left something behind";
      EXPECT_EQ(undo_of(1), "");
    }
    EXPECT_EQ(topology(), uncut);
  }
}

TEST(Organ, SameInputsSameBitsAlsoFromACheckpointMidCut) {
  const auto run_to = [](Simulation& simulation, Vec3& at, int ticks) {
    draw(simulation, at, ticks);
    return simulation.state_hash();
  };
  Simulation first(block_and_scalpel(), options(1)), second(block_and_scalpel(), options(2));
  Vec3 at = take(first), same = take(second);
  run_to(first, at, 70);
  run_to(second, same, 70);
  const std::vector<std::uint8_t> saved = first.checkpoint();
  EXPECT_EQ(saved, second.checkpoint());
  Vec3 later = at;
  const std::uint64_t there = run_to(first, at, 80);
  EXPECT_EQ(run_to(second, same, 80), there);
  Simulation third(block_and_scalpel(), options(1));
  third.restore(saved);
  Vec3 again = later;
  EXPECT_EQ(run_to(third, again, 80), there);
  // Back from a state in which there are more bodies.
  first.restore(saved);
  EXPECT_EQ(first.body_count(), 2U);
  EXPECT_EQ(run_to(first, later, 80), there);
  EXPECT_EQ(first.body_count(), 3U);
}

}  // namespace
}  // namespace prosector::test
