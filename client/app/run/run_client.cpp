#include "client/app/run/run_client.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <thread>
#include <utility>

#include "client/app/run/viewer.h"
#include "client/app/session/client_report.h"
#include "client/app/session/session_events.h"
#include "client/app/session/session_log.h"
#include "client/app/terminal/console.h"
#include "client/app/terminal/cut_list.h"
#include "client/app/terminal/panel_call.h"
#include "client/app/terminal/parts_commands.h"
#include "client/app/user/handled_bodies.h"
#include "client/app/user/input_pump.h"
#include "client/offer/offer_server.h"
#include "client/offer/offered_camera.h"
#include "common/clock.h"
#include "common/hand.h"
#include "common/index_tip.h"

namespace prosector {
namespace {

volatile std::sig_atomic_t interrupted = 0;

/// Reports whether a haptic arm is configured and the user is not an observer, as observers have no hands.
bool has_arm(const ClientOptions& options) {
  return !options.devices.arm.address.empty() && options.join.role != Role::observer;
}

void tell(const std::string& line) {
  fmt::print("{}\n", line), std::fflush(stdout);
}

class Client {
 public:
  Client(const ClientOptions& options, std::int64_t started_ns)
      : options_(options),
        connection_(options.bus, request(options)),
        session_events_(connection_.participant(), options.words) {
    report_.started_ns = started_ns;
    report_.joined_ns = monotonic_ns();
    tell(fmt::format("{} session '{}' as {}", options.join.role == Role::observer ? "observing" : "joined",
                     options.bus.session, options.join.name));
    if (!options.logs.latency.empty() && options.join.role == Role::observer)
      arrivals_.emplace(options.logs.latency);
    if (has_arm(options)) arm_ = std::make_unique<ArmHand>(options.devices.arm);
    if (arrivals_ || arm_) connection_.on_received([this](const Received& r) { received(r); });
    if (!options.logs.session.empty()) log_.emplace(options.logs.session);
    connection_.start();
    if (const std::string camera = used_camera(options); !camera.empty())
      camera_ = std::make_shared<SharedCamera>(camera);
    if (!options.offers.camera.empty())
      offered_camera_.emplace(shared_camera(camera_, options.offers.camera));
    for (const Offer& offer : options.offers.poses) {
      offers_.push_back(std::make_unique<OfferServer>(
          offer,
          [this] {
            return connection_.with_replica(
                [](Replica& replica) { return offered(replica, replica.time().advance(monotonic_ns())); });
          },
          offered_camera_ ? OfferServer::Picture([this] { return offered_camera_->newest(); })
                          : OfferServer::Picture()));
      tell(offers_.back()->words());
    }
    take_role(options.join.role);
    viewer_.emplace(options, connection_, report_, headset_user_, camera_, tell);
    if (const std::string help = viewer_->help(options.join.role, HelpColumns::blanks); !help.empty())
      tell(help);
    if (isatty(STDIN_FILENO) != 0) tell(console_help());
  }

  int run() {
    const auto interval = std::chrono::duration_cast<std::chrono::steady_clock::duration>(
        std::chrono::duration<double>(1 / options_.display.frames_per_second));
    auto next = std::chrono::steady_clock::now();
    while (!done()) {
      note_progress();
      follow_role();
      run_console_commands();
      if (pump_) run_gesture_commands();
      if (log_ && report_.complete_ns) write_log();
      viewer_->reload_changed_shaders();
      if (report_.complete_ns)
        viewer_->draw_if_seen(pump_.get());
      else
        show_loading();
      if (viewer_->keeps_time()) continue;
      next = std::max(next + interval, std::chrono::steady_clock::now() - interval);
      std::this_thread::sleep_until(next);
    }
    viewer_->finish(pump_.get());
    if (arm_) {
      tell(servo_line());
      tell(energy_line());
    }
    if (!options_.logs.summary.empty()) write_report(report_, connection_, options_.logs.summary);
    return report_.complete_ns && !viewer_->lost_pictures() ? 0 : 1;
  }

 private:
  const ClientOptions& options_;
  ClientReport report_;
  Connection connection_;
  std::shared_ptr<SharedCamera> camera_;  // camera for augmented reality or eye tracking; null: none
  std::optional<OfferedCamera>
      offered_camera_;  // camera whose images are offered to other software; nullopt: none
  std::vector<std::unique_ptr<OfferServer>> offers_;
  std::optional<ArrivalLog> arrivals_;
  std::optional<SessionLog> log_;
  std::unique_ptr<ArmHand> arm_;  // null: no arm
  HeadsetUser headset_user_;
  std::unique_ptr<InputPump> pump_;
  std::optional<Viewer> viewer_;        // created last: see lower_render_priority()
  std::string missing_ = "everything";  // last reported missing data
  bool server_gone_ = false, greeted_ = false;
  Role role_ = Role::observer;
  Console console_;
  SessionEvents session_events_;
  HandledBodies handled_bodies_;  // for the gesture that resets a body

