#pragma once
// A client's copies of the bodies of a session: shapes, motion and topology.

#include <cstdint>
#include <map>
#include <vector>

#include "client/replica/asset_store.h"
#include "client/replica/rigid_replica.h"
#include "client/replica/soft_replica.h"
#include "client/replica/topology_replica.h"
#include "common/body_messages.h"
#include "common/ids.h"
#include "common/mesh.h"
#include "common/scene_messages.h"

namespace prosector {

/// Bodies of a session. They are built from the assets of the server as these arrive. States that arrive
/// before their body are stored.
class BodyReplicas {
 public:
  /// Adds a received state of a body.
  void add(const RigidState& state) { rigid_[state.body].track.add(state); }
  void add(const SoftState& state);
  void add(const Settled& settled);
  void add(const TopologyRevision& revision) { topology_[revision.body].add(revision); }
  /// Builds the bodies of the scene whose assets have arrived. An asset that does not fit its body is counted
  /// and ignored.
  void build(const SceneInfo& scene, const AssetStore& assets, std::int64_t now_ns);
  /// Applies the topology revisions (states after cuts) of all soft bodies as far as their data have arrived.
  void follow_topology(const AssetStore& assets, std::int64_t now_ns);
  /// Returns the soft bodies whose keyframe (whole surface with all cuts) must be requested from the server,
  /// because a change of topology is missing or failed verification. Returns each body at most once a second.
  std::vector<BodyId> take_keyframe_requests(std::int64_t now_ns);

  const RigidReplica* rigid(BodyId body) const;
  SoftReplica* soft(BodyId body);
  const SoftReplica* soft(BodyId body) const;
  /// Returns the displayed topology revision (state after cuts) of a soft body's mesh; null if there is none
  /// yet.
  const TopologyRevision* topology(BodyId body) const;
  /// Returns one hash over the displayed topology revisions (states after cuts) of all soft bodies. It is
  /// equal on all clients that show the same cuts.
  std::uint64_t topology_hash() const;
  /// Returns the shape that replaces the body in collision detection, in the frame of its mesh. Returns null
  /// if there is none, or if it was not received yet. `described`: the body in the scene.
  const TriangleMesh* outline(BodyId body, const SceneBody& described, const AssetStore& assets);
  /// Returns the number of received data that were ignored because they were inconsistent.
  std::uint64_t refused() const;

 private:
  std::map<BodyId, RigidReplica> rigid_;
  std::map<BodyId, SoftReplica> soft_;
  std::map<BodyId, TopologyReplica> topology_;
  std::vector<SoftState> pending_soft_;  // received before the scene or the body's assets
  std::map<BodyId, Settled> settled_;
  std::map<BodyId, TriangleMesh> outlines_;
  std::uint64_t refused_ = 0;

  void build(BodyId id, const SceneBody& body, const AssetStore& assets, std::int64_t now_ns);
  void follow_topology(BodyId body, const AssetStore& assets, std::int64_t now_ns);
  void apply_pending(BodyId body);
};

}  // namespace prosector
