#include "drivers/fitting/glove_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/error.h"

namespace prosector {
namespace {

constexpr std::array<const char*, fingers> finger_names = {"thumb", "index finger", "middle finger",
                                                           "ring finger", "little finger"};
constexpr std::array<GlovePose, 2 + fingers> poses = {
    {{"flat", "Extend all fingers and the thumb, and hold still", {}},
     {"fist", "Make a fist with the thumb bent over it, and hold still", {true, true, true, true, true}},
     {"thumb", "Bend only the thumb", {true, false, false, false, false}},
     {"index", "Bend only the index finger", {false, true, false, false, false}},
     {"middle", "Bend only the middle finger", {false, false, true, false, false}},
     {"ring", "Bend only the ring finger; its neighbours may follow", {false, false, false, true, false}},
     {"little",
      "Bend only the little finger; its neighbour may follow",
      {false, false, false, false, true}}}};
constexpr double full_bend = std::numbers::pi / 2;  // rad, of a joint over the sensor's whole span
constexpr double much_repeat = 0.25;                // flexion, largest deviation without a warning

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Adds warnings: another sensor moved most when one finger was bent, or the finger was bent much less or
/// more than in the fist.
void check_alone(std::span<const PoseCounts> held, GloveFit& fit) {
  for (std::size_t f = 0; f < fingers; ++f) {
    const PoseCounts& alone = held[2 + f];
    const auto flexion = [&](std::size_t i) {
      return (alone.median[i] - fit.calibration.open[i]) /
             (fit.calibration.closed[i] - fit.calibration.open[i]);
    };
    std::size_t most = 0;
    for (std::size_t i = 1; i < fingers; ++i)
      if (flexion(i) > flexion(most)) most = i;
    fit.repeat[f] = std::abs(flexion(f) - 1);
    if (most != f && flexion(most) > flexion(f) + much_repeat)
      fit.doubts.push_back(
          fmt::format("bending only the {} changed the sensor of the {} most: check that the glove is on the "
                      "correct hand and that sensors are not swapped",
                      finger_names[f], finger_names[most]));
    else if (fit.repeat[f] > much_repeat)
      fit.doubts.push_back(
          fmt::format("the {} was bent to {:.0f} % of its flexion in the fist: repeat the pose if the finger "
                      "was meant to be fully bent",
                      finger_names[f], 100 * flexion(f)));
  }
}

}  // namespace

std::span<const GlovePose> glove_poses() {
  return poses;
}

PoseCounts pose_counts(std::span<const std::array<std::uint16_t, fingers>> readings) {
  PoseCounts out;
  for (std::size_t f = 0; f < fingers; ++f) {
    std::vector<double> counts;
    for (const auto& r : readings) counts.push_back(r[f]);
    if (counts.empty()) continue;
    out.median[f] = median_of(counts);
    // The median absolute deviation ignores readings from before the hand was still.
    constexpr double rms_of_median = 1.4826;  // factor for a normal distribution
    for (double& c : counts) c = std::abs(c - out.median[f]);
    out.noise[f] = rms_of_median * median_of(counts);
  }
  return out;
}

GloveFit fit_glove(std::span<const PoseCounts> held, double least_span) {
  if (held.size() != 2 && held.size() != poses.size())
    throw InputError(fmt::format("{} hand poses were held: either flat and fist are needed, or all {} poses",
                                 held.size(), poses.size()));
  GloveFit fit;
  fit.calibration = {held[0].median, held[1].median};
  std::size_t falling = 0;
  for (std::size_t f = 0; f < fingers; ++f) {
    fit.span[f] = std::abs(held[1].median[f] - held[0].median[f]);
    if (fit.span[f] < least_span)
      throw InputError(
          fmt::format("the {}'s sensor changed by {:.0f} counts between flat hand and fist, {:.0f} are "
                      "needed: repeat both poses, and check that the glove fits tightly",
                      finger_names[f], fit.span[f], least_span));
    if (held[1].median[f] < held[0].median[f]) ++falling;
  }
  fit.falls_on_bending = falling > fingers / 2;
  if (falling != 0 && falling != fingers)
    fit.doubts.push_back(
        fmt::format("the counts of {} of {} sensors decrease as the finger bends: unusual, but the glove is "
                    "calibrated accordingly",
                    falling, fingers));
  if (held.size() == poses.size()) check_alone(held, fit);
  constexpr double quantum = 1.0 / 12;
  for (std::size_t f = 0; f < fingers; ++f) {
    const double noise = std::max(held[0].noise[f], held[1].noise[f]);
    const double bend = full_bend / fit.span[f];
    fit.joint_error[f] = std::sqrt(bend * bend * (noise * noise + quantum) +
                                   full_bend * full_bend * fit.repeat[f] * fit.repeat[f]);
  }
  return fit;
}

}  // namespace prosector
