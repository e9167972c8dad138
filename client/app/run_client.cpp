#include "client/app/run_client.h"

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <thread>

#include "client/app/client_report.h"
#include "client/app/console.h"
#include "client/app/desk.h"
#include "client/app/figures.h"
#include "client/app/input_pump.h"
#include "client/app/panel_call.h"
#include "client/app/picture_sink.h"
#include "client/app/session_log.h"
#include "client/render/quality_governor.h"
#include "client/render/renderer.h"
#include "client/render/window_context.h"
#include "client/view/camera.h"
#include "client/view/scene_view.h"
#include "common/clock.h"
#include "common/hand.h"

namespace prosector {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void tell(const std::string& line) {
  fmt::print("{}\n", line), std::fflush(stdout);
}

double seconds_since(std::int64_t t) {
  return 1e-9 * static_cast<double>(monotonic_ns() - t);
}

/// Everything that draws; absent with --display none.
struct Stage {
  std::unique_ptr<GlContext> context;
  std::unique_ptr<Renderer> renderer;
  WindowContext* window = nullptr;  // the context, where it is one
  std::unique_ptr<Desk> desk;       // with a window only
  SceneView view;
};

// On a shared machine the simulation has the first call: pictures can wait a frame, physics can't. Threads
// that start after this (the software renderer's) inherit it; those that carry hands and snapshots run
// already.
void yield_to_simulation() {
  setpriority(PRIO_PROCESS, 0, 5);
}

std::unique_ptr<Stage> make_stage(const ClientOptions& o) {
  if (o.display == Display::none) return nullptr;
  yield_to_simulation();
  auto stage = std::make_unique<Stage>();
  if (o.display == Display::offscreen) {
    stage->context = make_offscreen_context(o.width, o.height);
  } else if (o.display == Display::osmesa) {
    stage->context = make_osmesa_context(o.width, o.height);
  } else {
    auto window = make_window_context(o.width, o.height, "Prosector: " + o.bus.session);
    stage->desk = std::make_unique<Desk>(*window, o.shown, o.monitor.has_value());
    stage->window = window.get();
    stage->context = std::move(window);
  }
  stage->renderer = std::make_unique<Renderer>(*stage->context, o.shaders, o.quality);
  return stage;
}

class Client {
 public:
  Client(const ClientOptions& options, std::int64_t started_ns)
      : options_(options),
        connection_(options.bus, request(options)),
        sink_(options),
        follow_(options.follow) {
    report_.started_ns = started_ns;
    report_.joined_ns = monotonic_ns();
    tell(fmt::format("{} session '{}' as {}", options.join.role == Role::observer ? "observing" : "joined",
                     options.bus.session, options.join.name));
    if (!options.latency_log.empty() && options.join.role == Role::observer) {
      arrivals_.emplace(options.latency_log);
      connection_.on_received([this](const Received& r) { arrivals_->received(r); });
    }
    if (!options.session_log.empty()) log_.emplace(options.session_log);
    connection_.start();
    take_role(options.join.role);
    if (options.frame_time) governor_.emplace(*options.frame_time);
    stage_ = make_stage(options);
    if (stage_ && stage_->desk && drives_hand_at_desk()) tell(desk_help);
    if (isatty(STDIN_FILENO) != 0) tell(console_help);
    if (stage_) report_.renderer = stage_->context->description();
  }

  int run() {
    const auto interval = std::chrono::duration_cast<std::chrono::steady_clock::duration>(
        std::chrono::duration<double>(1 / options_.frames_per_second));
    auto next = std::chrono::steady_clock::now();
    while (!done()) {
      note_progress();
      follow_role();
      obey_console();
      if (pump_) obey_gestures();
      if (log_ && report_.complete_ns) write_log();
      if (options_.watch_shaders && stage_)
        if (const auto news = stage_->renderer->reload_changed_shaders()) tell(*news);
      if (stage_ && report_.complete_ns) draw_if_seen();
      next = std::max(next + interval, std::chrono::steady_clock::now() - interval);
      std::this_thread::sleep_until(next);
    }
    if (stage_ && report_.complete_ns && sink_.wants_last()) sink_.finish(draw(true));
    sink_.finish_sheet();
    tell_failures();
    if (!options_.summary.empty()) write_report(report_, connection_, options_.summary);
    return report_.complete_ns ? 0 : 1;
  }

 private:
  const ClientOptions& options_;
  ClientReport report_;
  Connection connection_;
  std::optional<ArrivalLog> arrivals_;
  std::optional<SessionLog> log_;
  PictureSink sink_;
  std::unique_ptr<InputPump> pump_;
  std::unique_ptr<Stage> stage_;
  std::optional<QualityGovernor> governor_;  // of pictures; nullopt: their quality stays
  std::string missing_ = "everything";       // what was last told to be missing
  bool server_gone_ = false;
  Role role_ = Role::observer;
  Console console_;
  std::optional<Pose> looks_from_;
  std::string follow_;  // whose eyes to look through; empty: own
  bool full_screen_ = false;
  Figures figures_;

