#pragma once
// Lines along cuts on the outer surface of tissue: dark until a cut gapes so far that its inside is visible.

#include <map>
#include <vector>

#include "client/replica/cut_rims.h"
#include "client/replica/soft_replica.h"
#include "client/view/draw_list.h"

namespace prosector {

class CutLines {
 public:
  /// Begins a frame: removes the bodies that put() added for the last frame.
  void begin();
  /// Adds a soft body whose cuts are marked by lines in this frame. `mesh`: its outer surface as drawn;
  /// `shape`: map from the mesh's frame to the room. `soft` and `mesh` must not change until add().
  void put(BodyId body, const SoftReplica& soft, const DrawMesh& mesh, const Affine& shape);
  /// Adds lines along the cuts of the bodies that put() added for this frame to the list. Each side of a cut
  /// gets a line if put() also added the body on the other side. The two sides of the cut must be at most
  /// closed_pixels apart for the first camera; a wider cut shows its inside instead.
  void add(DrawList& list);

  static constexpr double width = 1.6;  // points
  // Maximum distance between the sides of a cut that counts as closed.
  static constexpr double closed_pixels = 3;

 private:
  struct Body {
    std::uint64_t shape = 0;  // SoftReplica::shape() for which rims was built
    std::vector<CutRim> rims;
    std::vector<RestEdge> rest;
    // In the current frame:
    const DrawMesh* mesh = nullptr;
    Affine placed{};
  };
  struct Side {
    const Body* body;
    CutRim rim;
    std::optional<OtherSide> other;  // its edge: index of sides_
  };
  std::map<BodyId, Body> bodies_;
  std::vector<Side> sides_;
  bool changed_ = false;  // sides_ must be rebuilt

  void find_sides();
  static Vec3 place(const Side& side, double share);
};

}  // namespace prosector
