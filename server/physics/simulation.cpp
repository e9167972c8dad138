#include "server/physics/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "common/error.h"
#include "server/physics/phase_clock.h"
#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

int threads_of(const CompileOptions& options) {
  return options.threads > 0 ? options.threads
                             : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

Simulation::Impl::Impl(const SceneDesc& scene, const CompileOptions& options)
    : model(compile(scene, options)),
      world(scene.gravity, room_sides(scene.room)),
      soft_boxes(still_margin),
      step_h(model.h),
      arena(threads_of(options)) {
  for (const RigidModel& r : model.rigid) {
    RigidMotion motion;
    motion.pose = r.start * r.center;
    world.add(r.setup, motion);
  }
  for (const RigidDesc& desc : model.scene.rigid) blade_shapes.push_back(blade_shape(desc.edges));
  parts = initial_parts(model.soft.size());
  for (BodyId body = 0; body < model.rigid.size(); ++body) take_effect(world, body);
  for (std::size_t i = 0; i < model.soft.size(); ++i) {
    soft.push_back(model.soft[i]->initial_state());
    fit_to_mesh(i, detector(*model.soft[i]), {});
    faces_of(i);  // refuses surfaces that can't be
  }
  arena.execute([&] { make_organs_ready(); });
  for (BodyId body = 0; body < parts.size(); ++body)
    if (is_part(body) && !panels) panels.emplace(model.h);
  arena.execute([&] { settle(options); });
  uncut_equilibrium = equilibrium;
}

Simulation::Simulation(const SceneDesc& scene, const CompileOptions& options)
    : impl_(std::make_unique<Impl>(scene, options)) {}
Simulation::~Simulation() = default;

const StepReport& Simulation::step(const TickInput& input) {
  Impl& m = *impl_;
  m.arena.execute([&] {
    m.report = {};
    Impl::PhaseClock clock(m.report);
    m.take_inputs(input);
    clock.end(Phase::inputs);
    m.advance_in_parts(clock);
    ++m.time.tick;
    m.recover_hands();
    m.unfold_tangles();
    m.fall_asleep();
    m.bring_back_lost();
    m.tend_holds();
    m.break_bones();
    m.step_panels();
    clock.end(Phase::constraints);
    m.describe();
    clock.end(Phase::report);
    m.cut_soft_bodies(input);  // what the next tick is made of
    clock.end(Phase::constraints);
  });
  return m.report;
}

const SceneDesc& Simulation::scene() const {
  return impl_->model.scene;
}
std::size_t Simulation::body_count() const {
  return impl_->model.rigid.size() + impl_->model.soft.size();
}
BodyKind Simulation::kind(BodyId body) const {
  return impl_->is_soft(body) ? BodyKind::soft : BodyKind::rigid;
}
const std::string& Simulation::name(BodyId body) const {
  return impl_->is_soft(body) ? soft(body).desc().name : impl_->model.rigid.at(body).name;
}
const TriangleMesh& Simulation::surface(BodyId body) const {
  return impl_->is_soft(body) ? soft(body).anatomy().surface : impl_->model.rigid.at(body).surface;
}
const SoftBody& Simulation::soft(BodyId body) const {
  return *impl_->model.soft.at(impl_->soft_index(body));
}
std::uint32_t Simulation::revision(BodyId soft_body) const {
  return impl_->revisions.at(impl_->soft_index(soft_body));
}
const Numbering& Simulation::numbering(BodyId soft_body) const {
  return impl_->numberings.at(impl_->soft_index(soft_body));
}
std::size_t Simulation::tet_count() const {
  std::size_t count = 0;
  for (const auto& body : impl_->model.soft) count += body->anatomy().tets.tets.size();
  return count;
}
ContentHash Simulation::content_hash() const {
  return impl_->model.hash;
}

SimTime Simulation::time() const {
  return impl_->time;
}
RigidBodyState Simulation::rigid_state(BodyId body) const {
  const RigidMotion motion = impl_->world.motion(body);
  const Pose& center = impl_->model.rigid.at(body).center;
  const Pose pose = motion.pose * center.inverse();
  return {pose, motion.linear_velocity + motion.angular_velocity.cross(pose.p - motion.pose.p),
          motion.angular_velocity, asleep(body)};
}
const SoftBodyState& Simulation::soft_state(BodyId body) const {
  return impl_->soft.at(impl_->soft_index(body));
}
const Part& Simulation::part(BodyId body) const {
  return impl_->parts.at(body);
}
bool Simulation::asleep(BodyId body) const {
  if (impl_->is_soft(body)) return soft_state(body).asleep;
  return !impl_->world.dynamic(body) || impl_->world.motion(body).asleep;
}
std::vector<Panel> Simulation::panels() const {
  if (!impl_->panels) return {};
  std::vector<Panel> out = impl_->panels->panels();
  for (Panel& panel : out) panel.time = impl_->time;
  return out;
}
double Simulation::room_lights() const {
  return impl_->room_lights;
}
std::span<const HandState> Simulation::hands() const {
  return impl_->hand_states;
}
std::vector<Exchange> Simulation::exchanges() const {
  return impl_->exchanges();
}

double Simulation::max_displacement(BodyId soft_body) const {
  const SparseMap& map = soft(soft_body).anatomy().embedding;
  const double* now = soft_state(soft_body).motion.x.data();
  const double* rest = impl_->equilibrium.at(impl_->soft_index(soft_body)).data();
  double most = 0;
  for (std::size_t i = 0; i < map.rows.size(); ++i)
    most = std::max(most, (map.apply(i, now) - map.apply(i, rest)).squaredNorm());
  return std::sqrt(most);
}

std::uint64_t Simulation::state_hash() const {
  StateHasher hasher;
  ByteWriter state;
  impl_->save(state);
  hasher.add(std::as_bytes(std::span(state.bytes())));
  impl_->world.hash(hasher);
  return hasher.digest();
}

std::vector<std::uint8_t> Simulation::save() const {
  ByteWriter out;
  impl_->save(out);
  return out.bytes();
}

std::vector<std::uint8_t> Simulation::checkpoint() {
  ByteWriter out;
  impl_->save(out);
  impl_->load(out.bytes());
  return out.bytes();
}

void Simulation::restore(std::span<const std::uint8_t> bytes) {
  impl_->load(bytes);
  impl_->earlier_exchanges.clear();
  impl_->islands.clear();  // of the state that was: the hands touch nothing until the next step
  impl_->describe_hands();
}

}  // namespace prosector
