#include "server/physics/soft/spring_network.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "common/anatomy/fabric.h"
#include "common/error.h"
#include "server/physics/soft/constitutive_law.h"
#include "server/physics/soft/node_vectors.h"
#include "server/physics/soft/tet4.h"

namespace prosector {
namespace {

constexpr double equal = 1e-9;  // lengths differ by rounding only

using Edge = std::array<std::uint32_t, 2>;

Edge edge(std::uint32_t a, std::uint32_t b) {
  return {std::min(a, b), std::max(a, b)};
}

Bend line_bend(const std::array<std::uint32_t, 3>& line, double stiffness, double a, double b) {
  Bend out{{line[0], line[1], line[2]}, stiffness};
  const double l = (a + b) / 2;
  if (!(std::abs(a - b) < equal * l)) out.weight = {l / a, -l / a - l / b, l / b};
  return out;
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
    else if (!anatomy_.quads.empty() || !anatomy_.triangles.empty())
      sheet();
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

  void sheet() {
    const double t = thickness(), nu = desc_.poisson_ratio;
    const double G = lame(desc_.youngs_modulus, nu).mu * t;
    const double C = desc_.youngs_modulus * t / (1 - nu * nu);
    for (const auto& q : anatomy_.quads) {
      const double a = (length(q[0], q[3]) + length(q[1], q[2])) / 2;
      const double b = (length(q[0], q[1]) + length(q[3], q[2])) / 2;
      const auto along = [&](double l, double width) {
        const double whole = (width / l) * (C - G * l * l / (width * width));
        return given(desc_.spring_stiffness, std::max(0.01 * C, whole)) / 2;
      };
      for (const Edge& e : {edge(q[0], q[3]), edge(q[1], q[2])}) stiffness_[e] += along(a, b);
      for (const Edge& e : {edge(q[0], q[1]), edge(q[3], q[2])}) stiffness_[e] += along(b, a);
      const double diagonal = given(desc_.shear_stiffness, G * (a * a + b * b) / (2 * a * b));
      for (const Edge& e : {edge(q[0], q[2]), edge(q[1], q[3])}) stiffness_[e] += diagonal;
    }
    for (const auto& c : anatomy_.triangles)
      for (std::size_t k = 0; k < 3; ++k) {
        const Edge e = edge(c[k], c[(k + 1) % 3]);
        const double l = length(e[0], e[1]);
        stiffness_[e] += given(desc_.spring_stiffness / 2, 8 * C * area(c) / (9 * l * l));
      }
    lump_sheet();
    bend_sheet(given(desc_.bending_stiffness, C * t * t / 12));
  }

  double area(const std::array<std::uint32_t, 3>& c) const {
    return (x_[c[1]] - x_[c[0]]).cross(x_[c[2]] - x_[c[0]]).norm() / 2;
  }

  void lump_sheet() {
    const std::vector<double> volume =
        anatomy_.node_volume.empty() ? sheet_node_volumes(anatomy_) : anatomy_.node_volume;
    std::copy(volume.begin(), volume.end(), out_.volume.begin());
  }

  /// A cell at one of its edges.
  struct Side {
    struct Across {
      std::uint32_t from, middle;  // a node and its neighbour on the edge
    };
    std::array<Across, 2> lines;  // of a whole cell, by the edge's ends
    bool whole;
    std::uint32_t opposite;  // corner of its triangle at the edge
  };

  /// Two whole cells with a common edge bend along the two lines that cross it at its ends; each line belongs
  /// half to the cells on either side of it. Where one isn't whole, two triangles bend about the edge.
  void bend_sheet(double D) {
    std::map<Edge, std::vector<Side>> sides;
    for (const auto& q : anatomy_.quads)
      for (std::size_t k = 0; k < 4; ++k) {
        const std::uint32_t a = q[k], b = q[(k + 1) % 4], c = q[(k + 2) % 4], d = q[(k + 3) % 4];
        Side side{{{{d, a}, {c, b}}}, true, k == 0 || k == 3 ? q[2] : q[0]};
        if (a > b) std::swap(side.lines[0], side.lines[1]);
        sides[edge(a, b)].push_back(side);
      }
    for (const auto& c : anatomy_.triangles)
      for (std::size_t k = 0; k < 3; ++k)
        sides[edge(c[k], c[(k + 1) % 3])].push_back({{}, false, c[(k + 2) % 3]});
    std::map<std::array<std::uint32_t, 3>, double> lines;
    for (const auto& [ends, cells] : sides) {
      if (cells.size() != 2) continue;
      if (cells[0].whole && cells[1].whole)
        add_lines(D, ends, cells, lines);
      else
        bend_about(D, ends, cells[0].opposite, cells[1].opposite);
    }
    for (const auto& [line, s] : lines) {
      const double a = length(line[0], line[1]), b = length(line[1], line[2]);
      if (a > 0 && b > 0) out_.bends.push_back(line_bend(line, s, a, b));
    }
  }

  void add_lines(double D, const Edge& ends, const std::vector<Side>& cells,
                 std::map<std::array<std::uint32_t, 3>, double>& lines) const {
    const double width = length(ends[0], ends[1]);
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint32_t first = cells[0].lines[k].from, middle = cells[0].lines[k].middle,
                          last = cells[1].lines[k].from;
      const double l = (length(first, middle) + length(middle, last)) / 2;
      lines[{std::min(first, last), middle, std::max(first, last)}] += D * width / 2 / (l * l * l);
    }
  }

  void bend_about(double D, const Edge& ends, std::uint32_t c, std::uint32_t d) {
    const Vec3 along = x_[ends[1]] - x_[ends[0]];
    const double l2 = along.squaredNorm(), areas = area({ends[0], ends[1], c}) + area({ends[0], ends[1], d});
    Bend bend{{ends[0], ends[1], c, d}, D * l2 / areas, {0, 0, 0, 0}, 4};
    for (std::size_t k = 2; k < 4; ++k) {
      const Vec3 arm = x_[bend.node[k]] - x_[ends[0]];
      const double foot = arm.dot(along) / l2, height = (arm - foot * along).norm();
      if (!(height > 0)) return;
      bend.weight[k] = 1 / height;
      bend.weight[0] -= (1 - foot) / height;
      bend.weight[1] -= foot / height;
    }
    out_.bends.push_back(bend);
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

SpringNetwork make_spring_network(const SoftDesc& desc, const Anatomy& anatomy) {
  return Builder(desc, anatomy).build();
}

}  // namespace prosector
