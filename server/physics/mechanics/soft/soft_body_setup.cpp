#include "server/physics/mechanics/soft/soft_body_setup.h"

#include <fmt/format.h>

#include <cmath>

namespace prosector::soft {

void refuse(const SoftDesc& desc, const std::string& what) {
  throw InputError(fmt::format("soft body \"{}\": {}", desc.name, what));
}

void require(bool ok, const SoftDesc& desc, const std::string& what) {
  if (!ok) refuse(desc, what);
}

void check_constants(const SoftDesc& desc) {
  const auto positive = [](double v) { return v > 0 && std::isfinite(v); };
  const auto not_negative = [](double v) { return v >= 0 && std::isfinite(v); };
  require(positive(desc.material.density), desc,
          fmt::format("density is {}; allowed: positive, in kg/m³", desc.material.density));
  require(not_negative(desc.material.damping_mass), desc,
          fmt::format("damping_mass is {}; allowed: 0 or more, in 1/s", desc.material.damping_mass));
  require(not_negative(desc.material.damping_stiffness), desc,
          fmt::format("damping_stiffness is {}; allowed: 0 or more, in s", desc.material.damping_stiffness));
  for (const AttachDesc& attach : desc.attach) {
    require(not_negative(attach.stiffness), desc,
            fmt::format("attach stiffness is {}; allowed: 0 or more, in N/m per m³", attach.stiffness));
    require(not_negative(attach.radius), desc,
            fmt::format("attach radius is {}; allowed: 0 or more, in m", attach.radius));
  }
}

void check_mesh(const SoftDesc& desc, const Anatomy& anatomy) {
  const std::size_t n = anatomy.tets.positions.size();
  require(!anatomy.tets.tets.empty() || !anatomy.quads.empty() || !anatomy.triangles.empty() ||
              !anatomy.segments.empty(),
          desc, "its mesh has no tetrahedra, sheet cells or rope segments; at least one is needed");
  for (std::size_t i = 0; i < n; ++i)
    if (!is_finite(anatomy.tets.positions[i])) refuse(desc, fmt::format("node {} is not finite", i));
  for (std::size_t e = 0; e < anatomy.tets.tets.size(); ++e)
    for (std::uint32_t node : anatomy.tets.tets[e])
      if (node >= n)
        refuse(desc,
               fmt::format("tetrahedron {} refers to node {}, but the mesh has {} nodes, numbered from 0", e,
                           node, n));
  for (const auto& quad : anatomy.quads)
    for (std::uint32_t node : quad)
      if (node >= n)
        refuse(desc,
               fmt::format("a sheet's cell refers to node {}, but the mesh has {} nodes, numbered from 0",
                           node, n));
  for (const auto& triangle : anatomy.triangles)
    for (std::uint32_t node : triangle)
      if (node >= n)
        refuse(
            desc,
            fmt::format("a triangle of a sheet refers to node {}, but the mesh has {} nodes, numbered from 0",
                        node, n));
  require(anatomy.node_volume.empty() || anatomy.node_volume.size() == n, desc,
          fmt::format("{} node volumes for {} nodes", anatomy.node_volume.size(), n));
  for (const auto& segment : anatomy.segments)
    for (std::uint32_t node : segment)
      if (node >= n)
        refuse(desc,
               fmt::format("a rope segment refers to node {}, but the mesh has {} nodes, numbered from 0",
                           node, n));
  const std::size_t vertices = anatomy.surface.positions.size();
  require(
      anatomy.embedding.rows.size() == vertices, desc,
      fmt::format("the surface has {} vertices, but {} rows of embedding weights; the numbers must be equal",
                  vertices, anatomy.embedding.rows.size()));
  for (const auto& row : anatomy.embedding.rows)
    for (std::uint32_t node : row.node)
      if (node >= n)
        refuse(
            desc,
            fmt::format("a surface vertex is embedded in node {}, but the mesh has {} nodes, numbered from 0",
                        node, n));
  for (const auto& triangle : anatomy.surface.triangles)
    for (std::uint32_t vertex : triangle)
      if (vertex >= vertices)
        refuse(desc,
               fmt::format(
                   "a surface triangle refers to vertex {}, but the surface has {} vertices, numbered from 0",
                   vertex, vertices));
}

VecX lumped_mass(double density, const VecX& volume) {
  const double least = least_mass_share * volume.mean();
  return density * volume.cwiseMax(least);
}

double bounding_diagonal(const VecX& x) {
  const auto points = x.reshaped(3, x.size() / 3);
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

VecX attachment_stiffness(const std::vector<AttachDesc>& attach, const VecX& rest, const VecX& volume) {
  VecX k = VecX::Zero(volume.size());
  for (const AttachDesc& a : attach) {
    for (Eigen::Index i = 0; i < k.size(); ++i) {
      const bool inside = (rest.segment<3>(3 * i) - a.center).norm() <= a.radius;
      if (inside) k[i] = std::max(k[i], a.stiffness * volume[i]);
    }
  }
  return k;
}

namespace {

double third_of_area(const TriangleMesh& surface, const std::array<std::uint32_t, 3>& t) {
  const Vec3 &a = surface.positions[t[0]], &b = surface.positions[t[1]], &c = surface.positions[t[2]];
  return (b - a).cross(c - a).norm() / 6;
}

}  // namespace

void follow_vertex_areas(const TriangleMesh& surface, const SurfaceEdit& edit, std::vector<double>& areas) {
  prosector::apply(edit.vertices, std::vector<double>(edit.positions.size()), areas);
  std::vector<std::uint8_t> touched(areas.size(), 0);
  for (const std::uint32_t vertex : edit.touched) {
    touched[vertex] = 1;
    areas[vertex] = 0;
  }
  for (const auto& t : surface.triangles) {  // in the order of vertex_areas(), so that sums are equal
    if ((touched[t[0]] | touched[t[1]] | touched[t[2]]) == 0) continue;
    const double third = third_of_area(surface, t);
    for (const std::uint32_t vertex : t)
      if (touched[vertex] != 0) areas[vertex] += third;
  }
}

std::vector<double> vertex_areas(const Anatomy& anatomy) {
  const TriangleMesh& surface = anatomy.surface;
  std::vector<double> area(surface.positions.size(), 0.0);
  for (const auto& t : surface.triangles) {
    const double third = third_of_area(surface, t);
    for (const std::uint32_t vertex : t) area[vertex] += third;
  }
  if (anatomy.segments.empty()) return area;
  std::vector<double> mantle(anatomy.tets.positions.size(), 0.0);
  for (const auto& [a, b] : anatomy.segments) {
    const double half =
        M_PI * anatomy.thickness * (anatomy.tets.positions[a] - anatomy.tets.positions[b]).norm() / 2;
    mantle[a] += half;
    mantle[b] += half;
  }
  for (std::size_t i = 0; i < area.size(); ++i) area[i] += mantle[anatomy.embedding.rows[i].node[0]];
  return area;
}

}  // namespace prosector::soft
