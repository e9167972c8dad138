#include "server/physics/stations/dissecting/cut_by_blades.h"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <map>
#include <string>

#include "common/error.h"
#include "server/physics/mechanics/cutting/carry.h"
#include "server/physics/mechanics/organs/sheet_parts.h"
#include "server/physics/mechanics/soft/rungs.h"
#include "server/physics/stations/dissecting/blade_sweep.h"
#include "server/physics/stations/dissecting/piece_builder.h"
#include "server/physics/stations/dissecting/refining.h"
#include "server/physics/stations/dissecting/tissue_near.h"

namespace prosector {
namespace {

/// Buffers of the cutting in one tick.
struct CutTick {
  std::map<std::size_t, std::vector<Vec3>> positions;  // of cut organs: by node id
  cutting::CutResult figures;                          // summed over all cuts
};

/// Returns the node positions of an organ, by id.
std::vector<Vec3> node_positions(const Bodies& bodies, const organs::Organ& organ) {
  std::vector<Vec3> out(organ.complex().node_end(), Vec3::Zero());
  for (const organs::OrganPiece& piece : organ.pieces())
    for (std::size_t n = 0; n < piece.mesh.nodes.size(); ++n)
      out[piece.mesh.nodes[n]] =
          bodies.soft[piece.body].state.motion.x.segment<3>(3 * static_cast<Eigen::Index>(n));
  return out;
}

/// Moves a stroke with a sheet, like the edge's points, since it stores its edge in the world frame only.
void carry_beside_sheet(const Bodies& bodies, cutting::BladeStroke& stroke, const organs::Blade& blade,
                        std::size_t edge, std::span<const Vec3> from) {
  std::size_t first = 0;
  for (std::size_t e = 0; e < edge; ++e) first += bodies.model.blades[blade.slot].edges[e].points.size();
  for (std::size_t k = 0; k < from.size(); ++k) stroke.edge[k].room += from[k] - blade.cut_to[first + k];
}

bool can_cut(const Bodies& bodies, std::size_t body, bool with_ray) {
  const Tissue& tissue = bodies.soft[body];
  const soft::MeshKind kind = soft::mesh_kind(tissue.solver->anatomy());
  return kind != soft::MeshKind::rope && (!with_ray || kind == soft::MeshKind::sheet) &&
         tissue.collision.fidelity != Fidelity::none;
}

/// Returns the body's organ; creates it if needed. Throws InputError for a mesh that can't be cut.
organs::Organ& organ_of(State& state, std::size_t body) {
  if (const auto cut = state.dissection.organs.find(body); cut != state.dissection.organs.end())
    return cut->second;
  if (auto ready = state.dissection.uncut.extract(body))
    return state.dissection.organs.insert(std::move(ready)).position->second;
  const soft::SoftBody& soft_body = *state.bodies.soft[body].solver;
  return state.dissection.organs
      .try_emplace(body, body, soft_body.anatomy(), soft_body.desc().material.density,
                   held_nodes_of(state, body))
      .first->second;
}

/// Advances an edge of a blade through one organ. Throws InputError, and changes nothing, if that is
/// impossible.
void cut_organ(State& state, organs::Blade& blade, std::size_t edge, std::size_t first,
               std::span<const Vec3> from, std::span<const Vec3> to, CutTick& cut) {
  organs::Organ& organ = organ_of(state, first);
  const auto [stroke, begins] = blade.strokes.try_emplace({first, edge});
  if (begins)
    stroke->second = cutting::begin_stroke(from);
  else if (organ.complex().is_sheet())
    carry_beside_sheet(state.bodies, stroke->second, blade, edge, from);
  std::vector<Vec3>& positions = cut.positions[first];
  if (positions.empty()) positions = node_positions(state.bodies, organ);
  const cutting::CutResult result = organ.cut(positions, to, stroke->second, blade.holder, blade.stroke);
  for (const cutting::TopologyOp& op : result.ops) cutting::carry(op, positions);
  cut.figures.split_tets += result.split_tets;
  cut.figures.slivers += result.slivers;
  cut.figures.least_dihedral_deg = std::min(cut.figures.least_dihedral_deg, result.least_dihedral_deg);
}

/// Advances an edge of a blade through all tissue.
void cut_tissue(State& state, organs::Blade& blade, std::size_t edge, std::span<const Vec3> from,
                std::span<const Vec3> to, CutTick& cut, StepReport& report) {
  Bodies& bodies = state.bodies;
  const collision::Aabb swept = swept_box(from, to);
  const bool ray = bodies.model.blades[blade.slot].edges[edge].ray;
  for (std::size_t first = 0; first < bodies.model.scene.soft.size(); ++first) {
    if (!can_cut(bodies, first, ray)) continue;
    const auto cut_before = state.dissection.organs.find(first);
    const auto reaches = [&](std::size_t body) {
      return !bodies.parts[bodies.soft_id(body)].out_of_touch() &&
             bodies.soft[body].outer_box().overlaps(swept);
    };
    bool near = cut_before == state.dissection.organs.end() && reaches(first);
    if (cut_before != state.dissection.organs.end())
      for (const organs::OrganPiece& piece : cut_before->second.pieces())
        near |= piece.whole() && reaches(piece.body);
    if (!near) {
      blade.strokes.erase({first, edge});
      continue;
    }
    take_refinement_back(state, first);
    try {
      cut_organ(state, blade, edge, first, from, to, cut);
    } catch (const InputError& error) {  // the mesh can't be cut, for example because of flat elements
      BodyReport& row = report.bodies.emplace_back();
      row.body = bodies.soft[first].solver->desc().name;
      row.note = error.what();
    }
  }
}

/// Advances a blade: cuts the area that its points sweep where tissue yields.
void advance_blade(State& state, const Sweep& sweep, organs::Blade& blade, CutTick& cut, StepReport& report) {
  const bool begins = blade.stroke == 0 || blade.outside > organs::between_strokes;
  if (sweep.in_tissue && begins) blade.stroke = ++state.dissection.strokes;
  if (sweep.in_tissue)
    blade.outside = 0;
  else if (!blade.drawn)
    blade.outside += 1 / state.bodies.model.scene.tick_rate;
  std::size_t p = 0;
  const std::vector<organs::BladeShape::Edge>& edges = state.bodies.model.blades[blade.slot].edges;
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    const std::size_t count = edges[edge].points.size();
    cut_tissue(state, blade, edge, std::span(sweep.from).subspan(p, count),
               std::span(sweep.to).subspan(p, count), cut, report);
    p += count;
  }
  blade.cutting = sweep.in_tissue;
  blade.cut_to = sweep.to;
}

/// Applies an organ's change to the bodies of its pieces. On failure restores the state before the change and
/// returns the reason.
Refusal carry_through(State& state, std::size_t first, const organs::Organ::Mark& before, TopologyCause cause,
                      ParticipantId author, StepReport& report) {
  organs::Organ& organ = state.dissection.organs.at(first);
  try {
    remake(state, organ, cause, author, report);
    return {};
  } catch (const std::exception& error) {
    for (organs::Blade& blade : state.dissection.blades)
      std::erase_if(blade.strokes, [&](const auto& stroke) { return stroke.first.first == first; });
    if (before.changes == 0)
      state.dissection.organs.erase(first);
    else
      organ.back_to(before, state.bodies.soft.size());
    return error.what();
  }
}

std::uint64_t log_length(const State& state) {
  std::uint64_t sum = 0;
  for (const auto& [first, organ] : state.dissection.organs) sum += organ.log().size();
  return sum;
}

/// Reports dihedral angles of cut tetrahedra below the required minimum.
void report_cuts(const cutting::CutResult& figures, StepReport& report) {
  if (figures.slivers == 0) return;
  BodyReport& row = report.bodies.emplace_back();
  row.body = "cut";
  row.note = fmt::format(
      "the cut created {} tetrahedra with dihedral angles below {} degrees; the smallest angle is {:.1f} "
      "degrees",
      figures.slivers, cutting::least_dihedral_deg, figures.least_dihedral_deg);
}

}  // namespace

