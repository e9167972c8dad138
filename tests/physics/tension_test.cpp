// An organ's outermost layer under tension: what is uncut keeps its shape, and a cut gapes.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <map>

#include "common/anatomy/rest_stretch.h"
#include "common/error.h"
#include "server/physics/mechanics/organs/organ_geometry.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/stations/compile/tension.h"
#include "tests/physics/scalpel.h"
#include "tests/soft/stepper.h"

namespace prosector::test {
namespace {

const Vec3 size(0.1, 0.06, 0.1);  // m, around the origin

SoftDesc tense(double percent, const std::string& model = "fem_corotational",
               const std::string& element = "tet4") {
  SoftDesc desc;
  desc.name = "block";
  desc.configuration.model = model;
  desc.configuration.element = element;
  desc.material.tension.value = percent;
  desc.material.tension_depth = 0.01;
  return desc;
}

/// Returns by what share tetrahedra near the middle of the top, at this height (m), are stretched along x, in
/// the mean.
double stretch_on_top(const TetMesh& mesh, double top) {
  double sum = 0, count = 0;
  for (const auto& tet : mesh.tets) {
    const Vec3 p = middle_of(mesh, tet);
    if (p.y() < top - 0.008 || std::abs(p.x()) > 0.03 || std::abs(p.z()) > 0.03) continue;
    sum += mesh.stretch->at(p)(0, 0) - 1;
    ++count;
  }
  return sum / count;
}

TEST(Tension, ItsLayerIsAsDeepAsAskedForAndAlongTheSurface) {
  const TetMesh mesh = make_block(size, {10, 6, 10}).tets;
  for (const double depth : {0.002, 0.01, 0.02}) {
    const std::vector<Mat3> V = layer_stretch(mesh, 0.1, depth);
    double pulled = 0, column = 0;  // mean of V_xx − 1 of the columns about the middle, over the height
    for (std::size_t t = 0; t < V.size(); ++t) {
      const Vec3 p = middle_of(mesh, mesh.tets[t]);
      if (std::abs(p.x()) > 0.02 || std::abs(p.z()) > 0.02) continue;
      column += 1;
      pulled += V[t](0, 0) - 1;
      EXPECT_NEAR(V[t](1, 1), 1, 1e-12);
    }
    EXPECT_NEAR(pulled / column, 2 * depth / size.y() * (0.1 / 0.9), 1e-6);  // of top and bottom
  }
}

/// Returns how far the two sides of a slit, 2 cm deep across the top, are apart where it is widest, m.
double gape(const SoftDesc& desc, const std::array<int, 3>& cells) {
  Anatomy anatomy = make_block(size, cells);
  put_under_tension(desc, anatomy);
  organs::Organ organ(0, anatomy, desc.material.density);
  const auto edge_at = [](double y) { return std::vector<Vec3>{{0.003, y, -0.03}, {0.003, y, 0.03}}; };
  cutting::BladeStroke stroke = cutting::begin_stroke(edge_at(0.04));
  for (int tick = 1; tick <= 6; ++tick) {
    std::vector<Vec3> rest;
    for (cutting::NodeId node = 0; node < organ.complex().node_end(); ++node)
      rest.push_back(organ.complex().rest(node));
    organ.cut(rest, edge_at(0.04 - 0.005 * tick), stroke, 1, 1);
  }
  organ.regroup(1);
  EXPECT_EQ(organ.pieces().size(), 1U);
  Numbering numbering;
  soft::SoftBody body(desc, organs::anatomy_of(organ, organ.piece(0), numbering));
  soft::SoftBodyState state = body.initial_state();
  Stepper(body, {8, 1e-6, {400, 1e-4}}).settle(Vec3::Zero(), state, 2, 10);
  double opening = 0;
  std::map<std::array<double, 3>, Vec3> met;
  const std::vector<Vec3>& rest = body.anatomy().tets.positions;
  for (std::size_t n = 0; n < rest.size(); ++n) {
    const Vec3 now = state.motion.x.segment<3>(3 * static_cast<Eigen::Index>(n));
    const auto [twin, first] = met.try_emplace({rest[n].x(), rest[n].y(), rest[n].z()}, now);
    if (!first) opening = std::max(opening, (now - twin->second).norm());
  }
  return opening;
}

TEST(Tension, ASlitGapesAndTheMoreTheMoreTensionThereIs) {
  double last = 0;
  for (const double percent : {4.0, 8.0, 16.0}) {
    const double opening = gape(tense(percent), {10, 6, 10});
    std::cout << percent << " %: " << 1e3 * opening << " mm\n";
    EXPECT_GT(opening, 1.2 * last);
    last = opening;
    EXPECT_GT(opening, 3e-4 * percent);  // m
  }
}

TEST(Tension, ASlitGapesUnderEveryModel) {
  for (const soft::ModelRow& row : soft::models())
    for (const std::string element : {"tet4", "tet10"}) {
      if (!row.tets || (element == "tet10" && row.fabric)) continue;
      const double opening = gape(tense(8, row.name, element), {5, 3, 5});
      std::cout << row.name << ' ' << element << ": " << 1e3 * opening << " mm\n";
      EXPECT_GT(opening, 8e-4) << row.name << ' ' << element;
    }
}

SceneDesc tense_block_and_scalpel(double percent) {
  SceneDesc scene = block_and_scalpel();
  scene.soft[0].geometry.cell = 0.01;
  scene.soft[0].material.tension.value = percent;
  scene.soft[0].material.tension_depth = 0.015;
  scene.soft[0].attach = {{{0, -0.19, 0}, 0.2, 1e7}};
  return scene;
}

/// Returns how far the triangles of a body's surface that have walls of a cut beside them are apart, m: the
/// widest opening along x of vertices that were in one place.
double opening_of(const Simulation& simulation) {
  const std::vector<Vec3>& rest = simulation.soft(1).anatomy().tets.positions;
  const VecX& x = simulation.soft_state(1).motion.x;
  double opening = 0;
  std::map<std::array<double, 3>, Vec3> met;
  for (std::size_t n = 0; n < rest.size(); ++n) {
    const Vec3 now = x.segment<3>(3 * static_cast<Eigen::Index>(n));
    const auto [twin, first] = met.try_emplace({rest[n].x(), rest[n].y(), rest[n].z()}, now);
    if (!first) opening = std::max(opening, (now - twin->second).norm());
  }
  return opening;
}

TEST(Tension, WhatIsUncutKeepsTheShapeThatIsGiven) {
  const Simulation simulation(tense_block_and_scalpel(8), options());
  const VecX moved = simulation.soft_state(1).motion.x - simulation.soft(1).rest();
  EXPECT_LT(moved.lpNorm<Eigen::Infinity>(), 1e-4);
  EXPECT_GT(stretch_on_top(simulation.soft(1).anatomy().tets, size.y()), 0.03);
}

TEST(Tension, ACutGapesInASessionWhichGoesOnFromACheckpointAndIsTakenBack) {
  Simulation simulation(tense_block_and_scalpel(8), options());
  Simulation slack(tense_block_and_scalpel(0), options());
  const std::uint64_t whole = simulation.soft(1).content_hash();
  for (Simulation* s : {&simulation, &slack}) {
    Vec3 at = take(*s);
    EXPECT_FALSE(draw(*s, at, 75).empty());
    for (int i = 0; i < 75; ++i) s->step(target(at -= Vec3(0.0016, 0, 0)));  // the blade leaves
    run(*s, 120, target(at));
  }
  std::cout << "gapes by " << 1e3 * opening_of(simulation) << " mm, slack by " << 1e3 * opening_of(slack)
            << " mm\n";
  EXPECT_GT(opening_of(simulation), 3e-3);
  EXPECT_LT(opening_of(slack), 1e-3);

  const std::vector<std::uint8_t> saved = simulation.checkpoint();
  Simulation other(tense_block_and_scalpel(8), options(2));
  other.restore(saved);
  for (Simulation* s : {&simulation, &other}) run(*s, 30);
  EXPECT_EQ(simulation.state_hash(), other.state_hash());

  simulation.step(undo());
  EXPECT_EQ(simulation.soft(1).content_hash(), whole);
  run(simulation, 240);
  const VecX moved = simulation.soft_state(1).motion.x - simulation.soft(1).rest();
  EXPECT_LT(moved.lpNorm<Eigen::Infinity>(), 5e-4);
}

TEST(Tension, WhatComesOffKeepsItsTension) {
  Simulation simulation(tense_block_and_scalpel(8), options());
  Vec3 at = take(simulation);
  draw(simulation, at, 140);
  ASSERT_EQ(simulation.body_count(), 3U);
  for (const BodyId piece : {BodyId{1}, BodyId{2}}) {
    const Anatomy& anatomy = simulation.soft(piece).anatomy();
    ASSERT_TRUE(anatomy.tets.stretch);
    EXPECT_EQ(anatomy.tets.stretch, simulation.soft(1).anatomy().tets.stretch);
  }
}

TEST(Tension, IsRefusedOfARope) {
  SceneDesc scene;
  SoftDesc& rope = scene.soft.emplace_back();
  rope.name = "thread";
  rope.geometry.shape = "rope";
  rope.configuration.model = "mass_spring";
  rope.geometry.size = {0.1, 0.002, 0.002};
  rope.geometry.cell = 0.01;
  rope.material.tension.value = 5;
  try {
    const Simulation simulation(scene, options());
    FAIL() << "was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("tension"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace prosector::test
