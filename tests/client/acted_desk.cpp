#include "tests/client/acted_desk.h"

#include <algorithm>
#include <stdexcept>

#include "client/view/held_bodies.h"

namespace prosector::test {
namespace {

const Vec3 eye(-0.05, 1.55, 0);  // m: below the lamp, looks down, with the picture's right along x
const Quat gaze(Eigen::AngleAxisd(-1.5707963, Vec3::UnitX()));
constexpr double farthest_surface = 4;  // m
constexpr double first_reach = 0.3;     // m: over all that lies on the table
constexpr std::int64_t send_ms = 16, stall_every_ms = 1000;

BusConfig config(BusEnd end) {
  BusConfig out;
  out.end = end;
  return out;
}

LocalNetworkConfig network(const Haste& haste) {
  LocalNetworkConfig out;
  out.delay = std::chrono::milliseconds(haste.delay_ms);
  out.jitter = std::chrono::milliseconds(haste.delay_ms / 2);
  return out;
}

}  // namespace

BodyId body_named(const Simulation& simulation, const std::string& name) {
  for (BodyId body = 0; body < simulation.body_count(); ++body)
    if (simulation.name(body) == name) return body;
  throw std::runtime_error("no body is named " + name);
}

ActedDesk::ActedDesk(Simulation& simulation, const Haste& haste)
    : haste_(haste),
      network_(network(haste)),
      server_bus_(network_.join(config(BusEnd::server))),
      bus_(network_.join(config(BusEnd::dissector))),
      loop_(simulation, *server_bus_, "prosector", nullptr,
            [this](const std::string& line) { log_.push_back(line); },
            {{}, [this] { return network_.now_ns(); }}),
      simulation_(simulation) {
  next_stall_ = stall_every_ms;
  loop_.publisher().flush();  // the network's chances are those of one order of what is said
  Presence presence;
  presence.participant = self_;
  presence.name = "mouse";
  presence.role = Role::host;
  bus_->publish(presence);
  command(Join{});
  wait(0.3);
}

void ActedDesk::stall(double seconds) {
  is_stalled_ = true;
  wait(seconds);
  is_stalled_ = false;
}

void ActedDesk::wait(double seconds) {
  for (int k = 0; k < static_cast<int>(1e3 * seconds); ++k) millisecond();
}

/// The window tells of the pointer's moves between two pictures, too.
void ActedDesk::point_at(const Vec3& place) {
  pointed_ = place;
  if (!hand_.is_pressed() || !hand_.cut_depth()) return;
  const auto point = surface({eye, (pointed_ - eye).normalized()});
  if (point && replica_.bodies().soft(point->body) != nullptr)
    hand_.trace(*point, [this](const Ray& ray, std::optional<BodyId> only) { return found(ray, only); });
}

std::optional<Picked> ActedDesk::surface(const Ray& ray) {
  return view_.surface_at(ray, held_by(replica_, {self_, right_hand}));
}

std::optional<Picked> ActedDesk::found(const Ray& ray, std::optional<BodyId> only) {
  const auto met = surface(ray);
  return met && (!only || met->body == *only) ? met : std::nullopt;
}

void ActedDesk::draw(const Vec3& from, const Vec3& to, double seconds) {
  const int steps = std::max(1, static_cast<int>(seconds / 0.1));  // as the end-to-end test does
  for (int k = 1; k <= steps; ++k) {
    point_at(from + (to - from) * k / steps);
    wait(0.1);
  }
}

bool ActedDesk::holds(BodyId body) const {
  const auto hands = simulation_.hands();
  return std::ranges::any_of(hands, [&](const HandState& hand) { return hand.holding == body; });
}

bool ActedDesk::waits_until_held(BodyId body, bool held, double seconds) {
  for (double t = 0; t < seconds && holds(body) != held; t += 0.05) wait(0.05);
  return holds(body) == held;
}

void ActedDesk::millisecond() {
  if (ms_ >= next_tick_) {
    loop_.tick();
    loop_.publisher().flush();
    next_tick_ = ms_ + haste_.tick_ms;
  }
  if (!is_stalled_) take();
  if (is_stalled_) next_picture_ = next_send_ = ms_ + 1;
  if (ms_ >= next_picture_ && replica_.complete()) {
    picture();
    next_picture_ = ms_ + haste_.picture_ms;
    if (haste_.stall_ms > 0 && ms_ >= next_stall_) {
      next_picture_ = ms_ + haste_.stall_ms;
      next_stall_ = ms_ + stall_every_ms;
    }
  }
  if (ms_ >= next_send_ && last_picture_ > 0) {
    send_hand();
    next_send_ = ms_ + send_ms;
  }
  ++ms_;
  network_.advance(std::chrono::milliseconds(1));
}

void ActedDesk::take() {
  std::vector<Received> received;
  bus_->take(received);
  for (const Received& r : received) {
    if (const auto* result = std::get_if<CommandResult>(&r.message); result && !result->accepted)
      messages_.push_back(result->reason);
    replica_.apply(r);
  }
}

HandGuide ActedDesk::guide(double tick) {
  HandGuide out;
  const HandRef own{self_, right_hand};
  out.pointer = {eye, (pointed_ - eye).normalized()};
  out.back = gaze * Vec3::UnitZ();
  out.pitch = 1.5;
  out.right = gaze * Vec3::UnitX();
  const auto point = surface(out.pointer);
  if (point && point->distance < farthest_surface) {
    out.surface = point->distance;
    out.soft = replica_.bodies().soft(point->body) != nullptr;
    out.level = point->normal.y();
    const RigidReplica* rigid = replica_.bodies().rigid(point->body);
    out.at_blade = rigid != nullptr && !rigid->edges.empty();
  }
  if (asked_for_) pressed_at_ = point ? std::optional(point->body) : std::nullopt;
  asked_for_ = false;
  out.gap = [this](const Vec3& place) -> std::optional<double> {
    const Vec3 way = place - eye;
    const auto behind = surface({eye, way.normalized()});
    return behind ? std::optional(behind->distance - way.norm()) : std::nullopt;
  };
  const auto user = replica_.user(self_, tick);
  if (user && user->hands[right_hand].tracked) out.physical = user->hands[right_hand].pose;
  out.tip = instrument_tip(replica_, own, tick);
  out.blade = held_blade(replica_, own, tick);
  if (point && out.soft) out.tissue = point;
  out.find = [this](const Ray& ray, std::optional<BodyId> only) { return found(ray, only); };
  return out;
}

void ActedDesk::picture() {
  const double tick = replica_.time().advance(network_.now_ns());
  LocalUser user;
  user.participant = self_;
  user.present = true;
  user.at_desk = true;
  ViewSettings settings;
  settings.overlay = false;
  settings.eye = Pose{eye, gaze};
  view_.build(replica_, tick, user, settings);
  gauge_.look(replica_, tick * replica_.time().tick_seconds());
  for (const StrokeFigures& s : gauge_.take_ended()) strokes_.push_back(s);
  const HandGuide now = guide(tick);
  if (last_picture_ == 0) hand_.begin(now.pointer, first_reach);
  hand_.advance(now, last_picture_ == 0 ? 0 : 1e-3 * static_cast<double>(ms_ - last_picture_));
  last_picture_ = std::max<std::int64_t>(ms_, 1);
  for (const HandRequest wish : hand_.take_wishes())
    command(wish == HandRequest::grasp ? CommandBody(Grasp{right_hand, pressed_at_})
                                       : CommandBody(Release{right_hand}));
}

void ActedDesk::send_hand() {
  HandInput input;
  input.participant = self_;
  input.sequence = ++sequence_;
  input.time_ns = network_.now_ns();
  input.head_tracked = true;
  input.head = {eye, gaze};
  HandPose& hand = input.hands[right_hand];
  hand.tracked = !hand_.is_withdrawn();
  hand.pose = hand_.pose();
  hand.flexion.fill(hand_.flexion());
  hand.gesture = hand_.is_closed() ? Gesture::fist : Gesture::flat;
  if (hand_.is_drawing()) hand.buttons = draws_cut;
  bus_->publish(input);
}

void ActedDesk::take_back() {
  hand_.lift_blade();
  for (int k = 0; k < 50 && hand_.draws(); ++k) wait(0.1);
  command(Undo{});
}

void ActedDesk::command(const CommandBody& body) {
  bus_->publish(Command{self_, ++sequence_, body});
}

}  // namespace prosector::test
