#include "client/app/run_client.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <thread>
#include <utility>

#include "client/app/client_report.h"
#include "client/app/console.h"
#include "client/app/cut_list.h"
#include "client/app/happenings.h"
#include "client/app/input_pump.h"
#include "client/app/panel_call.h"
#include "client/app/parts_commands.h"
#include "client/app/session_log.h"
#include "client/app/viewer.h"
#include "client/offer/offer_server.h"
#include "client/offer/offered_camera.h"
#include "common/clock.h"
#include "common/hand.h"
#include "common/index_tip.h"

namespace prosector {
namespace {

volatile std::sig_atomic_t interrupted = 0;

/// Tells whether the user has an arm and is to feel with it: an observer has no hands.
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
        happenings_(connection_.participant(), options.words) {
    report_.started_ns = started_ns;
    report_.joined_ns = monotonic_ns();
    tell(fmt::format("{} session '{}' as {}", options.join.role == Role::observer ? "observing" : "joined",
                     options.bus.session, options.join.name));
    if (!options.latency_log.empty() && options.join.role == Role::observer)
      arrivals_.emplace(options.latency_log);
    if (has_arm(options)) arm_ = std::make_unique<ArmHand>(options.devices.arm);
    if (arrivals_ || arm_) connection_.on_received([this](const Received& r) { received(r); });
    if (!options.session_log.empty()) log_.emplace(options.session_log);
    connection_.start();
    if (const std::string camera = used_camera(options); !camera.empty())
      camera_ = std::make_shared<SharedCamera>(camera);
    if (!options.offered_camera.empty())
      offered_camera_.emplace(shared_camera(camera_, options.offered_camera));
    for (const Offer& offer : options.offers) {
      offers_.push_back(std::make_unique<OfferServer>(
          offer,
          [this] {
            return connection_.with_replica(
                [](Replica& replica) { return offered(replica, replica.advance(monotonic_ns())); });
          },
          offered_camera_ ? OfferServer::Picture([this] { return offered_camera_->newest(); })
                          : OfferServer::Picture()));
      tell(offers_.back()->words());
    }
    take_role(options.join.role);
    viewer_.emplace(options, connection_, report_, headset_user_, camera_, tell);
    if (viewer_->has_desk()) tell(viewer_->help(options.join.role, HelpColumns::blanks));
    if (isatty(STDIN_FILENO) != 0) tell(console_help());
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
    if (!options_.summary.empty()) write_report(report_, connection_, options_.summary);
    return report_.complete_ns && !viewer_->lost_pictures() ? 0 : 1;
  }

 private:
  const ClientOptions& options_;
  ClientReport report_;
  Connection connection_;
  std::shared_ptr<SharedCamera> camera_;         // that is looked through, or sees the eyes; null: none is
  std::optional<OfferedCamera> offered_camera_;  // whose pictures others see; nullopt: none does
  std::vector<std::unique_ptr<OfferServer>> offers_;
  std::optional<ArrivalLog> arrivals_;
  std::optional<SessionLog> log_;
  std::unique_ptr<ArmHand> arm_;  // null: no arm
  HeadsetUser headset_user_;
  std::unique_ptr<InputPump> pump_;
  std::optional<Viewer> viewer_;        // made last: see yield_to_simulation()
  std::string missing_ = "everything";  // what was last told to be missing
  bool server_gone_ = false, greeted_ = false;
  Role role_ = Role::observer;
  Console console_;
  Happenings happenings_;

  static JoinRequest request(const ClientOptions& o) {
    JoinRequest out = o.join;
    if (out.role != Role::observer) {
      out.devices = describe_devices(o.devices);
      if (o.display == Display::openxr) out.devices += out.devices.empty() ? "openxr" : ", openxr";
    }
    if (has_arm(o)) out.arms = static_cast<std::uint8_t>(1u << o.devices.arm.hand);
    return out;
  }

  /// Takes a sample on the network's thread.
  void received(const Received& r) {
    if (arrivals_) arrivals_->received(r);
    if (const auto* felt = std::get_if<FeltPlanes>(&r.message); felt != nullptr && arm_)
      arm_->received(*felt, connection_.participant());
  }

  /// Says how punctual the arm's thread was.
  std::string servo_line() {
    const Lateness late = arm_->servo().lateness();
    return fmt::format(
        "arm: {} cycles, {} skipped; late by {:.3f} ms at p50, {:.3f} at p99, {:.1f} at worst, {} real-time "
        "priority",
        late.cycles, late.skipped, 1e3 * late.p50, 1e3 * late.p99, 1e3 * late.worst,
        arm_->servo().real_time() ? "with" : "without");
  }

