// Checkpoint record of the panels.

#include <cmath>

#include "server/physics/base/record.h"
#include "server/physics/mechanics/panel/panel_world.h"

namespace prosector::panel {
namespace {

constexpr std::size_t most_entries = 4096;

template <class Io>
void entry(Io& io, typename Io::template Entry<HandRef>& hand) {
  auto& [participant, side] = hand;
  io.number(participant, "participant");
  io.number(side, "hand");
  io.require(side <= stylus_hand, "a third hand");
}

template <class Io>
void entry(Io& io, typename Io::template Entry<Capsule>& capsule) {
  auto& [a, b, radius] = capsule;
  io.vector(a, "one end");
  io.vector(b, "other end");
  io.number(radius, "radius");
  io.require(radius > 0 && radius < 1, "a finger without thickness");
}

}  // namespace

template <class Io>
void PanelWorld::entry_of(Io& io, typename Io::template Entry<Open>& panel, std::size_t body_count) {
  auto& [body, pose, came_up, hold, pinned, motions, home, touched, pointed, shown, idle, came_under] = panel;
  io.number(body, "body");
  io.require(body < body_count, "a panel of a nonexistent body");
  io.pose(pose, "pose");
  io.pose(came_up, "first pose");
  io.optional(hold, "carried");
  if (hold) {
    auto& [who, at] = *hold;
    entry(io, who);
    io.vector(at, "position in the fist");
  }
  io.number(pinned, "pinned ticks");
  for (std::size_t k = 0; k < panel_control_count; ++k) {
    const auto in = io.scope("control", k);
    auto& [position, velocity] = motions[k];
    io.number(position, "position");
    io.require(position >= 0 && position <= 1, "a control outside its range");
    io.number(velocity, "velocity");
    io.require(std::abs(velocity) <= max_control_speed,
               "the checkpoint is damaged: the speed of a panel's control is out of range");
    io.flag(home[k], "pressed home");
    io.flag(touched[k], "touched");
    io.number(pointed[k], "ticks pointed at");
    io.number(shown[k], "shown value");
    io.require(shown[k] >= 0 && shown[k] <= 1,
               "the checkpoint is damaged: the shown value of a panel's control is outside [0, 1]");
  }
  io.number(idle, "idle ticks");
  io.map(came_under, most_entries, "hand under the panel", [&](auto& hand, auto& segments) {
    entry(io, hand);
    io.number(segments, "segments");
    io.require(
        segments != 0,
        "the checkpoint is damaged: a hand is listed as under a panel, but none of its finger segments is");
  });
}

/// Describes all members except `asked_`, which is empty between ticks.
template <class Io>
void PanelWorld::entry_of(Io& io, typename Io::template Entry<PanelWorld>& world, std::size_t body_count) {
  auto& [h, open, heads, rests, last_fingers, fists, tablets, styli, asked] = world;
  io.map(open, most_entries, "panel", [&](auto& who, auto& panel) {
    io.number(who, "participant");
    entry_of(io, panel, body_count);
  });
  io.map(heads, most_entries, "head", [&](auto& who, auto& reader) {
    auto& [eyes, ahead] = reader;
    io.number(who, "participant");
    io.vector(eyes, "eyes");
    io.vector(ahead, "direction");
    io.require(ahead.isZero(0) || std::abs(ahead.norm() - 1) < 1e-5, "a gaze without direction");
  });
  io.map(rests, most_entries, "hand on a body", [&](auto& hand, auto& rest) {
    auto& [body, ticks, answered] = rest;
    entry(io, hand);
    io.number(body, "body");
    io.number(ticks, "ticks");
    io.flag(answered, "answered");
  });
  io.map(last_fingers, most_entries, "fingers", [&](auto& hand, auto& segments) {
    entry(io, hand);
    io.list(segments, most_fingers, "segment", [&](auto& segment) { entry(io, segment); });
  });
  io.map(fists, most_entries, "fist", [&](auto& hand, auto& fist) {
    auto& [closed, since, at] = fist;
    entry(io, hand);
    io.flag(closed, "closed");
    io.number(since, "ticks since it closed");
    io.require(since <= no_fist, "a fist with a negative time");
    io.vector(at, "palm");
  });
  io.map(tablets, most_entries, "tablet", [&](auto& who, auto& tablet) {
    auto& [pose, seen, answered, unseen] = tablet;
    io.number(who, "participant");
    io.pose(pose, "pose");
    io.flag(seen, "seen");
    io.flag(answered, "answered");
    io.number(unseen, "unseen ticks");
  });
  io.map(styli, most_entries, "stylus", [&](auto& who, auto& shaft) {
    io.number(who, "participant");
    entry(io, shaft);
  });
}

void PanelWorld::save(RecordWriter& io) const {
  entry_of(io, *this, 0);
}

void PanelWorld::load(RecordReader& io, std::size_t body_count) {
  PanelWorld read(h_);
  entry_of(io, read, body_count);
  *this = std::move(read);
}

}  // namespace prosector::panel
