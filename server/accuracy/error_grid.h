#pragma once
// Converts errors at a body's vertices to the map that is sent to clients.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/error_estimate.h"
#include "common/mesh.h"

namespace prosector {

class ErrorGrid {
 public:
  /// Makes a grid of cubic cells over the first `vertices` positions of the mesh. It has max_error_map_side
  /// values along the longest axis.
  ErrorGrid(const TetMesh& mesh, std::size_t vertices);

  /// Returns the map of relative errors (fractions) on the grid, computed from the errors at the mesh's
  /// vertices. Each value is the mean over the vertices around it, weighted by nearness. Values without
  /// vertices around get the mean of their neighbours.
  ErrorMap map_of(std::span<const double> errors);

 private:
  struct Share {
    std::uint32_t value;
    double weight;
  };
  void fill();

  ErrorMap empty_;
  std::vector<std::array<Share, 8>> shares_;   // by vertex
  std::vector<double> sum_, weight_, filled_;  // by value
};

}  // namespace prosector
