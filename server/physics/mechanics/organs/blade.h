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

namespace prosector::organs {

inline constexpr double edge_spacing = 0.004;  // m: largest spacing of points along an edge
inline constexpr double edge_give = 5e-4;      // m: lag of a point behind its edge when the tissue yields
// Factor on the force bound to begin a cut, while there is no crack.
inline constexpr double to_begin_cut = 1.5;
// Bisections of a tick's motion to find where a point or edge entered.
inline constexpr int entry_halvings = 12;
/// Time in s that a blade must be out of tissue for its next entry to begin a new stroke. Until then all its
/// cuts count as one stroke, which undo takes back as a whole. So a nick in a severed piece that falls past
/// the blade is undone together with the cut.
inline constexpr double between_strokes = 0.2;

/// Returns the position (m) of a material point of tissue. `row`: up to four nodes and the point's weight for
/// each; `x`: positions of the body's n nodes (3n, m).
Vec3 point_of(const SparseMap::Row& row, const VecX& x);

/// Shape of an instrument's cutting edges in the instrument's frame: for each edge evenly spaced points (m),
/// the length per point, and the direction. A beam, such as a laser, is an edge with only its two ends as
/// points.
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

/// Returns the factor (0.001 to 1) that slicing applies to the force bound of a tie between a cutting edge
/// and the tissue point at which it cut last. `lag`: vector (m) by which the tissue point lags behind the
/// edge; it has the direction of the edge's motion. `edge`: unit direction of the edge. Slicing lowers the
/// force: a motion of u across the edge and ξu along it cuts only u times the edge's length. Energy balance
/// with toughness R gives F·√(1 + ξ²)·u = R·u·length, so F = R·length/√(1 + ξ²) (Atkins, Xu and Jeronimidis
/// 2004, "Cutting, by 'pressing and slicing', of thin floppy slices of materials"). The factor is 1/√(1 + ξ²)
/// for lags of at least `edge_give`. For smaller lags it tends to 1. Its lower limit keeps each tie from
/// vanishing.
double slicing(const Vec3& lag, const Vec3& edge);
/// Returns the fraction (0.001 to 1) of its force bound that a point bears where a cutting edge passes
/// through a sheet. `lag`: vector (m) by which the point lags behind the edge; `edge` and `normal`: unit
/// vectors along the edge and normal to the sheet. The fraction is the length that the motion cuts in the
/// sheet per path length, at any inclination of the edge.
double slicing(const Vec3& lag, const Vec3& edge, const Vec3& normal);

/// State of a cutting instrument while a hand holds it: its holder, its current stroke, whether it was in
/// tissue, and how far its edges have cut.
struct Blade {
  std::size_t slot = 0;      // of the instrument, in the rigid world
  ParticipantId holder = 0;  // author of its cuts
  std::uint64_t stroke = 0;  // number of the stroke, over all blades; undo takes back a stroke; 0: none yet
  bool cutting = false;      // was in tissue at the end of the last tick
  bool drawn = false;        // its hand draws a cut, which is one stroke
  double outside = 0;        // s since it left tissue; not counted while it is drawn
  std::vector<Vec3> cut_to;  // m, room frame: last cut position by point, in order of the edges
  /// Strokes of the blade that are in progress. Key: the organ, as the index of the original soft body, and
  /// the index of the blade's edge.
  std::map<std::pair<std::size_t, std::size_t>, cutting::BladeStroke> strokes;
};

/// Spring between tissue and one point of a blade's edge, with the soft body, the instrument, the point's
/// index and the material point of tissue to which it is tied.
struct BladeGrip {
  std::size_t body = 0;   // soft body
  std::size_t slot = 0;   // of the instrument
  std::size_t point = 0;  // index in Blade::cut_to
  SparseMap::Row row;     // material at the point's last cut position
  /// For a blade edge that passes through a sheet: the position of the passage, as a fraction of the way from
  /// this edge point to the next. Empty for a point in a solid or on top of a sheet.
  std::optional<double> through{};
  // m: offset of the point from that material, for a point that touched a sheet from above.
  Vec3 beside = Vec3::Zero();
  contact::Tie tie;
};

}  // namespace prosector::organs
