#include "common/anatomy/stuffing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "common/anatomy/bcc_lattice.h"
#include "common/anatomy/boundary_fit.h"
#include "common/error.h"

namespace prosector {
namespace {

using Tet = std::array<std::uint32_t, 4>;

// Distance of a cut point from a lattice vertex, as a fraction of the edge, below which the vertex is snapped
// to it. The safe values of the paper, which bound dihedral angles below by 10.7°.
constexpr double snap_long = 0.24999, snap_short = 0.41189;

constexpr double max_lattice_points = 1 << 23;                      // 300 MB, a few seconds per lattice tried
constexpr double tried_lattice_points = 1.25 * max_lattice_points;  // for the smallest cell tried

// Factors on the cell and offsets that stuff_solid() tries until a mesh has a manifold boundary.
constexpr std::array<double, 3> shrink = {1, 0.97, 0.94};
const std::array<Vec3, 4> offsets = {Vec3(0, 0, 0), Vec3(0.31, 0.17, 0.43), Vec3(0.13, 0.37, 0.23),
                                     Vec3(0.47, 0.29, 0.11)};

/// The lattice with field values, snapped vertices and cut points: steps 2 and 3 of the paper.
class CutLattice {
 public:
  CutLattice(const SolidField& field, double cell, const Vec3& offset)
      : field_(field),
        lattice_(field, cell, offset, tried_lattice_points),
        position_(lattice_.size()),
        sign_(lattice_.size()) {
    value_.resize(lattice_.size());
    for (std::size_t i = 0; i < lattice_.size(); ++i) {
      position_[i] = lattice_.position(i);
      value_[i] = field_.value(position_[i]);
      sign_[i] = value_[i] < 0 ? 1 : value_[i] > 0 ? -1 : 0;
    }
    snap_vertices();
  }

  TetMesh fill();

 private:
  void snap_vertices();
  std::uint32_t vertex(std::size_t point);
  std::uint32_t cut_vertex(std::size_t inside, std::size_t outside);
  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d);
  void split(const std::array<std::size_t, 4>& tet);
  void split_pair(std::size_t p, std::size_t q, std::size_t n, std::size_t m);
  void split_triple(const std::array<std::size_t, 3>& in, std::size_t n);
  void add_prism(const std::array<std::uint32_t, 3>& bottom, const std::array<std::uint32_t, 3>& top,
                 const std::array<bool, 3>& diagonal_from_bottom);
  bool first_takes_diagonal(std::size_t p, std::size_t q, std::size_t n) const;

