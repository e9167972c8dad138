#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>

#include "client/render/renderer.h"
#include "client/view/camera.h"
#include "client/view/hand_mesh.h"
#include "client/view/level_of_detail.h"
#include "client/view/normals.h"
#include "client/view/part_labels.h"
#include "client/view/still_scene.h"
#include "common/anatomy/atlas.h"
#include "common/clock.h"
#include "common/ids.h"
#include "common/paths.h"
#include "common/scene/load_scene.h"
#include "server/calibration/stopwatch.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"

namespace prosector {
namespace {

/// The rendered scene: a hand presses the first organ, which deforms.
struct Subject {
  std::string scene;  // name
  DrawList list;
  std::shared_ptr<DrawMesh> organ;    // null: scene without organs
  std::vector<NamedItem> named = {};  // all organs
  std::size_t hand;                   // index into list.items
  Pose eye;
  double fov = 0;       // rad
  bool stereo = false;  // two eyes side by side
  int width = 0, height = 0;
};

void set_size(Subject& subject, int width, int height) {
  subject.width = width;
  subject.height = height;
  subject.list.cameras.clear();
  if (!subject.stereo) {
    subject.list.cameras.push_back(mono_camera(subject.eye, subject.fov, width, height));
    return;
  }
  for (const DrawCamera& eye : stereo_cameras(subject.eye, StereoProfile(), width, height))
    subject.list.cameras.push_back(eye);
}

/// Moves the camera below its target, where a table hides the objects on it.
void look_from_below(Subject& subject) {
  const Vec3 target = subject.list.items[subject.hand].pose.p;
  Vec3 eye = subject.eye.p;
  eye.y() = target.y() - 0.6;
  subject.eye = look_at(eye, target);
  set_size(subject, subject.width, subject.height);
}

Subject scene_with_hand(const RenderBenchOptions& options) {
  const auto tell = [](const std::string& line) { fmt::print("{}\n", line); };
  const SourcePaths paths{
      std::filesystem::path(options.scene).parent_path(), {default_data_dir()}, default_cache_dir()};
  const SceneDesc scene = completed(load_scene(options.scene), paths, tell);
  Subject out;
  out.scene = scene.name;
  out.list = still_scene(scene, paths, tell);
  for (std::size_t k = 0; k < out.list.items.size(); ++k)
    if (out.list.items[k].appearance.surface == Surface::tissue)
      out.named.push_back({static_cast<std::uint32_t>(k), k, "a part of the anatomy"});
  for (DrawItem& item : out.list.items) {
    if (item.appearance.surface != Surface::tissue) continue;
    out.organ = std::make_shared<DrawMesh>(*item.mesh);
    item.mesh = out.organ;
    break;
  }
  const HandSkin skin(right_hand);
  out.hand = out.list.items.size();
  out.list.items.push_back({.mesh = make_hand_mesh(skin, 1000),
                            .pose = look_at(scene.camera.target + Vec3(0.1, 0, -0.1), scene.camera.target),
                            .appearance = {{0.66, 0.42, 0.32}, 0.5, 0, Surface::skin}});
  out.eye = look_at(scene.camera.eye, scene.camera.target);
  out.fov = scene.camera.fov;
  out.stereo = options.stereo;
  set_size(out, options.width, options.height);
  add_detail(out.list);
  return out;
}

enum class Motion : std::uint8_t { none, hand, press };

struct Case {
  std::string name;
  RendererSettings settings;
  Motion motion;
  double detail = quality_levels[1].detail;  // pixels
  bool labels = false;                       // names beside the organs
};

void move(Subject& subject, Motion motion) {
  if (motion == Motion::none) return;
  subject.list.items[subject.hand].pose.p.x() += 1e-4;
  if (motion == Motion::hand || !subject.organ) return;
  subject.organ->positions[0].y() += 1e-5F;
  smooth_normals(subject.organ->positions, subject.organ->triangles, subject.organ->normals);
  ++subject.organ->positions_revision;
}

/// Mean times of several frames.
struct Cost {
  double cpu_ms = 0, wall_ms = 0;                 // with readback
  double drawn_ms = 0;                            // without readback, frames overlapping
  std::map<std::string, double> wall_ms_of = {};  // per pass, without overlap
  std::size_t labels = 0;                         // of the last frame
  std::size_t drawn = 0;                          // triangles of the last frame's levels of detail
  std::size_t hidden = 0;                         // items culled, over all its cameras
};

/// Returns ms per frame without waiting for single frames, as with a display. Runs for at least 1 s, so that
/// an idle GPU reaches its full clock rate.
template <class Draw>
double drawn_ms(Renderer& renderer, const Draw& draw) {
  constexpr int ahead = 10;  // frames in flight
  constexpr std::int64_t second = 1'000'000'000;
  int frames = 0;
  std::int64_t start = 0, now = 0;
  for (const bool counts : {false, true}) {
    frames = 0;
    start = monotonic_ns();
    do {
      for (int k = 0; k < ahead; ++k) draw();
      renderer.finish();
      frames += ahead;
      now = monotonic_ns();
    } while (now - start < (counts ? second : second / 2));
  }
  return 1e-6 * static_cast<double>(now - start) / frames;
}

void add_labels(Subject& subject, PartLabels& labels) {
  subject.list.lines.clear();
  subject.list.texts.clear();
  const DrawCamera& camera = subject.list.cameras.front();
  labels.add(subject.list, subject.named,
             {Eigen::Vector2d(10, 10), Eigen::Vector2d(camera.width - 10, camera.height - 10)});
}

Cost measure(Subject& subject, const Case& what, const RenderBenchOptions& options) {
  const auto context = make_offscreen_context(subject.width, subject.height);
  Renderer renderer(*context, default_shader_dir(), what.settings);
  LevelOfDetail level_of_detail;
  PartLabels labels;
  Cost cost;
  std::int64_t last = 0;
  const auto move_and_draw = [&] {
    move(subject, what.motion);
    last = monotonic_ns();
    level_of_detail.choose(subject.list, what.detail);
    cost.wall_ms_of["detail"] += 1e-6 * static_cast<double>(monotonic_ns() - last) / options.frames;
    last = monotonic_ns();
    if (what.labels) add_labels(subject, labels);
    cost.wall_ms_of["labels"] += 1e-6 * static_cast<double>(monotonic_ns() - last) / options.frames;
    renderer.draw(subject.list);
  };
  const auto draw = [&](int frames) {
    for (int frame = 0; frame < frames; ++frame) {
      move_and_draw();
      const Image image = renderer.read_pixels();
      if (frame + 1 == options.frames && !options.picture_folder.empty())
        write_png(image, std::filesystem::path(options.picture_folder) / (what.name + ".png"));
    }
  };
  constexpr int warm_up = 2;
  draw(warm_up);
  const double cpu_start = cpu_ms();
  const std::int64_t start = monotonic_ns();
  draw(options.frames);
  cost.wall_ms = 1e-6 * static_cast<double>(monotonic_ns() - start) / options.frames;
  cost.cpu_ms = (cpu_ms() - cpu_start) / options.frames;
  cost.drawn_ms = drawn_ms(renderer, move_and_draw);
  cost.wall_ms_of.clear();
  renderer.on_pass([&](std::string_view pass) {
    const std::int64_t now = monotonic_ns();
    if (pass != "upload")
      cost.wall_ms_of[std::string(pass)] += 1e-6 * static_cast<double>(now - last) / options.frames;
    last = now;
  });
  draw(options.frames);
  cost.hidden = renderer.hidden();
  cost.labels = subject.list.texts.size();
  subject.list.lines.clear();
  subject.list.texts.clear();
  for (const DrawItem& item : subject.list.items) cost.drawn += triangles_of(item).size();
  return cost;
}

/// Divides every triangle into four, which leaves the image unchanged.
std::shared_ptr<DrawMesh> subdivided(const DrawMesh& mesh, std::uint64_t id) {
  auto out = std::make_shared<DrawMesh>(mesh);
  out->id = id;
  out->triangles.clear();
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] =
        middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(out->positions.size()));
    if (is_new) {
      out->positions.push_back(0.5F * (out->positions[a] + out->positions[b]));
      out->normals.push_back((out->normals[a] + out->normals[b]).normalized());
      if (!out->rest_positions.empty())
        out->rest_positions.push_back(0.5F * (out->rest_positions[a] + out->rest_positions[b]));
    }
    return found->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    for (const std::array<std::uint32_t, 3>& triangle :
         {std::array{a, ab, ca}, std::array{ab, b, bc}, std::array{ca, bc, c}, std::array{ab, bc, ca}})
      out->triangles.push_back(triangle);
  }
  return out;
}

