#pragma once
// Selects the points of a deformable that are streamed, and their order, and defines how the surface follows
// from them.
//
// The surface follows from the elements' nodes (x_surface = W·q), so the nodes that W uses determine
// everything that is visible. Where the surface has fewer vertices than that, its vertices are streamed
// instead. They are also streamed where nodes are added and removed while the surface stays (refine,
// docs/decisions/0025). The choice is made once for each body: when it is cut, points are appended
// (SurfaceLog).

#include <cstdint>
#include <vector>

#include "common/asset.h"
#include "common/mesh.h"

namespace prosector {

struct SurfaceStream {
  SparseMap sources;         // streamed point ← nodes of the body
  StreamedSurface surface;   // the client's asset; rest positions rounded to float32, as the client has them
  std::uint32_t points = 0;  // number of streamed points
  std::uint32_t chunk_points = 0;
  bool of_nodes = false;                // true: nodes are streamed; false: surface vertices
  std::vector<std::uint32_t> carriers;  // by point: its node or vertex; ~0: the point was removed
  /// By streamed point: the point whose displacement it copies. This is the point itself, unless it was
  /// removed by a cut: following another point keeps its chunk's box small. ~0 means that no point is left
  /// and it stays at rest. Empty if all points are in use.
  std::vector<std::uint32_t> leaders;

  std::uint32_t chunks() const { return (points + chunk_points - 1) / chunk_points; }
};

enum class Streamed : std::uint8_t { fewest, vertices };

/// Returns the matrix that maps the body's nodes to streamed surface vertices, after the nodes have changed.
/// `embedding` maps the nodes to all vertices of the surface.
SparseMap sources_of(const SurfaceStream& of_vertices, const SparseMap& embedding);

/// Selects and orders the points of a soft body that are streamed, `chunk_points` per chunk. Chunks are
/// compact in space: a hand presses only a few of them, and each has a small box for quantisation.
SurfaceStream make_surface_stream(const Anatomy& anatomy, std::uint32_t chunk_points,
                                  Streamed what = Streamed::fewest);

}  // namespace prosector
