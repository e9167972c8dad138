#include "client/app/session/connection.h"

#include <fmt/format.h>

#include <random>
#include <utility>

#include "client/app/session/no_session.h"
#include "common/clock.h"
#include "common/error.h"
#include "idl/cyclone_bus.h"

namespace prosector {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds poll_interval{20};
constexpr std::chrono::milliseconds rejoin_interval{
    300};                                      // The server accepts Presence at most five times a second.
constexpr std::chrono::seconds leave_time{1};  // until the server has noticed that the old connection ended

ParticipantId draw_participant_id() {
  std::random_device entropy;
  ParticipantId id = 0;
  while (id == 0) id = (ParticipantId{entropy()} << 32) | entropy();
  return id;
}

}  // namespace

Connection::Connection(const BusConfig& config, const JoinRequest& request)
    : config_(config),
      bus_(make_cyclone_bus(config)),
      participant_(draw_participant_id()),
      presence_{.participant = 0,
                .name = request.name,
                .role = request.role,
                .devices = request.devices,
                .arms = request.arms},
      servers_(request.language),
      catalogue_(catalogue_for(request.language)) {
  find_session(request.time_limit);
  ask_to_join(request.time_limit);
}

Connection::~Connection() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  command(Leave{});
  bus_->dispose(presence());
}

std::shared_ptr<Bus> Connection::bus() const {
  std::lock_guard lock(bus_mutex_);
  return bus_;
}

Presence Connection::presence() const {
  Presence out = presence_;
  out.participant = participant_;
  return out;
}

void Connection::publish(const HandInput& input) {
  unheard_.sent();
  bus()->publish(input);
}

/// Waits for the session. If discovery shows that it runs, waits for the timeout once more.
void Connection::find_session(std::chrono::milliseconds time_limit) {
  auto deadline = Clock::now() + time_limit;
  bool looked_around = false;
  std::vector<Received> received;
  while (!servers_.replica().session()) {
    if (Clock::now() > deadline) {
      const std::vector<SessionInfo> found = list_sessions(config_, std::chrono::milliseconds(600));
      if (looked_around || !is_among(config_, found))
        throw InputError(session_not_found_text(config_, 2 * time_limit, found));
      looked_around = true;
      deadline = Clock::now() + time_limit;
    }
    bus_->wait(poll_interval);
    bus_->take(received);
    apply(received);
  }
  const SessionInfo& session = *servers_.replica().session();
  if (session.version != protocol_version)
    throw InputError(fmt::format(
        "session '{}' speaks protocol version {}, this client speaks {}: install the same release on both",
        session.session, session.version, protocol_version));
}

// The command may overtake the presence, or be lost while a server's readers are still matching: ask
// repeatedly until the server answers.
void Connection::ask_to_join(std::chrono::milliseconds time_limit) {
  const auto deadline = Clock::now() + time_limit;
  auto next_try = Clock::now();
  std::vector<Received> received;
  while (Clock::now() < deadline) {
    if (Clock::now() >= next_try) {
      bus_->publish(presence());
      command(Join{});
      next_try = Clock::now() + std::chrono::milliseconds(500);
    }
    bus_->wait(poll_interval);
    bus_->take(received);
    const std::vector<const CommandResult*> answers = apply(received);
    if (answers.empty()) continue;
    const CommandResult* answer = answers.back();
    if (answer->accepted) return;
    throw InputError(fmt::format("session '{}' refused {}: {}", servers_.replica().session()->session,
                                 presence_.name, answer->reason));
  }
  throw InputError(fmt::format("session '{}' was found but did not answer within {} s: check its server",
                               servers_.replica().session()->session,
                               static_cast<double>(time_limit.count()) / 1e3));
}

/// Applies a batch of samples. Returns the followed server's answers to this client's commands.
std::vector<const CommandResult*> Connection::apply(const std::vector<Received>& received) {
  for (const Received& r : received) servers_.apply(r);
  std::vector<const CommandResult*> answers;
  for (const Received& r : received) {
    const auto* result = std::get_if<CommandResult>(&r.message);
    const bool ours = result != nullptr && result->participant == participant_;
    if (ours && r.writer == servers_.followed()) answers.push_back(result);
  }
  return answers;
}

