// Runs every configuration under every extreme, and maps the verdicts.

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <cstdio>
#include <filesystem>

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

char letter(const StabilityResult& result) {
  if (!result.verdict) return '.';
  return "sdrF"[static_cast<std::size_t>(*result.verdict)];
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
      StabilityResult result;
      if (!extreme.is_for(rung.mesh)) {
        fmt::print("   ");
        map.cells.back().emplace_back();
        continue;
      }
      if (rung.rung.solver == "direct" && !extreme.for_direct) {
        result.reason = "not run: the factorisation takes minutes";
      } else {
        result = run_extreme(rung, extreme, options.limit_ms);
      }
      report.add(to_row(rung, extreme, result));
      fmt::print(" {}{}", letter(result), result.met_deadline ? ' ' : '\'');
      std::fflush(stdout);
      map.cells.back().push_back(
          result.verdict ? std::optional(VerdictCell{*result.verdict, result.met_deadline}) : std::nullopt);
      if (result.verdict != Verdict::survives)
        remarks += fmt::format("{}, {}: {}: {}\n", row_name(rung), extreme.name,
                               result.verdict ? verdict_name(*result.verdict) : "open", result.reason);
    }
    fmt::print("\n");
  }
  fmt::print("\n{}", remarks);
  if (!options.picture_folder.empty())
    draw(map).write((std::filesystem::path(options.picture_folder) / "stability.svg").string());
  return report;
}

}  // namespace prosector
