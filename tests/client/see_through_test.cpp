// Pictures of a camera below the scene: where things fall, what hides and shades what, how bright things are.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>

#include "client/ar/camera_sight.h"
#include "client/ar/camera_view.h"
#include "client/ar/paper_light.h"
#include "client/render/projection.h"
#include "client/view/camera.h"
#include "client/view/room.h"
#include "client/view/see_through.h"
#include "common/clock.h"
#include "common/error.h"
#include "drivers/camera/base/camera_frames.h"
#include "drivers/camera/base/undistorter.h"
#include "drivers/camera/tags/standard_boards.h"
#include "picture.h"
#include "tests/folders.h"
#include "tests/random.h"
#include "twins/camera/synthetic_scene.h"

namespace prosector {
namespace {

constexpr int width = 160, height = 120;

/// A picture of one colour.
Image plain_image(int across, int down, const std::array<std::uint8_t, 3>& rgb) {
  Image out{across, down, {}};
  for (int k = 0; k < across * down; ++k) out.rgb.insert(out.rgb.end(), rgb.begin(), rgb.end());
  return out;
}

DrawBackdrop backdrop_of(Image image, double step = 1) {
  return {std::make_shared<const Image>(std::move(image)), 1, 0, 0, step};
}

/// A lamp above a table that a camera looks down at.
DrawList table_list() {
  DrawList out;
  out.cameras = {mono_camera(look_at({0, 1.3, 0.4}, {0, 0.9, 0}), 0.8, width, height)};
  out.lights = {test::lamp({0, 1.9, 0.05}, {0, 0.9, 0})};
  out.items = {table_plane({{0, 0.9, 0}, Quat(Eigen::AngleAxisd(-std::numbers::pi / 2, Vec3::UnitX()))}, 1)};
  out.backdrop = backdrop_of(plain_image(width, height, {90, 140, 200}));
  return out;
}

DrawItem ball_at(const Vec3& place, double radius = 0.03) {
  DrawItem out{.mesh = test::sphere_mesh(radius, 2), .pose = {}, .appearance = {}};
  out.pose.p = place;
  out.appearance.color = {0.9, 0.02, 0.02};
  out.appearance.roughness = 1;
  return out;
}

/// Returns the pixel of a place, from the upper left.
Eigen::Vector2i pixel_of(const DrawCamera& camera, const Vec3& place) {
  const Eigen::Vector4d clip = view_projection_of(camera) * place.homogeneous();
  return {static_cast<int>((clip.x() / clip.w() + 1) / 2 * camera.width),
          static_cast<int>((1 - clip.y() / clip.w()) / 2 * camera.height)};
}

const std::uint8_t* seen(const Image& image, const DrawCamera& camera, const Vec3& place) {
  const Eigen::Vector2i at = pixel_of(camera, place);
  return image.pixel(at.x(), at.y());
}

TEST(CameraView, PutsEveryPointWhereTheStraightPictureHasIt) {
  Random random(7);
  for (int trial = 0; trial < 200; ++trial) {
    Lens bent;
    bent.width = 100 + static_cast<int>(random.uniform(0, 1200));
    bent.height = 100 + static_cast<int>(random.uniform(0, 900));
    bent.fx = bent.width * random.uniform(0.6, 2);
    bent.fy = bent.fx * random.uniform(0.95, 1.05);
    bent.cx = bent.width * random.uniform(0.4, 0.6);
    bent.cy = bent.height * random.uniform(0.4, 0.6);
    Lens straight = bent;
    straight.width += 80;
    straight.height += 60;
    straight.cx += random.uniform(0, 80);
    straight.cy += random.uniform(0, 60);
    const int across = 50 + static_cast<int>(random.uniform(0, 1500));
    const int down = 50 + static_cast<int>(random.uniform(0, 1000));
    const CameraView view = view_of(bent, straight, across, down);
    EXPECT_EQ(view.camera.width, across);
    for (int k = 0; k < 20; ++k) {
      const Vec3 place(random.uniform(-1, 1), random.uniform(-1, 1), -random.uniform(0.3, 3));
      const Eigen::Vector4d clip = projection_of(view.camera) * place.homogeneous();
      const Vec2 ours((clip.x() / clip.w() + 1) / 2 * across, (1 - clip.y() / clip.w()) / 2 * down);
      const Vec2 theirs = straight.project(device_camera * place) + Vec2(0.5, 0.5);  // from its border
      EXPECT_LT((Vec2(view.left, view.top) + view.step * ours - theirs).norm(), 1e-8 * (1 + theirs.norm()));
    }
  }
}

TEST(CameraView, ShowsTheLensOwnFrameWhole) {
  Lens lens;
  for (const auto& [across, down] : {std::pair{640, 480}, {800, 600}, {1280, 720}, {300, 900}}) {
    const CameraView view = view_of(lens, lens, across, down);
    EXPECT_LE(view.left, 1e-9);
    EXPECT_LE(view.top, 1e-9);
    EXPECT_NEAR(std::max(view.left, view.top), 0, 1e-9);  // and as large as it can be
    EXPECT_NEAR(view.left + view.step * across, lens.width - view.left, 1e-9);
    EXPECT_NEAR(view.top + view.step * down, lens.height - view.top, 1e-9);
  }
}

TEST(Backdrop, IsShownPixelByPixelTheRightWayUp) {
  Image image = plain_image(width, height, {0, 0, 0});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::uint8_t* rgb = image.rgb.data() + 3 * (y * width + x);
      rgb[0] = static_cast<std::uint8_t>(x);
      rgb[1] = static_cast<std::uint8_t>(2 * y);
    }
  DrawList list;
  list.cameras = {mono_camera({}, 0.8, width, height)};
  list.backdrop = backdrop_of(image);
  EXPECT_EQ(test::picture_of(list, width, height).rgb, image.rgb);
}

TEST(Backdrop, LeavesWhatItDoesNotReach) {
  DrawList list;
  list.background = Vec3::Zero();
  list.cameras = {mono_camera({}, 0.8, width, height)};
  list.backdrop = backdrop_of(plain_image(40, 30, {200, 200, 200}));
  list.backdrop->left = -20;
  const Image picture = test::picture_of(list, width, height);
  EXPECT_EQ(picture.pixel(10, 10)[0], 0);
  EXPECT_EQ(picture.pixel(40, 10)[0], 200);
  EXPECT_EQ(picture.pixel(40, 40)[0], 0);
}

TEST(RealThings, ShowTheCamerasPictureWhereNoShadowFalls) {
  const DrawList list = table_list();
  const Image picture = test::picture_of(list, width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(picture.pixel(x, y)[c], (std::array{90, 140, 200}[c]), 1);
}

TEST(RealThings, HideWhatIsBehindThem) {
  DrawList list = table_list();
  const Vec3 above(0, 0.96, 0), below(0, 0.8, 0);
  list.items.push_back(ball_at(above));
  const DrawCamera& camera = list.cameras[0];
  const std::uint8_t* free = nullptr;
  const Image with_ball = test::picture_of(list, width, height);
  free = seen(with_ball, camera, above);
  EXPECT_GT(free[0], free[2]);  // it is red
  list.items.back().pose.p = below;
  const Image sunken = test::picture_of(list, width, height);
  EXPECT_LT(seen(sunken, camera, below)[0], seen(sunken, camera, below)[2]);  // the table's blue
  // A real ball before it.
  list.items.back().pose.p = above;
  DrawItem hand = ball_at(above + 0.3 * (camera.pose.p - above));
  hand.mesh = test::sphere_mesh(0.05, 3);
  hand.showing = ItemRole::real;
  hand.casts_shadow = false;
  list.items.push_back(hand);
  const Image hidden = test::picture_of(list, width, height);
  EXPECT_LT(seen(hidden, camera, above)[0], seen(hidden, camera, above)[2]);
}

TEST(RealThings, TakeShadowsInTheMeasureOfTheLampsShare) {
  DrawList list = table_list();
  list.ambient = Vec3::Zero();
  const DrawCamera camera = list.cameras[0];
  const Vec3 place(-0.1, 0.9, 0);
  list.items.push_back(ball_at(place + 0.12 * (list.lights[0].position - place), 0.04));
  const Image dark =
      test::picture_of(list, width, height, make_offscreen_context,
                       {.effects = every_effect & ~EffectSet(1u << index_of(Effect::ambient_occlusion))});
  for (int c = 0; c < 3; ++c)
    EXPECT_LT(seen(dark, camera, place)[c],
              100 * list.backdrop->image->rgb[static_cast<std::size_t>(c)] / 200);
  // Two lamps at one place: a shadow of the first leaves half of the light.
  list.lights.push_back(list.lights[0]);
  const Image half =
      test::picture_of(list, width, height, make_offscreen_context,
                       {.effects = every_effect & ~EffectSet(1u << index_of(Effect::ambient_occlusion))});
  const double expected = std::pow(0.5, 1 / 2.2);
  for (int c = 0; c < 3; ++c)
    EXPECT_NEAR(seen(half, camera, place)[c],
                expected * list.backdrop->image->rgb[static_cast<std::size_t>(c)], 8);
}

/// A real ball below the lamp: its shadow on the table is in the camera's picture already.
TEST(RealThings, ShadeWhatIsVirtualAlone) {
  DrawList list = table_list();
  list.ambient = Vec3::Constant(0.01);
  const DrawCamera camera = list.cameras[0];
  const Vec3 lamp = list.lights[0].position, on_ball(-0.1, 0.96, 0), on_table(0.12, 0.9, 0.05);
  list.items.push_back(ball_at(on_ball - Vec3(0, 0.05, 0), 0.05));
  const Image lit = test::picture_of(list, width, height);
  for (const Vec3& place : {on_ball, on_table}) {
    list.items.push_back(ball_at(place + 0.3 * (lamp - place), 0.03));
    list.items.back().showing = ItemRole::real;
  }
  const Image shaded = test::picture_of(list, width, height);
  EXPECT_GT(seen(lit, camera, on_ball)[0], 60);
  EXPECT_LT(seen(shaded, camera, on_ball)[0], seen(lit, camera, on_ball)[0] / 2);
  EXPECT_NEAR(seen(shaded, camera, on_table)[2], list.backdrop->image->rgb[2], 1);
}

TEST(Around, IsNotDrawn) {
  DrawList list = table_list();
  list.items.push_back(ball_at({0, 0.96, 0}));
  list.items.back().showing = ItemRole::around;
  list.items.back().casts_shadow = false;
  const Image picture = test::picture_of(list, width, height);
  EXPECT_EQ(picture.pixel(80, 60)[2], 200);
}

TEST(Phantoms, ThatTheSceneDoesntHaveAreToldWithThoseThatItHas) {
  SceneInfo scene;
  scene.name = "abdomen";
  scene.bodies.resize(2);
  scene.bodies[0].name = "liver";
  scene.bodies[1].name = "left kidney";
  const std::vector<std::string> right = {"left kidney", "liver"}, wrong = {"liver", "Liver"};
  EXPECT_NO_THROW(check_phantoms(scene, {}, ""));
  EXPECT_NO_THROW(check_phantoms(scene, right, "liver"));
  EXPECT_THROW(check_phantoms(scene, {}, "spleen"), InputError);
  scene.bodies[0].kind = BodyKind::soft;
  EXPECT_NO_THROW(check_phantoms(scene, right, ""));
  EXPECT_THROW(check_phantoms(scene, {}, "liver"), InputError) << "it has no pose";
  try {
    check_phantoms(scene, wrong, "");
    FAIL() << "a name that nobody has";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "phantom \"Liver\": the scene \"abdomen\" has no such body; bodies: liver, left kidney");
  }
}

/// Two people look at one table, each through a camera of their own.
TEST(CameraSight, TwoWhoLookAtOneBoardAgreeWhereItAndAPhantomAre) {
  const std::filesystem::path folder = testing::TempDir();
  const std::string cube = source_path("deploy/cameras/phantom.toml");
  const Pose phantom = {{0.2, 0.93, 0.03}, Quat(Eigen::AngleAxisd(0.3, Vec3::UnitY()))};
  const ObjectBoard fixed = {cube,
                             {{0.01, 0.02, -0.03}, Quat(Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()))}};
  struct Looker {
    Pose eye;
    std::unique_ptr<CameraSight> sight;
    std::shared_ptr<const UndistortedImage> seen = {};
  };
  std::array<Looker, 2> lookers = {{{look_at({-0.25, 1.35, 0.42}, {0.07, 0.92, 0}), nullptr},
                                    {look_at({0.4, 1.4, 0.35}, {0.07, 0.92, 0}), nullptr}}};
  for (std::size_t k = 0; k < lookers.size(); ++k) {
    const Pose& eye = lookers[k].eye;
    const std::filesystem::path file = folder / fmt::format("looker_{}.toml", k);
    std::ofstream(file) << fmt::format(
        "ambient = 0.8\n[[camera]]\nfocal = 600\nrate = 5\nrays = 2\nposition = [{}, {}, {}]\n"
        "orientation = [{}, {}, {}, {}]\n[[board]]\nknown = \"table\"\nposition = [0, 0.9, 0]\n"
        "orientation = [0.70710678, -0.70710678, 0, 0]\n[[board]]\nfile = \"{}\"\nposition = [{}, {}, {}]\n"
        "orientation = [{}, 0, {}, 0]\n",
        eye.p.x(), eye.p.y(), eye.p.z(), eye.q.w(), eye.q.x(), eye.q.y(), eye.q.z(), cube, phantom.p.x(),
        phantom.p.y(), phantom.p.z(), phantom.q.w(), phantom.q.y());
    lookers[k].sight = std::make_unique<CameraSight>(
        std::make_shared<SharedCamera>("synthetic:" + file.string()), CameraConfig{}, std::nullopt, fixed);
  }
  const std::int64_t start = monotonic_ns();
  for (Looker& looker : lookers) {
    while ((!looker.seen || !looker.seen->room_eye || !looker.seen->room_phantom) &&
           seconds_since(start) < 30)
      looker.seen = looker.sight->next(std::chrono::milliseconds(100));
    ASSERT_TRUE(looker.seen && looker.seen->room_eye && looker.seen->room_phantom) << looker.sight->warning();
    EXPECT_LT((looker.seen->room_eye->p - looker.eye.p).norm(), 1e-3) << "m";
    EXPECT_LT((looker.seen->room_phantom->p - phantom * fixed.mount.p).norm(), 1e-3) << "m";
    EXPECT_LT(looker.seen->room_phantom->q.angularDistance(phantom.q * fixed.mount.q), 0.01);
  }
  const double apart = (lookers[0].seen->room_phantom->p - lookers[1].seen->room_phantom->p).norm();
  std::cout << "the phantom, as two see it: " << 1e3 * apart << " mm apart\n";
  EXPECT_LT(apart, 1e-3) << "m";
}

