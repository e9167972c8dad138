#include "server/accuracy/estimated_body.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "server/physics/mechanics/soft/laws/mean_dilatation.h"
#include "server/physics/mechanics/soft/laws/polar.h"

namespace prosector::estimation {
namespace {

std::size_t vertices_of(const TetMesh& mesh) {
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

EstimatedBody::EstimatedBody(const SoftDesc& desc, const TetMesh& body_mesh, const VecX& ties,
                             const std::string& tissue)
    : mesh(body_mesh),
      quadratic(desc.configuration.is_quadratic()),
      elements(mesh),
      density(desc.material.density) {
  if (quadratic) tet10.emplace(mesh);
  make_laws(desc, tissue);
  make_volumes();
  make_ties(ties);
}

void EstimatedBody::make_laws(const SoftDesc& desc, const std::string& tissue) {
  const soft::Materials all =
                            soft::make_materials(desc.material, mesh, desc.configuration.is_position_based()),
                        own = all.at(elements.source());
  const soft::SplitMaterials split = soft::split_volume(own);
  for (std::size_t k = 0; k < own.kinds.size(); ++k) {
    MaterialLaws& laws_of_kind = laws.emplace_back();
    const soft::Material& local = quadratic ? split.local.kinds[k] : own.kinds[k];
    laws_of_kind.own = soft::make_law(desc.configuration.model, local);
    if (desc.configuration.model != tissue) laws_of_kind.tissue = soft::make_law(tissue, local);
    laws_of_kind.lame = own.kinds[k].lame;
    laws_of_kind.local = split.local.kinds[k].lame;
    laws_of_kind.mean = split.mean.empty() ? 0 : split.mean[k];
  }
  for (std::size_t e = 0; e < element_count(); ++e)
    kind.push_back(static_cast<std::uint32_t>(own.kind_of(e)));
}

void EstimatedBody::make_volumes() {
  volume.assign(vertices_of(mesh), 0);
  for (const std::uint32_t source : elements.source()) {
    const double quarter = soft::Tet4Elements::lumped_share(mesh, source);
    space.push_back(4 * quarter);
    all_volume += space.back();
    for (const std::uint32_t node : mesh.tets[source]) volume[node] += quarter;
  }
}

void EstimatedBody::make_ties(const VecX& ties) {
  const VecX lumped = quadratic ? tet10->lumped_volume() : soft::Tet4Elements::lumped_volume(mesh);
  for (std::size_t i = 0; i < vertex_count(); ++i) {
    const auto node = static_cast<Eigen::Index>(i);
    tie.push_back(lumped[node] > 0 ? ties[node] / lumped[node] : 0);
  }
}

Columns EstimatedBody::slopes(std::size_t e) const {
  Columns b;
  b.rightCols<3>() = elements.gradients(e);
  b.col(0) = -b.rightCols<3>().rowwise().sum();
  return b;
}

double EstimatedBody::least_tie(std::size_t e, std::span<const std::size_t> corners) const {
  double least = std::numeric_limits<double>::infinity();
  for (const std::size_t c : corners) least = std::min(least, tie[elements.nodes(e)[c]]);
  return least;
}

ElementState EstimatedBody::state(std::size_t e, const BodyMoment& moment) const {
  ElementState out = quadratic ? quadratic_state(e, moment.x) : linear_state(e, moment.x);
  out.mean_P = (out.P[0] + out.P[1] + out.P[2] + out.P[3]) / 4;
  out.force = volume_force(e, moment.acceleration);
  return out;
}

ElementState EstimatedBody::linear_state(std::size_t e, const VecX& x) const {
  const MaterialLaws& law = laws[kind[e]];
  const Mat3 F = elements.edges(e, x.data()) * elements.gradients(e).transpose();
  Mat3 P;
  law.own->stress({&F, 1}, {}, {&P, 1});
  ElementState out;
  out.R = soft::polar(F).R;
  out.P.fill(P);
  out.S = out.R.transpose() * F;
  out.Q = out.R.transpose() * P;
  out.work = P.cwiseProduct(F - out.R).sum();
  if (law.tissue) out.law = law_difference(*law.tissue, 0, {{&F, 1}, {&out.R, 1}, {&P, 1}});
  return out;
}

ElementState EstimatedBody::quadratic_state(std::size_t e, const VecX& x) const {
  const MaterialLaws& law = laws[kind[e]];
  std::array<double, 48> moved;
  tet10->move(e, x.data(), moved.data());
  std::array<Mat3, 4> F, P, R;
  std::array<double, 4> dilatation, pressure;
  for (std::size_t q = 0; q < 4; ++q) {
    const Eigen::Map<const Columns> D(moved.data() + 12 * q);
    F[q] = (D.rightCols<3>().colwise() - D.col(0)) * elements.gradients(e).transpose();
  }
  law.own->dilatation(F, dilatation);
  pressure.fill(law.mean * (dilatation[0] + dilatation[1] + dilatation[2] + dilatation[3]) / 4);
  law.own->stress(F, pressure, P);
  ElementState out;
  out.R = soft::polar((F[0] + F[1] + F[2] + F[3]) / 4).R;
  for (std::size_t q = 0; q < 4; ++q) {
    R[q] = soft::polar(F[q]).R;
    out.work += P[q].cwiseProduct(F[q] - R[q]).sum() / 4;
    out.S += R[q].transpose() * F[q] / 4;
    out.Q += R[q].transpose() * P[q] / 4;
  }
  if (law.tissue) out.law = law_difference(*law.tissue, law.mean, {F, R, P});
  for (int c = 0; c < 4; ++c) {
    out.P[static_cast<std::size_t>(c)].setZero();
    for (int q = 0; q < 4; ++q)
      out.P[static_cast<std::size_t>(c)] += corners_of(c, q) * P[static_cast<std::size_t>(q)];
  }
  return out;
}

VolumeForce EstimatedBody::volume_force(std::size_t e, const VecX& acceleration) const {
  const Corners& nodes = elements.nodes(e);
  VolumeForce out;
  for (std::size_t c = 0; c < 4; ++c) {
    out.at_corner[c] = density * acceleration.segment<3>(at(nodes[c]));
    out.sum += out.at_corner[c];
  }
  return out;
}

}  // namespace prosector::estimation
