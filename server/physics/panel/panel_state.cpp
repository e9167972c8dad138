// The panels' part of a checkpoint.

#include "server/physics/panel/panel_world.h"

namespace prosector {
namespace {

constexpr std::size_t most_entries = 4096;

void add(ByteWriter& out, const HandRef& hand) {
  out.add(hand.participant);
  out.add(hand.hand);
}

HandRef read_hand_ref(ByteReader& in) {
  HandRef hand;
  hand.participant = in.number<ParticipantId>();
  hand.hand = in.number<std::uint8_t>();
  in.require(hand.hand <= stylus_hand, "a third hand");
  return hand;
}

void add(ByteWriter& out, const Capsule& c) {
  out.add(c.a);
  out.add(c.b);
  out.add(c.radius);
}

Capsule read_capsule(ByteReader& in) {
  Capsule c;
  c.a = in.vector();
  c.b = in.vector();
  c.radius = in.number<double>();
  in.require(c.radius > 0 && c.radius < 1, "a finger without thickness");
  return c;
}

/// Reads `count` entries whose keys ascend.
template <class Map, class ReadKey, class ReadValue>
Map read_map(ByteReader& in, ReadKey read_key, ReadValue read_value) {
  Map out;
  for (std::size_t n = in.count(most_entries); n > 0; --n) {
    const auto key = read_key();
    in.require(out.empty() || out.rbegin()->first < key, "panels out of order");
    out.emplace_hint(out.end(), key, read_value());
  }
  return out;
}

}  // namespace

void PanelWorld::save(ByteWriter& out) const {
  out.add(static_cast<std::uint64_t>(open_.size()));
  for (const auto& [who, panel] : open_) {
    out.add(who);
    out.add(panel.body);
    out.add(panel.pose);
    out.add(panel.came_up);
    out.add(static_cast<std::uint8_t>(panel.hold.has_value()));
    if (panel.hold) {
      add(out, panel.hold->who);
      out.add(panel.hold->at);
    }
    out.add(panel.pinned);
    out.add(panel.idle);
    out.add(static_cast<std::uint64_t>(panel.came_under.size()));
    for (const auto& [hand, segments] : panel.came_under) {
      add(out, hand);
      out.add(segments);
    }
    for (std::size_t k = 0; k < panel_control_count; ++k) {
      out.add(panel.motions[k].position);
      out.add(panel.motions[k].velocity);
      out.add(static_cast<std::uint8_t>(panel.home[k]));
      out.add(static_cast<std::uint8_t>(panel.touched[k]));
      out.add(panel.pointed[k]);
      out.add(panel.shown[k]);
    }
  }
  out.add(static_cast<std::uint64_t>(heads_.size()));
  for (const auto& [who, reader] : heads_) {
    out.add(who);
    out.add(reader.eyes);
    out.add(reader.ahead);
  }
  out.add(static_cast<std::uint64_t>(rests_.size()));
  for (const auto& [hand, rest] : rests_) {
    add(out, hand);
    out.add(rest.body);
    out.add(rest.ticks);
    out.add(static_cast<std::uint8_t>(rest.answered));
  }
  out.add(static_cast<std::uint64_t>(last_fingers_.size()));
  for (const auto& [hand, segments] : last_fingers_) {
    add(out, hand);
    out.add(static_cast<std::uint64_t>(segments.size()));
    for (const Capsule& c : segments) add(out, c);
  }
  save_held(out);
}

/// Saves what hands carry, and what they hold.
void PanelWorld::save_held(ByteWriter& out) const {
  out.add(static_cast<std::uint64_t>(fists_.size()));
  for (const auto& [hand, fist] : fists_) {
    add(out, hand);
    out.add(static_cast<std::uint8_t>(fist.closed));
    out.add(fist.since);
    out.add(fist.at);
  }
  out.add(static_cast<std::uint64_t>(tablets_.size()));
  for (const auto& [who, tablet] : tablets_) {
    out.add(who);
    out.add(tablet.pose);
    out.add(static_cast<std::uint8_t>(tablet.seen));
    out.add(static_cast<std::uint8_t>(tablet.answered));
    out.add(tablet.unseen);
  }
  out.add(static_cast<std::uint64_t>(styli_.size()));
  for (const auto& [who, shaft] : styli_) {
    out.add(who);
    add(out, shaft);
  }
}

void PanelWorld::load(ByteReader& in, std::size_t body_count) {
  const auto id = [&] { return in.number<ParticipantId>(); };
  const auto hand = [&] { return read_hand_ref(in); };
  const auto share = [&] {
    const auto value = in.number<double>();
    in.require(value >= 0 && value <= 1, "a control outside its way");
    return value;
  };
  PanelWorld read(h_);
  read.open_ = read_map<decltype(open_)>(in, id, [&] {
    Open panel;
    panel.body = in.number<BodyId>();
    in.require(panel.body < body_count, "a panel of a body that isn't there");
    panel.pose = in.pose();
    panel.came_up = in.pose();
    if (in.flag()) {
      panel.hold.emplace().who = read_hand_ref(in);
      panel.hold->at = in.vector();
    }
    panel.pinned = in.number<std::uint32_t>();
    panel.idle = in.number<std::uint32_t>();
    panel.came_under = read_map<decltype(panel.came_under)>(in, hand, [&] {
      const auto segments = in.number<std::uint64_t>();
      in.require(segments != 0, "a hand under a panel without a finger there");
      return segments;
    });
    for (std::size_t k = 0; k < panel_control_count; ++k) {
      panel.motions[k].position = share();
      panel.motions[k].velocity = in.number<double>();
      in.require(std::abs(panel.motions[k].velocity) <= max_control_speed, "a control that flies");
      panel.home[k] = in.flag();
      panel.touched[k] = in.flag();
      panel.pointed[k] = in.number<std::uint32_t>();
      panel.shown[k] = share();
    }
    return panel;
  });
  read.heads_ = read_map<decltype(heads_)>(in, id, [&] {
    PanelReader reader{in.vector(), in.vector()};
    in.require(reader.ahead.isZero(0) || std::abs(reader.ahead.norm() - 1) < 1e-5,
               "a gaze without direction");
    return reader;
  });
  read.rests_ = read_map<decltype(rests_)>(in, hand, [&] {
    Rest rest;
    rest.body = in.number<BodyId>();
    rest.ticks = in.number<std::uint32_t>();
    rest.answered = in.flag();
    return rest;
  });
  read.last_fingers_ = read_map<decltype(last_fingers_)>(in, hand, [&] {
    std::vector<Capsule> segments(in.count(most_fingers));
    for (Capsule& c : segments) c = read_capsule(in);
    return segments;
  });
  read.load_held(in);
  *this = std::move(read);
}

void PanelWorld::load_held(ByteReader& in) {
  const auto id = [&] { return in.number<ParticipantId>(); };
  const auto hand = [&] { return read_hand_ref(in); };
  fists_ = read_map<decltype(fists_)>(in, hand, [&] {
    Fist fist;
    fist.closed = in.flag();
    fist.since = in.number<std::uint32_t>();
    in.require(fist.since <= no_fist, "a fist from before all time");
    fist.at = in.vector();
    return fist;
  });
  tablets_ = read_map<decltype(tablets_)>(in, id, [&] {
    Tablet tablet;
    tablet.pose = in.pose();
    tablet.seen = in.flag();
    tablet.answered = in.flag();
    tablet.unseen = in.number<std::uint32_t>();
    return tablet;
  });
  styli_ = read_map<decltype(styli_)>(in, id, [&] { return read_capsule(in); });
}

}  // namespace prosector
