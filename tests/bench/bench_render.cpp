#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>

#include "client/render/renderer.h"
#include "client/view/camera.h"
#include "client/view/room.h"
#include "tests/bench/stopwatch.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"

namespace prosector {
namespace {

/// A lumpy ellipsoid with about that many triangles.
std::shared_ptr<DrawMesh> lump(std::uint64_t id, const Vec3& radii, unsigned triangles) {
  auto mesh = std::make_shared<DrawMesh>();
  mesh->id = id;
  const auto rings = std::max(3u, static_cast<std::uint32_t>(std::sqrt(triangles / 4.0)));
  const std::uint32_t spokes = 2 * rings;
  for (std::uint32_t i = 0; i <= rings; ++i)
    for (std::uint32_t j = 0; j <= spokes; ++j) {
      const double polar = std::numbers::pi * i / rings, round = 2 * std::numbers::pi * j / spokes;
      const Vec3 out(std::sin(polar) * std::cos(round), std::cos(polar), -std::sin(polar) * std::sin(round));
      const double lumps = 1 + 0.06 * std::sin(5 * round) * std::sin(polar) * std::sin(4 * polar);
      mesh->positions.push_back((lumps * out.cwiseProduct(radii)).cast<float>());
      mesh->normals.push_back(out.cwiseQuotient(radii).normalized().cast<float>());
      if (i == rings || j == spokes) continue;
      const std::uint32_t a = i * (spokes + 1) + j, b = a + spokes + 1;
      mesh->triangles.push_back({a, b, a + 1});
      mesh->triangles.push_back({a + 1, b, b + 1});
    }
  mesh->rest_positions = mesh->positions;
  return mesh;
}

struct Thing {
  Surface surface;
  Vec3 at, radii, color;
  double roughness, wetness, share;  // share of the triangles
};

/// Organs and bones on a table in the room, under the lamp and two dim lights of the abdomen scene.
DrawList still_life(const RenderBenchOptions& options) {
  const Thing things[] = {
      {Surface::metal, {0, 0.94, 0}, {0.5, 0.05, 0.4}, {0.60, 0.62, 0.64}, 0.38, 0, 0.05},
      {Surface::tissue, {-0.06, 1.06, 0.05}, {0.14, 0.07, 0.10}, {0.42, 0.10, 0.08}, 0.45, 0.9, 0.40},
      {Surface::tissue, {0.12, 1.05, 0.14}, {0.04, 0.05, 0.06}, {0.45, 0.14, 0.10}, 0.40, 0.8, 0.15},
      {Surface::bone, {0.05, 1.02, -0.12}, {0.20, 0.03, 0.03}, {0.80, 0.74, 0.60}, 0.55, 0.2, 0.15},
      {Surface::bone, {0.05, 1.02, 0.26}, {0.20, 0.03, 0.03}, {0.80, 0.74, 0.60}, 0.55, 0.2, 0.15},
      {Surface::skin, {0.22, 1.12, 0.05}, {0.09, 0.03, 0.05}, {0.66, 0.42, 0.32}, 0.5, 0.1, 0.10}};
  DrawList list;
  list.items = room_items(1);
  for (const Thing& thing : things) {
    DrawItem item;
    item.mesh =
        lump(list.items.size() + 1, thing.radii, static_cast<unsigned>(thing.share * options.triangles));
    item.pose.p = thing.at;
    item.surface = thing.surface;
    item.appearance = {thing.color, thing.roughness, thing.wetness};
    list.items.push_back(item);
  }
  LightInfo lamp;
  lamp.kind = LightKind::spot;
  lamp.position = {0.1, 1.91, 0.1};
  lamp.direction = (Vec3(0, 1.05, 0.05) - lamp.position).normalized();
  lamp.intensity = 1.1;
  lamp.cone = 0.5;
  LightInfo dim;
  dim.intensity = 0.9;
  dim.position = {-1.6, 2.4, 1.2};
  list.lights = {lamp, dim, dim};
  list.lights[2].position = {1.8, 2.4, 0.6};
  list.cameras = {
      mono_camera(look_at({0.66, 1.42, -0.06}, {0, 1.10, 0.08}), 0.78, options.width, options.height)};
  return list;
}

struct Case {
  const char* name;
  int samples, shadow_size;
  bool has_room, has_things, moves;
};

double frame_ms(DrawList list, const Case& what, const RenderBenchOptions& options) {
  if (!what.has_room) list.items.erase(list.items.begin(), list.items.begin() + 2);
  if (!what.has_things) list.items.resize(2);
  const auto context = make_offscreen_context(options.width, options.height);
  Renderer renderer(*context, default_shader_dir(), {what.samples, what.shadow_size});
  double start = 0;
  for (int frame = -2; frame < options.frames; ++frame) {
    if (frame == 0) start = cpu_ms();
    if (what.moves) list.items.back().pose.p.x() += 1e-4;
    renderer.draw(list);
    const Image image = renderer.read_pixels();
    if (frame + 1 == options.frames && !options.picture_folder.empty())
      write_png(image, std::filesystem::path(options.picture_folder) / (std::string(what.name) + ".png"));
  }
  return (cpu_ms() - start) / options.frames;
}

}  // namespace

Report bench_render(const RenderBenchOptions& options) {
  const DrawList list = still_life(options);
  fmt::print("{} × {}, about {} triangles, with reading the picture back\n", options.width, options.height,
             options.triangles);
  using enum Column::Kind;
  const TextTable table(
      {{text, "name", "scene", 16}, {number, "cpu_ms_per_frame", "CPU ms a frame, all threads"}});
  table.print_header();
  Report report("render");
  const Case all[] = {{"full", 4, 1024, true, true, true},     {"nothing moves", 4, 1024, true, true, false},
                      {"1 sample", 1, 1024, true, true, true}, {"no shadow", 4, 0, true, true, true},
                      {"no room", 4, 1024, false, true, true}, {"room only", 4, 1024, true, false, false}};
  for (const Case& what : all) {
    report.add({{"name", what.name},
                {"width", options.width},
                {"height", options.height},
                {"cpu_ms_per_frame", frame_ms(list, what, options)}});
    table.print(report.rows().back());
  }
  return report;
}

}  // namespace prosector
