#include "client/view/effort_strip.h"

#include <algorithm>
#include <cmath>

#include "common/percent_text.h"

namespace prosector {

std::optional<Vec3> intersect_panel_plane(const Ray& ray, const Panel& panel) {
  const Pose into = panel.pose.inverse();
  const Vec3 from = into * ray.from, along = into.q * ray.along;
  if (from.z() <= 0 || along.z() > -1e-6) return std::nullopt;
  return from - from.z() / along.z() * along;
}

std::optional<std::uint32_t> picked_effort(const Ray& ray, const Panel& panel) {
  const auto at = intersect_panel_plane(ray, panel);
  if (!at || std::abs(at->x()) > panel_width / 2 || std::abs(at->y() - strip_y) > strip_height / 2)
    return std::nullopt;
  const double share = std::clamp(at->x() / notches_width + 0.5, 0.0, 1.0);
  return static_cast<std::uint32_t>(std::lround(share * max_steps_down));
}

std::string in_words(const ShownEffort& effort, const Catalogue& words) {
  return is_known_error(effort.error)
             ? words.tr("now {:.1f} ms per tick, error about {}", effort.tick_ms, percent_text(effort.error))
             : words.tr("now {:.1f} ms per tick, error unknown", effort.tick_ms);
}

}  // namespace prosector
