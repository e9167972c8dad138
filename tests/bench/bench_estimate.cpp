// Live error estimates of soft bodies against their true error, and the cost of the estimates.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "common/paths.h"
#include "common/scene/load_scene.h"
#include "server/accuracy/live_estimates.h"
#include "server/calibration/stopwatch.h"
#include "tests/bench/crowd.h"
#include "tests/bench/estimate_case.h"
#include "tests/bench/estimate_plot.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"

namespace prosector {
namespace {

constexpr double settling = 0.75, measured = 2;  // s
constexpr double depth = 0.02;                   // m, target depth of the middle fingertips
constexpr double telling = 0.01;                 // smaller true errors are not evaluated
constexpr double settled = 0.12;                 // largest uncertainty of an evaluated reference

/// Returns a row with the cost of the estimates, as a fraction of a step, while two hands press an organ.
nlohmann::ordered_json cost(const EstimateBenchOptions& options) {
  CompileOptions compile;
  compile.threads = 1;
  compile.data_dirs = {default_data_dir()};
  compile.cache_dir = default_cache_dir();
  Simulation simulation(load_scene(options.scene), compile);
  LiveEstimates estimates(simulation);
  const BodyId organ = pressed_body(simulation, "");
  const Crowd crowd(spread_places(simulation, organ, 2, 1), 1, 2, depth);
  const double h = 1 / simulation.scene().tick_rate;
  double step = 0, telling_ms = 0, most = 0;
  const int begin = static_cast<int>(settling / h), end = begin + static_cast<int>(measured / h);
  for (int tick = 0; tick < end; ++tick) {
    const TickInput input = crowd.act(tick, h);
    const double begun = cpu_ms();
    const StepReport& report = simulation.step(input);
    const double stepped = cpu_ms();
    estimates.follow(simulation, report);
    if (tick < begin) continue;
    step += stepped - begun;
    telling_ms += cpu_ms() - stepped;
    most = std::max(most, cpu_ms() - stepped);
  }
  const double ticks = end - begin;
  const LiveEstimate* told = estimates.newest(organ);
  fmt::print(
      "{}: CPU time per step {:.3g} ms, of the estimates {:.3g} ms ({:.2g} %), at most {:.3g} ms per tick\n",
      simulation.scene().name, step / ticks, telling_ms / ticks, 100 * telling_ms / step, most);
  if (told != nullptr)
    fmt::print("{}: estimated error {:.2g} %; force {:.3g} N, estimated error {:.2g} %\n",
               simulation.name(organ), 100 * told->error, told->press_force, 100 * told->press_error);
  return {{"scene", simulation.scene().name},  {"tets", tet_count(simulation)}, {"step_ms", step / ticks},
          {"estimate_ms", telling_ms / ticks}, {"share", telling_ms / step},    {"estimate_ms_most", most}};
}

/// Prints the number of estimates within the target range, for each element.
void sum_up(const std::vector<ReportRow>& rows, Report& report) {
  std::map<std::string, std::vector<double>> found;
  for (const ReportRow& row : rows)
    if (std::abs(figure(row, "error_continuum")) >= telling && std::abs(figure(row, "unsettled")) <= settled)
      found[fmt::format("{}, {}", setting(row, "element"),
                        setting(row, "act").starts_with("pressed") ? "pressed" : "by weight")]
          .push_back(figure(row, "effectivity"));
  for (auto& [group, values] : found) {
    std::sort(values.begin(), values.end());
    const auto kept = std::count_if(values.begin(), values.end(), [](double effectivity) {
      return effectivity >= least_effectivity && effectivity <= most_effectivity;
    });
    fmt::print("{}: {} of {} between {} and {}; minimum {:.2f}, median {:.2f}, maximum {:.2f}\n", group, kept,
               values.size(), least_effectivity, most_effectivity, values.front(), values[values.size() / 2],
               values.back());
    report.note(group, {{"kept", kept},
                        {"cases", values.size()},
                        {"least", values.front()},
                        {"median", values[values.size() / 2]},
                        {"most", values.back()}});
  }
}

}  // namespace

Report bench_estimate(const EstimateBenchOptions& options) {
  using enum Column::Kind;
  Report report("estimate");
  const TextTable table({{text, "case", "case", 6},
                         {text, "act", "act", 17},
                         {number, "poisson_ratio", "ratio", 6},
                         {text, "model", "model", 17},
                         {text, "element", "element", 7},
                         {count, "tets", "tets", 6},
                         {percent, "error_continuum", "true", 8},
                         {percent, "unsettled", "unsettled", 9},
                         {percent, "estimate", "estimate", 8},
                         {percent, "discretisation", "mesh", 8},
                         {percent, "model_part", "law", 8},
                         {number, "effectivity", "times", 7},
                         {number, "us_per_tet", "us per tet", 8}});
  table.print_header();
  for (const EstimateCase& one : estimate_cases(options.quick)) {
    if (!options.only.empty() && one.name != options.only) continue;
    for (const ReportRow& row : judged(one)) {
      report.add(row);
      table.print(row);
    }
  }
  sum_up(report.rows(), report);
  if (!options.scene.empty()) report.note("cost", cost(options));
  if (!options.picture_folder.empty())
    draw_estimates(report.rows())
        .write((std::filesystem::path(options.picture_folder) / "estimate.svg").string());
  return report;
}

}  // namespace prosector
