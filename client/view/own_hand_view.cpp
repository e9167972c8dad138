#include "client/view/own_hand_view.h"

#include <algorithm>

#include "client/view/force_arrow.h"
#include "client/view/held_blades.h"
#include "client/view/held_bodies.h"
#include "client/view/near_fade.h"
#include "common/hand.h"

namespace prosector {
namespace {

// Opacity of the local user's hand and sleeve at a desk while they cover anatomy or hold something; largest
// change per frame.
constexpr double covering_hand = 0.3, covering_sleeve = 0.3, opacity_step = 0.15;

/// Returns whether at least a quarter of the hand's joints are in front of bodies that can be worked on, as
/// seen by the first eye.
bool occludes_anatomy(const DrawList& list, DrawnBodies& drawn, const Replica& replica,
                      const HandPose& hand) {
  const auto& bodies = replica.scene()->bodies;
  const auto matters = [&](BodyId id) {
    return id < bodies.size() && (bodies[id].kind == BodyKind::soft || bodies[id].part || bodies[id].moves);
  };
  const Vec3& eye = list.cameras.front().pose.p;
  std::size_t before = 0;
  for (const Pose& joint : hand_pose(right_hand, hand.flexion)) {
    const Vec3 way = hand.pose * joint.p - eye;
    const auto point = drawn.nearest(list, {eye, way.normalized()}, matters);
    if (point && point->distance > way.norm()) ++before;
  }
  return before >= hand_joints / 4;
}

void add_guide_of(DrawList& list, DrawnBodies& bodies, const Replica& replica, const HandRef& hand,
                  double tick) {
  const auto user = replica.user(hand.participant, tick);
  const auto blade = held_blade(replica, hand, tick);
  if (!user || !blade) return;
  const FindSurface find = bodies.finder_without(list, held_by(replica, hand));
  add_guide(list, next_cut(replica, user->hands[hand.hand].pose * *blade, find));
}

}  // namespace

void OwnHandView::add_cues(DrawList& list, DrawnBodies& bodies, const UserAvatars& avatars,
                           const Replica& replica, const LocalUser& self, double tick,
                           std::uint64_t& next_mesh_id) {
  const auto user = replica.user(self.participant, tick);
  if (avatars.own_hand_items().empty() || !user || !user->hands[right_hand].tracked) return;
  const std::vector<BodyId> held = held_by(replica, {self.participant, right_hand});
  const HandPose& hand = user->hands[right_hand];
  const Vec3 fingertips = hand.pose * middle_fingertip(right_hand, hand.flexion);
  cues_.add(list, fingertips, bodies.finder_without(list, held), next_mesh_id);
  const ContactSample* contact = replica.contact(self.participant, right_hand);
  if (contact != nullptr && contact->touching) add_force_arrow(list, contact->point, -contact->force);
}

void OwnHandView::update_opacity(DrawList& list, DrawnBodies& bodies, const UserAvatars& avatars,
                                 const Replica& replica, const LocalUser& self, double tick) {
  if (avatars.own_hand_items().empty()) opacity_.reset();
  if (self.at_desk && !avatars.own_hand_items().empty()) {
    const auto user = replica.user(self.participant, tick);
    const bool is_physical = user && user->hands[right_hand].tracked;
    const HandPose& hand = is_physical ? user->hands[right_hand] : self.input.hands[right_hand];
    const bool holds = !held_by(replica, {self.participant, right_hand}).empty();
    const double to = holds || occludes_anatomy(list, bodies, replica, hand) ? 0 : 1;
    opacity_ = opacity_ ? *opacity_ + std::clamp(to - *opacity_, -opacity_step, opacity_step) : to;
    for (const std::size_t item : avatars.own_hand_items())
      list.items[item].opacity *= covering_hand + (1 - covering_hand) * *opacity_;
    for (const std::size_t item : avatars.own_sleeves())
      list.items[item].opacity *= covering_sleeve + (1 - covering_sleeve) * *opacity_;
  }
  fade_near_eyes(list, avatars.own_hand_items());
  fade_near_eyes(list, avatars.own_sleeves());
}

void add_blades(DrawList& list, DrawnBodies& bodies, const Replica& replica, const LocalUser& self,
                double tick) {
  for (BodyId id = 0; id < replica.scene()->bodies.size(); ++id) {
    if (!is_held_blade(replica, id)) continue;
    add_edges(list, replica.bodies().rigid(id)->edges, replica.rigid_pose(id, tick));
    for (const HandRef& hand : replica.part(id)->holders)
      if (!(self.at_desk && hand.participant == self.participant))
        add_guide_of(list, bodies, replica, hand, tick);
  }
}

}  // namespace prosector
