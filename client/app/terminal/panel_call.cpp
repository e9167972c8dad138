#include "client/app/terminal/panel_call.h"

namespace prosector {

std::optional<CommandBody> call_panel(const Replica& replica, ParticipantId user, std::size_t hand,
                                      std::optional<BodyId> pointed_at) {
  if (replica.panels().contains(user)) return ClosePanel{};
  const auto is_part = [&](BodyId body) {
    return replica.scene() && body < replica.scene()->bodies.size() && replica.scene()->bodies[body].part;
  };
  const ContactSample* touch = replica.contact(user, hand);
  const bool touches = touch != nullptr && touch->touching && is_part(touch->body);
  if (!touches && (!pointed_at || !is_part(*pointed_at))) return std::nullopt;
  return OpenPanel{touches ? touch->body : *pointed_at};
}

}  // namespace prosector
