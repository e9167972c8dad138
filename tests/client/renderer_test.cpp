// The renderer's promises, checked on pictures.

#include "client/render/renderer.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>

#include "client/render/projection.h"
#include "client/render/quality_governor.h"
#include "client/render/shader_source.h"
#include "common/error.h"
#include "tests/client/picture.h"
#include "tests/folders.h"

namespace prosector {
namespace {

using namespace test;

DrawList lit_sphere(const Vec3& light_direction) {
  DrawList list;
  list.cameras = {straight_camera({0, 0, 1}, 200, 150)};
  DrawItem item;
  item.mesh = sphere_mesh(0.2, 1);
  item.appearance.color = {0.6, 0.6, 0.6};
  item.appearance.roughness = 1;
  list.items = {item};
  list.lights = {directional(light_direction)};
  list.ambient = Vec3::Zero();
  return list;
}

/// Every kind of surface, shadows, lines, texts and two cameras: whatever the renderer can do.
DrawList everything() {
  DrawList list;
  list.cameras = {straight_camera({-0.03, 0.1, 1}, 160, 160), straight_camera({0.03, 0.1, 1}, 160, 160)};
  list.cameras[1].x = 160;
  for (int k = 0; k <= static_cast<int>(last_surface); ++k) {
    DrawItem item;
    item.mesh = sphere_mesh(0.07, 1);
    item.pose.p = {0.2 * (k % 3 - 1), 0.2 * (k / 3 - 1), 0};
    item.appearance = {{0.7, 0.35, 0.3}, 0.5, 0.11 * k, static_cast<Surface>(k)};
    list.items.push_back(item);
  }
  list.lights = {lamp({0.6, 1, 0.8}, Vec3::Zero()), directional({1, -1, -1})};
  list.lights[1].intensity = 0.3;
  list.lines = {{{0, 0, 0.1}, {0.2, 0.2, 0.1}, {1, 0, 0}, 3, false},
                {{-0.9, -0.9, 0}, {-0.6, -0.9, 0}, {0, 1, 0}, 2, true}};
  list.texts = {{"Prosector", {5, 5, 0}, true, 14, {1, 1, 1}}, {"here", {0, 0.3, 0}, false, 12, {1, 1, 0}}};
  return list;
}

TEST(Renderer, EglAndOsMesaDrawTheSameBytes) {
  const DrawList list = everything();
  const Image egl = picture_of(list, 320, 160, make_egl_context);
  const Image osmesa = picture_of(list, 320, 160, make_osmesa_context);
  EXPECT_EQ(egl.width, 320);
  EXPECT_TRUE(egl == osmesa);
}

TEST(Renderer, DrawsTheSameTwice) {
  const auto context = make_offscreen_context(320, 160);
  Renderer renderer(*context, default_shader_dir());
  renderer.draw(everything());
  const Image first = renderer.read_pixels();
  renderer.draw(everything());
  EXPECT_TRUE(first == renderer.read_pixels());
}

int largest_difference(const Image& a, const Image& b) {
  int most = 0;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x)
      for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(a.pixel(x, y)[k] - b.pixel(x, y)[k]));
  return most;
}

TEST(Renderer, LeavesNothingCutWhenASectionIsClosed) {
  DrawList closed = everything();
  closed.lines.clear();
  closed.texts.clear();
  for (DrawItem& item : closed.items) item.solid = 1;
  DrawList opened = closed;
  opened.section = SectionPlane{Vec3(0.3, 0.2, 1).normalized(), 0.01};
  const auto context = make_offscreen_context(320, 160);
  Renderer renderer(*context, default_shader_dir());
  renderer.draw(opened);
  const Image cut = renderer.read_pixels();
  renderer.draw(closed);
  const Image shut = renderer.read_pixels(), whole = picture_of(closed, 320, 160);
  EXPECT_GT(largest_difference(cut, whole), 100);
  // Mirrors may still show what was open: the room is drawn anew only when its lights change.
  EXPECT_LT(largest_difference(shut, whole), 50);
}

