// The geometry that the view makes: normals, people, panels, what is pointed at.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "client/view/body_mesh.h"
#include "client/view/camera.h"
#include "client/view/contact_overlay.h"
#include "client/view/corner_axes.h"
#include "client/view/force_arrow.h"
#include "client/view/hand_cues.h"
#include "client/view/near_fade.h"
#include "client/view/panel_view.h"
#include "client/view/pick.h"
#include "client/view/room.h"
#include "client/view/scene_tour.h"
#include "client/view/set_text.h"
#include "client/view/still_scene.h"
#include "client/view/surface_tree.h"
#include "client/view/wireframe.h"
#include "common/scene/primitives.h"
#include "tests/client/many_scripts.h"

namespace prosector {
namespace {

TEST(PanelView, ScrollsADescriptionThatDoesNotFit) {
  PanelView view(1);
  SceneBody part;
  part.name = "part";
  part.description = "short";
  EXPECT_EQ(view.hidden_lines(part), 0u);
  part.description.clear();
  for (int k = 0; k < 200; ++k) part.description += "word" + std::to_string(k) + " ";
  const std::size_t hidden = view.hidden_lines(part);
  ASSERT_GT(hidden, 1u);
  const auto shown = [&](std::size_t line) {
    DrawList list;
    view.add(list, {}, part, std::nullopt, line);
    return list.texts[1].text;
  };
  EXPECT_EQ(shown(0).substr(0, 5), "word0");
  EXPECT_NE(shown(1).substr(0, 5), "word0");
  EXPECT_EQ(shown(hidden), shown(hidden + 7)) << "no farther than to the end";
  DrawList list;
  view.add(list, {}, part, std::nullopt, hidden);
  Typesetter typesetter;
  EXPECT_FALSE(set_text(typesetter, list.texts[1], 1).block->cut);
  EXPECT_NE(list.texts[1].text.find("word199"), std::string::npos);
}

/// Returns how many buttons glow: those drawn much brighter than an idle one, without being touched.
std::ptrdiff_t glowing(const Panel& panel) {
  PanelView view(1);
  DrawList list;
  view.add(list, panel, {});
  return std::ranges::count_if(list.items,
                               [](const DrawItem& item) { return item.appearance.color.x() > 0.5; });
}

TEST(PanelView, AButtonGlowsOnlyWhileItsEffectIsOn) {
  Panel panel;
  const auto set = [&](PanelControl control, bool on) {
    panel.controls[static_cast<std::size_t>(control)].on = on;
  };
  set(PanelControl::attach, true);  // as a scene begins
  set(PanelControl::room_lights, true);
  EXPECT_EQ(glowing(panel), 0);
  for (const ControlDesc& control : panel_controls) {
    if (control.kind != ControlKind::button) continue;
    const bool at_first = panel.controls[static_cast<std::size_t>(control.control)].on;
    set(control.control, !at_first);
    EXPECT_EQ(glowing(panel), 1) << control.label;
    set(control.control, at_first);
  }
}

/// A ball of 2 cm before an eye at the origin, and how opaque it is.
double opacity_at(const Vec3& middle) {
  PartDesc ball;
  ball.shape = "sphere";
  ball.size = Vec3::Constant(0.02);
  DrawList list;
  list.cameras.emplace_back();
  list.items.push_back(
      {.mesh = rigid_mesh(mesh_of(ball), 1), .pose = {middle, Quat::Identity()}, .appearance = {}});
  const std::array<std::size_t, 1> items = {0};
  fade_near_eyes(list, items);
  return list.items[0].opacity;
}

TEST(NearFade, HidesWhatTheNearPlaneWouldCutOpen) {
  const double near = DrawCamera().near;
  EXPECT_EQ(opacity_at({0, 0, -near}), 0) << "in it";
  EXPECT_EQ(opacity_at({0, 0, -near - 0.011}), 0) << "just beyond";
  EXPECT_GT(opacity_at({0, 0, -0.09}), 0.1);
  EXPECT_LT(opacity_at({0, 0, -0.09}), 0.9);
  EXPECT_EQ(opacity_at({0, 0, -near_fade_begins - 0.011}), 1);
  EXPECT_EQ(opacity_at({0.5, 0, -near}), 1) << "beside the picture";
  EXPECT_EQ(opacity_at({0, 0, 0.2}), 1) << "behind the eye";
}

FindSurface floor_at(double height) {
  return [height](const Ray& ray, std::optional<BodyId>) -> std::optional<Picked> {
    const double distance = (height - ray.from.y()) / ray.along.y();
    if (!(distance > 0)) return std::nullopt;
    return Picked{{distance, ray.from + distance * ray.along, Vec3::UnitY()}, 0};
  };
}

TEST(ForceArrow, IsAsLongAsTheForceIsLargeAndPointsAlongIt) {
  const Vec3 point(0.1, 1, 0.2), direction = Vec3(1, 2, -1).normalized();
  double last = 0;
  for (const double force : {0.1, 1., 4.}) {
    DrawList list;
    add_force_arrow(list, point, force * direction);
    ASSERT_EQ(list.lines.size(), 5u);
    const Vec3 shaft = list.lines[0].b - list.lines[0].a;
    EXPECT_EQ(list.lines[0].a, point);
    EXPECT_NEAR(shaft.normalized().dot(direction), 1, 1e-12);
    EXPECT_GT(shaft.norm(), last);
    last = shaft.norm();
    for (const DrawLine& line : list.lines) EXPECT_EQ(line.b, list.lines[0].b) << "all end at its tip";
  }
  DrawList huge, faint, broken;
  add_force_arrow(huge, point, 1e6 * direction);
  EXPECT_LT((huge.lines[0].b - point).norm(), 0.2);
  add_force_arrow(faint, point, 0.01 * direction);
  EXPECT_TRUE(faint.lines.empty());
  add_force_arrow(broken, point, Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_TRUE(broken.lines.empty());
}

TEST(HandCues, AShadowGrowsDarkerAsTheHandComesNearAndLiesOnTheSurface) {
  HandCues cues;
  std::uint64_t next_mesh_id = 1;
  double last = 0;
  for (const double height : {0.5, 0.2, 0.1, 0.05, 0.01, 0.0}) {
    DrawList list;
    cues.add(list, {0.1, 1 + height, 0.2}, floor_at(1), next_mesh_id);
    ASSERT_FALSE(list.items.empty());
    EXPECT_GT(list.items.front().opacity, last) << height;
    last = list.items.front().opacity;
    double within = 1;
    for (const DrawItem& item : list.items) {
      EXPECT_LE(item.opacity, within) << "soft at its rim";
      within = item.opacity;
      EXPECT_FALSE(item.casts_shadow);
      for (const auto& x : item.mesh->positions) {
        EXPECT_NEAR(x.y(), 1, 0.003);
        EXPECT_LT((x - Eigen::Vector3f(0.1F, x.y(), 0.2F)).norm(), 0.0301F);
      }
    }
    const DrawLine& drop = list.lines.back();
    EXPECT_NEAR((drop.a - drop.b).norm(), height, 1e-9);
  }
  EXPECT_GT(last, 0.5);
  DrawList list;
  cues.add(list, {0, 0.5, 0}, floor_at(1), next_mesh_id);
  EXPECT_TRUE(list.items.empty() && list.lines.empty()) << "nothing lies below";
}

TEST(CornerAxes, LieLowerLeftAndTurnWithTheCamera) {
  DrawCamera camera;
  camera.pose.q = Quat(Eigen::AngleAxisd(1.5707963, Vec3::UnitY()));  // looks along −x
  DrawList list;
  add_corner_axes(list, std::nullopt, camera);
  ASSERT_EQ(list.lines.size(), 3u);
  for (const DrawLine& line : list.lines) {
    EXPECT_TRUE(line.overlay);
    EXPECT_LT(line.b.x(), -0.5);
    EXPECT_LT(line.b.y(), -0.5);
  }
  const Vec3 z = list.lines[2].b - list.lines[2].a;
  EXPECT_LT(z.x(), -0.05) << "looking along −x, +z is to the left";
  EXPECT_NEAR((list.lines[0].b - list.lines[0].a).norm(), 0, 1e-6) << "+x comes straight at the eye";
}

TEST(CornerAxes, OfAPatientSayWhichWayIsRightFrontAndHead) {
  const PatientFrame supine{{-2, 0, 0}, {0, 0, -1}};  // the face upwards
  EXPECT_NEAR((supine.front() - Vec3::UnitY()).norm(), 0, 1e-12);
  DrawCamera camera;  // looks along −z, from the feet to the head
  camera.pose.q = Quat(Eigen::AngleAxisd(-0.5, Vec3::UnitX()));
  DrawList list;
  add_corner_axes(list, supine, camera);
  std::map<std::string, Vec3> letters;
  for (const DrawText& text : list.texts) letters[text.text] = text.at;
  ASSERT_EQ(letters.size(), 6u);
  EXPECT_LT(letters["R"].x(), letters["L"].x() - 50)
      << "the patient's right is to the left of who stands at the feet";
  EXPECT_LT(letters["A"].y(), letters["P"].y() - 40) << "the front is up; a text's y is from above";
  EXPECT_LT(letters["S"].y(), letters["I"].y() - 20) << "the head is farther off: up in a view from above";
  EXPECT_NEAR((list.lines[0].b - list.lines[0].a).head<2>().y(), 0, 1e-9);

  DrawList from_the_feet;
  camera.pose.q = Quat::Identity();
  add_corner_axes(from_the_feet, supine, camera);
  EXPECT_EQ(from_the_feet.texts.size(), 4u) << "an axis that points at the eye has no letters";
}

TEST(Room, FacesInwards) {
  for (const DrawItem& item : room_items(1)) {
    EXPECT_FALSE(item.casts_shadow);
    const Eigen::Vector3f middle(0, 1.5F, 0);
    for (const auto& t : item.mesh->triangles) {
      const auto& p = item.mesh->positions;
      const Eigen::Vector3f normal = (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]);
      EXPECT_GT(normal.dot(middle - p[t[0]]), 0);
      EXPECT_GT(normal.dot(item.mesh->normals[t[0]]), 0);
    }
  }
}

Panel some_panel() {
  Panel panel;
  panel.participant = 3;
  panel.open = true;
  panel.pose = {{0.2, 1.2, -0.1}, Quat(Eigen::AngleAxisd(0.4, Vec3(0.1, 1, 0.2).normalized()))};
  panel.controls[5].position = 0.5;
  return panel;
}

TEST(PanelView, ShowsWhereControlsAreAndHowTheyStand) {
  PanelView view(1);
  SceneBody part;
  part.name = "kidney";
  part.description = "filters blood";
  const auto drawn = [&](const Panel& panel) {
    DrawList list;
    view.add(list, panel, part);
    return list;
  };
  const Panel rest = some_panel();
  const DrawList calm = drawn(rest);
  const auto has_text = [](const DrawList& list, const std::string& text) {
    return std::any_of(list.texts.begin(), list.texts.end(),
                       [&](const DrawText& t) { return t.text == text; });
  };
  EXPECT_TRUE(has_text(calm, "kidney"));
  EXPECT_TRUE(has_text(calm, "filters blood"));
  for (const DrawText& text : calm.texts) {
    ASSERT_TRUE(text.surface);
    const Vec3 at = rest.pose.inverse() * text.surface->p;
    EXPECT_LT(std::abs(at.x()), panel_width / 2) << text.text;
    EXPECT_LT(std::abs(at.y()), panel_height / 2) << text.text;
    EXPECT_GT(at.z(), 0);
  }
  for (std::size_t k = 0; k < panel_control_count; ++k) {
    Panel worked = rest;
    worked.controls[k].touched = true;
    worked.controls[k].position = 1;
    const DrawList list = drawn(worked);
    ASSERT_EQ(list.items.size(), calm.items.size());
    std::size_t changed = 0;
    for (std::size_t i = 0; i < list.items.size(); ++i) {
      if (list.items[i].appearance.color == calm.items[i].appearance.color) continue;
      ++changed;
      const Vec3& color = list.items[i].appearance.color;
      EXPECT_GT(color.y(), 2 * std::max(color.x(), color.z())) << "touched is green";
      const Vec3 moved = rest.pose.q.conjugate() * (list.items[i].pose.p - calm.items[i].pose.p);
      const ControlDesc& control = panel_controls[k];
      const Vec3 way = control_face(control, 1) - control_face(control, rest.controls[k].position);
      EXPECT_LT((moved - way).norm(), 1e-9) << control.label;
    }
    EXPECT_EQ(changed, 1u);
  }
}

// What is written lies on the board, in any script and of any length.
TEST(PanelView, WritingStaysOnTheBoard) {
  Typesetter typesetter;
  PanelView view(1);
  const Panel panel = some_panel();
  for (const test::Words& words : test::many_scripts)
    for (const int times : {1, 8}) {
      SceneBody part;
      for (int k = 0; k < times; ++k) {
        part.name.append(k == 0 ? "" : " ").append(words.name);
        part.description.append(k == 0 ? "" : " ").append(words.description);
      }
      DrawList list;
      view.add(list, panel, part);
      for (const DrawText& text : list.texts) {
        const SetText set = set_text(typesetter, text, 1);
        Vec3 at = panel.pose.inverse() * text.surface->p;
        if (text.centred) at += Vec3(-set.width() / 2, set.height() / 2, 0);
        EXPECT_GT(at.x(), -panel_width / 2) << words.script << ": " << text.text;
        EXPECT_LT(at.x() + set.width(), panel_width / 2) << words.script << ": " << text.text;
        EXPECT_LT(at.y(), panel_height / 2) << words.script << ": " << text.text;
        const bool control = text.text != part.name && text.text != part.description;
        EXPECT_GT(at.y() - set.height(), control ? -panel_height / 2 : panel_info.bottom - 1e-9)
            << words.script << ": " << text.text;
      }
    }
}

TEST(PanelView, ALongNameShrinksAndThenEndsWithAnEllipsis) {
  Typesetter typesetter;
  const auto name_on_panel = [&](const std::string& name) {
    SceneBody part;
    part.name = name;
    DrawList list;
    PanelView(1).add(list, some_panel(), part);
    return set_text(typesetter, list.texts[0], 1);
  };
  const SetText liver = name_on_panel("liver"),
                longer = name_on_panel("musculus pectoralis major, left side"),
                longest = name_on_panel(std::string(200, 'w'));
  EXPECT_EQ(liver.size, panel_name_height);
  EXPECT_LT(longer.size, panel_name_height);
  EXPECT_FALSE(longer.block->cut);
  EXPECT_LT(longest.size, longer.size);
  EXPECT_TRUE(longest.block->cut);
  EXPECT_TRUE(longest.block->lines[0].text.ends_with("…"));
}

TEST(Pick, EveryControlIsFoundThroughItsPixel) {
  const Panel panel = some_panel();
  const DrawCamera camera =
      mono_camera(look_at(panel.pose * Vec3(0.1, 0.15, 0.6), panel.pose.p), 0.8, 800, 600);
  const auto pixel = [&](const Vec3& in_panel) {
    const Vec3 seen = camera.pose.inverse() * (panel.pose * in_panel);
    return Eigen::Vector2d(
        (seen.x() / -seen.z() - camera.left) / (camera.right - camera.left) * camera.width,
        (camera.top - seen.y() / -seen.z()) / (camera.top - camera.bottom) * camera.height);
  };
  for (const ControlDesc& control : panel_controls) {
    const Vec3 face = control_face(control, 0);
    const auto at = pixel(face);
    const auto point = meet(ray_through(camera, at.x(), at.y()), panel);
    ASSERT_TRUE(point) << control.label;
    ASSERT_TRUE(point->control) << control.label;
    EXPECT_EQ(*point->control, control.control);
    EXPECT_LT((point->at - face).norm(), 1e-6);
  }
  for (const double position : {0.0, 0.3, 1.0}) {
    const auto at = pixel(control_face(describe(PanelControl::stiffness), position));
    EXPECT_NEAR(slider_position(meet(ray_through(camera, at.x(), at.y()), panel)->at), position, 1e-6);
  }
  const auto beside = pixel({panel_width, 0, 0}), info = pixel({0, panel_info.top - 0.01, 0});
  EXPECT_FALSE(meet(ray_through(camera, beside.x(), beside.y()), panel));
  ASSERT_TRUE(meet(ray_through(camera, info.x(), info.y()), panel));
  EXPECT_FALSE(meet(ray_through(camera, info.x(), info.y()), panel)->control);
  EXPECT_FALSE(meet(Ray{panel.pose * Vec3(0, 0, -1), panel.pose.q * Vec3::UnitZ()}, panel)) << "from behind";
}

TEST(SurfaceTree, MeetsTheFrontOfAnItem) {
  PartDesc ball;
  ball.shape = "sphere";
  ball.size = Vec3::Constant(0.2);
  DrawItem item{
      .mesh = rigid_mesh(mesh_of(ball), 1), .pose = {{0.5, 0, 0}, Quat::Identity()}, .appearance = {}};
  SurfaceTrees trees;
  const auto distance = [&](const Ray& ray) {
    const auto point = trees.meet(ray, item);
    return point ? point->distance : -1;
  };
  EXPECT_NEAR(distance({{0.5, 0, 1}, -Vec3::UnitZ()}), 0.9, 1e-3);
  EXPECT_EQ(distance({{0.61, 0, 1}, -Vec3::UnitZ()}), -1);
  item.shape.A = Vec3(2, 1, 3).asDiagonal();
  EXPECT_NEAR(distance({{1, 0, 1}, -Vec3::UnitZ()}), 0.7, 3e-3);
  EXPECT_GT(distance({{1.15, 0, 1}, -Vec3::UnitZ()}), 0);
  const auto point = trees.meet({{1.1, 0, 1}, -Vec3::UnitZ()}, item);
  ASSERT_TRUE(point);
  EXPECT_GT(point->normal.dot(Vec3(0.1 / 4, 0, point->at.z() / 9).normalized()), 0.97) << "an ellipsoid's";
  item.shape.A = Vec3(-2, 1, 3).asDiagonal();
  EXPECT_NEAR(distance({{-1, 0, 1}, -Vec3::UnitZ()}), 0.7, 3e-3) << "mirrored";
}

TEST(SurfaceTree, FindsWhatTryingEveryTriangleFindsAlsoAfterTheMeshMoved) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> anywhere(-0.3, 0.3);
  PartDesc solid;
  solid.shape = "sphere";
  solid.size = Vec3(0.3, 0.2, 0.25);
  const auto mesh = rigid_mesh(mesh_of(solid), 1);
  DrawItem item{.mesh = mesh, .pose = {}, .appearance = {}};
  SurfaceTrees trees;
  int met = 0;
  for (int round = 0; round < 4; ++round) {
    for (int k = 0; k < 300; ++k) {
      const Vec3 from(anywhere(random), anywhere(random), 1);
      const Ray ray{from, (Vec3(anywhere(random), anywhere(random), 0) - from).normalized()};
      std::optional<double> expected;
      for (const auto& t : mesh->triangles)
        if (const auto d = meet(ray, mesh->positions[t[0]].cast<double>(),
                                mesh->positions[t[1]].cast<double>(), mesh->positions[t[2]].cast<double>());
            d && (!expected || *d < *expected))
          expected = d;
      const auto point = trees.meet(ray, item);
      ASSERT_EQ(point.has_value(), expected.has_value());
      if (!point) continue;
      ++met;
      ASSERT_NEAR(point->distance, *expected, 1e-9);
    }
    for (auto& x : mesh->positions) x += 0.05F * Eigen::Vector3f::Random();
    ++mesh->positions_revision;
    if (round == 2) {  // cut: half of it is gone
      mesh->triangles.resize(mesh->triangles.size() / 2);
      ++mesh->revision;
    }
  }
  EXPECT_GT(met, 300);
}

TEST(Wireframe, OfABoxHasItsTwelveEdges) {
  const TriangleMesh box = mesh_of(PartDesc{});
  EXPECT_EQ(visible_edges(box).size(), 12u);
  EXPECT_EQ(all_edges(box.triangles).size(), 18u) << "with the faces' diagonals";
}

/// A lamp that carries a spot light, above a ball that may move.
SceneDesc lamp_and_ball() {
  SceneDesc scene;
  RigidDesc lamp, ball;
  lamp.name = "lamp";
  lamp.fixed = true;
  lamp.pose = {{0.3, 2, -0.4}, Quat(Eigen::AngleAxisd(0.5, Vec3::UnitX()))};
  lamp.geometry.parts.resize(1);
  ball.name = "ball";
  ball.pose.p = {0.1, 0.9, 0.2};
  ball.geometry.parts.resize(1);
  ball.geometry.parts[0].shape = "sphere";
  ball.geometry.parts[0].size = Vec3::Constant(0.2);
  scene.rigid = {lamp, ball};
  LightDesc carried, fixed;
  carried.kind = fixed.kind = LightKind::spot;
  carried.carrier = "lamp";
  carried.position = fixed.position = {0, -0.1, 0};
  scene.lights = {carried, fixed};
  return scene;
}

TEST(StillScene, LightsAreWhereTheirCarriersAre) {
  const SceneDesc scene = lamp_and_ball();
  const DrawList list = still_scene(scene, {}, [](const std::string&) {});
  ASSERT_EQ(list.lights.size(), 2u);
  const Pose& lamp = scene.rigid[0].pose;
  EXPECT_LT((list.lights[0].position - lamp * Vec3(0, -0.1, 0)).norm(), 1e-12);
  EXPECT_LT((list.lights[0].direction - lamp.q * Vec3(0, -1, 0)).norm(), 1e-12);
  EXPECT_EQ(list.lights[1].position, Vec3(0, -0.1, 0)) << "nobody carries it";
}

TEST(SceneTour, EveryStopLooksAtWhatMoves) {
  const SceneDesc scene = lamp_and_ball();
  const DrawList list = still_scene(scene, {}, [](const std::string&) {});
  const Subject subject = subject_of(scene, list);
  EXPECT_LT((subject.middle - Vec3(0.1, 0.9, 0.2)).norm(), 1e-3) << "the lamp is fixed";
  std::set<std::string> names;
  for (const TourStop& stop : tour_of(scene, list, 64, 48)) {
    names.insert(stop.name);
    if (stop.name == "scene") continue;
    ASSERT_EQ(stop.list.cameras.size(), 1u);
    const DrawCamera& camera = stop.list.cameras[0];
    const Vec3 seen = camera.pose.inverse() * subject.middle;
    EXPECT_LT(seen.z(), -camera.near) << stop.name;
    EXPECT_LT(std::abs(seen.x() / seen.z()), camera.right) << stop.name;
    EXPECT_LT(std::abs(seen.y() / seen.z()), camera.top) << stop.name;
  }
  EXPECT_EQ(names, (std::set<std::string>{"scene", "left", "right", "above", "close", "hands"}));
}

TEST(ContactOverlay, TellsEveryFigureAtTheLeft) {
  DrawList list;
  list.cameras.resize(1);
  ContactSample contact;
  contact.depth = 0.00234;
  contact.point = {0.1, 1.25, -0.3};
  contact.normal = {0, 0.8, 0.6};
  contact.impulse = 0.025;
  contact.force = {0, -3, 4};
  const std::string text = contact_figures(contact, "liver");
  for (const char* figure : {"liver", "2.34 mm", "0.100 1.250 -0.300", "0.00 0.80 0.60", "0.0250 N s",
                             "5.00 N", "0.00 -0.60 0.80"})
    EXPECT_NE(text.find(figure), std::string::npos) << figure << " in\n" << text;
  EXPECT_EQ(text.find("within"), std::string::npos) << "how far the force may be off isn't known";
  EXPECT_NE(contact_figures(contact, "liver", 0.06).find("\nwithin\t6 %"), std::string::npos);
  add_contact_overlay(list, contact, "liver");
  ASSERT_EQ(list.texts.size(), 1u);
  const DrawText& figures = list.texts[0];
  EXPECT_EQ(figures.text, text);
  EXPECT_EQ(figures.ground, TextGround::framed);
  EXPECT_GT(figures.color.y(), 2 * figures.color.x()) << "green";
  Typesetter typesetter;
  const SetText set = set_text(typesetter, figures, list.scale);
  constexpr double axes = 114;  // points that they reach up from the lower border
  EXPECT_LT(figures.at.x() + set.width(), 0.33 * list.cameras[0].width) << "left of the scene's middle";
  EXPECT_GT(figures.at.y(), 0.5 * list.cameras[0].height);
  EXPECT_LT(figures.at.y() + set.height(), list.cameras[0].height - axes);
}

}  // namespace
}  // namespace prosector
