#pragma once
// Which points of a deformable travel, in which order, and how its surface follows from them.
//
// The surface hangs on the elements' nodes (x_surface = W·q), so the nodes that W uses say all there is to
// see. Where the surface is coarser than that, its own vertices are fewer. Where nodes come and go while the
// surface stays (refine, docs/decisions/0025) they are its vertices. Chosen per body, once: when it is cut,
// points are appended (SurfaceLog).

#include <cstdint>
#include <vector>

#include "common/asset.h"
#include "common/mesh.h"

namespace prosector {

struct SurfaceStream {
  SparseMap sources;         // streamed point ← nodes of the body
  StreamedSurface surface;   // the client's asset; rest as the client will have it, to float32
  std::uint32_t points = 0;  // streamed
  std::uint32_t chunk_points = 0;
  bool of_nodes = false;                // streamed are nodes, else surface vertices …
  std::vector<std::uint32_t> carriers;  // … which ones, by point; ~0: it is gone
  /// The point that each point is displaced like. It is itself, but for one that is gone: so it makes its
  /// chunk's box no larger. ~0: none is left, it stays at rest. Empty: all are in use.
  std::vector<std::uint32_t> leaders;

  std::uint32_t chunks() const { return (points + chunk_points - 1) / chunk_points; }
};

enum class Streamed : std::uint8_t { fewest, vertices };

/// Returns the rows by which the streamed vertices follow from the body's nodes, which are others now.
SparseMap sources_of(const SurfaceStream& of_vertices, const SparseMap& embedding);

/// Makes the stream. Chunks are compact in space: what a hand presses is in few of them, and each has a small
/// box to quantise.
SurfaceStream make_surface_stream(const Anatomy& anatomy, std::uint32_t chunk_points,
                                  Streamed what = Streamed::fewest);

}  // namespace prosector
