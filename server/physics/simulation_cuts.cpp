// Last phase: what blades cut, and what is undone.

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <limits>

#include "common/error.h"
#include "server/physics/cutting/carry.h"
#include "server/physics/simulation_impl.h"
#include "server/physics/soft/rungs.h"

namespace prosector {

/// Where an organ's nodes are, by id.
std::vector<Vec3> Simulation::Impl::node_positions(const Organ& organ) const {
  std::vector<Vec3> out(organ.complex().node_end(), Vec3::Zero());
  for (const OrganPiece& piece : organ.pieces())
    for (std::size_t n = 0; n < piece.mesh.nodes.size(); ++n)
      out[piece.mesh.nodes[n]] = soft[piece.body].motion.x.segment<3>(3 * static_cast<Eigen::Index>(n));
  return out;
}

/// A stroke through a sheet knows its edge in the room only: it goes with the sheet as the edge's points do.
void Simulation::Impl::carry_beside_sheet(BladeStroke& stroke, const Blade& blade, std::size_t edge,
                                          std::span<const Vec3> from) const {
  std::size_t first = 0;
  for (std::size_t e = 0; e < edge; ++e) first += blade_shapes[blade.slot].edges[e].points.size();
  for (std::size_t k = 0; k < from.size(); ++k) stroke.edge[k].room += from[k] - blade.cut_to[first + k];
}

bool Simulation::Impl::can_cut(std::size_t body, bool with_ray) const {
  const MeshKind kind = mesh_kind(model.soft[body]->anatomy());
  return kind != MeshKind::rope && (!with_ray || kind == MeshKind::sheet) &&
         model.soft_collision[body].fidelity != Fidelity::none;
}

/// With the scene, so that no tick waits for it.
void Simulation::Impl::make_organs_ready() {
  for (std::size_t body = 0; body < model.soft.size(); ++body) {
    const bool is_cut = std::any_of(blade_shapes.begin(), blade_shapes.end(), [&](const BladeShape& blade) {
      return std::any_of(blade.edges.begin(), blade.edges.end(),
                         [&](const BladeShape::Edge& edge) { return can_cut(body, edge.ray); });
    });
    if (!is_cut) continue;
    const SoftBody& soft_body = *model.soft[body];
    try {
      uncut_organs.try_emplace(body, body, soft_body.anatomy(), soft_body.desc().density,
                               held_nodes_of(body));
    } catch (const InputError&) {  // can't be cut: said when a blade comes to it
    }
  }
}

/// Throws InputError for a mesh that can't be cut.
Organ& Simulation::Impl::organ_of(std::size_t body) {
  if (const auto cut = organs.find(body); cut != organs.end()) return cut->second;
  if (auto ready = uncut_organs.extract(body)) return organs.insert(std::move(ready)).position->second;
  const SoftBody& soft_body = *model.soft[body];
  return organs.try_emplace(body, body, soft_body.anatomy(), soft_body.desc().density, held_nodes_of(body))
      .first->second;
}

/// Takes an edge of a blade on, through whatever tissue there is.
void Simulation::Impl::cut_tissue(Blade& blade, std::size_t edge, std::span<const Vec3> from,
                                  std::span<const Vec3> to) {
  const Aabb swept = swept_box(from, to);
  const bool ray = blade_shapes[blade.slot].edges[edge].ray;
  for (std::size_t first = 0; first < model.scene.soft.size(); ++first) {
    if (!can_cut(first, ray)) continue;
    const auto cut_before = organs.find(first);
    const auto reaches = [&](std::size_t body) {
      return !parts[soft_id(body)].out_of_touch() && outer_box(body).overlaps(swept);
    };
    bool near = cut_before == organs.end() && reaches(first);
    if (cut_before != organs.end())
      for (const OrganPiece& piece : cut_before->second.pieces())
        near |= piece.whole() && reaches(piece.body);
    if (!near) {
      blade.strokes.erase({first, edge});
      continue;
    }
    try {
      cut_organ(blade, edge, first, from, to);
    } catch (const InputError& error) {  // a mesh that can't be cut: with flat elements, say
      BodyReport& row = report.bodies.emplace_back();
      row.body = model.soft[first]->desc().name;
      row.note = error.what();
    }
  }
}

/// Throws InputError, and changes nothing, where that can't be.
void Simulation::Impl::cut_organ(Blade& blade, std::size_t edge, std::size_t first,
                                 std::span<const Vec3> from, std::span<const Vec3> to) {
  Organ& organ = organ_of(first);
  const auto [stroke, begins] = blade.strokes.try_emplace({first, edge});
  if (begins)
    stroke->second = begin_stroke(from);
  else if (organ.complex().is_sheet())
    carry_beside_sheet(stroke->second, blade, edge, from);
  std::vector<Vec3>& positions = organ_positions[first];
  if (positions.empty()) positions = node_positions(organ);
  const CutResult result = organ.cut(positions, to, stroke->second, blade.holder, blade.stroke);
  for (const TopologyOp& op : result.ops) carry(op, positions);
  cut_figures.split_tets += result.split_tets;
  cut_figures.slivers += result.slivers;
  cut_figures.least_dihedral_deg = std::min(cut_figures.least_dihedral_deg, result.least_dihedral_deg);
}

void Simulation::Impl::obey(const CutEvent& event) {
  std::string& answer = report.cut_answers.emplace_back();
  if (event.kind == CutEvent::Kind::rewind) {
    answer = rewind(event);
    return;
  }
  Organ* last = nullptr;
  std::uint64_t stroke = 0;
  for (auto& [first, organ] : organs)
    if (const auto newest = organ.last_stroke(event.participant); newest && *newest >= stroke) {
      stroke = *newest;
      last = &organ;
    }
  if (last == nullptr) {
    answer = "there is no cut of yours to undo";
    return;
  }
  const Organ::Mark before = last->mark();
  answer = last->undo(event.participant);
  if (answer.empty())
    answer = carry_through(last->pieces().front().body, before, TopologyCause::undo, event.participant);
}

/// What an organ's change made of its pieces takes effect, or everything stays as it was before the change.
/// Empty when done, else why not.
std::string Simulation::Impl::carry_through(std::size_t first, const Organ::Mark& before, TopologyCause cause,
                                            ParticipantId author) {
  Organ& organ = organs.at(first);
  try {
    remake(organ, cause, author);
    return {};
  } catch (const std::exception& error) {
    for (Blade& blade : blades)
      std::erase_if(blade.strokes, [&](const auto& stroke) { return stroke.first.first == first; });
    if (before.changes == 0)
      organs.erase(first);
    else
      organ.back_to(before, model.soft.size());
    return error.what();
  }
}

/// Hands go on holding what is nearest to where they held it.
void Simulation::Impl::keep_holds(const std::vector<std::size_t>& bodies) {
  for (Hand& hand : hands) {
    if (!hand.hold || !is_soft(hand.hold->body)) continue;
    if (!std::binary_search(bodies.begin(), bodies.end(), soft_index(hand.hold->body))) continue;
    const Pose centre = world.motion(hand.slot).pose;
    struct Nearest {
      std::size_t body = 0;
      std::uint32_t vertex = 0;
      double distance = std::numeric_limits<double>::infinity();
    };
    std::vector<Nearest> found;
    for (const Hold::Point& p : hand.hold->points) {
      Nearest& best = found.emplace_back();
      for (const std::size_t body : bodies) {
        const auto x = surfaces[body].positions();
        for (std::uint32_t v = 0; v < x.size(); ++v)
          if (const double d = (x[v] - centre * p.in_hand).squaredNorm(); d < best.distance)
            best = {body, v, d};
      }
    }
    // One hand holds one body: that of most points.
    std::map<std::size_t, std::size_t> points;
    for (const Nearest& n : found) ++points[n.body];
    const auto most = std::max_element(points.begin(), points.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    Hold& hold = *hand.hold;
    hold.body = soft_id(most->first);
    std::vector<Hold::Point> kept;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i].body != most->first) continue;
      kept.push_back(hold.points[i]);
      kept.back().vertex = found[i].vertex;
    }
    hold.points = std::move(kept);
  }
}

