// The shape in which each soft body rests under gravity, on the things around it: found once per
// compiled scene by dynamic relaxation (implicit steps much longer than a tick, velocities dropped after
// each).

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>

#include "common/sealed_file.h"
#include "server/physics/coupled/island_solver.h"
#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

constexpr double relaxation_step = 0.1;  // s
constexpr int most_relaxation_steps = 150;
constexpr double at_rest = 2e-6;            // m a step
constexpr double relaxation_margin = 0.02;  // m: what is nearer may carry the body

std::filesystem::path cache_file(const CompileOptions& options, const ContentHash& hash) {
  return options.cache_dir / (to_hex(hash) + ".rest");
}

/// What the file is sealed under: its layout, and the scene that it belongs to.
std::string seal_key(const ContentHash& hash) {
  return "rest 1 " + to_hex(hash);
}

bool read_shapes(const std::vector<std::uint8_t>& bytes, std::vector<VecX>& shapes) {
  try {
    ByteReader reader(bytes, "equilibrium");
    std::vector<VecX> found;
    for (const VecX& shape : shapes) found.push_back(reader.vector(shape.size()));
    if (!reader.done()) return false;
    shapes = std::move(found);
    return true;
  } catch (const InputError&) {
    return false;  // of other bodies
  }
}

/// False when there is none, or one that does not fit: it is found anew.
bool read_cache(const CompileOptions& options, const ContentHash& hash, std::vector<VecX>& shapes) {
  if (options.cache_dir.empty()) return false;
  const std::filesystem::path file = cache_file(options, hash);
  FoundFile found = read_sealed(file, seal_key(hash));
  if (found.bytes && read_shapes(*found.bytes, shapes)) return true;
  if (found.bytes) found.trouble = "is damaged";
  if (!found.trouble.empty() && options.progress)
    options.progress(fmt::format("cache {} {}: bodies settle anew", file.filename().string(), found.trouble));
  return false;
}

/// A cache that can't be written is no error.
void write_cache(const CompileOptions& options, const ContentHash& hash, const std::vector<VecX>& shapes) {
  ByteWriter out;
  for (const VecX& shape : shapes) out.add(shape);
  write_sealed(cache_file(options, hash), seal_key(hash), out.bytes());
}

}  // namespace

void Simulation::Impl::relax(std::span<const std::size_t> bodies) {
  IslandSolver solver;
  std::vector<ContactMemories> held(soft.size());
  for (int step = 0; step < most_relaxation_steps; ++step) {
    Island island;
    std::vector<VecX> before;
    for (const std::size_t body : bodies) {
      island.soft.push_back({body, model.soft[body].get(), &soft[body]});
      before.push_back(soft[body].motion.x);
      for (Collider c : colliders) {
        c.fixed = true;  // what moves stands still until the scene runs
        if (may_meet(body, c)) add_contacts(body, c, relaxation_margin, held[body], island.contacts);
      }
      for (const std::size_t other : bodies)
        if (other >= body && may_meet(body, other))
          add_pair_contacts(body, other, relaxation_margin, island.contacts);
    }
    for (const std::size_t body : bodies) model.soft[body]->set_relaxed(true);
    const IslandReport solved = solver.solve(island, relaxation_step, model.scene.gravity);
    double moved = 0;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const std::size_t body = bodies[k];
      SoftBodyState& state = soft[body];
      model.soft[body]->set_relaxed(false);
      keep(island.contacts, body, held[body]);
      state.motion.v.setZero();
      state.warm_start.setZero();
      state.motion.has_history = false;
      moved = std::max(moved, (state.motion.x - before[k]).lpNorm<Eigen::Infinity>());
      follow_nodes(body);
    }
    if (!solved.finite || moved < at_rest) return;
  }
}

/// Bodies that bear each other have their equilibrium together.
std::vector<std::vector<std::size_t>> Simulation::Impl::neighbourhoods() {
  std::vector<std::size_t> first(soft.size());
  std::iota(first.begin(), first.end(), std::size_t{0});
  std::vector<Contact> found;
  for (std::size_t i = 0; i < soft.size(); ++i)
    for (std::size_t j = i + 1; j < soft.size(); ++j) {
      if (!may_meet(i, j) || first[i] == first[j]) continue;
      if (!add_pair_contacts(i, j, relaxation_margin, found)) continue;
      const auto [to, from] = std::minmax(first[i], first[j]);
      std::replace(first.begin(), first.end(), std::size_t{from}, std::size_t{to});
    }
  std::vector<std::vector<std::size_t>> out(soft.size());
  for (std::size_t i = 0; i < soft.size(); ++i) out[first[i]].push_back(i);
  std::erase_if(out, [](const auto& group) { return group.empty(); });
  return out;
}

/// What nothing ties and nothing is near has no equilibrium to find: it starts where the scene puts it, and
/// falls.
bool Simulation::Impl::floats(std::span<const std::size_t> bodies) const {
  const auto falls = [&](std::size_t body) {
    return model.soft[body]->desc().gravity && !model.scene.gravity.isZero();
  };
  const auto held = [&](std::size_t body) {
    return !model.soft[body]->attachment_stiffness().isZero() ||
           std::any_of(colliders.begin(), colliders.end(), [&](const Collider& c) {
             return may_meet(body, c) && touches(body, c, relaxation_margin);
           });
  };
  return std::any_of(bodies.begin(), bodies.end(), falls) && std::none_of(bodies.begin(), bodies.end(), held);
}

/// What rests inside out is no equilibrium of tissue: the author hears of it.
void Simulation::Impl::tell_if_crushed(std::size_t body, const CompileOptions& options) {
  const double share = model.soft[body]->inverted_share(equilibrium[body]);
  if (share == 0 || !options.progress) return;
  const SoftDesc& desc = model.soft[body]->desc();
  options.progress(
      fmt::format("soft body \"{}\": its own weight crushes {:.2g} % of it; let it be stiffer than {:.3g} "
                  "Pa, smaller, or "
                  "tied to its place ([[soft.attach]])",
                  desc.name, 100 * share, desc.youngs_modulus));
}

void Simulation::Impl::settle(const CompileOptions& options) {
  refresh_colliders();
  for (const SoftBodyState& state : soft) equilibrium.push_back(state.motion.x);
  const bool cached = read_cache(options, model.hash, equilibrium);
  for (const std::vector<std::size_t>& bodies : neighbourhoods()) {
    const bool falls = floats(bodies);
    if (!cached && !falls) relax(bodies);
    for (const std::size_t i : bodies) {
      if (cached) soft[i].motion.x = equilibrium[i];
      equilibrium[i] = soft[i].motion.x;
      soft[i].motion.x_prev = soft[i].motion.x;
      soft[i].asleep = !falls;
      place_surface(i);
      tell_if_crushed(i, options);
      if (options.progress && !cached && !falls)
        options.progress(fmt::format(
            "{}: settled, {:.1f} mm from its imaged shape", model.soft[i]->desc().name,
            1e3 * (equilibrium[i] - model.soft[i]->initial_state().motion.x).lpNorm<Eigen::Infinity>()));
    }
  }
  layer_sides.clear();  // as when the shapes were read
  if (!cached && !options.cache_dir.empty() && !soft.empty()) write_cache(options, model.hash, equilibrium);
}

}  // namespace prosector