void Connection::start() {
  thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
}

void Connection::run(std::stop_token stop) {
  std::vector<Received> received;
  auto next_check = Clock::now() + rejoin_interval;
  while (!stop.stop_requested()) {
    if (Clock::now() > next_check) {
      rejoin_if_missing();
      next_check = Clock::now() + rejoin_interval;
    }
    ask_for_keyframes();
    const std::shared_ptr<Bus> bus = this->bus();
    if (!bus->wait(std::chrono::milliseconds(100))) continue;
    bus->take(received);
    const std::uint64_t followed = servers_.followed();
    if (on_received_)
      for (const Received& r : received)
        if (r.writer == followed) on_received_(r);
    take(received);
    if (!inputs_ignored(received)) continue;
    reconnect();
    next_check = Clock::now() + leave_time;
  }
}

void Connection::take(const std::vector<Received>& received) {
  std::lock_guard lock(mutex_);
  for (const CommandResult* answer : apply(received))
    if (!answer->accepted)
      words_.push_back(answer->sequence == 0
                           ? catalogue_.tr(answer->reason)
                           : catalogue_.tr("the server refused: {}", catalogue_.tr(answer->reason)));
}

// After a network failure or a server restart the roster lacks this client: publish the presence and join
// again.
void Connection::rejoin_if_missing() {
  const bool forgotten = with_replica([&](const Replica& r) {
    return r.session() && !r.server_gone() && !r.roster().contains(participant_);
  });
  if (!forgotten) return;
  bus()->publish(presence());
  command(Join{});
}

/// Reports whether, according to the received samples, the server no longer consumes this user's inputs.
bool Connection::inputs_ignored(const std::vector<Received>& received) {
  const bool takes_part = with_replica([&](const Replica& r) {
    const auto own = r.roster().find(participant_);
    return own != r.roster().end() && own->second.role != Role::observer && r.time().pace() > 0;
  });
  bool unheard = false;
  for (const Received& r : received) {
    if (r.writer != servers_.followed() || r.liveness == Liveness::gone) continue;
    const auto* user = std::get_if<UserState>(&r.message);
    if (user != nullptr && user->participant == participant_) unheard_.take_consumed(user->input_sequence);
    if (std::holds_alternative<ServerStatus>(r.message))
      unheard |= unheard_.take_status(r.arrival_ns, takes_part);
  }
  return unheard;
}

/// Leaves the session and joins with new DDS writers, like a new process.
void Connection::reconnect() {
  std::shared_ptr<Bus> other;
  try {
    other = make_cyclone_bus(config_);
  } catch (const InputError& error) {
    std::lock_guard lock(mutex_);
    words_.push_back(catalogue_.tr(
        "the server no longer receives your hands, and the client cannot reconnect: {}", error.what()));
    return;
  }
  const Presence old = presence();
  {
    std::lock_guard lock(bus_mutex_);
    std::swap(bus_, other);
    participant_ = draw_participant_id();  // the server associates the old id with the old writers
  }
  other->dispose(old);
  Received end{RosterEntry{}, Liveness::gone, servers_.followed()};
  std::get<RosterEntry>(end.message).participant = old.participant;
  std::lock_guard lock(mutex_);
  servers_.apply(end);
  words_.push_back(catalogue_.tr("the server no longer received your hands: the client has reconnected"));
}

// Requests keyframes of the bodies whose replica does not match the server's topology.
void Connection::ask_for_keyframes() {
  const std::vector<BodyId> bodies =
      with_replica([](Replica& replica) { return replica.bodies().take_keyframe_requests(monotonic_ns()); });
  for (const BodyId body : bodies) command(RequestKeyframe{body});
}

void Connection::command(const CommandBody& body) {
  const ParticipantId participant = participant_;
  bus()->publish(Command{participant, ++command_sequence_, body});
}

std::vector<std::string> Connection::take_server_messages() {
  std::lock_guard lock(mutex_);
  return std::exchange(words_, {});
}

}  // namespace prosector