// Lambert and a matt highlight are brightest near where the normal meets the light (highlight: halfway). With
// the light behind the eye both coincide with the point that faces it.
TEST(Renderer, ASphereIsBrightestWhereItFacesTheLight) {
  for (const double tilt : {-0.3, 0.0, 0.35}) {
    const Vec3 direction(-std::sin(tilt), 0, -std::cos(tilt));
    const Image image = picture_of(lit_sphere(direction), 200, 150);
    double weight = 0, x_sum = 0, y_sum = 0, brightest = 0;
    for (int y = 0; y < 150; ++y)
      for (int x = 0; x < 200; ++x) brightest = std::max(brightest, luminance(image.pixel(x, y)));
    for (int y = 0; y < 150; ++y)
      for (int x = 0; x < 200; ++x)
        if (luminance(image.pixel(x, y)) > brightest - 2.5) {
          weight += 1;
          x_sum += x + 0.5;
          y_sum += y + 0.5;
        }
    const Vec3 expected = -0.2 * direction;
    const double scale = 75 / 0.4 / (1 - expected.z());  // pixels per metre at that depth
    EXPECT_NEAR(x_sum / weight, 100 + scale * expected.x(), 4) << "tilt " << tilt;
    EXPECT_NEAR(y_sum / weight, 75, 4) << "tilt " << tilt;
  }
}

TEST(Renderer, TheLampCastsAShadow) {
  DrawList list;
  list.cameras = {straight_camera({0, 0, 1}, 120, 120)};
  DrawItem wall;
  auto quad = std::make_shared<DrawMesh>();
  quad->id = 1;
  quad->positions = {{-1, -1, -0.3F}, {1, -1, -0.3F}, {1, 1, -0.3F}, {-1, 1, -0.3F}};
  quad->normals.assign(4, Eigen::Vector3f::UnitZ());
  quad->triangles = {{0, 1, 2}, {0, 2, 3}};
  wall.mesh = quad;
  DrawItem ball;
  ball.mesh = sphere_mesh(0.1, 2);
  list.items = {wall, ball};
  list.lights = {lamp({0.6, 0, 0.9}, {0, 0, -0.1})};
  // The line from the lamp through the ball's centre meets the wall at x = −0.2.
  const int x = static_cast<int>(60 + 60 * (-0.2 / 1.3) / 0.4), y = 60;
  RendererSettings clear_air;
  clear_air.effects[index_of(Effect::shafts)] = false;
  const double shadowed =
      luminance(picture_of(list, 120, 120, make_offscreen_context, clear_air).pixel(x, y));
  list.items[1].casts_shadow = false;
  const double lit = luminance(picture_of(list, 120, 120, make_offscreen_context, clear_air).pixel(x, y));
  EXPECT_LT(shadowed, 0.6 * lit);
  list.items[1].casts_shadow = true;
  RendererSettings no_shadows = clear_air;
  no_shadows.effects[index_of(Effect::shadows)] = false;
  EXPECT_NEAR(luminance(picture_of(list, 120, 120, make_offscreen_context, no_shadows).pixel(x, y)), lit, 2);
}

DrawItem square(double half, const Pose& pose, std::uint64_t id) {
  auto quad = std::make_shared<DrawMesh>();
  quad->id = id;
  const auto h = static_cast<float>(half);
  quad->positions = {{-h, -h, 0}, {h, -h, 0}, {h, h, 0}, {-h, h, 0}};
  quad->normals.assign(4, Eigen::Vector3f::UnitZ());
  quad->triangles = {{0, 1, 2}, {0, 2, 3}};
  DrawItem item;
  item.mesh = quad;
  item.pose = pose;
  return item;
}

/// Mean brightness with ambient occlusion over that without, in 5 × 5 pixels.
double left_by_occlusion(const DrawList& list, int x, int y, int coarser = 2) {
  RendererSettings with, without;
  with.ambient_occlusion_pixels = coarser;
  without.effects[index_of(Effect::ambient_occlusion)] = false;
  std::array<double, 2> sum{};
  for (std::size_t k = 0; k < 2; ++k) {
    const Image image = picture_of(list, 120, 120, make_offscreen_context, k == 0 ? with : without);
    for (int dy = -2; dy <= 2; ++dy)
      for (int dx = -2; dx <= 2; ++dx) sum[k] += luminance(image.pixel(x + dx, y + dy));
  }
  return sum[0] / sum[1];
}

