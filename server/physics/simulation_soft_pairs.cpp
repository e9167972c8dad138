// Phase 3, its second half: which soft bodies touch each other.

#include <algorithm>
#include <numeric>

#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

// Bodies that a scene puts into each other, or that met faster than they were solved, part slowly: an overlap
// presses no harder than this, times the softer body's Young's modulus.
constexpr double most_pressure = 4;

}  // namespace

bool Simulation::Impl::may_meet(std::size_t a, std::size_t b) const {
  if (parts[soft_id(a)].out_of_touch() || parts[soft_id(b)].out_of_touch()) return false;
  const SoftCollision &first = model.soft_collision[a], &second = model.soft_collision[b];
  return first.fidelity != Fidelity::none && second.fidelity != Fidelity::none &&
         may_touch(first.mask, second.mask);
}

SoftSkin Simulation::Impl::skin(std::size_t body) {
  std::optional<TriangleSurface>& own = faces[body];
  if (own && !faces_moved[body]) own->move(surfaces[body].positions());
  faces_moved[body] = 1;
  return {&surfaces[body], own ? &*own : nullptr, skin_of(body), model.soft[body]->desc().surface_cell};
}

double Simulation::Impl::reach_of(std::size_t body) const {
  return model.h * soft[body].motion.v.lpNorm<Eigen::Infinity>();
}

/// How far parts of the body may near each other within the tick.
double Simulation::Impl::inner_reach_of(std::size_t body) const {
  const auto v = soft[body].motion.v.reshaped(3, model.soft[body]->nodes());
  const Vec3 mean = v.rowwise().mean();
  return 2 * model.h * (v.colwise() - mean).cwiseAbs().maxCoeff();
}

Contact Simulation::Impl::pair_contact(std::size_t a, std::size_t b, const VertexMeeting& meeting) const {
  const Anatomy& other = model.soft[b]->anatomy();
  const SoftDesc &of_a = model.soft[a]->desc(), &of_b = model.soft[b]->desc();
  Contact c;
  c.a = surface_side(a, meeting.vertex);
  c.b.kind = ContactSide::Kind::soft;
  c.b.body = b;
  const auto& corners = other.surface.triangles[meeting.at.triangle];
  for (std::size_t k = 0; k < 3; ++k)
    c.b.add(other.embedding.rows[corners[k]], meeting.at.weights[static_cast<Eigen::Index>(k)]);
  c.point = surfaces[a].positions()[meeting.vertex];
  c.normal = meeting.normal;
  const double cell = std::min(of_a.surface_cell, of_b.surface_cell);
  c.gap = std::max(meeting.gap, -most_pressure * cell / model.scene.contact_stiffness);
  // Both surfaces give way, each as its own tissue would: twice two springs in series, so that of two equal
  // bodies each counts as against something rigid.
  const double own = model.contact_stiffness(a, meeting.vertex);
  const double ratio = of_b.youngs_modulus / of_b.surface_cell / (of_a.youngs_modulus / of_a.surface_cell);
  c.stiffness = 2 * own * ratio / (1 + ratio);
  c.friction = std::sqrt(of_a.friction * of_b.friction);
  return c;
}

bool Simulation::Impl::add_pair_contacts(std::size_t a, std::size_t b, double margin,
                                         std::vector<Contact>& out) {
  const Vec3 grow = Vec3::Constant(margin + skin_of(a) + skin_of(b));
  if (!boxes_overlap(surfaces[a].lo() - grow, surfaces[a].hi() + grow, surfaces[b].lo(), surfaces[b].hi()))
    return false;
  const std::size_t before = out.size();
  const SoftSkin first = skin(a), second = skin(b);
  const auto add = [&](std::size_t from, std::size_t to) {
    for (const VertexMeeting& meeting : meetings) out.push_back(pair_contact(from, to, meeting));
    meetings.clear();
  };
  find_meetings(first, second, margin, meetings);
  add(a, b);
  find_meetings(second, first, margin, meetings);
  add(b, a);
  return out.size() > before;
}

bool Simulation::Impl::woken_by_soft(std::size_t body) {
  std::vector<Contact> found;
  for (std::size_t other = 0; other < soft.size(); ++other)
    if (!soft[other].asleep && may_meet(body, other) &&
        add_pair_contacts(body, other, wake_margin + std::min(most_reach, reach_of(other)), found))
      return true;
  return false;
}

void Simulation::Impl::detect_soft_pairs() {
  std::size_t used = 0;
  const auto meet = [&](std::size_t a, std::size_t b, double reach) {
    if (used == soft_pairs.size()) soft_pairs.emplace_back();
    SoftPair& pair = soft_pairs[used];
    pair.a = a;
    pair.b = b;
    pair.contacts.clear();
    if (!add_pair_contacts(a, b, contact_margin + std::min(most_reach, reach), pair.contacts)) return;
    ++used;
  };
  for (std::size_t i = 0; i < soft.size(); ++i) {
    if (soft[i].asleep) continue;
    for (std::size_t j = i + 1; j < soft.size(); ++j)
      if (!soft[j].asleep && may_meet(i, j)) meet(i, j, reach_of(i) + reach_of(j));
  }
  soft_pairs.resize(used);
  soft_group.resize(soft.size());
  std::iota(soft_group.begin(), soft_group.end(), std::size_t{0});
  for (const SoftPair& pair : soft_pairs) {
    const std::size_t from = soft_group[pair.a], to = soft_group[pair.b];
    if (from == to) continue;
    for (std::size_t& group : soft_group)
      if (group == from || group == to) group = std::min(from, to);
  }
}

}  // namespace prosector
