#pragma once
// Process ids of remote writers, hashed from the GUID of the remote participant.

#include <dds/dds.h>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace prosector {

class WriterIds {
 public:
  /// Returns the id of the remote process whose writer published a sample; `publication` is the writer's
  /// handle in this reader. Returns 0 if the writer is gone and was never seen before.
  std::uint64_t of(dds_entity_t reader, dds_instance_handle_t publication);
  /// Returns the ids of the remote processes whose writers currently match this reader.
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
