// Detection of printed boards with a synthetic camera: pose errors by distance, tilt, motion, occlusion,
// light and resolution, scatter at rest, and CPU time per image. Also of a face, whose rotation error is that
// of the direction from the eyes to the screen's centre.

#include <fmt/format.h>

#include <initializer_list>
#include <set>

#include "drivers/camera/base/image_reader.h"
#include "tests/bench/camera_plot.h"
#include "tests/bench/face_trials.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"
#include "tests/camera/tag_errors.h"

namespace prosector {
namespace {

/// One row to measure: the varied parameter and its value.
struct CameraTrial {
  std::string board, varied;
  double value;
  TagCase what;
};

TagCase case_of(const Board& board, double distance) {
  TagCase what;
  what.board = board;
  what.distance = distance;
  what.most_tilt = 50 * degree;
  return what;
}

/// Lists the rows measured for one board.
std::vector<CameraTrial> trials_of(const std::string& name, const Board& board, double usual_distance) {
  std::vector<CameraTrial> out;
  const auto add = [&](const std::string& varied, double value, auto change) {
    TagCase what = case_of(board, usual_distance);
    change(what, value);
    out.push_back({name, varied, value, what});
  };
  for (const double d : {0.3, 0.4, 0.6, 0.8, 1.2, 1.8})
    add("distance m", d, [](TagCase& w, double v) { w.distance = v; });
  for (const double d : {0.8, 1., 1.2, 1.8})
    add("distance m, tracked", d, [](TagCase& w, double v) {
      w.distance = v;
      w.reads_on = true;
    });
  for (const double t : {0., 20., 40., 60., 70.})
    add("tilt deg", t, [](TagCase& w, double v) { w.least_tilt = w.most_tilt = v * degree; });
  for (const double s : {0., 0.1, 0.2, 0.3, 0.4, 0.6, 0.8})
    add("speed m/s, 10 ms exposed", s, [](TagCase& w, double v) {
      w.speed = v;
      w.exposure = 0.01;
    });
  for (const double c : {0., 0.4, 0.7}) add("covered", c, [](TagCase& w, double v) { w.covered = v; });
  for (const double l : {1., 0.3, 0.1, 0.03}) add("light", l, [](TagCase& w, double v) { w.light = v; });
  for (const double h : {240., 480., 720.})
    add("lines of 4:3", h, [](TagCase& w, double v) {
      w.height = static_cast<int>(v);
      w.width = w.height * 4 / 3;
    });
  for (const double d : {1., 2.}) add("decimate", d, [](TagCase& w, double v) { w.finder.decimate = v; });
  for (const double e : {1.0, 1.8, 2.2, 2.6})
    add("assumed gamma, 2.2 true", e, [](TagCase& w, double v) { w.assumed = v; });
  for (const double d : {0.4, 0.8})
    add("scatter at rest, m", d, [](TagCase& w, double v) {
      w.distance = v;
      w.still = true;
    });
  return out;
}

/// Lists the rows measured for a printed image.
std::vector<CameraTrial> page_trials(const std::filesystem::path& file) {
  const Board page{"page", {}, std::make_shared<const PrintedImage>(PrintedImage{read_image(file), 0.2})};
  std::vector<CameraTrial> out;
  const auto add = [&](const std::string& varied, std::initializer_list<double> values, auto change) {
    for (const double value : values) {
      TagCase what = case_of(page, 0.6);
      change(what, value);
      out.push_back({"page", varied, value, what});
    }
  };
  add("distance m", {0.3, 0.4, 0.6, 0.9, 1.2}, [](TagCase& w, double v) { w.distance = v; });
  add("tilt deg", {0, 20, 40, 60}, [](TagCase& w, double v) { w.least_tilt = w.most_tilt = v * degree; });
  add("covered", {0, 0.4, 0.7}, [](TagCase& w, double v) { w.covered = v; });
  add("light", {1, 0.3, 0.1}, [](TagCase& w, double v) { w.light = v; });
  return out;
}

ReportRow row_of(const CameraTrial& trial) {
  const TagErrors errors = tag_errors(trial.what);
  return {{"board", trial.board},
          {"varied", trial.varied},
          {"value", trial.value},
          {"seen", static_cast<double>(errors.seen) / trial.what.places},
          {"depth_mm", quantile(errors.depth, 0.5)},
          {"depth_95_mm", quantile(errors.depth, 0.95)},
          {"lateral_mm", quantile(errors.lateral, 0.5)},
          {"turn_deg", quantile(errors.turn, 0.5) / degree},
          {"told_mm", quantile(errors.told, 0.5)},
          {"straighten_ms", quantile(errors.straighten_ms, 0.5)},
          {"find_ms", quantile(errors.find_ms, 0.5)},
          {"fit_ms", quantile(errors.fit_ms, 0.5)}};
}

}  // namespace

Report bench_camera(const CameraBenchOptions& options) {
  Report report("camera");
  using enum Column::Kind;
  const TextTable table({{text, "board", "board", 8},
                         {text, "varied", "varied", 26},
                         {number, "value", "value"},
                         {percent, "seen", "seen"},
                         {number, "depth_mm", "depth mm"},
                         {number, "depth_95_mm", "95 %"},
                         {number, "lateral_mm", "lateral mm"},
                         {number, "turn_deg", "rotation deg"},
                         {number, "told_mm", "reported mm"},
                         {number, "straighten_ms", "undistort ms"},
                         {number, "find_ms", "detect ms"},
                         {number, "fit_ms", "fit ms"},
                         {number, "lag_ms", "lag ms"}});
  table.print_header();
  const Board tag = grid_board("tag", {1, 1, 0.08, 0.02, 7}), tablet = grid_board("tablet", {});
  std::vector<CameraTrial> trials = trials_of("tag", tag, 0.8);
  for (CameraTrial& trial : trials_of("tablet", tablet, 0.6)) trials.push_back(std::move(trial));
  if (!options.page.empty())
    for (CameraTrial& trial : page_trials(options.page)) trials.push_back(std::move(trial));
  std::set<std::string> begun;
  for (CameraTrial& trial : trials) {
    // Smoke test: one value of each parameter.
    if (options.quick && !begun.insert(trial.varied).second) continue;
    trial.what.places = options.quick ? 1 : 24;
    const ReportRow row = row_of(trial);
    table.print(row);
    report.add(row);
  }
  measure_faces(options.quick, [&](const ReportRow& row) {
    table.print(row);
    report.add(row);
  });
  if (!options.picture_folder.empty()) {
    draw_by_distance(report.rows()).write((options.picture_folder / "camera-distance.svg").string());
    draw_by_speed(report.rows()).write((options.picture_folder / "camera-speed.svg").string());
  }
  return report;
}

}  // namespace prosector
