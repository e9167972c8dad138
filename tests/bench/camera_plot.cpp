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
      {"Depth error of detected boards",
       "640 × 480, focal length 600 px, tilts to 50°, noise 3 of 255; medians", "distance, m", "mm"},
      [](const ReportRow& row) { return figure(row, "value"); },
      [](const ReportRow& row) { return figure(row, "depth_mm"); });
}

Svg draw_by_speed(const std::vector<ReportRow>& rows) {
  return draw_lines(
      rows_of(rows, "speed m/s, 10 ms exposed"), "board", {0, 0.8, false, {0, 0.2, 0.4, 0.6, 0.8}},
      {0, 1, false, {0, 0.25, 0.5, 0.75, 1}},
      {"Detection rate of boards in a single blurred image",
       "10 ms exposure; tag at 0.8 m, tablet at 0.6 m; each image alone",
       "speed parallel to the image plane, m/s", "detection rate"},
      [](const ReportRow& row) { return figure(row, "value"); },
      [](const ReportRow& row) { return figure(row, "seen"); });
}

}  // namespace prosector
