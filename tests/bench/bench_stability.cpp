// Runs every configuration under every extreme, and maps the verdicts.

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cstdio>
#include <filesystem>

#include "tests/bench/earlier_reports.h"
#include "tests/bench/machine.h"
#include "tests/bench/rung_report.h"
#include "tests/bench/stability_run.h"
#include "tests/bench/stability_rungs.h"
#include "tests/bench/subjects.h"
#include "tests/bench/verdict_map.h"

namespace prosector {
namespace {

ReportRow to_row(const StabilityRung& rung, const Extreme& extreme, const StabilityResult& result) {
  ReportRow row = settings(rung.rung);
  if (is_fabric(rung.mesh)) row["element"] = mesh_name(rung.mesh);
  row["threads"] = 1;
  row["tets"] = result.tets;
  row["nodes"] = result.nodes;
  row["dt"] = extreme.dt;
  row["extreme"] = extreme.name;
  if (result.verdict)
    row["verdict"] = verdict_name(*result.verdict);
  else
    row["verdict"] = nullptr;
  row["reason"] = result.reason;
  row["met_deadline"] = result.met_deadline;
  row["ms_per_frame"] = result.ms_per_frame;
  row["steps_per_s"] = result.steps_per_s;
  row["worst_ms_per_frame"] = result.worst_ms_per_frame;
  row["energy_excess"] = result.energy_excess;
  row["shape_error_m"] = result.shape_error;
  row["back_after_s"] = result.back_after_s;
  row["steps"] = result.steps;
  row["steps_not_converged"] = result.steps_not_converged;
  row["resets"] = result.resets;
  row["steps_refused"] = result.refusals;
  row["steps_degraded"] = result.losses;
  row["steps_guarded"] = result.guarded;
  row["recoveries"] = result.recoveries;
  row["residual"] = result.residual;
  return row;
}

constexpr Verdict verdicts[] = {Verdict::survives, Verdict::degrades, Verdict::refuses, Verdict::fails};

/// Returns a row's place in the map; none if the run has no verdict.
std::optional<VerdictCell> cell_of(const ReportRow& row) {
  for (const Verdict verdict : verdicts)
    if (setting(row, "verdict") == verdict_name(verdict))
      return VerdictCell{verdict, row.at("met_deadline").get<bool>()};
  return std::nullopt;
}

char letter(const std::optional<VerdictCell>& cell) {
  return cell ? "sdrF"[static_cast<std::size_t>(cell->verdict)] : '.';
}

ReportRow measured(const StabilityRung& rung, const Extreme& extreme, double limit_ms) {
  StabilityResult result;
  if (rung.rung.solver == "direct" && !extreme.for_direct)
    result.reason = "not run: the factorisation takes minutes";
  else
    result = run_extreme(rung, extreme, limit_ms);
  return to_row(rung, extreme, result);
}

/// Returns the row of earlier reports with this configuration and extreme; none: it was not run.
std::optional<ReportRow> found(const std::vector<ReportRow>& earlier, const StabilityRung& rung,
                               const Extreme& extreme) {
  const ReportRow wanted = to_row(rung, extreme, {});
  for (const ReportRow& report : earlier)
    for (const ReportRow& row : report["rows"]) {
      const auto same = [&](const char* key) { return setting(row, key) == setting(wanted, key); };
      if (same("model") && same("element") && same("integrator") && same("solver") && same("effort") &&
          same("extreme"))
        return row;
    }
  return std::nullopt;
}

}  // namespace

std::vector<std::string> extreme_names() {
  std::vector<std::string> names;
  for (const Extreme& extreme : extremes()) names.push_back(extreme.name);
  return names;
}

Report bench_stability(const StabilityBenchOptions& options) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  Report report("stability");
  const std::vector<ReportRow> earlier = read_reports("stability", options.from);
  if (!earlier.empty()) report.note("measured", origins(earlier));
  VerdictMap map;
  map.title = "Verdicts of the extremes, by configuration";
  map.subtitle = fmt::format("{}, one thread, each configuration with a scene's default budget",
                             machine()["cpu"].get<std::string>());
  std::vector<Extreme> chosen;
  for (const Extreme& extreme : extremes()) {
    if (!options.extreme.empty() && options.extreme != extreme.name) continue;
    if (options.quick && !extreme.cheap) continue;
    chosen.push_back(extreme);
    map.extremes.emplace_back(extreme.name);
  }
  fmt::print(
      "s survives, d degrades with a report, r refuses, F fails, . not completed; ' missed deadlines\n");
  for (std::size_t i = 0; i < map.extremes.size(); ++i) fmt::print("{:>3} {}\n", i + 1, map.extremes[i]);
  std::string remarks;
  for (const StabilityRung& rung : stability_rungs(options.model)) {
    map.rungs.push_back(row_name(rung));
    map.cells.emplace_back();
    fmt::print("{:<60}", row_name(rung));
    for (const Extreme& extreme : chosen) {
      if (!extreme.is_for(rung.mesh)) {
        fmt::print("   ");
        map.cells.back().emplace_back();
        continue;
      }
      const std::optional<ReportRow> row = earlier.empty()
                                               ? std::optional(measured(rung, extreme, options.limit_ms))
                                               : found(earlier, rung, extreme);
      const std::optional<VerdictCell> cell = row ? cell_of(*row) : std::nullopt;
      if (row) report.add(*row);
      fmt::print(" {}{}", letter(cell), cell && !cell->met_deadline ? '\'' : ' ');
      std::fflush(stdout);
      map.cells.back().push_back(cell);
      if (row && (!cell || cell->verdict != Verdict::survives))
        remarks += fmt::format("{}, {}: {}: {}\n", row_name(rung), extreme.name,
                               cell ? verdict_name(cell->verdict) : "open", setting(*row, "reason"));
    }
    fmt::print("\n");
  }
  fmt::print("\n{}", remarks);
  if (!options.picture_folder.empty())
    draw(map).write((std::filesystem::path(options.picture_folder) / "stability.svg").string());
  return report;
}

}  // namespace prosector
