#include "client/app/run/desk_mode.h"

#include <algorithm>

#include "client/app/desk/desk_session.h"
#include "client/app/run/audience_settings.h"
#include "client/view/loading_screen.h"

namespace prosector {

DeskMode::DeskMode(ViewerContext& client, SceneView& scene, const Projection& projection)
    : ScreenMode(client), scene_(scene), projection_(projection), follow_(client.options.view.follow) {
  const ClientOptions& o = client.options;
  window_ = make_window_context(o.display.width, o.display.height, "Prosector: " + o.bus.session);
  desk_ = std::make_unique<Desk>(
      *window_, DeskChoices{.shown = o.view.shown, .full_screen = o.display.monitor.has_value()});
  if (o.display.audience) window_->open_audience(audience_settings(o.display));
}

Outlook DeskMode::look(InputPump* pump, LocalUser& self, const Outlook& usual) {
  Outlook out = usual;
  const DeskSession session = begin_desk_frame(self.participant);
  desk_->view().follow_camera(leading_camera_);
  desk_->update(session);
  rumble_.follow(desk_->has_gamepad(), touch_force(self.participant), monotonic_ns());
  self.at_desk = !is_tracked(client_.options);
  out.projection = projection_;
  if (!is_led_by_head(self)) {
    out.eye = desk_->view().eye();
    out.pointed = desk_->pointed();
  }
  follow_choices(self, out);
  if (pump != nullptr && !is_tracked(client_.options)) drive_hand(*pump, self, session.own_panel.has_value());
  if (pump == nullptr) send_time_commands();
  out.width = window_->width();
  out.height = window_->height();
  return out;
}

bool DeskMode::is_led_by_head(const LocalUser& self) const {
  return is_tracked(client_.options) && self.input.head_tracked;
}

/// Returns the session state for this frame. Begins at the start view in the first frame.
DeskSession DeskMode::begin_desk_frame(ParticipantId self) {
  return client_.connection.with_replica([&](Replica& replica) {
    const double tick = replica.time().advance(monotonic_ns());
    const double aspect = static_cast<double>(window_->width()) / window_->height();
    if (!desk_->has_begun()) desk_->begin(start_view_of(replica, tick, self, aspect));
    DeskSession out = desk_session(replica, scene_, tick, self);
    if (desk_->parts().is_open())
      out.parts =
          part_rows(parts_data(replica), client_.parts, desk_->parts().search(), client_.options.words);
    out.scale = scale();
    return out;
  });
}

/// Returns the magnitude of the contact force on the desk user's hand, N.
double DeskMode::touch_force(ParticipantId self) {
  return client_.connection.with_replica([&](const Replica& replica) {
    const ContactSample* contact = replica.contact(self, right_hand);
    return contact != nullptr && contact->touching ? contact->force.norm() : 0;
  });
}

Role DeskMode::role_of(ParticipantId participant) {
  return client_.connection.with_replica([&](const Replica& replica) {
    const auto entry = replica.roster().find(participant);
    return entry == replica.roster().end() ? Role::observer : entry->second.role;
  });
}

/// Applies what the user chose with mouse and keyboard.
void DeskMode::follow_choices(const LocalUser& self, Outlook& out) {
  const DeskChoices& choices = desk_->display().choices();
  const ClientOptions& options = client_.options;
  show_choices(*desk_, out);
  out.has_pointer = true;
  out.sought_tick = desk_->time().wish();
  out.wireframes = options.view.wireframes != choices.wireframes;
  for (const PartsOrder& order : desk_->parts().take_orders()) client_.parts.obey(order);
  if (choices.full_screen != full_screen_) {
    full_screen_ = choices.full_screen;
    window_->set_full_screen(full_screen_ ? options.display.monitor.value_or(0) : std::optional<int>());
  }
  for (std::size_t n = desk_->display().take_follow_requests(); n > 0; --n) follow_next(self.participant);
  out.follow = follow_;
  if (choices.figures) out.notes = client_.figures.text();
  if (choices.help)
    out.help = help_text(role_of(self.participant), controls(), HelpColumns::tabs, options.words);
}

/// Follows the eyes of the next other user with a tracked head; after the last one returns to the own view.
void DeskMode::follow_next(ParticipantId self) {
  std::vector<std::string> names = {""};
  client_.connection.with_replica([&](Replica& replica) {
    const double tick = replica.time().advance(monotonic_ns());
    for (const auto& [id, entry] : replica.roster()) {
      const auto user = replica.user(id, tick);
      if (id != self && user && user->head_tracked) names.push_back(entry.name);
    }
  });
  if (names.size() == 1 && follow_.empty())
    client_.say(client_.options.words.tr("Tab: there is no other participant whose view could be shown"),
                MessageKind::own);
  const auto now = std::find(names.begin(), names.end(), follow_);
  follow_ = now == names.end() || now + 1 == names.end() ? "" : *(now + 1);
}

/// Sends the hand's target and the commands that the user gave with mouse and keyboard.
void DeskMode::drive_hand(InputPump& pump, LocalUser& self, bool has_panel) {
  self.input = desk_->input();
  pump.set_desk_input(self.input);
  for (const CommandBody& command : desk_->take_commands()) client_.connection.command(command);
  if (const auto ray = desk_->panel_opening().take_request()) request_panel(*ray, has_panel);
}

/// Asks the server to open the panel of the part that the ray meets; without a part, to close the open one.
void DeskMode::request_panel(const Ray& ray, bool has_panel) {
  if (const auto part = scene_.part_at(ray)) {
    desk_->panel_opening().expect();
    return client_.connection.command(OpenPanel{*part});
  }
  if (has_panel) return client_.connection.command(ClosePanel{});
  const auto met = scene_.surface_at(ray);
  const std::string name = client_.connection.with_replica([&](const Replica& replica) {
    const bool known = met && replica.scene() && met->body < replica.scene()->bodies.size();
    return known ? replica.scene()->bodies[met->body].name : std::string();
  });
  const Catalogue& words = client_.options.words;
  client_.say(name.empty() ? std::string(words.tr("P: point at a part of the anatomy to open its panel"))
                           : words.tr("P: the {} has no panel; only parts of the anatomy have one", name),
              MessageKind::own);
}

/// Sends the commands that a user without hands may give.
void DeskMode::send_time_commands() {
  for (const CommandBody& command : desk_->take_commands())
    if (std::holds_alternative<SetPace>(command) || std::holds_alternative<StepTicks>(command) ||
        std::holds_alternative<Seek>(command))
      client_.connection.command(command);
}

std::vector<ControlDevice> DeskMode::controls() const {
  std::vector<ControlDevice> out;
  if (client_.connection.with_replica([](Replica& r) { return r.recording().has_value(); }))
    out.push_back(ControlDevice::recording);
  out.push_back(is_tracked(client_.options) ? ControlDevice::headset : ControlDevice::hand);
  out.push_back(ControlDevice::view);
  if (desk_->has_gamepad()) out.push_back(ControlDevice::gamepad);
  return out;
}

void DeskMode::show_loading(Renderer& renderer, const LoadingState& state) {
  desk_->wait();
  renderer.draw(loading_picture(client_.options.bus.session, state.waits_for, state.progress,
                                window_->width(), window_->height(), scale()));
  window_->present();
}

}  // namespace prosector
