#pragma once
// Opens what a list has of tissue at a plane, and closes it again with caps in the inside's colour.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "client/view/cap.h"
#include "client/view/draw_list.h"

namespace prosector {

/// Tells whether a section opens what looks so: tissue, skin and bone, but no instrument, cloth or furniture.
bool is_openable(const Appearance& appearance);

/// Returns the plane through `middle` that takes away what is before it, as seen along `back` (from what is
/// seen to the eye, unit). It is turned to the room's nearest axis where that is close.
SectionPlane section_facing(const Vec3& back, const Vec3& middle);

class SectionCaps {
 public:
  /// Closes the list's solids where its section opens them: adds an item for each, with meshes of ids from
  /// `next_mesh_id` on. Returns for each the solid's number and the item's index.
  std::vector<std::pair<std::uint32_t, std::size_t>> add(DrawList& list, std::uint64_t& next_mesh_id);

 private:
  /// A surface, as far as its section depends on it.
  struct Face {
    std::uint64_t mesh, revision, positions_revision;
    Pose pose;
    Affine shape;
    bool operator==(const Face& o) const {
      return mesh == o.mesh && revision == o.revision && positions_revision == o.positions_revision &&
             pose.p == o.pose.p && pose.q.coeffs() == o.pose.q.coeffs() && shape.A == o.shape.A &&
             shape.p == o.shape.p;
    }
  };
  struct Closed {
    std::vector<Face> faces;  // that the mesh was made of
    std::optional<SectionPlane> section;
    std::shared_ptr<DrawMesh> mesh;
  };
  std::map<std::uint32_t, Closed> closed_;  // by solid

  void close(const DrawList& list, const std::vector<std::size_t>& items, Closed& closed) const;
};

}  // namespace prosector
