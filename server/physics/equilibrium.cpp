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
constexpr double most_inverted = 0.05;      // of the volume inside out: no equilibrium of tissue

/// What is found of a body.
struct Rest {
  VecX shape;               // 3n, m
  bool recovering = false;  // under the law that leads out of every shape: its own doesn't carry its weight
};

std::filesystem::path cache_file(const CompileOptions& options, const ContentHash& hash) {
  return options.cache_dir / (to_hex(hash) + ".rest");
}

/// What the file is sealed under: its layout, and the scene that it belongs to.
std::string seal_key(const ContentHash& hash) {
  return "rest 2 " + to_hex(hash);
}

bool read_rests(const std::vector<std::uint8_t>& bytes, std::vector<Rest>& rests) {
  try {
    ByteReader reader(bytes, "equilibrium");
    std::vector<Rest> found;
    for (const Rest& rest : rests) {
      found.push_back({reader.vector(rest.shape.size())});
      found.back().recovering = reader.flag();
    }
    if (!reader.done()) return false;
    rests = std::move(found);
    return true;
  } catch (const InputError&) {
    return false;  // of other bodies
  }
}

/// False when there is none, or one that does not fit: it is found anew.
bool read_cache(const CompileOptions& options, const ContentHash& hash, std::vector<Rest>& rests) {
  if (options.cache_dir.empty()) return false;
  const std::filesystem::path file = cache_file(options, hash);
  FoundFile found = read_sealed(file, seal_key(hash));
  if (found.bytes && read_rests(*found.bytes, rests)) return true;
  if (found.bytes) found.trouble = "is damaged";
  if (!found.trouble.empty() && options.progress)
    options.progress(fmt::format("cache {} {}: bodies settle anew", file.filename().string(), found.trouble));
  return false;
}

/// A cache that can't be written is no error.
void write_cache(const CompileOptions& options, const ContentHash& hash, const std::vector<Rest>& rests) {
  ByteWriter out;
  for (const Rest& rest : rests) {
    out.add(rest.shape);
    out.add(static_cast<std::uint8_t>(rest.recovering));
  }
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
      island.soft.push_back({body, &model.soft[body]->in_force(soft[body]), &soft[body]});
      before.push_back(soft[body].motion.x);
      for (Collider c : colliders) {
        c.fixed = true;  // what moves stands still until the scene runs
        if (may_meet(body, c)) add_contacts(body, c, relaxation_margin, held[body], island.contacts);
      }
      for (const std::size_t other : bodies)
        if (other >= body && may_meet(body, other))
          add_pair_contacts(body, other, relaxation_margin, island.contacts);
    }
    for (const SoftMember& member : island.soft) member.body->set_relaxed(true);
    const IslandReport solved = solver.solve(island, relaxation_step, model.scene.gravity);
    double moved = 0;
    for (std::size_t k = 0; k < bodies.size(); ++k) {
      const std::size_t body = bodies[k];
      SoftBodyState& state = soft[body];
      island.soft[k].body->set_relaxed(false);
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

/// Bodies that their own weight turns inside out settle again, with what they touch, under the law that leads
/// out of every shape, and keep it.
void Simulation::Impl::settle_crushed(std::span<const std::size_t> bodies) {
  bool again = false;
  for (const std::size_t body : bodies) {
    SoftBody& b = *model.soft[body];
    if (!b.has_recovery() || b.inverted_share(soft[body].motion.x) <= most_inverted) continue;
    b.keep_recovering();
    again = true;
  }
  if (!again) return;
  for (const std::size_t body : bodies) {
    soft[body] = model.soft[body]->initial_state();
    soft[body].recovering = model.soft[body]->keeps_recovering();
    follow_nodes(body);
  }
  relax(bodies);
}

/// What its own weight crushes is no tissue as it is described: the author hears of it.
void Simulation::Impl::tell_if_crushed(std::size_t body, const CompileOptions& options) {
  const SoftBody& b = *model.soft[body];
  const double share = b.inverted_share(equilibrium[body]);
  if ((share == 0 && !b.keeps_recovering()) || !options.progress) return;
  const SoftDesc& desc = b.desc();
  const std::string what =
      b.keeps_recovering()
          ? fmt::format("under {} its own weight crushes it: it is fem_corotational", desc.model)
          : fmt::format("its own weight crushes {:.2g} % of it", 100 * share);
  options.progress(
      fmt::format("soft body \"{}\": {}; let it be stiffer than {:.3g} Pa, smaller, or tied to its place "
                  "([[soft.attach]])",
                  desc.name, what, desc.youngs_modulus));
}

void Simulation::Impl::settle(const CompileOptions& options) {
  refresh_colliders();
  std::vector<Rest> rests;
  for (const SoftBodyState& state : soft) rests.push_back({state.motion.x});
  const bool cached = read_cache(options, model.hash, rests);
  for (std::size_t i = 0; i < soft.size(); ++i)
    if (cached && rests[i].recovering) model.soft[i]->keep_recovering();
  equilibrium.resize(soft.size());
  for (const std::vector<std::size_t>& bodies : neighbourhoods()) {
    const bool falls = floats(bodies);
    if (!cached && !falls) relax(bodies);
    if (!cached && !falls) settle_crushed(bodies);
    for (const std::size_t i : bodies) {
      if (cached) soft[i].motion.x = rests[i].shape;
      equilibrium[i] = soft[i].motion.x;
      rests[i] = {equilibrium[i], model.soft[i]->keeps_recovering()};
      soft[i].motion.x_prev = soft[i].motion.x;
      soft[i].recovering = rests[i].recovering;
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
  if (!cached && !options.cache_dir.empty() && !soft.empty()) write_cache(options, model.hash, rests);
}

}  // namespace prosector
