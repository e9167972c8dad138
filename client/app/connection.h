#pragma once
// Finding a session, being let in, and leaving it.

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "client/app/unheard_inputs.h"
#include "client/replica/server_choice.h"
#include "idl/bus.h"

namespace prosector {

struct JoinRequest {
  std::string name;
  Role role = Role::observer;
  std::string devices;
  std::uint8_t arms = 0;                     // as Presence::arms
  std::string language;                      // tag of the names that are shown; empty: the scene's own
  std::chrono::milliseconds patience{5000};  // how long to look for the session
};

/// A joined session: a thread takes samples into the replica as they arrive, whatever the drawing does.
class Connection {
 public:
  /// Joins. Throws InputError with what to do: no server found (and where it looked, and which sessions there
  /// are), another protocol version, refused by the server and why.
  Connection(const BusConfig& config, const JoinRequest& request);
  ~Connection();

  /// Returns this user's id in the session. Reconnecting changes it.
  ParticipantId participant() const { return participant_; }
  const std::string& name() const { return presence_.name; }

  /// Runs `f(replica)` while the network thread waits.
  template <class F>
  decltype(auto) with_replica(F&& f) {
    std::lock_guard lock(mutex_);
    return f(servers_.replica());
  }

  /// Sets what is called on the network thread for every sample of the server that is followed, before the
  /// replica takes it. To be set before start().
  void on_received(std::function<void(const Received&)> f) { on_received_ = std::move(f); }
  void start();

  void publish(const HandInput& input);
  void publish(const ArmForce& force) { bus()->publish(force); }
  void command(CommandKind kind, std::size_t hand);
  void command(Command command);  // participant and sequence are filled in
  BusCounters counters() const { return bus()->counters(); }
  /// Returns what the server told this user since the last call, for people, in order: why commands were
  /// refused, and what a hand lost.
  std::vector<std::string> take_words();

 private:
  BusConfig config_;
  mutable std::mutex bus_mutex_;
  std::shared_ptr<Bus> bus_;  // use bus(): it may be replaced
  std::atomic<ParticipantId> participant_;
  Presence presence_;  // but for the id
  UnheardInputs unheard_;
  std::mutex mutex_;
  ServerChoice servers_;
  std::vector<std::string> words_;
  Catalogue catalogue_;
  std::atomic<std::uint64_t> command_sequence_ = 0;
  std::function<void(const Received&)> on_received_;
  std::jthread thread_;

  std::shared_ptr<Bus> bus() const;
  Presence presence() const;
  void find_session(std::chrono::milliseconds patience);
  void ask_to_join(std::chrono::milliseconds patience);
  void run(std::stop_token stop);
  void take(const std::vector<Received>& received);
  std::vector<const CommandResult*> apply(const std::vector<Received>& received);
  void rejoin_if_forgotten();
  bool is_unheard(const std::vector<Received>& received);
  void reconnect();
  void ask_for_keyframes();
};

}  // namespace prosector