TEST(PaperLight, IsThatOfTheBoardsPaperWhateverLiesOnHalfOfIt) {
  SyntheticScene scene;
  scene.sensor.noise = 3;
  const Board board = find_board("table");
  Carrier lying;
  lying.pose = {{0, 0, -0.6}, Quat::Identity()};
  scene.ambient = 1;
  scene.add_board(board, lying);
  for (const double light : {0.3, 1.0}) {
    scene.sensor.light = light;
    const Image image = SceneRenderer(scene).paint(0);
    const auto paper = paper_light(image, scene.lens, board, device_camera * lying.pose);
    ASSERT_TRUE(paper);
    const double expected = light * std::pow(235 / 255.0, 2.2);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR((*paper)[c], expected, 0.08 * expected);
  }
  const auto behind =
      paper_light(Image{640, 480, std::vector<std::uint8_t>(3 * 640 * 480)}, scene.lens, board, lying.pose);
  EXPECT_FALSE(behind);
}

/// Paper of ours on the scene's table, lit as a camera's is, looks as the camera's.
TEST(LightAs, MakesOurPaperAsBrightAsTheCameras) {
  for (const Vec3& paper : {Vec3(0.2, 0.2, 0.2), Vec3(0.6, 0.55, 0.45), Vec3(0.05, 0.05, 0.06)}) {
    DrawList list = table_list();
    for (DrawItem& item : room_items(10)) {
      list.items.push_back(item);
      list.items.back().showing = ItemRole::around;
    }
    const Vec3 shown = rendered_paper_color(list, {0, 0.9, 0}, Vec3::UnitY());
    DrawItem sheet = table_plane({{0, 0.92, 0}, list.items[0].pose.q}, 5);
    sheet.showing = ItemRole::itself;
    sheet.appearance.color = Vec3::Constant(0.83);
    sheet.appearance.roughness = 1;
    match_lighting(sheet, shown, paper);
    list.items.push_back(sheet);
    const Image picture = test::picture_of(list, width, height);
    for (int c = 0; c < 3; ++c) {
      const double light = std::pow(seen(picture, list.cameras[0], {0, 0.92, 0})[c] / 255.0, 2.2);
      EXPECT_NEAR(light, paper[c], 0.25 * paper[c] + 0.01);
    }
  }
}

}  // namespace
}  // namespace prosector
