// Cuts where tissue is squeezed, inside out, held by others, or a single tetrahedron: through the whole
// simulation.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <map>

#include "common/anatomy/mesh_quality.h"
#include "tests/physics/scalpel.h"

namespace prosector::test {
namespace {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

/// Every edge has two triangles, the one the other way round.
bool is_closed(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      ++edges[{t[k], t[(k + 1) % 3]}];
      --edges[{t[(k + 1) % 3], t[k]}];
    }
  return std::all_of(edges.begin(), edges.end(), [](const auto& e) { return e.second == 0; });
}

/// What has to hold of all soft bodies after whatever cut: finite, of the volume and mass that they had
/// together, no element turned over at rest, no hole in a surface.
class Tissue {
 public:
  explicit Tissue(const Simulation& simulation) : simulation_(simulation) { sum(volume_, mass_); }

  AssertionResult is_sound() const {
    for (BodyId body = first(); body < simulation_.body_count(); ++body) {
      const soft::SoftBodyState& state = simulation_.soft_state(body);
      if (!state.motion.x.allFinite() || !state.motion.v.allFinite())
        return AssertionFailure() << "body " << body << " is not finite";
      if (state.motion.v.size() > 0 && state.motion.v.cwiseAbs().maxCoeff() > 20)
        return AssertionFailure() << "body " << body << " bursts: " << state.motion.v.cwiseAbs().maxCoeff()
                                  << " m/s";
      if (!is_closed(simulation_.surface(body))) return AssertionFailure() << "a hole in body " << body;
    }
    double volume = 0, mass = 0;
    if (!sum(volume, mass)) return AssertionFailure() << "an element is turned over at rest";
    if (std::abs(volume - volume_) > 1e-9 * volume_)
      return AssertionFailure() << "volume " << volume_ << " became " << volume;
    if (std::abs(mass - mass_) > 1e-9 * mass_)
      return AssertionFailure() << "mass " << mass_ << " became " << mass;
    return AssertionSuccess();
  }

 private:
  BodyId first() const { return static_cast<BodyId>(simulation_.scene().rigid.size()); }
  bool sum(double& volume, double& mass) const {
    for (BodyId body = first(); body < simulation_.body_count(); ++body) {
      if (simulation_.surface(body).triangles.empty()) continue;
      mass += simulation_.soft(body).total_mass();
      const TetMesh& mesh = simulation_.soft(body).anatomy().tets;
      for (const auto& t : mesh.tets) {
        const double v = tet_volume(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]],
                                    mesh.positions[t[3]]);
        if (!(v > 0)) return false;
        volume += v;
      }
    }
    return true;
  }
  const Simulation& simulation_;
  double volume_ = 0, mass_ = 0;
};

/// Draws the scalpel through, and lets all come to rest without it; what `each` adds to a tick's input.
template <class Each>
void draw_through(Simulation& simulation, Vec3 at, int ticks, const Tissue& tissue, const Each& each) {
  for (int i = 0; i < ticks; ++i) {
    at.x() += 0.004;
    TickInput input = target(at);
    each(i, input);
    simulation.step(input);
    ASSERT_TRUE(tissue.is_sound()) << "tick " << i;
  }
  for (int i = 0; i < 200; ++i) {
    TickInput input = target(at);
    each(ticks, input);
    simulation.step(input);
  }
  EXPECT_TRUE(tissue.is_sound());
}

/// As if somebody had put the body's nodes elsewhere, at rest.
void put(Simulation& simulation, BodyId body, const VecX& where) {
  std::vector<std::uint8_t> bytes = simulation.save();
  const VecX& x = simulation.soft_state(body).motion.x;
  const auto* begin = reinterpret_cast<const std::uint8_t*>(x.data());
  const auto at = std::search(bytes.begin(), bytes.end(), begin, begin + 8 * x.size());
  ASSERT_NE(at, bytes.end());
  std::memcpy(&*at, where.data(), 8 * static_cast<std::size_t>(x.size()));
  simulation.restore(bytes);
}

TEST(ExtremeCut, WhileTheBlockIsSqueezed) {
  SceneDesc scene = block_and_scalpel();
  scene.rigid[scalpel].edges[0].to.y() = -0.2;  // it swells up and down
  scene.soft[0].attach = {{{0, 0, 0}, 0.03, 1e5}};
  scene.soft[0].material.toughness = 0;
  for (const double side : {-1.0, 1.0}) {
    scene.rigid.push_back(
        part_body(side < 0 ? "near jaw" : "far jaw", "box", {0.14, 0.08, 0.02}, {0, 0.03, 0.061 * side}));
    scene.rigid.back().fixed = true;
  }
  Simulation simulation(scene, options());
  const Tissue tissue(simulation);
  const Vec3 at = take(simulation);
  const auto jaws = [&](double z, TickInput& input) {
    for (const BodyId jaw : {BodyId{1}, BodyId{2}})
      input.kinematic_targets.push_back({jaw, {{0, 0.03, jaw == 1 ? -z : z}, Quat::Identity()}});
  };
  for (int i = 0; i < 60; ++i) {
    TickInput input = target(at);
    jaws(0.061 - 0.025 * i / 60, input);
    simulation.step(input);
  }
  EXPECT_GT(simulation.max_displacement(3), 0.015) << "nothing squeezes it";
  draw_through(simulation, at, 60, tissue,
               [&](int i, TickInput& input) { jaws(i < 60 ? 0.036 : 0.07, input); });
  EXPECT_GT(simulation.revision(3), 10U);
  EXPECT_GT(simulation.body_count(), 4U) << "it stayed whole";
}