  const SolidField& field_;
  BccLattice lattice_;
  std::vector<Vec3> position_;
  std::vector<double> value_;
  std::vector<signed char> sign_;  // 1 inside, −1 outside, 0 on the surface
  std::unordered_map<std::uint64_t, Vec3> cuts_;
  TetMesh mesh_;
  std::unordered_map<std::uint64_t, std::uint32_t> numbers_;
};

std::uint64_t edge_key(std::size_t a, std::size_t b) {
  return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | std::max(a, b);
}

void CutLattice::snap_vertices() {
  // Computes all cut points on the unmoved lattice first. Then each vertex is snapped to its nearest
  // violating cut point, and edges with an end on the surface lose their cut points.
  std::vector<std::size_t> touched;
  for (std::size_t i = 0; i < lattice_.size(); ++i) {
    bool any = false;
    lattice_.for_neighbors(i, [&](std::size_t j, bool) {
      if (sign_[i] * sign_[j] >= 0) return;
      any = true;
      if (i > j) return;
      const std::size_t in = sign_[i] > 0 ? i : j, out = in == i ? j : i;
      const double t = crossing(field_, position_[in], value_[in], position_[out], value_[out]);
      cuts_[edge_key(i, j)] = position_[in] + t * (position_[out] - position_[in]);
    });
    if (any) touched.push_back(i);
  }
  for (const std::size_t i : touched) {
    double best = 1;
    Vec3 target = Vec3::Zero();
    lattice_.for_neighbors(i, [&](std::size_t j, bool is_long) {
      if (sign_[i] * sign_[j] >= 0) return;
      const Vec3& x = cuts_.at(edge_key(i, j));
      const double t = (x - lattice_.position(i)).norm() / lattice_.edge_length(is_long);
      const double violation = t / (is_long ? snap_long : snap_short);
      if (violation < best) {
        best = violation;
        target = x;
      }
    });
    if (best < 1) {
      position_[i] = target;
      sign_[i] = 0;
    }
  }
}

std::uint32_t CutLattice::vertex(std::size_t point) {
  const auto [it, fresh] =
      numbers_.try_emplace(edge_key(point, point), static_cast<std::uint32_t>(mesh_.positions.size()));
  if (fresh) mesh_.positions.push_back(position_[point]);
  return it->second;
}

std::uint32_t CutLattice::cut_vertex(std::size_t inside, std::size_t outside) {
  if (sign_[outside] == 0) return vertex(outside);
  const auto key = edge_key(inside, outside);
  const auto [it, fresh] = numbers_.try_emplace(key, static_cast<std::uint32_t>(mesh_.positions.size()));
  if (fresh) mesh_.positions.push_back(cuts_.at(key));
  return it->second;
}

void CutLattice::add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
  if (a == b || a == c || a == d || b == c || b == d || c == d) return;
  const auto& x = mesh_.positions;
  if (tet_volume(x[a], x[b], x[c], x[d]) < 0) std::swap(c, d);
  mesh_.tets.push_back({a, b, c, d});
}

// A lattice face with p and q inside and n outside leaves a quad p, q, cut(q, n), cut(p, n). Its diagonal
// starts at the cut point of a long edge if there is one. Otherwise (pq long, both cuts on short edges) it
// alternates around pq, the paper's parity rule. Returns true if the diagonal is p to cut(q, n). It depends
// on the face only, so the tetrahedra on both sides agree.
bool CutLattice::first_takes_diagonal(std::size_t p, std::size_t q, std::size_t n) const {
  if (lattice_.is_long(p, n)) return false;
  if (lattice_.is_long(q, n)) return true;
  return lattice_.parity(p, n);
}

// Adds a prism with bottom (b0 b1 b2) and top (t0 t1 t2) as tetrahedra. The side between columns i and i + 1
// has the diagonal b_i–t_{i+1} if d[i], else t_i–b_{i+1}. The three must not be all equal.
void CutLattice::add_prism(const std::array<std::uint32_t, 3>& b, const std::array<std::uint32_t, 3>& t,
                           const std::array<bool, 3>& d) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    // Finds column i whose top is on the diagonals of both adjacent sides: side i (i→j) and side k (k→i).
    if (!d[i] && d[k]) {
      add(t[i], b[0], b[1], b[2]);
      if (d[j])  // side j→k: b_j–t_k
        add(t[i], b[j], b[k], t[k]), add(t[i], b[j], t[k], t[j]);
      else
        add(t[i], b[j], b[k], t[j]), add(t[i], b[k], t[k], t[j]);
      return;
    }
  }
}

void CutLattice::split_triple(const std::array<std::size_t, 3>& in, std::size_t n) {
  std::array<std::uint32_t, 3> bottom, top;
  std::array<bool, 3> diagonal;
  for (std::size_t i = 0; i < 3; ++i) {
    bottom[i] = vertex(in[i]);
    top[i] = cut_vertex(in[i], n);
    diagonal[i] = first_takes_diagonal(in[i], in[(i + 1) % 3], n);
  }
  add_prism(bottom, top, diagonal);
}

