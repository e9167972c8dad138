#include "server/physics/mechanics/panel/panel_world.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace prosector::panel {
namespace {

constexpr double least_slide = 1e-6;  // of the travel: a smaller difference from the shown value is no motion

bool usable(const Vec3& x) {
  return x.allFinite() && x.cwiseAbs().maxCoeff() <= max_coordinate;
}

Capsule into(const Pose& panel_from_room, const Capsule& c) {
  return {panel_from_room * c.a, panel_from_room * c.b, c.radius};
}

/// Returns whether a segment with its tip at `a` points at the board's front from near by.
bool points_at(const Capsule& index, const Pose& panel) {
  const Capsule seen = into(panel.inverse(), index);
  const Vec3 along = seen.a - seen.b;
  if (seen.a.z() <= 0 || along.z() >= 0) return false;
  const Vec3 way = -seen.a.z() / along.z() * along, at = seen.a + way;
  return way.norm() < pointing_reach && std::abs(at.x()) < panel_width / 2 &&
         std::abs(at.y()) < panel_height / 2;
}

}  // namespace

PanelWorld::PanelWorld(double h) : h_(h) {}

std::uint32_t PanelWorld::ticks(double seconds) const {
  return static_cast<std::uint32_t>(std::ceil(seconds / h_));
}

void PanelWorld::take(const HeadPlace& head) {
  if (!usable(head.at)) return;
  const bool faces = std::abs(head.ahead.norm() - 1) < 1e-6 && std::abs(head.ahead.y()) < 1e-6;
  heads_[head.participant] = {head.at, faces ? head.ahead : Vec3::Zero()};
}

void PanelWorld::take(const HeldPlace& held) {
  const ParticipantId who = held.participant;
  if (held.thing == HeldObject::stylus) {
    const Vec3 tip = held.at * Vec3(0, 0, stylus_radius), end = held.at * Vec3(0, 0, stylus_length);
    styli_.erase(who);
    if (held.seen && usable(tip) && usable(end)) styli_[who] = {tip, end, stylus_radius};
    return;
  }
  const auto tablet = tablets_.find(who);
  if (held.seen && usable(held.at.p)) {
    Tablet& seen = tablets_[who];
    seen.pose = {held.at.p, held.at.q.normalized()};
    seen.seen = true;
    seen.unseen = 0;
  } else if (tablet != tablets_.end()) {
    tablet->second.seen = false;
  }
}

void PanelWorld::take(const PanelEvent& event, const PanelSubjects& subjects) {
  const auto panel = open_.find(event.participant);
  switch (event.kind) {
    case PanelEvent::Kind::open: {
      if (!subjects.has_panel(event.body)) return;
      const auto [lo, hi] = subjects.box(event.body);
      if (panel != open_.end() && panel->second.body == event.body)
        panel->second.pinned = ticks(pinned_from_afar);
      open(event.participant, event.body, (lo + hi) / 2, nullptr, 1, subjects);
      return;
    }
    case PanelEvent::Kind::close:
      if (panel != open_.end()) open_.erase(panel);
      return;
    case PanelEvent::Kind::set:
      if (panel != open_.end()) set(panel->second, event);
      return;
    case PanelEvent::Kind::put:
      if (panel != open_.end() && !panel->second.hold && !tablets_.contains(panel->first))
        place(panel->first, panel->second, event.at);
      return;
    case PanelEvent::Kind::put_back:
      if (panel != open_.end() && !panel->second.hold && !tablets_.contains(panel->first))
        panel->second.pose = panel->second.came_up;
      return;
  }
}

/// Opens a panel that faces the participant's head, or the hand's palm if the head is unknown.
void PanelWorld::open(ParticipantId who, BodyId body, const Vec3& touched, const Vec3* palm, double side,
                      const PanelSubjects& subjects) {
  if (const auto old = open_.find(who); old != open_.end() && old->second.body == body) {
    old->second.idle = 0;
    return;
  }
  const auto [lo, hi] = subjects.box(body);
  const auto head = heads_.find(who);
  PanelReader reader{touched + Vec3(0, 0.3, 1)};
  if (palm != nullptr) reader.eyes = *palm + Vec3(0, 0.3, 0);
  if (head != heads_.end()) reader = head->second;
  if (!usable(touched) || !usable(lo) || !usable(hi)) return;
  Open panel;
  panel.body = body;
  panel.pose = panel.came_up = place_panel({touched, lo, hi, reader, side});
  if (const auto tablet = tablets_.find(who); tablet != tablets_.end()) panel.pose = tablet->second.pose;
  panel.shown = subjects.shown(body);
  constexpr auto slider = static_cast<std::size_t>(PanelControl::stiffness);
  panel.motions[slider].position = std::clamp(panel.shown[slider], 0.0, 1.0);
  open_.insert_or_assign(who, panel);
}

