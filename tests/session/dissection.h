#pragma once
// A session in which a host cuts a piece off and an observer looks on.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/physics/scalpel.h"
#include "tests/session/hosted.h"

namespace prosector::test {

inline constexpr BodyId cut_body = 1;  // or membrane

enum class Tissue { block, mass_spring, xpbd };

/// So tender, and the blade so long, that nothing is left whole behind it.
inline SceneDesc tender(Tissue tissue) {
  SceneDesc scene = tissue == Tissue::block         ? block_and_scalpel()
                    : tissue == Tissue::mass_spring ? membrane_and_scalpel("mass_spring")
                                                    : membrane_and_scalpel("xpbd");
  scene.name = "rewound";
  scene.soft[0].material.toughness = 0;
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
      ada.command(Grasp{});
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
  void rewind(std::uint32_t revision) { ada.command(Rewind{cut_body, revision}); }
  bool holds() const {
    return !hosted.simulation.hands().empty() && hosted.simulation.hands()[0].holding == scalpel;
  }
  std::uint64_t mesh() const { return hosted.simulation.soft(cut_body).content_hash(); }

  Hosted hosted;
  Guest ada, eve;
  Vec3 at{-0.12, 0.14, 0.02};
  bool hand_is_there = false;
};

/// Largest distance of what a client draws from what the server has, m.
inline double error(const Simulation& simulation, Guest& guest, BodyId body) {
  SoftReplica* soft = guest.replica.bodies().soft(body);
  if (soft == nullptr) return 1;
  soft->sample(static_cast<double>(simulation.time().tick) + 1, 1.0 / 60);
  const Anatomy& anatomy = simulation.soft(body).anatomy();
  const double* x = simulation.soft_state(body).motion.x.data();
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

}  // namespace prosector::test
