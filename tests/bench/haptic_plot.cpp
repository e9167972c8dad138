#include "tests/bench/haptic_plot.h"

#include "tests/bench/line_plot.h"

namespace prosector {
Svg draw_stable_stiffness(const std::vector<ReportRow>& rows) {
  return draw_lines(
      rows, "scheme", {0, 200, false, {0, 20, 50, 100, 200}},
      {30, 20000, true, {30, 100, 300, 1000, 3000, 10000}},
      {"Largest tissue stiffness that an arm renders stably",
       "light hand; jitter 0 to 20 ms each way, 5 % loss", "round trip, ms", "N/m"},
      [](const ReportRow& row) { return 1e3 * figure(row, "round_trip"); },
      [](const ReportRow& row) { return figure(row, "stable_stiffness"); });
}

Svg draw_felt_stiffness(const std::vector<ReportRow>& rows) {
  return draw_lines(
      rows, "scheme", {30, 10000, true, {30, 100, 300, 1000, 3000, 10000}},
      {0, 3, false, {0, 0.5, 1, 1.5, 2, 2.5, 3}},
      {"Perceived stiffness over true stiffness",
       "medium hand oscillating at 2 Hz; 100 ms round trip, jitter 0 to 20 ms, 5 % loss",
       "tissue stiffness, N/m", "perceived over true stiffness"},
      [](const ReportRow& row) { return figure(row, "stiffness"); },
      [](const ReportRow& row) { return figure(row, "felt_2hz"); });
}

}  // namespace prosector
