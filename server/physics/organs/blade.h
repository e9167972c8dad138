#pragma once
// An instrument's cutting edges while a hand holds it.
//
// Along each edge stand points that tissue holds back: each is tied by a spring to the material where it has
// cut to. The spring bears no more than the tissue's toughness times the length of edge that the point stands
// for. That is the force at which a crack of that width goes on (Atkins and Mai 1985). Below it tissue sticks
// to the edge and is drawn along. At it the point moves on through the tissue, which is cut between where the
// points were and where they are. Drawn along itself an edge parts less on its way, and bears so much less
// (slicing()). So the work done is toughness times the area that was cut.

#include <cstdint>
#include <map>
#include <vector>

#include "common/scene/scene.h"
#include "server/physics/cutting/blade_stroke.h"

namespace prosector {

inline constexpr double edge_spacing = 0.004;  // m between points of an edge, at most
inline constexpr double edge_give = 5e-4;      // m that a point lags behind its edge when tissue gives
inline constexpr double to_begin_cut = 1.5;    // times the force at which one goes on: there is no crack yet
inline constexpr int entry_halvings = 12;      // of a tick's way, to where a point or an edge entered
/// s out of tissue after which a blade that enters it begins another stroke. What came off falls past the
/// blade: who undoes a cut doesn't mean the nick that it got then.
inline constexpr double between_strokes = 0.2;

/// Returns where material of `row` is while nodes are at `x` (3n, m).
Vec3 point_of(const SparseMap::Row& row, const VecX& x);

/// Points along edges, in the instrument's frame.
struct BladeShape {
  struct Edge {
    std::vector<Vec3> points;        // m, from end to end, evenly
    double length_per_point = 0;     // m
    Vec3 direction = Vec3::UnitZ();  // unit, along it
    bool ray = false;                // a beam from its first point to its last
  };
  std::vector<Edge> edges;
};
BladeShape blade_shape(const std::vector<EdgeDesc>& edges);

/// Returns the share of its bound that a point of an edge along `edge` (unit) bears. The point lags behind by
/// `lag` (m) in the direction that it goes, which is the force's. A way u across the edge and ξu along it
/// parts u times the edge's length, so F·√(1 + ξ²)·u = R·u·length. Hence F = R·length/√(1 + ξ²), of which
/// R·length/(1 + ξ²) pushes and ξ times that draws. (Atkins, Xu and Jeronimidis 2004, "Cutting, by 'pressing
/// and slicing', of thin floppy slices of materials".) The share is 1 where the point lags so little that it
/// has not gone anywhere yet. It is never less than a thousandth: points stay tied to where they have cut to.
double slicing(const Vec3& lag, const Vec3& edge);
/// Returns that share where an edge goes through a sheet with that normal (unit). What it parts is as long as
/// its way in the sheet, wherever it leans to.
double slicing(const Vec3& lag, const Vec3& edge, const Vec3& normal);

/// One while it is held.
struct Blade {
  std::size_t slot = 0;      // of the instrument in the rigid world
  ParticipantId holder = 0;  // whose cut it is
  std::uint64_t stroke = 0;  // counts, over all blades, and is what undo takes back; 0: none yet
  bool cutting = false;      // it was in tissue when the last tick ended
  bool drawn = false;        // its hand draws a cut, which is one stroke
  double outside = 0;        // s since it was in tissue; stays while it is drawn
  std::vector<Vec3> cut_to;  // m, room frame: per point, in order of the edges, where it has cut to
  /// By organ (the soft body that it was) and edge.
  std::map<std::pair<std::size_t, std::size_t>, BladeStroke> strokes;
};

}  // namespace prosector
