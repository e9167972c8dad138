#include "client/replica/replica.h"

#include "client/replica/shown_names.h"
#include "common/assert.h"

namespace prosector {
namespace {

constexpr double contact_life = 0.25;  // s: persistent contacts are sent each tick

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};

Pose interpolate(const Pose& a, const Vec3& va, const Pose& b, const Vec3& vb, double h, double s) {
  return {hermite(a.p, va, b.p, vb, h, s), a.q.slerp(s, b.q)};
}

Pose interpolate(const Pose& a, const Pose& b, double s) {
  return {a.p + s * (b.p - a.p), a.q.slerp(s, b.q)};
}

/// Returns the time of a streamed state or status, whose arrival updates the playout clock; null for other
/// messages.
const SimTime* streamed_time(const Message& message) {
  return std::visit(Overloaded{
                        [](const UserState& m) { return &m.time; },
                        [](const RigidState& m) { return &m.time; },
                        [](const SoftState& m) { return &m.time; },
                        [](const ContactSample& m) { return &m.time; },
                        [](const ServerStatus& m) { return &m.time; },
                        [](const auto&) -> const SimTime* { return nullptr; },
                    },
                    message);
}

/// Stores an open panel of a participant, or removes a closed one.
void update_panel(std::map<ParticipantId, Panel>& open, const Panel& panel) {
  if (panel.open)
    open[panel.participant] = panel;
  else
    open.erase(panel.participant);
}

}  // namespace

void Replica::apply(const Received& received) {
  if (received.liveness == Liveness::gone)
    forget(received.message);
  else
    apply(received.message, received.arrival_ns);
  if (std::holds_alternative<AssetChunk>(received.message) ||
      std::holds_alternative<TopologyRevision>(received.message))
    bodies_.follow_topology(assets_, received.arrival_ns);
  if (lacks_bodies_ && session_ && scene_) build_bodies(received.arrival_ns);
}

void Replica::apply(const Message& message, std::int64_t arrival_ns) {
  if (const SimTime* time = streamed_time(message)) time_.arrived(*time, arrival_ns);
  std::visit(
      Overloaded{
          [&](const SessionInfo& m) {
            session_ = m;
            server_gone_ = false;
            time_.set_tick_rate(m.tick_rate);
          },
          [&](const SceneInfo& m) {
            // A scene only grows, by pieces that were cut off.
            if (scene_ && m.bodies.size() <= scene_->bodies.size()) return;
            scene_ = m;
            show_names(*scene_, language_);
            lacks_bodies_ = true;
          },
          [&](const AssetChunk& m) { assets_.add(m); },
          [&](const RosterEntry& m) { roster_[m.participant] = m; },
          [&](const UserState& m) { users_[m.participant].add(m); },
          [&](const RigidState& m) {
            if (!scene_ || m.body < scene_->bodies.size())
              bodies_.add(m);
            else
              ++refused_;
          },
          [&](const SoftState& m) { bodies_.add(m); }, [&](const Settled& m) { bodies_.add(m); },
          [&](const TopologyRevision& m) { bodies_.add(m); },
          [&](const ContactSample& m) {
            if (!roster_.contains(m.participant)) return;  // the participant is not known yet, or has left
            ContactSample& known = contacts_[{m.participant, m.hand}];
            if (m.time >= known.time) known = m;
          },
          [&](const ServerStatus& m) { status_ = m; }, [&](const BodyStatus& m) { body_status_[m.body] = m; },
          [&](const PartState& m) { parts_[m.body] = m; }, [&](const Panel& m) { update_panel(panels_, m); },
          [&](const RoomState& m) {
            room_lights_ = m.lights;
            time_.set_pace(m.pace);
          },
          [&](const Recording& m) { recording_ = m; }, [](const auto&) {},  // messages for the server only
      },
      message);
}

void Replica::forget(const Message& message) {
  std::visit(Overloaded{
                 [&](const SessionInfo&) { server_gone_ = true; },
                 [&](const RosterEntry& m) {
                   roster_.erase(m.participant);
                   users_.erase(m.participant);
                   std::erase_if(contacts_, [&](const auto& c) { return c.first.first == m.participant; });
                 },
                 [&](const Panel& m) { panels_.erase(m.participant); },
                 [](const auto&) {},
             },
             message);
}

