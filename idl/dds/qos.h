#pragma once
// Conversion of a topic's table row to DDS quality of service, used by its writers and readers.

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
/// Returns the QoS of a DDS publisher or subscriber of the session. A session is a DDS partition; "*" matches
/// all sessions.
Qos partition_qos(const std::string& session);

}  // namespace prosector