TEST(Renderer, AmbientOcclusionDarkensWhereThingsTouchButNoPlane) {
  DrawList list;
  list.cameras = {straight_camera({0, 0, 0.6}, 120, 120)};
  list.lights = {directional({0.2, -0.1, -1})};
  // A plane aslant, so that its depth changes from pixel to pixel.
  list.items = {square(1, {{0, 0, 0}, Quat(Eigen::AngleAxisd(0.9, Vec3::UnitX()))}, 1)};
  EXPECT_NEAR(left_by_occlusion(list, 60, 60), 1, 0.01);
  // A ball that touches it.
  const Vec3 up = list.items[0].pose.q * Vec3::UnitZ();
  DrawItem ball;
  ball.mesh = sphere_mesh(0.05, 2);
  ball.pose.p = 0.05 * up;
  ball.casts_shadow = false;
  list.items.push_back(ball);
  // It is seen from 57 pixels below the upper border on: above, the plane goes on behind it.
  for (const int coarser : {1, 2}) {
    EXPECT_LT(left_by_occlusion(list, 60, 52, coarser), 0.95) << coarser;
    EXPECT_NEAR(left_by_occlusion(list, 112, 60, coarser), 1, 0.01) << coarser << ", far from the ball";
  }
}

// The eye looks across the beam of a lamp that shines down, at nothing.
TEST(Renderer, DustShowsInTheBeamButNotInAShadow) {
  DrawList list;
  list.cameras = {straight_camera({0, 0, 1}, 120, 120)};
  list.background = Vec3::Zero();
  DrawItem ball;
  ball.mesh = sphere_mesh(0.1, 1);
  ball.pose.p = {0, 0.2, 0};
  list.items = {ball};
  list.lights = {lamp({0, 1.2, 0}, Vec3::Zero())};
  list.lights[0].cone = 0.15;  // the ball takes two thirds of it
  list.lights[0].intensity = 60;
  const auto below_the_ball = [&] { return luminance(picture_of(list, 120, 120).pixel(60, 75)); };
  const double shadowed = below_the_ball();
  list.items[0].casts_shadow = false;
  const double lit = below_the_ball();
  EXPECT_GT(lit, 8);
  EXPECT_LT(shadowed, 0.7 * lit);
}

TEST(Renderer, AMirrorShowsTheWallThatItFaces) {
  DrawList list;
  list.cameras = {straight_camera({0, 1.2, 1}, 60, 60)};
  list.lights = {directional({0, -1, 0})};
  list.ambient = Vec3::Constant(0.3);
  DrawItem ball;
  ball.mesh = sphere_mesh(0.3, 1);
  ball.pose.p = {0, 1.2, 0};
  ball.appearance = {{0.95, 0.95, 0.95}, 0.05, 0, Surface::metal};
  const auto wall = [](double side, const Vec3& color, std::uint64_t id) {
    auto quad = std::make_shared<DrawMesh>();
    quad->id = id;
    const float x = static_cast<float>(3.5 * side), z = static_cast<float>(3.5 * side);
    quad->positions = {{x, 0, -z}, {x, 0, z}, {x, 3, z}, {x, 3, -z}};
    quad->normals.assign(4, Eigen::Vector3f(static_cast<float>(-side), 0, 0));
    quad->triangles = {{0, 1, 2}, {0, 2, 3}, {0, 2, 1}, {0, 3, 2}};  // seen from both sides
    DrawItem item;
    item.mesh = quad;
    item.appearance = {color, 0.9, 0, Surface::wall};
    return item;
  };
  list.items = {ball, wall(-1, {0.9, 0.05, 0.05}, 2), wall(1, {0.05, 0.05, 0.9}, 3)};
  const Image image = picture_of(list, 60, 60);
  // The ball's left, 45° aside, reflects what is to its left.
  const std::uint8_t *left = image.pixel(30 - 20, 30), *right = image.pixel(30 + 20, 30);
  EXPECT_GT(left[0], left[2] + 30);
  EXPECT_GT(right[2], right[0] + 30);
}