void Replica::build_bodies(std::int64_t now_ns) {
  PROSECTOR_ASSERT(session_.has_value() && scene_.has_value());
  bodies_.build(*scene_, assets_, now_ns);
  lacks_bodies_ = !missing().empty();
  complete_ = complete_ || !lacks_bodies_;
}

std::uint64_t Replica::refused() const {
  return refused_ + assets_.refused() + bodies_.refused();
}

std::string Replica::missing(const Catalogue& words) const {
  if (!session_) return words.tr("waiting for the session's description");
  if (!scene_) return words.tr("waiting for the scene");
  std::size_t meshes = 0, states = 0, topologies = 0;
  for (BodyId id = 0; id < scene_->bodies.size(); ++id) {
    if (scene_->bodies[id].kind == BodyKind::rigid) {
      const RigidReplica* rigid = bodies_.rigid(id);
      meshes += rigid == nullptr || rigid->mesh.positions.empty();
    } else {
      const SoftReplica* soft = bodies_.soft(id);
      meshes += soft == nullptr;
      states += soft == nullptr || !soft->complete();
      topologies += bodies_.topology(id) == nullptr;
    }
  }
  if (meshes + states + topologies == 0) return "";
  return words.tr("waiting for {} of {} meshes, {} initial states, {} topology logs", meshes,
                  scene_->bodies.size(), states, topologies);
}

double Replica::progress() const {
  if (!session_ || !scene_ || scene_->bodies.empty()) return scene_ && session_ ? 1 : 0;
  double sum = 0;
  for (BodyId id = 0; id < scene_->bodies.size(); ++id) {
    const SceneBody& body = scene_->bodies[id];
    const double mesh = assets_.share(body.mesh);
    if (body.kind == BodyKind::rigid) {
      sum += mesh;
      continue;
    }
    const SoftReplica* soft = bodies_.soft(id);
    const double state = soft != nullptr && soft->complete() ? 1 : 0;
    sum += (mesh + assets_.share(body.map) + state + (bodies_.topology(id) != nullptr ? 1 : 0)) / 4;
  }
  return sum / static_cast<double>(scene_->bodies.size());
}

const ContactSample* Replica::contact(ParticipantId participant, std::size_t hand) const {
  const auto it = contacts_.find({participant, static_cast<std::uint8_t>(hand)});
  if (it == contacts_.end()) return nullptr;
  const SimTime &sampled = it->second.time, &newest = time_.newest();
  const bool fresh =
      sampled.epoch == newest.epoch && static_cast<double>(newest.tick) - static_cast<double>(sampled.tick) <=
                                           contact_life / time_.tick_seconds();
  return fresh ? &it->second : nullptr;
}

const BodyStatus* Replica::body_status(BodyId body) const {
  const auto it = body_status_.find(body);
  return it == body_status_.end() ? nullptr : &it->second;
}

const PartState* Replica::part(BodyId body) const {
  const auto it = parts_.find(body);
  return it == parts_.end() ? nullptr : &it->second;
}

Pose Replica::rigid_pose(BodyId body, double tick) const {
  const RigidReplica* rigid = bodies_.rigid(body);
  if (rigid == nullptr) return {};
  const auto b = rigid->track.at(tick, time_.tick_seconds());
  if (b.from == nullptr) return rigid->scene_pose;
  if (b.from == b.to) return b.from->pose;
  return interpolate(b.from->pose, b.from->linear_velocity, b.to->pose, b.to->linear_velocity, b.seconds,
                     b.share);
}

std::optional<UserState> Replica::user(ParticipantId participant, double tick) const {
  const auto it = users_.find(participant);
  if (it == users_.end()) return std::nullopt;
  const auto b = it->second.at(tick, time_.tick_seconds());
  if (b.from == nullptr) return std::nullopt;
  if (b.from == b.to) return *b.from;
  UserState out = *b.to;
  out.head = interpolate(b.from->head, b.to->head, b.share);
  for (std::size_t h = 0; h < out.hands.size(); ++h) {
    if (!b.from->hands[h].tracked || !b.to->hands[h].tracked) continue;
    out.hands[h].pose = interpolate(b.from->hands[h].pose, b.to->hands[h].pose, b.share);
    for (std::size_t f = 0; f < fingers; ++f)
      out.hands[h].flexion[f] =
          b.from->hands[h].flexion[f] + b.share * (b.to->hands[h].flexion[f] - b.from->hands[h].flexion[f]);
  }
  return out;
}

}  // namespace prosector
