#pragma once
// One soft body's surface as it is told to clients: in slots that are never used again, from one topology to
// the next.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "common/surface_patch.h"
#include "server/physics/simulation.h"
#include "server/session/surface_stream.h"

namespace prosector {

class SurfaceLog {
 public:
  /// Begins with the body as it is, at `change.revision`.
  SurfaceLog(const Anatomy& anatomy, const Numbering& numbering, const TopologyChange& change, SimTime time,
             Streamed streamed = Streamed::fewest);

  /// Goes on to what `change` made of the body, whose nodes are at `x` now.
  void follow(const Anatomy& anatomy, const Numbering& numbering, const VecX& x, const TopologyChange& change,
              SimTime time);

  /// Returns what clients are told of the newest revision; without a keyframe's assets.
  const TopologyRevision& newest() const { return newest_; }
  const DrawnSurface& surface() const { return surface_; }
  /// Returns all slots, as clients take a keyframe: rest mesh and map.
  std::array<Asset, 2> keyframe() const { return {encode(surface_.rest), encode(surface_.streamed)}; }
  /// Returns the stream, never changed once made: the publisher's thread reads it.
  std::shared_ptr<const SurfaceStream> stream() const { return stream_; }

 private:
  /// The slots of numbers.
  struct Slots {
    std::vector<std::uint32_t> of;
    std::uint32_t count = 0;
    /// Returns the slot of a number; the next one for a number that had none yet.
    std::uint32_t at(std::uint32_t number);
  };
  /// Slots of the nodes on edges of quadratic elements, which have no numbers: by where they are at rest, in
  /// the order in which they come. Those of both sides of a cut are at the same place.
  using EdgeSlots = std::map<std::array<float, 3>, std::vector<std::uint32_t>>;
  Slots points_, vertices_, triangles_;
  EdgeSlots edge_points_;
  DrawnSurface surface_;
  std::shared_ptr<const SurfaceStream> stream_;
  TopologyRevision newest_;

  /// Returns the slots by carrier, node or vertex; of those alone that are in `carriers`.
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
