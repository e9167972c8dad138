#include "server/physics/stations/compile/equilibrium.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <span>

#include "common/byte_stream.h"
#include "common/error.h"
#include "common/sealed_file.h"
#include "server/physics/mechanics/coupled/island_solver.h"
#include "server/physics/mechanics/soft/implicit_stepper.h"
#include "server/physics/mechanics/soft/recovery_law.h"
#include "server/physics/mechanics/soft/unfold.h"
#include "server/physics/stations/touching/rigid_soft_contacts.h"

namespace prosector {
namespace {

constexpr double relaxation_step = 0.1;  // s
constexpr int most_relaxation_steps = 150;
constexpr double at_rest = 2e-6;            // m per step: smaller motion counts as rest
constexpr double relaxation_margin = 0.02;  // m: bodies nearer than this may support each other
constexpr double most_inverted = 0.05;      // of the volume inverted: not an equilibrium of tissue

/// Equilibrium of a body.
struct Rest {
  VecX shape;               // 3n, m
  bool recovering = false;  // under the recovery law, since the body's own law can't carry its weight
};

std::filesystem::path cache_file(const CompileOptions& options, const ContentHash& hash) {
  return options.cache_dir / (to_hex(hash) + ".rest");
}

/// Returns the key with which the file is sealed: its format and its scene.
std::string seal_key(const ContentHash& hash) {
  return "rest 3 " + to_hex(hash);
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
    return false;  // file of other bodies
  }
}

/// Reads the cache. Returns false if it is missing or doesn't match; the equilibrium is then recomputed.
bool read_cache(const CompileOptions& options, const ContentHash& hash, std::vector<Rest>& rests) {
  if (options.cache_dir.empty()) return false;
  const std::filesystem::path file = cache_file(options, hash);
  SealedFileResult found = read_sealed_file(file, seal_key(hash));
  if (found.bytes && read_rests(*found.bytes, rests)) return true;
  if (found.bytes) found.error = "is damaged";
  if (!found.error.empty() && options.progress)
    options.progress(fmt::format("cache file {} {}: the bodies' equilibrium is computed again",
                                 file.filename().string(), found.error));
  return false;
}

/// Writes the cache; failure to write is no error.
void write_cache(const CompileOptions& options, const ContentHash& hash, const std::vector<Rest>& rests) {
  ByteWriter out;
  for (const Rest& rest : rests) {
    out.add(rest.shape);
    out.add(static_cast<std::uint8_t>(rest.recovering));
  }
  write_sealed_file(cache_file(options, hash), seal_key(hash), out.bytes());
}

/// Finds equilibrium shapes, with surroundings as at the start of the scene.
class Settling {
 public:
  Settling(State& state, SoftContactFinder& finder) : state_(state), bodies_(state.bodies), finder_(finder) {
    refresh(colliders_, bodies_, state.hands, state.dissection.blades);
  }
  std::vector<std::vector<std::size_t>> neighbourhoods();
  void relax(std::span<const std::size_t> group);
  bool floats(std::span<const std::size_t> group) const;
  void settle_crushed(std::span<const std::size_t> group);

