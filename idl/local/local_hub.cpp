#include "idl/local/local_hub.h"

#include <algorithm>

#include "common/clock.h"
#include "common/error.h"
#include "idl/wire/codec.h"

namespace prosector {

using Hub = LocalNetwork::Hub;

std::int64_t Hub::now() const {
  return config.stepped ? stepped_ns : monotonic_ns();
}

bool Hub::lost() {
  return std::uniform_real_distribution<double>(0, 1)(random) < config.loss;
}

std::int64_t Hub::transit_ns() {
  const auto delay = std::chrono::nanoseconds(config.delay).count();
  const auto jitter = std::chrono::nanoseconds(config.jitter).count();
  return std::max<std::int64_t>(0,
                                delay + std::uniform_int_distribution<std::int64_t>(-jitter, jitter)(random));
}

bool Hub::meet(const End& writer, const End& reader, std::size_t topic) {
  return &writer != &reader && reader.alive && writer.config.session == reader.config.session &&
         writer.config.domain == reader.config.domain &&
         reads(reader.config.end, reader.has_arm(), topics[topic]);
}

std::shared_ptr<Hub::End> Hub::join(const BusConfig& end_config) {
  for (const auto& other : ends)
    if (other->alive && end_config.end == BusEnd::server && other->config.end == BusEnd::server &&
        other->config.domain == end_config.domain && other->config.server_index == end_config.server_index)
      throw InputError("another server in this process already uses this domain and server index");
  auto end = std::make_shared<End>();
  end->config = end_config;
  end->id = ++last_id;
  for (const auto& other : ends) {
    if (!other->alive) continue;
    for (const auto& [key, history] : other->kept)
      if (meet(*other, *end, key.first))
        for (const Sample& sample : history) send(*end, sample);
  }
  ends.push_back(end);
  return end;
}

void Hub::send(End& to, Sample sample) {
  const std::size_t topic = sample.received.message.index();
  std::int64_t arrival = now() + transit_ns();
  if (topics[topic].reliable) {
    while (lost()) arrival += 2 * std::chrono::nanoseconds(config.delay).count() + transit_ns();
    std::int64_t& last = to.last_arrival[{sample.received.writer, topic}];
    last = arrival = std::max(arrival, last);
  } else if (lost()) {
    return;
  }
  to.in_transit.emplace(arrival, std::move(sample));
}

void Hub::send_to_readers(End& from, const Sample& sample) {
  for (const auto& to : ends)
    if (meet(from, *to, sample.received.message.index())) send(*to, sample);
  changed.notify_all();
}

bool Hub::publish(End& from, const Message& message) {
  const std::size_t topic = message.index();
  const TopicSpec& spec = topics[topic];
  const auto refused = [&](const Refusal& why) {
    from.counters.dropped(topic, why);
    return false;
  };
  if (!from.alive || !writes(from.config.end, from.has_arm(), spec))
    return refused("message not sent: this program has no right to write this topic");
  const auto hears = [&](const auto& to) { return meet(from, *to, topic); };
  if (spec.requires_reader && std::ranges::none_of(ends, hears))
    return refused("message not sent: no server is connected that could receive it");
  Sample sample;
  if (const Refusal refusal = through_the_wire(message, sample.received.message, sample.bytes))
    return refused(refusal);
  sample.received.writer = from.id;
  sample.sequence = ++from.written[{topic, lane(message)}];
  from.counters.published(sample.bytes);
  if (spec.transient_local) {
    auto& history = from.kept[{topic, instance_key(message)}];
    history.push_back(sample);
    if (spec.depth != 0 && history.size() > spec.depth) history.pop_front();
  }
  send_to_readers(from, sample);
  return true;
}

void Hub::dispose(End& from, const Message& message) {
  const std::size_t topic = message.index();
  if (!writes(from.config.end, from.has_arm(), topics[topic])) return;
  from.kept.erase({topic, instance_key(message)});
  if (!topics[topic].notifies_end) return;
  Sample sample;
  sample.received = {key_only(message), Liveness::gone, from.id, 0};
  sample.sequence = ++from.written[{topic, lane(message)}];
  send_to_readers(from, sample);
}

void Hub::leave(End& from, std::int64_t noticed_after_ns) {
  if (!from.alive) return;
  const auto kept = std::exchange(from.kept, {});
  for (const auto& [key, history] : kept) {
    if (!topics[key.first].notifies_end) continue;
    Sample sample;
    sample.received = {key_only(history.back().received.message), Liveness::gone, from.id, 0};
    sample.sequence = ++from.written[{key.first, lane(sample.received.message)}];
    const std::int64_t at = now() + noticed_after_ns + transit_ns();
    for (const auto& to : ends)
      if (meet(from, *to, key.first)) to->in_transit.emplace(at, sample);
  }
  from.alive = false;
  std::erase_if(ends, [&from](const auto& end) { return end.get() == &from; });
  changed.notify_all();
}

void Hub::collect_arrivals(End& end) {
  while (!end.in_transit.empty() && end.in_transit.begin()->first <= now()) {
    auto first = end.in_transit.extract(end.in_transit.begin());
    first.mapped().received.arrival_ns = first.key();
    deliver(end, std::move(first.mapped()));
  }
}

void Hub::deliver(End& to, Sample sample) {
  const std::size_t topic = sample.received.message.index();
  const TopicSpec& spec = topics[topic];
  std::uint64_t& last = to.last_sequence[{sample.received.writer, topic, lane(sample.received.message)}];
  if (!spec.reliable && sample.sequence < last) return;  // overtaken by a later sample
  last = std::max(last, sample.sequence);
  if (sample.received.liveness == Liveness::alive && spec.depth != 0) {
    const auto same_instance = [&](const Sample& other) {
      return other.received.message.index() == topic && other.received.liveness == Liveness::alive &&
             instance_key(other.received.message) == instance_key(sample.received.message);
    };
    if (static_cast<std::uint32_t>(std::ranges::count_if(to.arrived, same_instance)) >= spec.depth)
      to.arrived.erase(std::ranges::find_if(to.arrived, same_instance));
  }
  to.arrived.push_back(std::move(sample));
}

}  // namespace prosector
