// 1,000 falling rigid boxes: a scene without tissue must match Bullet alone in motion and cost. The server's
// simulation and Bullet alone step alternately.

#include <fmt/format.h>

#include "server/calibration/stopwatch.h"
#include "tests/bench/contact_run.h"
#include "tests/physics/plain_world.h"

namespace prosector {
namespace {

SceneDesc scene_of(int boxes) {
  SceneDesc scene;
  scene.rigid = {test::table()};
  scene.rigid[0].geometry.parts[0].size = {20, 0.1, 20};
  for (int i = 0; i < boxes; ++i) {
    const Vec3 at(0.14 * (i % 10 - 4.5) + 0.01 * (i / 100 % 3), 0.1 + 0.13 * (i / 100),
                  0.14 * (i / 10 % 10 - 4.5));
    scene.rigid.push_back(test::part_body(fmt::format("box {}", i), "box", Vec3::Constant(0.1), at));
  }
  return scene;
}

}  // namespace

void falling_boxes_case(ContactRows& rows, bool quick) {
  const int boxes = quick ? 10 : 1000, ticks = quick ? 10 : 300;
  const SceneDesc scene = scene_of(boxes);
  ContactRun ours(scene);
  test::PlainWorld bullet(scene);
  double bullet_ms = 0;
  for (int tick = 0; tick < ticks; ++tick) {
    ours.step();
    const double start = cpu_ms();
    bullet.step();
    bullet_ms += cpu_ms() - start;
  }
  double apart = 0;
  for (int i = 1; i <= boxes; ++i) {
    const auto body = static_cast<BodyId>(i);
    apart = std::max(apart, (ours.simulation().rigid_state(body).pose.p - bullet.state(body).pose.p).norm());
  }
  const std::string setting = fmt::format("{} rigid boxes", boxes);
  rows.add(ours, setting, {"CPU time over Bullet's", "1", ours.ms_per_tick() / (bullet_ms / ticks), 1, 0.1},
           {{"bullet_ms_per_tick", bullet_ms / ticks}});
  rows.add(ours, setting, {"largest position difference from Bullet", "mm", 1e3 * apart, 0, 0});
}

}  // namespace prosector