void Simulation::Impl::cut_soft_bodies(const TickInput& input) {
  organ_positions.clear();
  cut_figures = {};
  const std::uint64_t before = log_length();
  std::map<std::size_t, Organ::Mark> marks;  // of organs, before they were cut
  for (const auto& [first, organ] : organs) marks[first] = organ.mark();
  std::map<std::size_t, ParticipantId> cut;  // organ → whose cut
  for (Blade& blade : blades) {
    std::map<std::size_t, std::size_t> lengths;
    for (const auto& [first, organ] : organs) lengths[first] = organ.log().size();
    advance(blade);
    for (const auto& [first, organ] : organs)
      if (organ.log().size() > lengths[first]) cut[first] = blade.holder;
  }
  for (const auto& [first, author] : cut)
    if (const std::string failed = carry_through(first, marks[first], TopologyCause::cut, author);
        !failed.empty()) {
      BodyReport& row = report.bodies.emplace_back();
      row.body = model.soft[first]->desc().name;
      row.note = fmt::format("the cut was taken back: {}", failed);
    }
  for (const CutEvent& event : input.cuts) obey(event);
  if (log_length() > before) report_cuts();
}

std::uint64_t Simulation::Impl::log_length() const {
  std::uint64_t sum = 0;
  for (const auto& [first, organ] : organs) sum += organ.log().size();
  return sum;
}

/// What a cut could not keep above the floor.
void Simulation::Impl::report_cuts() {
  if (cut_figures.slivers == 0) return;
  BodyReport& row = report.bodies.emplace_back();
  row.body = "cut";
  row.note = fmt::format("{} of the tetrahedra made have dihedral angles below {} degrees, the least {:.1f}",
                         cut_figures.slivers, least_dihedral_deg, cut_figures.least_dihedral_deg);
}

}  // namespace prosector