void cut_soft_bodies(State& state, std::span<const organs::BladeGrip> grips, StepReport& report) {
  CutTick tick;
  const std::uint64_t before = log_length(state);
  std::map<std::size_t, organs::Organ::Mark> marks;  // of cut organs, before this tick
  for (const auto& [first, organ] : state.dissection.organs) marks[first] = organ.mark();
  std::map<std::size_t, ParticipantId> cut_by;  // from organ to author of the cut
  std::vector<Sweep> sweeps;  // computed before any cut: a cut undoes refinement, to which grips refer
  for (const organs::Blade& blade : state.dissection.blades)
    sweeps.push_back(sweep_of(state.bodies, grips, blade));
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    organs::Blade& blade = state.dissection.blades[i];
    std::map<std::size_t, std::size_t> lengths;
    for (const auto& [first, organ] : state.dissection.organs) lengths[first] = organ.log().size();
    advance_blade(state, sweeps[i], blade, tick, report);
    for (const auto& [first, organ] : state.dissection.organs)
      if (organ.log().size() > lengths[first]) cut_by[first] = blade.holder;
  }
  for (const auto& [first, author] : cut_by)
    if (const Refusal failed =
            carry_through(state, first, marks[first], TopologyCause::cut, author, report)) {
      BodyReport& row = report.bodies.emplace_back();
      row.body = state.bodies.soft[first].solver->desc().name;
      row.note = fmt::format("the cut was undone: {}", failed.why());
    }
  if (log_length(state) > before) report_cuts(tick.figures, report);
}

