// Session discovery before joining: a reader of SessionInfo in all partitions.

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "common/clock.h"
#include "common/error.h"
#include "common/server_run.h"
#include "idl/cyclone_bus.h"
#include "idl/dds/node.h"
#include "idl/dds/profile.h"
#include "idl/dds/qos.h"
#include "idl/host_conflict_monitor.h"
#include "idl/wire/codec.h"

namespace prosector {
namespace {

constexpr std::size_t session_info = topic_of<SessionInfo>();

class SessionListener {
 public:
  explicit SessionListener(BusConfig config, const std::string& partition) {
    config.end = BusEnd::observer;
    const std::scoped_lock lock(entity_mutex());
    node_ = std::make_unique<Node>(config);
    const dds_entity_t participant = node_->participant.get();
    const dds_entity_t subscriber =
        dds_create_subscriber(participant, partition_qos(partition).get(), nullptr);
    const TopicSpec& spec = topics[session_info];
    const dds_entity_t topic =
        dds_create_topic(participant, wire_codec(session_info).descriptor, spec.name, nullptr, nullptr);
    reader_ = dds_create_reader(subscriber, topic, endpoint_qos(spec).get(), nullptr);
    waiting_ = Entity(dds_create_waitset(participant), "waitset");
    dds_waitset_attach(waiting_.get(), dds_create_readcondition(reader_, DDS_ANY_STATE), 0);
  }
  ~SessionListener() {
    const std::scoped_lock lock(entity_mutex());
    waiting_ = {};
    node_.reset();
  }

  /// Waits until `deadline_ns` at most, then stores the received samples.
  void listen(std::int64_t deadline_ns) {
    const std::int64_t left = std::max<std::int64_t>(0, deadline_ns - monotonic_ns());
    if (dds_waitset_wait(waiting_.get(), nullptr, 0, left) <= 0) return;
    void* sample = nullptr;
    dds_sample_info_t info;
    while (dds_take(reader_, &sample, &info, 1, 1) > 0) {
      Message message;
      const bool alive = info.valid_data && info.instance_state == DDS_IST_ALIVE;
      if (!alive) {
        wire_codec(session_info).decode_key(sample, message);
        found_.erase(instance_key(message));
      } else if (!wire_codec(session_info).decode(sample, message)) {
        found_[instance_key(message)] = std::get<SessionInfo>(message);
      }
      dds_return_loan(reader_, &sample, 1);
      sample = nullptr;
    }
  }
  const std::map<InstanceKey, SessionInfo>& found() const { return found_; }

 private:
  std::unique_ptr<Node> node_;
  Entity waiting_;           // wait set for reader_; destroyed before node_
  dds_entity_t reader_ = 0;  // deleted with its domain
  std::map<InstanceKey, SessionInfo> found_;
};

std::int64_t deadline_after(std::chrono::milliseconds timeout) {
  return monotonic_ns() + std::chrono::nanoseconds(timeout).count();
}

}  // namespace

std::vector<SessionInfo> list_sessions(const BusConfig& config, std::chrono::milliseconds timeout) {
  SessionListener listener(config, "*");
  for (const std::int64_t deadline = deadline_after(timeout); monotonic_ns() < deadline;)
    listener.listen(deadline);
  std::vector<SessionInfo> sessions;
  for (const auto& [key, info] : listener.found()) sessions.push_back(info);
  std::ranges::sort(sessions, {}, &SessionInfo::session);
  return sessions;
}

struct HostConflictMonitor::Impl {
  explicit Impl(const BusConfig& config) : began_ns(monotonic_ns()) {
    listener.emplace(config, config.session);
    thread = std::jthread([this](const std::stop_token& stop) {
      while (!stop.stop_requested() && look()) {
      }
      listener.reset();  // leaves the network
    });
  }

  /// Listens for one round. Returns false when the watch ends.
  bool look() {
    constexpr std::int64_t round_ns = 20'000'000;  // between two checks for other requests to the watch
    listener->listen(monotonic_ns() + round_ns);
    const std::lock_guard lock(mutex);
    known = listener->found();
    changed.notify_all();
    if (!yield) return true;
    for (const auto& [key, info] : known) {
      if (!precedes(info.server_run, own)) continue;
      yield(info);
      return false;
    }
    return monotonic_ns() < guarded_until_ns;
  }

  std::optional<SessionListener> listener;  // used by the watch's thread only
  std::int64_t began_ns;
  mutable std::mutex mutex;  // protects all members below
  mutable std::condition_variable changed;
  std::map<InstanceKey, SessionInfo> known;
  std::function<void(const SessionInfo&)> yield;
  std::uint64_t own = 0;
  std::int64_t guarded_until_ns = 0;
  std::jthread thread;
};

HostConflictMonitor::HostConflictMonitor(const BusConfig& config) : impl_(std::make_unique<Impl>(config)) {}
HostConflictMonitor::~HostConflictMonitor() = default;

std::optional<SessionInfo> HostConflictMonitor::other(std::chrono::milliseconds time) const {
  std::unique_lock lock(impl_->mutex);
  const std::int64_t deadline = impl_->began_ns + std::chrono::nanoseconds(time).count();
  while (impl_->known.empty() && monotonic_ns() < deadline)
    impl_->changed.wait_for(lock, std::chrono::nanoseconds(deadline - monotonic_ns()));
  if (impl_->known.empty()) return std::nullopt;
  return impl_->known.begin()->second;
}

void HostConflictMonitor::guard(std::uint64_t own, std::chrono::milliseconds time,
                                std::function<void(const SessionInfo& other)> yield) {
  const std::lock_guard lock(impl_->mutex);
  impl_->own = own;
  impl_->guarded_until_ns = monotonic_ns() + std::chrono::nanoseconds(time).count();
  impl_->yield = std::move(yield);
}

std::optional<std::uint32_t> find_free_server_index(const BusConfig& config) {
  BusConfig attempt = config;
  attempt.end = BusEnd::server;
  for (attempt.server_index = 0; attempt.server_index < servers_per_host; ++attempt.server_index) {
    try {
      const std::scoped_lock lock(entity_mutex());
      const Node node(attempt);
      return attempt.server_index;
    } catch (const InputError&) {  // taken: try the next index
    }
  }
  return std::nullopt;
}

}  // namespace prosector
