// Phase 3, its second half: which soft bodies touch each other.

#include <algorithm>
#include <numeric>

#include "server/physics/contact/flat_elements.h"
#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

// Bodies that a scene puts into each other, or that met faster than they were solved, part slowly: an overlap
// presses no harder than this, times the softer body's Young's modulus.
constexpr double most_pressure = 4;
// What is too deep in each other is led apart as a whole, gently: tissue gives way little under it.
constexpr double parting_speed = 0.25;    // m/s
constexpr double parting_pressure = 0.5;  // times the softer body's Young's modulus

}  // namespace

bool Simulation::Impl::may_meet(std::size_t a, std::size_t b) const {
  if (parts[soft_id(a)].out_of_touch() || parts[soft_id(b)].out_of_touch()) return false;
  const SoftCollision &first = model.soft_collision[a], &second = model.soft_collision[b];
  if (a == b) return first.with_itself;
  return first.fidelity != Fidelity::none && second.fidelity != Fidelity::none &&
         may_touch(first.mask, second.mask);
}

SoftSkin Simulation::Impl::skin(std::size_t body) {
  const TriangleSurface* own = faces_of(body);
  if (own && !faces_moved[body]) faces[body]->move(surfaces[body].positions());
  faces_moved[body] = 1;
  return {&surfaces[body], own, skin_of(body), model.soft[body]->desc().surface_cell};
}

double Simulation::Impl::reach_of(std::size_t body) const {
  return step_h * soft[body].motion.v.lpNorm<Eigen::Infinity>();
}

/// How far parts of the body may near each other within the tick.
double Simulation::Impl::inner_reach_of(std::size_t body) const {
  const auto v = soft[body].motion.v.reshaped(3, model.soft[body]->nodes());
  const Vec3 mean = v.rowwise().mean();
  return 2 * step_h * (v.colwise() - mean).cwiseAbs().maxCoeff();
}

/// Both surfaces give way, each as its own tissue would: twice two springs in series, so that of two equal
/// bodies each counts as against something rigid.
double Simulation::Impl::pair_stiffness(std::size_t a, std::size_t b, std::uint32_t vertex) const {
  const SoftDesc &of_a = model.soft[a]->desc(), &of_b = model.soft[b]->desc();
  const double own = model.contact_stiffness(a, vertex);
  const double ratio = of_b.youngs_modulus / of_b.surface_cell / (of_a.youngs_modulus / of_a.surface_cell);
  return 2 * own * ratio / (1 + ratio);
}

Contact Simulation::Impl::pair_contact(std::size_t a, std::size_t b, const Vec3& normal, double gap) const {
  const SoftDesc &of_a = model.soft[a]->desc(), &of_b = model.soft[b]->desc();
  Contact c;
  c.a.kind = c.b.kind = ContactSide::Kind::soft;
  c.a.body = a;
  c.b.body = b;
  c.normal = normal;
  const double cell = std::min(of_a.surface_cell, of_b.surface_cell);
  c.gap = std::max(gap, -most_pressure * cell / model.scene.contact_stiffness);
  c.friction = std::sqrt(of_a.friction * of_b.friction);
  return c;
}

Contact Simulation::Impl::pair_contact(std::size_t a, std::size_t b, const VertexMeeting& meeting) const {
  const Anatomy& other = model.soft[b]->anatomy();
  Contact c = pair_contact(a, b, meeting.normal, meeting.gap);
  c.a = surface_side(a, meeting.vertex);
  const auto& corners = other.surface.triangles[meeting.at.triangle];
  for (std::size_t k = 0; k < 3; ++k)
    c.b.add(other.embedding.rows[corners[k]], meeting.at.weights[static_cast<Eigen::Index>(k)]);
  c.feature = meeting.vertex;
  c.point = surfaces[a].positions()[meeting.vertex];
  c.stiffness = pair_stiffness(a, b, meeting.vertex);
  recall(find(memories[a], c.b, c.feature), c);
  return c;
}

bool Simulation::Impl::add_pair_contacts(std::size_t a, std::size_t b, double margin,
                                         std::vector<Contact>& out) {
  if (a == b && !is_thin(a)) return add_self_contacts(a, margin, out);
  if (a != b && !outer_box(a).grown(margin).overlaps(outer_box(b))) return false;
  if (rough[a] || rough[b]) return add_rough_pair_contacts(a, b, margin, out);
  if (layered[a] && layered[b]) return add_layer_contacts(a, b, margin, out);
  const std::size_t before = out.size();
  const SoftSkin first = skin(a), second = skin(b);
  bool deep = entangled.contains({a, b});
  const auto add = [&](std::size_t from, std::size_t to, const SoftSkin& own, const SoftSkin& other) {
    meetings.clear();
    find_meetings(own, other, margin, meetings);
    deep = deep || may_be_immersed(own, other, meetings);
    for (const VertexMeeting& meeting : meetings) out.push_back(pair_contact(from, to, meeting));
  };
  add(a, b, first, second);
  add(b, a, second, first);
  if (deep) part(a, b, before, out);
  return out.size() > before;
}

const std::vector<char>& Simulation::Impl::inside_out_of(std::size_t body) {
  InsideOut& out = inside_out[body];
  if (out.known) return out.vertices;
  out.known = true;
  out.vertices.clear();
  std::vector<char> nodes;
  if (!mark_inverted(model.soft[body]->linear_tets(), soft[body].motion.x, nodes)) return out.vertices;
  for (const SparseMap::Row& row : model.soft[body]->anatomy().embedding.rows) {
    double share = 0;
    for (std::size_t k = 0; k < row.node.size(); ++k) share += nodes[row.node[k]] ? row.weight[k] : 0;
    out.vertices.push_back(share > 0.5);
  }
  return out.vertices;
}

