#include <fmt/format.h>

#include <string>

#include "client/render/renderer.h"
#include "client/view/camera.h"
#include "client/view/hand_mesh.h"
#include "client/view/normals.h"
#include "client/view/still_scene.h"
#include "common/paths.h"
#include "common/scene/load_scene.h"
#include "server/calibration/stopwatch.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"

namespace prosector {
namespace {

/// What a frame moves: a hand that presses the first organ, which gives way.
struct Subject {
  std::string scene;  // its name
  DrawList list;
  std::shared_ptr<DrawMesh> organ;  // null: the scene has none
  std::size_t hand;                 // index into list.items
};

Subject scene_with_hand(const RenderBenchOptions& options) {
  const SceneDesc scene = load_scene(options.scene);
  const SourcePaths paths{scene.file.parent_path(), {default_data_dir()}, default_cache_dir()};
  Subject out;
  out.scene = scene.name;
  out.list = still_scene(scene, paths, [](const std::string& line) { fmt::print("{}\n", line); });
  for (DrawItem& item : out.list.items) {
    if (item.appearance.surface != Surface::tissue) continue;
    out.organ = std::make_shared<DrawMesh>(*item.mesh);
    item.mesh = out.organ;
    break;
  }
  const HandSkin skin(right_hand);
  out.hand = out.list.items.size();
  out.list.items.push_back({.mesh = skin.make_mesh(1000),
                            .pose = look_at(scene.camera.target + Vec3(0.1, 0, -0.1), scene.camera.target),
                            .appearance = {{0.66, 0.42, 0.32}, 0.5, 0, Surface::skin}});
  out.list.cameras = {mono_camera(look_at(scene.camera.eye, scene.camera.target), scene.camera.fov,
                                  options.width, options.height)};
  return out;
}

enum class Motion : std::uint8_t { none, hand, press };

struct Case {
  std::string name;
  RendererSettings settings;
  Motion motion;
};

void move(Subject& subject, Motion motion) {
  if (motion == Motion::none) return;
  subject.list.items[subject.hand].pose.p.x() += 1e-4;
  if (motion == Motion::hand || !subject.organ) return;
  subject.organ->positions[0].y() += 1e-5F;
  smooth_normals(subject.organ->positions, subject.organ->triangles, subject.organ->normals);
  ++subject.organ->positions_revision;
}

double frame_ms(Subject& subject, const Case& what, const RenderBenchOptions& options) {
  const auto context = make_offscreen_context(options.width, options.height);
  Renderer renderer(*context, default_shader_dir(), what.settings);
  double start = 0;
  for (int frame = -2; frame < options.frames; ++frame) {
    if (frame == 0) start = cpu_ms();
    move(subject, what.motion);
    renderer.draw(subject.list);
    const Image image = renderer.read_pixels();
    if (frame + 1 == options.frames && !options.picture_folder.empty())
      write_png(image, std::filesystem::path(options.picture_folder) / (what.name + ".png"));
  }
  return (cpu_ms() - start) / options.frames;
}

std::size_t triangles_of(const DrawList& list) {
  std::size_t sum = 0;
  for (const DrawItem& item : list.items) sum += item.mesh->triangles.size();
  return sum;
}

}  // namespace

Report bench_render(const RenderBenchOptions& options) {
  Subject subject = scene_with_hand(options);
  const std::size_t triangles = triangles_of(subject.list);
  fmt::print("{} × {}, {} triangles, with reading the picture back\n", options.width, options.height,
             triangles);
  using enum Column::Kind;
  const TextTable table(
      {{text, "name", "picture", 20}, {number, "cpu_ms_per_frame", "CPU ms a frame, all threads"}});
  table.print_header();
  Report report("render");
  std::vector<Case> all;
  for (const QualityLevel& level : quality_levels)
    all.push_back({std::string(level.name), level.settings, Motion::press});
  all.push_back({"only the hand moves", {}, Motion::hand});
  all.push_back({"nothing moves", {}, Motion::none});
  for (std::size_t k = 0; k < effect_rows.size(); ++k) {
    RendererSettings without;
    without.effects.flip(k);
    all.push_back({fmt::format("medium without {}", effect_rows[k].name), without, Motion::press});
  }
  for (const Case& what : all) {
    report.add({{"name", what.name},
                {"scene", subject.scene},
                {"triangles", triangles},
                {"width", options.width},
                {"height", options.height},
                {"cpu_ms_per_frame", frame_ms(subject, what, options)}});
    table.print(report.rows().back());
  }
  return report;
}

}  // namespace prosector
