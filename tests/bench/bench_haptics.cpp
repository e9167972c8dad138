// Haptic rendering of tissue over a network, for each scheme, in virtual time.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "common/panel_control.h"

#include "tests/bench/haptic_plot.h"
#include "tests/bench/subjects.h"
#include "tests/bench/text_table.h"
#include "tests/haptics/haptic_case.h"

namespace prosector {
namespace {

// Prediction and passivity control belong to our schemes; the last two render received data directly.
const std::vector<HapticScheme> schemes = {
    {"linearised", "first-order model of the tissue at the hand, as in the client", -1, true, {}},
    {"plane after contact", "as linearised, but planes are sent only after contact", -1, false, {}},
    {"without passivity",
     "as linearised, without passivity observer and controller",
     -1,
     true,
     {true, false}},
    {"without prediction",
     "as linearised, with forces at the delayed hand position",
     -1,
     true,
     {false, true}},
    {"stiffness × 0.5", "as linearised, with the estimated stiffness halved", -0.5, true, {}},
    {"stiffness × 1.5", "as linearised, with 1.5 times the estimated stiffness", -1.5, true, {}},
    {"stiff surface", "the deformed surface as a plane of 800 N/m", 800, false, {false, false}},
    {"force over network", "the received force, held until the next one", 0, false, {false, false}},
};

struct HandRow {
  const char* name;
  HandImpedance hand;
};
const std::vector<HandRow> simulated_hands = {{"light", light_hand}, {"medium", medium_hand}};

constexpr double still = 3e-4;                               // m: larger ripple counts as unstable
constexpr double min_stiffness = 30, max_stiffness = 20000;  // N/m
const std::vector<double> round_trips = {0, 0.02, 0.05, 0.1, 0.2};
const std::vector<double> stiffnesses = {30, 100, 300, 1000, 3000, 10000};
constexpr LineQuality clean{}, bad{0, 0.02, 0.05};

bool stable(const HapticScheme& scheme, HapticCase test, int seeds) {
  for (int seed = 1; seed <= seeds; ++seed) {
    test.seed = static_cast<std::uint64_t>(seed);
    const HapticResult result = run(scheme, test);
    if (!result.finite || result.ripple > still) return false;
  }
  return true;
}

/// Returns the largest tissue stiffness up to which all tested ones are stable, N/m; 0: the smallest is
/// unstable.
double stable_stiffness(const HapticScheme& scheme, HapticCase test, double step, int seeds) {
  double last = 0;
  for (double k = min_stiffness; k <= max_stiffness; k *= step) {
    test.stiffness = k;
    if (!stable(scheme, test, seeds)) break;
    last = k;
  }
  return last;
}

ReportRow settings_of(const HapticScheme& scheme, const HandRow& hand, const LineQuality& line) {
  return {{"scheme", scheme.name},
          {"hand", hand.name},
          {"round_trip", line.round_trip},
          {"jitter", line.jitter},
          {"loss", line.loss}};
}

/// Adds a row for one tissue. Figures are means over seeds, whose depths differ by a fraction of an encoder
/// step; energy and ripple are the worst values.
void add_felt(ReportRow& row, const HapticScheme& scheme, HapticCase test, int seeds) {
  double felt = 0, at2 = 0, at8 = 0, peak = 0, onset = 0, least = 0, ripple = 0;
  const double depth = test.depth;
  for (int seed = 1; seed <= seeds; ++seed) {
    test.seed = static_cast<std::uint64_t>(seed);
    test.depth = depth * (1 + 0.1 * seed / seeds);
    test.frequency = 0;
    const HapticResult still_hand = run(scheme, test);
    felt += still_hand.felt / seeds;
    peak = std::max(peak, still_hand.peak);
    onset = std::max(onset, still_hand.onset);
    ripple = std::max(ripple, still_hand.ripple);
    test.frequency = 2;
    const HapticResult slow = run(scheme, test);
    test.frequency = 8;
    const HapticResult fast = run(scheme, test);
    at2 += slow.felt_swinging / seeds;
    at8 += fast.felt_swinging / seeds;
    least = std::min({least, still_hand.least_energy, slow.least_energy, fast.least_energy});
  }
  row["felt_static"] = felt;
  row["felt_2hz"] = at2;
  row["felt_8hz"] = at8;
  row["ripple"] = ripple;
  row["least_energy"] = least;
  row["onset"] = onset;
  row["peak"] = peak;
}

}  // namespace

Report bench_haptics(const HapticsBenchOptions& options) {
  Report report("haptics");
  const int seeds = options.quick ? 1 : 5;
  const double step = options.quick ? 4 : 1.15;
  const TextTable stable_table({{Column::Kind::text, "scheme", "scheme", 20},
                                {Column::Kind::text, "hand", "hand", 7},
                                {Column::Kind::number, "jitter", "jitter s", 9},
                                {Column::Kind::number, "round_trip", "round trip s", 12},
                                {Column::Kind::number, "stable_stiffness", "stable to N/m", 14}});
  stable_table.print_header();
  std::vector<ReportRow> stable_rows, felt_rows;
  for (const HapticScheme& scheme : schemes)
    for (const HandRow& hand : simulated_hands)
      for (LineQuality line : {clean, bad})
        for (const double round_trip : round_trips) {
          line.round_trip = round_trip;
          HapticCase test;
          test.hand = hand.hand;
          test.line = line;
          ReportRow row = settings_of(scheme, hand, line);
          row["stable_stiffness"] = stable_stiffness(scheme, test, step, seeds);
          stable_table.print(row);
          if (line.jitter > 0 && hand.hand.stiffness == light_hand.stiffness) stable_rows.push_back(row);
          report.add(std::move(row));
        }
  const TextTable felt_table({{Column::Kind::text, "scheme", "scheme", 20},
                              {Column::Kind::number, "round_trip", "round trip s", 12},
                              {Column::Kind::number, "stiffness", "tissue N/m", 11},
                              {Column::Kind::number, "felt_static", "felt", 8},
                              {Column::Kind::number, "felt_2hz", "at 2 Hz", 8},
                              {Column::Kind::number, "felt_8hz", "at 8 Hz", 8},
                              {Column::Kind::number, "least_energy", "energy J", 10},
                              {Column::Kind::number, "onset", "onset s", 8},
                              {Column::Kind::number, "peak", "peak", 7}});
  felt_table.print_header();
  for (const HapticScheme& scheme : schemes)
    for (const double round_trip : round_trips)
      for (const double stiffness : stiffnesses) {
        HapticCase test;
        test.hand = medium_hand;
        test.line = bad;
        test.line.round_trip = round_trip;
        test.stiffness = stiffness;  // pressed too briefly to heat the motors
        ReportRow row = settings_of(scheme, simulated_hands[1], test.line);
        row["stiffness"] = stiffness;
        add_felt(row, scheme, test, seeds);
        felt_table.print(row);
        if (round_trip == 0.1) felt_rows.push_back(row);
        report.add(std::move(row));
      }
  HapticCase air;
  air.free = true;
  const double drag = run(schemes.front(), air).drag;
  fmt::print("free-space drag of the arm without its own friction: {:.3g} N\n", drag);
  report.note("free_drag", drag);
  if (!options.picture_folder.empty()) {
    const std::filesystem::path folder = options.picture_folder;
    draw_stable_stiffness(stable_rows).write(folder / "haptics-stable.svg");
    draw_felt_stiffness(felt_rows).write(folder / "haptics-felt.svg");
  }
  return report;
}

}  // namespace prosector