  static JoinRequest request(const ClientOptions& o) {
    JoinRequest out = o.join;
    if (out.role != Role::observer) {
      out.devices = describe_devices(o.devices);
      if (o.display.kind == Display::openxr) out.devices += out.devices.empty() ? "openxr" : ", openxr";
    }
    if (has_arm(o)) out.arms = static_cast<std::uint8_t>(1u << o.devices.arm.hand);
    return out;
  }

  /// Processes a sample on the network thread.
  void received(const Received& r) {
    if (arrivals_) arrivals_->received(r);
    if (const auto* felt = std::get_if<FeltPlanes>(&r.message); felt != nullptr && arm_)
      arm_->received(*felt, connection_.participant());
  }

  /// Returns the timing statistics of the arm's servo thread.
  std::string servo_line() {
    const Lateness late = arm_->servo().lateness();
    return fmt::format(
        "arm: {} servo cycles, {} skipped; cycle latency {:.3f} ms p50, {:.3f} p99, {:.1f} max, {} real-time "
        "priority",
        late.cycles, late.skipped, 1e3 * late.p50, 1e3 * late.p99, 1e3 * late.worst,
        arm_->servo().real_time() ? "with" : "without");
  }

  /// Returns the energy transferred through the arm's hand, as counted by client and server.
  std::string energy_line() {
    const EnergyBook here = arm_->servo().view().energy, there = arm_->server_energy();
    return fmt::format(
        "arm: energy from the hand {:.1f} mJ, to the hand {:.1f} mJ; counted by the server {:.1f} mJ and "
        "{:.1f} mJ",
        1e3 * here.taken, 1e3 * here.given, 1e3 * there.taken, 1e3 * there.given);
  }

  bool done() {
    const bool over = options_.seconds > 0 && seconds_since(report_.joined_ns) > options_.seconds;
    return interrupted != 0 || over || viewer_->closed();
  }

  void note_progress() {
    std::string missing;
    const bool gone = connection_.with_replica([&](Replica& replica) {
      if (!report_.complete_ns && replica.complete()) {
        report_.complete_ns = monotonic_ns();
        report_.bytes_at_complete = connection_.counters().bytes_in;
        const PhantomSettings& found = options_.devices.phantom;
        if (!options_.ar.camera.empty())
          check_phantoms(*replica.scene(), options_.ar.phantoms, found.has_place() ? found.body : "");
      }
      missing = replica.missing();
      return replica.server_gone();
    });
    if (missing != missing_) {
      missing_ = missing;
      tell(missing.empty() ? "everything is here" : missing);  // English: scripts wait for it
      if (missing.empty()) greet();
    }
    if (gone != server_gone_) {
      server_gone_ = gone;
      inform(gone ? options_.words.tr("the server does not respond; waiting for it")
                  : options_.words.tr("the server responds again"));
    }
    for (const std::string& words : connection_.take_server_messages()) inform(words, MessageKind::own);
    session_events_.rename_self(connection_.participant());
    for (const SessionMessage& happening : connection_.with_replica([&](const Replica& replica) {
           return session_events_.look(replica, seconds_since(report_.joined_ns));
         }))
      inform(happening.text, happening.kind);
    viewer_->print_failures();
  }

  /// Prints a line in the terminal and shows it in the window.
  void inform(const std::string& line, MessageKind kind = MessageKind::news) {
    tell(line);
    if (viewer_) viewer_->say(line, kind);
  }

  /// Prints and shows the first hints, once.
  void greet() {
    if (!std::exchange(greeted_, true))
      for (const std::string& line : viewer_->greeting(role_)) inform(line);
  }

  /// Answers a terminal command: also in the window, unless the answer has several lines.
  void answer(const std::string& text) {
    text.find('\n') == std::string::npos ? inform(text, MessageKind::own) : tell(text);
  }

  void show_loading() {
    const auto [missing, progress] = connection_.with_replica([this](const Replica& replica) {
      return std::pair(replica.missing(options_.words), replica.progress());
    });
    viewer_->draw_loading(missing, progress);
  }

  /// Creates or removes the user's hands: observers have none.
  void take_role(Role role) {
    role_ = role;
    if (role == Role::observer)
      pump_.reset();
    else if (!pump_)
      pump_ = std::make_unique<InputPump>(connection_, source(), &headset_user_, arm_.get(),
                                          latency_log_of_hands(), tell);
  }

