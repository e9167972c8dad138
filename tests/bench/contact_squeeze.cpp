// Extreme input: tissue squeezed flat between plates, a probe that passes through at 50 m/s, a hand that
// jumps 1 m every tick. The state must stay finite and bounded, and the shape must recover.

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/bench/contact_run.h"

namespace prosector {
namespace {

constexpr double back = 1.0;  // mm: largest shape error of recovered tissue

/// Returns a scene with tissue on a frictionless table, since friction could preserve a strain. The tissue is
/// attached within `radius` of the centre of its base.
SceneDesc tied_block(double radius) {
  SceneDesc scene;
  scene.rigid = {test::table()};
  scene.rigid[0].contact.friction = 0;
  scene.soft = {test::block()};
  scene.soft[0].attach = {{{0, 0, 0}, radius, 2e7}};
  return scene;
}

/// Returns the largest distance of a node from the centre of the block, m.
double spread(const Simulation& s, BodyId body) {
  const VecX& x = s.soft_state(body).motion.x;
  const Vec3 centre = soft_centre(s, body);
  return std::sqrt((x.reshaped(3, x.size() / 3).colwise() - centre).colwise().squaredNorm().maxCoeff());
}

void report_recovery(ContactRows& rows, ContactRun& run, const std::string& setting, BodyId body,
                     double widest) {
  rows.add(run, setting, {"largest extent over the half diagonal", "1", widest / 0.0768, 1, 4});
  run.run(300);
  rows.add(run, setting,
           {"shape error after 5 s", "mm", 1e3 * run.simulation().max_displacement(body), 0, back});
}

/// Moves a plate down at `speed` m/s to 6 mm above the table, holds it for 0.2 s and raises it again.
void squeeze(ContactRows& rows, double speed) {
  SceneDesc scene = tied_block(0.015);  // only the base: higher attachments would be pulled through the plate
  scene.rigid.push_back(test::part_body("press", "box", {0.4, 0.02, 0.4}, {0, 0.075, 0}));
  scene.rigid[1].fixed = true;
  scene.rigid[1].contact.friction = 0;
  ContactRun run(scene);
  double widest = 0, force = 0;
  const double open = 0.075, shut = 0.016;
  const auto plate_at = [&](double y) {
    run.step(driving(1, {{0, y, 0}, Quat::Identity()}));
    widest = std::max(widest, spread(run.simulation(), 2));
    for (const Exchange& t : run.simulation().exchanges())
      if (t.b == 1) force = std::max(force, t.normal_impulse / run.h());
  };
  for (double y = open; y > shut;) plate_at(y = std::max(shut, y - speed * run.h()));
  for (int i = 0; i < 12; ++i) plate_at(shut);
  const double thickness = [&] {  // of the tissue between the plates
    const VecX& x = run.simulation().soft_state(2).motion.x;
    const auto heights = x(Eigen::seq(1, Eigen::last, Eigen::fix<3>));
    return heights.maxCoeff() - heights.minCoeff();
  }();
  for (double y = shut; y < open;) plate_at(y = std::min(open, y + speed * run.h()));
  const std::string setting = fmt::format("plates closing at {} m/s", speed);
  // Contacts of both faces yield according to the scene's contact_stiffness, three times as much at the
  // edges.
  const SoftDesc& desc = scene.soft[0];
  const double yields = force / (desc.geometry.size.x() * desc.geometry.size.z()) /
                        desc.material.youngs_modulus * desc.geometry.surface_cell / scene.contact_stiffness;
  rows.add(run, setting,
           {"thickness after 0.2 s of squeezing", "mm", 1e3 * thickness, 6, 1e3 * 2 * 3 * yields},
           {{"most_force_N", force}});
  report_recovery(rows, run, setting, 2, widest);
}

void push_through(ContactRows& rows, double speed, double tick_rate) {
  SceneDesc scene = tied_block(0.04);
  scene.tick_rate = tick_rate;
  scene.rigid.push_back(test::part_body("probe", "capsule", {0.012, 0.2, 0}, {-1, 0.03, 0.005}));
  scene.rigid[1].fixed = true;
  scene.rigid[1].pose.q = Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitZ()));
  ContactRun run(scene);
  double widest = 0;
  for (double x = -1; x < 1;) {
    x += speed * run.h();
    run.step(driving(1, {{x, 0.03, 0.005}, scene.rigid[1].pose.q}));
    widest = std::max(widest, spread(run.simulation(), 2));
  }
  rows.add(run, fmt::format("probe at {} m/s, {} ticks/s", speed, tick_rate),
           {"largest extent over the half diagonal", "1", widest / 0.0768, 1, 4});
  run.run(static_cast<int>(5 * tick_rate));
  rows.add(run, fmt::format("probe at {} m/s, {} ticks/s", speed, tick_rate),
           {"shape error after 5 s", "mm", 1e3 * run.simulation().max_displacement(2), 0, back});
}

}  // namespace

void squeeze_case(ContactRows& rows, bool quick) {
  for (const double speed : {0.05, 0.5, 5.0}) {
    squeeze(rows, speed);
    if (quick) return;
  }
}

void probe_case(ContactRows& rows, bool quick) {
  push_through(rows, 50, 60);
  if (quick) return;
  push_through(rows, 50, 1000);
  push_through(rows, 2, 60);
}

void teleport_case(ContactRows& rows, bool quick) {
  ContactRun run(tied_block(0.04));
  run.step(test::appear({0.5, 0.03, 0}));
  double widest = 0, farthest = 0;
  for (int i = 0; i < (quick ? 12 : 120); ++i) {
    run.step(test::target({i % 2 == 0 ? -0.5 : 0.5, 0.03, 0}));
    widest = std::max(widest, spread(run.simulation(), 1));
    farthest = std::max(farthest, run.simulation().hands()[0].pose.p.norm());
  }
  const std::string setting = "hand jumps 1 m every tick";
  rows.add(run, setting, {"distance of the hand from the centre", "m", farthest, 0, 1});
  run.run(60, test::target({1, 1, 1}));
  report_recovery(rows, run, setting, 1, widest);
  if (quick) return;
  ContactRun held(tied_block(0.04));  // jumps of a hand that grasps the tissue
  const Vec3 on_top(-0.004, 0.073, 0.045);
  held.step(test::appear(on_top));
  held.step(test::event(HandEvent::Kind::grasp, on_top));
  widest = 0;
  for (int i = 0; i < 60; ++i) {
    held.step(test::target(on_top + Vec3(0, i % 2 == 0 ? 1 : 0, 0)));
    widest = std::max(widest, spread(held.simulation(), 1));
  }
  held.step(test::event(HandEvent::Kind::release, on_top));
  held.run(60, test::target({1, 1, 1}));
  report_recovery(rows, held, "hand jumps 1 m every tick, grasping", 1, widest);
}

}  // namespace prosector
