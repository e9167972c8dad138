#include "tests/play/person.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector::test {
namespace {

constexpr double fingertips = 0.18;  // m ahead of the wrist
constexpr double beside = 0.25;      // m from an organ, where sweeps begin
constexpr double slowest = 0.05,
                 fastest = 20;  // m/s: a mouse flicks a hand through the room in a tick or two

}  // namespace

Pose Person::wrist() const {
  return {at_ + rotated_ * Vec3(0, 0, fingertips), rotated_};
}

double Person::some_speed() {
  return slowest * std::pow(fastest / slowest, random_.uniform(0, 1));
}

Vec3 Person::some_point(const Simulation& simulation) {
  std::vector<BodyId> organs;
  for (BodyId b = 0; b < simulation.body_count(); ++b)
    if (simulation.kind(b) == BodyKind::soft && !simulation.soft(b).anatomy().embedding.rows.empty())
      organs.push_back(b);
  if (organs.empty()) return random_.point(0.3) + Vec3(0, 1, 0);
  const BodyId organ = organs[random_.below(organs.size())];
  const Anatomy& anatomy = simulation.soft(organ).anatomy();
  const std::size_t vertex = random_.below(anatomy.embedding.rows.size());
  return anatomy.embedding.apply(vertex, simulation.soft_state(organ).motion.x.data());
}

void Person::sweep(const Simulation& simulation) {
  const Vec3 through = some_point(simulation) + random_.point(0.02);
  Vec3 along = random_.point(1);
  along.y() *= 0.5;  // hands come from the side more often than from below
  along = along.norm() > 1e-3 ? along.normalized() : Vec3::UnitX();
  const double speed = some_speed();
  // Back and forth; the way is given last first.
  way_.push_back({through + beside * along, speed, random_.uniform(0, 0.5), random_.uniform(0, 0.9)});
  if (random_.below(3) == 0) way_.push_back({through, speed, random_.uniform(0, 2), random_.uniform(0, 0.9)});
  way_.push_back({through - beside * along, 2, 0, random_.uniform(0, 0.9)});
  story_ += " sweep";
}

void Person::poke(const Simulation& simulation) {
  const Vec3 place = some_point(simulation);
  const Vec3 above = place + Vec3(random_.uniform(-0.05, 0.05), 0.15, random_.uniform(-0.05, 0.05));
  way_.push_back({above, some_speed(), 0, 0.1});
  way_.push_back({place - Vec3(0, random_.uniform(0, 0.12), 0), some_speed(), random_.uniform(0, 2), 0.1});
  way_.push_back({above, 2, 0, random_.uniform(0, 0.9)});
  story_ += " poke";
}

void Person::pull(const Simulation& simulation) {
  const Vec3 place = some_point(simulation);
  const Vec3 to = place + random_.point(0.3) + Vec3(0, 0.1, 0);
  way_.push_back({to, 1, 0.2, 0.1, Waypoint::Then::release});
  way_.push_back({to, some_speed(), random_.uniform(0, 1), 0.8});
  way_.push_back({place, 1, 0.2, 0.8, Waypoint::Then::grasp});
  way_.push_back({place + Vec3(0, 0.1, 0.1), 2, 0, 0.1});
  story_ += " pull";
}

void Person::wield(const Simulation& simulation) {
  std::vector<BodyId> tools;
  for (BodyId b = 0; b < simulation.scene().rigid.size(); ++b)
    if (simulation.scene().rigid[b].tool != "none") tools.push_back(b);
  if (tools.empty()) return sweep(simulation);
  const Vec3 tool = simulation.rigid_state(tools[random_.below(tools.size())]).pose.p;
  const Vec3 place = some_point(simulation);
  const Vec3 along = 0.12 * random_.point(1).normalized();
  const double speed = std::min(some_speed(), 2.0);
  way_.push_back({place + Vec3(0, 0.3, 0), 1, 0, 0.1, Waypoint::Then::release});
  for (std::size_t stroke = 1 + random_.below(3); stroke > 0; --stroke) {
    way_.push_back({place + along, speed, 0, 0.7});
    way_.push_back({place - along, speed, 0, 0.7});
  }
  way_.push_back({place + Vec3(0, 0.25, 0), 1, 0, 0.7});
  way_.push_back({tool, 0.5, 0.2, 0.7, Waypoint::Then::grasp});
  way_.push_back({tool + Vec3(0, 0.1, 0), 2, 0, 0.1});
  story_ += " wield";
}

/// Takes a part out of its place or puts it back, or takes back a cut.
void Person::meddle(const Simulation& simulation, TickInput& input) {
  std::vector<BodyId> parts;
  for (BodyId b = 0; b < simulation.body_count(); ++b)
    if (simulation.kind(b) == BodyKind::soft && simulation.soft(b).desc().part) parts.push_back(b);
  if (random_.below(3) == 0 || parts.empty()) {
    input.cuts.push_back({.kind = CutEvent::Kind::undo, .participant = who_});
    story_ += " undo";
    return;
  }
  const BodyId part = parts[random_.below(parts.size())];
  const bool attached = simulation.part(part).attached;
  PartEvent event;
  event.kind = attached ? PartEvent::Kind::detach : PartEvent::Kind::attach;
  event.participant = who_;
  event.body = part;
  input.parts.push_back(event);
  story_ += attached ? " detach" : " attach";
}

void Person::plan(const Simulation& simulation, TickInput& input) {
  ++acts_;
  rotated_ = Quat(Eigen::AngleAxisd(random_.uniform(-1.5, 1.5), Vec3::UnitY()) *
                  Eigen::AngleAxisd(random_.uniform(-1.3, 0.3), Vec3::UnitX()) *
                  Eigen::AngleAxisd(random_.uniform(-1.5, 1.5), Vec3::UnitZ()));
  const std::size_t what = random_.below(16);
  if (what < 6) return sweep(simulation);
  if (what < 9) return poke(simulation);
  if (what < 12) return pull(simulation);
  if (what < 15) return wield(simulation);
  meddle(simulation, input);
}

void Person::act(const Simulation& simulation, TickInput& input) {
  const double h = 1 / simulation.scene().tick_rate;
  if (!there_) input.events.push_back({HandEvent::Kind::appear, who_, right_hand});
  there_ = true;
  if (way_.empty()) plan(simulation, input);
  if (!way_.empty()) {
    const Waypoint& next = way_.back();
    const Vec3 way = next.at - at_;
    const double far = way.norm(), step = h * next.speed;
    at_ = far > step ? Vec3(at_ + step / far * way) : next.at;
    if (far <= step && (waited_ += h) > next.wait) {
      waited_ = 0;
      flexion_ = next.flexion;
      if (next.then == Waypoint::Then::grasp)
        input.events.push_back({HandEvent::Kind::grasp, who_, right_hand});
      if (next.then == Waypoint::Then::release)
        input.events.push_back({HandEvent::Kind::release, who_, right_hand});
      way_.pop_back();
    }
  }
  HandTarget target{who_, right_hand, wrist()};
  target.flexion.fill(flexion_);
  input.targets.push_back(target);
}

void Person::leave(TickInput& input) {
  if (there_) input.events.push_back({HandEvent::Kind::vanish, who_, right_hand});
  there_ = false;
  way_.clear();
  waited_ = 0;
}

}  // namespace prosector::test