// Splits a tetrahedron with p and q inside, n outside, m outside or on the surface.
void CutLattice::split_pair(std::size_t p, std::size_t q, std::size_t n, std::size_t m) {
  const auto vp = vertex(p), vq = vertex(q), pn = cut_vertex(p, n), qn = cut_vertex(q, n);
  const bool from_p_n = first_takes_diagonal(p, q, n);
  if (sign_[m] == 0) {  // a pyramid over the quad
    const auto apex = vertex(m);
    if (from_p_n) {
      add(apex, vp, vq, qn), add(apex, vp, qn, pn);
    } else {
      add(apex, vp, vq, pn), add(apex, vq, qn, pn);
    }
    return;
  }
  const auto pm = cut_vertex(p, m), qm = cut_vertex(q, m);
  const bool from_p_m = first_takes_diagonal(p, q, m);
  // A prism with ends (p, pn, pm) and (q, qn, qm). The third side is on the surface, so its diagonal is free;
  // it is chosen to avoid the twisted prism. If pq is short, that also joins the cuts of the two long edges.
  add_prism({vp, pn, pm}, {vq, qn, qm}, {from_p_n, !from_p_n, !from_p_m});
}

void CutLattice::split(const std::array<std::size_t, 4>& tet) {
  std::array<std::size_t, 4> in{}, on{}, out{};
  std::size_t ins = 0, ons = 0, outs = 0;
  for (const std::size_t v : tet) {
    if (sign_[v] > 0) in[ins++] = v;
    if (sign_[v] == 0) on[ons++] = v;
    if (sign_[v] < 0) out[outs++] = v;
  }
  if (ins == 0) return;
  if (outs == 0) {
    add(vertex(tet[0]), vertex(tet[1]), vertex(tet[2]), vertex(tet[3]));
  } else if (ins == 1) {
    std::array<std::uint32_t, 3> far{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < ons; ++k) far[count++] = vertex(on[k]);
    for (std::size_t k = 0; k < outs; ++k) far[count++] = cut_vertex(in[0], out[k]);
    add(vertex(in[0]), far[0], far[1], far[2]);
  } else if (ins == 2) {
    split_pair(in[0], in[1], out[0], ons == 1 ? on[0] : out[1]);
  } else {
    split_triple({in[0], in[1], in[2]}, out[0]);
  }
}

TetMesh CutLattice::fill() {
  lattice_.for_tets([&](const std::array<std::size_t, 4>& tet) { split(tet); });
  return std::move(mesh_);
}

// Duplicates vertices at which groups of tetrahedra touch without a common face: each group gets its own
// copy.
void split_touching_vertices(TetMesh& mesh) {
  std::vector<std::vector<std::uint32_t>> around(mesh.positions.size());
  for (std::uint32_t t = 0; t < mesh.tets.size(); ++t)
    for (const auto node : mesh.tets[t]) around[node].push_back(t);
  const std::size_t nodes = mesh.positions.size();
  for (std::uint32_t node = 0; node < nodes; ++node) {
    TetMesh star;  // tetrahedra around a node contain it, so those joined through faces form one group
    for (const auto t : around[node]) star.tets.push_back(mesh.tets[t]);
    const auto group = tet_components(star);
    std::uint32_t groups = 0;
    for (const auto g : group) groups = std::max(groups, g + 1);
    for (std::uint32_t g = 1; g < groups; ++g) {
      const auto copy = static_cast<std::uint32_t>(mesh.positions.size());
      mesh.positions.push_back(mesh.positions[node]);
      for (std::size_t k = 0; k < group.size(); ++k)
        if (group[k] == g)
          std::replace(mesh.tets[around[node][k]].begin(), mesh.tets[around[node][k]].end(), node, copy);
    }
  }
}

TetMesh largest_piece(const TetMesh& mesh) {
  const auto component = tet_components(mesh);
  std::vector<double> volume;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    if (component[t] >= volume.size()) volume.resize(component[t] + 1);
    const auto& tet = mesh.tets[t];
    volume[component[t]] += tet_volume(mesh.positions[tet[0]], mesh.positions[tet[1]], mesh.positions[tet[2]],
                                       mesh.positions[tet[3]]);
  }
  const auto best = std::max_element(volume.begin(), volume.end()) - volume.begin();
  std::vector<bool> keep(mesh.tets.size());
  for (std::size_t t = 0; t < keep.size(); ++t) keep[t] = component[t] == static_cast<std::uint32_t>(best);
  return subset(mesh, keep);
}

