#include "server/physics/simulation.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <thread>

#include "common/error.h"
#include "server/physics/stations/compile/compile.h"
#include "server/physics/stations/compile/equilibrium.h"
#include "server/physics/stations/compile/overlaps.h"
#include "server/physics/stations/dissecting/cut_by_blades.h"
#include "server/physics/stations/dissecting/refining.h"
#include "server/physics/stations/hands/touching.h"
#include "server/physics/stations/save/checkpoint.h"
#include "server/physics/stations/save/take_over.h"
#include "server/physics/stations/step.h"
#include "server/physics/stations/touching/fit_tissue.h"

namespace prosector {
namespace {

int threads_of(const CompileOptions& options) {
  return options.threads > 0 ? options.threads
                             : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// Takes a state whose bodies are where the scene puts them to where the first tick begins.
void begin(State& state, StepBuffers& buffers, const CompileOptions& options) {
  Bodies& bodies = state.bodies;
  for (Tissue& tissue : bodies.soft) {
    fit_to_mesh(state, tissue.index, {});
    tissue.surface.faces();  // refuses surfaces that can't be
  }
  make_organs_ready(state);
  make_refinable(state);
  for (BodyId body = 0; body < bodies.count(); ++body)
    if (bodies.is_part(body) && !state.panels) state.panels.emplace(bodies.model.h);
  check_overlaps(state, options);
  settle(state, buffers.contacts, options);
  for (const Tissue& tissue : bodies.soft) state.dissection.uncut_equilibrium.push_back(tissue.equilibrium);
}

}  // namespace

struct Simulation::Impl {
  Impl(CompiledScene compiled, const CompileOptions& options)
      : model(std::move(compiled.model)),
        state(model, std::move(compiled.soft)),
        buffers(state),
        arena(threads_of(options)) {
    arena.execute([&] { begin(state, buffers, options); });
  }

