#pragma once
// Which of a mesh's triangles are worth drawing: the coarsest level that nobody can tell from the mesh.

#include <cstdint>
#include <deque>
#include <future>
#include <map>
#include <memory>
#include <vector>

#include "client/view/bounds.h"

namespace prosector {

/// Makes the detail of every item that is worth it and has none.
void add_detail(DrawList& list);

/// A choice of level for each mesh. It remembers what it chose, so that a level doesn't come and go with
/// every small step of the eye. It makes what detail is missing in the background, one mesh after the other.
/// Until then a mesh is drawn in full, and so is one whose triangles keep changing because it is being cut.
class LevelOfDetail {
 public:
  /// Gives each item the coarsest level that is off by no more than `pixels` for any of the list's cameras,
  /// measured in the middle of its picture. 0: all are drawn in full. Both eyes, insets and shadows share a
  /// level.
  void choose(DrawList& list, double pixels);

 private:
  /// What is known of a mesh.
  struct Known {
    std::uint64_t revision = 0, positions_revision = 0;
    Sphere bounds;
    std::shared_ptr<const Detail> detail;
    std::vector<double> errors, measured_to;  // by level − 1: error_of(), and its `enough`
    std::size_t level = 0;
    int pictures_unchanged = 0;
    std::uint64_t last_picture = 0;
  };
  struct Wanted {
    std::uint64_t mesh, revision;
    std::vector<Eigen::Vector3f> rest;
    Triangles triangles;
  };
  struct Made {
    std::uint64_t mesh, revision;
    std::shared_ptr<const Detail> detail;
  };

  std::map<std::uint64_t, Known> known_;  // by the mesh's id
  std::deque<Wanted> wanted_;
  std::future<Made> making_;
  std::uint64_t picture_ = 0;

  void take_made();
  Known& know(const DrawItem& item);
  bool is_within(Known& known, const DrawMesh& mesh, std::size_t level, double error);
  std::size_t level_of(Known& known, const DrawMesh& mesh, double error);
};

}  // namespace prosector
