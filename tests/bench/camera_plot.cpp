#include "tests/bench/camera_plot.h"

#include <algorithm>

#include "tests/bench/line_plot.h"

namespace prosector {
namespace {

std::vector<ReportRow> rows_of(const std::vector<ReportRow>& rows, const std::string& varied) {
  std::vector<ReportRow> out;
  std::copy_if(rows.begin(), rows.end(), std::back_inserter(out),
               [&](const ReportRow& row) { return setting(row, "varied") == varied; });
  return out;
}

}  // namespace

Svg draw_by_distance(const std::vector<ReportRow>& rows) {
  return draw_lines(
      rows_of(rows, "distance m"), "board", {0.25, 2, true, {0.3, 0.4, 0.6, 0.8, 1.2, 1.8}},
      {0.003, 10, true, {0.003, 0.01, 0.03, 0.1, 0.3, 1, 3, 10}},
      {"How far off boards are found along the axis",
       "640 × 480, focal length 600 px, tilts to 50°, noise 3 of 255; medians", "distance, m", "mm"},
      [](const ReportRow& row) { return figure(row, "value"); },
      [](const ReportRow& row) { return figure(row, "depth_mm"); });
}

Svg draw_by_speed(const std::vector<ReportRow>& rows) {
  return draw_lines(
      rows_of(rows, "speed m/s, 10 ms exposed"), "board", {0, 0.8, false, {0, 0.2, 0.4, 0.6, 0.8}},
      {0, 1, false, {0, 0.25, 0.5, 0.75, 1}},
      {"How often boards are found in one blurred picture",
       "10 ms of exposure; the tag at 0.8 m, the tablet at 0.6 m; without what went before",
       "speed across the picture, m/s", "share found"},
      [](const ReportRow& row) { return figure(row, "value"); },
      [](const ReportRow& row) { return figure(row, "seen"); });
}

}  // namespace prosector
