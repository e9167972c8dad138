#include "tests/collision/reference/collision_world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/error.h"

namespace prosector {
namespace {

constexpr double impact_slop = 1e-5;  // m: that near is met

double checked(double margin) {
  if (!(margin > 0) || !std::isfinite(margin))
    throw InputError(fmt::format("collision margin {} m: must be positive and finite", margin));
  return margin;
}

}  // namespace

CollisionWorld::CollisionWorld(double margin) : margin_(checked(margin)), broad_(2 * margin) {}

CollisionWorld::Id CollisionWorld::add(CollisionObject object, const CollisionOptions& options) {
  const auto free = std::find_if(entries_.begin(), entries_.end(), [](const Entry& e) { return !e.object; });
  const auto id = static_cast<Id>(free - entries_.begin());
  if (free == entries_.end()) entries_.emplace_back();
  Entry& e = entries_[id];
  e = {std::move(object), options, true, false};
  if (!e.object->pieces().empty()) broad_.add(id, e.object->box(), options.mask, options.moves);
  ++size_;
  return id;
}

void CollisionWorld::remove(Id id) {
  if (broad_.has(id)) broad_.remove(id);
  entries_[id] = {};
  --size_;
}

void CollisionWorld::place(Id id, const Pose& pose, const Vec3& linear, const Vec3& angular) {
  Entry& e = entry(id);
  (e.object->place(pose, linear, angular) ? e.changed : e.rejected) = true;
}

void CollisionWorld::bend(Id id, std::size_t part, const Pose& pose) {
  Entry& e = entry(id);
  if (!e.object->bend(part, pose)) e.rejected = true;
}

void CollisionWorld::move(Id id, std::span<const Vec3> positions, std::span<const Vec3> velocities) {
  Entry& e = entry(id);
  (e.object->move(positions, velocities) ? e.changed : e.rejected) = true;
}

void CollisionWorld::cut(Id id, const TriangleMesh& surface) {
  entry(id).object->cut(surface);
  entry(id).changed = true;
}

void CollisionWorld::set_moves(Id id, bool moves) {
  entry(id).options.moves = moves;
  if (broad_.has(id)) broad_.set_moves(id, moves);
}

/// Half of the margin on either side: boxes meet if and only if the shapes may be that near. Where one is
/// continuous, all boxes are for the whole tick: the others move too.
void CollisionWorld::refresh_boxes(double h) {
  const bool sweep = std::any_of(entries_.begin(), entries_.end(),
                                 [](const Entry& e) { return e.object && e.options.continuous; });
  const double swept = sweep ? h : 0;
  for (Id id = 0; id < entries_.size(); ++id) {
    Entry& e = entries_[id];
    if (!broad_.has(id) || (!e.changed && swept == swept_)) continue;
    broad_.update(id, (swept > 0 ? e.object->swept_box(swept) : e.object->box()).grown(margin_ / 2));
    e.changed = false;
  }
  swept_ = swept;
}

void CollisionWorld::detect_pair(Id a, Id b, double h) {
  const CollisionObject &p = object(a), &q = object(b);
  const bool continuous = entries_[a].options.continuous || entries_[b].options.continuous;
  std::optional<collision::Proximity> found = proximity(p, q, margin_);
  double gap = found ? found->gap : 0;
  std::optional<double> impact;
  if (continuous) {
    if (const auto met = time_of_impact(p, q, h, impact_slop)) {
      report_.unsettled_impacts += met->converged ? 0 : 1;
      if (met->converged) {
        if (!found) gap = proximity(p, q, std::numeric_limits<double>::infinity())->gap;
        impact = met->time;
        found = met->at;
      }
    }
  }
  if (!found) return;
  const double t = impact.value_or(0);
  report_.touches.push_back({a, b, found->point(), found->normal, gap, p.local(found->on_a, t),
                             q.local(found->on_b, t), found->at_a, found->at_b, impact});
}

const CollisionReport& CollisionWorld::detect(double h) {
  report_ = {};
  for (Id id = 0; id < entries_.size(); ++id)
    if (std::exchange(entries_[id].rejected, false)) report_.rejected.push_back(id);
  refresh_boxes(h);
  const auto& pairs = broad_.find_pairs();
  report_.broad_pairs = pairs.size();
  for (const auto& [a, b] : pairs) detect_pair(a, b, h);
  return report_;
}

}  // namespace prosector
