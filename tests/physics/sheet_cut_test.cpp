// A held scalpel cuts a sheet: through the whole simulation, for each model that sheets have.

#include <gtest/gtest.h>

#include "server/physics/mechanics/organs/organ.h"
#include "server/physics/mechanics/organs/sheet_parts.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scalpel.h"
#include "tests/random.h"

namespace prosector::test {
namespace {

struct Rung {
  std::string model, integrator;
};
void PrintTo(const Rung& rung, std::ostream* out) {
  *out << rung.model << '_' << rung.integrator;
}

double mass_of_pieces(const Simulation& simulation) {
  double sum = 0;
  for (BodyId body = 1; body < simulation.body_count(); ++body) sum += simulation.soft(body).total_mass();
  return sum;
}

Vec3 momentum(const Simulation& simulation) {
  Vec3 sum = Vec3::Zero();
  for (BodyId body = 1; body < simulation.body_count(); ++body) {
    if (simulation.surface(body).triangles.empty()) continue;
    const VecX &mass = simulation.soft(body).node_mass(), &v = simulation.soft_state(body).motion.v;
    for (Eigen::Index i = 0; i < mass.size(); ++i) sum += mass[i] * v.segment<3>(3 * i);
  }
  return sum;
}

class CutSheet : public ::testing::TestWithParam<Rung> {};

TEST_P(CutSheet, InTwoBodiesUndoneAndRestored) {
  const SceneDesc scene = membrane_and_scalpel(GetParam().model, GetParam().integrator);
  Simulation simulation(scene, options());
  const double mass = simulation.soft(1).total_mass();
  const std::uint64_t uncut = simulation.soft(1).content_hash();
  Vec3 at = take(simulation);
  const std::vector<TopologyChange> halfway = draw(simulation, at, 75);  // to its middle
  ASSERT_FALSE(halfway.empty());
  EXPECT_EQ(simulation.body_count(), 2U);
  EXPECT_NEAR(mass_of_pieces(simulation), mass, 1e-12 * mass);
  const std::vector<std::uint8_t> saved = simulation.checkpoint();
  Vec3 again = at;
  draw(simulation, at, 75);
  ASSERT_EQ(simulation.body_count(), 3U);
  EXPECT_NEAR(mass_of_pieces(simulation), mass, 1e-12 * mass);
  for (const BodyId body : {1U, 2U}) {
    EXPECT_GT(simulation.soft(body).total_mass(), 0.4 * mass);
    EXPECT_TRUE(simulation.soft_state(body).motion.x.allFinite());
    EXPECT_LT(simulation.max_displacement(body), 0.01);
    EXPECT_FALSE(simulation.soft(body).anatomy().quads.empty());      // away from the cut
    EXPECT_FALSE(simulation.soft(body).anatomy().triangles.empty());  // along it
  }
  EXPECT_EQ(simulation.name(2), "membrane piece 1");
  const std::uint64_t cut = simulation.state_hash();

  Simulation restored(scene, options(2));
  restored.restore(saved);
  draw(restored, again, 75);
  EXPECT_EQ(restored.state_hash(), cut);

  ASSERT_EQ(simulation.step(undo()).cut_answers, std::vector<Refusal>(1));
  EXPECT_EQ(simulation.soft(1).content_hash(), uncut);
  EXPECT_NEAR(simulation.soft(1).total_mass(), mass, 1e-12 * mass);
  EXPECT_TRUE(simulation.surface(2).triangles.empty());
}

std::vector<Rung> rungs() {
  std::vector<Rung> out;
  for (const soft::ModelRow& model : soft::models())
    if (model.fabric)
      for (const std::string& integrator : soft::integrators_for(model))
        out.push_back({model.name, integrator});
  return out;
}

INSTANTIATE_TEST_SUITE_P(Rungs, CutSheet, ::testing::ValuesIn(rungs()),
                         [](const auto& info) { return info.param.model + "_" + info.param.integrator; });

TEST(SheetBlade, ToughSheetsAreDrawnAlongInsteadOfCut) {
  for (const double toughness : {10.0, 1e5}) {
    SceneDesc scene = membrane_and_scalpel();
    scene.soft[0].material.toughness = toughness;
    Simulation simulation(scene, options());
    Vec3 at = take(simulation);
    draw(simulation, at, 60);  // 2.6 cm into it
    if (toughness > 1000) {
      EXPECT_GT(simulation.max_displacement(1), 0.01);
      EXPECT_LE(simulation.soft(1).anatomy().triangles.size(), 4U);
    } else {
      EXPECT_LT(simulation.max_displacement(1), 0.005);
      EXPECT_GE(simulation.soft(1).anatomy().triangles.size(), 6U);
    }
  }
}

TEST(SheetBlade, ARayCutsSheetsWithoutResistanceAndNothingElse) {
  SceneDesc sheet = membrane_and_scalpel(), solid = block_and_scalpel();
  sheet.soft[0].material.toughness = 1e5;
  for (SceneDesc* scene : {&sheet, &solid}) {
    scene->rigid[0].edges[0].ray = true;
    Simulation simulation(*scene, options());
    Vec3 at = take(simulation);
    const bool cut = !draw(simulation, at, 150).empty();
    EXPECT_EQ(cut, scene == &sheet);
    EXPECT_LT(simulation.max_displacement(1), 1e-3);
    EXPECT_EQ(simulation.body_count(), scene == &sheet ? 3U : 2U);
  }
}

// Nothing but gravity acts on a free sheet that a blade cuts without resistance.
TEST(SheetBlade, CutsKeepAFallingSheetsMomentum) {
  SceneDesc scene = membrane_and_scalpel();
  scene.gravity = {0, -0.05, 0};
  scene.rigid[0].balanced = true;
  scene.soft[0].attach.clear();
  scene.soft[0].material.toughness = 0;
  scene.soft[0].material.damping_mass = 0;
  Simulation simulation(scene, options());
  const double mass = simulation.soft(1).total_mass();
  Vec3 at = take(simulation);
  int cuts = 0;
  for (int i = 0; i < 120; ++i) {
    const Vec3 before = momentum(simulation);
    const bool asleep = simulation.asleep(1);
    cuts += draw(simulation, at, 1).empty() ? 0 : 1;
    if (asleep || simulation.asleep(1)) continue;
    const Vec3 expected = before + mass * scene.gravity / scene.tick_rate;
    ASSERT_LT((momentum(simulation) - expected).norm(), 1e-6 * mass * 0.05) << "tick " << i;
  }
  EXPECT_GT(cuts, 5);
}

/// By a scalpel that leans and turns as it is drawn across.
void part_membranes(unsigned seed, int strokes) {
  Random random(seed);
  for (int i = 0; i < strokes; ++i) {
    SceneDesc scene = membrane_and_scalpel(i % 2 == 0 ? "mass_spring" : "xpbd");
    SoftDesc& sheet = scene.soft[0];
    sheet.material.toughness = i % 3 == 0 ? 0 : random.uniform(1, 10);
    sheet.geometry.cell = random.uniform(0.008, 0.016);
    sheet.pose.q = Quat(Eigen::AngleAxisd(random.uniform(-0.5, 0.5), Vec3::UnitY()));
    const auto angles = [&] { return std::array{random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6)}; };
    const auto first = angles(), last = angles();
    const double off = random.uniform(-0.015, 0.015), aside = random.uniform(-0.03, 0.03);
    Simulation simulation(scene, options());
    const Vec3 hand = take(simulation), at_sheet(hand.x(), membrane_height, 0), below = at_sheet - hand;
    constexpr int to_the_border = 40, ticks = 180;
    for (int tick = 0; tick <= ticks; ++tick) {
      const double share = static_cast<double>(tick) / ticks;
      const double taken_up = std::min(1.0, static_cast<double>(tick) / to_the_border);
      const auto angle = [&](std::size_t k) { return taken_up * (first[k] + share * (last[k] - first[k])); };
      const Quat q(Eigen::AngleAxisd(angle(0), Vec3::UnitX()) * Eigen::AngleAxisd(angle(1), Vec3::UnitZ()));
      const Vec3 way(0.26 * share, 0, off * taken_up + aside * (share - 0.5));
      simulation.step(target(at_sheet + way - q * below, q));
    }
    EXPECT_EQ(simulation.hands()[0].holding, std::optional<BodyId>(scalpel)) << "stroke " << i;
    EXPECT_EQ(simulation.body_count(), 3U) << "stroke " << i;
  }
}

TEST(SheetBlade, PartsMembranesOfAFixedSeed) {
  part_membranes(test_seed(true), 8);
}

TEST(SheetBlade, PartsMembranesOfAnySeed) {
  part_membranes(test_seed(false), 8);
}

/// A thick membrane that meets itself.
SceneDesc thick_membrane(const std::string& model) {
  SceneDesc scene = membrane_and_scalpel(model);
  SoftDesc& sheet = scene.soft[0];
  sheet.geometry.size.y() = 0.004;
  sheet.material.youngs_modulus = 3e4;
  sheet.material.toughness = 0;
  sheet.contact.self_contact = true;
  return scene;
}

double fastest(const Simulation& simulation) {
  double most = 0;
  for (BodyId body = 1; body < simulation.body_count(); ++body)
    if (!simulation.surface(body).triangles.empty())
      most = std::max(most, simulation.soft_state(body).motion.v.lpNorm<Eigen::Infinity>());
  return most;
}

// The sides of a cut lie nearer to each other than the sheet is thick.
TEST(SheetSeam, ACutSetsNothingGoing) {
  for (const std::string model : {"mass_spring", "xpbd"}) {
    Simulation simulation(thick_membrane(model), options());
    Vec3 at = take(simulation);
    for (int i = 0; i < 150; ++i) {
      draw(simulation, at, 1);
      ASSERT_LT(fastest(simulation), 1e-6) << model << ", tick " << i;
    }
    EXPECT_EQ(simulation.body_count(), 3U);
  }
}

/// How many nodes of a piece, or of what lies on one side of the cut, are over the other, and how far they
/// are above it, at least.
struct Over {
  int nodes = 0;
  double lowest = 1;  // m
};

Over over(const Simulation& simulation, BodyId upper, BodyId lower) {
  Over out;
  const auto node = [&](BodyId body, std::uint32_t n) -> Vec3 {
    return simulation.soft_state(body).motion.x.segment<3>(3 * Eigen::Index{n});
  };
  const auto z_at_rest = [&](BodyId body, std::uint32_t n) {
    return simulation.soft(body).anatomy().tets.positions[n].z();
  };
  const Anatomy& sheet = simulation.soft(lower).anatomy();
  std::vector<std::array<std::uint32_t, 3>> triangles(sheet.triangles.begin(), sheet.triangles.end());
  for (const auto& [a, b, c, d] : sheet.quads) triangles.insert(triangles.end(), {{a, b, c}, {a, c, d}});
  for (std::uint32_t n = 0; n < simulation.soft(upper).anatomy().tets.positions.size(); ++n) {
    if (z_at_rest(upper, n) > -1e-3) continue;
    const Vec3 x = node(upper, n);
    for (const auto& [a, b, c] : triangles) {
      if (std::min({z_at_rest(lower, a), z_at_rest(lower, b), z_at_rest(lower, c)}) < -1e-3) continue;
      const Vec3 p = node(lower, a), u = node(lower, b) - p, v = node(lower, c) - p;
      const double area = u.z() * v.x() - u.x() * v.z();
      const Vec3 way = x - p;
      const double s = (way.z() * v.x() - way.x() * v.z()) / area,
                   t = (u.z() * way.x() - u.x() * way.z()) / area;
      if (!(s > 0 && t > 0 && s + t < 1)) continue;
      ++out.nodes;
      out.lowest = std::min(out.lowest, way.y() - s * u.y() - t * v.y());
    }
  }
  return out;
}

// Of what lies on each other nothing was farther apart at rest than some cells.
TEST(SheetSeam, SidesPressedOntoEachOtherDontPass) {
  for (const bool through : {true, false}) {
    SceneDesc scene = thick_membrane("mass_spring");
    scene.soft[0].attach = {{{0, membrane_height, 0.06}, 0.03, 1e9}};
    Simulation simulation(scene, options());
    Vec3 scalpel_at = take(simulation);
    draw(simulation, scalpel_at, through ? 150 : 96);
    ASSERT_EQ(simulation.body_count(), through ? 3U : 2U);
    const double x = through ? 0 : -0.01;
    BodyId upper = 1;  // whose strip along the cut is taken
    if (through && simulation.soft(1).anatomy().tets.positions.front().z() > -0.03) upper = 2;
    const BodyId lower = through ? 3 - upper : 1;
    constexpr ParticipantId other = 8;
    const auto step = [&](const Vec3& hand, std::optional<HandEvent::Kind> kind = {}) {
      TickInput input = target(scalpel_at);
      HandTarget& t = input.targets.emplace_back(input.targets[0]);
      t.participant = other;
      t.target.p = hand;
      if (kind) input.events.push_back({*kind, other, right_hand, 0});
      simulation.step(input);
    };
    Vec3 hand(x, membrane_height + 0.012, -0.012);
    step(hand, HandEvent::Kind::appear);
    step(hand, HandEvent::Kind::grasp);
    ASSERT_EQ(simulation.hands()[1].holding, std::optional<BodyId>(upper));
    const auto go = [&](const Vec3& way, int ticks) {
      for (int i = 0; i < ticks; ++i) step(hand += way / ticks);
    };
    go({0, 0.015, 0}, 20);
    go({0, 0, 0.028}, 40);
    go({0, -0.03, 0}, 40);
    go({0, 0, 0}, 30);
    const Over now = over(simulation, upper, lower);
    EXPECT_GE(now.nodes, 5);
    EXPECT_GT(now.lowest, 0.9 * scene.soft[0].geometry.size.y()) << (through ? "two pieces" : "a slit");
  }
}

TEST(SheetOrgan, IsUndoneInAnyOrderThatItsCutsAllow) {
  const Simulation simulation(membrane_and_scalpel("xpbd"), options());
  const soft::SoftBody& body = simulation.soft(1);
  const auto held = organs::held_nodes(body.desc().attach, body.anatomy());
  organs::Organ organ(0, body.anatomy(), body.desc().material.density, held);
  const auto cut = [&](double z, ParticipantId author, std::uint64_t number) {
    std::vector<Vec3> x(organ.complex().node_end());
    for (cutting::NodeId n = 0; n < x.size(); ++n) x[n] = organ.complex().rest(n);
    const std::vector<Vec3> from = {{-0.06, 0, z}, {-0.06, 0.1, z}}, to = {{0.06, 0, z}, {0.06, 0.1, z}};
    cutting::BladeStroke stroke = cutting::begin_stroke(from);
    EXPECT_FALSE(organ.cut(x, to, stroke, author, number).ops.empty());
    organ.regroup(organ.pieces().size());
  };
  const std::uint64_t uncut = cutting::content_hash(organ.complex());
  cut(0.0341, 1, 1);
  const std::uint64_t one = cutting::content_hash(organ.complex());
  cut(-0.0341, 2, 2);  // far from it
  cut(0.0361, 3, 3);   // beside it
  EXPECT_TRUE(organ.undo(1));
  EXPECT_FALSE(organ.undo(3));
  EXPECT_FALSE(organ.undo(1));
  EXPECT_FALSE(organ.undo(2));
  EXPECT_EQ(cutting::content_hash(organ.complex()), uncut);
  EXPECT_NE(one, uncut);
  organ.regroup(organ.pieces().size());

  organs::Organ other(0, body.anatomy(), body.desc().material.density, held);
  other.restore(organ.log(), organ.mark().pieces, organ.pieces().size());
  EXPECT_EQ(cutting::content_hash(other.complex()), uncut);
}

}  // namespace
}  // namespace prosector::test
