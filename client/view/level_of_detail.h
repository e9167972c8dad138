#pragma once
// Level-of-detail selection: the coarsest level that is visually indistinguishable from the mesh.

#include <cstdint>
#include <deque>
#include <future>
#include <map>
#include <memory>
#include <vector>

#include "client/view/bounds.h"

namespace prosector {

/// Makes the levels of detail of every eligible item that has none.
void add_detail(DrawList& list);

/// Level selection for each mesh, with hysteresis, so that small motions of the eye don't switch levels back
/// and forth. Missing levels are made in the background, one mesh after the other. Until then a mesh is drawn
/// in full, as is one whose triangles keep changing because it is being cut.
class LevelOfDetail {
 public:
  /// Sets each item's level to the coarsest one with an error of at most `pixels` in any of the list's
  /// cameras, at the scale of the view's centre. 0: all are drawn in full. Eyes, insets and shadows share a
  /// level.
  void choose(DrawList& list, double pixels);

 private:
  /// Cached data of a mesh.
  struct Known {
    std::uint64_t revision = 0, positions_revision = 0;
    Sphere bounds;
    std::shared_ptr<const Detail> detail;
    std::vector<double> errors, measured_to;  // by level − 1: error_of(), and the `enough` it was called with
    std::size_t level = 0;
    int frames_unchanged = 0;
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