// A point at depth D seen by eyes e apart with parallel axes is shifted by e/D in tangents.
TEST(Renderer, StereoDisparityIsEyeDistanceOverDepth) {
  constexpr double eye_distance = 0.064;
  for (const double depth : {0.4, 0.8, 1.6}) {
    DrawList list;
    for (int eye = 0; eye < 2; ++eye) {
      list.cameras.push_back(straight_camera({(eye - 0.5) * eye_distance, 0, 0}, 300, 200));
      list.cameras.back().x = 300 * eye;
    }
    DrawItem item;
    item.mesh = sphere_mesh(0.01 * depth, 1);
    item.pose.p = {0, 0, -depth};
    item.appearance.surface = Surface::emissive;
    item.appearance.color = Vec3::Ones();
    list.items = {item};
    list.background = Vec3::Zero();
    const Image image = picture_of(list, 600, 200);
    std::array<double, 2> weight{}, x_sum{};
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 600; ++x) {
        const auto eye = static_cast<std::size_t>(x / 300);
        const double l = luminance(image.pixel(x, y));
        weight[eye] += l;
        x_sum[eye] += l * (x % 300 + 0.5);
      }
    ASSERT_GT(weight[0], 0);
    ASSERT_GT(weight[1], 0);
    const double disparity = x_sum[0] / weight[0] - x_sum[1] / weight[1];
    EXPECT_NEAR(disparity, eye_distance / depth * 200 / 0.8, 0.15) << depth;
  }
}

TEST(Renderer, RefreshesPositionsAndTopologyByRevision) {
  const auto context = make_offscreen_context(100, 100);
  Renderer renderer(*context, default_shader_dir());
  DrawList list;
  list.cameras = {straight_camera({0, 0, 1}, 100, 100)};
  auto mesh = sphere_mesh(0.1, 7);
  DrawItem item;
  item.mesh = mesh;
  item.appearance.surface = Surface::emissive;
  item.appearance.color = Vec3::Ones();
  list.items = {item};
  const auto brightness = [&](int x) {
    renderer.draw(list);
    return luminance(renderer.read_pixels().pixel(x, 50));
  };
  EXPECT_GT(brightness(50), 100);
  for (auto& p : mesh->positions) p.x() += 0.25F;
  EXPECT_GT(brightness(50), 100) << "same revision: the cached positions stay";
  ++mesh->positions_revision;
  EXPECT_LT(brightness(50), 100);
  EXPECT_GT(brightness(82), 100);
  mesh->triangles.clear();
  ++mesh->revision;
  EXPECT_LT(brightness(82), 100);
}

TEST(Renderer, RefusesMeshesThatDoNotFit) {
  const auto context = make_offscreen_context(10, 10);
  Renderer renderer(*context, default_shader_dir());
  DrawList list;
  list.cameras = {straight_camera({0, 0, 1}, 10, 10)};
  const auto draw = [&](const std::function<void(DrawMesh&)>& spoil) {
    auto mesh = sphere_mesh(0.1, 1);
    spoil(*mesh);
    DrawItem item;
    item.mesh = mesh;
    list.items = {item};
    renderer.draw(list);
  };
  EXPECT_THROW(draw([](DrawMesh& m) { m.normals.pop_back(); }), std::invalid_argument);
  EXPECT_THROW(draw([](DrawMesh& m) { m.rest_positions.resize(1); }), std::invalid_argument);
  EXPECT_THROW(draw([](DrawMesh& m) { m.triangles[0][0] = 1 << 30; }), std::invalid_argument);
  EXPECT_NO_THROW(draw([](DrawMesh&) {}));
}

