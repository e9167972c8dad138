#include "server/accuracy/error_work.h"

namespace prosector::estimation {

ErrorWork::ErrorWork(const SoftDesc& desc, const TetMesh& mesh, const VecX& ties, const std::string& tissue)
    : body(desc, mesh, ties, tissue), functions(body), state(body, functions), sums(body.vertex_count()) {
  newest.local.assign(body.vertex_count(), 0);
  if (body.mesh.stretch != nullptr) estimate_rest();
}

/// Stores the rest state as a baseline. Tissue is under tension at rest: only loads beyond the rest state
/// move it.
void ErrorWork::estimate_rest() {
  const std::vector<Vec3>& rest = body.mesh.positions;
  moment.x.resize(3 * static_cast<Eigen::Index>(rest.size()));
  for (std::size_t i = 0; i < rest.size(); ++i)
    moment.x.segment<3>(3 * static_cast<Eigen::Index>(i)) = rest[i];
  moment.acceleration = moment.slip = VecX::Zero(moment.x.size());
  clear();
  for (std::size_t k = 0; k < piece_count(); ++k) piece(k);
  state.keep(before.rest);
}

void ErrorWork::clear() {
  done = 0;
  state.clear();
  sums.clear();
}

void ErrorWork::piece(std::size_t k) {
  if (k < body.element_count()) return add_element(k);
  k -= body.element_count();
  if (k < functions.faces.size()) return state.add_face(body, functions, k);
  k -= functions.faces.size();
  if (k < functions.size()) return add_function(k);
  sums.add_forces(body, functions, state, before);
  sums.estimate(body, moment, newest);
}

void ErrorWork::add_element(std::size_t e) {
  const ElementState now = body.state(e, moment);
  state.add_element(body, functions, e, now, moment.x);
  sums.add_element(body, e, now, before, moment.slip);
}

void ErrorWork::add_function(std::size_t k) {
  const double of_all = state.energy_above(functions, before.rest, k);
  const double of_press = before.quiet.known ? state.energy_above(functions, before.quiet, k) : of_all;
  sums.add_function(functions.index[k], of_all, of_press);
}

}  // namespace prosector::estimation
