#pragma once
// Opens the tissue in a list at a section plane, and closes it with caps in the colour of the inside.

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "client/view/cap.h"
#include "client/view/draw_list.h"

namespace prosector {

/// Returns whether a section opens bodies of this appearance: tissue, skin and bone, but no instrument, cloth
/// or furniture.
bool is_openable(const Appearance& appearance);

/// Returns the plane through `middle` that removes the side towards the eye. `back`: unit, from the subject
/// to the eye. The plane snaps to the nearest axis of the room if that is close.
SectionPlane section_facing(const Vec3& back, const Vec3& middle);

class SectionCaps {
 public:
  /// Closes the list's solids where its section opens them, with one item for each. Takes mesh ids from
  /// `next_mesh_id`. Returns pairs of solid number and item index.
  std::vector<std::pair<std::uint32_t, std::size_t>> add(DrawList& list, std::uint64_t& next_mesh_id);

 private:
  /// The state of a surface that its section depends on.
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
    std::vector<Face> faces;  // the faces from which the mesh was made
    std::optional<SectionPlane> section;
    std::shared_ptr<DrawMesh> mesh;
  };
  std::map<std::uint32_t, Closed> closed_;  // by solid

  void close(const DrawList& list, const std::vector<std::size_t>& items, Closed& closed) const;
};

}  // namespace prosector