 private:
  State& state_;
  Bodies& bodies_;
  SoftContactFinder& finder_;
  Colliders colliders_;
};

void Settling::relax(std::span<const std::size_t> group) {
  coupled::IslandSolver solver;
  std::vector<contact::ContactMemories> held(bodies_.soft.size());
  for (int step = 0; step < most_relaxation_steps; ++step) {
    coupled::Island island;
    std::vector<VecX> before;
    for (const std::size_t body : group) {
      island.soft.push_back(
          {body, &bodies_.soft[body].solver->in_force(bodies_.soft[body].state), &bodies_.soft[body].state});
      before.push_back(bodies_.soft[body].state.motion.x);
      for (contact::Collider c : colliders_) {
        c.fixed = true;  // movable bodies stand still until the scene runs
        if (may_meet(bodies_.soft[body], c))
          add_contacts(bodies_.soft[body], c, relaxation_margin, held[body], bodies_.model.h,
                       island.contacts);
      }
      for (const std::size_t other : group)
        if (other >= body && bodies_.may_meet(body, other))
          finder_.add_pair_contacts(state_, body, other, relaxation_margin, bodies_.model.h, island.contacts);
    }
    coupled::weigh(island, bodies_.model.scene.gravity);
    for (const coupled::SoftMember& member : island.soft) member.body->stepper().set_relaxed(true);
    const coupled::IslandReport solved = solver.solve(island, relaxation_step);
    double moved = 0;
    for (std::size_t k = 0; k < group.size(); ++k) {
      const std::size_t body = group[k];
      soft::SoftBodyState& state = bodies_.soft[body].state;
      island.soft[k].body->stepper().set_relaxed(false);
      contact::keep(island.contacts, body, held[body]);
      stop(state);
      moved = std::max(moved, (state.motion.x - before[k]).lpNorm<Eigen::Infinity>());
      bodies_.soft[body].follow_nodes();
    }
    if (!solved.finite || moved < at_rest) return;
  }
}

/// Returns groups of bodies that support each other, whose equilibrium is found together.
std::vector<std::vector<std::size_t>> Settling::neighbourhoods() {
  std::vector<std::size_t> first(bodies_.soft.size());
  std::iota(first.begin(), first.end(), std::size_t{0});
  std::vector<contact::Contact> found;
  for (std::size_t i = 0; i < bodies_.soft.size(); ++i)
    for (std::size_t j = i + 1; j < bodies_.soft.size(); ++j) {
      if (!bodies_.may_meet(i, j) || first[i] == first[j]) continue;
      if (!finder_.add_pair_contacts(state_, i, j, relaxation_margin, bodies_.model.h, found)) continue;
      const auto [to, from] = std::minmax(first[i], first[j]);
      std::replace(first.begin(), first.end(), std::size_t{from}, std::size_t{to});
    }
  std::vector<std::vector<std::size_t>> out(bodies_.soft.size());
  for (std::size_t i = 0; i < bodies_.soft.size(); ++i) out[first[i]].push_back(i);
  std::erase_if(out, [](const auto& group) { return group.empty(); });
  return out;
}

/// Returns whether the group is unattached and nothing is near. Then there is no equilibrium: the bodies fall
/// from their start.
bool Settling::floats(std::span<const std::size_t> group) const {
  const auto falls = [&](std::size_t body) {
    return bodies_.soft[body].solver->desc().gravity && !bodies_.model.scene.gravity.isZero();
  };
  const auto held = [&](std::size_t body) {
    return !bodies_.soft[body].solver->attachment_stiffness().isZero() ||
           std::any_of(colliders_.begin(), colliders_.end(), [&](const contact::Collider& c) {
             return may_meet(bodies_.soft[body], c) && touches(bodies_.soft[body], c, relaxation_margin);
           });
  };
  return std::any_of(group.begin(), group.end(), falls) && std::none_of(group.begin(), group.end(), held);
}

/// Relaxes a group with bodies that their own weight inverts again, with these under the recovery law, which
/// they keep.
void Settling::settle_crushed(std::span<const std::size_t> group) {
  bool again = false;
  for (const std::size_t body : group) {
    soft::SoftBody& b = *bodies_.soft[body].solver;
    if (!b.recovery().exists() ||
        soft::inverted_share(b.linear_tets(), bodies_.soft[body].state.motion.x) <= most_inverted)
      continue;
    b.recovery().keep();
    again = true;
  }
  if (!again) return;
  for (const std::size_t body : group) {
    bodies_.soft[body].state = bodies_.soft[body].solver->initial_state();
    bodies_.soft[body].state.recovering = bodies_.soft[body].solver->recovery().is_kept();
    bodies_.soft[body].follow_nodes();
  }
  relax(group);
}

/// Reports a body that its own weight crushes: its description is unrealistic.
void report_if_crushed(const Tissue& tissue, const CompileOptions& options) {
  const soft::SoftBody& b = *tissue.solver;
  const double share = soft::inverted_share(b.linear_tets(), tissue.equilibrium);
  if ((share == 0 && !b.recovery().is_kept()) || !options.progress) return;
  const SoftDesc& desc = b.desc();
  const std::string what =
      b.recovery().is_kept()
          ? fmt::format("its own weight crushes it with model {}, so fem_corotational is used",
                        desc.configuration.model)
          : fmt::format("its own weight crushes {:.2g} % of its elements", 100 * share);
  options.progress(
      fmt::format("soft body \"{}\": {}; set youngs_modulus above {:.3g} Pa, make the body smaller, or "
                  "attach it ([[soft.attach]])",
                  desc.name, what, desc.material.youngs_modulus));
}

}  // namespace

void settle(State& state, SoftContactFinder& finder, const CompileOptions& options) {
  Bodies& bodies = state.bodies;
  Settling settling(state, finder);
  std::vector<Rest> rests;
  for (const Tissue& tissue : bodies.soft) rests.push_back({tissue.state.motion.x});
  const bool cached = read_cache(options, bodies.model.hash, rests);
  for (std::size_t i = 0; i < bodies.soft.size(); ++i)
    if (cached && rests[i].recovering) bodies.soft[i].solver->recovery().keep();
  for (const std::vector<std::size_t>& group : settling.neighbourhoods()) {
    const bool falls = settling.floats(group);
    if (!cached && !falls) settling.relax(group);
    if (!cached && !falls) settling.settle_crushed(group);
    for (const std::size_t i : group) {
      Tissue& tissue = bodies.soft[i];
      if (cached) tissue.state.motion.x = rests[i].shape;
      tissue.equilibrium = tissue.state.motion.x;
      rests[i] = {tissue.equilibrium, tissue.solver->recovery().is_kept()};
      tissue.state.motion.x_prev = tissue.state.motion.x;
      tissue.state.recovering = rests[i].recovering;
      tissue.state.asleep = !falls;
      tissue.place_surface();
      report_if_crushed(tissue, options);
      if (options.progress && !cached && !falls)
        options.progress(fmt::format(
            "{}: equilibrium found under gravity; nodes are up to {:.1f} mm from their imaged positions",
            tissue.solver->desc().name,
            1e3 * (tissue.equilibrium - tissue.solver->initial_state().motion.x).lpNorm<Eigen::Infinity>()));
    }
  }
  state.layer_sides.clear();  // as when the checkpointed shapes were read
  if (!cached && !options.cache_dir.empty() && !bodies.soft.empty())
    write_cache(options, bodies.model.hash, rests);
}

}  // namespace prosector