void PanelWorld::set(Open& panel, const PanelEvent& event) {
  const auto k = static_cast<std::size_t>(event.control);
  if (k >= panel_control_count || !std::isfinite(event.value)) return;
  const bool button = panel_controls[k].kind == ControlKind::button;
  const double value = button ? (event.value >= 0.5 ? 1 : 0) : std::clamp(event.value, 0.0, 1.0);
  panel.motions[k] = {button ? 1 : value, 0};
  panel.home[k] = button;
  panel.shown[k] = value;
  panel.pointed[k] = ticks(pointed_time);
  panel.idle = 0;
  asked_.push_back({event.participant, panel.body, event.control, value});
}

std::vector<PanelAction> PanelWorld::step(std::span<const PanelHand> bare_hands,
                                          const PanelSubjects& subjects) {
  const std::vector<PanelHand> hands = with_styli(bare_hands);
  std::map<ParticipantId, Pose> before;
  for (const auto& [who, panel] : open_) before.emplace(who, panel.pose);
  lay_on_tablets(subjects);
  carry(hands);
  for (auto& [who, panel] : open_) {
    const auto was = before.find(who);
    move(who, panel, was != before.end() ? was->second : panel.pose, hands);
  }
  for (const PanelHand& hand : hands) feel(hand, subjects);
  grow_old(hands, subjects);
  remember(hands);
  return std::exchange(asked_, {});
}

/// Moves the controls of a panel that was at `before` at the end of the last tick.
void PanelWorld::move(ParticipantId who, Open& panel, const Pose& before, std::span<const PanelHand> hands) {
  const MovedControls moved = move_controls(panel.motions, fingers_before(panel, before, hands), h_);
  panel.motions = moved.motions;
  for (const ControlDesc& control : panel_controls) {
    const auto k = static_cast<std::size_t>(control.control);
    const ControlMotion& motion = panel.motions[k];
    panel.touched[k] = moved.touched[k];
    if (panel.touched[k]) panel.idle = 0;
    if (panel.pointed[k] > 0) --panel.pointed[k];
    if (control.kind == ControlKind::slider) {
      if (std::abs(motion.position - panel.shown[k]) > least_slide)
        asked_.push_back({who, panel.body, control.control, motion.position});
    } else if (panel.home[k]) {
      panel.home[k] = motion.position > let_go_position;
    } else if (motion.position > home_position) {
      panel.home[k] = true;
      asked_.push_back({who, panel.body, control.control, panel.shown[k] >= 0.5 ? 0.0 : 1.0});
    }
  }
}

/// Returns the segments of a hand that are under the board's front and came there from outside its outline;
/// `under`: before this tick. They press nothing until they have been above the board. Otherwise a hand that
/// approaches the board would press the controls it passes under.
std::uint64_t PanelWorld::came_under(const Open& panel, const PanelHand& hand, std::uint64_t under) {
  const Pose into_panel = panel.pose.inverse();
  for (std::size_t f = 0; f < std::min(hand.fingers.size(), most_fingers); ++f) {
    const std::uint64_t bit = std::uint64_t{1} << f;
    const AtBoard place = at_board(into(into_panel, hand.fingers[f]));
    if (place == AtBoard::beside) under |= bit;
    if (place == AtBoard::over) under &= ~bit;
  }
  return under;
}

/// Returns the finger sweeps of the hands that operate the panel's controls.
std::vector<FingerSweep> PanelWorld::fingers_before(Open& panel, const Pose& before,
                                                    std::span<const PanelHand> hands) const {
  std::vector<FingerSweep> out;
  std::erase_if(panel.came_under, [&](const auto& entry) {
    return std::none_of(hands.begin(), hands.end(),
                        [&](const auto& hand) { return hand.who == entry.first; });
  });
  const Pose into_panel = panel.pose.inverse(), into_last = before.inverse();
  for (const PanelHand& hand : hands) {
    const auto before_it = panel.came_under.find(hand.who);
    const std::uint64_t was_under = before_it == panel.came_under.end() ? 0 : before_it->second;
    const std::uint64_t is_under = came_under(panel, hand, was_under);
    if (is_under == 0)
      panel.came_under.erase(hand.who);
    else
      panel.came_under[hand.who] = is_under;
    if (!presses(panel, hand)) continue;
    const auto last = last_fingers_.find(hand.who);
    const bool known = last != last_fingers_.end() && last->second.size() == hand.fingers.size();
    for (std::size_t f = 0; f < std::min(hand.fingers.size(), most_fingers); ++f) {
      const std::uint64_t bit = std::uint64_t{1} << f;
      if (is_under & bit) continue;
      const Capsule to = into(into_panel, hand.fingers[f]);
      const bool from_there = known && !(was_under & bit);
      out.push_back({from_there ? into(into_last, last->second[f]) : to, to});
    }
  }
  return out;
}

