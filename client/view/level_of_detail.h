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

/// Computes the levels of detail (coarser triangle lists) of every item whose mesh is large enough and has
/// none, waiting for the result.
void add_detail(DrawList& list);

/// Selector of each mesh's level of detail, with hysteresis, so that small motions of the eye don't switch
/// levels back and forth. Missing levels are computed in the background, one mesh after the other. Until then
/// a mesh is drawn in full, as is one whose triangles keep changing because it is being cut.
class LevelOfDetail {
 public:
  /// Sets each item's level of detail to the coarsest one whose visual error is at most `pixels` in all of
  /// the list's cameras. 0: all items are drawn in full. All cameras and shadows share an item's level.
  void choose(DrawList& list, double pixels);

 private:
  /// Cached data of a mesh: its levels of detail, their errors, and the level in use.
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
