// Geometry of bodies and people: normals, tubes, figures.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "client/view/avatar.h"
#include "client/view/body_mesh.h"
#include "client/view/camera.h"
#include "client/view/contact_overlay.h"
#include "client/view/corner_axes.h"
#include "client/view/force_arrow.h"
#include "client/view/hand_cues.h"
#include "client/view/near_fade.h"
#include "client/view/normals.h"
#include "client/view/panel_view.h"
#include "client/view/pick.h"
#include "client/view/room.h"
#include "client/view/scene_tour.h"
#include "client/view/set_text.h"
#include "client/view/still_scene.h"
#include "client/view/surface_tree.h"
#include "client/view/tube.h"
#include "client/view/wireframe.h"
#include "common/scene/primitives.h"
#include "tests/client/many_scripts.h"

namespace prosector {
namespace {

TEST(Normals, OfASphereAreItsRadii) {
  PartDesc part;
  part.shape = "sphere";
  const TriangleMesh mesh = mesh_of(part);
  const CreasedMesh creased = split_creases(mesh);
  EXPECT_EQ(creased.positions.size(), mesh.positions.size()) << "nothing to split";
  for (std::size_t k = 0; k < creased.positions.size(); ++k)
    EXPECT_GT(creased.normals[k].dot(creased.positions[k].normalized()), 0.99F);
}

TEST(Normals, OfABoxAreSharp) {
  const TriangleMesh mesh = mesh_of(PartDesc{});
  const CreasedMesh creased = split_creases(mesh);
  EXPECT_EQ(creased.positions.size(), 24u);
  ASSERT_EQ(creased.triangles.size(), mesh.triangles.size());
  for (std::size_t t = 0; t < creased.triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = creased.triangles[t][k];
      EXPECT_EQ(creased.source[v], mesh.triangles[t][k]);
      EXPECT_NEAR(creased.normals[v].cwiseAbs().maxCoeff(), 1, 1e-6);
    }
}

TEST(Normals, SurviveTrianglesWithoutArea) {
  const std::vector<Eigen::Vector3f> positions(3, Eigen::Vector3f::Ones());
  const std::vector<std::array<std::uint32_t, 3>> triangles = {{0, 1, 2}};
  std::vector<Eigen::Vector3f> normals;
  smooth_normals(positions, triangles, normals);
  for (const auto& n : normals) EXPECT_EQ(n, Eigen::Vector3f::UnitY());
  TriangleMesh flat;
  flat.positions.assign(3, Vec3::Zero());
  flat.triangles = {{0, 1, 2}};
  for (const auto& n : split_creases(flat).normals) EXPECT_TRUE(n.allFinite());
}

/// Of a closed mesh, by the divergence theorem.
double enclosed_volume(const DrawMesh& mesh) {
  double six_times = 0;
  for (const auto& t : mesh.triangles)
    six_times += mesh.positions[t[0]].cross(mesh.positions[t[1]]).dot(mesh.positions[t[2]]);
  return six_times / 6;
}

std::vector<Eigen::Vector3f> helix(float turn) {
  std::vector<Eigen::Vector3f> axis;
  for (int i = 0; i <= 200; ++i) {
    const float s = 0.005F * static_cast<float>(i);
    axis.emplace_back(s, 0.1F * std::cos(turn * s), 0.1F * std::sin(turn * s));
  }
  return axis;
}

TEST(Tube, LiesAroundItsAxis) {
  constexpr float diameter = 0.02F;
  const auto straight = helix(0), wound = helix(12);
  const auto tube = tube_mesh(straight, diameter, 1);
  const auto check = [&](const std::vector<Eigen::Vector3f>& axis) {
    double length = 0;
    for (std::size_t i = 1; i < axis.size(); ++i) length += (axis[i] - axis[i - 1]).norm();
    const double r = diameter / 2;
    // A ring of 12 corners has 95.5 % of the circle's area.
    EXPECT_NEAR(enclosed_volume(*tube), 0.955 * (M_PI * r * r * length + 4.0 / 3 * M_PI * r * r * r),
                0.01 * M_PI * r * r * length);
    for (std::size_t v = 0; v < tube->positions.size(); ++v) {
      float nearest = 1;
      for (const auto& p : axis) nearest = std::min(nearest, (tube->positions[v] - p).norm());
      EXPECT_NEAR(nearest, diameter / 2, 1e-3 * diameter);
      EXPECT_NEAR(tube->normals[v].norm(), 1, 1e-5);
    }
  };
  check(straight);
  sweep_tube(wound, diameter, *tube);
  check(wound);
}

TEST(Tube, DoesNotTwistAndSurvivesCoincidingPoints) {
  auto axis = helix(12);
  std::fill(axis.begin() + 50, axis.begin() + 60, axis[50]);
  const auto tube = tube_mesh(axis, 0.002F, 1);
  const std::size_t sides = tube->positions.size() / (axis.size() + 8);
  for (std::size_t v = sides; v < tube->positions.size(); ++v) {
    ASSERT_TRUE(tube->positions[v].allFinite());
    EXPECT_GT(tube->normals[v].dot(tube->normals[v - sides]), 0.7F) << v;
  }
  std::fill(axis.begin(), axis.end(), axis[0]);
  sweep_tube(axis, 0.002F, *tube);
  for (const auto& x : tube->positions) EXPECT_LT((x - axis[0]).norm(), 0.0011F);
}

const FigureSurfaces& figure() {
  static const FigureSurfaces made = make_figure_surfaces();
  return made;
}

TEST(Figure, IsOfClosedSurfacesOfAPersonsSize) {
  const auto volume = [](const TriangleMesh& mesh) {
    double six_times = 0;
    for (const auto& t : mesh.triangles)
      six_times += mesh.positions[t[0]].cross(mesh.positions[t[1]]).dot(mesh.positions[t[2]]);
    return six_times / 6;
  };
  EXPECT_NEAR(volume(figure().head), 4e-3, 1.2e-3) << "m³";
  EXPECT_GT(volume(figure().bust), 10e-3);
  EXPECT_GT(volume(figure().forearm), 0.6e-3);
  EXPECT_LT(volume(figure().forearm), 2e-3);
  for (const TriangleMesh* mesh :
       {&figure().head, &figure().cap, &figure().mask, &figure().bust, &figure().forearm}) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& t : mesh->triangles)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_TRUE(edges.emplace(t[k], t[(k + 1) % 3]).second) << "twice the same way round";
    for (const auto& [a, b] : edges) EXPECT_TRUE(edges.contains({b, a})) << "open";
    EXPECT_LT(mesh->triangles.size(), 6000u);
  }
  double nose = 0;
  for (const Vec3& x : figure().head.positions) nose = std::min(nose, x.z());
  EXPECT_LT(nose, -0.03) << "the nose points ahead";
}

