#include "idl/local_bus.h"

#include "common/clock.h"
#include "idl/local/local_hub.h"

namespace prosector {
namespace {

using Hub = LocalNetwork::Hub;

constexpr std::int64_t crash_lease_ns = 1'000'000'000;  // Presence's liveliness lease

class LocalBus final : public Bus {
 public:
  LocalBus(std::shared_ptr<Hub> hub, std::shared_ptr<Hub::End> end)
      : hub_(std::move(hub)), end_(std::move(end)) {}
  ~LocalBus() override { leave(0); }

  bool publish(const Message& message) override {
    const std::scoped_lock lock(hub_->mutex);
    return hub_->publish(*end_, message);
  }

  void dispose(const Message& message) override {
    const std::scoped_lock lock(hub_->mutex);
    hub_->dispose(*end_, message);
  }

  void take(std::vector<Received>& out) override {
    const std::scoped_lock lock(hub_->mutex);
    out.clear();
    hub_->collect_arrivals(*end_);
    for (Hub::Sample& sample : end_->arrived) accept(sample, out);
    end_->arrived.clear();
  }

  bool wait(std::chrono::milliseconds timeout) override {
    std::unique_lock lock(hub_->mutex);
    const std::int64_t deadline = monotonic_ns() + std::chrono::nanoseconds(timeout).count();
    for (;;) {
      hub_->collect_arrivals(*end_);
      if (!end_->arrived.empty()) return true;
      const std::int64_t now = monotonic_ns();
      if (hub_->config.stepped || now >= deadline) return false;
      const std::int64_t next =
          end_->in_transit.empty() ? deadline : std::min(deadline, end_->in_transit.begin()->first);
      hub_->changed.wait_for(lock, std::chrono::nanoseconds(next - now));
    }
  }

  BusCounters counters() const override { return end_->counters.read(); }

  void leave(std::int64_t noticed_after_ns) {
    const std::scoped_lock lock(hub_->mutex);
    hub_->leave(*end_, noticed_after_ns);
  }

 private:
  void accept(Hub::Sample& sample, std::vector<Received>& out) {
    const std::size_t topic = sample.received.message.index();
    end_->counters.received(sample.bytes);
    if (sample.received.liveness == Liveness::alive) {
      if (!end_->gate.admits(topic, sample.received.writer, sample.received.arrival_ns)) {
        end_->counters.dropped(topic, "too many per second");
        return;
      }
      if (topics[topic].notifies_end) end_->claims.said(sample.received.writer, sample.received.message);
      end_->counters.taken();
    } else if (!end_->claims.ended(sample.received.writer, sample.received.message)) {
      end_->counters.dropped(
          topic, "end of an instance ignored: it was reported by a process that did not write the instance");
      return;
    }
    out.push_back(std::move(sample.received));
  }

  std::shared_ptr<Hub> hub_;
  std::shared_ptr<Hub::End> end_;
};

}  // namespace

LocalNetwork::LocalNetwork(const LocalNetworkConfig& config) : hub_(std::make_shared<Hub>(config)) {}
LocalNetwork::~LocalNetwork() = default;

std::unique_ptr<Bus> LocalNetwork::join(const BusConfig& config) {
  const std::scoped_lock lock(hub_->mutex);
  return std::make_unique<LocalBus>(hub_, hub_->join(config));
}

void LocalNetwork::crash(Bus& bus) {
  dynamic_cast<LocalBus&>(bus).leave(crash_lease_ns);
}

void LocalNetwork::advance(std::chrono::nanoseconds time) {
  const std::scoped_lock lock(hub_->mutex);
  hub_->stepped_ns += time.count();
  hub_->changed.notify_all();
}

std::int64_t LocalNetwork::now_ns() const {
  const std::scoped_lock lock(hub_->mutex);
  return hub_->now();
}

}  // namespace prosector
