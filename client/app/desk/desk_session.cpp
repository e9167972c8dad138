#include "client/app/desk/desk_session.h"

#include <memory>
#include <vector>

#include "client/view/anatomy_points.h"
#include "client/view/held_bodies.h"
#include "client/view/section.h"
#include "client/view/shown_effort.h"

namespace prosector {
namespace {

/// Properties of a body that the desk needs.
struct BodyTraits {
  bool soft = false, blade = false, openable = false;
};

std::vector<BodyTraits> traits_of(const Replica& replica) {
  const auto& bodies = replica.scene()->bodies;
  std::vector<BodyTraits> out(bodies.size());
  for (BodyId id = 0; id < bodies.size(); ++id) {
    const RigidReplica* rigid = replica.bodies().rigid(id);
    out[id] = {replica.bodies().soft(id) != nullptr, rigid != nullptr && !rigid->edges.empty(),
               is_openable(bodies[id].appearance)};
  }
  return out;
}

}  // namespace

DeskStart start_view_of(Replica& replica, double tick, ParticipantId self, double aspect) {
  std::vector<Vec3> heads;
  for (const auto& [id, entry] : replica.roster())
    if (const auto user = replica.user(id, tick); id != self && user && user->head_tracked)
      heads.push_back(user->head.p);
  return desk_start(replica.scene()->camera, anatomy_points(replica), heads, aspect);
}

DeskSession desk_session(const Replica& replica, SceneView& view, double tick, ParticipantId self) {
  DeskSession out;
  const HandRef hand{self, right_hand};
  out.room.surface = [&view, held = held_by(replica, hand)](const Ray& ray) {
    return view.surface_at(ray, held);
  };
  out.room.box = [&view](BodyId body) { return view.box_of(body); };
  const auto asks = [traits = std::make_shared<const std::vector<BodyTraits>>(traits_of(replica))](
                        bool BodyTraits::*trait) {
    return [traits, trait](BodyId body) { return body < traits->size() && (*traits)[body].*trait; };
  };
  out.room.opens = asks(&BodyTraits::openable);
  out.is_soft = asks(&BodyTraits::soft);
  out.is_blade = asks(&BodyTraits::blade);
  const auto own = replica.panels().find(self);
  if (own != replica.panels().end()) {
    out.own_panel = own->second;
    out.effort = shown_effort(replica, own->second.body, self);
    out.hidden_panel_lines = view.hidden_panel_lines();
  }
  const auto user = replica.user(self, tick);
  if (user && user->hands[right_hand].tracked) out.physical_hand = user->hands[right_hand].pose;
  if (const ContactSample* contact = replica.contact(self, right_hand); contact && contact->touching)
    out.touched = contact->body;
  out.tip = instrument_tip(replica, hand, tick);
  out.blade = held_blade(replica, hand, tick);
  out.pace = replica.time().pace();
  out.watched = shown_time(replica, tick);
  return out;
}

void show_choices(const Desk& desk, Outlook& settings) {
  const DeskChoices& choices = desk.display().choices();
  settings.pointer = desk.view().pointer_pixel();
  settings.cut_guide = desk.hand().cut_line();
  settings.cut_depth = desk.hand().cut_depth();
  settings.shown = choices.shown;
  settings.highlighted = desk.parts().hovered_bodies();
  settings.parts_list = desk.parts().shown();
  settings.section = choices.section;
  settings.panel = desk.panel().look();
}

}  // namespace prosector