  static JoinRequest request(const ClientOptions& o) {
    JoinRequest out = o.join;
    if (out.role != Role::observer) out.devices = describe_devices(o.devices);
    return out;
  }

  bool drives_hand_at_desk() const { return pump_ && !has_devices(options_.devices); }

  bool done() {
    const bool over = options_.seconds > 0 && seconds_since(report_.joined_ns) > options_.seconds;
    return interrupted != 0 || over || (stage_ && stage_->desk && stage_->desk->closed());
  }

  void note_progress() {
    std::string missing;
    const bool gone = connection_.with_replica([&](Replica& replica) {
      if (!report_.complete_ns && replica.complete()) {
        report_.complete_ns = monotonic_ns();
        report_.bytes_at_complete = connection_.counters().bytes_in;
      }
      missing = replica.missing();
      return replica.server_gone();
    });
    if (missing != missing_) {
      missing_ = missing;
      tell(missing.empty() ? "everything is here" : missing);
    }
    if (gone != server_gone_) {
      server_gone_ = gone;
      tell(gone ? "the server is gone; waiting for it to come back" : "the server is back");
    }
    if (const std::string refusal = connection_.last_refusal(); !refusal.empty())
      tell("the server refused: " + refusal);
    tell_failures();
  }

  /// Observers have no hands; whoever is made a dissector has.
  void take_role(Role role) {
    role_ = role;
    if (role == Role::observer)
      pump_.reset();
    else if (!pump_)
      pump_ = std::make_unique<InputPump>(connection_, options_.devices, latency_log_of_hands(), tell);
  }

  /// Who joined as an observer logs what arrives instead.
  std::filesystem::path latency_log_of_hands() const {
    return options_.join.role == Role::observer ? std::filesystem::path() : options_.latency_log;
  }

  Vec3 middle_of(Replica& replica, BodyId body) const {
    const SoftReplica* soft = replica.soft(body);
    if (soft == nullptr) return replica.rigid_pose(body, replica.advance(monotonic_ns())).p;
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (const Eigen::Vector3f& x : soft->surface()) sum += x;
    return (sum / static_cast<float>(soft->surface().size())).cast<double>();
  }

  void follow_role() {
    const Role role = connection_.with_replica([&](Replica& replica) {
      const auto me = replica.roster().find(connection_.participant());
      return me == replica.roster().end() ? role_ : me->second.role;
    });
    if (role == role_) return;
    take_role(role);
    tell(role == Role::observer
             ? "you are an observer now"
             : fmt::format("you are {} now", role == Role::host ? "the host" : "a dissector"));
  }

  void obey_console() {
    for (const std::string& line : console_.take()) {
      const auto parsed = connection_.with_replica([&](Replica& replica) {
        return parse_console_line(line, replica.scene() ? *replica.scene() : SceneInfo{}, replica.roster(),
                                  [&](BodyId body) { return middle_of(replica, body); });
      });
      if (const Command* command = std::get_if<Command>(&parsed))
        connection_.command(*command);
      else if (const TakePicture* picture = std::get_if<TakePicture>(&parsed))
        stage_ ? sink_.ask(picture->file) : tell("picture: nothing is drawn with --display none");
      else if (const LookFrom* look = std::get_if<LookFrom>(&parsed))
        looks_from_ = look_at(look->eye, look->target);
      else if (std::holds_alternative<LookAsBefore>(parsed))
        looks_from_.reset();
      else
        tell(std::get<std::string>(parsed));
    }
  }

  void obey_gestures() {
    for (const std::size_t hand : pump_->take_panel_calls()) {
      const auto pointed_at = stage_ ? stage_->view.part_at(along_index(hand)) : std::nullopt;
      const auto command = connection_.with_replica([&](const Replica& replica) {
        return call_panel(replica, connection_.participant(), hand, pointed_at);
      });
      if (command) connection_.command(*command);
    }
  }

  Ray along_index(std::size_t hand) const {
    constexpr std::size_t index_knuckle = 2;
    const HandPose pose = pump_->latest().hands[hand];
    const Pose finger = pose.pose * hand_pose(hand, pose.flexion)[index_knuckle];
    return {finger.p, finger.q * -Vec3::UnitZ()};
  }

  void write_log() {
    connection_.with_replica([&](Replica& replica) {
      log_->write(replica, replica.advance(monotonic_ns()), seconds_since(report_.joined_ns));
    });
  }

