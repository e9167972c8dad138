#include "client/app/commands/render_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "client/app/output/recorder.h"
#include "client/render/contact_sheet.h"
#include "client/view/level_of_detail.h"
#include "client/view/scene_tour.h"
#include "client/view/still_scene.h"
#include "common/anatomy/atlas.h"
#include "common/error.h"
#include "common/paths.h"
#include "common/scene/load_scene.h"

namespace prosector {
namespace {

constexpr double turntable_rate = 25;  // frames/s
constexpr int sheet_columns = 4, sheet_tile_width = 200;

void print_line(const std::string& line) {
  fmt::print("{}\n", line), std::fflush(stdout);
}

std::unique_ptr<GlContext> make_context(const RenderOptions& o) {
  return o.osmesa ? make_osmesa_context(o.width, o.height) : make_offscreen_context(o.width, o.height);
}

Image draw(Renderer& renderer, const DrawList& list) {
  renderer.draw(list);
  return renderer.read_pixels();
}

class Pictures {
 public:
  explicit Pictures(const RenderOptions& o) : options_(o), prefix_(o.scene.stem().string()) {}

  std::filesystem::path file(const std::string& name) const {
    return options_.out / fmt::format("{}-{}", prefix_, name);
  }
  void keep(Image image, const std::string& name, const std::string& about) {
    write_png(image, file(name + ".png"));
    print_line(fmt::format("{}: {}", file(name + ".png").string(), about));
    if (options_.sheet) all_.push_back(std::move(image));
  }
  void write_sheet() const {
    if (all_.empty()) return;
    write_png(contact_sheet(all_, sheet_columns, sheet_tile_width), file("sheet.png"));
    print_line(fmt::format("{}: contact sheet of all frames, row by row", file("sheet.png").string()));
  }

 private:
  const RenderOptions& options_;
  std::string prefix_;
  std::vector<Image> all_;
};

/// Returns the draw list on which an effect is compared. Glass effects need a view of glass (null: there is
/// none), light shafts a view of a shaft, all others use a close view.
const DrawList* compared(const std::vector<TourStop>& tour, Effect effect) {
  const bool of_glass = effect == Effect::refraction || effect == Effect::dispersion;
  const std::string_view best = of_glass ? "glass" : effect == Effect::shafts ? "shaft" : "close";
  const auto found =
      std::find_if(tour.begin(), tour.end(), [&](const TourStop& stop) { return stop.name == best; });
  if (found != tour.end()) return &found->list;
  return of_glass ? nullptr : &tour.front().list;
}

void draw_toggled_effects(const RenderOptions& o, const std::vector<TourStop>& tour, Pictures& pictures) {
  for (std::size_t k = 0; k < effect_rows.size(); ++k) {
    const DrawList* list = compared(tour, static_cast<Effect>(k));
    if (list == nullptr) continue;
    RendererSettings other = o.quality.settings;
    other.effects.flip(k);
    const auto context = make_context(o);
    Renderer renderer(*context, o.shaders, other);
    pictures.keep(draw(renderer, *list),
                  fmt::format("{}-{}", other.effects[k] ? "with" : "without", effect_rows[k].name),
                  std::string(effect_rows[k].about));
  }
}

void draw_turn(const RenderOptions& o, const SceneDesc& scene, DrawList list, Renderer& renderer,
               const std::filesystem::path& file) {
  const Subject subject = subject_of(scene, list);
  const int count = std::max(2, static_cast<int>(std::lround(turntable_rate * o.turntable)));
  Recorder recorder(file, o.width, o.height, turntable_rate);
  LevelOfDetail level_of_detail;
  for (int k = 0; k < count; ++k) {
    list.cameras = {orbit_camera(scene, subject, 2 * std::numbers::pi * k / count, o.width, o.height)};
    level_of_detail.choose(list, o.quality.detail);
    recorder.add(draw(renderer, list));
    if (!recorder.failure().empty()) throw InputError(recorder.failure());
  }
  print_line(fmt::format("{}: one turn, {} frames", file.string(), count));
}

}  // namespace

int render_scene(const RenderOptions& o) {
  const SourcePaths paths{o.scene.parent_path(), {default_data_dir()}, default_cache_dir()};
  const SceneDesc scene = completed(load_scene(o.scene), paths, print_line);
  DrawList list = still_scene(scene, paths, print_line);
  if (o.quality.detail > 0) add_detail(list);
  std::vector<TourStop> tour = tour_of(scene, list, o.width, o.height);
  const auto is_left_out = [&](const TourStop& stop) { return !o.view.empty() && stop.name != o.view; };
  std::string names;
  for (const TourStop& stop : tour) names += " " + stop.name;
  std::erase_if(tour, is_left_out);
  if (tour.empty())
    throw InputError(fmt::format("--view {}: unknown view; views of this scene:{}", o.view, names));

  for (TourStop& stop : tour) LevelOfDetail().choose(stop.list, o.quality.detail);

  std::error_code error;
  std::filesystem::create_directories(o.out, error);
  if (error) throw InputError(fmt::format("--out {}: {}", o.out.string(), error.message()));
  Pictures pictures(o);
  const auto context = make_context(o);
  Renderer renderer(*context, o.shaders, o.quality.settings);
  for (const TourStop& stop : tour) pictures.keep(draw(renderer, stop.list), stop.name, stop.about);
  if (o.turntable > 0) draw_turn(o, scene, list, renderer, pictures.file("turn.avi"));
  if (o.compare) draw_toggled_effects(o, tour, pictures);
  pictures.write_sheet();
  return 0;
}

}  // namespace prosector