TEST(Renderer, CullsOnlyWhatNoCameraSees) {
  const Frustum frustum(view_projection_of(straight_camera({0, 0, 1}, 100, 100)));
  EXPECT_TRUE(frustum.may_see({{0, 0, 0}, 0.1}));
  EXPECT_TRUE(frustum.may_see({{0.45, 0, 0}, 0.1})) << "crosses the right plane";
  EXPECT_FALSE(frustum.may_see({{0.7, 0, 0}, 0.1}));
  EXPECT_FALSE(frustum.may_see({{0, -0.7, 0}, 0.1}));
  EXPECT_FALSE(frustum.may_see({{0, 0, 1.3}, 0.1})) << "behind the eye";
  EXPECT_FALSE(frustum.may_see({{0, 0, -40}, 0.1})) << "beyond the far plane";
}

const std::filesystem::path source_shaders = source_path("shaders");

TEST(Renderer, CarriesItsShadersAndReadsAFolderInTheirPlace) {
  std::size_t read = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source_shaders)) {
    if (entry.path().extension() == ".glsl") continue;
    const std::string file = entry.path().filename().string();
    const ShaderSource carried = load_shader_source({}, file, {"EFFECT_FILM"});
    const ShaderSource in_folder = load_shader_source(source_shaders, file, {"EFFECT_FILM"});
    EXPECT_EQ(carried.text, in_folder.text) << file;
    EXPECT_EQ(carried.files.front(), file);
    EXPECT_EQ(in_folder.files.front(), entry.path());
    ++read;
  }
  EXPECT_GE(read, 10u);
  EXPECT_THROW((void)load_shader_source({}, "no_such.frag", {}), InputError);
  EXPECT_THROW((void)load_shader_source("/nonexistent", "main.frag", {}), InputError);
}

TEST(Renderer, NamesTheFileAndLineOfAShaderError) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "prosector_bad_shaders";
  std::filesystem::remove_all(folder);
  std::filesystem::copy(source_shaders, folder, std::filesystem::copy_options::recursive);
  std::ofstream(folder / "noise.glsl", std::ios::app) << "\nfloat broken() { return nonsense; }\n";
  std::ifstream in(folder / "noise.glsl");
  const auto lines = std::count(std::istreambuf_iterator<char>(in), {}, '\n');
  const auto context = make_offscreen_context(10, 10);
  try {
    Renderer renderer(*context, folder);
    FAIL() << "compiled";
  } catch (const InputError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("noise.glsl:" + std::to_string(lines) + ":"), std::string::npos) << what;
    EXPECT_NE(what.find("nonsense"), std::string::npos) << what;
  }
  std::filesystem::remove(folder / "noise.glsl");
  EXPECT_THROW(Renderer(*context, folder), InputError);
  std::filesystem::remove_all(folder);
}

TEST(Renderer, ReadsShadersAnewAndKeepsTheOldOnesWhenTheNewAreBroken) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "prosector_new_shaders";
  std::filesystem::remove_all(folder);
  std::filesystem::copy(source_shaders, folder, std::filesystem::copy_options::recursive);
  const auto context = make_offscreen_context(60, 60);
  RendererSettings plain;
  plain.effects.reset();
  Renderer renderer(*context, folder, plain);
  DrawList list = lit_sphere({0, 0, -1});
  list.cameras = {straight_camera({0, 0, 1}, 60, 60)};
  renderer.draw(list);
  const Image before = renderer.read_pixels();
  EXPECT_EQ(renderer.reload_changed_shaders(), std::nullopt) << "nothing was written";

  const auto append = [&](const char* text) {
    const auto written = std::filesystem::last_write_time(folder / "color.glsl");
    std::ofstream(folder / "color.glsl", std::ios::app) << text;
    std::filesystem::last_write_time(folder / "color.glsl", written + std::chrono::seconds(1));
  };
  append("\nfloat broken() { return nonsense; }\n");
  const auto refused = renderer.reload_changed_shaders();
  ASSERT_TRUE(refused);
  EXPECT_NE(refused->find("color.glsl:"), std::string::npos) << *refused;
  EXPECT_NE(refused->find("nonsense"), std::string::npos) << *refused;
  renderer.draw(list);
  EXPECT_TRUE(renderer.read_pixels() == before) << "the old ones draw on";
  EXPECT_EQ(renderer.reload_changed_shaders(), std::nullopt) << "told once";

  std::filesystem::copy(source_shaders / "color.glsl", folder / "color.glsl",
                        std::filesystem::copy_options::overwrite_existing);
  append("\n#define with_brightness(shown) vec4(0.0, 1.0, 0.0, 1.0)\n");
  EXPECT_TRUE(renderer.reload_changed_shaders());
  renderer.draw(list);
  const Image after = renderer.read_pixels();
  EXPECT_EQ(after.pixel(30, 30)[0], 0);
  EXPECT_EQ(after.pixel(30, 30)[1], 255);
  std::filesystem::remove_all(folder);
}

