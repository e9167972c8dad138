#include "server/physics/mechanics/soft/springs/sheet_springs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/anatomy/sheets_and_ropes.h"
#include "common/error.h"
#include "server/physics/mechanics/soft/base/node_vectors.h"
#include "server/physics/mechanics/soft/laws/constitutive_law.h"
#include "server/physics/mechanics/soft/springs/spring_parts.h"

namespace prosector::soft {
namespace {

using Line = std::array<std::uint32_t, 3>;
using Quads = std::vector<std::array<std::uint32_t, 4>>;
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// A cell at one of its edges.
struct Side {
  std::array<std::uint32_t, 2> from;  // whole cell: for each end of the edge, its neighbour across the cell
  std::uint32_t opposite;             // corner opposite the edge in its triangle
  bool whole;
};

class SheetSprings {
 public:
  SheetSprings(const SoftMaterial& material, const Anatomy& sheet, const Quads& quads,
               const Triangles& triangles)
      : material_(material),
        x_(sheet.tets.positions),
        quads_(quads),
        triangles_(triangles),
        t_(sheet.thickness) {
    if (!(t_ > 0))
      throw InputError(fmt::format("thickness is {} m; allowed for a sheet or rope: positive", t_));
    const double nu = material.poisson_ratio;
    G_ = lame(material.youngs_modulus, nu).mu * t_;
    C_ = material.youngs_modulus * t_ / (1 - nu * nu);
  }

  SpringNetwork build() {
    stretch();
    bend(given(material_.bending_stiffness, C_ * t_ * t_ / 12));
    return std::move(out_);
  }

 private:
  double length(std::uint32_t a, std::uint32_t b) const { return (x_[a] - x_[b]).norm(); }
  double area(const Line& c) const { return (x_[c[1]] - x_[c[0]]).cross(x_[c[2]] - x_[c[0]]).norm() / 2; }
  static double given(double stiffness, double derived) { return stiffness > 0 ? stiffness : derived; }

  void stretch() {
    std::vector<StiffnessPart> parts;
    parts.reserve(6 * quads_.size() + 3 * triangles_.size());
    for (const auto& q : quads_) {
      const double a = (length(q[0], q[3]) + length(q[1], q[2])) / 2;
      const double b = (length(q[0], q[1]) + length(q[3], q[2])) / 2;
      const auto along = [&](double l, double width) {
        const double whole = (width / l) * (C_ - G_ * l * l / (width * width));
        return given(material_.spring_stiffness, std::max(0.01 * C_, whole)) / 2;
      };
      for (const Edge& e : {edge(q[0], q[3]), edge(q[1], q[2])}) parts.push_back({e, along(a, b)});
      for (const Edge& e : {edge(q[0], q[1]), edge(q[3], q[2])}) parts.push_back({e, along(b, a)});
      const double diagonal = given(material_.shear_stiffness, G_ * (a * a + b * b) / (2 * a * b));
      for (const Edge& e : {edge(q[0], q[2]), edge(q[1], q[3])}) parts.push_back({e, diagonal});
    }
    for (const auto& c : triangles_)
      for (std::size_t k = 0; k < 3; ++k) {
        const Edge e = edge(c[k], c[(k + 1) % 3]);
        const double l = length(e[0], e[1]);
        parts.push_back({e, given(material_.spring_stiffness / 2, 8 * C_ * area(c) / (9 * l * l))});
      }
    add_springs(x_, std::move(parts), out_);
    if (material_.tension)
      for (Spring& spring : out_.springs) spring.rest *= 1 - material_.tension.value / 100;
  }

  /// Adds the bends. Two whole cells with a common edge bend along the two lines that cross the edge at its
  /// ends; half of each line belongs to the cells on either side. If a cell is not whole, two triangles bend
  /// about the edge.
  void bend(double D) {
    std::vector<Part<Edge, Side>> sides;
    sides.reserve(4 * quads_.size() + 3 * triangles_.size());
    for (const auto& q : quads_)
      for (std::size_t k = 0; k < 4; ++k) {
        const std::uint32_t a = q[k], b = q[(k + 1) % 4], c = q[(k + 2) % 4], d = q[(k + 3) % 4];
        Side side{{d, c}, k == 0 || k == 3 ? q[2] : q[0], true};
        if (a > b) std::swap(side.from[0], side.from[1]);
        sides.push_back({edge(a, b), side});
      }
    for (const auto& c : triangles_)
      for (std::size_t k = 0; k < 3; ++k)
        sides.push_back({edge(c[k], c[(k + 1) % 3]), {{}, c[(k + 2) % 3], false}});
    sort_parts(x_.size(), sides);
    std::vector<Part<Line, double>> lines;  // N/m
    lines.reserve(sides.size());
    out_.bends.reserve(sides.size());
    for_each_place(sides, [&](auto first, auto last) {
      if (last - first != 2) return;
      const Side &a = first->value, &b = (first + 1)->value;
      if (a.whole && b.whole)
        add_lines(D, first->at, a, b, lines);
      else
        bend_about(D, first->at, a.opposite, b.opposite);
    });
    sort_parts(x_.size(), lines);
    for_each_place(lines, [&](auto first, auto last) {
      double s = 0;
      for (auto part = first; part != last; ++part) s += part->value;
      const Line& line = first->at;
      const double a = length(line[0], line[1]), b = length(line[1], line[2]);
      if (a > 0 && b > 0) out_.bends.push_back(line_bend(line, s, a, b));
    });
  }

