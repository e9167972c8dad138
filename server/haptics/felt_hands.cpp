#include "server/haptics/felt_hands.h"

#include <algorithm>
#include <iterator>
#include <set>

#include "server/haptics/felt_panel.h"
#include "server/physics/mechanics/soft/soft_body.h"

namespace prosector {
namespace {

/// Returns a number that changes with a body's mesh and ties.
std::uint64_t version_of(const Simulation& simulation, BodyId body) {
  return (std::uint64_t{simulation.revision(body)} << 32 | simulation.rehung(body) << 1) +
         (simulation.soft(body).attached() ? 1 : 0);
}

std::shared_ptr<const BodyCopy> copy_of(const soft::SoftBody& body) {
  auto copy = std::make_shared<BodyCopy>();
  copy->desc = body.desc();
  copy->anatomy = body.anatomy();
  copy->ties = body.attached() ? body.attachment_stiffness() : VecX(VecX::Zero(body.nodes()));
  return copy;
}

/// Adds the planes of panels that the hand touches, up to `max_contact_planes` in all.
void add_panels(const Simulation& simulation, const HandState& hand, std::vector<ContactPlane>& planes) {
  HandPose pose;
  pose.pose = hand.pose;
  pose.flexion = hand.flexion;
  for (const Panel& panel : simulation.panels())
    for (const ContactPlane& plane : panel_planes(panel, hand.hand, pose))
      if (planes.size() < max_contact_planes) planes.push_back(plane);
}

/// Returns whether the body has a potential energy, whose tangent gives its stiffness. Bodies with a
/// substepper have none.
bool has_tangent(const soft::SoftBody& body) {
  return body.substepper() == nullptr;
}

}  // namespace

std::vector<FeltPlanes> FeltHands::follow(const Simulation& simulation, std::span<const FeelingHand> hands) {
  std::erase_if(hands_, [&](const auto& known) {
    return std::none_of(hands.begin(), hands.end(),
                        [&](const FeelingHand& h) { return h.hand == known.first; });
  });
  take_answers();
  std::vector<FeltPlanes> out;
  for (const FeelingHand& feeling : hands) {
    FeltPlanes message;
    message.participant = feeling.hand.participant;
    message.hand = feeling.hand.hand;
    message.time = simulation.time();
    for (const HandState& state : simulation.hands()) {
      if (state.participant != feeling.hand.participant || state.hand != feeling.hand.hand) continue;
      message = hands_.try_emplace(feeling.hand, feeling.hand).first->second.follow(simulation, state);
      add_panels(simulation, state, message.planes);
    }
    message.input_sequence = feeling.input_sequence;
    out.push_back(std::move(message));
  }
  ask(simulation);
  return out;
}

/// Requests the slopes of the next touched body in turn, if the worker is idle.
void FeltHands::ask(const Simulation& simulation) {
  if (worker_ && worker_->busy()) return;
  std::set<BodyId> felt;
  for (BodyId body = 0; body < simulation.body_count(); ++body) {
    std::vector<Patch> patches;
    std::vector<std::uint64_t> names;
    if (simulation.kind(body) != BodyKind::soft || !has_tangent(simulation.soft(body))) continue;
    for (const auto& [ref, hand] : hands_) hand.patches_on(body, patches, names);
    if (!patches.empty()) felt.insert(body);
  }
  if (felt.empty()) return;
  const auto next = felt.upper_bound(last_asked_);
  const BodyId body = next == felt.end() ? *felt.begin() : *next;
  ComplianceQuestion question;
  question.body = last_asked_ = body;
  question.version = version_of(simulation, body);
  if (const auto known = copied_.find(body); known == copied_.end() || known->second != question.version)
    question.copy = copy_of(simulation.soft(body));
  question.x = simulation.soft_state(body).motion.x;
  question.strength = simulation.part(body).stiffness;
  // Hands with haptic arms are no supports: each presses with the force that it renders.
  const auto bears = [&](const Support& s) {
    return s.body == body && !(s.hand && hands_.contains(*s.hand));
  };
  for (const auto& [ref, hand] : hands_) {
    std::vector<Patch> own;
    std::vector<std::uint64_t> names;
    hand.patches_on(body, own, names);
    if (own.empty()) continue;
    std::copy_if(hand.supports().begin(), hand.supports().end(), std::back_inserter(question.supports),
                 bears);
    break;  // all hands that touch a body have the same supports
  }
  for (const auto& [ref, hand] : hands_) hand.patches_on(body, question.patches, question.names);
  if (!worker_) worker_ = std::make_unique<ComplianceWorker>();
  const std::uint64_t version = question.version;
  if (worker_->ask(std::move(question))) copied_[body] = version;
}

void FeltHands::take_answers() {
  if (!worker_) return;
  for (const ComplianceAnswer& answer : worker_->take())
    for (auto& [ref, hand] : hands_) hand.take(answer);
}

}  // namespace prosector