/// Makes a hand that touches a body long enough open the part's panel, or close its owner's panel if the body
/// has none. A lost touch may last as long as the touch before it. A pinned panel is not replaced.
void PanelWorld::feel(const PanelHand& hand, const PanelSubjects& subjects) {
  Rest& rest = rests_[hand.who];
  if (!hand.touches) {
    if (rest.ticks > 0) --rest.ticks;
    if (rest.ticks == 0) rest = {};
    return;
  }
  if (rest.ticks == 0 || rest.body != *hand.touches) rest = {*hand.touches, 0, false};
  rest.ticks = std::min(rest.ticks + 1, ticks(touch_moment));
  if (rest.answered || rest.ticks < ticks(touch_moment)) return;
  if (const auto own = open_.find(hand.who.participant); own != open_.end() && own->second.pinned > 0) return;
  rest.answered = true;
  if (subjects.has_panel(rest.body))
    open(hand.who.participant, rest.body, hand.touched_at, &hand.palm, hand.who.hand == right_hand ? -1 : 1,
         subjects);
  else if (!tablets_.contains(hand.who.participant))
    open_.erase(hand.who.participant);
}

void PanelWorld::grow_old(std::span<const PanelHand> hands, const PanelSubjects& subjects) {
  for (auto it = open_.begin(); it != open_.end();) {
    Open& panel = it->second;
    const bool on_part = std::any_of(hands.begin(), hands.end(), [&](const PanelHand& hand) {
      return hand.who.participant == it->first && hand.touches == panel.body;
    });
    const bool pointed_at = std::any_of(hands.begin(), hands.end(), [&](const PanelHand& hand) {
      return hand.who.participant == it->first && hand.index.radius > 0 && points_at(hand.index, panel.pose);
    });
    if (pointed_at) panel.pinned = std::max(panel.pinned, ticks(pinned_by_hand));
    panel.idle = on_part || panel.pinned > 0 || tablets_.contains(it->first) ? 0 : panel.idle + 1;
    if (panel.pinned > 0) --panel.pinned;
    const bool over = panel.idle > ticks(panel_timeout) || !subjects.has_panel(panel.body);
    it = over ? open_.erase(it) : std::next(it);
  }
}

/// Removes data of hands that are gone, and heads of participants with neither hands nor panel.
void PanelWorld::remember(std::span<const PanelHand> hands) {
  const auto here = [&](auto belongs) { return std::any_of(hands.begin(), hands.end(), belongs); };
  std::erase_if(rests_, [&](const auto& rest) {
    return !here([&](const PanelHand& hand) { return hand.who == rest.first; });
  });
  std::erase_if(heads_, [&](const auto& head) {
    return !open_.contains(head.first) &&
           !here([&](const PanelHand& hand) { return hand.who.participant == head.first; });
  });
  std::erase_if(fists_, [&](const auto& fist) {
    return open_.empty() || !here([&](const PanelHand& hand) { return hand.who == fist.first; });
  });
  last_fingers_.clear();
  if (!open_.empty())
    for (const PanelHand& hand : hands) last_fingers_[hand.who] = hand.fingers;
}

void PanelWorld::show(const PanelSubjects& subjects) {
  for (auto& [who, panel] : open_) {
    panel.shown = subjects.shown(panel.body);
    for (const ControlDesc& control : panel_controls) {
      const auto k = static_cast<std::size_t>(control.control);
      ControlMotion& motion = panel.motions[k];
      const bool worked = panel.touched[k] || motion.velocity != 0;
      if (control.kind == ControlKind::slider && !worked)
        motion.position = std::clamp(panel.shown[k], 0.0, 1.0);
    }
  }
}

std::vector<Panel> PanelWorld::panels() const {
  std::vector<Panel> out;
  for (const auto& [who, panel] : open_) {
    Panel& seen = out.emplace_back();
    seen.participant = who;
    seen.open = true;
    seen.body = panel.body;
    seen.pose = panel.pose;
    for (std::size_t k = 0; k < panel_control_count; ++k)
      seen.controls[k] = {panel.motions[k].position,
                          panel_controls[k].kind == ControlKind::button && panel.shown[k] >= 0.5,
                          panel.touched[k] || panel.pointed[k] > 0};
  }
  return out;
}

}  // namespace prosector::panel
