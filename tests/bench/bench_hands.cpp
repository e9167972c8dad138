// Hand tracking on rendered images of the project's skinned hand: detection rate, errors of points, pose and
// flexion, and CPU time per image.

#include <fmt/format.h>

#include <cmath>

#include "common/error.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"
#include "tests/gesture_bends.h"
#include "tests/hands/hand_trial.h"

namespace prosector {
namespace {

constexpr unsigned first_seed = 101;
constexpr double degrees = 57.29577951308232;

/// Combines the trials of several sequences.
void add_trial(HandTrial& all, const HandTrial& one) {
  all.pictures += one.pictures;
  all.seen += one.seen;
  all.views += one.views;
  all.right_points += one.right_points;
  all.right_side += one.right_side;
  all.sure += one.sure;
  all.palm_runs += one.palm_runs;
  for (const auto list : {&HandTrial::points, &HandTrial::lateral, &HandTrial::depth, &HandTrial::turn,
                          &HandTrial::flexion, &HandTrial::find_ms, &HandTrial::fit_ms})
    (all.*list).add(one.*list);
}

double share(std::size_t part, std::size_t all) {
  return all == 0 ? std::nan("") : static_cast<double>(part) / static_cast<double>(all);
}

ReportRow row_of(const std::string& what, HandNets nets, std::size_t cameras, const HandTrial& t) {
  return {{"trial", what},
          {"nets", nets == HandNets::full ? "full" : "lite"},
          {"cameras", cameras},
          {"pictures", t.pictures},
          {"seen", share(t.seen, t.pictures)},
          {"right_points", share(t.right_points, t.views)},
          {"right_side", share(t.right_side, t.seen)},
          {"sure", share(t.sure, t.pictures)},
          {"palm_runs", t.palm_runs},
          {"points_median", t.points.at(0.5)},
          {"points_mean", t.points.mean()},
          {"points_95", t.points.at(0.95)},
          {"lateral_mm", 1e3 * t.lateral.at(0.5)},
          {"depth_mm", 1e3 * t.depth.at(0.5)},
          {"depth_95_mm", 1e3 * t.depth.at(0.95)},
          {"turn_deg", degrees * t.turn.at(0.5)},
          {"flexion_median", t.flexion.at(0.5)},
          {"flexion_95", t.flexion.at(0.95)},
          {"find_ms", t.find_ms.at(0.5)},
          {"fit_ms", t.fit_ms.at(0.5)}};
}

/// Adds rows with the confusion matrix of gestures: fractions of each gesture's images.
void tell_gestures(HandNets nets, const GestureTrial& trial, Report& report) {
  using enum Column::Kind;
  std::vector<Column> columns = {
      {text, "trial", "made", 12}, {text, "nets", "nets"}, {percent, "none", "none"}};
  for_gestures([&](const GestureRow& row) { columns.push_back({percent, row.name, row.name}); });
  const TextTable table(columns);
  table.print_header();
  for_gestures([&](const GestureRow& made) {
    HandTrial nothing;
    nothing.pictures = trial.pictures_of(made.gesture);
    ReportRow row = row_of(made.name, nets, 1, nothing);
    row["right_gesture"] = trial.right_share(made.gesture);
    for (const GestureRow& told : gesture_table()) {
      const auto& all = trial.told.at(made.gesture);
      const auto count = all.find(told.gesture);
      row[told.name] = share(count == all.end() ? 0 : count->second, nothing.pictures);
    }
    table.print(row);
    report.add(row);
  });
  fmt::print("side correct: {:.1f} %\n", 100 * share(trial.right_side, trial.pictures));
}

}  // namespace

Report bench_hands(const HandsBenchOptions& options) {
  const std::filesystem::path nets = fetched_nets();
  if (nets.empty()) throw InputError("hand networks missing: run deploy/fetch_models.sh");
  const HandPainter painter;
  Report report("hands");
  using enum Column::Kind;
  const TextTable table({{text, "trial", "trial", 8},
                         {text, "nets", "nets"},
                         {count, "cameras", "cameras"},
                         {percent, "seen", "seen"},
                         {percent, "right_points", "points correct"},
                         {percent, "right_side", "side correct"},
                         {percent, "sure", "confident"},
                         {percent, "points_median", "point error"},
                         {number, "lateral_mm", "lateral mm"},
                         {number, "depth_mm", "depth mm"},
                         {number, "turn_deg", "rotation deg"},
                         {number, "flexion_median", "flexion"},
                         {number, "find_ms", "detect ms"},
                         {number, "fit_ms", "fit ms"}});
  table.print_header();
  const auto tell = [&](const ReportRow& row) {
    table.print(row);
    report.add(row);
  };
  const std::size_t views = options.quick ? 10 : 100, sequences = options.quick ? 1 : 4,
                    length = options.quick ? 10 : 90;
  for (const HandNets size : {HandNets::lite, HandNets::full}) {
    tell(row_of("first", size, 1, first_sight(nets, size, painter, views, first_seed)));
    for (const std::size_t cameras : {1u, 2u}) {
      HandTrial all;
      for (unsigned k = 0; k < sequences; ++k)
        add_trial(all, followed_hand(nets, size, painter, length, cameras, first_seed + k));
      tell(row_of("followed", size, cameras, all));
    }
  }
  for (const HandNets size : {HandNets::lite, HandNets::full})
    tell_gestures(size, made_gestures(nets, size, painter, options.quick ? 1 : 10, first_seed), report);
  return report;
}

}  // namespace prosector
