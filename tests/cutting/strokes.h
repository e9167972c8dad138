#pragma once
// A table of what blades do: everyday strokes and awkward ones.

#include <string>
#include <vector>

#include "server/physics/mechanics/cutting/mesh_cut.h"

namespace prosector {

/// The blade's edge tick by tick; strokes one after another.
using Stroke = std::vector<std::vector<Vec3>>;
struct NamedStrokes {
  std::string name;
  std::vector<Stroke> strokes;
  std::size_t box_pieces;  // of a box afterwards; 0: not said
};

/// In units of tests/cutting/meshes.h's box.
std::vector<NamedStrokes> strokes_to_make();

/// A plane through `middle` across everything, in `ticks`; `normal` is its own.
Stroke across(const Vec3& middle, const Vec3& normal, int ticks);

/// Cuts, and puts the nodes that it makes in their places. `x`: m, by node id; grows.
cutting::CutResult cut_and_carry(cutting::TetComplex& complex, cutting::TetTree& tree, std::vector<Vec3>& x,
                                 const std::vector<Vec3>& edge, cutting::BladeStroke& stroke);

std::vector<Vec3> rest_positions(const cutting::TetComplex& complex);

}  // namespace prosector