TEST(Renderer, ChangesItsQualityWhileItDraws) {
  std::map<std::string_view, Image> expected;
  for (const QualityLevel& level : quality_levels)
    expected[level.name] = picture_of(everything(), 320, 160, make_offscreen_context, level.settings);
  const auto context = make_offscreen_context(320, 160);
  Renderer renderer(*context, default_shader_dir());
  renderer.draw(everything());
  for (const QualityLevel& level : quality_levels) {
    renderer.set_settings(level.settings);
    renderer.draw(everything());
    EXPECT_TRUE(renderer.read_pixels() == expected[level.name]) << level.name;
  }
}

TEST(Renderer, TellsOfEveryPassInTheOrderOfDrawing) {
  const auto context = make_offscreen_context(32, 16);
  Renderer renderer(*context, default_shader_dir());
  std::string passes;
  renderer.on_pass([&](std::string_view name) { passes += std::string(name) + " "; });
  renderer.draw(lit_sphere({0, 0, -1}));
  EXPECT_EQ(passes,
            "upload shadow environment surfaces ambient_occlusion glass shafts lines insets edges texts ");
}

TEST(Renderer, ReadsTheLogsOfSeveralDrivers) {
  const ShaderSource source{"", {"a.glsl", "b.glsl"}};
  EXPECT_EQ(readable_log("1:14(3): error: no x", source), "b.glsl:14: error: no x\n");
  EXPECT_EQ(readable_log("0(7) : error C1: no y", source), "a.glsl:7: error C1: no y\n");
  EXPECT_EQ(readable_log("9:1(1): error: beyond\nplain words", source),
            "9:1(1): error: beyond\nplain words\n");
}

/// Returns how far the middle of a ball of cloth, seen from a distance (m) before it, is off being even: of
/// 255, over 8 pixels.
double ripple_of_cloth(double distance) {
  DrawList list = lit_sphere({0, 0, -1});
  list.cameras = {straight_camera({0, 0, 0.2 + distance}, 200, 150)};
  list.items[0].appearance.surface = Surface::cloth;
  const Image image = picture_of(list, 200, 150);
  double most = 0;
  for (int y = 65; y < 85; ++y)
    for (int x = 88; x < 112; ++x) {
      const auto at = [&](int beside) { return luminance(image.pixel(x + beside, y)); };
      most = std::max(most, std::abs(at(0) - (at(-4) + at(4)) / 2));
    }
  return most;
}

TEST(Renderer, ThreadsOfClothAreSeenFromCloseByAndAreNoStripesFromFarther) {
  EXPECT_GT(ripple_of_cloth(0.04), 5);
  for (const double distance : {0.3, 0.45, 0.6, 0.8}) EXPECT_LT(ripple_of_cloth(distance), 3) << distance;
}

TEST(Renderer, ContextsRefuseImpossibleSizes) {
  EXPECT_THROW(make_egl_context(0, 10), InputError);
  EXPECT_THROW(make_osmesa_context(10, max_picture_size + 1), InputError);
  EXPECT_THROW(make_offscreen_context(-1, 10), InputError);
}

}  // namespace
}  // namespace prosector
