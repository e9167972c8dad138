#include "client/app/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

#include "client/app/desk_session.h"
#include "client/app/picture_file.h"
#include "client/view/camera.h"
#include "client/view/loading_picture.h"
#include "client/view/session_overlay.h"
#include "client/view/words_ahead.h"
#include "common/error.h"

namespace prosector {

Viewer::Viewer(const ClientOptions& options, Connection& connection, ClientReport& report,
               HeadsetUser& headset_user, const std::shared_ptr<SharedCamera>& camera,
               std::function<void(const std::string&)> tell)
    : options_(options),
      connection_(connection),
      report_(report),
      tell_(std::move(tell)),
      sink_(options),
      stage_(make_stage(options, headset_user, camera)),
      follow_(options.follow),
      figures_(options.words),
      messages_(options.words) {
  if (options.frame_time) governor_.emplace(*options.frame_time);
  if (!options.picture_log.empty()) log_.emplace(options.picture_log);
  if (stage_) report_.renderer = stage_->context->description();
}

void Viewer::take_picture(const std::filesystem::path& file) {
  stage_ ? sink_.ask(file) : inform(options_.words.tr("picture: nothing is drawn with --display none"));
}

std::optional<BodyId> Viewer::part_at(const Ray& ray) {
  return stage_ ? stage_->view.part_at(ray) : std::nullopt;
}

// Offscreen, a picture that nobody keeps is not drawn; the first one proves that drawing works.
void Viewer::draw_if_seen(InputPump* pump) {
  if (!stage_) return;
  follow_eyes();
  if (has_headset()) return draw_in_headset(pump);
  if (stage_->sight) return draw_through_camera(pump);
  const double seconds = seconds_since(report_.joined_ns);
  const bool kept = sink_.wants(seconds);
  if (!kept && !stage_->desk && report_.first_picture_ns) return;
  const Image image = draw(pump, kept);
  if (kept) sink_.take(image, seconds);
}

/// Waits for the camera's next picture, and draws the scene over it as it was seen when that was taken.
void Viewer::draw_through_camera(InputPump* pump) {
  constexpr std::chrono::milliseconds patience(100);
  const auto picture = stage_->sight->next(patience);
  waited_for_camera_ = true;
  if (comes_too_soon()) return;
  look_through_camera(picture.get());
  const double seconds = seconds_since(report_.joined_ns);
  const bool kept = sink_.wants(seconds);
  if (!kept && !stage_->desk && report_.first_picture_ns) return;
  if (pump != nullptr && picture && has_devices(options_.devices)) wait_for_hands(*pump, picture->time_ns);
  const Image image = draw(pump, kept);
  if (log_ && picture) {
    times_.drawn_ns = monotonic_ns();
    times_.camera_ns = picture->time_ns;
    log_->add(times_);
  }
  if (kept) sink_.take(image, seconds);
}

/// Tells whether a camera's picture is to be left out, as more come than are to be drawn; the next one is
/// due then. What comes up to half an interval early is drawn: cameras and clocks differ.
bool Viewer::comes_too_soon() {
  const auto interval_ns = static_cast<std::int64_t>(1e9 / options_.frames_per_second);
  const std::int64_t now_ns = monotonic_ns();
  if (now_ns + interval_ns / 2 < due_ns_) return true;
  due_ns_ = std::max(due_ns_, now_ns - interval_ns / 2) + interval_ns;
  return false;
}

void Viewer::look_through_camera(const SightPicture* picture) {
  SeeThrough now;
  now.room_board = stage_->sight->room_board();
  now.words = stage_->sight->trouble(options_.words);
  now.phantoms = options_.phantoms;
  now.found = stage_->phantom;
  now.camera.width = stage_->context->width();
  now.camera.height = stage_->context->height();
  if (picture != nullptr) {
    const CameraView view = view_of(picture->bent, picture->straight, now.camera.width, now.camera.height);
    now.camera = view.camera;
    now.backdrop = {picture->image, picture->number, view.left, view.top, view.step};
    now.is_placed = picture->room_eye.has_value();
    now.camera.pose = picture->room_eye.value_or(Pose{});
    now.paper = picture->paper;
    now.room_tablet = picture->room_tablet;
    if (now.found && picture->room_phantom) now.found->place = picture->room_phantom;
  }
  if (now.words != (through_ ? through_->words : ""))
    inform(now.words.empty() ? options_.words.tr("the camera sees the table") : now.words);
  through_ = std::move(now);
}

/// Waits until the hands are known as they were at that time. It isn't long that they take on their way from
/// who has looked for them in the picture; where there are none, or others track them, they don't come.
void Viewer::wait_for_hands(const InputPump& pump, std::int64_t time_ns) const {
  constexpr std::chrono::milliseconds nap(2);
  constexpr int most_naps = 150, naps_on_way = 10;
  for (int naps = 0; naps < most_naps && !stage_->sight->all_saw(time_ns); ++naps)
    std::this_thread::sleep_for(nap);
  for (int naps = 0; naps < naps_on_way && pump.latest().time_ns < time_ns; ++naps)
    std::this_thread::sleep_for(nap);
}

/// Goes on to the headset's next frame, and hands on what it says. Returns whether a picture is wanted.
bool Viewer::begin_headset_frame() {
  auto frame = stage_->headset->next_frame();
  for (const HeadsetNews& news : stage_->headset->take_news())
    news.for_wearer ? inform(options_.words.tr(news.line)) : tell_(news.line);
  if (!frame) {
    if (stage_->mirror != nullptr) stage_->mirror->wait();
    return false;
  }
  seen_ = std::move(frame);
  return true;
}

void Viewer::show_in_headset() {
  const auto copy = [this](unsigned texture) { stage_->renderer->copy_to(texture); };
  stage_->headset->show(copy);
  if (stage_->mirror != nullptr) stage_->mirror->show(2 * seen_->width, seen_->height, copy);
}

void Viewer::draw_in_headset(InputPump* pump) {
  if (!begin_headset_frame()) return;
  const double seconds = seconds_since(report_.joined_ns);
  const bool kept = sink_.wants(seconds);
  const Image image = draw(pump, kept);
  show_in_headset();
  if (kept) sink_.take(image, seconds);
}

void Viewer::draw_loading_in_headset(const std::string& waits_for, double progress) {
  if (!begin_headset_frame()) return;
  DrawList list;
  list.scale = scale();
  const auto eyes = seen_->cameras();
  list.cameras.assign(eyes.begin(), eyes.end());
  add_words_ahead(list, fmt::format("{}: {:.0f} %\n{}", options_.bus.session, 100 * progress, waits_for));
  stage_->renderer->draw(list, 2 * seen_->width, seen_->height);
  show_in_headset();
}

/// Draws for the eyes that a headset has, and one's own hands where they are when that is seen.
void Viewer::look_through_headset(LocalUser& self, ViewSettings& settings) const {
  settings.eyes = seen_->cameras();
  settings.width = 2 * seen_->width;
  settings.height = seen_->height;
  for (std::size_t hand : {left_hand, right_hand})
    if (const auto& then = seen_->user.hands[hand]; then && self.input.hands[hand].tracked) {
      self.input.hands[hand].pose = then->wrist;
      self.input.hands[hand].flexion = then->flexion;
    }
}

void Viewer::draw_loading(const std::string& waits_for, double progress) {
  waited_for_camera_ = false;
  if (has_headset()) return draw_loading_in_headset(waits_for, progress);
  if (!has_desk()) return;
  stage_->desk->wait();
  stage_->renderer->draw(loading_picture(options_.bus.session, waits_for, progress, stage_->context->width(),
                                         stage_->context->height(), scale()));
  stage_->context->present();
}

void Viewer::finish(InputPump* pump) {
  if (has_headset()) report_.pacing = stage_->headset->pacing();
  if (stage_ && report_.complete_ns && sink_.wants_last()) sink_.finish(draw(pump, true));
  sink_.finish_sheet();
  tell_failures();
}

void Viewer::reload_changed_shaders() {
  if (!options_.watch_shaders || !stage_) return;
  if (const auto news = stage_->renderer->reload_changed_shaders()) inform(*news);
}

void Viewer::tell_failures() {
  for (const std::string& failure : sink_.take_failures()) inform(failure);
}

std::vector<ControlDevice> Viewer::devices() const {
  std::vector<ControlDevice> out;
  if (has_desk() && connection_.with_replica([](Replica& r) { return r.recording().has_value(); }))
    out.push_back(ControlDevice::recording);
  out.push_back(is_tracked(options_) ? ControlDevice::headset : ControlDevice::hand);
  if (has_desk()) out.push_back(ControlDevice::view);
  if (has_desk() && stage_->desk->has_gamepad()) out.push_back(ControlDevice::gamepad);
  return out;
}

std::string Viewer::help(Role role, HelpColumns columns) const {
  return help_text(role, devices(), columns, options_.words);
}

std::vector<std::string> Viewer::greeting(Role role) const {
  return has_desk() ? first_words(role, devices(), options_.words) : std::vector<std::string>();
}

std::string Viewer::pointed() const {
  const auto body = has_desk() ? stage_->desk->pointed() : std::nullopt;
  return !body ? "nothing" : connection_.with_replica([&](const Replica& replica) {
    return named_with_holders(replica, *body);
  });
}

/// Returns how many pixels a point has.
double Viewer::scale() const {
  if (options_.scale) return *options_.scale;
  if (seen_) return headset_scale(seen_->cameras()[0]);
  return stage_->window != nullptr ? stage_->window->content_scale() : 1;
}

Role Viewer::role_of(ParticipantId participant) {
  return connection_.with_replica([&](const Replica& replica) {
    const auto entry = replica.roster().find(participant);
    return entry == replica.roster().end() ? Role::observer : entry->second.role;
  });
}

/// Returns the force on the desk user's hand, N.
double Viewer::touch_force(ParticipantId self) {
  return connection_.with_replica([&](const Replica& replica) {
    const ContactSample* contact = replica.contact(self, right_hand);
    return contact != nullptr && contact->touching ? contact->force.norm() : 0;
  });
}

/// Takes where the user's eyes are before the screen, if that is a window: also where no picture is drawn.
void Viewer::follow_eyes() {
  if (!stage_->eyes) return;
  if (const std::string news = stage_->eyes->take_news(); !news.empty()) inform(options_.words.tr(news));
  const double fov = connection_.with_replica([](const Replica& r) { return r.scene()->camera.fov; });
  look_ = stage_->eyes->look(monotonic_ns(), fov);
}

/// Returns what is seen through the screen where no desk turns the view.
DrawCamera Viewer::window_without_desk() const {
  const CameraInfo camera = connection_.with_replica([](const Replica& r) { return r.scene()->camera; });
  const LookFrom from = looks_from_.value_or(LookFrom{camera.eye, camera.target});
  const DrawCamera rest = mono_camera(look_at(from.eye, from.target), camera.fov, stage_->context->width(),
                                      stage_->context->height());
  return look_through(rest, (from.target - from.eye).norm(), *look_);
}

void Viewer::use_desk(InputPump* pump, LocalUser& self, ViewSettings& settings) {
  Desk& desk = *stage_->desk;
  desk.see_by(look_);
  const DeskSession session = connection_.with_replica([&](Replica& replica) {
    const double tick = replica.advance(monotonic_ns());
    const double aspect = static_cast<double>(stage_->context->width()) / stage_->context->height();
    if (!desk.has_begun()) desk.begin(seat_of(replica, tick, self.participant, aspect));
    DeskSession out = desk_session(replica, stage_->view, tick, self.participant);
    if (desk.parts().is_open())
      out.parts = part_rows(parts_known(replica), parts_, desk.parts().search(), options_.words);
    out.scale = scale();
    return out;
  });
  // Who looks through a camera points where that sees, and is where it stands.
  desk.look_as(through_ && through_->is_placed ? std::optional(through_->camera) : std::nullopt);
  desk.update(session);
  rumble_.follow(desk.has_gamepad(), touch_force(self.participant), monotonic_ns());
  self.at_desk = !is_tracked(options_);
  const DeskChoices& choices = desk.choices();
  const bool head_leads = through_ || (is_tracked(options_) && self.input.head_tracked);
  if (!head_leads) settings.eye = desk.eye();
  if (!head_leads || through_) settings.pointed = desk.pointed();
  if (!head_leads && look_) settings.window = desk.camera();
  show_choices(desk, settings);
  settings.wireframes = options_.wireframes != choices.wireframes;
  for (const PartsOrder& order : desk.parts().take_orders()) obey(order);
  if (choices.full_screen != full_screen_) {
    full_screen_ = choices.full_screen;
    stage_->window->set_full_screen(full_screen_ ? options_.monitor.value_or(0) : std::optional<int>());
  }
  for (std::size_t n = desk.take_follow_requests(); n > 0; --n) follow_next(self.participant);
  settings.follow = follow_;
  if (choices.figures) settings.notes = figures_.text();
  if (choices.help) settings.help = help(role_of(self.participant), HelpColumns::tabs);
  if (pump != nullptr && !is_tracked(options_))
    drive_hand_at_desk(*pump, self, session.own_panel.has_value());
  if (pump == nullptr) ask_for_time();
}

/// Sends what somebody without hands may ask for.
void Viewer::ask_for_time() {
  for (const Command& command : stage_->desk->take_commands())
    if (command.kind == CommandKind::set_pace || command.kind == CommandKind::step_ticks ||
        command.kind == CommandKind::seek)
      connection_.command(command);
}

/// Lets a tracked user's fingertips scroll what their panel says.
void Viewer::read_panel(const Replica& replica, const LocalUser& self, ViewSettings& settings) {
  const auto own = replica.panels().find(self.participant);
  const auto panel = own == replica.panels().end() ? std::nullopt : std::optional(own->second);
  panel_finger_.follow(panel, stage_->view.hidden_panel_lines(), self.input);
  settings.panel = {.place = {}, .first_line = panel_finger_.line()};
}

void Viewer::call_parts(const HandInput& user, std::size_t hand) {
  const Pose eyes = user.head_tracked        ? user.head
                    : stage_ && stage_->desk ? stage_->desk->eye()
                    : looks_from_            ? look_at(looks_from_->eye, looks_from_->target)
                                  : Pose{user.hands[hand].pose.p + Vec3(0, 0.3, 0.3), Quat::Identity()};
  parts_board_.open_or_shut(eyes, hand);
}

/// Lets a tracked user's fingertips work the list of parts on its board.
void Viewer::work_parts_board(const Replica& replica, const LocalUser& self, ViewSettings& settings) {
  if (!parts_board_.is_open()) return;
  parts_board_.follow(part_rows(parts_known(replica), parts_, {}, options_.words), self.input);
  for (const PartsOrder& order : parts_board_.take_orders()) obey(order);
  settings.parts = parts_;
  const std::vector<BodyId> hovered = parts_board_.hovered_bodies();
  settings.highlighted.insert(settings.highlighted.end(), hovered.begin(), hovered.end());
  settings.parts_board = parts_board_.shown();
}

/// Shows the time of a recording that is watched.
void Viewer::watch_time(const Replica& replica, double tick, ViewSettings& settings) const {
  const std::optional<ShownTime> shown = shown_time(replica, tick);
  if (!shown) return;
  WatchedTime& time = settings.time.emplace();
  time.recording = *replica.recording();
  time.tick = shown->tick;
  time.tick_rate = shown->tick_rate;
  time.pace = shown->pace;
  time.pointer = {-1, -1};
  if (!stage_->desk) return;
  time.wish = stage_->desk->wished_tick();
  time.pointer = settings.pointer / settings.scale;
}

void Viewer::drive_hand_at_desk(InputPump& pump, LocalUser& self, bool has_panel) {
  Desk& desk = *stage_->desk;
  self.input = desk.input();
  pump.set_desk_input(self.input);
  for (const Command& command : desk.take_commands()) connection_.command(command);
  const auto request = desk.take_panel_request();
  if (!request) return;
  Command command;
  const auto part = stage_->view.part_at(*request);
  command.kind = part ? CommandKind::open_panel : CommandKind::close_panel;
  command.body = part.value_or(0);
  if (part) desk.expect_panel();
  if (part || has_panel) return connection_.command(command);
  const auto met = stage_->view.surface_at(*request);
  const std::string name = connection_.with_replica([&](const Replica& replica) {
    const bool known = met && replica.scene() && met->body < replica.scene()->bodies.size();
    return known ? replica.scene()->bodies[met->body].name : std::string();
  });
  const Catalogue& words = options_.words;
  say(name.empty() ? std::string(words.tr("P: point at a part of the anatomy to open its panel"))
                   : words.tr("P: the {} has no panel; only parts of the anatomy have one", name),
      MessageKind::own);
}

/// Goes on to the next other user who has eyes, and after the last one back to one's own.
void Viewer::follow_next(ParticipantId self) {
  std::vector<std::string> names = {""};
  connection_.with_replica([&](Replica& replica) {
    const double tick = replica.advance(monotonic_ns());
    for (const auto& [id, entry] : replica.roster()) {
      const auto user = replica.user(id, tick);
      if (id != self && user && user->head_tracked) names.push_back(entry.name);
    }
  });
  if (names.size() == 1 && follow_.empty())
    say(options_.words.tr("Tab: nobody else is here to see through the eyes of"), MessageKind::own);
  const auto now = std::find(names.begin(), names.end(), follow_);
  follow_ = now == names.end() || now + 1 == names.end() ? "" : *(now + 1);
}

/// Draws the next picture. `keep` also reads it back, which costs.
Image Viewer::draw(InputPump* pump, bool keep) {
  const std::int64_t begin = monotonic_ns();
  LocalUser self{.participant = connection_.participant(), .input = {}, .present = pump != nullptr};
  ViewSettings settings;
  settings.words = options_.words;
  settings.overlay = options_.overlay;
  settings.wireframes = options_.wireframes;
  settings.shown = options_.shown;
  settings.insets = options_.insets;
  settings.detail = governor_ ? governor_->level().detail : options_.quality.detail;
  settings.follow = follow_;
  if (looks_from_) settings.eye = look_at(looks_from_->eye, looks_from_->target);
  settings.messages = messages_.shown(seconds_since(report_.joined_ns));
  if (options_.display == Display::stereo) settings.stereo = options_.stereo;
  settings.through = through_;
  if (pump != nullptr) self.input = pump->latest();
  if (stage_->desk) use_desk(pump, self, settings);
  if (look_ && !stage_->desk && !(self.present && self.input.head_tracked))
    settings.window = window_without_desk();
  settings.width = stage_->context->width();
  settings.height = stage_->context->height();
  if (seen_) look_through_headset(self, settings);
  settings.scale = scale();
  settings.parts = parts_;
  const DrawList& list = build_list(self, settings);
  if (seen_)
    stage_->renderer->draw(list, settings.width, settings.height);
  else
    stage_->renderer->draw(list);
  Image image;
  if (keep) image = stage_->renderer->read_pixels();
  stage_->context->present();
  note_picture(seconds_since(begin));
  if (const int times = stage_->desk ? stage_->desk->take_picture_request() : 0; times > 0)
    keep_picture(times, self, settings);
  return image;
}

const DrawList& Viewer::build_list(const LocalUser& self, ViewSettings& settings) {
  return connection_.with_replica([&](Replica& replica) -> const DrawList& {
    const double tick = replica.advance(monotonic_ns());
    times_.tick = replica.shown_tick(tick);
    times_.hand_ns = self.present ? self.input.time_ns : 0;
    watch_time(replica, tick, settings);
    if (is_tracked(options_)) read_panel(replica, self, settings);
    if (is_tracked(options_)) work_parts_board(replica, self, settings);
    // One's own tablet is where the picture, or what tracks it, has it: the server's comes later.
    if (const HeldPose& tablet = self.input.held[static_cast<std::size_t>(HeldThing::tablet)]; tablet.tracked)
      settings.panel.place = tablet.pose;
    if (settings.through && settings.through->room_tablet)
      settings.panel.place = settings.through->room_tablet;
    return stage_->view.build(replica, tick, self, settings);
  });
}

/// Keeps what is shown as a file of its own, so many times as large.
void Viewer::keep_picture(int times, const LocalUser& self, ViewSettings settings) {
  const auto tick = connection_.with_replica(
      [](Replica& r) { return static_cast<std::uint64_t>(r.shown_tick(r.advance(monotonic_ns()))); });
  const auto variable = [](const char* name) {
    const char* value = std::getenv(name);
    return std::string(value != nullptr ? value : "");
  };
  settings.width *= times;
  settings.height *= times;
  settings.scale *= times;
  settings.pointer *= times;
  try {
    const std::filesystem::path file =
        free_picture_file(pictures_folder(variable), std::chrono::system_clock::now(), tick);
    write_png(stage_->renderer->picture_of(build_list(self, settings), settings.width, settings.height),
              file);
    inform(options_.words.tr("picture: {}", file.string()));
  } catch (const InputError& error) {
    inform(error.what());
  }
}

void Viewer::note_picture(double seconds) {
  if (!report_.first_picture_ns) report_.first_picture_ns = monotonic_ns();
  ++report_.pictures;
  report_.drawing_seconds += seconds;
  if (report_.pictures > 1)
    report_.longest_drawing_seconds = std::max(report_.longest_drawing_seconds, seconds);
  if (governor_ && governor_->took(seconds)) {
    stage_->renderer->set_settings(governor_->level().settings);
    inform(options_.words.tr("quality: {}", options_.words.tr(std::string(governor_->level().name))));
  }
  connection_.with_replica([&](const Replica& replica) {
    figures_.take(monotonic_ns(), seconds, connection_.counters(),
                  replica.status() ? &*replica.status() : nullptr);
  });
}

}  // namespace prosector