  void tell_failures() {
    for (const std::string& failure : sink_.take_failures()) tell(failure);
  }

  // Offscreen, a picture that nobody keeps is not drawn; the first one proves that drawing works.
  void draw_if_seen() {
    const double seconds = seconds_since(report_.joined_ns);
    const bool kept = sink_.wants(seconds);
    if (!kept && !stage_->desk && report_.first_picture_ns) return;
    const Image image = draw(kept);
    if (kept) sink_.take(image, seconds);
  }

  void use_desk(LocalUser& self, ViewSettings& settings) {
    Desk& desk = *stage_->desk;
    std::optional<Panel> own_panel;
    const CameraInfo camera = connection_.with_replica([&](Replica& r) {
      if (const auto own = r.panels().find(self.participant); own != r.panels().end())
        own_panel = own->second;
      return r.scene()->camera;
    });
    desk.update(camera, own_panel ? &*own_panel : nullptr);
    settings.eye = desk.eye();
    settings.wireframes = options_.wireframes != desk.wireframes();
    settings.shown = desk.shown();
    if (desk.full_screen() != full_screen_) {
      full_screen_ = desk.full_screen();
      stage_->window->set_full_screen(full_screen_ ? options_.monitor.value_or(0) : std::optional<int>());
    }
    for (std::size_t n = desk.take_follow_requests(); n > 0; --n) follow_next(self.participant);
    settings.follow = follow_;
    if (desk.figures()) settings.notes = figures_.text();
    if (desk.help()) settings.notes += (settings.notes.empty() ? "" : "\n\n") + std::string(desk_help);
    if (!drives_hand_at_desk()) return;
    self.input = desk.input();
    pump_->set_desk_input(self.input);
    for (const Command& command : desk.take_commands()) connection_.command(command);
    const auto request = desk.take_panel_request();
    if (!request) return;
    Command command;
    const auto part = stage_->view.part_at(*request);
    command.kind = part ? CommandKind::open_panel : CommandKind::close_panel;
    command.body = part.value_or(0);
    if (part || own_panel) connection_.command(command);
  }

  /// To the next other user who has eyes, and after the last one back to one's own.
  void follow_next(ParticipantId self) {
    std::vector<std::string> names = {""};
    connection_.with_replica([&](Replica& replica) {
      const double tick = replica.advance(monotonic_ns());
      for (const auto& [id, entry] : replica.roster()) {
        const auto user = replica.user(id, tick);
        if (id != self && user && user->head_tracked) names.push_back(entry.name);
      }
    });
    const auto now = std::find(names.begin(), names.end(), follow_);
    follow_ = now == names.end() || now + 1 == names.end() ? "" : *(now + 1);
  }

  /// Draws a picture; `keep` also reads it back, which costs.
  Image draw(bool keep) {
    const std::int64_t begin = monotonic_ns();
    LocalUser self{.participant = connection_.participant(), .input = {}, .present = pump_ != nullptr};
    ViewSettings settings;
    settings.overlay = options_.overlay;
    settings.wireframes = options_.wireframes;
    settings.shown = options_.shown;
    settings.insets = options_.insets;
    settings.follow = follow_;
    settings.eye = looks_from_;
    if (options_.display == Display::stereo) settings.stereo = options_.stereo;
    if (pump_) self.input = pump_->latest();
    if (stage_->desk) use_desk(self, settings);
    settings.width = stage_->context->width();
    settings.height = stage_->context->height();
    const DrawList* list = nullptr;
    connection_.with_replica([&](Replica& replica) {
      list = &stage_->view.build(replica, replica.advance(monotonic_ns()), self, settings);
    });
    stage_->renderer->draw(*list);
    Image image;
    if (keep) image = stage_->renderer->read_pixels();
    stage_->context->present();
    if (!report_.first_picture_ns) report_.first_picture_ns = monotonic_ns();
    ++report_.pictures;
    const double seconds = seconds_since(begin);
    if (governor_ && governor_->took(seconds)) {
      stage_->renderer->set_settings(governor_->level().settings);
      tell(fmt::format("quality: {}", governor_->level().name));
    }
    report_.drawing_seconds += seconds;
    connection_.with_replica([&](const Replica& replica) {
      figures_.take(monotonic_ns(), seconds, connection_.counters(),
                    replica.status() ? &*replica.status() : nullptr);
    });
    if (report_.pictures > 1)
      report_.longest_drawing_seconds = std::max(report_.longest_drawing_seconds, seconds);
    return image;
  }
};

}  // namespace

int run_client(const ClientOptions& options, std::int64_t started_ns) {
  std::signal(SIGINT, [](int) { interrupted = 1; });
  std::signal(SIGTERM, [](int) { interrupted = 1; });
  return Client(options, started_ns).run();
}

}  // namespace prosector