bool gives_tets(const SolidField& field, double cell) {
  return std::ranges::any_of(shrink, [&](double factor) {
    return std::ranges::any_of(offsets, [&](const Vec3& offset) {
      return !CutLattice(field, factor * cell, offset).fill().tets.empty();
    });
  });
}

/// Rounds down to `digits` significant digits, so that a message can state the value exactly.
double rounded_down(double x, int digits) {
  const double unit = std::pow(10, std::floor(std::log10(x)) + 1 - digits);
  return std::floor(x / unit) * unit;
}

/// Throws InputError that suggests a finer cell, after testing that it gives tetrahedra.
[[noreturn]] void refuse_coarse(const SolidField& field, double cell) {
  constexpr double max_points = 1 << 18;  // of the finest lattice tried
  for (double finer = rounded_down(0.9e3 * cell, 2);
       lattice_points(field.box.size(), 0.94e-3 * finer) < max_points; finer = rounded_down(0.9 * finer, 2))
    if (gives_tets(field, 1e-3 * finer))
      throw InputError(
          fmt::format("mesh: a cell of {:.3g} mm gives no tetrahedra; use a finer one, e.g. {:.3g} mm",
                      1000 * cell, finer));
  throw InputError(
      fmt::format("mesh: neither a cell of {:.3g} mm nor any finer one tried gives tetrahedra", 1000 * cell));
}

void refuse_fine(const SolidField& field, double cell) {
  require_sizes(field, cell);
  const Vec3 extent = field.box.size();
  const double tets = expected_tets(field, cell);
  const auto fits = [&](double coarser) {
    return tets * std::pow(cell / coarser, 3) <= max_tets &&
           lattice_points(extent, coarser) <= max_lattice_points;
  };
  if (fits(cell)) return;
  double allowed = cell;
  while (!fits(allowed)) allowed *= 1.02;
  throw InputError(fmt::format(
      "mesh: a cell of {:.3g} mm is too fine for a shape {:.3g} x {:.3g} x {:.3g} m large: about {:.2g} "
      "tetrahedra, of at most {:.2g}; allowed: a cell of {:.3g} mm or more",
      1000 * cell, extent[0], extent[1], extent[2], tets, max_tets, 1.01e3 * allowed));
}

/// Returns the best mesh of several lattice offsets and cells, before its boundary is fitted.
TetMesh best_of_lattices(const SolidField& field, double cell) {
  TetMesh best;
  std::size_t best_bad = SIZE_MAX;
  for (const double factor : shrink)
    for (const Vec3& offset : offsets) {
      TetMesh mesh = stuff(field, factor * cell, offset);
      if (mesh.tets.empty()) continue;
      mesh = largest_piece(mesh);
      const std::size_t bad = non_manifold_edges(boundary_faces(mesh));
      if (bad < best_bad) {
        best_bad = bad;
        best = std::move(mesh);
      }
      if (best_bad == 0) return best;
    }
  if (best.tets.empty()) refuse_coarse(field, cell);
  return best;
}

}  // namespace

TetMesh stuff(const SolidField& field, double cell, const Vec3& offset) {
  return CutLattice(field, cell, offset).fill();
}

double expected_tets(const SolidField& field, double cell) {
  constexpr int samples = 24;  // along each axis
  constexpr double tet_volume_in_cells = 0.128;
  return sampled_volume(field, samples) / (tet_volume_in_cells * cell * cell * cell);
}

TetMesh stuff_solid(const SolidField& field, double cell) {
  refuse_fine(field, cell);
  TetMesh mesh = best_of_lattices(field, cell);
  split_touching_vertices(mesh);
  fit_boundary(field, cell, mesh);
  return mesh;
}

}  // namespace prosector
