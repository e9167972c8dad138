#include "idl/cyclone_bus.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <optional>

#include "common/clock.h"
#include "common/session_name.h"
#include "idl/counters.h"
#include "idl/dds/node.h"
#include "idl/dds/qos.h"
#include "idl/dds/writer_ids.h"
#include "idl/instance_owners.h"
#include "idl/rate_gate.h"
#include "idl/wire/codec.h"

namespace prosector {
namespace {

constexpr std::uint32_t samples_per_take = 64;

struct Endpoint {
  Entity topic;
  std::vector<Entity> writers;  // one per lane
  Entity reader, arrived;       // arrived: read condition, true while the reader has samples
};

class CycloneBus final : public Bus {
 public:
  /// Joins the network; requires entity_mutex() to be held.
  explicit CycloneBus(const BusConfig& config);
  ~CycloneBus() override;

  bool publish(const Message& message) override;
  void dispose(const Message& message) override;
  void take(std::vector<Received>& out) override;
  bool wait(std::chrono::milliseconds timeout) override;
  BusCounters counters() const override { return counters_.read(); }

 private:
  void open(std::size_t topic, bool arm);
  void open_for_arms();
  void take_topic(std::size_t topic, std::vector<Received>& out);
  void take_samples(std::size_t topic, std::vector<Received>& out);
  void end_instances_of(std::size_t topic, std::uint64_t writer, std::vector<Received>& out);
  void accept(std::size_t topic, const void* sample, const dds_sample_info_t& info,
              std::vector<Received>& out);
  Refusal accept_data(std::size_t topic, const void* sample, Received& received);
  dds_entity_t writer_of(const Message& message) const;
  bool has_no_reader(dds_entity_t writer) const;

