#pragma once
// The strip below a panel that tells how exactly its part is solved, what that costs and how far it is off.
// The pointer sets it; fingers don't. In the panel's frame (common/panel.h), m.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "client/language/catalogue.h"
#include "client/view/pick.h"

namespace prosector {

/// How a deformable is solved now.
struct ShownEffort {
  std::uint32_t steps_down = 0;  // 0: as described … max_steps_down: coarse
  double tick_ms = 0;            // that whole ticks take, median of the last second
  double error = -1;             // of displacements, fraction; below 0: not known
  std::vector<Price> prices{};   // what it can have; empty: nobody asked
  bool may_ask = false;          // who sees it may choose among them
};

inline constexpr double strip_height = 0.052, strip_gap = 0.006;
inline constexpr double strip_y = -panel_height / 2 - strip_gap - strip_height / 2;  // of its middle
inline constexpr double notches_y = strip_y - 0.012, notches_width = 0.15;

/// Returns where the notch of so many steps down is.
inline Vec3 effort_notch(std::uint32_t steps_down) {
  return {notches_width * (static_cast<double>(steps_down) / max_steps_down - 0.5), notches_y, 0};
}
/// Returns where a ray meets the plane of the panel's front from before it, in the panel's frame; nullopt: it
/// doesn't.
std::optional<Vec3> meet_front(const Ray& ray, const Panel& panel);
/// Returns the steps down of the notch that a ray is nearest to; nullopt: it meets no strip.
std::optional<std::uint32_t> meet_effort(const Ray& ray, const Panel& panel);
/// Returns cost and error in words.
std::string in_words(const ShownEffort& effort, const Catalogue& words = {});

}  // namespace prosector
