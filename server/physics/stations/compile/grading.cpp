#include "server/physics/stations/compile/grading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "common/error.h"
#include "server/physics/mechanics/organs/refined_body.h"
#include "server/physics/mechanics/soft/rungs.h"

namespace prosector {
namespace {

// Fractions of the longest edge at a rim. A cubic cell that is divided along its diagonals gets divided along
// its own edges; smaller values gained little for a cube and a slab.
constexpr double edge_share = 0.7, reach_share = 1. / 6;

constexpr double points_a_reach = 4;  // along the rim

bool is_held(const SoftDesc& desc, const Vec3& x) {
  return std::any_of(desc.attach.begin(), desc.attach.end(),
                     [&](const AttachDesc& a) { return (x - a.center).norm() <= a.radius; });
}

/// The rim where attached faces meet free ones.
struct Rim {
  std::vector<std::pair<Vec3, Vec3>> edges;  // m, both ends; equal for a single point
  double longest = 0;                        // m: mean of the longest edges of the tetrahedra there
};

double longest_edge(const cutting::TetComplex& complex, cutting::TetId tet) {
  double squared = 0;
  const auto corners = complex.corners(tet);
  for (std::size_t a = 0; a < corners.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      squared = std::max(squared, (complex.rest(corners[a]) - complex.rest(corners[b])).squaredNorm());
  return std::sqrt(squared);
}

Rim rim_of(const SoftDesc& desc, const cutting::TetComplex& complex) {
  Rim rim;
  std::size_t faces = 0;
  for (const cutting::TetId tet : cutting::tet_ids(complex))
    for (std::size_t k = 0; k < complex.sides(); ++k) {
      if (complex.neighbor(tet, k) != cutting::TetComplex::none) continue;
      std::array<Vec3, 3> held;
      std::size_t count = 0;
      for (const std::size_t corner : cutting::TetComplex::face[k])
        if (const Vec3& x = complex.rest(complex.corners(tet)[corner]); is_held(desc, x)) held[count++] = x;
      if (count == 0 || count == held.size()) continue;
      rim.edges.emplace_back(held[0], held[count - 1]);
      rim.longest += longest_edge(complex, tet);
      ++faces;
    }
  if (faces > 0) rim.longest /= static_cast<double>(faces);
  return rim;
}

cutting::TouchedPlaces places_on(const Rim& rim, double reach) {
  const double apart = reach / points_a_reach;
  std::vector<Vec3> points;
  for (const auto& [from, to] : rim.edges) {
    const double parts = std::max(1.0, std::ceil((to - from).norm() / apart));
    for (double i = 0; i <= parts; ++i) points.push_back(from + i / parts * (to - from));
  }
  return {std::move(points), apart};
}

}  // namespace

Anatomy graded_at_rims(const SoftDesc& desc, Anatomy anatomy) {
  const auto refusal = [&](const std::string& why) {
    return InputError(fmt::format("[[soft]] \"{}\": grade is \"rims\", {}", desc.name, why));
  };
  if (soft::mesh_kind(anatomy) != soft::MeshKind::tets)
    throw refusal("which is allowed only for solids; set grade = \"none\"");
  if (desc.attach.empty()) return anatomy;
  try {
    const Rim rim = rim_of(desc, cutting::TetComplex(anatomy.tets, desc.material.density));
    if (rim.edges.empty()) return anatomy;
    const double reach = reach_share * rim.longest;
    organs::RefinedBody body(std::move(anatomy), desc.material.density,
                             {.edge = edge_share * rim.longest,
                              .reach = reach,
                              .most = std::numeric_limits<std::size_t>::max() / 2,
                              .linger = 1});
    const cutting::TouchedPlaces places = places_on(rim, reach);
    while (!body.mesh.follow(places, false, false).empty()) {
    }
    return organs::refined_anatomy(body, organs::refined_mesh(body));
  } catch (const InputError& error) {
    throw refusal(fmt::format("but its mesh does not allow it: {}; set grade = \"none\" or use another mesh",
                              error.what()));
  }
}

}  // namespace prosector