Vec3 Simulation::Impl::middle_of(std::size_t body) const {
  const VecX& mass = model.soft[body]->node_mass();
  return soft[body].motion.x.reshaped(3, mass.size()) * mass / mass.sum();
}

void Simulation::Impl::part(std::size_t a, std::size_t b, std::size_t before, std::vector<Contact>& out) {
  const SoftSkin first = skin(a), second = skin(b);
  const Immersion of_a = find_immersion(first, second, inside_out_of(a), inside_out_of(b));
  const Immersion of_b = find_immersion(second, first, inside_out_of(b), inside_out_of(a));
  const double cell = std::min(first.cell, second.cell), step = parting_speed * step_h;
  const auto known = entangled.find({a, b});
  const std::optional<Entanglement> now =
      lead_apart(of_a, of_b, middle_of(a) - middle_of(b), known != entangled.end() ? &known->second : nullptr,
                 in_a_hand(a) || in_a_hand(b), cell, step_h);
  if (!now) return;
  still_entangled[{a, b}] = *now;
  if (now->whole) out.resize(before);
  std::vector<Contact> led;
  const auto lead = [&](std::size_t from, std::size_t to, const Immersion& inside, const Vec3& along) {
    for (const VertexMeeting& meeting : inside.vertices) {
      if (!now->whole && !came_through(meeting, along, cell)) continue;
      std::erase_if(out, [&](const Contact& c) {
        return c.a.body == from && c.b.body == to && c.feature == meeting.vertex &&
               c.a.kind == ContactSide::Kind::soft && c.b.kind == ContactSide::Kind::soft;
      });
      Contact& c = led.emplace_back(pair_contact(from, to, meeting));
      c.normal = along;
      c.gap = -step;
      c.friction = 0;
      c.feature = Contact::no_feature;
      c.grip.setZero();
      c.gripped = 0;
      c.stiffness *= parting_pressure * cell / model.scene.contact_stiffness / step;
    }
  };
  lead(a, b, of_a, now->way);
  lead(b, a, of_b, -now->way);
  out.insert(out.end(), led.begin(), led.end());
  parted[a] = b;
  parted[b] = a;
}

Aabb Simulation::Impl::box_of(std::size_t body) const {
  const double reach = soft[body].asleep ? 0 : std::min(most_reach, reach_of(body));
  return outer_box(body).grown(wake_margin + reach);
}

void Simulation::Impl::track_soft_bodies() {
  for (std::size_t i = 0; i < soft.size(); ++i) {
    if (model.soft_collision[i].fidelity == Fidelity::none) continue;
    const auto id = static_cast<BroadPhase::Id>(i);
    if (!soft_boxes.has(id)) {
      soft_boxes.add(id, box_of(i), model.soft_collision[i].mask, !soft[i].asleep);
      continue;
    }
    soft_boxes.set_moves(id, !soft[i].asleep);
    soft_boxes.update(id, box_of(i));
  }
}

bool Simulation::Impl::woken_by_soft(std::size_t body) {
  if (model.soft_collision[body].fidelity == Fidelity::none) return false;
  std::vector<Contact> found;
  for (const std::size_t other : soft_boxes.query(box_of(body)))
    if (!soft[other].asleep && may_meet(body, other) &&
        add_pair_contacts(body, other, wake_margin + std::min(most_reach, reach_of(other)), found))
      return true;
  return false;
}

void Simulation::Impl::detect_soft_pairs() {
  std::size_t used = 0;
  for (std::size_t i = 0; i < soft.size(); ++i)  // what woke meanwhile
    if (const auto id = static_cast<BroadPhase::Id>(i); soft_boxes.has(id))
      soft_boxes.set_moves(id, !soft[i].asleep);
  std::fill(parted.begin(), parted.end(), std::nullopt);
  still_entangled.clear();
  std::fill(passed_through.begin(), passed_through.end(), 0);  // of what was just looked at to wake it, too
  std::vector<BroadPhase::Pair> near = soft_boxes.find_pairs();
  for (BroadPhase::Id i = 0; i < soft.size(); ++i)
    if (model.soft_collision[i].with_itself) near.emplace_back(i, i);
  std::sort(near.begin(), near.end());
  for (const auto& [a, b] : near) {
    if (soft[a].asleep || soft[b].asleep || !may_meet(a, b)) continue;
    if (used == soft_pairs.size()) soft_pairs.emplace_back();
    SoftPair& pair = soft_pairs[used];
    pair.a = a;
    pair.b = b;
    pair.contacts.clear();
    // Of a solid that hits something the one part stops and the other goes on.
    const double nearing = a == b && is_thin(a) ? inner_reach_of(a) : reach_of(a) + reach_of(b);
    const double reach = std::min(most_reach, nearing);
    if (add_pair_contacts(a, b, contact_margin + reach, pair.contacts)) ++used;
  }
  soft_pairs.resize(used);
  std::swap(entangled, still_entangled);
  forget_layers(near);
  group_soft_bodies();
}

/// Each body's group is the first of those that pairs join it with.
void Simulation::Impl::group_soft_bodies() {
  soft_group.resize(soft.size());
  std::iota(soft_group.begin(), soft_group.end(), std::size_t{0});
  const auto first = [&](std::size_t body) {
    while (soft_group[body] != body) body = soft_group[body] = soft_group[soft_group[body]];
    return body;
  };
  for (const SoftPair& pair : soft_pairs) {
    const std::size_t a = first(pair.a), b = first(pair.b);
    soft_group[std::max(a, b)] = std::min(a, b);
  }
  for (std::size_t i = 0; i < soft.size(); ++i) soft_group[i] = first(i);
}

}  // namespace prosector
