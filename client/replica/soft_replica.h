#pragma once
// A client's copy of one deformable: streamed points in chunks, and the surface embedded in them.
//
// Cuts only append points, so samples of other revisions are still valid for the points that both have.

#include <cstdint>
#include <vector>

#include "client/replica/track.h"
#include "common/body_messages.h"
#include "common/ids.h"
#include "common/math.h"
#include "common/scene_messages.h"
#include "common/surface_change.h"
#include "common/surface_patch.h"

namespace prosector {

class SoftReplica {
 public:
  /// Creates the soft body from its scene entry `body` and its assets. `rest` is the surface at rest,
  /// `streamed` the streamed points' rest positions and the map from points to surface; their sizes must
  /// agree.
  SoftReplica(const SceneBody& body, TriangleMesh rest, StreamedSurface streamed);

  /// Adds a received sample of one chunk of points; drops one that doesn't fit this body. Returns false if it
  /// also has points of a later topology revision: then it must be added again after that revision has
  /// arrived.
  bool add(const SoftState& chunk);
  bool add(const Settled& settled);  // adds all chunks, at full precision
  bool complete() const { return missing_chunks_ == 0; }

  // ---- Topology
  /// Sets the number of the topology revision (state after cuts) that the present surface has.
  void begin_at(std::uint32_t revision) { revision_ = revision; }
  /// Replaces the surface by `next`, the result of the topology change `patch`. Points that the cut adds
  /// start at the patch's positions; older points keep their samples. `revision` and `time` are those of the
  /// change.
  void follow(DrawnSurface next, const SurfacePatch& patch, std::uint32_t revision, SimTime time);
  /// Replaces the surface by `next`, a keyframe with the same points and possibly more. Additional points
  /// start with the displacement of the last old point. Throws InputError if it has fewer points.
  void enter(DrawnSurface next, std::uint32_t revision, SimTime time);

  /// Interpolates the points at `tick` (simulation step, with a fraction) and updates the surface. `dt`:
  /// duration of a tick, s. Returns true if anything moved since the last call.
  bool sample(double tick, double dt);

  const std::vector<Vec3>& points() const { return current_; }
  const DrawnSurface& drawn() const { return drawn_; }
  const TriangleMesh& rest() const { return drawn_.rest; }
  const std::vector<Eigen::Vector3f>& surface() const { return surface_; }
  std::uint32_t revision() const { return revision_; }
  /// Returns a counter that increases with each change of the rest surface rest(), that is, with each cut.
  std::uint64_t shape() const { return shape_; }
  std::uint64_t dropped() const { return dropped_; }

 private:
  struct Chunk {
    SimTime time;
    std::vector<Vec3> positions, velocities;
  };
  std::uint32_t points_, chunk_points_;
  DrawnSurface drawn_;
  std::uint32_t revision_ = 0;
  std::uint64_t shape_ = 0;
  std::vector<Track<Chunk>> chunks_;
  std::size_t missing_chunks_ = 0;
  std::vector<Vec3> current_;
  std::vector<Eigen::Vector3f> surface_;
  bool reshaped_ = false;  // since the last sample()
  std::uint64_t dropped_ = 0;

  std::uint32_t size_of(std::uint32_t chunk) const;
  void add(std::uint32_t chunk, Chunk sample);
  void fill_missing_points(std::uint32_t chunk, Chunk& sample) const;
  void grow(DrawnSurface next, const std::vector<Vec3>& where, std::uint32_t revision, SimTime time);
};

}  // namespace prosector