TEST(ExtremeCut, WhileTheBlockIsInsideOut) {
  SceneDesc scene = block_and_scalpel();
  scene.soft[0].material.toughness = 0;
  Simulation simulation(scene, options());
  const Tissue tissue(simulation);
  Vec3 at = take(simulation);
  draw(simulation, at, 70);
  const std::uint32_t half = simulation.revision(1);
  ASSERT_GT(half, 1U);
  for (const Vec3& scale :
       {Vec3(1, 1, -1), Vec3(1, 0.05, 1), Vec3(-0.8, 1, 1)}) {  // mirrored, flat, mirrored
    VecX x = simulation.soft_state(1).motion.x;
    for (Eigen::Index n = 0; n < x.size() / 3; ++n)
      x.segment<3>(3 * n) =
          Vec3(0, 0.03, 0) + scale.cwiseProduct(Vec3(x.segment<3>(3 * n) - Vec3(0, 0.03, 0)));
    put(simulation, 1, x);
    for (int i = 0; i < 10; ++i) {
      at.x() += 0.0016;
      simulation.step(target(at));
      ASSERT_TRUE(tissue.is_sound()) << "tick " << i << " after " << scale.transpose();
    }
  }
  draw_through(simulation, at, 40, tissue, [](int, TickInput&) {});
  EXPECT_GT(simulation.revision(1), half);
  EXPECT_LT(simulation.max_displacement(1), 0.01) << "it did not recover";
}

TEST(ExtremeCut, WhereTwoHandsHoldThePieces) {
  SceneDesc scene = block_and_scalpel();
  scene.soft[0].attach.clear();
  scene.soft[0].geometry.size = {0.1, 0.06, 0.24};
  scene.soft[0].material.toughness = 0;
  Simulation simulation(scene, options());
  const Tissue tissue(simulation);
  const std::array<Vec3, 2> ends = {Vec3(0, 0.073, -0.08), Vec3(0, 0.073, 0.11)};
  const auto hold = [&](int tick, TickInput& input) {  // and pull apart
    for (const ParticipantId who : {ParticipantId{8}, ParticipantId{9}}) {
      Vec3 place = ends[who - 8];
      place.z() += (who == 8 ? -1 : 1) * 0.02 * std::clamp((tick - 60) / 30.0, 0.0, 1.0);
      input.targets.push_back({who, right_hand, {place, Quat::Identity()}, {}});
    }
  };
  for (const auto kind : {HandEvent::Kind::appear, HandEvent::Kind::grasp}) {
    TickInput input;
    hold(0, input);
    for (const HandTarget& t : input.targets) input.events.push_back({kind, t.participant, right_hand, 0});
    simulation.step(input);
  }
  const Vec3 at(-0.12, 0.14, 0.02);
  for (const auto kind : {HandEvent::Kind::appear, HandEvent::Kind::grasp}) {
    TickInput input = event(kind, at);
    hold(0, input);
    simulation.step(input);
  }
  ASSERT_EQ(simulation.hands().size(), 3U);
  for (const HandState& hand : simulation.hands()) ASSERT_TRUE(hand.holding) << hand.participant;
  draw_through(simulation, at, 65, tissue, hold);
  EXPECT_GT(simulation.revision(1), 5U);
  const auto left = simulation.hands()[1].holding, right = simulation.hands()[2].holding;
  ASSERT_TRUE(left && right);
  EXPECT_GT(simulation.body_count(), 2U) << "it did not part";
  EXPECT_NE(*left, *right) << "each has the piece that was in their hand";
}

TEST(ExtremeCut, ASingleTetrahedron) {
  CompileOptions one = options();
  one.anatomy = [](const SoftDesc&) {
    TetMesh mesh;
    mesh.positions = {{-0.04, 0, -0.03}, {0.04, 0, -0.03}, {0, 0, 0.04}, {0, 0.06, 0}};
    mesh.tets = {{0, 2, 1, 3}};
    return with_boundary(std::move(mesh));
  };
  SceneDesc scene = block_and_scalpel();
  Simulation simulation(scene, one);
  const Tissue tissue(simulation);
  const Vec3 at = take(simulation);
  draw_through(simulation, at, 60, tissue, [](int, TickInput&) {});
  EXPECT_GT(simulation.revision(1), 0U);
}

}  // namespace
}  // namespace prosector::test
