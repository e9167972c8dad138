#include "server/accuracy/live_estimates.h"

#include <algorithm>
#include <cmath>

#include "server/accuracy/body_trial.h"
#include "server/physics/mechanics/soft/integrators/explicit_integrators.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector {
namespace {

constexpr double turn_seconds = 0.25;    // s, simulated: in which all due bodies are estimated
constexpr double quiet_seconds = 0.5;    // s, simulated: from a cut until elements are listed again
constexpr double first_order = 0.5;      // factor on h·Δv: position error of a step of implicit Euler
constexpr double second_order = 2. / 9;  // factor on h·Δ²v: of a step of BDF2
constexpr double least_press = 1e-3;     // of the loads' work: less does not count as a press
constexpr double least_moved = 5e-5;     // m: half the precision of drawn surfaces

int order_of(const SoftDesc& desc) {
  for (const soft::IntegratorRow& row : soft::integrators())
    if (row.name == desc.configuration.integrator) return row.order;
  for (const auto& row : soft::explicit_integrators())
    if (row.name == desc.configuration.integrator) return row.order;
  return 1;  // position-based models
}

/// Returns the force with which hands press the body, N; below 0: no hand touches it.
double pressed(const Simulation& simulation, BodyId body) {
  double force = -1;
  for (const HandState& hand : simulation.hands())
    if (hand.contact.touching && hand.contact.body == body)
      force = std::max(force, 0.) + hand.contact.force.norm();
  return force;
}

/// Returns the work of the hands' forces over their depth in the body, J. If pressure is proportional to
/// depth, the mean depth under a round object is two thirds of its greatest depth.
double contact_work(const Simulation& simulation, BodyId body) {
  double work = 0;
  for (const HandState& hand : simulation.hands())
    if (hand.contact.touching && hand.contact.body == body)
      work += 2. / 3 * hand.contact.force.norm() * std::max(hand.contact.depth, 0.);
  return work;
}

/// Displacement of the nodes from rest, m, less the body's mean displacement.
struct Moved {
  double most = 0;
  double mean = 0;  // root of the mean square
};
Moved moved(const VecX& x, const VecX& rest) {
  const auto n = static_cast<double>(x.size() / 3);
  const auto by_node = (x - rest).reshaped(3, x.size() / 3);
  const Vec3 whole = by_node.rowwise().mean();
  const VecX far = (by_node.colwise() - whole).colwise().norm();
  return {far.maxCoeff(), far.norm() / std::sqrt(n)};
}

}  // namespace

LiveEstimates::LiveEstimates(const Simulation& simulation)
    : h_(1 / simulation.scene().tick_rate),
      turn_(std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::lround(turn_seconds / h_)))) {
  for (BodyId id = 0; id < simulation.body_count(); ++id)
    if (simulation.kind(id) == BodyKind::soft) rebuild(simulation, id, bodies_[id]);
}

void LiveEstimates::rebuild(const Simulation& simulation, BodyId id, Body& body) {
  const soft::SoftBody& soft = simulation.soft(id);
  body.revision = simulation.revision(id);
  body.attached = soft.attached();
  body.rebuild = false;
  body.settled = false;
  body.estimator.reset();
  body.grid.reset();
  const TetMesh& mesh = soft.anatomy().tets;
  if (!BodyEstimator::judges(soft.desc(), mesh)) return;
  const VecX ties = body.attached ? soft.attachment_stiffness() : VecX(VecX::Zero(soft.nodes()));
  // Fibres are the author's knowledge of this tissue: a law without them is no reference for it.
  const std::string tissue =
      soft.desc().configuration.model == "fem_fibers" ? soft.desc().configuration.model : tissue_law;
  body.estimator = std::make_unique<BodyEstimator>(soft.desc(), mesh, ties, tissue);
  body.grid = std::make_unique<ErrorGrid>(body.estimator->mesh(), body.estimator->newest().local.size());
}

void LiveEstimates::follow(const Simulation& simulation, const StepReport& report) {
  for (const BodyReport& row : report.bodies)
    for (auto& [id, body] : bodies_)
      if (simulation.name(id) == row.body)
        body.solver =
            row.last_step * (row.converged && std::isfinite(row.residual) ? std::min(row.residual, 1.) : 1);
  std::size_t all = 0;
  for (BodyId id = 0; id < simulation.body_count(); ++id) {
    if (simulation.kind(id) != BodyKind::soft) continue;
    Body& body = bodies_[id];
    watch(simulation, id, body);
    if (body.estimator != nullptr && due(simulation, id, body)) all += body.estimator->pieces();
  }
  for (std::size_t left = all / turn_ + 1; left > 0;) {
    if (!at_) {
      const auto is_due = [&](const auto& entry) { return due(simulation, entry.first, entry.second); };
      const auto after = bodies_.upper_bound(last_);
      auto found = std::find_if(after, bodies_.end(), is_due);
      if (found == bodies_.end()) {
        const auto before = std::find_if(bodies_.begin(), after, is_due);
        if (before != after) found = before;
      }
      if (found == bodies_.end() || found->second.begun == simulation.time().tick) break;
      at_ = last_ = found->first;
      begin(simulation, found->first, found->second);
    }
    Body& body = bodies_.at(*at_);
    const std::size_t pieces = std::min(left, body.estimator->pieces());
    left -= pieces;
    if (!body.estimator->go_on(pieces)) continue;
    take(body);
    at_.reset();
  }
  for (auto& [id, body] : bodies_) remember(simulation, id, body);
}

