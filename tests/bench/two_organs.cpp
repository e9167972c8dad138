#include "tests/bench/two_organs.h"

#include <fmt/format.h>

#include <algorithm>

#include "server/calibration/stopwatch.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "server/physics/simulation.h"
#include "tests/play/judge.h"

namespace prosector {
namespace {

constexpr ParticipantId somebody = 1;
constexpr BodyId left = 1, right = 2;
constexpr double near_seconds = 0.25;  // between two penetration checks

/// A tied block and a free one side by side on a table.
SceneDesc two_organs(const Rung& rung) {
  SceneDesc scene;
  scene.name = "two organs";
  RigidDesc& table = scene.rigid.emplace_back();
  table.name = "table";
  table.fixed = true;
  table.geometry.parts.push_back({});
  table.geometry.parts[0].size = {1, 0.04, 1};
  table.geometry.parts[0].pose.p = {0, -0.02, 0};
  for (const double x : {-0.051, 0.051}) {
    SoftDesc& organ = scene.soft.emplace_back();
    rung.apply_to(organ);
    organ.name = x < 0 ? "left" : "right";
    organ.geometry.shape = "block";
    organ.geometry.size = {0.1, 0.06, 0.1};
    organ.pose.p = {x, 0.03, 0};
    organ.geometry.cell = organ.geometry.surface_cell = 0.02;
  }
  scene.soft[0].attach.push_back({{-10.09, 0.03, 0}, 10, 1e9});
  return scene;
}

/// Returns the hand's target: it is thrown into the first organ from above, through it into the second at
/// 5 m/s, pressed down there, and withdrawn through both.
std::optional<Vec3> hand_at(double t) {
  if (t < 0.2) return Vec3(-0.03, 0.2, 0);
  if (t < 1) return Vec3(-0.03, 0.01, 0);
  if (t < 1.04) return Vec3(-0.03 + 5 * (t - 1), 0.03, 0);
  if (t < 2) return Vec3(0.05, 0.005, 0);
  if (t < 2.2) return Vec3(0.05 - (t - 2), 0.02, 0);
  return std::nullopt;
}

constexpr double hand_leaves = 2.2, ends = 7.2;  // s

}  // namespace

StabilityResult press_two_organs(const Rung& rung, double limit_ms) {
  CompileOptions options;
  options.threads = 1;
  Simulation simulation(two_organs(rung), options);
  const test::Judge judge(simulation);
  const double h = 1 / simulation.scene().tick_rate;
  StabilityResult result;
  result.tets = tet_count(simulation);
  for (const BodyId body : {left, right})
    result.nodes += static_cast<std::size_t>(simulation.soft(body).nodes());
  std::vector<double> steps_ms;
  double spent_ms = 0, looked = 0;
  bool there = false;
  test::Finding found;
  for (double t = 0; t < ends; t += h) {
    TickInput input;
    const std::optional<Vec3> at = hand_at(t);
    if (at.has_value() != there)
      input.events.push_back({there ? HandEvent::Kind::vanish : HandEvent::Kind::appear, somebody});
    if (at) input.targets.push_back({somebody, right_hand, {*at, Quat::Identity()}, {}});
    there = at.has_value();
    const double start = cpu_ms();
    const StepReport& report = simulation.step(input);
    steps_ms.push_back(cpu_ms() - start);
    spent_ms += steps_ms.back();
    ++result.steps;
    bool reset = false, loss = false;
    for (const BodyReport& row : report.bodies) {
      reset = reset || row.reset;
      loss = loss || (!row.reset && !row.converged && !row.note.empty());
      if (row.reset || (!row.converged && !row.note.empty() && result.resets == 0))
        result.reason = row.body + ": " + row.note;
    }
    result.resets += reset ? 1 : 0;
    result.losses += loss ? 1 : 0;
    if (spent_ms > limit_ms) {
      result.reason = fmt::format("stopped after {:.0f} ms of CPU time", spent_ms);
      return result;
    }
    if (t < hand_leaves || t - looked < near_seconds) continue;
    looked = t;
    found = judge.look(simulation);
    if (!found.good() || found.inverted > 0)
      result.back_after_s = -1;
    else if (result.back_after_s < 0)
      result.back_after_s = t - hand_leaves;
  }
  found = judge.look(simulation);
  result.ms_per_frame = median(steps_ms);
  result.worst_ms_per_frame = *std::max_element(steps_ms.begin(), steps_ms.end());
  result.steps_per_s = 1e3 / result.ms_per_frame;
  result.met_deadline = result.ms_per_frame <= 1e3 * h;
  result.shape_error = found.overlap;
  if (!found.good() || found.inverted > 0) {
    result.verdict = Verdict::fails;
    result.reason = found.good() ? "inverted element" : found.where;
  } else {
    result.verdict = result.resets + result.losses > 0 ? Verdict::degrades : Verdict::survives;
  }
  return result;
}

}  // namespace prosector
