#pragma once
// The strip below a panel that shows the solver effort of its part, its cost and its estimated error.
// Operated by the pointer, not by fingers. In the panel's frame (common/panel.h), m.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "client/language/catalogue.h"
#include "client/view/pick.h"
#include "common/commands.h"
#include "common/error_estimate.h"
#include "common/part_messages.h"

namespace prosector {

/// Solver effort of a soft body as its panel shows it: how far the effort is reduced, its time per tick and
/// its error.
struct ShownEffort {
  std::uint32_t steps_down = 0;  // 0: as in the scene … max_steps_down: coarsest
  double tick_ms = 0;            // duration of whole ticks, median of the last second
  double error = -1;             // relative error of displacements; below 0: unknown
  std::vector<Price> prices{};   // available model configurations; empty: not requested yet
  bool may_ask = false;          // the viewer may choose one
};

inline constexpr double strip_height = 0.052, strip_gap = 0.006;
inline constexpr double strip_y = -panel_height / 2 - strip_gap - strip_height / 2;  // of its centre
inline constexpr double notches_y = strip_y - 0.012, notches_width = 0.15;

/// Returns the position, in the panel's frame, m, of the notch on the effort strip that stands for this
/// number of steps down (steps by which solver effort is reduced).
inline Vec3 effort_notch(std::uint32_t steps_down) {
  return {notches_width * (static_cast<double>(steps_down) / max_steps_down - 0.5), notches_y, 0};
}
/// Returns the point, in the panel's frame, m, at which a ray meets the plane of the panel's front, coming
/// from its front side. Returns nullopt if it does not.
std::optional<Vec3> intersect_panel_plane(const Ray& ray, const Panel& panel);
/// Returns the number of steps by which to reduce solver effort, of the notch nearest to where the ray meets
/// the panel's effort strip. Returns nullopt if the ray misses the strip.
std::optional<std::uint32_t> picked_effort(const Ray& ray, const Panel& panel);
/// Returns a text on a body's current solver effort: its milliseconds per tick, and its estimated error, if
/// known.
std::string in_words(const ShownEffort& effort, const Catalogue& words = {});

}  // namespace prosector
