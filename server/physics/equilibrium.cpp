// The shape in which each soft body rests under gravity, on the things around it: found once per
// compiled scene by dynamic relaxation (implicit steps much longer than a tick, velocities dropped after
// each).

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "server/physics/coupled/island_solver.h"
#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

constexpr double relaxation_step = 0.1;  // s
constexpr int most_relaxation_steps = 150;
constexpr double at_rest = 2e-6;            // m a step
constexpr double relaxation_margin = 0.02;  // m: what is nearer may carry the body

std::filesystem::path cache_file(const CompileOptions& options, const ContentHash& hash) {
  return options.cache_dir / (to_hex(hash) + ".equilibrium");
}

bool read_cache(const std::filesystem::path& file, std::vector<VecX>& shapes) {
  std::ifstream in(file, std::ios::binary);
  if (!in) return false;
  const std::vector<char> bytes((std::istreambuf_iterator<char>(in)), {});
  try {
    ByteReader reader(std::span(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()),
                      file.string());
    std::vector<VecX> found;
    for (const VecX& shape : shapes) found.push_back(reader.vector(shape.size()));
    if (!reader.done()) return false;
    shapes = std::move(found);
    return true;
  } catch (const InputError&) {
    return false;  // damaged: computed anew
  }
}

/// Written beside and renamed, so that a reader never sees half a file. A cache that can't be written is no
/// error.
void write_cache(const std::filesystem::path& file, const std::vector<VecX>& shapes) {
  ByteWriter out;
  for (const VecX& shape : shapes) out.add(shape);
  std::error_code ignored;
  std::filesystem::create_directories(file.parent_path(), ignored);
  const auto part = std::filesystem::path(file.string() + ".part");
  std::ofstream stream(part, std::ios::binary);
  stream.write(reinterpret_cast<const char*>(out.bytes().data()),
               static_cast<std::streamsize>(out.bytes().size()));
  stream.close();
  if (stream)
    std::filesystem::rename(part, file, ignored);
  else
    std::filesystem::remove(part, ignored);
}

}  // namespace

void Simulation::Impl::relax(std::size_t body) {
  SoftBodyState& state = soft[body];
  IslandSolver solver;
  for (int step = 0; step < most_relaxation_steps; ++step) {
    surfaces[body].update(state.motion.x.data());
    Island island;
    island.soft.push_back({body, model.soft[body].get(), &state});
    for (Collider c : colliders) {
      c.fixed = true;  // what moves stands still until the scene runs
      if (c.parts) add_contacts(body, c, relaxation_margin, island.contacts);
    }
    const VecX before = state.motion.x;
    model.soft[body]->set_relaxed(true);
    const IslandReport solved = solver.solve(island, relaxation_step, model.scene.gravity);
    model.soft[body]->set_relaxed(false);
    state.motion.v.setZero();
    state.warm_start.setZero();
    state.motion.has_history = false;
    if (!solved.finite || (state.motion.x - before).lpNorm<Eigen::Infinity>() < at_rest) return;
  }
}

/// A body that nothing ties and nothing is near has no equilibrium to find: it starts where the scene puts
/// it, and falls.
bool Simulation::Impl::floats(std::size_t body) const {
  const SoftBody& b = *model.soft[body];
  if (!b.desc().gravity || model.scene.gravity.isZero() || !b.attachment_stiffness().isZero()) return false;
  return std::none_of(colliders.begin(), colliders.end(), [&](const Collider& c) {
    return c.parts && surfaces[body].touches(c, skin_of(body) + relaxation_margin);
  });
}

void Simulation::Impl::settle(const CompileOptions& options) {
  refresh_colliders();
  for (const SoftBodyState& state : soft) equilibrium.push_back(state.motion.x);
  const bool cached = !options.cache_dir.empty() && read_cache(cache_file(options, model.hash), equilibrium);
  for (std::size_t i = 0; i < soft.size(); ++i) {
    const bool falls = floats(i);
    if (cached)
      soft[i].motion.x = equilibrium[i];
    else if (!falls)
      relax(i);
    equilibrium[i] = soft[i].motion.x;
    soft[i].motion.x_prev = soft[i].motion.x;
    soft[i].asleep = !falls;
    surfaces[i].update(soft[i].motion.x.data());
    if (options.progress && !cached && !falls)
      options.progress(fmt::format(
          "{}: settled, {:.1f} mm from its imaged shape", model.soft[i]->desc().name,
          1e3 * (equilibrium[i] - model.soft[i]->initial_state().motion.x).lpNorm<Eigen::Infinity>()));
  }
  if (!cached && !options.cache_dir.empty() && !soft.empty())
    write_cache(cache_file(options, model.hash), equilibrium);
}

}  // namespace prosector
