// Error against cost: configuration × resolution × step × iterations over the test cases, with Bullet.

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "common/error.h"
#include "tests/bench/bullet_specimen.h"
#include "tests/bench/earlier_reports.h"
#include "tests/bench/machine.h"
#include "tests/bench/memory.h"
#include "tests/bench/pressed_case.h"
#include "tests/bench/recommendation.h"
#include "tests/bench/rung_report.h"
#include "tests/bench/stable_step.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"
#include "tests/bench/trade_case.h"
#include "tests/bench/trade_plot.h"
#include "tests/bench/trade_sweep.h"

namespace prosector {
namespace {

/// Returns the columns of a case's table: settings, cost, figures.
TextTable table_for(const TradeCase& which) {
  using enum Column::Kind;
  std::vector<Column> columns = {{text, "model", "model", 29},
                                 {text, "element", "element", 5},
                                 {text, "integrator", "integrator", 17},
                                 {text, "solver", "solver", 9},
                                 {text, "effort", "effort", 15},
                                 {count, "tets", "tets", 6},
                                 {number, "dt_ms", "dt ms", 6},
                                 {number, "ms_per_frame", "ms/frame", 8},
                                 {number, "ms_per_simulated_s", "ms/sim s", 8},
                                 {number, "memory_kib", "KiB", 7},
                                 {percent, which.error_key, "error", 9}};
  const std::string name = which.name;
  if (name == "swing") {
    columns.push_back({percent, "error_frequency", "frequency", 9});
    columns.push_back({percent, "amplitude_lost_per_period", "amplitude", 9});
    columns.push_back({number, "phase_lag_per_period_rad", "lag rad", 8});
    columns.push_back({number, "largest_stable_step_s", "max dt s", 8});
  }
  if (name == "swing" || name == "free") columns.push_back({percent, "energy_drift", "energy", 9});
  if (name == "free") columns.push_back({percent, "momentum_drift", "momentum", 9});
  if (which.pressed)
    columns.push_back({number, "force_N", "force N", 8});
  else if (name != "swing")
    columns.push_back({percent, "volume_loss", "volume", 9});
  columns.push_back({text, "remark", "", 0});
  return TextTable(columns);
}

/// Creates a specimen with `make` and runs `measure` on it with the row and a runner. Both may throw
/// InputError to refuse the configuration.
template <class Make, class Measure>
ReportRow run_one(const TradeCase& which, double dt, double limit_ms, ReportRow row, const Make& make,
                  const Measure& measure) {
  row["dt"] = dt;
  row["dt_ms"] = 1e3 * dt;
  try {
    const std::size_t before = allocated_bytes();
    const auto body = make();
    Runner runner(*body, dt, which.gravity, limit_ms);
    measure(*body, row, runner);
    row.update(runner.figures());
    if (which.judge) which.judge(row);
    row["memory_kib"] = static_cast<double>(allocated_bytes() - before) / 1024;
    if (!runner.finite())
      row["remark"] = "became non-finite";
    else if (!row.contains(which.error_key))
      row["remark"] = "stopped: over the time limit";
    else if (row.contains("reported"))
      row["remark"] = row["reported"];
  } catch (const InputError& error) {
    row["remark"] = std::string("refused: ") + error.what();
  }
  return row;
}

/// Runs a piece of tissue with a configuration of ours or Bullet's.
template <class Trial>
ReportRow run_piece(const TradeCase& which, const Trial& trial, double limit_ms, ReportRow row) {
  const TestPiece piece = which.piece(trial.cells);
  row["tets"] = piece.mesh.tets.size();
  row["nodes"] = piece.mesh.positions.size();
  return run_one(
      which, trial.dt, limit_ms, row, [&] { return make_specimen(trial.rung, piece); },
      [&](Specimen& specimen, ReportRow& out, Runner& runner) {
        out["nodes"] = specimen.node_mass().size();
        out.update(which.measure(specimen, piece, out["model"], runner));
      });
}

ReportRow run_press(const TradeCase& which, const Trial& trial, double limit_ms, ReportRow row) {
  return run_one(
      which, trial.dt, limit_ms, row,
      [&] { return make_pressed(*which.pressed, trial.rung, trial.cells, trial.dt); },
      [&](PressedSpecimen& specimen, ReportRow& out, Runner& runner) {
        out["tets"] = specimen.tissue().tets();
        out["nodes"] = specimen.nodes();
        out.update(measure_press(specimen, runner));
      });
}

TradePlot plot_for(const TradeCase& which, const Report& report) {
  TradePlot plot;
  plot.title = which.title;
  const auto where = machine();
  plot.subtitle =
      fmt::format("{}, one thread. Marks on an edge are out of range.", where["cpu"].get<std::string>());
  plot.cost_label = "CPU ms per simulated second (real time: 1000)";
  plot.error_label = which.error_label;
  for (const ReportRow& row : report.rows()) {
    if (setting(row, "case") != which.name) continue;
    plot.points.push_back({figure(row, "ms_per_simulated_s"), figure(row, which.error_key),
                           setting(row, "model") + ", " + setting(row, "element"), in_words(row)});
  }
  return plot;
}

/// Returns the rows of earlier reports that belong to this case.
void take_rows(const TradeCase& which, const std::vector<ReportRow>& earlier, Report& report) {
  for (const ReportRow& one : earlier)
    for (ReportRow row : one["rows"]) {
      if (setting(row, "case") != which.name) continue;
      if (which.judge) which.judge(row);
      report.add(std::move(row));
    }
}

}  // namespace

Report bench_trade(const TradeBenchOptions& options) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  Report report("trade");
  const std::vector<ReportRow> earlier = read_reports("trade", options.from);
  if (!earlier.empty()) report.note("measured", origins(earlier));
  std::map<std::string, double> stable_steps;  // s, per configuration
  const auto stable_step = [&](const auto& rung) {
    const ReportRow row = settings(rung);
    std::string key;
    for (const char* name : {"model", "element", "integrator", "solver", "effort"})
      key += setting(row, name) + " ";
    const auto [at, is_new] = stable_steps.try_emplace(key);
    if (is_new)
      at->second = largest_stable_step([&](const TestPiece& piece) { return make_specimen(rung, piece); });
    return at->second;
  };
  for (const TradeCase* which : trade_cases()) {
    if (!options.only.empty() && options.only != which->name) continue;
    take_rows(*which, earlier, report);
    const bool is_swing = which == &swing_case();
    fmt::print("\n{}: {}\n", which->name, which->title);
    const TextTable table = table_for(*which);
    table.print_header();
    const auto run = [&](const auto& trial) {
      if (!options.model.empty() && options.model != trial.rung.model) return;
      ReportRow row = {{"case", which->name}};
      row.update(settings(trial.rung));
      row["threads"] = 1;
      if (is_swing) row["largest_stable_step_s"] = stable_step(trial.rung);
      if constexpr (std::is_same_v<std::decay_t<decltype(trial)>, Trial>)
        row = which->pressed ? run_press(*which, trial, options.limit_ms, row)
                             : run_piece(*which, trial, options.limit_ms, row);
      else
        row = run_piece(*which, trial, options.limit_ms, row);
      table.print(row);
      report.add(std::move(row));
    };
    if (earlier.empty()) {
      for (const Trial& trial : trials(*which, options.quick)) run(trial);
      for (const BulletTrial& trial : bullet_trials(*which, options.quick)) run(trial);
    }
    const bool any = std::any_of(report.rows().begin(), report.rows().end(),
                                 [&](const ReportRow& row) { return setting(row, "case") == which->name; });
    if (any && !options.picture_folder.empty()) {
      const auto file =
          std::filesystem::path(options.picture_folder) / fmt::format("trade-{}.svg", which->name);
      draw(plot_for(*which, report)).write(file.string());
    }
  }
  const std::vector<std::string> advice = recommend(report.rows());
  fmt::print("\nOn this machine, one thread:\n");
  for (const std::string& line : advice) fmt::print("  {}\n", line);
  report.note("recommendation", advice);
  return report;
}

}  // namespace prosector
