#pragma once
// Which process wrote a sample: a number from the GUID prefix of the remote participant.

#include <dds/dds.h>

#include <cstdint>
#include <unordered_map>

namespace prosector {

class WriterIds {
 public:
  /// 0 when the writer is gone and was never seen before.
  std::uint64_t of(dds_entity_t reader, dds_instance_handle_t publication);

 private:
  std::unordered_map<dds_instance_handle_t, std::uint64_t> known_;
};

}  // namespace prosector
