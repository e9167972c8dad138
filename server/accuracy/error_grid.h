#pragma once
// Makes the map of a body's error that travels from values at its vertices.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh.h"
#include "common/messages.h"

namespace prosector {

class ErrorGrid {
 public:
  /// Lays a grid over the first `vertices` positions of the mesh, of cubes, max_error_map_side values along
  /// the longest axis.
  ErrorGrid(const TetMesh& mesh, std::size_t vertices);

  /// Returns the map of errors (fractions) by vertex: of each value the mean of the vertices around, by their
  /// nearness. Values with none around have that of their neighbours.
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
