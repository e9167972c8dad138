// What people see of what the server tells, from message to picture.

#include "client/view/scene_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <thread>

#include "client/render/projection.h"
#include "client/view/camera.h"
#include "common/asset.h"
#include "common/panel.h"
#include "common/surface_patch.h"
#include "tests/client/told_client.h"

namespace prosector {
namespace {

using namespace test;

TEST(SceneView, TheLampsLightGoesAlongWithIt) {
  Client client;
  client.scene.bodies.pop_back();
  LightInfo light;
  light.kind = LightKind::spot;
  light.body = lamp_body;
  light.position = {0, -0.03, 0};
  light.cone = 0.18;  // a circle of 0.17 m on the table
  light.intensity = 2;
  client.scene.lights = {light};
  client.scene.bodies[0].appearance.color = Vec3::Constant(0.12);  // the room's own light shows little on it
  client.join();
  const ViewSettings settings = plain(320, 240);
  const DrawCamera camera = client.list(1, settings).cameras.front();
  const Image before = client.picture(1, settings);
  RigidState moved;
  moved.body = lamp_body;
  moved.time = {0, 10};
  moved.pose.p = {0.25, 2, 0};
  client.tell(moved);
  const Image after = client.picture(10, settings);
  const Vec3 left(-0.25, 1, 0), right(0.25, 1, 0), aside(0, 1, 0.3);
  const auto at = [&](const Image& image, const Vec3& point) { return brightness(image, camera, point); };
  EXPECT_GT(at(before, left), 1.8 * at(before, right));  // as coded for the eye: over 3 times as much light
  EXPECT_GT(at(after, right), 1.8 * at(after, left));
  EXPECT_NEAR(at(after, right), at(before, left), 0.1 * at(before, left));
  EXPECT_NEAR(at(after, left), at(before, right), 0.1 * at(before, left));
  EXPECT_NEAR(at(after, aside), at(before, aside), 1) << "where it shone neither before nor after";
  // Corotated, it shines where it points to.
  moved.time = {0, 20};
  moved.pose.q = Quat(Eigen::AngleAxisd(-std::atan(0.5 / 0.97), Vec3::UnitZ()));
  client.tell(moved);
  EXPECT_GT(at(client.picture(20, settings), left), 1.8 * at(after, left));
}

/// Of all pixels, the least by which red exceeds green.
int least_redness(const Image& image) {
  int least = 255;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      least = std::min(least, image.pixel(x, y)[0] - image.pixel(x, y)[1]);
  return least;
}

// A hole (a face that is culled, or cut off by the near plane) would show the room, which is grey.
TEST(SceneView, AHeadInsideAPartSeesNothingButItsInside) {
  constexpr double scale = 6, radius = 0.1 * scale;
  const Vec3 middle(0, 1.2, -1.2);  // so that nothing else is in it
  for (const Surface surface : {Surface::tissue})
    for (const double opacity : {1.0, 0.6})
      for (const double mirror : {1.0, -1.0}) {
        Client client;
        client.scene.bodies[part_body].part = true;
        client.scene.bodies[part_body].pose.p = middle;
        client.scene.bodies[part_body].appearance = {{0.8, 0.1, 0.1}, 0.6, 0, surface};
        LightInfo light;
        light.position = middle;
        light.intensity = 0.5;
        client.scene.lights = {light};
        client.join();
        ViewSettings settings = plain(64, 64);
        settings.eye = look_at(middle, middle + Vec3::UnitX());
        EXPECT_LT(least_redness(client.picture(1, settings)), 10) << "not yet inspected: seen through";
        PartState state;
        state.body = part_body;
        state.inspected = true;
        state.opacity = opacity;
        state.shape.A = scale * Vec3(mirror, 1, 1).asDiagonal().toDenseMatrix();
        state.shape.p = middle - state.shape.A * middle;
        client.tell(state);
        // In the middle, and with the eyes as near its wall as those of a head whose temple touches it.
        for (const double from_wall : {radius, 0.05})
          for (const Vec3& ahead : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0),
                                    Vec3(0, 0, 1), Vec3(0, 0, -1)}) {
            const Vec3 eye = middle + (radius - from_wall) * Vec3(1, 0.3, 0.2).normalized();
            settings.eye = look_at(eye, eye + ahead);
            EXPECT_GT(least_redness(client.picture(1, settings)), 10)
                << "opacity " << opacity << ", " << from_wall << " m from the wall, towards "
                << ahead.transpose();
          }
      }
}

