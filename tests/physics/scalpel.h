#pragma once
// A block that a held scalpel cuts.

#include <gtest/gtest.h>

#include <vector>

#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/physics/scenes.h"

namespace prosector::test {

inline constexpr BodyId scalpel = 0;

/// A block, 10 × 6 × 10 cm, tied at its base, beside a scalpel whose edge hangs down from its handle.
inline SceneDesc block_and_scalpel() {
  SceneDesc scene;
  scene.gravity = Vec3::Zero();
  scene.rigid = {part_body("scalpel", "box", {0.01, 0.08, 0.01}, {-0.12, 0.13, 0})};
  scene.rigid[0].edges = {{{0, -0.04, 0}, {0, -0.14, 0}}};
  scene.soft = {block()};
  scene.soft[0].attach = {{{0, 0, 0}, 0.2, 1e7}};
  scene.soft[0].geometry.cell = 0.02;
  scene.soft[0].material.toughness = 10;
  return scene;
}

inline constexpr double membrane_height = 0.04;  // m

/// Instead of the block a membrane, 10 × 10 cm, tied at two sides; the scalpel's edge hangs down through its
/// plane.
inline SceneDesc membrane_and_scalpel(const std::string& model = "mass_spring",
                                      const std::string& integrator = "implicit_euler") {
  SceneDesc scene = block_and_scalpel();
  SoftDesc& sheet = scene.soft[0];
  sheet.name = "membrane";
  sheet.geometry.shape = "sheet";
  sheet.geometry.size = {0.1, 0.001, 0.1};
  sheet.pose.p = {0, membrane_height, 0};
  sheet.geometry.cell = sheet.geometry.surface_cell = 0.01;
  sheet.configuration.model = model;
  sheet.configuration.integrator = integrator;
  sheet.material.youngs_modulus = 1e5;
  sheet.material.damping_mass = 5;
  sheet.configuration.substeps = 10;
  sheet.attach = {{{0, membrane_height, 0.06}, 0.045, 1e9}, {{0, membrane_height, -0.06}, 0.045, 1e9}};
  return scene;
}

/// A hand takes the scalpel.
inline Vec3 take(Simulation& simulation) {
  const Vec3 at(-0.12, 0.14, 0.02);
  simulation.step(appear(at));
  simulation.step(event(HandEvent::Kind::grasp, at));
  EXPECT_EQ(simulation.hands()[0].holding, std::optional<BodyId>(scalpel));
  return at;
}

/// Draws the scalpel through the block at 0.1 m/s, for `ticks` ticks.
inline std::vector<TopologyChange> draw(Simulation& simulation, Vec3& at, int ticks) {
  std::vector<TopologyChange> changes;
  for (int i = 0; i < ticks; ++i) {
    at.x() += 0.0016;
    const StepReport& report = simulation.step(target(at));
    changes.insert(changes.end(), report.topology.begin(), report.topology.end());
  }
  return changes;
}

/// Of somebody's last cut.
inline TickInput undo() {
  TickInput input;
  input.cuts = {{CutEvent::Kind::undo, somebody, 0, 0}};
  return input;
}

}  // namespace prosector::test
