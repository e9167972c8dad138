#include "idl/dds/writer_ids.h"

#include "common/hash.h"

namespace prosector {

std::uint64_t WriterIds::of(dds_entity_t reader, dds_instance_handle_t publication) {
  if (const auto it = known_.find(publication); it != known_.end()) return it->second;
  dds_builtintopic_endpoint_t* endpoint = dds_get_matched_publication_data(reader, publication);
  if (endpoint == nullptr) return 0;
  StateHasher hasher;
  hasher.add(std::as_bytes(std::span(endpoint->participant_key.v)));
  dds_builtintopic_free_endpoint(endpoint);
  // Handles are never used again: a table that has seen very many writers starts over.
  constexpr std::size_t many = 65536;
  if (known_.size() >= many) known_.clear();
  const std::uint64_t id = hasher.digest() | 1;  // never 0
  known_.emplace(publication, id);
  return id;
}

}  // namespace prosector