TEST(SceneView, AnInsetShowsWhatAUserSeesAndNothingElseChanges) {
  Client client;
  LightInfo light;
  light.position = {0, 2, 1};
  client.scene.lights = {light};
  client.join();
  const RosterEntry ada = ada_entry();
  client.tell(ada);
  UserState user;
  user.participant = ada.participant;
  user.head_tracked = true;
  user.head = look_at({0, 1.5, 0.1}, {0, 1.1, 0});  // the part from close by
  client.tell(user);
  ViewSettings settings = plain(320, 240);
  const auto is_named = [](const DrawText& text) { return text.text == "ada"; };
  while (std::ranges::none_of(client.list(1, settings).texts, is_named))  // her figure is on its way
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  const Image without = client.picture(1, settings);
  settings.insets = {"ada", "nobody"};
  const Image with = client.picture(1, settings);
  const DrawList& list = client.list(1, settings);
  ASSERT_EQ(list.cameras.size(), 2u);
  const DrawCamera& inset = list.cameras[1];
  EXPECT_TRUE(inset.inset);
  EXPECT_LT((inset.pose.p - user.head.p).norm(), 1e-6);
  EXPECT_TRUE(std::any_of(list.texts.begin(), list.texts.end(),
                          [](const DrawText& text) { return text.text == "nobody is not in the session"; }));
  int inside = 0, outside = 0;
  for (int y = 0; y < with.height; ++y)
    for (int x = 0; x < with.width; ++x) {
      const bool same = std::abs(luminance(with.pixel(x, y)) - luminance(without.pixel(x, y))) < 8;
      const int up = with.height - 1 - y;
      const bool in =
          x >= inset.x && x < inset.x + inset.width && up >= inset.y && up < inset.y + inset.height;
      // Names are written at the right. Edges that end at the inset are blended up to their search's reach.
      constexpr int reach = 16;  // pixels, shaders/edges.frag
      if (!same && x < inset.x - reach) ++outside;
      if (!same && in) ++inside;
    }
  EXPECT_EQ(outside, 0);
  EXPECT_GT(inside, inset.width * inset.height / 4);
}

// They stand above it, as the server last told, and go with --no-overlay.
TEST(SceneView, FiguresStandAboveTheSoftBodyThatAsksForThem) {
  Client client;
  const BodyId body = client.add_soft("membrane");
  client.scene.bodies[part_body].show_figures = true;  // rigid: has none
  client.join();
  ViewSettings settings = plain(320, 240);
  settings.overlay = true;
  const auto figures = [&] {
    std::vector<DrawText> out;
    for (const DrawText& text : client.list(1, settings).texts)
      if (text.text.find(" ms") != std::string::npos && !text.overlay) out.push_back(text);
    return out;
  };
  EXPECT_TRUE(figures().empty()) << "nothing was told yet";
  BodyStatus status;
  status.body = body;
  status.substeps = 12;
  status.step = 1.39e-3;
  client.tell(status);
  ASSERT_EQ(figures().size(), 1u);
  EXPECT_EQ(figures()[0].text, "membrane\n12 steps of 1.39 ms");
  EXPECT_NEAR(figures()[0].at.x(), 0.1, 1e-6);
  // In the picture, which is seen from above, they hide nothing of the body.
  const DrawCamera camera = client.list(1, settings).cameras.front();
  const auto height = [&](const Vec3& at) {
    const Eigen::Vector4d clip = view_projection_of(camera) * at.homogeneous();
    return clip.y() / clip.w();
  };
  for (const double x : {0.0, 0.2})
    for (const double y : {1.1, 1.3}) EXPECT_GT(height(figures()[0].at), height({x, y, 0}));
  EXPECT_LT((figures()[0].at - Vec3(0.1, 1.3, 0)).norm(), 0.1);
  status.error = 0.031;
  status.press_error = 0.06;
  client.tell(status);
  EXPECT_EQ(figures()[0].text, "membrane\n12 steps of 1.39 ms\nerror 3.1 %\npressed: force within 6 %");
  status.asleep = true;
  client.tell(status);
  ASSERT_EQ(figures().size(), 1u);
  EXPECT_NE(figures()[0].text.find("at rest"), std::string::npos);
  settings.overlay = false;
  EXPECT_TRUE(figures().empty());
}

TEST(SceneView, StrainColoursReachAsFarAsTheStrainsAndTheLegendSaysHowFar) {
  for (const auto& [stretch, end] : {std::pair(1.015F, "2 or more"), {1.15F, "20 or more"}}) {
    Client client;
    client.add_soft("membrane", stretch);
    client.join();
    ViewSettings settings = plain(320, 240);
    settings.shown = Shown::strain;
    const DrawList& list = client.list(1, settings);
    EXPECT_TRUE(std::ranges::any_of(list.texts, [&](const DrawText& text) { return text.text == end; }))
        << end;
    const auto painted = std::ranges::find(list.items, true, &DrawItem::painted);
    ASSERT_NE(painted, list.items.end());
    EXPECT_LT((painted->mesh->rest_positions[0].cast<double>() - value_color({"", "", 0, 1}, 0.75)).norm(),
              0.01)
        << "three quarters of the scale";
  }
}

