// The shipped scenes' geometry, made with no data folder: every stand-in exists, and lies where the real
// thing would.

#include <gtest/gtest.h>

#include <map>

#include "common/anatomy/implicit.h"
#include "common/anatomy/sources.h"
#include "common/scene/load_scene.h"
#include "common/scene/scene_fields.h"
#include "tests/folders.h"

namespace prosector {
namespace {

Eigen::AlignedBox3d bounds(const TriangleMesh& mesh, const Pose& pose) {
  Eigen::AlignedBox3d box;
  for (const Vec3& x : mesh.positions) box.extend(pose * x);
  return box;
}

SceneDesc abdomen() {
  return load_scene(source_path("deploy/scenes/abdomen.toml"));
}

TEST(SceneSources, WordsAreTheShapesThatAnatomyMakes) {
  std::vector<std::string_view> shapes;
  for (const ImplicitShape& shape : implicit_shapes()) shapes.push_back(shape.name);
  for (const Child& child : scene_table().children)
    for (const Field& field : child.table().fields)
      if (field.key == "fallback") {
        EXPECT_EQ(field.words, shapes) << child.key;
      } else if (child.key == "soft" && field.key == "shape") {
        auto with_fabric = shapes;
        with_fabric.insert(with_fabric.end(), {"sheet", "rope"});
        EXPECT_EQ(field.words, with_fabric);
      }
}

TEST(SceneSources, OrganStandInsFillTheLabelsBoxes) {
  // In the room, of the labels' voxels at the scene's pose: m.
  const std::map<std::string, Eigen::AlignedBox3d> labels = {
      {"liver", {Vec3(-0.1018, 0.9010, -0.0833), Vec3(0.1043, 1.0719, 0.0660)}},
      {"kidney", {Vec3(-0.0722, 0.9213, -0.0153), Vec3(-0.0031, 0.9737, 0.0940)}},
      {"gallbladder", {Vec3(-0.0481, 1.0083, 0.0087), Vec3(-0.0142, 1.0459, 0.0500)}}};
  for (const SoftDesc& organ : abdomen().soft) {
    const TriangleMesh surface = make_anatomy(organ, {}, {}).surface;
    const Eigen::AlignedBox3d box = bounds(surface, Pose{});
    EXPECT_LT((box.center() - labels.at(organ.name).center()).norm(), 0.01) << organ.name;
    EXPECT_LT((box.sizes() - labels.at(organ.name).sizes()).cwiseAbs().maxCoeff(), 0.02) << organ.name;
  }
}

TEST(SceneSources, FreeRigidBodiesLieOnTheirSupport) {
  const std::map<std::string, double> lowest = {{"femur", 0.90}, {"probe", 0.906}, {"scalpel", 0.906}};
  for (const RigidDesc& rigid : abdomen().rigid) {
    if (rigid.fixed) continue;
    const double y = bounds(make_surface(rigid, {}, {}), rigid.pose).min().y();
    EXPECT_NEAR(y, lowest.at(rigid.name), 0.002) << rigid.name;
  }
}

}  // namespace
}  // namespace prosector