  const Model model;
  State state;
  StepBuffers buffers;
  StepReport report;
  tbb::task_arena arena;
};

Simulation::Simulation(const SceneDesc& scene, const CompileOptions& options)
    : impl_(std::make_unique<Impl>(compile(scene, options), options)) {}
Simulation::~Simulation() = default;

const StepReport& Simulation::step(const TickInput& input) {
  Impl& m = *impl_;
  m.arena.execute([&] {
    m.report = {};
    prosector::step(m.state, m.buffers, input, m.report);
  });
  return m.report;
}

const SceneDesc& Simulation::scene() const {
  return impl_->model.scene;
}
std::size_t Simulation::body_count() const {
  return impl_->state.bodies.count();
}
BodyKind Simulation::kind(BodyId body) const {
  return impl_->state.bodies.is_soft(body) ? BodyKind::soft : BodyKind::rigid;
}
const std::string& Simulation::name(BodyId body) const {
  return impl_->state.bodies.is_soft(body) ? soft(body).desc().name : impl_->model.rigid.at(body).name;
}
const TriangleMesh& Simulation::surface(BodyId body) const {
  return impl_->state.bodies.is_soft(body) ? soft(body).anatomy().surface
                                           : impl_->model.rigid.at(body).surface;
}
const soft::SoftBody& Simulation::soft(BodyId body) const {
  return *impl_->state.bodies.soft.at(impl_->state.bodies.soft_index(body)).solver;
}
std::uint32_t Simulation::revision(BodyId soft_body) const {
  return impl_->state.bodies.soft.at(impl_->state.bodies.soft_index(soft_body)).revision;
}
const Numbering& Simulation::numbering(BodyId soft_body) const {
  return impl_->state.bodies.soft.at(impl_->state.bodies.soft_index(soft_body)).numbering;
}
std::uint64_t Simulation::topology_hash(BodyId soft_body) const {
  return prosector::topology_hash(impl_->state, impl_->state.bodies.soft_index(soft_body));
}
std::uint64_t Simulation::rehung(BodyId soft_body) const {
  const organs::RefinedBodies& refined = impl_->state.dissection.refined;
  const auto body = refined.find(impl_->state.bodies.soft_index(soft_body));
  return body == refined.end() ? 0 : body->second.rehung;
}
ContentHash Simulation::content_hash() const {
  return impl_->model.hash;
}

SimTime Simulation::time() const {
  return impl_->state.time;
}
RigidBodyState Simulation::rigid_state(BodyId body) const {
  const rigid::RigidMotion motion = impl_->state.bodies.rigid.motion(body);
  const Pose& center = impl_->model.rigid.at(body).center;
  const Pose pose = motion.pose * center.inverse();
  return {pose, motion.linear_velocity + motion.angular_velocity.cross(pose.p - motion.pose.p),
          motion.angular_velocity, asleep(body)};
}
const soft::SoftBodyState& Simulation::soft_state(BodyId body) const {
  return impl_->state.bodies.soft.at(impl_->state.bodies.soft_index(body)).state;
}
const Part& Simulation::part(BodyId body) const {
  return impl_->state.bodies.parts.at(body);
}
bool Simulation::asleep(BodyId body) const {
  if (impl_->state.bodies.is_soft(body)) return soft_state(body).asleep;
  return !impl_->state.bodies.rigid.dynamic(body) || impl_->state.bodies.rigid.motion(body).asleep;
}
HandSurroundings Simulation::around(const HandRef& hand, double reach) const {
  return surroundings_of(impl_->state, impl_->buffers.islands, impl_->buffers.colliders, hand, reach);
}
std::vector<Panel> Simulation::panels() const {
  if (!impl_->state.panels) return {};
  std::vector<Panel> out = impl_->state.panels->panels();
  for (Panel& panel : out) panel.time = impl_->state.time;
  return out;
}
double Simulation::room_lights() const {
  return impl_->state.room_lights;
}
std::span<const HandState> Simulation::hands() const {
  return impl_->buffers.hand_states;
}
std::vector<Exchange> Simulation::exchanges() const {
  return prosector::exchanges(impl_->state, impl_->buffers);
}

double Simulation::max_displacement(BodyId soft_body) const {
  const SparseMap& map = soft(soft_body).anatomy().embedding;
  const double* now = soft_state(soft_body).motion.x.data();
  const double* rest =
      impl_->state.bodies.soft.at(impl_->state.bodies.soft_index(soft_body)).equilibrium.data();
  double most = 0;
  for (std::size_t i = 0; i < map.rows.size(); ++i)
    most = std::max(most, (map.apply(i, now) - map.apply(i, rest)).squaredNorm());
  return std::sqrt(most);
}

std::uint64_t Simulation::state_hash() const {
  return hash_of(impl_->state);
}

std::vector<std::uint8_t> Simulation::save(RecordLabels* labels) const {
  ByteWriter out;
  prosector::save(impl_->state, out, labels);
  return out.bytes();
}

std::vector<std::uint8_t> Simulation::checkpoint() {
  const std::vector<std::uint8_t> out = save();
  load(impl_->state, out);
  return out;
}

Refusal Simulation::take_over(const Simulation& from) {
  try {
    if (Refusal why = prosector::take_over(from.impl_->state, impl_->state)) return why;
    checkpoint();
  } catch (const InputError& error) {  // of the bytes that carry the state over
    return fmt::format(
        "internal error: the simulation's state cannot be transferred to the rebuilt scene: {}. Please "
        "report this.",
        error.what());
  }
  clear_last_tick(impl_->state, impl_->buffers);
  return {};
}

void Simulation::restore(std::span<const std::uint8_t> bytes) {
  load(impl_->state, bytes);
  clear_last_tick(impl_->state, impl_->buffers);
}

std::size_t tet_count(const Simulation& simulation) {
  std::size_t count = 0;
  for (BodyId body = 0; body < simulation.body_count(); ++body)
    if (simulation.kind(body) == BodyKind::soft) count += simulation.soft(body).anatomy().tets.tets.size();
  return count;
}

}  // namespace prosector