TEST(Figure, ShouldersStayUprightBelowAnyHead) {
  for (const double yaw : {0.0, 2.0, -3.0})
    for (const double pitch : {-1.5, -0.7, 0.0, 1.2, 1.5}) {
      const Pose head{{1, 1.5, 0},
                      Quat(Eigen::AngleAxisd(yaw, Vec3::UnitY()) * Eigen::AngleAxisd(pitch, Vec3::UnitX()))};
      const Pose bust = bust_below(head);
      EXPECT_NEAR((bust.q * Vec3::UnitY()).y(), 1, 1e-9);
      EXPECT_LT((bust * Vec3(0, -0.09, 0.1) - head * Vec3(0, -0.09, 0.1)).norm(), 1e-9) << "at the neck";
      EXPECT_NEAR((bust.q * -Vec3::UnitZ()).dot(Vec3(-std::sin(yaw), 0, -std::cos(yaw))), 1, 1e-9)
          << yaw << " " << pitch;
    }
}

TEST(Figure, TheElbowIsBentTowardsTheShoulderAsFarAsAWristBends) {
  const Pose bust{{0, 1.6, 0.5}, Quat::Identity()};
  for (const std::size_t hand : {left_hand, right_hand}) {
    const double side = hand == right_hand ? 1 : -1;
    const Pose ahead{{side * 0.17, 1.33, 0}, Quat::Identity()};
    EXPECT_LT(forearm_behind(ahead, bust, hand).q.angularDistance(ahead.q), 1e-6) << "straight before it";
    const Pose low{{side * 0.17, 1.1, 0.2}, Quat::Identity()};
    const Vec3 way = (bust * Vec3(side * 0.17, -0.27, 0.1) - low.p).normalized();
    EXPECT_NEAR((forearm_behind(low, bust, hand).q * Vec3::UnitZ()).dot(way), 1, 1e-6);
    const Pose turned{low.p, Quat(Eigen::AngleAxisd(2.5, Vec3::UnitY()))};
    EXPECT_NEAR(forearm_behind(turned, bust, hand).q.angularDistance(turned.q), 0.6, 1e-6);
  }
}

TEST(Avatar, HasAHeadShouldersAndAName) {
  DrawList list;
  const Pose pose{{1, 1.5, 0}, Quat(Eigen::AngleAxisd(0.5, Vec3::UnitY()))};
  add_avatar(list, FigureMeshes(figure(), 1), pose, {1, 0, 0}, "Vesalius");
  ASSERT_EQ(list.items.size(), 5u) << "head, eyes, cap, mask, shoulders";
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(list.items[k].pose.p, pose.p);
  EXPECT_LT((list.items[4].pose.p - pose.p).norm(), 1e-9) << "of a head held level";
  EXPECT_GT(list.items[4].appearance.color.x(), 2 * list.items[4].appearance.color.y()) << "in their colour";
  ASSERT_EQ(list.texts.size(), 1u);
  EXPECT_EQ(list.texts[0].text, "Vesalius");
  EXPECT_GT(list.texts[0].at.y(), pose.p.y() + 0.15) << "above the head";
}

/// A floor at a height, as cues find it.

}  // namespace
}  // namespace prosector