  /// Says what went through the arm's hand, as both ends counted it.
  std::string energy_line() {
    const EnergyBook here = arm_->servo().view().energy, there = arm_->far_end();
    return fmt::format("arm: the hand gave {:.1f} mJ and got {:.1f}; the server counted {:.1f} and {:.1f}",
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
        if (!options_.camera.empty())
          check_phantoms(*replica.scene(), options_.phantoms, found.has_place() ? found.body : "");
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
      inform(gone ? options_.words.tr("the server is gone; waiting for it to come back")
                  : options_.words.tr("the server is back"));
    }
    for (const std::string& words : connection_.take_words()) inform(words, MessageKind::own);
    happenings_.rename_self(connection_.participant());
    for (const Happening& happening : connection_.with_replica([&](const Replica& replica) {
           return happenings_.look(replica, seconds_since(report_.joined_ns));
         }))
      inform(happening.text, happening.kind);
    viewer_->tell_failures();
  }

  /// Tells people at the terminal and in the picture.
  void inform(const std::string& line, MessageKind kind = MessageKind::news) {
    tell(line);
    if (viewer_) viewer_->say(line, kind);
  }

  /// Tells who has a window what to do first, once.
  void greet() {
    if (!std::exchange(greeted_, true))
      for (const std::string& line : viewer_->greeting(role_)) inform(line);
  }

  /// Answers what was typed: in the picture, too, unless it is a page of help.
  void answer(const std::string& text) {
    text.find('\n') == std::string::npos ? inform(text, MessageKind::own) : tell(text);
  }

  void show_loading() {
    const auto [missing, progress] = connection_.with_replica([this](const Replica& replica) {
      return std::pair(replica.missing(options_.words), replica.progress());
    });
    viewer_->draw_loading(missing, progress);
  }

  /// Observers have no hands; whoever is made a dissector has.
  void take_role(Role role) {
    role_ = role;
    if (role == Role::observer)
      pump_.reset();
    else if (!pump_)
      pump_ = std::make_unique<InputPump>(connection_, source(), &headset_user_, arm_.get(),
                                          latency_log_of_hands(), tell);
  }

  /// Returns where devices come from. What they see by a camera is what is looked through or offered, where
  /// it is that one.
  ConfigSource source() const {
    ConfigSource out = options_.source;
    out.camera = camera_ || !offered_camera_ ? camera_ : offered_camera_->camera();
    return out;
  }

  /// Returns where inputs are logged; none for an observer, who logs what arrives instead.
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
    const Catalogue& words = options_.words;
    inform(role == Role::observer ? words.tr("you are an observer now")
           : role == Role::host   ? words.tr("you are the host now")
                                  : words.tr("you are a dissector now"));
  }

  void obey_console() {
    for (const std::string& line : console_.take()) {
      if (obeys_about_parts(line)) continue;
      const auto parsed = connection_.with_replica([&](Replica& replica) {
        return parse_console_line(
            line, replica.scene() ? *replica.scene() : SceneInfo{}, replica.roster(),
            [&](BodyId body) { return middle_of(replica, body); },
            shown_time(replica, replica.advance(monotonic_ns())));
      });
      if (const Command* command = std::get_if<Command>(&parsed))
        connection_.command(*command);
      else if (const TakePicture* picture = std::get_if<TakePicture>(&parsed))
        viewer_->take_picture(picture->file);
      else if (const LookFrom* look = std::get_if<LookFrom>(&parsed))
        viewer_->look_from(*look);
      else if (std::holds_alternative<LookAsBefore>(parsed))
        viewer_->look_from(std::nullopt);
      else if (std::holds_alternative<TellPointed>(parsed))
        tell("at the pointer: " + viewer_->pointed());
      else if (std::holds_alternative<ListCuts>(parsed))
        tell(connection_.with_replica([](const Replica& r) {
          return told_cuts(r.scene() ? *r.scene() : SceneInfo{}, r.roster(), r.tick_seconds(),
                           [&](BodyId body) { return r.topology(body); });
        }));
      else
        answer(std::get<std::string>(parsed));
    }
  }

  /// Obeys a line about what the user sees of the parts; false: it is about something else.
  bool obeys_about_parts(const std::string& line) {
    const auto parsed = connection_.with_replica([&](const Replica& replica) {
      return parse_parts_line(line, parts_known(replica), viewer_->parts());
    });
    if (!parsed) return false;
    if (const PartsOrder* order = std::get_if<PartsOrder>(&*parsed))
      viewer_->obey(*order);
    else
      answer(std::get<std::string>(*parsed));
    return true;
  }

  void obey_gestures() {
    for (const std::size_t hand : pump_->take_panel_calls()) {
      const auto pointed_at = viewer_->part_at(along_index(hand));
      const auto command = connection_.with_replica([&](const Replica& replica) {
        return call_panel(replica, connection_.participant(), hand, pointed_at);
      });
      if (command) connection_.command(*command);
    }
    for (const std::size_t hand : pump_->take_parts_calls()) viewer_->call_parts(pump_->latest(), hand);
  }

  Ray along_index(std::size_t hand) const {
    const HandPose pose = pump_->latest().hands[hand];
    const Pose finger = pose.pose * hand_pose(hand, pose.flexion)[index_knuckle];
    return {finger.p, finger.q * -Vec3::UnitZ()};
  }

  void write_log() {
    connection_.with_replica([&](Replica& replica) {
      log_->write(replica, replica.advance(monotonic_ns()), seconds_since(report_.joined_ns));
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
