#include "idl/dds/qos.h"

namespace prosector {
namespace {

constexpr dds_duration_t max_blocking = DDS_MSECS(500);

}  // namespace

Qos endpoint_qos(const TopicSpec& topic) {
  Qos qos(dds_create_qos());
  const dds_history_kind_t history = topic.depth == 0 ? DDS_HISTORY_KEEP_ALL : DDS_HISTORY_KEEP_LAST;
  const auto depth = static_cast<std::int32_t>(topic.depth);
  dds_qset_reliability(qos.get(), topic.reliable ? DDS_RELIABILITY_RELIABLE : DDS_RELIABILITY_BEST_EFFORT,
                       max_blocking);
  dds_qset_history(qos.get(), history, depth);
  dds_qset_durability(qos.get(),
                      topic.transient_local ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
  // This setting, not the history above, determines the samples that late joiners receive.
  if (topic.transient_local)
    dds_qset_durability_service(qos.get(), 0, history, depth, DDS_LENGTH_UNLIMITED, DDS_LENGTH_UNLIMITED,
                                DDS_LENGTH_UNLIMITED);
  if (topic.lease > 0)
    dds_qset_liveliness(qos.get(), DDS_LIVELINESS_AUTOMATIC, static_cast<dds_duration_t>(topic.lease * 1e9));
  return qos;
}

Qos partition_qos(const std::string& session) {
  Qos qos(dds_create_qos());
  dds_qset_partition1(qos.get(), session.c_str());
  return qos;
}

}  // namespace prosector