// Of a desk user, whose eyes the scene's camera's field of view is known of.
TEST(SceneView, ThroughAUsersEyesIsSeenWhatTheySee) {
  Client client;
  client.join();
  RosterEntry ada = ada_entry();
  client.tell(ada);
  UserState user;
  user.participant = ada.participant;
  user.head_tracked = true;
  user.head = look_at({0.4, 1.5, 0.3}, {0, 1.1, 0});
  client.tell(user);
  ViewSettings settings = plain(320, 240);
  settings.follow = "ada";
  const DrawCamera desk = client.list(1, settings).cameras.front();
  EXPECT_LT((desk.pose.p - user.head.p).norm(), 1e-6);
  EXPECT_NEAR(desk.top, std::tan(client.scene.camera.fov / 2), 1e-9);
  ada.devices = "fastrak";
  client.tell(ada);
  EXPECT_GT(client.list(1, settings).cameras.front().top, desk.top) << "not known: wide enough for the hands";
}

/// Returns where hands are drawn (their mesh has as many vertices as a skin), and how opaque.
struct Columns {
  int first = 1 << 20, last = -1;
};

/// Where two pictures differ, in columns of each half.
std::array<Columns, 2> difference(const Image& a, const Image& b) {
  std::array<Columns, 2> out;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x) {
      if (std::abs(luminance(a.pixel(x, y)) - luminance(b.pixel(x, y))) < 8) continue;
      Columns& eye = out[static_cast<std::size_t>(2 * x / a.width)];
      eye.first = std::min(eye.first, x % (a.width / 2));
      eye.last = std::max(eye.last, x % (a.width / 2));
    }
  return out;
}

// Its rims lie e·(1/Z − 1/D) apart in tangents: crossed before the distance of convergence, uncrossed beyond.
TEST(SceneView, AViewersChoiceChangesWhatThatViewerSeesAndPointsAt) {
  Client client;
  client.scene.bodies[part_body].part = true;
  client.join();
  ViewSettings settings = plain(400, 300);
  const std::size_t all = client.list(1, settings).items.size();
  const Ray down{{0, 1.9, 0}, -Vec3::UnitY()};
  const auto pointed = [&] { return client.view().surface_at(down)->body; };
  EXPECT_EQ(pointed(), part_body);
  const auto item_of_part = [&]() -> const DrawItem& {
    const auto& items = client.list(1, settings).items;
    return *std::ranges::find_if(items, [](const DrawItem& item) { return item.pose.p == Vec3(0, 1.2, 0); });
  };

  settings.parts.obey({.kind = PartsOrder::Kind::color, .parts = {"part"}, .color = Vec3(0, 0, 1)});
  settings.parts.obey({.kind = PartsOrder::Kind::opacity, .parts = {"part"}, .opacity = 0.4});
  EXPECT_EQ(item_of_part().appearance.color, Vec3(0, 0, 1));
  EXPECT_EQ(item_of_part().opacity, 0.4);
  EXPECT_FALSE(item_of_part().casts_shadow);
  PartState shared;
  shared.body = part_body;
  shared.opacity = 0.5;
  client.tell(shared);
  EXPECT_EQ(item_of_part().opacity, 0.2) << "what everybody sees counts, too";

  settings.parts.obey({.kind = PartsOrder::Kind::hide, .parts = {"part"}});
  EXPECT_EQ(client.list(1, settings).items.size(), all - 1);
  EXPECT_EQ(pointed(), 0u) << "the table behind it";
  settings.parts.obey({.kind = PartsOrder::Kind::reset_all});
  EXPECT_EQ(client.list(1, settings).items.size(), all);

  settings.highlighted = {part_body};
  EXPECT_GT(item_of_part().brightness, 1);
}

