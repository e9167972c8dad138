#include "server/physics/mechanics/soft/springs/spring_network.h"

#include <fmt/format.h>

#include <cmath>
#include <map>

#include "common/error.h"
#include "server/physics/mechanics/soft/base/node_vectors.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"
#include "server/physics/mechanics/soft/springs/sheet_springs.h"
#include "server/physics/mechanics/soft/springs/spring_parts.h"
#include "server/physics/mechanics/soft/springs/tet_springs.h"

namespace prosector::soft {
namespace {

constexpr double equal = 1e-9;  // relative: smaller differences of lengths are rounding errors

double given(double stiffness, double derived) {
  return stiffness > 0 ? stiffness : derived;
}

SpringNetwork make_rope_springs(const SoftMaterial& material, const Anatomy& rope) {
  const double d = rope.thickness, area = M_PI * d * d / 4;
  if (!(d > 0)) throw InputError(fmt::format("thickness is {} m; allowed for a sheet or rope: positive", d));
  lame(material.youngs_modulus, material.poisson_ratio);  // throws InputError for invalid constants
  const std::vector<Vec3>& x = rope.tets.positions;
  const auto length = [&](std::uint32_t a, std::uint32_t b) { return (x[a] - x[b]).norm(); };
  SpringNetwork out;
  out.rest = to_vector(x);
  out.volume = VecX::Zero(static_cast<Eigen::Index>(x.size()));
  std::vector<StiffnessPart> parts;
  std::map<std::uint32_t, std::vector<std::uint32_t>> neighbours;
  for (const auto& [a, b] : rope.segments) {
    const double l = length(a, b);
    parts.push_back({edge(a, b), given(material.spring_stiffness, material.youngs_modulus * area / l)});
    for (const std::uint32_t node : {a, b}) out.volume[node] += area * l / 2;
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  add_springs(x, std::move(parts), out);
  const double EI = given(material.bending_stiffness, material.youngs_modulus * M_PI * d * d * d * d / 64);
  for (const auto& [middle, ends] : neighbours) {
    if (ends.size() != 2) continue;
    const double a = length(ends[0], middle), b = length(middle, ends[1]), l = (a + b) / 2;
    if (a > 0 && b > 0) out.bends.push_back(line_bend({ends[0], middle, ends[1]}, EI / (l * l * l), a, b));
  }
  return out;
}

}  // namespace

Bend line_bend(const std::array<std::uint32_t, 3>& line, double stiffness, double a, double b) {
  Bend out{{line[0], line[1], line[2]}, stiffness};
  const double l = (a + b) / 2;
  if (!(std::abs(a - b) < equal * l)) out.weight = {l / a, -l / a - l / b, l / b};
  return out;
}

SpringNetwork make_spring_network(const SoftMaterial& material, const Anatomy& anatomy) {
  if (!anatomy.quads.empty() || !anatomy.triangles.empty()) return make_sheet_springs(material, anatomy);
  return anatomy.segments.empty() ? make_tet_springs(material, anatomy.tets)
                                  : make_rope_springs(material, anatomy);
}

}  // namespace prosector::soft
