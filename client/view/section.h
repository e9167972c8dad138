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

/// Returns whether a section plane opens bodies of this appearance: tissue, skin and bone, but no instrument,
/// cloth or furniture.
bool is_openable(const Appearance& appearance);

/// Returns the section plane through `middle` (m) that removes the side towards the eye. `back`: unit vector
/// from the subject to the eye. If `back` is close to an axis of the room, the plane is perpendicular to that
/// axis.
SectionPlane section_facing(const Vec3& back, const Vec3& middle);

class SectionCaps {
 public:
  /// Adds caps that close the list's solids where its section plane opens them, one item for each solid.
  /// Takes the ids of new meshes from `next_mesh_id`. Returns the solid number and the index of the new item
  /// for each cap.
  std::vector<std::pair<std::uint32_t, std::size_t>> add(DrawList& list, std::uint64_t& next_mesh_id);

 private:
  /// State of a surface (mesh revisions, pose and shape) on which its intersection with the section plane
  /// depends. The cap is rebuilt when it changes.
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