Refusal undo_last_cut(State& state, ParticipantId participant, StepReport& report) {
  organs::Organ* last = nullptr;
  std::uint64_t stroke = 0;
  for (auto& [first, organ] : state.dissection.organs)
    if (const auto newest = organs::last_stroke(organ.log(), participant); newest && *newest >= stroke) {
      stroke = *newest;
      last = &organ;
    }
  if (last == nullptr) return "you have no cut to undo";
  const organs::Organ::Mark before = last->mark();
  if (Refusal refused = last->undo(participant)) return refused;
  return carry_through(state, last->pieces().front().body, before, TopologyCause::undo, participant, report);
}

void make_organs_ready(State& state) {
  Bodies& bodies = state.bodies;
  for (std::size_t body = 0; body < bodies.soft.size(); ++body) {
    const bool is_cut = std::any_of(
        bodies.model.blades.begin(), bodies.model.blades.end(), [&](const organs::BladeShape& blade) {
          return std::any_of(
              blade.edges.begin(), blade.edges.end(),
              [&](const organs::BladeShape::Edge& edge) { return can_cut(bodies, body, edge.ray); });
        });
    if (!is_cut) continue;
    const soft::SoftBody& soft_body = *bodies.soft[body].solver;
    try {
      state.dissection.uncut.try_emplace(body, body, soft_body.anatomy(), soft_body.desc().material.density,
                                         held_nodes_of(state, body));
    } catch (const InputError&) {  // can't be cut; reported when a blade touches it
    }
  }
}

std::vector<std::uint8_t> held_nodes_of(const State& state, std::size_t body) {
  const auto cut = state.dissection.organs.find(body);
  const Anatomy& whole =
      cut != state.dissection.organs.end() ? cut->second.whole() : state.bodies.soft[body].solver->anatomy();
  if (soft::mesh_kind(whole) != soft::MeshKind::sheet) return {};
  return organs::held_nodes(state.bodies.soft[body].solver->desc().attach, whole);
}

}  // namespace prosector
