#include "client/app/connection.h"

#include <fmt/format.h>

#include <random>
#include <utility>

#include "client/app/no_session.h"
#include "common/clock.h"
#include "common/error.h"
#include "idl/cyclone_bus.h"

namespace prosector {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds poll_interval{20};
constexpr std::chrono::milliseconds rejoin_interval{300};  // Presence may be said five times a second
constexpr std::chrono::seconds leave_time{1};  // until the server knows that an old connection ended

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
  find_session(request.patience);
  ask_to_join(request.patience);
}

Connection::~Connection() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
  command(CommandKind::leave, right_hand);
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

/// Waits for the session. Where a look around finds that it runs, it is waited for as long again.
void Connection::find_session(std::chrono::milliseconds patience) {
  auto deadline = Clock::now() + patience;
  bool looked_around = false;
  std::vector<Received> received;
  while (!servers_.replica().session()) {
    if (Clock::now() > deadline) {
      const std::vector<SessionInfo> found = list_sessions(config_, std::chrono::milliseconds(600));
      if (looked_around || !is_among(config_, found))
        throw InputError(no_session_text(config_, 2 * patience, found));
      looked_around = true;
      deadline = Clock::now() + patience;
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

// The command may overtake the presence, or be lost to a server that is just matching: ask again until
// answered.
void Connection::ask_to_join(std::chrono::milliseconds patience) {
  const auto deadline = Clock::now() + patience;
  auto next_try = Clock::now();
  std::vector<Received> received;
  while (Clock::now() < deadline) {
    if (Clock::now() >= next_try) {
      bus_->publish(presence());
      command(CommandKind::join, right_hand);
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
  throw InputError(fmt::format("session '{}' was found but did not answer within {} s: is its server stuck?",
                               servers_.replica().session()->session,
                               static_cast<double>(patience.count()) / 1e3));
}

/// Takes a batch; returns the answers to commands of ours by the server that is followed then.
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
      rejoin_if_forgotten();
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
    if (!is_unheard(received)) continue;
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

// After the network was cut, or the server started again, the roster is without us: say again who we are.
void Connection::rejoin_if_forgotten() {
  const bool forgotten = with_replica([&](const Replica& r) {
    return r.session() && !r.server_gone() && !r.roster().contains(participant_);
  });
  if (!forgotten) return;
  bus()->publish(presence());
  command(CommandKind::join, right_hand);
}

/// Tells whether the server, by what it just said, no longer consumes what this user's hands do.
bool Connection::is_unheard(const std::vector<Received>& received) {
  const bool takes_part = with_replica([&](const Replica& r) {
    const auto own = r.roster().find(participant_);
    return own != r.roster().end() && own->second.role != Role::observer && r.pace() > 0;
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

/// Leaves the session and comes back as another process would: with writers of its own.
void Connection::reconnect() {
  std::shared_ptr<Bus> other;
  try {
    other = make_cyclone_bus(config_);
  } catch (const InputError& error) {
    std::lock_guard lock(mutex_);
    words_.push_back(catalogue_.tr("the server no longer receives your hands: {}", error.what()));
    return;
  }
  const Presence old = presence();
  {
    std::lock_guard lock(bus_mutex_);
    std::swap(bus_, other);
    participant_ = draw_participant_id();  // the server ties the old one to the old writers
  }
  other->dispose(old);
  Received end{RosterEntry{}, Liveness::gone, servers_.followed()};
  std::get<RosterEntry>(end.message).participant = old.participant;
  std::lock_guard lock(mutex_);
  servers_.apply(end);
  words_.push_back(catalogue_.tr("the server no longer received your hands: reconnected"));
}

// Where what this client has of a body does not fit what the server says of it.
void Connection::ask_for_keyframes() {
  const std::vector<BodyId> bodies =
      with_replica([](Replica& replica) { return replica.take_keyframe_requests(monotonic_ns()); });
  for (const BodyId body : bodies) {
    Command ask;
    ask.kind = CommandKind::keyframe;
    ask.body = body;
    command(ask);
  }
}

void Connection::command(CommandKind kind, std::size_t hand) {
  Command out;
  out.kind = kind;
  out.hand = static_cast<std::uint8_t>(hand);
  command(out);
}

void Connection::command(Command command) {
  command.participant = participant_;
  command.sequence = ++command_sequence_;
  bus()->publish(command);
}

std::vector<std::string> Connection::take_words() {
  std::lock_guard lock(mutex_);
  return std::exchange(words_, {});
}

}  // namespace prosector
