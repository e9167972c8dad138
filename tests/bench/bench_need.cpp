// Choice of model configuration by accuracy: the server's choice for each soft body of a scene and several
// accuracies, with cost and error on the body itself.

#include <fmt/format.h>

#include "common/scene/load_scene.h"
#include "server/calibration/accuracy_change.h"
#include "server/physics/stations/compile/sources.h"
#include "tests/bench/bench_choice.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"

namespace prosector {
namespace {

constexpr double asked[] = {30, 10, 5, 3, 1};  // %

ReportRow row_of(const Choice& choice, double percent) {
  ReportRow row = {{"body", choice.body},
                   {"asked", percent / 100},
                   {"model", choice.rung.model},
                   {"element", choice.rung.element},
                   {"solver", choice.rung.solver},
                   {"effort", choice.rung.effort()},
                   {"cell_mm", 1e3 * choice.cell},
                   {"error", choice.expected.error},
                   {"ms_per_frame", choice.expected.ms},
                   {"kept", choice.good_enough ? "yes" : "no"}};
  for (const ActError& act : choice.acts) row["acts"][act.act] = act.error;
  row["worst_act"] = choice.acts.empty() ? "" : worst(choice.acts).act;
  return row;
}

}  // namespace

Report bench_need(const NeedBenchOptions& options) {
  Report report("need");
  const TextTable table({{Column::Kind::text, "body", "body", 12},
                         {Column::Kind::percent, "asked", "requested", 9},
                         {Column::Kind::percent, "error", "expected", 9},
                         {Column::Kind::text, "kept", "met", 4},
                         {Column::Kind::number, "ms_per_frame", "ms per frame", 10},
                         {Column::Kind::text, "worst_act", "worst", 18},
                         {Column::Kind::text, "model", "model", 17},
                         {Column::Kind::text, "element", "element", 7},
                         {Column::Kind::text, "solver", "solver", 9},
                         {Column::Kind::number, "cell_mm", "cell, mm", 8}});
  table.print_header();
  RungMeter meter;
  ChoiceOptions choice = choice_options(options.cache, meter);
  for (const std::string& folder : options.data) choice.sources.data_dirs.emplace_back(folder);
  if (options.verbose) choice.sources.progress = [](const std::string& line) { fmt::print("  {}\n", line); };
  const SceneDesc scene = whole_scene(load_scene(options.scene), choice.sources);
  for (const SoftDesc& desc : scene.soft) {
    if (!desc.geometry.is_solid() || (!options.body.empty() && desc.name != options.body)) continue;
    const AccuracyChange dial(scene, desc.name, choice);
    for (const double percent : asked) {
      const ReportRow row = row_of(dial.choose(percent), percent);
      table.print(row);
      report.add(row);
    }
  }
  return report;
}

}  // namespace prosector
