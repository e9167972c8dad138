#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "server/accuracy/error_work.h"
#include "server/physics/mechanics/soft/laws/mean_dilatation.h"

namespace prosector::estimation {
namespace {

std::size_t vertex_count(const TetMesh& mesh) {
  std::uint32_t last = 0;
  for (const Corners& tet : mesh.tets) last = std::max(last, *std::max_element(tet.begin(), tet.end()));
  return mesh.tets.empty() ? 0 : last + 1;
}

}  // namespace

Eigen::Matrix4d corners_from_points() {
  const double at_corner = (5 + 3 * std::sqrt(5.)) / 20, elsewhere = (5 - std::sqrt(5.)) / 20;
  Eigen::Matrix4d points = Eigen::Matrix4d::Constant(elsewhere);
  points.diagonal().setConstant(at_corner);
  return points.inverse();
}

ErrorWork::ErrorWork(const SoftDesc& desc, const TetMesh& body_mesh, const VecX& ties,
                     const std::string& tissue)
    : mesh(body_mesh),
      quadratic(desc.configuration.is_quadratic()),
      elements(mesh),
      table(bubbles(quadratic)),
      density(desc.material.density) {
  if (quadratic) tet10.emplace(mesh);
  make_laws(desc, tissue);
  const std::size_t vertices = vertex_count(mesh);
  volume.assign(vertices, 0);
  for (const std::uint32_t source : elements.source()) {
    const double quarter = Tet4Elements::lumped_share(mesh, source);
    space.push_back(4 * quarter);
    all_volume += space.back();
    for (const std::uint32_t node : mesh.tets[source]) volume[node] += quarter;
  }
  const VecX lumped = quadratic ? tet10->lumped_volume() : Tet4Elements::lumped_volume(mesh);
  for (std::size_t i = 0; i < vertices; ++i) {
    const auto node = static_cast<Eigen::Index>(i);
    tie.push_back(lumped[node] > 0 ? ties[node] / lumped[node] : 0);
  }
  make_functions();
  make_faces();
  make_compliance();
  for (auto* by_element : {&S, &Q, &R}) by_element->assign(element_count(), Mat3::Identity());
  law.assign(element_count(), {});
  residual.assign(functions.size(), Vec3::Zero());
  reaction.assign(vertices, Vec3::Zero());
  disc.assign(vertices, 0);
  model.assign(vertices, 0);
  newest.local.assign(vertices, 0);
  if (mesh.stretch == nullptr) return;
  // Tissue is under tension at rest: only loads beyond the rest state move it.
  moment.x.resize(3 * static_cast<Eigen::Index>(mesh.positions.size()));
  for (std::size_t i = 0; i < mesh.positions.size(); ++i)
    moment.x.segment<3>(3 * static_cast<Eigen::Index>(i)) = mesh.positions[i];
  moment.acceleration = moment.slip = VecX::Zero(moment.x.size());
  clear();
  for (std::size_t k = 0; k < piece_count(); ++k) piece(k);
  keep(rest);
}

void ErrorWork::make_laws(const SoftDesc& desc, const std::string& tissue) {
  const Materials all = make_materials(desc.material, mesh, desc.configuration.is_position_based()),
                  own = all.at(elements.source());
  const SplitMaterials split = split_volume(own);
  for (std::size_t k = 0; k < own.kinds.size(); ++k) {
    MaterialLaws& laws_of_kind = laws.emplace_back();
    const Material& local = quadratic ? split.local.kinds[k] : own.kinds[k];
    laws_of_kind.own = make_law(desc.configuration.model, local);
    if (desc.configuration.model != tissue) laws_of_kind.tissue = make_law(tissue, local);
    laws_of_kind.lame = own.kinds[k].lame;
    laws_of_kind.local = split.local.kinds[k].lame;
    laws_of_kind.mean = split.mean.empty() ? 0 : split.mean[k];
  }
  for (std::size_t e = 0; e < element_count(); ++e)
    kind.push_back(static_cast<std::uint32_t>(own.kind_of(e)));
}

void ErrorWork::make_functions() {
  for (std::size_t e = 0; e < element_count(); ++e)
    for (const Bubble& bubble : table.of_tet)
      functions.add(FunctionIndex::key(bubble.corners, elements.nodes(e)));
  functions.close();
  owner.assign(functions.size(), 0);
  for (std::size_t e = element_count(); e-- > 0;)
    for (const Bubble& bubble : table.of_tet) {
      const std::uint32_t k = functions.find(FunctionIndex::key(bubble.corners, elements.nodes(e)));
      owner[k] = static_cast<std::uint32_t>(e);
    }
  for (std::size_t e = 0; e < element_count(); ++e)
    for (const Bubble& bubble : table.of_tet)
      function.push_back(functions.find(FunctionIndex::key(bubble.corners, elements.nodes(e))));
}

void ErrorWork::make_faces() {
  area.assign(volume.size(), 0);
  for (OuterFace face : outer_faces(mesh)) {
    std::sort(face.begin(), face.end());
    std::array<std::uint32_t, 8> found{};
    bool all_there = true;  // false for faces of elements that were left out
    for (std::size_t k = 0; k < table.of_face.size(); ++k) {
      const auto key = FunctionIndex::key(table.of_face[k].corners, face);
      found[k] = functions.find(key);
      all_there = all_there && found[k] < functions.size() && functions[found[k]] == key;
    }
    if (!all_there) continue;
    faces.push_back(face);
    face_function.insert(face_function.end(), found.begin(),
                         found.begin() + static_cast<std::ptrdiff_t>(table.of_face.size()));
    for (const std::uint32_t node : face) area[node] += area_vector(mesh, face).norm() / 3;
  }
}

void ErrorWork::make_compliance() {
  std::vector<Mat3> K(functions.size(), Mat3::Zero());
  for (std::size_t e = 0; e < element_count(); ++e) {
    const MaterialLaws& law = laws[kind[e]];
    const Columns b = slopes(e);
    const double V = elements.volume(e);
    for (std::size_t k = 0; k < table.of_tet.size(); ++k) {
      const Bubble& bubble = table.of_tet[k];
      const Mat3 G = b * bubble.stiffness * b.transpose();
      const Vec3 mean = b * bubble.slope;
      double least_tie = std::numeric_limits<double>::infinity();
      for (const std::size_t c : bubble.corners) least_tie = std::min(least_tie, tie[elements.nodes(e)[c]]);
      K[function[e * table.of_tet.size() + k]] +=
          V * (law.local.mu * (G.trace() * Mat3::Identity() + G) + law.local.lambda * G +
               law.mean * mean * mean.transpose() + least_tie * bubble.square * Mat3::Identity());
    }
  }
  for (const Mat3& stiffness : K) compliance.push_back(stiffness.inverse());
}

/// Returns the gradients of the corners' barycentric coordinates at rest, 1/m.
Columns ErrorWork::slopes(std::size_t e) const {
  Columns b;
  b.rightCols<3>() = elements.gradients(e);
  b.col(0) = -b.rightCols<3>().rowwise().sum();
  return b;
}

}  // namespace prosector::estimation
