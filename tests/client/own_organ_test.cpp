// Somebody's own organ, drafted by `prosector-scene new`, is cut with the scalpel that the draft lays beside
// it.

#include <gtest/gtest.h>

#include "common/draft/draft_scene.h"
#include "common/scene/load_scene.h"
#include "tests/anatomy/files.h"
#include "tests/client/acted_desk.h"
#include "tests/draft/surface_texts.h"

namespace prosector::test {
namespace {

TEST(OwnOrgan, IsCutWithTheScalpelThatItsDraftHas) {
  const testing_files::TempDir dir;
  testing_files::write(dir.path / "liver.obj", as_obj(surface_of("liver", {0.22, 0.12, 0.16}, 0.012), 1000));
  const Draft draft = draft_scene(dir.path / "liver.obj", dir.path, {});
  testing_files::write(dir.path / "scene.toml", draft.toml);
  const SceneDesc scene = load_scene(dir.path / "scene.toml");
  ASSERT_EQ(scene.rigid.back().name, "scalpel");
  CompileOptions options;
  options.threads = 1;
  Simulation simulation(scene, options);
  const auto scalpel = static_cast<BodyId>(scene.rigid.size() - 1), liver = static_cast<BodyId>(scalpel + 1);
  const Vec3 handle = scene.rigid.back().pose.p + Vec3(0, 0.002, 0.02), from(-0.04, 1, 0),
             to(0.04, 1, 0);  // m
  ActedDesk desk(simulation, Haste{});
  desk.point_at(handle);
  desk.wait(1);
  desk.press();
  ASSERT_TRUE(desk.waits_until_held(scalpel, true, 5));
  desk.let_go();
  desk.wait(1.5);
  desk.draw(handle, from, 1);
  desk.wait(1.5);
  desk.press();
  desk.draw(from, to, 2);
  desk.let_go();
  for (int k = 0; k < 60 && desk.draws(); ++k) desk.wait(0.5);
  EXPECT_GT(simulation.revision(liver), 0U);
  EXPECT_TRUE(desk.messages().empty()) << desk.messages().front();
}

}  // namespace
}  // namespace prosector::test
