#pragma once
// Messages with the state of bodies: rigid poses, points of soft bodies, and the log of their topology.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/hash.h"
#include "common/ids.h"
#include "common/math.h"
#include "common/surface_change.h"

namespace prosector {

inline constexpr std::size_t max_streamed_points = 1024 * 1024;  // of one soft body

/// Message from the server to all clients: the pose and velocities of a rigid body. Best effort, keyed by
/// body. It is sent for moving bodies only.
struct RigidState {
  BodyId body = 0;
  SimTime time;
  Pose pose;
  Vec3 linear_velocity = Vec3::Zero();   // m/s
  Vec3 angular_velocity = Vec3::Zero();  // rad/s
  bool settled = false;                  // last sample before the body falls asleep
};

inline constexpr std::size_t max_chunk_points = 256;
inline constexpr double max_tube_diameter = 10;        // m: largest diameter that a scene may specify
inline constexpr std::size_t soft_chunk_points = 112;  // used by the server: fits one datagram, ≤ 1,200 bytes

/// Message from the server to all clients: positions and velocities of one chunk (fixed part) of a soft
/// body's streamed points. Best effort, keyed by (body, chunk). Each chunk is decodable alone, so a lost
/// datagram costs one chunk only. Values are quantised on the wire within the chunk's bounding box; here they
/// are decoded.
struct SoftState {
  BodyId body = 0;
  std::uint32_t chunk = 0;
  SimTime time;
  std::uint32_t revision = 0;  // topology revision of the points
  std::uint32_t first_point = 0;
  std::vector<Vec3> positions;   // metres, relative to the points' rest positions (StreamedSurface)
  std::vector<Vec3> velocities;  // m/s, coarse: for Hermite interpolation
};

/// Message from the server to all clients: the final shape of a soft body that fell asleep, in full
/// precision. Reliable, transient-local, keyed by body. It corrects a lost last chunk and gives late joiners
/// the shape at rest.
struct Settled {
  BodyId body = 0;
  SimTime time;
  std::uint32_t revision = 0;
  std::uint64_t hash = 0;                  // StateHasher digest of the float positions
  std::vector<Eigen::Vector3f> positions;  // all streamed points, metres, world frame
};

/// Message from the server to all clients: one entry of the ordered log of a soft body's topology changes.
/// Reliable, transient-local, keyed by (body, revision). A body's first revision is that of the compiled
/// scene, or of the cut that created the body; later ones chain to it. A client can start at a revision with
/// a keyframe (the whole surface); the revisions before it are then no longer stored.
struct TopologyRevision {
  BodyId body = 0;
  std::uint32_t revision = 0;
  std::uint64_t previous_hash = 0;  // chain hash of revision − 1 (0 for the first)
  std::uint64_t chain_hash = 0;     // chain_hash_of(): common/surface_patch.h
  std::uint64_t content_hash = 0;   // connectivity, rest shape, masses
  SimTime time;                     // of the tick that made the revision
  TopologyCause cause = TopologyCause::compiled;
  ParticipantId author = 0;        // participant that cut, undid or rewound; 0: none
  std::int32_t piece_of = -1;      // body that this one was cut off from; −1: none
  std::uint64_t surface_hash = 0;  // hash of the slots after this revision
  SurfacePatch patch;              // relative to the previous revision
  ContentHash mesh{}, map{};       // keyframe: Assets of all slots, as in SceneBody; zero: none

  bool keyframe() const { return mesh != ContentHash{}; }
};

}  // namespace prosector
