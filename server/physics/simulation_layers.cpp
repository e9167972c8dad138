// Phase 3, for thin bodies against each other and for any against itself.

#include <fmt/format.h>

#include <algorithm>

#include "server/physics/simulation_impl.h"
#include "server/physics/soft/rungs.h"

namespace prosector {
namespace {

constexpr double cells_apart = 2.5;        // at rest: nearer parts of one surface are neighbours
constexpr double thicknesses_apart = 1.5;  // likewise
constexpr double hurry = 1.5;              // times the speed at which they near each other: it may grow …
constexpr double turning = 0.2;            // … and other motion turn into it
// m/s, at which what overlaps when the tick starts is parted: so no overlap gives more energy than that.
constexpr double opening_speed = 0.06;

// Times the mass of what meets over h²: what nears by a cell is stopped within a fraction of a millimetre,
// and tangles that press against each other store next to nothing.
constexpr double firmness = 30;

/// 1/kg: what a point's velocity changes by for an impulse on it.
double lightness(const SoftBody& body, const ContactSide& side) {
  double sum = 0;
  for (std::size_t k = 0; k < side.nodes; ++k)
    sum += side.weight[k] * side.weight[k] / body.node_mass()[Eigen::Index{side.node[k]}];
  return sum;
}

Vec3 velocity_of(const SoftBodyState& state, const ContactSide& side) {
  Vec3 v = Vec3::Zero();
  for (std::size_t k = 0; k < side.nodes; ++k)
    v += side.weight[k] * state.motion.v.segment<3>(3 * Eigen::Index{side.node[k]});
  return v;
}

}  // namespace

bool Simulation::Impl::is_thin(std::size_t body) const {
  return model.soft[body]->anatomy().thickness > 0;
}

void Simulation::Impl::fit_layers(std::size_t body) {
  layered[body] = 0;
  layers[body].reset();
  std::erase_if(layer_sides,
                [&](const auto& entry) { return entry.first.first == body || entry.first.second == body; });
  const bool blades_come = std::any_of(blade_shapes.begin(), blade_shapes.end(),
                                       [](const BladeShape& blade) { return !blade.edges.empty(); });
  const auto can_fall_apart = [&](std::size_t i) {
    const CollisionMask& mask = model.soft_collision[i].mask;
    return mesh_kind(model.soft[i]->anatomy()) == MeshKind::sheet && may_touch(mask, mask);
  };
  const auto meets = [&](std::size_t i, std::size_t j) {
    const SoftCollision &a = model.soft_collision[i], &b = model.soft_collision[j];
    if (!is_thin(i) || !is_thin(j) || a.fidelity != Fidelity::mesh || b.fidelity != Fidelity::mesh)
      return false;
    // A sheet that can be cut has them from the beginning, for its pieces: what a checkpoint holds doesn't
    // depend on whether it was.
    return i == j ? a.with_itself || (blades_come && can_fall_apart(i)) : may_touch(a.mask, b.mask);
  };
  if (model.soft_collision[body].with_itself && !is_thin(body) && faces_of(body)) {
    const bool closed = faces_of(body)->topology().closed();
    if (!closed && organs.empty())
      throw InputError(
          fmt::format("[[soft]] \"{}\": self_contact needs a surface without holes, that has an inside",
                      model.soft[body]->desc().name));
    if (!closed)
      folds[body].reset();
    else if (!folds[body])
      folds[body].emplace(model.soft[body]->anatomy(), model.soft_collision[body].cell);
  }
  for (std::size_t other = 0; other < model.soft.size() && !layered[body]; ++other)
    layered[body] = meets(body, other);
}

bool Simulation::Impl::has_layers() const {
  return std::any_of(layered.begin(), layered.end(), [](char l) { return l != 0; });
}

const ElementSurface& Simulation::Impl::layers_of(std::size_t body) {
  if (!layers[body]) layers[body].emplace(model.soft[body]->anatomy());
  if (!layers_moved[body]) layers[body]->move(soft[body].motion.x);
  layers_moved[body] = 1;
  return *layers[body];
}

bool Simulation::Impl::nears(const Contact& contact, double gap) const {
  const SoftBodyState &a = soft[contact.a.body], &b = soft[contact.b.body];
  // What settles has no speed yet comes nearer by whole steps.
  if (gap <= contact_margin || (a.motion.v.isZero(0) && b.motion.v.isZero(0))) return true;
  const Vec3 apart = velocity_of(a, contact.a) - velocity_of(b, contact.b);
  const double nearing = hurry * std::max(0.0, -apart.dot(contact.normal)) + turning * apart.norm();
  return gap <= contact_margin + step_h * nearing;
}

bool Simulation::Impl::add_self_contacts(std::size_t body, double margin, std::vector<Contact>& out) {
  const std::size_t before = out.size();
  meetings.clear();
  folds[body]->find(skin(body), margin, meetings);
  for (const VertexMeeting& meeting : meetings) {
    Contact c = pair_contact(body, body, meeting);
    c.gap = std::max(c.gap, -opening_speed * step_h);
    out.push_back(c);
  }
  return out.size() > before;
}

bool Simulation::Impl::add_layer_contacts(std::size_t a, std::size_t b, double margin,
                                          std::vector<Contact>& out) {
  if (b < a) return add_layer_contacts(b, a, margin, out);
  const ElementSurface &of_a = layers_of(a), &of_b = layers_of(b);
  LayerSearch search;
  search.thickness = skin_of(a) + skin_of(b);
  search.margin = margin;
  const SoftDesc& desc = model.soft[a]->desc();
  const auto both_in = [&](const auto& organ) { return organ.second.has(a) && organ.second.has(b); };
  if (a == b || std::any_of(organs.begin(), organs.end(), both_in)) {
    search.apart_at_rest = std::max(cells_apart * desc.cell, thicknesses_apart * search.thickness);
    search.seam = (thicknesses_apart - 1) * search.thickness;
  }
  std::vector<LayerMeeting> found;
  std::vector<LayerSide>& sides = layer_sides[{a, b}];
  const int passed = find_layers(of_a, of_b, search, sides, found);
  passed_through[a] += passed;
  if (a != b) passed_through[b] += passed;
  if (sides.empty()) layer_sides.erase({a, b});
  const std::size_t before = out.size();
  for (LayerMeeting meeting : found) {
    // Whose corner it is remembers it.
    const bool turned = meeting.kind == LayerMeet::corner_of_b;
    if (turned) swap_sides(meeting);
    const std::size_t first = turned ? b : a, second = turned ? a : b;
    const ElementSurface &own = turned ? of_b : of_a, &other = turned ? of_a : of_b;
    Contact c = pair_contact(first, second, meeting.normal, meeting.gap);
    own.add(meeting.a, meeting.weights_a, c.a);
    other.add(meeting.b, meeting.weights_b, c.b);
    if (!nears(c, meeting.gap)) continue;
    c.gap = std::max(c.gap, -opening_speed * step_h);
    c.point = at(own.now(meeting.a), meeting.weights_a);
    c.stiffness = 0;
    for (std::size_t k = 0; k < 3; ++k)
      c.stiffness += meeting.weights_a[static_cast<Eigen::Index>(k)] *
                     pair_stiffness(first, second, own.corners(meeting.a)[k]);
    const double mass = 1 / (lightness(*model.soft[first], c.a) + lightness(*model.soft[second], c.b));
    c.stiffness = std::min(c.stiffness, firmness * mass / (step_h * step_h));
    c.feature = own.feature(meeting.a, meeting.weights_a);
    c.met = other.feature(meeting.b, meeting.weights_b);
    recall(find_layer(memories[first], c), c);
    out.push_back(c);
  }
  return out.size() > before;
}

/// Sides are remembered of pairs that were near; of what sleeps, as it was.
void Simulation::Impl::forget_layers(const std::vector<BroadPhase::Pair>& near) {
  std::erase_if(layer_sides, [&](const auto& entry) {
    const auto [a, b] = entry.first;
    if (soft[a].asleep || soft[b].asleep || a == b) return false;
    return !std::binary_search(
        near.begin(), near.end(),
        BroadPhase::Pair(static_cast<BroadPhase::Id>(a), static_cast<BroadPhase::Id>(b)));
  });
}

}  // namespace prosector
