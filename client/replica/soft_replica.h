#pragma once
// One deformable as a client knows it: streamed points in chunks, and the surface that they carry.

#include <cstdint>
#include <vector>

#include "client/replica/track.h"
#include "common/asset.h"
#include "common/mesh.h"
#include "common/messages.h"

namespace prosector {

class SoftReplica {
 public:
  /// `body` from the scene, `rest` and `streamed` from its assets; sizes agree.
  SoftReplica(const SceneBody& body, TriangleMesh rest, StreamedSurface streamed);

  void add(const SoftState& chunk);  // dropped when it doesn't fit this body's chunks
  void add(const Settled& settled);  // every chunk at once, at full precision
  bool complete() const { return known_points_ == points_; }

  /// Interpolates the points at `tick` and carries the surface along. Returns true if anything moved since
  /// the last call.
  bool sample(double tick, double dt);

  const std::vector<Vec3>& points() const { return current_; }
  const TriangleMesh& rest() const { return rest_; }
  const std::vector<Eigen::Vector3f>& surface() const { return surface_; }
  std::uint64_t dropped() const { return dropped_; }

 private:
  struct Chunk {
    SimTime time;
    std::vector<Vec3> positions, velocities;
  };
  std::uint32_t points_, chunk_points_;
  TriangleMesh rest_;
  StreamedSurface streamed_;
  std::vector<Track<Chunk>> chunks_;
  std::uint32_t known_points_ = 0;
  std::vector<Vec3> current_;
  std::vector<Eigen::Vector3f> surface_;
  std::uint64_t dropped_ = 0;

  std::uint32_t size_of(std::uint32_t chunk) const;
  void add(std::uint32_t chunk, Chunk sample);
};

}  // namespace prosector