void subdivide_bodies(Subject& subject) {
  for (DrawItem& item : subject.list.items) {
    const bool is_organ = item.mesh == subject.organ;
    const auto finer = subdivided(*item.mesh, item.mesh->id + (1U << 24));
    item.mesh = finer;
    item.detail = nullptr;
    if (is_organ) subject.organ = finer;
  }
  add_detail(subject.list);
}

std::size_t triangles_of(const DrawList& list) {
  std::size_t sum = 0;
  for (const DrawItem& item : list.items) sum += item.mesh->triangles.size();
  return sum;
}

}  // namespace

Report bench_render(const RenderBenchOptions& options) {
  Subject subject = scene_with_hand(options);
  using enum Column::Kind;
  const TextTable table({{text, "name", "picture", 28},
                         {number, "width", "wide"},
                         {number, "height", "high"},
                         {number, "triangles", "triangles"},
                         {number, "drawn", "drawn"},
                         {number, "hidden", "hidden"},
                         {number, "labels", "labels"},
                         {number, "cpu_ms_per_frame", "CPU ms, all threads"},
                         {number, "wall_ms_per_frame", "ms"},
                         {number, "drawn_ms_per_frame", "no readback"},
                         {number, "ms_passes", "all passes"},
                         {number, "ms_detail", "detail"},
                         {number, "ms_labels", "placing labels"},
                         {number, "ms_shadow", "shadow"},
                         {number, "ms_environment", "mirror"},
                         {number, "ms_surfaces", "surfaces"},
                         {number, "ms_glass", "glass"},
                         {number, "ms_shafts", "shafts"},
                         {number, "ms_edges", "edges"}});
  fmt::print(
      "per frame: with readback; without it, ten frames in flight; then each pass, finished before the "
      "next starts\n");
  table.print_header();
  Report report("render");
  const auto add = [&](const Case& what) {
    const Cost cost = measure(subject, what, options);
    ReportRow row = {{"name", what.name},
                     {"scene", subject.scene},
                     {"triangles", triangles_of(subject.list)},
                     {"drawn", cost.drawn},
                     {"hidden", cost.hidden},
                     {"labels", cost.labels},
                     {"width", subject.width},
                     {"height", subject.height},
                     {"eyes", subject.list.cameras.size()},
                     {"samples", what.settings.samples},
                     {"cpu_ms_per_frame", cost.cpu_ms},
                     {"wall_ms_per_frame", cost.wall_ms},
                     {"drawn_ms_per_frame", cost.drawn_ms}};
    double drawn = 0;
    for (const auto& [pass, ms] : cost.wall_ms_of) {
      row["ms_" + pass] = ms;
      drawn += ms;
    }
    row["ms_passes"] = drawn;
    report.add(row);
    table.print(report.rows().back());
  };
  const QualityLevel& usual = quality_levels[1];
  for (const QualityLevel& level : quality_levels)
    add({std::string(level.name), level.settings, Motion::press, level.detail});
  RendererSettings hidden_too = usual.settings;
  hidden_too.occlusion = false;
  const auto add_hidden = [&](const std::string& name) {
    add({name, usual.settings, Motion::press, 0});
    add({name + ", culling off", hidden_too, Motion::press, 0});
  };
  add_hidden("medium, all triangles");
  const Pose eye = subject.eye;
  look_from_below(subject);
  add_hidden("from below");
  subject.eye = eye;
  set_size(subject, options.width, options.height);
  add({"only the hand moves", usual.settings, Motion::hand});
  add({"nothing moves", usual.settings, Motion::none});
  add({"nothing moves, labels", usual.settings, Motion::none, usual.detail, true});
  for (std::size_t k = 0; k < effect_rows.size(); ++k) {
    RendererSettings without = usual.settings;
    without.effects.flip(k);
    add({fmt::format("medium {} {}", without.effects[k] ? "with" : "without", effect_rows[k].name), without,
         Motion::press});
  }
  for (const double scale : {0.5, 2.0}) {
    set_size(subject, static_cast<int>(scale * options.width), static_cast<int>(scale * options.height));
    for (const QualityLevel& level : quality_levels)
      add({fmt::format("{}, {} times the size", level.name, scale), level.settings, Motion::press,
           level.detail});
  }
  set_size(subject, options.width, options.height);
  for (int finer = 1; finer <= 2; ++finer) {
    subdivide_bodies(subject);
    const int times = finer == 1 ? 4 : 16;
    add({fmt::format("medium, {} times the triangles", times), usual.settings, Motion::press});
    add({fmt::format("medium, {} times, all triangles", times), usual.settings, Motion::press, 0});
    if (finer < 2) continue;
    look_from_below(subject);
    add_hidden("16 times, from below");
  }
  return report;
}

}  // namespace prosector
