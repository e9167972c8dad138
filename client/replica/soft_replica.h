#pragma once
// One deformable as a client knows it: streamed points in chunks, and the surface that they carry.
//
// When it is cut, points are only appended, so samples of other revisions still say where those are that both
// have.

#include <cstdint>
#include <vector>

#include "client/replica/track.h"
#include "common/messages.h"
#include "common/surface_patch.h"

namespace prosector {

class SoftReplica {
 public:
  /// Takes `body` from the scene, `rest` and `streamed` from its assets; sizes agree.
  SoftReplica(const SceneBody& body, TriangleMesh rest, StreamedSurface streamed);

  /// Takes a chunk; one that doesn't fit this body's chunks is dropped. Returns false where it tells of
  /// points of a later revision, too: give it again when that is here.
  bool add(const SoftState& chunk);
  bool add(const Settled& settled);  // takes every chunk at once, at full precision
  bool complete() const { return missing_chunks_ == 0; }

  // ---- Topology
  /// Sets the revision that the surface belongs to as it is.
  void begin_at(std::uint32_t revision) { revision_ = revision; }
  /// Goes on to the surface that `patch` makes of this one: new points begin where the patch says they are,
  /// old ones keep their past.
  void follow(DrawnSurface next, const SurfacePatch& patch, std::uint32_t revision, SimTime time);
  /// Goes on to another surface over the same points and more: those begin displaced like the point before
  /// them. Throws InputError when it has fewer points.
  void enter(DrawnSurface next, std::uint32_t revision, SimTime time);

  /// Interpolates the points at `tick` and carries the surface along. Returns true if anything moved since
  /// the last call.
  bool sample(double tick, double dt);

  const std::vector<Vec3>& points() const { return current_; }
  const DrawnSurface& drawn() const { return drawn_; }
  const TriangleMesh& rest() const { return drawn_.rest; }
  const std::vector<Eigen::Vector3f>& surface() const { return surface_; }
  std::uint32_t revision() const { return revision_; }
  /// Returns a number that rises whenever rest() became another mesh.
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
  void complete_from_newest(std::uint32_t chunk, Chunk& sample) const;
  void grow(DrawnSurface next, const std::vector<Vec3>& where, std::uint32_t revision, SimTime time);
};

}  // namespace prosector
