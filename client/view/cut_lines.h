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
  /// Begins a frame with no bodies.
  void begin();
  /// Adds a body to the frame. `mesh`: its outer surface as drawn; `shape`: from the mesh's frame to the
  /// room. `soft` and `mesh` must not change until add().
  void put(BodyId body, const SoftReplica& soft, const DrawMesh& mesh, const Affine& shape);
  /// Adds the lines for the list's first camera. A side of a cut has a line if the opposite side's body is in
  /// the frame and the sides are within closed_pixels. A gaping cut shows its inside instead of a line.
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
