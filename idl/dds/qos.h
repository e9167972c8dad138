#pragma once
// A topic's row as DDS quality of service, the same for its writers and readers.

#include <dds/dds.h>

#include <memory>
#include <string>

#include "idl/topics.h"

namespace prosector {

struct QosDeleter {
  void operator()(dds_qos_t* qos) const { dds_delete_qos(qos); }
};
using Qos = std::unique_ptr<dds_qos_t, QosDeleter>;

Qos endpoint_qos(const TopicSpec& topic);
/// Makes the QoS of a publisher or subscriber: one session is one partition; "*" hears them all.
Qos partition_qos(const std::string& session);

}  // namespace prosector
