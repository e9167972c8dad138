#pragma once
// Finds, joins and leaves a session.

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "client/app/session/input_loss_detector.h"
#include "client/replica/server_choice.h"
#include "idl/bus.h"

namespace prosector {

struct JoinRequest {
  std::string name;
  Role role = Role::observer;
  std::string devices;
  std::uint8_t arms = 0;  // see Presence::arms
  std::string language;   // language tag of the displayed names; empty: the scene's own names
  std::chrono::milliseconds time_limit{5000};  // timeout of the search for the session
};

/// Connection to a joined session. A separate thread applies received messages to the replica, the client's
/// copy of the session, independently of rendering.
class Connection {
 public:
  /// Joins the session. Throws InputError with advice if no server was found (with the address and the
  /// available sessions), if its protocol version differs, or if the server refuses.
  Connection(const BusConfig& config, const JoinRequest& request);
  ~Connection();

  /// Returns the id of this client's user in the session. It changes when the client reconnects.
  ParticipantId participant() const { return participant_; }
  const std::string& name() const { return presence_.name; }

  /// Calls `f` with the replica, the client's copy of the session, while the network thread can't change it.
  /// Returns the result of `f`.
  template <class F>
  decltype(auto) with_replica(F&& f) {
    std::lock_guard lock(mutex_);
    return f(servers_.replica());
  }

  /// Sets the function that is called on the network thread for every message of the followed server, before
  /// the message is applied to the replica. Must be called before start().
  void on_received(std::function<void(const Received&)> f) { on_received_ = std::move(f); }
  void start();

  void publish(const HandInput& input);
  void publish(const ArmForce& force) { bus()->publish(force); }
  void command(const CommandBody& body);
  BusCounters counters() const { return bus()->counters(); }
  /// Returns and removes the server's messages to this user since the last call, in order: reasons for
  /// refused commands, and messages that answer no command.
  std::vector<std::string> take_server_messages();

 private:
  BusConfig config_;
  mutable std::mutex bus_mutex_;
  std::shared_ptr<Bus> bus_;  // access through bus(): reconnect() replaces it
  std::atomic<ParticipantId> participant_;
  Presence presence_;  // all but the participant id
  InputLossDetector unheard_;
  std::mutex mutex_;
  ServerChoice servers_;
  std::vector<std::string> words_;
  Catalogue catalogue_;
  std::atomic<std::uint64_t> command_sequence_ = 0;
  std::function<void(const Received&)> on_received_;
  std::jthread thread_;

  std::shared_ptr<Bus> bus() const;
  Presence presence() const;
  void find_session(std::chrono::milliseconds time_limit);
  void ask_to_join(std::chrono::milliseconds time_limit);
  void run(std::stop_token stop);
  void take(const std::vector<Received>& received);
  std::vector<const CommandResult*> apply(const std::vector<Received>& received);
  void rejoin_if_missing();
  bool inputs_ignored(const std::vector<Received>& received);
  void reconnect();
  void ask_for_keyframes();
};

}  // namespace prosector
