#pragma once
// An instrument's cutting edges while a hand holds it.
//
// Each edge has points that tissue resists: a spring ties each point to the material at its last cut
// position. The spring's force is at most the tissue's toughness times the edge length per point. At that
// force a crack of that width propagates (Atkins and Mai 1985). Below it, tissue sticks to the edge and is
// dragged along. At the bound the point advances, and the tissue between its old and new positions is cut. An
// edge that is drawn along its own direction cuts less area per path length, and its bound is reduced
// accordingly (slicing()). So the work equals toughness times cut area.

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "common/ids.h"
#include "common/scene/scene.h"
#include "server/physics/mechanics/contact/contact.h"
#include "server/physics/mechanics/cutting/blade_stroke.h"

namespace prosector {

inline constexpr double edge_spacing = 0.004;  // m: largest spacing of points along an edge
inline constexpr double edge_give = 5e-4;      // m: lag of a point behind its edge when the tissue yields
// Factor on the force bound to begin a cut, while there is no crack.
inline constexpr double to_begin_cut = 1.5;
// Bisections of a tick's motion to find where a point or edge entered.
inline constexpr int entry_halvings = 12;
/// s out of tissue after which a blade's next entry begins a new stroke. A severed piece may fall past the
/// blade and get a nick. The nick then belongs to the same stroke, so undo takes back the cut and not only
/// the nick.
inline constexpr double between_strokes = 0.2;

/// Returns the position of the material point `row` for node positions `x` (3n, m).
Vec3 point_of(const SparseMap::Row& row, const VecX& x);

/// Points along the cutting edges, in the instrument's frame.
struct BladeShape {
  struct Edge {
    std::vector<Vec3> points;        // m, evenly spaced from end to end
    double length_per_point = 0;     // m
    Vec3 direction = Vec3::UnitZ();  // unit, along the edge
    bool ray = false;                // a beam from the first point to the last
  };
  std::vector<Edge> edges;
};
BladeShape blade_shape(const std::vector<EdgeDesc>& edges);

/// Returns the fraction of its force bound that a point on an edge along `edge` (unit) bears. `lag` (m): lag
/// of the point, in the direction of its motion and force. A motion of u across the edge and ξu along it cuts
/// u times the edge's length, so F·√(1 + ξ²)·u = R·u·length. Hence F = R·length/√(1 + ξ²), with the
/// components R·length/(1 + ξ²) across the edge and ξ times that along it. (Atkins, Xu and Jeronimidis 2004,
/// "Cutting, by 'pressing and slicing', of thin floppy slices of materials".) The fraction is 1 for a lag so
/// small that the point has not moved yet. It is never less than a thousandth: points stay tied to their last
/// cut positions.
double slicing(const Vec3& lag, const Vec3& edge);
/// Returns the fraction for an edge that passes through a sheet with that normal (unit). The cut length is
/// that of the edge's path through the sheet, at any inclination.
double slicing(const Vec3& lag, const Vec3& edge, const Vec3& normal);

/// State of a blade while it is held.
struct Blade {
  std::size_t slot = 0;      // of the instrument, in the rigid world
  ParticipantId holder = 0;  // author of its cuts
  std::uint64_t stroke = 0;  // number of the stroke, over all blades; undo takes back a stroke; 0: none yet
  bool cutting = false;      // was in tissue at the end of the last tick
  bool drawn = false;        // its hand draws a cut, which is one stroke
  double outside = 0;        // s since it left tissue; not counted while it is drawn
  std::vector<Vec3> cut_to;  // m, room frame: last cut position by point, in order of the edges
  /// By organ (index of the original soft body) and edge.
  std::map<std::pair<std::size_t, std::size_t>, BladeStroke> strokes;
};

/// A tie between tissue and a point of a blade's edge.
struct BladeGrip {
  std::size_t body = 0;   // soft body
  std::size_t slot = 0;   // of the instrument
  std::size_t point = 0;  // index in Blade::cut_to
  SparseMap::Row row;     // material at the point's last cut position
  /// Where the edge passes through a sheet, as a fraction of the way from this point to the next; none: in a
  /// solid.
  std::optional<double> through{};
  // m: offset of the point from that material, for a point that touched a sheet from above.
  Vec3 beside = Vec3::Zero();
  Tie tie;
};

}  // namespace prosector
