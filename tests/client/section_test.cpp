// What closes solids that a plane opens.

#include "client/view/section.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "client/view/body_mesh.h"
#include "client/view/cap.h"
#include "common/scene/primitives.h"

namespace prosector {
namespace {

DrawItem item_of(const std::string& shape, const Vec3& size, std::uint64_t id = 1) {
  PartDesc part;
  part.shape = shape;
  part.size = size;
  return {.mesh = rigid_mesh(mesh_of(part), id),
          .pose = {},
          .appearance = {.surface = Surface::tissue},
          .solid = static_cast<std::uint32_t>(id)};
}

double area_of(const std::vector<DrawItem>& items, const SectionPlane& section) {
  std::vector<OutlineEdge> outline;
  for (const DrawItem& item : items) add_outline(item, section, outline);
  return fill(outline).area;
}

/// The sum of the triangles' areas, below zero for those that face away from the section's normal.
double area_of(const DrawMesh& mesh, const Vec3& normal) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Eigen::Vector3f a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
    sum += 0.5 * (b - a).cross(c - a).cast<double>().dot(normal);
  }
  return sum;
}

const Vec3 oblique = Vec3(1, 2, -0.7).normalized();

TEST(Section, OfASphereIsADisk) {
  const double radius = 0.1;
  const DrawItem ball = item_of("sphere", Vec3::Constant(2 * radius));
  for (const Vec3& normal : {Vec3(Vec3::UnitZ()), oblique, Vec3(-oblique)})
    for (const double height : {-0.06, 0.0013, 0.05}) {
      const double disk = std::numbers::pi * (radius * radius - height * height);
      EXPECT_NEAR(area_of({ball}, {normal, height}), disk, 0.02 * disk) << normal << ", " << height;
    }
  EXPECT_EQ(area_of({ball}, {oblique, 2 * radius}), 0);
}

TEST(Section, OfABoxIsItsCrossSection) {
  DrawItem box = item_of("box", {0.2, 0.1, 0.3});
  EXPECT_NEAR(area_of({box}, {Vec3::UnitX(), 0.031}), 0.1 * 0.3, 0.02 * 0.03);
  EXPECT_NEAR(area_of({box}, {Vec3(1, 1, 0).normalized(), 0}), std::sqrt(2.0) * 0.1 * 0.3, 0.02 * 0.03);
  box.pose = {{0.4, 0, 0}, Quat(Eigen::AngleAxisd(std::numbers::pi / 2, Vec3::UnitY()))};
  EXPECT_NEAR(area_of({box}, {Vec3::UnitX(), 0.4}), 0.1 * 0.2, 0.02 * 0.02);
  box.shape.A = Vec3(-2, 1, 1).asDiagonal();
  EXPECT_NEAR(area_of({box}, {Vec3::UnitX(), -0.8}), 0.1 * 0.2, 0.02 * 0.02) << "mirrored";
}

TEST(Section, LeavesHollowsOpenAndFillsWhatOverlapsOnce) {
  const DrawItem ball = item_of("sphere", Vec3::Constant(0.2));
  DrawItem hollow = item_of("sphere", Vec3::Constant(0.1));
  const double ring = std::numbers::pi * (0.01 - 0.0025), disk = std::numbers::pi * 0.01;
  auto turned = std::make_shared<DrawMesh>(*hollow.mesh);
  for (auto& t : turned->triangles) std::swap(t[1], t[2]);
  EXPECT_NEAR(area_of({ball, hollow}, {oblique, 0}), disk, 0.02 * disk);
  hollow.mesh = turned;
  EXPECT_NEAR(area_of({ball, hollow}, {oblique, 0}), ring, 0.02 * ring);
}

TEST(Section, StaysOpenWhereTheSurfaceHasAGap) {
  DrawItem ball = item_of("sphere", Vec3::Constant(0.2));
  auto torn = std::make_shared<DrawMesh>(*ball.mesh);
  std::erase_if(torn->triangles, [&](const auto& t) { return torn->positions[t[0]].y() > 0.05F; });
  ball.mesh = torn;
  const double open = area_of({ball}, {Vec3::UnitX(), 0.001}), disk = std::numbers::pi * 0.01;
  EXPECT_LT(open, 0.97 * disk);
  EXPECT_GE(open, 0);
}

TEST(Section, CapsFaceWhatIsTakenAwayAndKeepTheirPlaceInTheRestShape) {
  DrawList list;
  list.items = {item_of("sphere", Vec3::Constant(0.2)), item_of("box", Vec3::Constant(0.1), 2)};
  list.items[1].solid = 0;
  auto moved = std::make_shared<DrawMesh>(*list.items[0].mesh);
  moved->rest_positions = moved->positions;
  for (auto& x : moved->positions) x += Eigen::Vector3f(0.5F, 0, 0);
  list.items[0].mesh = moved;
  list.section = SectionPlane{Vec3::UnitX(), 0.52};
  std::uint64_t next_id = 9;
  SectionCaps caps;
  const auto added = caps.add(list, next_id);
  ASSERT_EQ(added.size(), 1u) << "what has no number stays whole";
  EXPECT_EQ(added[0].first, 1u);
  ASSERT_EQ(added[0].second, 2u);
  const DrawItem& cap = list.items[2];
  EXPECT_EQ(cap.solid, 0u) << "which the section would take away";
  const double disk = std::numbers::pi * (0.01 - 0.0004);
  EXPECT_NEAR(area_of(*cap.mesh, Vec3::UnitX()), disk, 0.02 * disk);
  for (std::size_t v = 0; v < cap.mesh->positions.size(); ++v) {
    ASSERT_NEAR(cap.mesh->positions[v].x(), 0.52, 1e-3);
    ASSERT_NEAR(cap.mesh->rest_positions[v].x(), 0.02, 1e-5);
  }
  const std::uint64_t revision = cap.mesh->revision;
  list.items.resize(2);
  caps.add(list, next_id);
  EXPECT_EQ(list.items[2].mesh->revision, revision) << "nothing moved";
  list.items.resize(2);
  list.section->offset += 0.01;
  caps.add(list, next_id);
  EXPECT_NE(list.items[2].mesh->revision, revision);
}

TEST(Section, FacesTheEyeOrTheNearestAxis) {
  const Vec3 middle(0.1, 1, 0.2);
  const SectionPlane near_axis = section_facing(Vec3(-1, 0.1, 0.1).normalized(), middle);
  EXPECT_EQ(near_axis.normal, Vec3(-Vec3::UnitX()));
  EXPECT_NEAR(near_axis.height(middle), 0, 1e-12);
  EXPECT_EQ(section_facing(oblique, middle).normal, oblique);
}

}  // namespace
}  // namespace prosector
