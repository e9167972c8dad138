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
  /// Starts with the body's present state, at `change.revision`.
  SurfaceLog(const Anatomy& anatomy, const Numbering& numbering, const TopologyChange& change, SimTime time,
             Streamed streamed = Streamed::fewest);

  /// Updates the surface to the body that `change` made, whose nodes are at `x` now.
  void follow(const Anatomy& anatomy, const Numbering& numbering, const VecX& x, const TopologyChange& change,
              SimTime time);

  /// Returns the newest revision for clients, without a keyframe's assets.
  const TopologyRevision& newest() const { return newest_; }
  const DrawnSurface& surface() const { return surface_; }
  /// Returns all slots as the assets of a keyframe: rest mesh and map.
  std::array<Asset, 2> keyframe() const { return {encode(surface_.rest), encode(surface_.streamed)}; }
  /// Returns the stream. It is never changed once made: the publisher's thread reads it.
  std::shared_ptr<const SurfaceStream> stream() const { return stream_; }

 private:
  /// Slots by number.
  struct Slots {
    std::vector<std::uint32_t> of;
    std::uint32_t count = 0;
    /// Returns the slot of a number; a number without one gets the next free slot.
    std::uint32_t at(std::uint32_t number);
  };
  /// Slots of the nodes on edges of quadratic elements, which have no numbers: by rest position, in the order
  /// of appearance. Nodes on both sides of a cut have the same rest position.
  using EdgeSlots = std::map<std::array<float, 3>, std::vector<std::uint32_t>>;
  Slots points_, vertices_, triangles_;
  EdgeSlots edge_points_;
  DrawnSurface surface_;
  std::shared_ptr<const SurfaceStream> stream_;
  TopologyRevision newest_;

  /// Returns the slots by carrier, node or vertex, of the given `carriers` only.
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