/// Checks whether the body still has the mesh and ties of its estimator, and rebuilds the estimator if not.
void LiveEstimates::watch(const Simulation& simulation, BodyId id, Body& body) {
  const std::uint64_t tick = simulation.time().tick;
  const std::uint32_t revision = simulation.revision(id);
  const bool attached = simulation.soft(id).attached();
  if (revision != body.revision || attached != body.attached) {
    body.revision = revision;
    body.attached = attached;
    body.changed = tick;
    body.rebuild = true;
    body.newest.reset();
    body.ticks = 0;
    if (at_ == id) at_.reset();
  }
  if (body.rebuild && (body.changed == 0 || static_cast<double>(tick - body.changed) * h_ >= quiet_seconds))
    rebuild(simulation, id, body);
  if (!simulation.asleep(id)) body.settled = false;
}

bool LiveEstimates::due(const Simulation& simulation, BodyId id, const Body& body) const {
  if (body.estimator == nullptr || body.rebuild || simulation.soft_state(id).recovering) return false;
  return simulation.asleep(id) ? !body.settled : body.ticks > 0;
}

void LiveEstimates::begin(const Simulation& simulation, BodyId id, Body& body) {
  const soft::SoftBody& soft = simulation.soft(id);
  const soft::SoftBodyState& state = simulation.soft_state(id);
  const Vec3 gravity = soft.weight(simulation.scene().gravity, true).acceleration;
  const Eigen::Index nodes = soft.nodes();
  body.was_asleep = simulation.asleep(id);
  body.pressed = pressed(simulation, id);
  body.begun = simulation.time().tick;
  moment_.x = state.motion.x;
  moment_.acceleration.resize(3 * nodes);
  moment_.slip = VecX::Zero(3 * nodes);
  moment_.solver = 0;
  const double strength = simulation.part(id).stiffness;
  for (Eigen::Index i = 0; i < nodes; ++i) moment_.acceleration.segment<3>(3 * i) = gravity / strength;
  const Moved far = moved(state.motion.x, soft.rest());
  body.stirred = far.mean > least_moved;
  if (!body.was_asleep) {
    moment_.acceleration -= (state.motion.v - body.v) / (h_ * strength);
    if (order_of(soft.desc()) == 1)
      moment_.slip = first_order * h_ * (state.motion.v - body.v);
    else if (body.ticks > 1)
      moment_.slip = second_order * h_ * (state.motion.v - 2 * body.v + body.v_before);
    moment_.solver = far.most > 0 ? body.solver / far.most : 0;
  }
  moment_.give = contact_work(simulation, id);
  body.estimator->begin(moment_);
}

void LiveEstimates::take(Body& body) {
  const Estimate& found = body.estimator->newest();
  if (body.was_asleep) {
    body.settled = true;
    body.estimator->keep_as_quiet();
  }
  if (!body.newest) body.newest.emplace();
  LiveEstimate& out = *body.newest;
  out.tick = body.begun;
  // A displacement below the precision of the shape has no meaningful relative error.
  out.error = body.stirred ? found.error : 0;
  out.parts = body.stirred ? found.parts : ErrorParts{};
  out.press_error = body.pressed > 0 && found.pressed > least_press ? found.press : -1;
  out.press_force = std::max(body.pressed, 0.);
  out.map = body.grid->map_of(body.stirred ? found.local : std::vector<double>(found.local.size()));
}

/// Stores the velocities with which the next tick's are compared.
void LiveEstimates::remember(const Simulation& simulation, BodyId id, Body& body) {
  if (body.estimator == nullptr) return;
  const VecX& v = simulation.soft_state(id).motion.v;
  if (simulation.asleep(id) || (body.ticks > 0 && body.v.size() != v.size())) {
    body.ticks = 0;
    return;
  }
  body.v_before.swap(body.v);
  body.v = v;
  body.ticks = std::min(body.ticks + 1, 2);
}

const LiveEstimate* LiveEstimates::newest(BodyId body) const {
  const auto found = bodies_.find(body);
  return found == bodies_.end() || !found->second.newest ? nullptr : &*found->second.newest;
}

}  // namespace prosector
