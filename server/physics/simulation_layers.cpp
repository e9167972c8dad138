// Phase 3, for bodies against themselves.

#include <algorithm>

#include "server/physics/simulation_impl.h"

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

void Simulation::Impl::add_layers() {
  for (std::size_t i = 0; i < soft.size(); ++i) {
    layers.emplace_back();
    if (model.soft_collision[i].with_itself) layers.back().emplace(model.soft[i]->anatomy());
  }
  layers_moved.resize(soft.size());
  passed_through.resize(soft.size());
}

bool Simulation::Impl::has_layers() const {
  return std::any_of(layers.begin(), layers.end(), [](const auto& l) { return l.has_value(); });
}

const ElementSurface& Simulation::Impl::layers_of(std::size_t body) {
  if (!layers_moved[body]) layers[body]->move(soft[body].motion.x);
  layers_moved[body] = 1;
  return *layers[body];
}

bool Simulation::Impl::add_layer_contacts(std::size_t a, std::size_t b, double margin,
                                          std::vector<Contact>& out) {
  if (b < a) return add_layer_contacts(b, a, margin, out);
  const ElementSurface &of_a = layers_of(a), &of_b = layers_of(b);
  LayerSearch search;
  search.thickness = skin_of(a) + skin_of(b);
  search.margin = margin;
  const SoftDesc& desc = model.soft[a]->desc();
  search.apart_at_rest = std::max(cells_apart * (is_thin(a) ? desc.cell : desc.surface_cell),
                                  thicknesses_apart * search.thickness);
  std::vector<LayerMeeting> found;
  std::vector<LayerSide>& sides = layer_sides[{a, b}];
  const int passed = find_layers(of_a, of_b, search, sides, found);
  passed_through[a] += passed;
  if (a != b) passed_through[b] += passed;
  if (sides.empty()) layer_sides.erase({a, b});
  const std::size_t before = out.size();
  // What settles has no speed yet comes nearer by whole steps.
  const bool settles = soft[a].motion.v.isZero(0) && soft[b].motion.v.isZero(0);
  for (const LayerMeeting& meeting : found) {
    Contact c = pair_contact(a, b, meeting.normal, meeting.gap);
    of_a.add(meeting.a, meeting.weights_a, c.a);
    of_b.add(meeting.b, meeting.weights_b, c.b);
    const Vec3 apart = velocity_of(soft[a], c.a) - velocity_of(soft[b], c.b);
    const double nearing = hurry * std::max(0.0, -apart.dot(meeting.normal)) + turning * apart.norm();
    if (!settles && meeting.gap > contact_margin + model.h * nearing) continue;
    c.gap = std::max(c.gap, -opening_speed * model.h);
    c.point = at(of_a.now(meeting.a), meeting.weights_a);
    c.stiffness = 0;
    for (std::size_t k = 0; k < 3; ++k)
      c.stiffness +=
          meeting.weights_a[static_cast<Eigen::Index>(k)] * pair_stiffness(a, b, of_a.corners(meeting.a)[k]);
    if (is_thin(a)) {
      const double mass = 1 / (lightness(*model.soft[a], c.a) + lightness(*model.soft[b], c.b));
      c.stiffness = std::min(c.stiffness, firmness * mass / (model.h * model.h));
    }
    if (a == b) c.friction = 0;
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