  void add_lines(double D, const Edge& ends, const Side& a, const Side& b,
                 std::vector<Part<Line, double>>& lines) const {
    const double width = length(ends[0], ends[1]);
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint32_t first = a.from[k], middle = ends[k], last = b.from[k];
      const double l = (length(first, middle) + length(middle, last)) / 2;
      lines.push_back({{std::min(first, last), middle, std::max(first, last)}, D * width / 2 / (l * l * l)});
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

  const SoftMaterial& material_;
  const std::vector<Vec3>& x_;
  const Quads& quads_;
  const Triangles& triangles_;
  double t_, G_, C_;  // m; N/m
  SpringNetwork out_;
};

void set_nodes(const Anatomy& sheet, SpringNetwork& springs) {
  springs.rest = to_vector(sheet.tets.positions);
  const std::vector<double> volume =
      sheet.node_volume.empty() ? sheet_node_volumes(sheet) : sheet.node_volume;
  springs.volume = Eigen::Map<const VecX>(volume.data(), static_cast<Eigen::Index>(volume.size()));
}

}  // namespace

SpringNetwork make_sheet_springs(const SoftMaterial& material, const Anatomy& sheet) {
  SpringNetwork out = SheetSprings(material, sheet, sheet.quads, sheet.triangles).build();
  set_nodes(sheet, out);
  return out;
}

// Contributions of added or removed cells have a touched corner: as an end of a spring, the middle of a line,
// or the ends of an edge with a bend. All these springs and bends are recomputed from all cells around the
// touched corners, in their order. The others do not change.
std::vector<std::uint32_t> follow_sheet(const SoftMaterial& material, const Anatomy& sheet, const Kept& kept,
                                        std::span<const std::uint32_t> touched, SpringNetwork& springs) {
  const std::size_t nodes = sheet.tets.positions.size();
  std::vector<char> is_touched(nodes, 0), met(nodes, 0);
  if (!kept.all_unmoved()) {
    const std::vector<std::uint32_t> now = kept.destinations();
    // Elements with a removed node are removed. Their other nodes are corners of the cell that was removed
    // with the node, or have a spring to such a corner.
    renumber(now, springs.springs);
    renumber(now, springs.bends);
  }
  for (const std::uint32_t node : touched) is_touched[node] = 1;
  const auto any = [&](std::span<const std::uint32_t> of) {
    return std::any_of(of.begin(), of.end(), [&](std::uint32_t node) { return is_touched[node] != 0; });
  };
  const auto near = [&](const auto& cells) {
    auto out = cells;
    std::erase_if(out, [&](const auto& cell) { return !any(cell); });
    return out;
  };
  const Quads quads = near(sheet.quads);
  const Triangles triangles = near(sheet.triangles);
  SpringNetwork fresh = SheetSprings(material, sheet, quads, triangles).build();

  const auto spring_affected = [&](const Spring& s) { return any(s.node); };
  const auto bend_affected = [&](const Bend& b) {
    return is_touched[b.node[1]] || (b.count == 4 && is_touched[b.node[0]]);
  };
  const auto meet = [&](const SpringNetwork& network) {
    for (const Spring& s : network.springs)
      if (spring_affected(s))
        for (const std::uint32_t node : s.nodes()) met[node] = 1;
    for (const Bend& b : network.bends)
      if (bend_affected(b))
        for (const std::uint32_t node : b.nodes()) met[node] = 1;
  };
  meet(springs);
  meet(fresh);
  replace(springs.springs, std::move(fresh.springs), spring_affected);
  replace(springs.bends, std::move(fresh.bends), bend_affected);
  springs.dropped = fresh.dropped;
  set_nodes(sheet, springs);
  std::vector<std::uint32_t> out;
  for (std::uint32_t node = 0; node < nodes; ++node)
    if (met[node]) out.push_back(node);
  return out;
}

}  // namespace prosector::soft
