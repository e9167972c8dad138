#pragma once
// One soft body's surface as sent to clients, from one topology to the next. Its points, vertices and
// triangles have slots that are never used again.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "common/surface_patch.h"
#include "server/physics/simulation.h"
#include "server/session/sending/surface_stream.h"

namespace prosector {

class SurfaceLog {
 public:
  /// Starts with the body's current surface, as topology revision `change.revision`.
  SurfaceLog(const Anatomy& anatomy, const Numbering& numbering, const TopologyChange& change, SimTime time,
             Streamed streamed = Streamed::fewest);

  /// Updates the streamed surface to the body's new mesh after the topology change `change`. The mesh's nodes
  /// are at `x` (3n, m) now.
  void follow(const Anatomy& anatomy, const Numbering& numbering, const VecX& x, const TopologyChange& change,
              SimTime time);

  /// Returns the newest topology revision as sent to clients, without the assets (meshes) that a keyframe
  /// adds.
  const TopologyRevision& newest() const { return newest_; }
  const DrawnSurface& surface() const { return surface_; }
  /// Returns the whole surface, with all its slots (permanent indices), as the two assets of a keyframe: the
  /// rest mesh, and the map from streamed points to its vertices.
  std::array<Asset, 2> keyframe() const { return {encode(surface_.rest), encode(surface_.streamed)}; }
  /// Returns the current selection of streamed points. The object is never changed once made, because the
  /// publisher's thread reads it.
  std::shared_ptr<const SurfaceStream> stream() const { return stream_; }

 private:
  /// Slots (indices on the client that are never reused) by permanent number of a node, vertex or triangle.
  struct Slots {
    std::vector<std::uint32_t> of;
    std::uint32_t count = 0;
    /// Returns the client's slot for the node, vertex or triangle with that permanent number. A number
    /// without a slot gets the next free one.
    std::uint32_t at(std::uint32_t number);
  };
  /// Client's slots of the nodes on edges of quadratic elements, which have no permanent numbers. They are
  /// identified by rest position, and where several have the same one (on both sides of a cut), by the order
  /// of appearance.
  using EdgeSlots = std::map<std::array<float, 3>, std::vector<std::uint32_t>>;
  Slots points_, vertices_, triangles_;
  EdgeSlots edge_points_;
  DrawnSurface surface_;
  std::shared_ptr<const SurfaceStream> stream_;
  TopologyRevision newest_;

  /// Returns the client's slots by carrier (node or surface vertex of the body). Only the given `carriers`
  /// have one.
  std::vector<std::uint32_t> slots_of(std::span<const std::uint32_t> carriers, bool of_nodes,
                                      const Anatomy& anatomy, const Numbering& numbering);
  void place_points(const Anatomy& anatomy, const Numbering& numbering, DrawnSurface& surface,
                    SurfaceStream& stream, std::vector<std::uint32_t>& slot_of);
  void place_vertices(const Anatomy& anatomy, const Numbering& numbering, const SurfaceStream& stream,
                      const std::vector<std::uint32_t>& slot_of, DrawnSurface& surface);
  void place_triangles(const Anatomy& anatomy, const Numbering& numbering, DrawnSurface& surface);
  void note(const TopologyChange& change, SimTime time);
};

}  // namespace prosector
