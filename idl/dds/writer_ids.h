#pragma once
// Which process wrote a sample: a number from the GUID prefix of the remote participant.

#include <dds/dds.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace prosector {

class WriterIds {
 public:
  /// Returns the writer's id; 0 when it is gone and was never seen before.
  std::uint64_t of(dds_entity_t reader, dds_instance_handle_t publication);
  /// Returns the processes whose writers this reader is matched with now.
  std::vector<std::uint64_t> present(dds_entity_t reader);

 private:
  struct Writer {
    std::uint64_t id;
    dds_entity_t reader;
  };
  std::unordered_map<dds_instance_handle_t, Writer> known_;

  void forget_departed();
};

}  // namespace prosector
