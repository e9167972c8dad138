// The balls of pressed_tissue.h are pressed in, held, and moved sideways: force and cost with uniform meshes,
// and with local refinement that follows the ball.

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <span>

#include "server/calibration/stopwatch.h"
#include "tests/bench/machine.h"
#include "tests/bench/pressed_tissue.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"
#include "tests/bench/trade_plot.h"

namespace prosector {
namespace {

constexpr int down_ticks = 30, held_ticks = 60, drawn_ticks = 60;
constexpr int last_ticks = 10;  // last ticks of holding, over which the force is averaged
constexpr double way = 0.012;   // m, length of the sideways motion

/// A mesh configuration of the body.
struct Modelled {
  const char* element;
  double cell;         // m
  double refine_cell;  // m; 0: not refined
};

constexpr double mm = 1e-3;
constexpr Modelled layer_ways[] = {{"tet4", 10 * mm, 0},
                                   {"tet4", 10 * mm, 5 * mm},
                                   {"tet4", 10 * mm, 2.5 * mm},
                                   {"tet4", 20. / 3 * mm, 0},
                                   {"tet4", 20. / 3 * mm, 10. / 3 * mm},
                                   {"tet4", 5 * mm, 0},
                                   {"tet4", 10. / 3 * mm, 0},
                                   {"tet10", 10 * mm, 0},
                                   {"tet10", 20. / 3 * mm, 0},
                                   {"tet10", 5 * mm, 0}};
constexpr Modelled organ_ways[] = {
    {"tet4", 16 * mm, 0},       {"tet4", 16 * mm, 8 * mm}, {"tet4", 16 * mm, 4 * mm},
    {"tet4", 32. / 3 * mm, 0},  {"tet4", 12 * mm, 6 * mm}, {"tet4", 12 * mm, 3 * mm},
    {"tet4", 8 * mm, 0},        {"tet4", 16. / 3 * mm, 0}, {"tet10", 16 * mm, 0},
    {"tet10", 32. / 3 * mm, 0}, {"tet10", 8 * mm, 0}};

constexpr Modelled liver_ways[] = {
    {"tet4", 25 * mm, 0},      {"tet4", 25 * mm, 6 * mm}, {"tet4", 25 * mm, 4 * mm},
    {"tet4", 20 * mm, 5 * mm}, {"tet4", 16 * mm, 0},      {"tet4", 16 * mm, 8 * mm},
    {"tet4", 16 * mm, 4 * mm}, {"tet10", 25 * mm, 0},     {"tet10", 16 * mm, 0}};

struct Pressed {
  double force = 0;             // N, static
  double off_trend = 0;         // largest deviation from the trend while sliding, over the force
  double from_tick = 0;         // largest change per tick while sliding, over the force
  double ms = 0, ms_drawn = 0;  // median CPU time of a tick, static and sliding
  double ms_changed = 0;        // largest CPU time of ticks that changed the mesh
  std::size_t tets = 0;         // largest number
};

/// Returns the largest relative deviation of the forces from their best-fit cubic.
double off_slow_trend(const std::vector<double>& forces) {
  constexpr Eigen::Index terms = 4;
  const auto count = static_cast<Eigen::Index>(forces.size());
  const Eigen::Map<const VecX> force(forces.data(), count);
  Eigen::MatrixXd powers(count, terms);
  const VecX along = VecX::LinSpaced(count, -1, 1);
  for (Eigen::Index k = 0; k < terms; ++k) powers.col(k) = along.array().pow(static_cast<double>(k));
  const VecX trend = powers * powers.colPivHouseholderQr().solve(force);
  return ((force - trend).array() / trend.array()).abs().maxCoeff();
}

/// Returns the largest relative change between successive forces.
double most_from_tick_to_tick(const std::vector<double>& forces) {
  double most = 0;
  for (std::size_t i = 1; i < forces.size(); ++i)
    most = std::max(most, std::abs(forces[i] / forces[i - 1] - 1));
  return most;
}

Pressed press(const PressedBody& body, const Modelled& modelled, const RefineBenchOptions& options) {
  SoftDesc desc = pressed_desc(body, modelled.cell, modelled.refine_cell);
  desc.configuration.element = modelled.element;
  desc.contact.points = options.contact == "surface" ? ContactPoints::surface : ContactPoints::vertices;
  PressedTissue tissue(body, desc, {.threads = options.threads});
  Pressed out;
  std::vector<double> held, drawn, forces;  // ms, ms, N while sliding
  for (int tick = 1; tick <= down_ticks + held_ticks + drawn_ticks; ++tick) {
    const double down = std::min(1.0, tick / double{down_ticks});
    const double along = std::max(0, tick - down_ticks - held_ticks) / double{drawn_ticks};
    const std::uint64_t changes = tissue.simulation().rehung(1);
    const double begin = cpu_ms();
    tissue.press(body.depth * down, way * along);
    const double took = cpu_ms() - begin;
    out.tets = std::max(out.tets, tissue.tets());
    if (tissue.simulation().rehung(1) != changes) out.ms_changed = std::max(out.ms_changed, took);
    const double force = tissue.force();
    if (tick > down_ticks + held_ticks) {
      drawn.push_back(took);
      forces.push_back(force);
    } else if (tick > down_ticks) {
      held.push_back(took);
      if (tick > down_ticks + held_ticks - last_ticks) out.force += force / last_ticks;
    }
  }
  out.ms = median(held);
  out.ms_drawn = median(drawn);
  out.off_trend = off_slow_trend(forces);
  out.from_tick = most_from_tick_to_tick(forces);
  return out;
}

constexpr const char* linear = "linear elements";
constexpr const char* quadratic = "quadratic elements";
constexpr const char* following = "linear elements, locally refined";

std::string way_of(const Modelled& modelled) {
  if (modelled.refine_cell > 0) return following;
  return modelled.element == std::string("tet10") ? quadratic : linear;
}

ReportRow row_of(const PressedBody& body, const Modelled& modelled, const Pressed& pressed,
                 const RefineBenchOptions& options) {
  return {{"body", body.name},
          {"way", way_of(modelled)},
          {"element", modelled.element},
          {"contact", options.contact},
          {"threads", options.threads},
          {"cell_mm", 1e3 * modelled.cell},
          {"refine_cell_mm", 1e3 * modelled.refine_cell},
          {"tets_at_most", pressed.tets},
          {"force_mN", 1e3 * pressed.force},
          {"error_continuum", pressed.force / body.force - 1},
          {"off_trend", pressed.off_trend},
          {"from_tick_to_tick", pressed.from_tick},
          {"cpu_ms_held", pressed.ms},
          {"cpu_ms_drawn", pressed.ms_drawn},
          {"cpu_ms_changed", pressed.ms_changed}};
}

std::string label_of(const ReportRow& row) {
  const double refined = figure(row, "refine_cell_mm");
  return fmt::format(
      "{} of {} mm{}, {:.0f} tetrahedra", setting(row, "element") == "tet10" ? "quadratic" : "linear",
      three_digits(figure(row, "cell_mm")),
      refined > 0 ? fmt::format(", {} mm refined", three_digits(refined)) : "", figure(row, "tets_at_most"));
}

Svg picture_of(const PressedBody& body, const Report& report) {
  TradePlot plot;
  plot.title = fmt::format("A ball pressed {:.0f} mm into {}, with and without local refinement",
                           1e3 * body.depth, body.called);
  const auto where = machine();
  plot.subtitle =
      fmt::format("{}, load {:.1f}. Static force against the reference; cost while the ball slides.",
                  where["cpu"].get<std::string>(), where["load_average"].get<double>());
  plot.cost_label = "CPU ms per tick (real time: 16.7)";
  plot.error_label = "force error";
  plot.error_floor = body.unsettled / 10;
  plot.fronts = {{"Pareto front without refinement", {linear, quadratic}},
                 {"Pareto front with refinement", {}}};
  for (const ReportRow& row : report.rows())
    if (setting(row, "body") == body.name)
      plot.points.push_back(
          {figure(row, "cpu_ms_drawn"), figure(row, "error_continuum"), setting(row, "way"), label_of(row)});
  return draw(plot);
}

}  // namespace

Report bench_refine(const RefineBenchOptions& options) {
  using enum Column::Kind;
  const TextTable table({{text, "body", "body", 6},
                         {text, "way", "way", 38},
                         {number, "cell_mm", "cell, mm"},
                         {number, "refine_cell_mm", "refined, mm"},
                         {count, "tets_at_most", "max. tets"},
                         {number, "force_mN", "force, mN"},
                         {percent, "error_continuum", "error"},
                         {percent, "off_trend", "off trend"},
                         {percent, "from_tick_to_tick", "per tick"},
                         {number, "cpu_ms_held", "CPU ms static"},
                         {number, "cpu_ms_drawn", "CPU ms sliding"},
                         {number, "cpu_ms_changed", "mesh change ms"}});
  table.print_header();
  Report report("refine");
  const auto run = [&](const PressedBody& body, std::span<const Modelled> ways) {
    if (!options.only.empty() && options.only != body.name) return;
    for (const Modelled& modelled : ways.first(options.quick ? 2 : ways.size())) {
      report.add(row_of(body, modelled, press(body, modelled, options), options));
      table.print(report.rows().back());
    }
    if (!options.picture_folder.empty())
      picture_of(body, report)
          .write(std::filesystem::path(options.picture_folder) / fmt::format("refine-{}.svg", body.name));
  };
  run(pressed_layer_body(), layer_ways);
  run(pressed_organ(), organ_ways);
  run(pressed_liver(), liver_ways);
  return report;
}

}  // namespace prosector