TEST(SceneView, APhantomAndNothingElseIsLeftToTheCamerasPicture) {
  Client client;
  client.join();
  ViewSettings settings = plain(400, 300);
  CameraOverlay& through = settings.projection.emplace<CameraOverlay>();
  through.is_placed = true;
  through.room_board.p = {0, 3, 0};  // above everything: no body is its table
  through.camera.width = 400;
  through.camera.height = 300;
  const auto real = [&] {
    std::vector<Vec3> out;
    for (const DrawItem& item : client.list(1, settings).items)
      if (item.showing == ItemRole::real) {
        out.push_back(item.pose.p);
        EXPECT_TRUE(item.casts_shadow) << "it shades organs";
      }
    return out;
  };
  EXPECT_TRUE(real().empty());
  through.phantoms = {"part", "nobody"};
  EXPECT_EQ(real(), std::vector<Vec3>{Vec3(0, 1.2, 0)});
  through.phantoms = {};
  FoundPhantom& found = through.found.emplace();
  found.body = "part";
  EXPECT_EQ(real(), std::vector<Vec3>{Vec3(0, 1.2, 0)}) << "its board wasn't seen yet";
  found.place.emplace().p = {0.3, 1, 0};
  EXPECT_EQ(real(), std::vector<Vec3>{found.place->p});
}

TEST(SceneView, APhantomOfAShapeOfItsOwnHidesWhatIsVirtual) {
  Client client;
  client.join();
  ViewSettings settings = plain(320, 240);
  CameraOverlay& through = settings.projection.emplace<CameraOverlay>();
  through.is_placed = true;
  through.camera = mono_camera(look_at({0, 1.5, 0.6}, {0, 1.2, 0}), 0.8, 320, 240);
  through.room_board = {{0, 1, 0}, Quat(Eigen::AngleAxisd(-std::numbers::pi / 2, Vec3::UnitX()))};
  through.backdrop = {
      std::make_shared<const Image>(Image{320, 240, std::vector<std::uint8_t>(3 * 320 * 240, 255)}), 1, 0, 0,
      1};
  FoundPhantom& found = through.found.emplace();
  found.shape = std::make_shared<const TriangleMesh>(mesh_of(solid("box", {0.3, 0.3, 0.02})));
  const DrawCamera& camera = through.camera;
  const auto seen = [&] { return brightness(client.picture(1, settings), camera, {0, 1.2, 0}); };
  EXPECT_LT(seen(), 200) << "the part: nobody knows where the phantom is";
  found.place = Pose{{0, 1.3, 0.2}, camera.pose.q};
  EXPECT_GT(seen(), 250) << "the camera's white";
  found.place->p = {0, 1.0, -0.4};
  EXPECT_LT(seen(), 200) << "the part before the phantom";
}

TEST(SceneView, NamesStandBesideThePartsWhenTheViewerAsksForThem) {
  Client client;
  client.scene.bodies[part_body].part = true;
  client.join();
  ViewSettings settings = plain(400, 300);
  EXPECT_TRUE(client.list(1, settings).texts.empty());
  settings.parts.obey({.kind = PartsOrder::Kind::labels});
  const DrawList& list = client.list(1, settings);
  ASSERT_EQ(list.texts.size(), 1u) << "the table is no part, the lamp is not in the picture";
  EXPECT_EQ(list.texts[0].text, "part");
  EXPECT_FALSE(list.lines.empty());
}

TEST(SceneView, BothEyesSeeThePanelWithTheDisparityOfItsDistance) {
  StereoProfile profile;
  Client client;
  LightInfo light;
  light.position = {0, 2, 1};
  client.scene.lights = {light};
  client.join();
  LocalUser self;
  self.participant = 7;
  self.present = true;
  self.input.head_tracked = true;
  self.input.head = look_at({0, 1.6, 0.8}, {0, 1.6, 0});
  ViewSettings settings = plain(profile.picture_width(), profile.picture_height());
  settings.projection = profile;
  for (const double depth : {0.5, 0.6, 0.9}) {
    Panel panel;
    panel.participant = self.participant;
    panel.body = part_body;
    panel.pose = {self.input.head * Vec3(0, 0, -depth), self.input.head.q};
    client.tell(panel);
    const Image without = client.picture(1, settings, self);
    panel.open = true;
    client.tell(panel);
    const Image with = client.picture(1, settings, self);
    const auto [left, right] = difference(without, with);
    const double pixels =
        profile.eye_width / (2 * std::tan(profile.fov_horizontal / 2));  // of a tangent of 1
    const double expected = profile.eye_distance * (1 / depth - 1 / profile.convergence) * pixels;
    // Each rim falls on whole pixels, and may be one off by how it stands out from what is behind.
    EXPECT_NEAR(left.first - right.first, expected, 2) << depth;
    EXPECT_NEAR(left.last - right.last, expected, 2) << depth;
    for (const Columns& eye : {left, right})
      EXPECT_NEAR(eye.last - eye.first, panel_width / depth * pixels, 0.03 * panel_width / depth * pixels);
  }
}

}  // namespace
}  // namespace prosector