  /// Returns the source of the device configuration, with the open camera, so that trackers can share it.
  ConfigSource source() const {
    ConfigSource out = options_.source;
    out.camera = camera_ || !offered_camera_ ? camera_ : offered_camera_->camera();
    return out;
  }

  /// Returns the latency log of inputs; empty for an observer, whose log has arrivals instead.
  std::filesystem::path latency_log_of_hands() const {
    return options_.join.role == Role::observer ? std::filesystem::path() : options_.logs.latency;
  }

  Vec3 middle_of(Replica& replica, BodyId body) const {
    const SoftReplica* soft = replica.bodies().soft(body);
    if (soft == nullptr) return replica.rigid_pose(body, replica.time().advance(monotonic_ns())).p;
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
    const Catalogue& words = options_.words;
    inform(role == Role::observer ? words.tr("you are now an observer")
           : role == Role::host   ? words.tr("you are now the host")
                                  : words.tr("you are now a dissector"));
  }

  void run_console_commands() {
    for (const std::string& line : console_.take()) {
      if (execute_parts_line(line)) continue;
      const auto parsed = connection_.with_replica([&](Replica& replica) {
        return parse_console_line(
            line, replica.scene() ? *replica.scene() : SceneInfo{}, replica.roster(),
            [&](BodyId body) { return middle_of(replica, body); },
            shown_time(replica, replica.time().advance(monotonic_ns())));
      });
      if (const CommandBody* command = std::get_if<CommandBody>(&parsed))
        connection_.command(*command);
      else if (const TakePicture* picture = std::get_if<TakePicture>(&parsed))
        viewer_->take_picture(picture->file);
      else if (const LookFrom* look = std::get_if<LookFrom>(&parsed))
        viewer_->look_from(*look);
      else if (std::holds_alternative<RestoreView>(parsed))
        viewer_->look_from(std::nullopt);
      else if (std::holds_alternative<DescribePointed>(parsed))
        tell("at the pointer: " + viewer_->pointed());
      else if (std::holds_alternative<ListCuts>(parsed))
        tell(connection_.with_replica([](const Replica& r) {
          return cut_list_text(r.scene() ? *r.scene() : SceneInfo{}, r.roster(), r.time().tick_seconds(),
                               [&](BodyId body) { return r.bodies().topology(body); });
        }));
      else
        answer(std::get<std::string>(parsed));
    }
  }

  /// Executes a command about the display of parts. Returns false if the line is none.
  bool execute_parts_line(const std::string& line) {
    const auto parsed = connection_.with_replica([&](const Replica& replica) {
      return parse_parts_line(line, parts_data(replica), viewer_->parts());
    });
    if (!parsed) return false;
    if (const PartsOrder* order = std::get_if<PartsOrder>(&*parsed))
      viewer_->obey(*order);
    else
      answer(std::get<std::string>(*parsed));
    return true;
  }

  void run_gesture_commands() {
    for (const std::size_t hand : pump_->take_calls(GestureEvent::panel)) {
      const auto pointed_at = viewer_->part_at(along_index(hand));
      const auto command = connection_.with_replica([&](const Replica& replica) {
        return call_panel(replica, connection_.participant(), hand, pointed_at);
      });
      if (command) connection_.command(*command);
    }
    for (const std::size_t hand : pump_->take_calls(GestureEvent::parts))
      viewer_->call_parts(pump_->latest(), hand);
    reset_bodies(pump_->take_calls(GestureEvent::reset));
  }

  /// Resets for each of these hands the body that it holds, otherwise the body that it held or touched last.
  void reset_bodies(const std::vector<std::size_t>& hands) {
    connection_.with_replica(
        [&](const Replica& replica) { handled_bodies_.update(replica, connection_.participant()); });
    for (const std::size_t hand : hands)
      if (const auto body = handled_bodies_.last(hand))
        connection_.command(ResetBody{.body = *body, .hand = static_cast<std::uint8_t>(hand)});
      else
        inform(options_.words.tr("nothing to reset: hold or touch a body first"), MessageKind::own);
  }

  Ray along_index(std::size_t hand) const {
    const HandPose pose = pump_->latest().hands[hand];
    const Pose finger = pose.pose * hand_pose(hand, pose.flexion)[index_knuckle];
    return {finger.p, finger.q * -Vec3::UnitZ()};
  }

  void write_log() {
    connection_.with_replica([&](Replica& replica) {
      log_->write(replica, replica.time().advance(monotonic_ns()), seconds_since(report_.joined_ns));
    });
  }
};

}  // namespace

int run_client(const ClientOptions& options, std::int64_t started_ns) {
  std::signal(SIGINT, [](int) { interrupted = 1; });
  std::signal(SIGTERM, [](int) { interrupted = 1; });
  return Client(options, started_ns).run();
}

}  // namespace prosector
