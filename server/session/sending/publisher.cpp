#include "server/session/sending/publisher.h"

#include <algorithm>
#include <utility>

namespace prosector {
namespace {

constexpr std::size_t max_waiting_snapshots = 2;
constexpr std::chrono::milliseconds felt_interval{5};   // between repeats of contact planes
constexpr std::chrono::milliseconds longest_felt{250};  // older planes are not repeated: ticks have stopped

}  // namespace

Publisher::Publisher(Bus& bus, const SessionInfo& info, std::shared_ptr<const SceneContent> content)
    : bus_(bus), info_(info), content_(std::move(content)) {
  const std::vector<SceneBody>& bodies = content_->scene.bodies;
  for (BodyId b = 0; b < bodies.size(); ++b) {
    const SceneBody& body = bodies[b];
    if (body.kind == BodyKind::rigid && body.moves) rigid_.try_emplace(b, b, body.pose);
  }
  thread_ = std::thread([this] { run(); });
}

Publisher::~Publisher() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_one();
  thread_.join();
  bus_.dispose(info_);
}

void Publisher::say(std::vector<Outgoing> messages) {
  if (messages.empty()) return;
  {
    const std::lock_guard lock(mutex_);
    for (Outgoing& m : messages) messages_.push_back(std::move(m));
  }
  wake_.notify_one();
}

void Publisher::offer(std::shared_ptr<const Snapshot> snapshot) {
  {
    const std::lock_guard lock(mutex_);
    if (snapshots_.size() == max_waiting_snapshots) {
      snapshots_.pop_front();
      ++counters_.snapshots_dropped;
    }
    snapshots_.push_back(std::move(snapshot));
  }
  wake_.notify_one();
}

void Publisher::flush() {
  std::unique_lock lock(mutex_);
  idle_.wait(lock, [this] { return !busy_ && messages_.empty() && snapshots_.empty(); });
}

PublisherCounters Publisher::counters() const {
  const std::lock_guard lock(mutex_);
  return counters_;
}

void Publisher::run() {
  announce();
  std::unique_lock lock(mutex_);
  while (true) {
    busy_ = false;
    idle_.notify_all();
    const auto has_work = [this] { return stop_ || !messages_.empty() || !snapshots_.empty(); };
    while (repeats_felt() && !wake_.wait_for(lock, felt_interval, has_work)) {
      lock.unlock();
      repeat_felt();
      lock.lock();
    }
    wake_.wait(lock, has_work);
    if (messages_.empty() && snapshots_.empty()) return;
    busy_ = true;
    std::deque<Outgoing> messages;
    messages.swap(messages_);
    std::shared_ptr<const Snapshot> snapshot;
    if (!snapshots_.empty()) {
      snapshot = std::move(snapshots_.front());
      snapshots_.pop_front();
    }
    lock.unlock();
    for (const Outgoing& m : messages) {
      if (m.dispose) {
        bus_.dispose(m.message);
        continue;
      }
      newcomer_ |= std::holds_alternative<RosterEntry>(m.message);
      publish(m.message);
    }
    if (snapshot) send(*snapshot);
    lock.lock();
    if (snapshot) ++counters_.snapshots_sent;
  }
}

void Publisher::announce() {
  publish(info_);
  publish(content_->scene);
  for (const TopologyRevision& revision : content_->topology) publish(revision);
  for (const Asset& asset : content_->assets)
    for (const AssetChunk& chunk : chunks_of(asset)) publish(chunk);
}

void Publisher::send(const Snapshot& snapshot) {
  std::vector<Message> out;
  hands_.update(snapshot, newcomer_, out);
  for (const RigidSnapshot& r : snapshot.rigid)
    rigid_.at(r.body).update(r.state, snapshot.time, newcomer_, out);
  for (const SoftSnapshot& s : snapshot.soft)
    soft_.try_emplace(s.body, s.body, info_.tick_rate).first->second.update(s, snapshot.time, newcomer_, out);
  std::vector<Message> ended;
  panels_.update(snapshot, out, ended);
  for (const Message& m : ended) bus_.dispose(m);
  if (snapshot.status) out.push_back(*snapshot.status);
  newcomer_ = false;
  for (const Message& m : out) publish(m);
  felt_ = snapshot.felt;
  felt_at_ = std::chrono::steady_clock::now();
}

bool Publisher::repeats_felt() const {
  return !felt_.empty() && std::chrono::steady_clock::now() - felt_at_ < longest_felt;
}

void Publisher::repeat_felt() {
  for (const FeltPlanes& felt : felt_) publish(felt);
}

void Publisher::publish(const Message& message) {
  if (bus_.publish(message)) return;
  const std::lock_guard lock(mutex_);
  ++counters_.unsent;
}

}  // namespace prosector
