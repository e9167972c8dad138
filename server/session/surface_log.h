#pragma once
// One soft body's surface as it is told to clients: in slots that are never used again, from one topology to
// the next.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "common/surface_patch.h"
#include "server/physics/simulation.h"
#include "server/session/surface_stream.h"

namespace prosector {

class SurfaceLog {
 public:
  /// Begins with the body as it is, at `change.revision`.
  SurfaceLog(const Anatomy& anatomy, const Numbering& numbering, const TopologyChange& change, SimTime time);

  /// Goes on to what `change` made of the body, whose nodes are at `x` now.
  void follow(const Anatomy& anatomy, const Numbering& numbering, const VecX& x, const TopologyChange& change,
              SimTime time);

  /// What clients are told of the newest revision; without a keyframe's assets.
  const TopologyRevision& newest() const { return newest_; }
  const DrawnSurface& surface() const { return surface_; }
  /// All slots, as clients take a keyframe: rest mesh and map.
  std::array<Asset, 2> keyframe() const { return {encode(surface_.rest), encode(surface_.streamed)}; }
  /// Never changed once made: the publisher's thread reads it.
  std::shared_ptr<const SurfaceStream> stream() const { return stream_; }

 private:
  /// Slots by number.
  struct Slots {
    std::vector<std::uint32_t> of;
    std::uint32_t count = 0;
    /// The slot of a number; the next one for a number that had none yet.
    std::uint32_t at(std::uint32_t number);
  };
  Slots points_, vertices_, triangles_;
  DrawnSurface surface_;
  std::shared_ptr<const SurfaceStream> stream_;
  TopologyRevision newest_;

  void place_points(const Anatomy& anatomy, const Numbering& numbering, DrawnSurface& surface,
                    SurfaceStream& stream);
  void place_vertices(const Anatomy& anatomy, const Numbering& numbering, const SurfaceStream& stream,
                      DrawnSurface& surface);
  void place_triangles(const Anatomy& anatomy, const Numbering& numbering, DrawnSurface& surface);
  void note(const TopologyChange& change, SimTime time);
};

}  // namespace prosector
