#include "server/accuracy/body_trial.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "server/physics/mechanics/soft/elements/edge_nodes.h"

namespace prosector {
namespace {

constexpr std::size_t place_count = 250;
constexpr double left_by_halving = 3;  // 2² − 1: convergence at second order with halved elements

/// Orients all tetrahedra positively. Linear elements don't need it, but the search for outer faces does.
void orient(TetMesh& mesh) {
  for (auto& tet : mesh.tets) {
    const auto from_first = [&](std::size_t k) -> Vec3 {
      return mesh.positions[tet[k]] - mesh.positions[tet[0]];
    };
    if (from_first(1).cross(from_first(2)).dot(from_first(3)) < 0) std::swap(tet[0], tet[1]);
  }
}

/// Returns the mesh with each tetrahedron divided into eight, without a surface.
Anatomy halved(const Anatomy& anatomy) {
  Anatomy fine;
  fine.tets = anatomy.tets;
  const soft::EdgeNodes edges = soft::add_edge_nodes(fine);
  fine.tets = soft::divided(fine.tets, edges);
  orient(fine.tets);
  return fine;
}

}  // namespace

/// A body with a model and element, and its rest state in each act.
struct BodyTrial::Solved {
  Solved(const SoftDesc& desc, Anatomy anatomy) : body(desc, std::move(anatomy)) {}
  StaticBody body;
  std::vector<StaticAnswer> answers;
  std::vector<double> dents;  // m: mean displacement along a press, weighted by its pressure; 0 for weights
  std::unique_ptr<Probes> probes;
};

const ActError& worst(const std::vector<ActError>& acts) {
  return *std::max_element(acts.begin(), acts.end(),
                           [](const ActError& a, const ActError& b) { return a.error < b.error; });
}

BodyTrial::BodyTrial(const SoftDesc& desc, const Vec3& gravity, Anatomy mesh, const TrialSettings& settings)
    : desc_(desc),
      mesh_{std::move(mesh.tets), {}, {}},
      divided_(8 * mesh_.tets.tets.size() <= settings.most_tets),
      before_step_(settings.before_step) {
  const Vec3 weighs = settings.weight * gravity;
  acts_ = acts_of(desc, mesh_.tets, weighs, settings.presses);
  if (settings.tilts)
    for (Act& act : tilts(desc, mesh_.tets, weighs)) acts_.push_back(std::move(act));
  for (const Act& act : acts_) feet_.push_back(foot_of(desc, mesh_.tets, act.stands.value_or(gravity)));
  places_ = places_in(mesh_.tets, place_count);
  reference_ = solve(settings.law, "tet10", divided_ ? halved(mesh_) : mesh_);
  leave_out_unborne();
  unsettled_.assign(acts_.size(), 0);
  if (!divided_) return;
  const auto undivided = solve(settings.law, "tet10", mesh_);
  for (std::size_t act = 0; act < acts_.size(); ++act)
    unsettled_[act] = difference(act, *undivided, *reference_) / left_by_halving;
}

BodyTrial::~BodyTrial() = default;
BodyTrial::BodyTrial(BodyTrial&&) noexcept = default;

/// Removes tilts in which the reference itself doesn't bear the body: such a body can't stand tilted.
void BodyTrial::leave_out_unborne() {
  const auto leave_out = [](auto& of_acts, std::size_t act) {
    of_acts.erase(of_acts.begin() + static_cast<std::ptrdiff_t>(act));
  };
  for (std::size_t act = acts_.size(); act-- > 0;) {
    if (!acts_[act].stands || reference_->answers[act].usable()) continue;
    leave_out(acts_, act);
    leave_out(feet_, act);
    leave_out(reference_->answers, act);
    leave_out(reference_->dents, act);
  }
}

std::unique_ptr<BodyTrial::Solved> BodyTrial::solve(const std::string& model, const std::string& element,
                                                    const Anatomy& mesh) const {
  SoftDesc desc = desc_;
  desc.configuration.model = model;
  desc.configuration.element = element;
  auto out = std::make_unique<Solved>(desc, mesh);
  for (std::size_t i = 0; i < acts_.size(); ++i) {
    const Act& act = acts_[i];
    if (feet_[i]) out->body.tie(ties_of(*feet_[i], out->body));
    const VecX load = load_of(act, out->body);
    out->answers.push_back(out->body.settle(load, before_step_));
    const VecX moved = out->answers.back().x - out->body.rest();
    out->dents.push_back(act.press ? load.dot(moved) / act.press->force : 0);
  }
  out->probes = std::make_unique<Probes>(out->body, places_);
  return out;
}

/// Returns the relative difference of two answers: of the dent for a press, of all displacements for weights.
double BodyTrial::difference(std::size_t act, const Solved& one, const Solved& other) const {
  const StaticAnswer &a = one.answers[act], &b = other.answers[act];
  if (!a.usable() || !b.usable()) return collapsed;
  if (acts_[act].press) return std::abs(one.dents[act] / other.dents[act] - 1);
  return relative_difference(*one.probes, a.x, *other.probes, b.x, places_.size());
}

std::vector<ActError> BodyTrial::measure(const std::string& model, const std::string& element) const {
  if (element == "tet10" && !divided_)
    throw std::logic_error(
        "configurations with tet10 elements cannot be judged: the reference solution has tet10 elements of "
        "the same size");
  const auto solved = solve(model, element, mesh_);
  std::vector<ActError> out;
  for (std::size_t act = 0; act < acts_.size(); ++act)
    out.push_back(
        {acts_[act].name, difference(act, *solved, *reference_) + unsettled_[act], unsettled_[act]});
  return out;
}

}  // namespace prosector
