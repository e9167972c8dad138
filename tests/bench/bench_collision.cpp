// Collision detection of sessions at all fidelities: cost, errors against the reference, scaling.

#include <cmath>
#include <utility>
#include <vector>

#include "common/scene_messages.h"

#include "tests/bench/collision_cases.h"
#include "tests/bench/collision_plot.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"

namespace prosector {
namespace {

using enum Column::Kind;

constexpr int most_cells = 64;  // cells along a sheet: finer ones have too many cells within the margin
constexpr std::array fidelities = {Fidelity::sphere, Fidelity::aabb, Fidelity::obb, Fidelity::hull,
                                   Fidelity::mesh};

/// Returns a text table for pairs: the columns `first`, the error columns, the columns `last`.
TextTable pair_table(std::vector<Column> first, const std::vector<Column>& last = {}) {
  first.insert(first.end(), {{percent, "false_hits", "false hits", 8},
                             {percent, "missed_hits", "missed", 8},
                             {percent, "depth_error", "depth error", 8},
                             {number, "normal_error_deg", "normal, deg", 8}});
  first.insert(first.end(), last.begin(), last.end());
  return TextTable(std::move(first));
}

void add_rigid_pairs(const CollisionBenchOptions& options, Report& report) {
  const TextTable table = pair_table({{text, "shape", "rigid pairs", 11},
                                      {text, "fidelity", "fidelity", 7},
                                      {number, "us_per_pair", "us/pair", 8}},
                                     {{count, "bytes_per_object", "bytes", 9}});
  table.print_header();
  for (const test::NamedParts& shape : test::shape_table()) {
    const RigidPairs pairs(shape, options.pairs);
    for (const Fidelity fidelity : fidelities) {
      report.add(pairs.measure(fidelity));
      table.print(report.rows().back());
    }
  }
}

void add_organ_pairs(const CollisionBenchOptions& options, Report& report) {
  const TextTable table = pair_table({{text, "shape", "organ with", 11},
                                      {text, "fidelity", "fidelity", 7},
                                      {number, "us_per_pair", "us/pair", 8}});
  table.print_header();
  for (const test::NamedParts& shape : test::shape_table())
    for (const Fidelity fidelity : fidelities) {
      report.add(measure_organ_and_rigid(fidelity, shape, options.pairs));
      table.print(report.rows().back());
    }
  const TextTable two =
      pair_table({{text, "fidelity", "two organs", 11}, {number, "us_per_pair", "us/pair", 8}});
  two.print_header();
  for (const Fidelity fidelity : fidelities) {
    report.add(measure_two_organs(fidelity, options.pairs));
    two.print(report.rows().back());
  }
}

void add_bodies(const CollisionBenchOptions& options, Report& report) {
  const TextTable table({{text, "fidelity", "fidelity", 8},
                         {count, "bodies", "bodies", 8},
                         {number, "ms_place", "ms update", 9},
                         {number, "ms_detect", "ms detect", 9},
                         {count, "contacts", "contacts", 9},
                         {number, "bytes_per_body", "bytes/body", 9}});
  table.print_header();
  for (const Fidelity fidelity : fidelities) {
    double last_ms = 0;
    for (double bodies = 100; bodies <= options.max_bodies * 1.01 && last_ms < options.limit_ms;
         bodies *= std::sqrt(10)) {
      report.add(measure_bodies(fidelity, static_cast<int>(std::lround(bodies)), options.ticks));
      table.print(report.rows().back());
      last_ms = figure(report.rows().back(), "ms_scene");
    }
  }
}

void add_surfaces(const CollisionBenchOptions& options, Report& report) {
  const TextTable table({{count, "triangles", "triangles", 9},
                         {number, "ms_build", "ms build", 9},
                         {number, "ms_refit", "refit", 9},
                         {number, "ms_apart", "near", 9},
                         {number, "ms_crossing", "deep", 9},
                         {number, "ms_list", "list self", 11},
                         {number, "ms_self", "itself", 9},
                         {number, "bytes_per_triangle", "bytes/triangle", 9}});
  table.print_header();
  for (int levels = 2; 8 << 2 * levels <= options.max_triangles * 4 / 3; ++levels) {
    report.add(measure_surface(levels, options.ticks));
    table.print(report.rows().back());
  }
}

void add_layers(const CollisionBenchOptions& options, Report& report) {
  const TextTable table({{count, "cells", "cells", 9},
                         {number, "ms_refit", "ms refit", 9},
                         {number, "ms_layers", "layers", 9},
                         {count, "meetings", "meetings", 9}});
  table.print_header();
  for (int cells = 8; cells <= most_cells && 2 * cells * cells <= options.max_triangles; cells *= 2) {
    report.add(measure_layers(cells, options.ticks));
    table.print(report.rows().back());
  }
}

void add_soft_sessions(const CollisionBenchOptions& options, Report& report) {
  const TextTable table({{count, "bodies", "soft bodies", 11},
                         {count, "all_pairs", "body pairs", 13},
                         {number, "ms_narrow", "ms detect", 12}});
  table.print_header();
  for (const int bodies : {10, 100, 1000}) {
    if (bodies > options.max_bodies) break;
    report.add(measure_soft_session(bodies, options.ticks));
    table.print(report.rows().back());
  }
}

}  // namespace

Report bench_collision(const CollisionBenchOptions& options) {
  Report report("collision");
  add_rigid_pairs(options, report);
  add_organ_pairs(options, report);
  add_bodies(options, report);
  add_surfaces(options, report);
  add_layers(options, report);
  add_soft_sessions(options, report);
  if (!options.picture_folder.empty())
    draw_collision(report.rows()).write(options.picture_folder + "/collision.svg");
  return report;
}

}  // namespace prosector
