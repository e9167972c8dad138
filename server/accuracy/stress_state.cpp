#include "server/accuracy/stress_state.h"

#include <algorithm>

#include "server/physics/mechanics/soft/laws/polar.h"

namespace prosector::estimation {
namespace {

/// Returns the residual of one function in element e, N. `b` is the element's slopes.
Vec3 residual_in(const EstimatedBody& body, std::size_t e, const Bubble& bubble, const ElementState& now,
                 const Columns& b, const VecX& x) {
  const double V = body.elements.volume(e), least_tie = body.least_tie(e, bubble.corners);
  const Corners& nodes = body.elements.nodes(e);
  Vec3 r = Vec3::Zero();
  for (int c = 0; c < 4; ++c) {
    const auto corner = static_cast<std::size_t>(c);
    if (body.quadratic) r += V * (now.P[corner] * (b * bubble.stress.row(c).transpose()));
    Vec3 f = now.force.at_corner[corner];
    if (least_tie > 0)
      f -= std::min(least_tie, body.tie[nodes[corner]]) *
           (x.segment<3>(at(nodes[corner])) - body.mesh.positions[nodes[corner]]);
    r -= body.space[e] * bubble.load[c] * f;
  }
  if (!body.quadratic) r += V * (now.mean_P * (b * bubble.slope));
  return r;
}

}  // namespace

StressState::StressState(const EstimatedBody& body, const MissingFunctions& functions) {
  for (auto* by_element : {&S, &Q, &R}) by_element->assign(body.element_count(), Mat3::Identity());
  law.assign(body.element_count(), {});
  residual.assign(functions.size(), Vec3::Zero());
  reaction.assign(body.vertex_count(), Vec3::Zero());
}

void StressState::clear() {
  std::fill(residual.begin(), residual.end(), Vec3::Zero());
  std::fill(reaction.begin(), reaction.end(), Vec3::Zero());
  mean_F.setZero();
}

void StressState::add_element(const EstimatedBody& body, const MissingFunctions& functions, std::size_t e,
                              const ElementState& now, const VecX& x) {
  const double V = body.elements.volume(e);
  const Corners& nodes = body.elements.nodes(e);
  const Columns b = body.slopes(e);
  for (std::size_t c = 0; c < 4; ++c)
    reaction[nodes[c]] += V * now.mean_P * b.col(static_cast<int>(c)) -
                          body.space[e] / 20 * (now.force.at_corner[c] + now.force.sum);
  const std::vector<Bubble>& bubbles_of_tet = functions.table.of_tet;
  for (std::size_t k = 0; k < bubbles_of_tet.size(); ++k)
    residual[functions.of_element[e * bubbles_of_tet.size() + k]] +=
        residual_in(body, e, bubbles_of_tet[k], now, b, x);
  S[e] = now.S;
  Q[e] = now.Q;
  R[e] = now.R;
  mean_F += V * now.R * now.S;
  law[e] = now.law;
}

void StressState::add_face(const EstimatedBody& body, const MissingFunctions& functions, std::size_t f) {
  const OuterFace& face = functions.faces[f];
  const double size = area_vector(body.mesh, face).norm();
  std::array<Vec3, 3> traction;
  for (std::size_t c = 0; c < 3; ++c)
    traction[c] =
        body.tie[face[c]] > 0 ? Vec3(Vec3::Zero()) : Vec3(reaction[face[c]] / functions.area[face[c]]);
  const std::vector<FaceBubble>& bubbles_of_face = functions.table.of_face;
  for (std::size_t k = 0; k < bubbles_of_face.size(); ++k) {
    Vec3& r = residual[functions.of_face[f * bubbles_of_face.size() + k]];
    for (int c = 0; c < 3; ++c)
      r -= size * bubbles_of_face[k].load[c] * traction[static_cast<std::size_t>(c)];
  }
}

double StressState::energy_above(const MissingFunctions& functions, const Baseline& base,
                                 std::size_t k) const {
  Vec3 more = residual[k];
  if (base.known) more -= soft::polar(mean_F).R * base.turn.transpose() * base.residual[k];
  const Vec3 turned = R[functions.owner[k]].transpose() * more;
  return turned.dot(functions.compliance[k] * turned);
}

void StressState::keep(Baseline& base) const {
  base.S = S;
  base.Q = Q;
  base.residual = residual;
  base.reaction = reaction;
  base.turn = soft::polar(mean_F).R;
  base.law = law;
  base.known = true;
}

}  // namespace prosector::estimation
