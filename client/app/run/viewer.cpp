#include "client/app/run/viewer.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "client/app/output/picture_file.h"
#include "client/view/camera.h"
#include "client/view/session_overlay.h"
#include "common/error.h"

namespace prosector {

Viewer::Viewer(const ClientOptions& options, Connection& connection, ClientReport& report,
               HeadsetUser& headset_user, const std::shared_ptr<SharedCamera>& camera,
               std::function<void(const std::string&)> print_line)
    : client_(options, connection, report, std::move(print_line)),
      report_(report),
      sink_(options.output, options.display),
      stage_(make_stage(client_, headset_user, camera)) {
  if (options.rendering.frame_time) governor_.emplace(*options.rendering.frame_time);
  if (stage_) report_.renderer = stage_->mode->context().description();
}

void Viewer::take_picture(const std::filesystem::path& file) {
  stage_ ? sink_.ask(file)
         : client_.inform(client_.options.words.tr("screenshot: nothing is drawn with --display none"));
}

std::optional<BodyId> Viewer::part_at(const Ray& ray) {
  return stage_ ? stage_->scene.part_at(ray) : std::nullopt;
}

// Frames that no user sees and that are not stored are not rendered, except the first, which proves that
// rendering works.
void Viewer::draw_if_seen(InputPump* pump) {
  if (!stage_ || !stage_->mode->begin_frame()) return;
  const double seconds = seconds_since(report_.joined_ns);
  const bool kept = sink_.wants(seconds);
  if (!kept && !stage_->mode->is_watched() && report_.first_picture_ns) return;
  stage_->mode->wait_for_inputs(pump);
  const Image image = draw(pump, kept);
  stage_->mode->show(*stage_->renderer, times_);
  if (kept) sink_.take(image, seconds);
}

void Viewer::draw_loading(const std::string& waits_for, double progress) {
  if (stage_) stage_->mode->show_loading(*stage_->renderer, {waits_for, progress});
}

void Viewer::finish(InputPump* pump) {
  if (stage_) stage_->mode->report(report_);
  if (stage_ && report_.complete_ns && sink_.wants_last()) sink_.finish(draw(pump, true));
  sink_.finish_sheet();
  print_failures();
}

void Viewer::reload_changed_shaders() {
  if (!client_.options.rendering.watch_shaders || !stage_) return;
  if (const auto news = stage_->renderer->reload_changed_shaders()) client_.inform(*news);
}

void Viewer::print_failures() {
  for (const std::string& failure : sink_.take_failures()) client_.inform(failure);
}

std::string Viewer::help(Role role, HelpColumns columns) const {
  return stage_ ? help_text(role, stage_->mode->controls(), columns, client_.options.words) : "";
}

std::vector<std::string> Viewer::greeting(Role role) const {
  return stage_ ? first_hints(role, stage_->mode->controls(), client_.options.words)
                : std::vector<std::string>();
}

std::string Viewer::pointed() const {
  const auto body = stage_ ? stage_->mode->pointed() : std::nullopt;
  return !body ? "nothing" : client_.connection.with_replica([&](const Replica& replica) {
    return named_with_holders(replica, *body);
  });
}

/// Lets a tracked user's fingertips scroll the text of their panel.
void Viewer::read_panel(const Replica& replica, const LocalUser& self, ViewSettings& settings) {
  const auto own = replica.panels().find(self.participant);
  const auto panel = own == replica.panels().end() ? std::nullopt : std::optional(own->second);
  panel_finger_.follow(panel, stage_->scene.hidden_panel_lines(), self.input);
  settings.panel = {.place = {}, .first_line = panel_finger_.line()};
}

void Viewer::call_parts(const HandInput& user, std::size_t hand) {
  const auto eye = user.head_tracked ? user.head : stage_ ? stage_->mode->eye() : std::nullopt;
  parts_board_.toggle_open(eye.value_or(Pose{user.hands[hand].pose.p + Vec3(0, 0.3, 0.3), Quat::Identity()}),
                           hand);
}

/// Lets a tracked user's fingertips operate the board with the list of parts.
void Viewer::work_parts_board(const Replica& replica, const LocalUser& self, ViewSettings& settings) {
  if (!parts_board_.is_open()) return;
  parts_board_.follow(part_rows(parts_data(replica), client_.parts, {}, client_.options.words), self.input);
  for (const PartsOrder& order : parts_board_.take_orders()) client_.parts.obey(order);
  settings.parts = client_.parts;
  const std::vector<BodyId> hovered = parts_board_.hovered_bodies();
  settings.highlighted.insert(settings.highlighted.end(), hovered.begin(), hovered.end());
  settings.parts_board = parts_board_.shown();
}

/// Shows the playback time of a recording.
void Viewer::show_playback_time(const Replica& replica, double tick, ViewSettings& settings) const {
  const std::optional<ShownTime> shown = shown_time(replica, tick);
  if (!shown) return;
  WatchedTime& time = settings.time.emplace();
  time.recording = *replica.recording();
  time.tick = shown->tick;
  time.tick_rate = shown->tick_rate;
  time.pace = shown->pace;
  time.wish = settings.sought_tick;
  time.pointer = {-1, -1};
  if (settings.has_pointer) time.pointer = settings.pointer / settings.scale;
}

/// Returns the outlook by the client's options, which the view mode may change.
Outlook Viewer::usual_outlook() const {
  Outlook out;
  out.wireframes = client_.options.view.wireframes;
  out.shown = client_.options.view.shown;
  out.follow = client_.options.view.follow;
  if (const auto& from = client_.looks_from) out.eye = look_at(from->eye, from->target);
  return out;
}

/// Returns what the next frame shows, and updates `self` to what the user does in it.
ViewSettings Viewer::view_settings(InputPump* pump, LocalUser& self) {
  const ClientOptions& options = client_.options;
  ViewSettings out;
  out.words = options.words;
  out.overlay = options.view.overlay;
  out.insets = options.view.insets;
  out.detail = governor_ ? governor_->level().detail : options.rendering.quality.detail;
  out.messages = client_.messages.shown(seconds_since(report_.joined_ns));
  if (pump != nullptr) self.input = pump->latest();
  static_cast<Outlook&>(out) = stage_->mode->look(pump, self, usual_outlook());
  out.scale = stage_->mode->scale();
  out.parts = client_.parts;
  return out;
}

/// Renders the next frame. `keep` also reads it back, which is expensive.
Image Viewer::draw(InputPump* pump, bool keep) {
  const std::int64_t begin = monotonic_ns();
  LocalUser self{.participant = client_.connection.participant(), .input = {}, .present = pump != nullptr};
  ViewSettings settings = view_settings(pump, self);
  stage_->mode->render(*stage_->renderer, build_list(self, settings), settings);
  Image image;
  if (keep) image = stage_->renderer->read_pixels();
  stage_->mode->context().present();
  record_frame_time(seconds_since(begin));
  if (const int times = stage_->mode->take_picture_request(); times > 0) keep_picture(times, self, settings);
  return image;
}

const DrawList& Viewer::build_list(const LocalUser& self, ViewSettings& settings) {
  return client_.connection.with_replica([&](Replica& replica) -> const DrawList& {
    const double tick = replica.time().advance(monotonic_ns());
    times_.tick = replica.time().shown_tick(tick);
    times_.hand_ns = self.present ? self.input.time_ns : 0;
    show_playback_time(replica, tick, settings);
    if (is_tracked(client_.options)) read_panel(replica, self, settings);
    if (is_tracked(client_.options)) work_parts_board(replica, self, settings);
    // The own tablet's pose is taken from the image or the tracker: the server's pose arrives later.
    if (const HeldPose& tablet = self.input.held[static_cast<std::size_t>(HeldObject::tablet)];
        tablet.tracked)
      settings.panel.place = tablet.pose;
    if (const CameraOverlay* through = settings.through(); through != nullptr && through->room_tablet)
      settings.panel.place = through->room_tablet;
    return stage_->scene.build(replica, tick, self, settings);
  });
}

/// Writes the current view to a new file, at `times` the window's size.
void Viewer::keep_picture(int times, const LocalUser& self, ViewSettings settings) {
  const auto tick = client_.connection.with_replica([](Replica& r) {
    return static_cast<std::uint64_t>(r.time().shown_tick(r.time().advance(monotonic_ns())));
  });
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
    client_.inform(client_.options.words.tr("screenshot: {}", file.string()));
  } catch (const InputError& error) {
    client_.inform(error.what());
  }
}

void Viewer::record_frame_time(double seconds) {
  if (!report_.first_picture_ns) report_.first_picture_ns = monotonic_ns();
  ++report_.pictures;
  report_.drawing_seconds += seconds;
  if (report_.pictures > 1)
    report_.longest_drawing_seconds = std::max(report_.longest_drawing_seconds, seconds);
  if (governor_ && governor_->took(seconds)) {
    stage_->renderer->set_settings(governor_->level().settings);
    client_.inform(client_.options.words.tr("quality: {}",
                                            client_.options.words.tr(std::string(governor_->level().name))));
  }
  client_.connection.with_replica([&](const Replica& replica) {
    client_.figures.take(monotonic_ns(), seconds, client_.connection.counters(),
                         replica.status() ? &*replica.status() : nullptr);
  });
}

}  // namespace prosector
