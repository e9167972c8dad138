#include "client/replica/replica.h"

#include <algorithm>

#include "client/replica/shown_names.h"
#include "common/assert.h"
#include "common/asset.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr std::size_t max_early_chunks = 4096;  // soft-body samples stored until their body is known
constexpr double contact_life = 0.25;           // s: persistent contacts are sent each tick

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

/// Returns cutting edges from a mesh whose vertices are their end points, in pairs. Throws InputError if the
/// asset is invalid.
std::vector<CuttingEdge> decode_edges(std::span<const std::uint8_t> bytes) {
  const TriangleMesh ends = decode_triangle_mesh(bytes);
  if (ends.positions.size() % 2 != 0)
    throw InputError("asset of the server is invalid: a cutting edge has no second end point");
  std::vector<CuttingEdge> out;
  for (std::size_t k = 0; k < ends.positions.size(); k += 2)
    out.push_back({ends.positions[k], ends.positions[k + 1]});
  return out;
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
    for (const auto& [body, soft] : soft_) follow_topology(body, received.arrival_ns);
  if (lacks_bodies_ && session_ && scene_) build_bodies(received.arrival_ns);
}

void Replica::apply(const Message& message, std::int64_t arrival_ns) {
  if (const SimTime* time = streamed_time(message)) {
    newest_ = std::max(newest_, *time);
    if (clock_) clock_->arrived(*time, arrival_ns);
  }
  std::visit(
      Overloaded{
          [&](const SessionInfo& m) {
            session_ = m;
            server_gone_ = false;
            if (!clock_) clock_.emplace(m.tick_rate).set_pace(pace_);
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
              rigid_[m.body].track.add(m);
            else
              ++refused_;
          },
          [&](const SoftState& m) {
            const auto it = soft_.find(m.body);
            if (it != soft_.end() && it->second.add(m)) return;
            if (pending_soft_.size() < max_early_chunks) pending_soft_.push_back(m);
          },
          [&](const Settled& m) {
            settled_[m.body] = m;
            if (const auto it = soft_.find(m.body); it != soft_.end()) it->second.add(m);
          },
          [&](const TopologyRevision& m) { topology_[m.body].add(m); },
          [&](const ContactSample& m) {
            if (!roster_.contains(m.participant)) return;  // the participant is not known yet, or has left
            ContactSample& known = contacts_[{m.participant, m.hand}];
            if (m.time >= known.time) known = m;
          },
          [&](const ServerStatus& m) { status_ = m; }, [&](const BodyStatus& m) { body_status_[m.body] = m; },
          [&](const PartState& m) { parts_[m.body] = m; }, [&](const Panel& m) { update_panel(panels_, m); },
          [&](const RoomState& m) {
            room_lights_ = m.lights;
            pace_ = m.pace;
            if (clock_) clock_->set_pace(pace_);
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
  for (BodyId id = 0; id < scene_->bodies.size(); ++id) {
    const SceneBody& body = scene_->bodies[id];
    try {
      build(id, body, now_ns);
    } catch (const InputError&) {
      ++refused_;
    }
  }
  lacks_bodies_ = !missing().empty();
  complete_ = complete_ || !lacks_bodies_;
}

void Replica::build(BodyId id, const SceneBody& body, std::int64_t now_ns) {
  const auto mesh = assets_.find(body.mesh);
  if (!mesh) return;
  const auto map_bytes = assets_.find(body.map);
  if (body.kind == BodyKind::rigid) {
    const bool has_edges = body.map != ContentHash{};
    RigidReplica& rigid = rigid_[id];
    if (!rigid.mesh.positions.empty() || (has_edges && !map_bytes)) return;
    rigid.mesh = decode_triangle_mesh(*mesh);
    rigid.scene_pose = body.pose;
    if (has_edges) rigid.edges = decode_edges(*map_bytes);
    return;
  }
  if (!map_bytes || soft_.contains(id) || body.points == 0 || body.chunk_points == 0) return;
  TriangleMesh rest = decode_triangle_mesh(*mesh);
  StreamedSurface streamed = decode_streamed_surface(*map_bytes);
  if (streamed.map.rows.size() != rest.positions.size())
    throw InputError(
        "asset of the server is invalid: the embedding map does not have one row for each surface vertex");
  if (streamed.rest.size() != body.points)
    throw InputError(
        "asset of the server is invalid: the number of rest positions differs from the number of streamed "
        "points");
  soft_.emplace(id, SoftReplica(body, std::move(rest), std::move(streamed)));
  apply_pending(id);
  follow_topology(id, now_ns);
}

void Replica::follow_topology(BodyId body, std::int64_t now_ns) {
  const auto topology = topology_.find(body);
  if (topology == topology_.end()) return;
  if (topology->second.advance(assets_, soft_.at(body), now_ns)) apply_pending(body);
}

/// Applies samples that arrived before the body's assets or topology.
void Replica::apply_pending(BodyId body) {
  PROSECTOR_ASSERT(soft_.contains(body));
  SoftReplica& soft = soft_.at(body);
  if (const auto settled = settled_.find(body); settled != settled_.end()) soft.add(settled->second);
  std::erase_if(pending_soft_, [&](const SoftState& chunk) { return chunk.body == body && soft.add(chunk); });
}

std::vector<BodyId> Replica::take_keyframe_requests(std::int64_t now_ns) {
  std::vector<BodyId> out;
  for (auto& [body, topology] : topology_)
    if (topology.needs_keyframe(now_ns)) out.push_back(body);
  return out;
}

std::uint64_t Replica::refused() const {
  std::uint64_t out = refused_ + assets_.refused();
  for (const auto& [body, topology] : topology_) out += topology.refused();
  return out;
}

std::string Replica::missing(const Catalogue& words) const {
  if (!session_) return words.tr("waiting for the session's description");
  if (!scene_) return words.tr("waiting for the scene");
  std::size_t meshes = 0, states = 0, topologies = 0;
  for (BodyId id = 0; id < scene_->bodies.size(); ++id) {
    if (scene_->bodies[id].kind == BodyKind::rigid) {
      const auto it = rigid_.find(id);
      meshes += it == rigid_.end() || it->second.mesh.positions.empty();
    } else {
      const auto it = soft_.find(id);
      meshes += it == soft_.end();
      states += it == soft_.end() || !it->second.complete();
      const auto topology = topology_.find(id);
      topologies += topology == topology_.end() || topology->second.shown() == nullptr;
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
    const auto soft = soft_.find(id);
    const double state = soft != soft_.end() && soft->second.complete() ? 1 : 0;
    sum += (mesh + assets_.share(body.map) + state + (topology(id) != nullptr ? 1 : 0)) / 4;
  }
  return sum / static_cast<double>(scene_->bodies.size());
}

const TopologyRevision* Replica::topology(BodyId body) const {
  const auto found = topology_.find(body);
  return found == topology_.end() ? nullptr : found->second.shown();
}

std::uint64_t Replica::topology_hash() const {
  StateHasher hasher;
  for (const auto& [body, topology] : topology_) {
    if (topology.shown() == nullptr) continue;
    hasher.add(body);
    hasher.add(topology.shown()->chain_hash);
  }
  return hasher.digest();
}

const ContactSample* Replica::contact(ParticipantId participant, std::size_t hand) const {
  const auto it = contacts_.find({participant, static_cast<std::uint8_t>(hand)});
  if (it == contacts_.end()) return nullptr;
  const SimTime& told = it->second.time;
  const bool fresh =
      told.epoch == newest_.epoch &&
      static_cast<double>(newest_.tick) - static_cast<double>(told.tick) <= contact_life / tick_seconds();
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

const TriangleMesh* Replica::outline(BodyId body) {
  if (!scene_ || body >= scene_->bodies.size()) return nullptr;
  const SceneBody& described = scene_->bodies[body];
  if (const auto it = outlines_.find(body); it != outlines_.end()) return &it->second;
  const bool has_own = described.outline != ContentHash{};
  if (!has_own && described.fidelity == Fidelity::none) return nullptr;
  const auto bytes = assets_.find(has_own ? described.outline : described.mesh);
  if (!bytes) return nullptr;
  try {
    return &outlines_.emplace(body, decode_triangle_mesh(*bytes)).first->second;
  } catch (const InputError&) {
    ++refused_;
    return &outlines_[body];  // an empty mesh, so that decoding is not repeated
  }
}

const RigidReplica* Replica::rigid(BodyId body) const {
  const auto it = rigid_.find(body);
  return it == rigid_.end() ? nullptr : &it->second;
}

SoftReplica* Replica::soft(BodyId body) {
  const auto it = soft_.find(body);
  return it == soft_.end() ? nullptr : &it->second;
}

const SoftReplica* Replica::soft(BodyId body) const {
  const auto it = soft_.find(body);
  return it == soft_.end() ? nullptr : &it->second;
}

double Replica::advance(std::int64_t now_ns) {
  return clock_ ? clock_->playhead(now_ns) : 0;
}

Pose Replica::rigid_pose(BodyId body, double tick) const {
  const RigidReplica* rigid = this->rigid(body);
  if (rigid == nullptr) return {};
  const auto b = rigid->track.at(tick, tick_seconds());
  if (b.from == nullptr) return rigid->scene_pose;
  if (b.from == b.to) return b.from->pose;
  return interpolate(b.from->pose, b.from->linear_velocity, b.to->pose, b.to->linear_velocity, b.seconds,
                     b.share);
}

std::optional<UserState> Replica::user(ParticipantId participant, double tick) const {
  const auto it = users_.find(participant);
  if (it == users_.end()) return std::nullopt;
  const auto b = it->second.at(tick, tick_seconds());
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
