// Phase 6, its middle: soft bodies that no force leads back are unfolded, and put out of what they are in.

#include <fmt/format.h>

#include <algorithm>

#include "server/physics/coupled/recovery.h"
#include "server/physics/simulation_impl.h"

namespace prosector {
namespace {

constexpr int tangle_check_ticks = 8;
constexpr double left_inside = 0.1;  // cells: what is no deeper contacts press out by themselves
constexpr int most_moves = 100;
constexpr double squeezing = 3;             // weights
constexpr double entangled_seconds = 0.75;  // for so long bodies are led apart

/// m: along `up`, of the lowest node.
double height_of_lowest(const VecX& x, const Vec3& up) {
  return (up.transpose() * x.reshaped(3, x.size() / 3)).minCoeff();
}

}  // namespace

/// Whether it is being led out of another body; false once that has been given up.
bool Simulation::Impl::is_being_led(std::size_t body) const {
  return std::any_of(entangled.begin(), entangled.end(), [&](const auto& entry) {
    return (entry.first.first == body || entry.first.second == body) &&
           entry.second.seconds < 2 * entangled_seconds;
  });
}

bool Simulation::Impl::in_a_hand(std::size_t body) const {
  return std::any_of(soft_contacts[body].begin(), soft_contacts[body].end(),
                     [&](const Contact& c) { return hand_at(c.b.body) != nullptr; }) ||
         std::any_of(hands.begin(), hands.end(),
                     [&](const Hand& hand) { return hand.hold && hand.hold->body == soft_id(body); });
}

/// Whether rigid things press the body against each other or what it is tied to, harder than its weight and
/// other tissue do: it has no room for its own shape. What tissue presses has room, because tissue gives way.
bool Simulation::Impl::is_squeezed(std::size_t body) const {
  double by_rigid = 0, by_tissue = 0;
  Vec3 unbalanced = Vec3::Zero();  // N: of the rigid things' forces, what tissue and gravity take up
  for (const ContactMemory& m : memories[body]) {
    (m.soft ? by_tissue : by_rigid) += m.force;
    if (!m.soft) unbalanced += m.force * m.normal;
  }
  const double between = model.soft[body]->attached() ? by_rigid : by_rigid - unbalanced.norm();
  const double weight = model.soft[body]->total_mass() * model.scene.gravity.norm();
  return between > std::max(squeezing * weight, by_tissue);
}

/// Whether the body is deep in other tissue, but can't be led out: what of it is inside out tells no way.
bool Simulation::Impl::is_blind(std::size_t body) {
  if (inside_out_of(body).empty() || in_a_hand(body)) return false;
  return std::any_of(soft_pairs.begin(), soft_pairs.end(), [&](const SoftPair& pair) {
    if ((pair.a != body && pair.b != body) || pair.a == pair.b || entangled.contains({pair.a, pair.b}))
      return false;
    const SoftSkin a = skin(pair.a), b = skin(pair.b);
    if (!a.faces || !b.faces || a.skin > 0 || b.skin > 0 || in_a_hand(pair.a + pair.b - body)) return false;
    return is_deep(find_immersion(a, b, {}, {}), find_immersion(b, a, {}, {}), std::min(a.cell, b.cell));
  });
}

/// What the body would strike if it took its own shape: a hand, what squeezes it, or, unless it has its own
/// place, a rigid thing. Other tissue gives way, and is led out of it.
Surroundings Simulation::Impl::surroundings_of(std::size_t body) {
  const std::vector<Contact>& touches = soft_contacts[body];
  const bool borne = std::any_of(touches.begin(), touches.end(),
                                 [](const Contact& c) { return c.b.kind == ContactSide::Kind::rigid; });
  const bool met = std::any_of(soft_pairs.begin(), soft_pairs.end(),
                               [&](const SoftPair& pair) { return pair.a == body || pair.b == body; });
  const bool crushed = in_a_hand(body) || is_squeezed(body);
  return {crushed, is_blind(body), crushed || (borne && !model.soft[body]->attached()),
          met || !touches.empty()};
}

void Simulation::Impl::unfold_tangles() {
  if (time.tick % tangle_check_ticks != 0) return;
  std::vector<std::size_t> unfolded;
  for (Island& island : islands)
    for (SoftMember& s : island.soft) {
      const double lowest = height_of_lowest(s.state->motion.x, -model.scene.gravity.normalized());
      if (!unfold_if_tangled(s, surroundings_of(s.index), equilibrium[s.index], step_h, tangle_check_ticks))
        continue;
      place_unfolded(s.index, lowest);
      tell_reset(s.index, s.note);
      unfolded.push_back(s.index);
    }
  for (const std::size_t body : unfolded) make_room_for(body);
  for (const auto& [bodies, how] : entangled)
    if (how.seconds > entangled_seconds && !in_a_hand(bodies.first) && !in_a_hand(bodies.second))
      disentangle(bodies.first, bodies.second);
}

void Simulation::Impl::tell_reset(std::size_t body, const std::string& why) {
  BodyReport& row = report.bodies.emplace_back();
  row.body = model.soft[body]->desc().name;
  row.reset = true;
  row.note = why;
}

/// Where an unfolded body goes: what has a place of its own, there; else what it lies on is no higher than it
/// was.
void Simulation::Impl::place_unfolded(std::size_t body, double lowest) {
  VecX& x = soft[body].motion.x;
  const Vec3 up = -model.scene.gravity.normalized();
  if (model.soft[body]->attached())
    x = equilibrium[body];
  else
    x += (std::max(0.0, lowest - height_of_lowest(x, up)) * up).replicate(x.size() / 3, 1);
  follow_nodes(body);
}

/// What was unfolded may be in other tissue, and forces that lead it out would crush it again.
void Simulation::Impl::make_room_for(std::size_t body) {
  for (std::size_t other = 0; other < soft.size(); ++other)
    if (other != body && may_meet(body, other) && outer_box(body).overlaps(outer_box(other)))
      part_at_once(body, other);
}

/// Puts one body beside the other, as a whole: a free one, the lighter one of two. False: neither is free.
bool Simulation::Impl::part_at_once(std::size_t a, std::size_t b) {
  const auto ease = [&](std::size_t body) {
    return model.soft[body]->attached() ? 0 : 1 / model.soft[body]->total_mass();
  };
  if (ease(a) == 0 && ease(b) == 0) return false;
  if (ease(a) < ease(b)) std::swap(a, b);
  put_beside(a, b);
  return true;
}

/// Bodies that did not come apart by being led.
void Simulation::Impl::disentangle(std::size_t a, std::size_t b) {
  if (part_at_once(a, b)) {
    tell_reset(a, fmt::format("stayed in {}: one was put beside the other", model.soft[b]->desc().name));
    return;
  }
  for (const std::size_t body : {a, b}) {
    const double moved = (soft[body].motion.x - equilibrium[body]).lpNorm<Eigen::Infinity>();
    if (moved < model.soft[body]->desc().surface_cell) continue;  // so the scene has it
    model.soft[body]->unfold(soft[body]);
    place_unfolded(body, 0);
    tell_reset(body,
               fmt::format("stayed in {}: put where it rests", model.soft[body == a ? b : a]->desc().name));
  }
}

/// Moves a solid out of another along the way in which they part, but never down: something bears it.
void Simulation::Impl::put_beside(std::size_t body, std::size_t other) {
  const double cell = std::min(model.soft[body]->desc().surface_cell, model.soft[other]->desc().surface_cell);
  const Vec3 up = -model.scene.gravity.normalized();
  Vec3 way = Vec3::Zero();
  for (int moves = 0; moves < most_moves; ++moves) {
    const SoftSkin own = skin(body), others = skin(other);
    if (!own.faces || !others.faces || own.skin > 0 || others.skin > 0) return;
    const Immersion in = find_immersion(own, others, inside_out_of(body), inside_out_of(other));
    const Immersion around = find_immersion(others, own, inside_out_of(other), inside_out_of(body));
    const double deepest = std::max(in.deepest, around.deepest);
    if (deepest < left_inside * cell) return;
    if (moves == 0) {
      way = way_apart(in, around, middle_of(body) - middle_of(other));
      way -= std::min(0.0, way.dot(up)) * up;
      way = way.norm() > 0 ? Vec3(way.normalized()) : up;
    }
    soft[body].motion.x += (deepest * way).replicate(model.soft[body]->nodes(), 1);
    soft[body].motion.has_history = false;
    soft[body].asleep = false;
    follow_nodes(body);
  }
}

}  // namespace prosector
