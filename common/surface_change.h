#pragma once
// Change of a deformable body's drawn surface by one revision of its topology. Metres, world frame.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/math.h"

namespace prosector {

/// Cause of a change (revision) of a soft body's topology.
enum class TopologyCause : std::uint8_t { compiled, cut, undo, rewind };

inline constexpr std::size_t max_surface_vertices = 1024 * 1024;       // slots of one soft body
inline constexpr std::size_t max_surface_triangles = 2 * 1024 * 1024;  // slots of one soft body

/// Change of a soft body's drawn surface by one revision of its topology. Streamed points, vertices and
/// triangles are stored in slots, whose numbers are never reused. A change sets some slots and appends
/// others. Removed elements stay as unused slots; a removed triangle has three equal corners. Numbers are
/// floats, so that server and clients store the same bits.
struct SurfacePatch {
  struct Point {                                     // appended, in order
    Eigen::Vector3f rest = Eigen::Vector3f::Zero();  // m, world frame: reference for SoftState's positions
    Eigen::Vector3f now = Eigen::Vector3f::Zero();   // m, world frame, at the revision's time
  };
  struct Vertex {
    std::uint32_t slot = 0;
    Eigen::Vector3f rest = Eigen::Vector3f::Zero();  // m, world frame
    std::array<std::uint32_t, 4> point{};  // streamed points that carry it; unused entries: weight 0
    std::array<float, 4> weight{};         // sum 1
  };
  struct Triangle {
    std::uint32_t slot = 0;
    std::array<std::uint32_t, 3> corners{};  // vertex slots
    bool inner = false;                      // exposed by a cut
  };
  std::vector<Point> points;
  std::vector<Vertex> vertices;     // by slot, ascending
  std::vector<Triangle> triangles;  // by slot, ascending
};

}  // namespace prosector
