#pragma once
// What a client knows of the session as one server runs it, made only from what that one said. Fed by the
// network thread, read by the view: lock it.

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/language/catalogue.h"
#include "client/replica/asset_store.h"
#include "client/replica/playout_clock.h"
#include "client/replica/soft_replica.h"
#include "client/replica/topology_replica.h"
#include "client/replica/track.h"
#include "common/messages.h"
#include "idl/bus.h"

namespace prosector {

/// A straight cutting edge, m, in its body's frame.
struct CuttingEdge {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
};

struct RigidReplica {
  TriangleMesh mesh;
  std::vector<CuttingEdge> edges;  // that cut tissue while a hand holds the body
  Pose scene_pose;                 // where it stands until a RigidState says otherwise
  Track<RigidState> track;
};

class Replica {
 public:
  Replica() = default;
  /// Takes assets that are known already: they are named by content, so they are good for any server. Bodies
  /// are called as in `language`, a tag, where the scene has such names.
  explicit Replica(AssetStore assets, std::string language = "")
      : assets_(std::move(assets)), language_(std::move(language)) {}

  /// Takes one sample. What contradicts itself (a body that isn't in the scene, an asset that is no mesh) is
  /// counted, not believed.
  void apply(const Received& received);

  /// Tells whether the scene, every asset, the topology log and a first state of every deformable are there.
  /// What cuts add later changes that no more: until it is here, it is not shown.
  bool complete() const { return complete_; }
  /// Returns what is still missing, for people: "waiting for 3 of 12 meshes".
  std::string missing(const Catalogue& words = {}) const;
  /// Returns how much of what missing() waits for is here, 0 … 1.
  double progress() const;
  /// Hashes the chain hashes of the topology revisions that are shown of every soft body: equal on every
  /// client that sees the same cuts.
  std::uint64_t topology_hash() const;
  /// Returns the bodies of which the server has to be asked for a keyframe; each at most once a second.
  std::vector<BodyId> take_keyframe_requests(std::int64_t now_ns);

  const std::optional<SessionInfo>& session() const { return session_; }
  const std::optional<SceneInfo>& scene() const { return scene_; }
  const std::map<ParticipantId, RosterEntry>& roster() const { return roster_; }
  const std::optional<ServerStatus>& status() const { return status_; }
  /// Returns the newest word about a hand's contact; null: none, or none for a quarter of a second.
  const ContactSample* contact(ParticipantId participant, std::size_t hand) const;
  /// Returns the newest status of a body; null before its first, and for rigid bodies.
  const BodyStatus* body_status(BodyId body) const;
  const RigidReplica* rigid(BodyId body) const;
  SoftReplica* soft(BodyId body);
  const SoftReplica* soft(BodyId body) const;
  /// Returns the newest revision of a soft body's mesh that is shown; null: none.
  const TopologyRevision* topology(BodyId body) const;
  /// Returns what people made of a body; null while nobody changed it.
  const PartState* part(BodyId body) const;
  /// Returns the open panels, by whose they are.
  const std::map<ParticipantId, Panel>& panels() const { return panels_; }
  /// Returns the brightness of all lights but those that bodies carry, 0 … 1.
  double room_lights() const { return room_lights_; }
  /// Returns what a body collides as, in the frame of its mesh; null: nothing, or not here yet.
  const TriangleMesh* outline(BodyId body);
  /// Returns how many simulated seconds go by in a real one, as the host has it; 0: time stands still.
  double pace() const { return pace_; }
  /// Returns the recorded session that is watched; nullopt: this one is live.
  const std::optional<Recording>& recording() const { return recording_; }
  /// Returns the tick that is shown when the playhead is at `tick`: no later than anything told.
  double shown_tick(double tick) const { return std::min(tick, static_cast<double>(newest_.tick)); }
  bool server_gone() const { return server_gone_; }
  const AssetStore& assets() const { return assets_; }
  std::uint64_t refused() const;

  // ---- At the playhead
  /// Moves the playhead to `now_ns`; returns the tick to draw.
  double advance(std::int64_t now_ns);
  Pose rigid_pose(BodyId body, double tick) const;
  std::optional<UserState> user(ParticipantId participant, double tick) const;
  double tick_seconds() const { return session_ ? 1 / session_->tick_rate : 1.0 / 60; }
  double playout_delay_ms() const { return clock_ ? clock_->delay_ms() : 0; }

 private:
  AssetStore assets_;
  std::string language_;
  std::optional<SessionInfo> session_;
  std::optional<SceneInfo> scene_;
  std::optional<PlayoutClock> clock_;
  std::map<ParticipantId, RosterEntry> roster_;
  std::map<ParticipantId, Track<UserState>> users_;
  std::map<std::pair<ParticipantId, std::uint8_t>, ContactSample> contacts_;
  SimTime newest_;  // that anything told
  std::map<BodyId, RigidReplica> rigid_;
  std::map<BodyId, SoftReplica> soft_;
  std::map<BodyId, TopologyReplica> topology_;
  std::vector<SoftState> early_soft_;  // arrived before the scene or its assets
  std::map<BodyId, Settled> settled_;
  std::optional<ServerStatus> status_;
  std::optional<Recording> recording_;
  std::map<BodyId, BodyStatus> body_status_;
  std::map<BodyId, PartState> parts_;
  std::map<ParticipantId, Panel> panels_;
  double room_lights_ = 1, pace_ = 1;
  std::map<BodyId, TriangleMesh> outlines_;
  bool complete_ = false, lacks_bodies_ = true, server_gone_ = false;
  std::uint64_t refused_ = 0;

  void apply(const Message& message, std::int64_t arrival_ns);
  void forget(const Message& message);
  void build_bodies(std::int64_t now_ns);
  void build(BodyId id, const SceneBody& body, std::int64_t now_ns);
  void follow_topology(BodyId body, std::int64_t now_ns);
  void take_early(BodyId body);
};

}  // namespace prosector
