#pragma once
// A client's copy of the session state of one server. The network thread writes it and the view reads it:
// lock it.

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
#include "common/body_messages.h"
#include "common/hand_messages.h"
#include "common/ids.h"
#include "common/math.h"
#include "common/part_messages.h"
#include "common/recording_messages.h"
#include "common/scene_messages.h"
#include "common/session_messages.h"
#include "common/status_messages.h"
#include "idl/bus.h"
#include "idl/message.h"

namespace prosector {

/// A straight cutting edge, m, body frame.
struct CuttingEdge {
  Vec3 from = Vec3::Zero(), to = Vec3::Zero();
};

struct RigidReplica {
  TriangleMesh mesh;
  std::vector<CuttingEdge> edges;  // cut tissue while a hand holds the body
  Pose scene_pose;                 // pose until the first RigidState
  Track<RigidState> track;
};

class Replica {
 public:
  Replica() = default;
  /// Creates a replica with assets from another one: they are identified by their content hash, so they are
  /// valid for any server. Body names are shown in `language`, a tag, if the scene has such names.
  explicit Replica(AssetStore assets, std::string language = "")
      : assets_(std::move(assets)), language_(std::move(language)) {}

  /// Applies a sample. Inconsistent samples (a body that isn't in the scene, an asset that is no mesh) are
  /// counted and ignored.
  void apply(const Received& received);

  /// Reports whether the scene, every asset, the topology log and a first state of every deformable have
  /// arrived. It stays true after cuts: new topology is not shown until its data has arrived.
  bool complete() const { return complete_; }
  /// Returns a text on the missing data: "waiting for 3 of 12 meshes …"; empty: none.
  std::string missing(const Catalogue& words = {}) const;
  /// Returns the received fraction of the data listed by missing(), 0 … 1.
  double progress() const;
  /// Returns a hash of the chain hashes of the displayed topology revisions of all soft bodies: equal on all
  /// clients that show the same cuts.
  std::uint64_t topology_hash() const;
  /// Returns the bodies whose keyframe must be requested from the server; each at most once a second.
  std::vector<BodyId> take_keyframe_requests(std::int64_t now_ns);

  const std::optional<SessionInfo>& session() const { return session_; }
  const std::optional<SceneInfo>& scene() const { return scene_; }
  const std::map<ParticipantId, RosterEntry>& roster() const { return roster_; }
  const std::optional<ServerStatus>& status() const { return status_; }
  /// Returns the newest contact sample of a hand; null: none, or none for a quarter of a second.
  const ContactSample* contact(ParticipantId participant, std::size_t hand) const;
  /// Returns a body's newest status; null before the first, and for rigid bodies.
  const BodyStatus* body_status(BodyId body) const;
  const RigidReplica* rigid(BodyId body) const;
  SoftReplica* soft(BodyId body);
  const SoftReplica* soft(BodyId body) const;
  /// Returns the displayed revision of a soft body's mesh; null: none.
  const TopologyRevision* topology(BodyId body) const;
  /// Returns a part's state; null while it is unchanged.
  const PartState* part(BodyId body) const;
  /// Returns the open panels by owner.
  const std::map<ParticipantId, Panel>& panels() const { return panels_; }
  /// Returns the brightness of the lights that bodies don't carry, 0 … 1.
  double room_lights() const { return room_lights_; }
  /// Returns a body's collision shape, in the frame of its mesh; null: none, or not received yet.
  const TriangleMesh* outline(BodyId body);
  /// Returns the ratio of simulated to real time set by the host; 0: paused.
  double pace() const { return pace_; }
  /// Returns the description of the recording; nullopt: the session is live.
  const std::optional<Recording>& recording() const { return recording_; }
  /// Returns the displayed tick for a playhead at `tick`: no later than the newest received state.
  double shown_tick(double tick) const { return std::min(tick, static_cast<double>(newest_.tick)); }
  bool server_gone() const { return server_gone_; }
  const AssetStore& assets() const { return assets_; }
  std::uint64_t refused() const;

  // ---- State at the playhead
  /// Moves the playhead to `now_ns`. Returns the tick to display.
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
  SimTime newest_;  // time of the newest received state
  std::map<BodyId, RigidReplica> rigid_;
  std::map<BodyId, SoftReplica> soft_;
  std::map<BodyId, TopologyReplica> topology_;
  std::vector<SoftState> pending_soft_;  // received before the scene or the body's assets
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
  void apply_pending(BodyId body);
};

}  // namespace prosector
