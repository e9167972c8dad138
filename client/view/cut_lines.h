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
  /// nearer than closed_pixels, and where its other side is another body that is not in the picture.
  void add(DrawList& list);

  static constexpr double width = 1.6;        // points
  static constexpr double closed_pixels = 3;  // between the sides of a cut that shows nothing of its inside

 private:
  struct Body {
    std::uint64_t shape = 0;  // SoftReplica::shape() that rims are of
    std::vector<CutRim> rims;
    std::vector<RestEdge> rest;
    bool has_walls = false;  // its rims are a cut's; else some are a sheet's own border
    // In this picture:
    const DrawMesh* mesh = nullptr;
    Affine placed{};
  };
  struct Side {
    const Body* body;
    CutRim rim;
    std::optional<std::size_t> other;  // of sides_
  };
  std::map<BodyId, Body> bodies_;
  std::vector<Side> sides_;
  bool changed_ = false;  // sides_ are to be found anew

  void find_sides();
  static Vec3 place(const Side& side, std::uint32_t vertex);
};

}  // namespace prosector
