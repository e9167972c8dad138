// Panels carried by tablets and fists, and reset by a second fist.

#include <algorithm>
#include <cmath>
#include <utility>

#include "server/physics/mechanics/panel/panel_place.h"
#include "server/physics/mechanics/panel/panel_world.h"

namespace prosector::panel {

/// Returns the hands, and each stylus as a hand with a single finger, in canonical order.
std::vector<PanelHand> PanelWorld::with_styli(std::span<const PanelHand> hands) const {
  std::vector<PanelHand> out(hands.begin(), hands.end());
  for (const auto& [who, shaft] : styli_) {
    PanelHand stylus;
    stylus.who = {who, stylus_hand};
    stylus.palm = stylus.touched_at = shaft.b;
    stylus.fingers = {shaft};
    stylus.index = shaft;
    out.push_back(std::move(stylus));
  }
  std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.who < b.who; });
  return out;
}

/// Attaches panels to their owners' tablets. A tablet that has just appeared opens a panel. A tablet that is
/// no longer tracked keeps its panel for a while, then releases it.
void PanelWorld::lay_on_tablets(const PanelSubjects& subjects) {
  for (auto it = tablets_.begin(); it != tablets_.end();) {
    auto& [who, tablet] = *it;
    tablet.unseen = tablet.seen ? 0 : tablet.unseen + 1;
    if (tablet.unseen > ticks(tablet_rest)) {
      it = tablets_.erase(it);
      continue;
    }
    if (!std::exchange(tablet.answered, true) && !open_.contains(who))
      if (const auto body = subjects.first()) {
        const auto [lo, hi] = subjects.box(*body);
        open(who, *body, (lo + hi) / 2, nullptr, 1, subjects);
      }
    if (const auto panel = open_.find(who); panel != open_.end()) {
      panel->second.hold.reset();
      panel->second.pose = tablet.pose;
    }
    ++it;
  }
}

/// Returns whether the hand's palm or one of its fingers is at the board's head.
bool PanelWorld::reaches_head(const Open& panel, const PanelHand& hand) {
  const Pose into = panel.pose.inverse();
  return is_at_head(into * hand.palm) ||
         std::any_of(hand.fingers.begin(), hand.fingers.end(),
                     [&](const Capsule& finger) { return is_at_head(into * finger.a); });
}

/// Returns whether the hand's fingers operate controls. A hand behind the board does not. Neither does a hand
/// at the head, whose fingers bend over the buttons, nor a closing hand on its way there.
bool PanelWorld::presses(const Open& panel, const PanelHand& hand) {
  if (panel.hold && panel.hold->who == hand.who) return false;
  const Vec3 palm = panel.pose.inverse() * hand.palm;
  const bool closes = hand.bend > (reaches_head(panel, hand) ? closing_at_head : closing_bend);
  return palm.z() > 0 && !is_at_head(palm) && !closes;
}

void PanelWorld::carry(std::span<const PanelHand> hands) {
  if (open_.empty()) return;
  for (const PanelHand& hand : hands) {
    const bool known = fists_.contains(hand.who);
    Fist& fist = fists_[hand.who];
    fist.since = std::min(fist.since + 1, no_fist);
    if (known && hand.fist && !fist.closed) take_hold(hand, fist);
    fist.closed = hand.fist;
  }
  for (auto& [who, panel] : open_) follow(who, panel, hands);
}

std::vector<HandRef> PanelWorld::carriers() const {
  std::vector<HandRef> out;
  for (const auto& [who, panel] : open_)
    if (panel.hold) out.push_back(panel.hold->who);
  std::sort(out.begin(), out.end());
  return out;
}

/// Makes a hand that has just closed at a panel's head carry the panel, or reset its pose for a second fist.
void PanelWorld::take_hold(const PanelHand& hand, Fist& fist) {
  const auto at_head = std::find_if(open_.begin(), open_.end(), [&](const auto& panel) {
    return !panel.second.hold && !tablets_.contains(panel.first) && reaches_head(panel.second, hand);
  });
  if (at_head == open_.end()) return;
  Open& panel = at_head->second;
  const bool second = fist.since < ticks(second_fist) && (hand.palm - fist.at).norm() < second_fist_way;
  fist.since = second ? no_fist : 0;
  fist.at = hand.palm;
  panel.idle = 0;
  if (second)
    panel.pose = panel.came_up;
  else
    panel.hold = Hold{hand.who, panel.pose.inverse() * hand.palm};
}

/// Moves a carried panel with the palm and keeps it facing its owner's eyes.
void PanelWorld::follow(ParticipantId who, Open& panel, std::span<const PanelHand> hands) {
  if (!panel.hold) return;
  const auto hand = std::find_if(hands.begin(), hands.end(),
                                 [&](const PanelHand& h) { return h.who == panel.hold->who && h.fist; });
  if (hand == hands.end()) {
    panel.hold.reset();
    return;
  }
  place(who, panel, hand->palm - panel.pose.q * panel.hold->at);
}

/// Moves a panel's centre to `middle`, m, world frame, and turns it towards its owner's eyes.
void PanelWorld::place(ParticipantId who, Open& panel, const Vec3& middle) {
  if (!middle.allFinite() || middle.cwiseAbs().maxCoeff() > max_coordinate) return;
  panel.pose.p = middle;
  if (const auto head = heads_.find(who); head != heads_.end())
    panel.pose.q = face_reader(middle, head->second);
  panel.idle = 0;
}

}  // namespace prosector::panel
