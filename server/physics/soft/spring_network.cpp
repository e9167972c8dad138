#include "server/physics/soft/spring_network.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "common/error.h"
#include "server/physics/soft/constitutive_law.h"
#include "server/physics/soft/node_vectors.h"
#include "server/physics/soft/sheet_springs.h"
#include "server/physics/soft/tet4.h"

namespace prosector {
namespace {

constexpr double equal = 1e-9;  // lengths differ by rounding only

using Edge = std::array<std::uint32_t, 2>;

Edge edge(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

class Builder {
 public:
  Builder(const SoftDesc& desc, const Anatomy& anatomy)
      : desc_(desc), anatomy_(anatomy), x_(anatomy.tets.positions) {
    out_.rest = to_vector(x_);
    out_.volume = VecX::Zero(static_cast<Eigen::Index>(x_.size()));
  }

  SpringNetwork build() {
    if (!anatomy_.segments.empty())
      rope();
    else
      solid();
    for (const auto& [ends, k] : stiffness_) {
      const double length = (x_[ends[0]] - x_[ends[1]]).norm();
      if (length > 0 && k > 0)
        out_.springs.push_back({ends, length, k});
      else
        ++out_.dropped;
    }
    return std::move(out_);
  }

 private:
  double length(std::uint32_t a, std::uint32_t b) const { return (x_[a] - x_[b]).norm(); }
  static double given(double stiffness, double derived) { return stiffness > 0 ? stiffness : derived; }

  double thickness() const {
    if (!(anatomy_.thickness > 0))
      throw InputError(
          fmt::format("thickness is {} m; a sheet or rope needs a positive one", anatomy_.thickness));
    return anatomy_.thickness;
  }

  void rope() {
    const double d = thickness(), area = M_PI * d * d / 4;
    const double EI = given(desc_.bending_stiffness, desc_.youngs_modulus * M_PI * d * d * d * d / 64);
    lame(desc_.youngs_modulus, desc_.poisson_ratio);  // checks them
    std::map<std::uint32_t, std::vector<std::uint32_t>> neighbours;
    for (const auto& [a, b] : anatomy_.segments) {
      const double l = length(a, b);
      stiffness_[edge(a, b)] += given(desc_.spring_stiffness, desc_.youngs_modulus * area / l);
      for (const std::uint32_t node : {a, b}) out_.volume[node] += area * l / 2;
      neighbours[a].push_back(b);
      neighbours[b].push_back(a);
    }
    for (const auto& [middle, ends] : neighbours) {
      if (ends.size() != 2) continue;
      const double a = length(ends[0], middle), b = length(middle, ends[1]), l = (a + b) / 2;
      if (a > 0 && b > 0) out_.bends.push_back(line_bend({ends[0], middle, ends[1]}, EI / (l * l * l), a, b));
    }
  }

  void solid() {
    const Materials materials = make_materials(desc_, anatomy_.tets);
    std::vector<double> modulus;  // of the springs of each kind, Pa
    Materials volume = materials;
    bool held = false;
    for (Material& kind : volume.kinds) {
      const auto [lambda, mu] = kind.lame;
      const bool hold = desc_.hold_volume && lambda > mu;
      // Alone, the springs are given E's stiffness in tension at their own ratio of ¼.
      const double E = mu * (3 * lambda + 2 * mu) / (lambda + mu);
      modulus.push_back(hold ? mu : E / 2.5);
      kind.lame = {hold ? lambda - mu : 0, 0};
      held = held || hold;
    }
    if (held) out_.volume_springs = volume;
    out_.volume = Tet4Elements::lumped_volume(anatomy_.tets);
    for (std::size_t t = 0; t < anatomy_.tets.tets.size(); ++t) {
      const auto& tet = anatomy_.tets.tets[t];
      const double mu = modulus[materials.kind_of(t)];
      const Vec3 u = x_[tet[1]] - x_[tet[0]], v = x_[tet[2]] - x_[tet[0]], w = x_[tet[3]] - x_[tet[0]];
      const double V = std::abs(u.cross(v).dot(w)) / 6;
      for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = a + 1; b < 4; ++b) {
          const double l = length(tet[a], tet[b]);
          double& k = stiffness_[edge(tet[a], tet[b])];
          if (desc_.spring_stiffness > 0)
            k = desc_.spring_stiffness;
          else if (l > 0)
            k += 2.5 * mu * V / (l * l);
        }
    }
  }

  const SoftDesc& desc_;
  const Anatomy& anatomy_;
  const std::vector<Vec3>& x_;
  std::map<Edge, double> stiffness_;
  SpringNetwork out_;
};

}  // namespace

Bend line_bend(const std::array<std::uint32_t, 3>& line, double stiffness, double a, double b) {
  Bend out{{line[0], line[1], line[2]}, stiffness};
  const double l = (a + b) / 2;
  if (!(std::abs(a - b) < equal * l)) out.weight = {l / a, -l / a - l / b, l / b};
  return out;
}

SpringNetwork make_spring_network(const SoftDesc& desc, const Anatomy& anatomy) {
  if (!anatomy.quads.empty() || !anatomy.triangles.empty()) return make_sheet_springs(desc, anatomy);
  return Builder(desc, anatomy).build();
}

}  // namespace prosector
