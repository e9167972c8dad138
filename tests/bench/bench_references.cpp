// Reference solutions of the cases cube, slab, hang, press and organ of trade, and of refine's liver,
// recomputed on increasingly fine meshes, with the difference of each mesh from the stored reference.

#include <fmt/format.h>

#include <cmath>

#include "tests/bench/pressed_tissue.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"
#include "tests/bench/weighed_reference.h"

namespace prosector {
namespace {

constexpr std::array<std::uint32_t, 3> divisions = {2, 4, 8};
constexpr double layer_cells[] = {2.25e-3, 1.6e-3, 1.2e-3}, organ_cells[] = {8e-3, 4.5e-3, 3.2e-3},  // m
    liver_cells[] = {8e-3, 6e-3, 5e-3};

class Rows {
 public:
  explicit Rows(Report& report) : report_(report) { table_.print_header(); }
  void add(ReportRow row, const std::string& mesh, double off, double unsettled) {
    row.update({{"mesh", mesh}, {"element", "tet10"}, {"off", off}, {"unsettled", unsettled}});
    report_.add(std::move(row));
    table_.print(report_.rows().back());
  }

 private:
  Report& report_;
  TextTable table_{{{Column::Kind::text, "case", "case", 6},
                    {Column::Kind::text, "mesh", "mesh", 16},
                    {Column::Kind::percent, "off", "off", 9},
                    {Column::Kind::percent, "unsettled", "unsettled", 9},
                    {Column::Kind::number, "force_N", "force N", 8}}};
};

ReportRow row_of(const WeighedReference& which, const std::array<Vec3, weighed_places>& moved) {
  ReportRow row = {{"case", which.name}, {"moved_m", ReportRow::array()}};
  for (const Vec3& one : moved) row["moved_m"].push_back({one[0], one[1], one[2]});
  return row;
}

void find(const WeighedReference& which, bool quick, Rows& rows) {
  std::array<std::array<Vec3, weighed_places>, divisions.size()> moved;
  for (std::size_t i = 0; i < divisions.size(); ++i) {
    moved[i] = moved_at_rest(which, divisions[i]);
    const auto cells = [&](std::size_t axis) { return which.coarse[axis] * divisions[i]; };
    rows.add(row_of(which, moved[i]), fmt::format("{} × {} × {}", cells(0), cells(1), cells(2)),
             error_of(which, moved[i]), which.unsettled);
    if (quick) return;
  }
  const auto limit = extrapolated(moved);
  rows.add(row_of(which, limit), "extrapolated", error_of(which, limit), which.unsettled);
}

void find(const char* name, const PressedBody& body, std::span<const double> cells, bool quick, Rows& rows) {
  for (const double cell : cells.first(quick ? 1 : cells.size())) {
    const double force = force_at_rest(body, pressed_desc(body, cell));
    rows.add({{"case", name}, {"force_N", force}}, fmt::format("{} mm", three_digits(1e3 * cell)),
             force / body.force - 1, body.unsettled);
  }
}

}  // namespace

Report bench_references(const ReferenceBenchOptions& options) {
  Report report("references");
  Rows rows(report);
  const auto asked = [&](const char* name) { return options.only.empty() || options.only == name; };
  for (const WeighedReference& which : weighed_references())
    if (asked(which.name)) find(which, options.quick, rows);
  if (asked("press")) find("press", pressed_layer_body(), layer_cells, options.quick, rows);
  if (asked("organ")) find("organ", pressed_organ(), organ_cells, options.quick, rows);
  if (asked("liver")) find("liver", pressed_liver(), liver_cells, options.quick, rows);
  return report;
}

}  // namespace prosector
