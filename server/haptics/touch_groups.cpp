#include "server/haptics/touch_groups.h"

#include <algorithm>
#include <tuple>

#include "common/contact_plane.h"

namespace prosector {
namespace {

constexpr double agreement =
    0.5;  // of forces: least ratio of |sum| to sum of magnitudes that counts as one direction
constexpr double hardly_pulls = 0.2;  // N: weaker holds get no direction from their force
constexpr std::size_t most_holds =
    max_contact_planes - 1;  // groups: one plane stays free for touches that press

/// Adds a touch that presses, or is close. The group's point is the mean of its touches, weighted by force if
/// any presses.
void add_pressing(TouchGroup& group, const HandTouch& touch) {
  group.touches.push_back(touch);
  Vec3 pressing = Vec3::Zero(), rubbing = Vec3::Zero(), facing = Vec3::Zero(), pressed = Vec3::Zero(),
       middle = Vec3::Zero();
  double force = 0;
  for (const HandTouch& t : group.touches) {
    pressing += t.force * t.normal;
    rubbing += t.exchanged - t.exchanged.dot(t.normal) * t.normal;
    pressed += t.force * t.point;
    force += t.force;
    facing += t.normal;
    middle += t.point / static_cast<double>(group.touches.size());
  }
  group.pressing = pressing.norm();
  group.force = pressing + rubbing;
  group.point = force > 0 ? Vec3(pressed / force) : middle;
  const Vec3& direction = group.pressing > 0 ? pressing : facing;
  group.normal = direction.norm() > 0 ? Vec3(direction.normalized()) : touch.normal;
}

/// Adds a point at which the hand holds the body. The group's point is the mean of its touches, weighted by
/// force if any pulls.
void add_held(TouchGroup& group, const HandTouch& touch) {
  group.touches.push_back(touch);
  Vec3 pulled = Vec3::Zero(), middle = Vec3::Zero();
  double all = 0;
  group.force.setZero();
  for (const HandTouch& t : group.touches) {
    group.force += t.exchanged;
    pulled += t.force * t.point;
    all += t.force;
    middle += t.point / static_cast<double>(group.touches.size());
  }
  group.pressing = group.force.norm();
  group.point = all > 0 ? Vec3(pulled / all) : middle;
  group.normal = group.pressing > hardly_pulls ? Vec3(group.force / group.pressing) : Vec3(Vec3::UnitY());
}

/// Returns whether all touches press the hand in about one direction, as tissue presses a fingertip.
/// Otherwise the hand grips the body.
bool one_way(std::span<const HandTouch> touches) {
  Vec3 sum = Vec3::Zero();
  double all = 0;
  for (const HandTouch& t : touches) {
    sum += t.force * t.normal;
    all += t.force;
  }
  return sum.norm() >= agreement * all;
}

/// Adds a body's touches, with one group for each side. When there are `max_contact_planes` groups, further
/// pressing touches join the group with the nearest normal, so that no force is left out.
void add_sides(std::span<const HandTouch> touches, std::vector<TouchGroup>& out) {
  for (const HandTouch& touch : touches) {
    TouchGroup* nearest = nullptr;
    for (TouchGroup& group : out)
      if (!group.holds && group.body == touch.body &&
          (nearest == nullptr || group.normal.dot(touch.normal) > nearest->normal.dot(touch.normal)))
        nearest = &group;
    const bool fits = nearest != nullptr && nearest->normal.dot(touch.normal) > same_side;
    const bool is_new = !fits && out.size() < max_contact_planes;
    if (is_new) {
      nearest = &out.emplace_back();
      nearest->body = touch.body;
    }
    if (nearest != nullptr && (fits || is_new || touch.force > 0)) add_pressing(*nearest, touch);
  }
}

/// Adds the points at which the hand holds one body. Once there are `most_holds` groups, further points join
/// the last of them.
void add_hold(std::span<const HandTouch> touches, std::vector<TouchGroup>& out) {
  if (out.size() < most_holds) {
    out.emplace_back().body = touches.front().body;
    out.back().holds = true;
  }
  for (const HandTouch& touch : touches) add_held(out.back(), touch);
}

/// Adds one body's touches that press the hand, or are close to it.
void add_pressed(std::span<const HandTouch> touches, std::vector<TouchGroup>& out) {
  if (!one_way(touches)) {
    add_sides(touches, out);
  } else if (out.size() < max_contact_planes) {
    out.emplace_back().body = touches.front().body;
    for (const HandTouch& touch : touches) add_pressing(out.back(), touch);
  }
}

}  // namespace

std::vector<TouchGroup> grouped(std::vector<HandTouch> touches) {
  std::stable_sort(touches.begin(), touches.end(), [](const HandTouch& a, const HandTouch& b) {
    return std::tuple(!a.holds, a.body, b.force) < std::tuple(!b.holds, b.body, a.force);
  });
  std::vector<TouchGroup> out;
  for (auto first = touches.begin(); first != touches.end();) {
    const auto last = std::find_if(first, touches.end(), [&](const HandTouch& t) {
      return t.body != first->body || t.holds != first->holds;
    });
    first->holds ? add_hold({first, last}, out) : add_pressed({first, last}, out);
    first = last;
  }
  return out;
}

}  // namespace prosector
