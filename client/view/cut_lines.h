#pragma once
// The lines of cuts on the outside of tissue: dark until a cut gapes so far that one sees into it.

#include <map>
#include <vector>

#include "client/replica/cut_rims.h"
#include "client/replica/soft_replica.h"
#include "client/view/draw_list.h"

namespace prosector {

class CutLines {
 public:
  /// Begins a picture: no body is in it.
  void begin();
  /// Puts a body into the picture. `mesh`: its outside as it is drawn. `shape`: from there to the room.
  /// `soft` and `mesh` stay as they are until add().
  void put(BodyId body, const SoftReplica& soft, const DrawMesh& mesh, const Affine& shape);
  /// Adds the lines as the list's first camera sees them. A side of a cut has one while the other side is
  /// seen, too, and nearer than closed_pixels. What gapes shows its inside in place of a line.
  void add(DrawList& list);

  static constexpr double width = 1.6;        // points
  static constexpr double closed_pixels = 3;  // between the sides of a cut that shows nothing of its inside

 private:
  struct Body {
    std::uint64_t shape = 0;  // SoftReplica::shape() that rims are of
    std::vector<CutRim> rims;
    std::vector<RestEdge> rest;
    // In this picture:
    const DrawMesh* mesh = nullptr;
    Affine placed{};
  };
  struct Side {
    const Body* body;
    CutRim rim;
    std::optional<OtherSide> other;  // its edge: of sides_
  };
  std::map<BodyId, Body> bodies_;
  std::vector<Side> sides_;
  bool changed_ = false;  // sides_ are to be found anew

  void find_sides();
  static Vec3 place(const Side& side, double share);
};

}  // namespace prosector