  const BusConfig config_;
  std::unique_ptr<Node> node_;
  Entity publisher_, subscriber_;
  Entity waiting_;  // wait set for the readers; destroyed before node_
  std::array<Endpoint, topic_count> endpoints_;
  std::atomic<bool> arms_;  // whether endpoints for arms exist
  std::mutex take_mutex_;   // protects the three members below
  WriterIds writer_ids_;
  InstanceOwners claims_;
  RateGate gate_;
  EdgeCounters counters_;
};

CycloneBus::CycloneBus(const BusConfig& config)
    : config_(config), node_(std::make_unique<Node>(config)), arms_(config.arm) {
  const dds_entity_t participant = node_->participant.get();
  const Qos partition = partition_qos(config.session);
  publisher_ = Entity(dds_create_publisher(participant, partition.get(), nullptr), "publisher");
  subscriber_ = Entity(dds_create_subscriber(participant, partition.get(), nullptr), "subscriber");
  waiting_ = Entity(dds_create_waitset(participant), "waitset");
  for (std::size_t i = 0; i < topic_count; ++i) open(i, config.arm);
}

/// Creates the entities that this end needs for the topic.
void CycloneBus::open(std::size_t topic, bool arm) {
  const TopicSpec& spec = topics[topic];
  const bool in = reads(config_.end, arm, spec), out = writes(config_.end, arm, spec);
  if (!in && !out) return;
  Endpoint& endpoint = endpoints_[topic];
  const Qos qos = endpoint_qos(spec);
  endpoint.topic = Entity(
      dds_create_topic(node_->participant.get(), wire_codec(topic).descriptor, spec.name, nullptr, nullptr),
      spec.name);
  for (std::uint32_t k = 0; out && k < spec.lanes; ++k)
    endpoint.writers.emplace_back(
        dds_create_writer(publisher_.get(), endpoint.topic.get(), qos.get(), nullptr), spec.name);
  if (!in) return;
  endpoint.reader =
      Entity(dds_create_reader(subscriber_.get(), endpoint.topic.get(), qos.get(), nullptr), spec.name);
  endpoint.arrived = Entity(dds_create_readcondition(endpoint.reader.get(), DDS_ANY_STATE), spec.name);
  dds_waitset_attach(waiting_.get(), endpoint.arrived.get(), 0);
}

/// Opens a server's endpoints of the topics for arms, once a participant has an arm.
void CycloneBus::open_for_arms() {
  const std::scoped_lock lock(entity_mutex());
  for (std::size_t i = 0; i < topic_count; ++i)
    if (topics[i].for_arms) open(i, true);
  arms_ = true;  // from now on publish(), on its own thread, may access them
}

CycloneBus::~CycloneBus() {
  const std::scoped_lock lock(entity_mutex());
  waiting_ = {};
  node_.reset();  // deletes the domain and all its entities
}

/// Returns the writer for the message; 0 if this end doesn't write the topic.
dds_entity_t CycloneBus::writer_of(const Message& message) const {
  if (topics[message.index()].for_arms && !arms_) return 0;
  const std::vector<Entity>& writers = endpoints_[message.index()].writers;
  return writers.empty() ? 0 : writers[lane(message)].get();
}

bool CycloneBus::has_no_reader(dds_entity_t writer) const {
  dds_publication_matched_status_t status{};
  return dds_get_publication_matched_status(writer, &status) != DDS_RETCODE_OK || status.current_count == 0;
}

bool CycloneBus::publish(const Message& message) {
  const std::size_t topic = message.index();
  const dds_entity_t writer = writer_of(message);
  const auto refused = [&](const Refusal& why) {
    counters_.dropped(topic, why);
    return false;
  };
  if (writer == 0) return refused("message not sent: this program has no right to write this topic");
  if (topics[topic].requires_reader && has_no_reader(writer))
    return refused("message not sent: no server is connected that could receive it");
  WireArena arena;
  void* sample = nullptr;
  if (const Refusal refusal = wire_codec(topic).encode(message, arena, sample)) return refused(refusal);
  if (dds_write(writer, sample) != DDS_RETCODE_OK) return refused("timed out before sending");
  counters_.published(wire_codec(topic).payload_bytes(sample));
  return true;
}

void CycloneBus::dispose(const Message& message) {
  const dds_entity_t writer = writer_of(message);
  WireArena arena;
  void* sample = nullptr;
  if (writer == 0 || wire_codec(message.index()).encode(message, arena, sample)) return;
  dds_dispose(writer, sample);
  dds_unregister_instance(writer, sample);  // otherwise the instance would be stored for late joiners forever
}

void CycloneBus::take(std::vector<Received>& out) {
  const std::scoped_lock lock(take_mutex_);
  out.clear();
  for (std::size_t i = 0; i < topic_count; ++i)
    if (endpoints_[i].reader) take_topic(i, out);
  const auto has_arm = [](const Received& r) {
    const auto* presence = std::get_if<Presence>(&r.message);
    return presence != nullptr && presence->arms != 0;
  };
  if (!arms_ && std::any_of(out.begin(), out.end(), has_arm)) open_for_arms();
}

void CycloneBus::take_topic(std::size_t topic, std::vector<Received>& out) {
  if (!topics[topic].notifies_end) return take_samples(topic, out);
  // A process that is absent before the samples are taken can't have newer samples afterwards.
  const std::vector<std::uint64_t> present = writer_ids_.present(endpoints_[topic].reader.get());
  const std::vector<std::uint64_t> departed = claims_.absent(topic, present);
  take_samples(topic, out);
  for (const std::uint64_t writer : departed) end_instances_of(topic, writer, out);
}

void CycloneBus::end_instances_of(std::size_t topic, std::uint64_t writer, std::vector<Received>& out) {
  std::vector<Message> instances;
  claims_.end_all(topic, writer, instances);
  for (Message& instance : instances)
    out.push_back({std::move(instance), Liveness::gone, writer, monotonic_ns()});
}

void CycloneBus::take_samples(std::size_t topic, std::vector<Received>& out) {
  const dds_entity_t reader = endpoints_[topic].reader.get();
  for (;;) {
    std::array<void*, samples_per_take> samples{};  // null: Cyclone lends its own buffers
    std::array<dds_sample_info_t, samples_per_take> infos;
    const dds_return_t count = dds_take(reader, samples.data(), infos.data(), samples.size(),
                                        static_cast<std::uint32_t>(samples.size()));
    if (count <= 0) return;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      accept(topic, samples[i], infos[i], out);
    dds_return_loan(reader, samples.data(), count);
    if (static_cast<std::size_t>(count) < samples.size()) return;
  }
}

void CycloneBus::accept(std::size_t topic, const void* sample, const dds_sample_info_t& info,
                        std::vector<Received>& out) {
  const WireCodec& codec = wire_codec(topic);
  Received received;
  received.arrival_ns = monotonic_ns();
  received.writer = writer_ids_.of(endpoints_[topic].reader.get(), info.publication_handle);
  if (info.valid_data) {
    counters_.received(codec.payload_bytes(sample));
    if (const Refusal refusal = accept_data(topic, sample, received)) {
      counters_.dropped(topic, refusal);
    } else {
      counters_.taken();
      out.push_back(received);
    }
  }
  const bool last_of_instance = info.sample_rank == 0;
  if (topics[topic].notifies_end && info.instance_state != DDS_IST_ALIVE && last_of_instance) {
    codec.decode_key(sample, received.message);
    received.liveness = Liveness::gone;
    if (claims_.ended(received.writer, received.message))
      out.push_back(std::move(received));
    else
      counters_.dropped(
          topic, "end of an instance ignored: it was reported by a process that did not write the instance");
  }
}

Refusal CycloneBus::accept_data(std::size_t topic, const void* sample, Received& received) {
  const TopicSpec& spec = topics[topic];
  if (received.writer == 0 && spec.writers != Writers::server)
    return "message discarded: it is from a process that has left the network";
  if (!gate_.admits(topic, received.writer, received.arrival_ns)) return "too many per second";
  if (const Refusal refusal = wire_codec(topic).decode(sample, received.message)) return refusal;
  if (spec.notifies_end && !claims_.said(received.writer, received.message))
    return "message discarded: its process has written too many instances of this topic";
  return {};
}

bool CycloneBus::wait(std::chrono::milliseconds timeout) {
  return dds_waitset_wait(waiting_.get(), nullptr, 0, std::chrono::nanoseconds(timeout).count()) > 0;
}

}  // namespace

std::unique_ptr<Bus> make_cyclone_bus(const BusConfig& config) {
  check_session_name(config.session);
  const std::scoped_lock lock(entity_mutex());
  return std::make_unique<CycloneBus>(config);
}

}  // namespace prosector
