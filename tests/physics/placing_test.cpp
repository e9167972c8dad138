#include <gtest/gtest.h>

#include "common/error.h"
#include "tests/physics/scenes.h"

namespace prosector::test {
namespace {

/// Returns what a scene's compilation reports.
std::string report_of(const SceneDesc& scene) {
  std::string out;
  CompileOptions reporting = options();
  reporting.progress = [&](const std::string& line) { out += line + "\n"; };
  Simulation simulation(scene, reporting);
  return out;
}

TEST(Placing, ARigidBodyInsideASolidIsRefused) {
  SceneDesc scene;
  scene.soft = {block("organ")};
  scene.rigid = {part_body("stone", "box", {0.01, 0.01, 0.01}, {0, 0.03, 0})};
  try {
    Simulation simulation(scene, options());
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("\"stone\" is placed inside [[soft]] \"organ\""),
              std::string::npos)
        << error.what();
  }
  scene.rigid[0].contact.touches = {"default"};
  scene.soft[0].contact.group = "inner";
  EXPECT_NO_THROW(Simulation(scene, options())) << "they may not touch";
  scene.soft[0].contact.group = default_group;
  scene.rigid[0].contact.touches.clear();
  scene.rigid[0].pose.p.y() = 0.07;
  EXPECT_NO_THROW(Simulation(scene, options())) << "it is above";
}

TEST(Placing, SolidsInEachOtherAreReported) {
  SceneDesc scene;
  scene.soft = {block("one"), block("other")};
  scene.soft[1].pose.p.x() += 0.07;
  EXPECT_NE(report_of(scene).find("one and other: warning: they are placed in each other"),
            std::string::npos);
  scene.soft[1].pose.p.x() += 0.04;
  EXPECT_EQ(report_of(scene).find("placed in each other"), std::string::npos);
}

TEST(Placing, ABodyThatItsWeightFlattensIsReported) {
  SceneDesc scene;
  scene.soft = {block()};
  for (const double modulus : {5400.0, 700.0, 600.0, 100.0}) {
    scene.soft[0].material.youngs_modulus = modulus;
    EXPECT_EQ(report_of(scene).find("the body's weight presses on its base") != std::string::npos,
              modulus < 620)
        << modulus;
  }
  scene.soft[0].attach = {{{0, 0, 0}, 0.2, 1e6}};
  EXPECT_EQ(report_of(scene).find("the body's weight presses"), std::string::npos) << "it is attached";
}

}  // namespace
}  // namespace prosector::test
