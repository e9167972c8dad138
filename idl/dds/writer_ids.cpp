#include "idl/dds/writer_ids.h"

#include "common/hash.h"

namespace prosector {
namespace {

constexpr std::size_t many_writers = 65536;  // handles are never reused, so a table of them only grows

/// Returns the id of the writer's process; 0 if the reader isn't matched with this writer, or no longer.
std::uint64_t matched_process(dds_entity_t reader, dds_instance_handle_t publication) {
  dds_builtintopic_endpoint_t* endpoint = dds_get_matched_publication_data(reader, publication);
  if (endpoint == nullptr) return 0;
  StateHasher hasher;
  hasher.add(std::as_bytes(std::span(endpoint->participant_key.v)));
  dds_builtintopic_free_endpoint(endpoint);
  return hasher.digest() | 1;  // never 0
}

}  // namespace

std::uint64_t WriterIds::of(dds_entity_t reader, dds_instance_handle_t publication) {
  if (const auto it = known_.find(publication); it != known_.end()) return it->second.id;
  const std::uint64_t id = matched_process(reader, publication);
  if (id == 0) return 0;
  if (known_.size() >= many_writers) forget_departed();
  if (known_.size() < many_writers) known_.emplace(publication, Writer{id, reader});
  return id;
}

void WriterIds::forget_departed() {
  std::erase_if(known_,
                [](const auto& entry) { return matched_process(entry.second.reader, entry.first) == 0; });
}

std::vector<std::uint64_t> WriterIds::present(dds_entity_t reader) {
  std::vector<dds_instance_handle_t> handles(64);
  dds_return_t count = dds_get_matched_publications(reader, handles.data(), handles.size());
  while (count > static_cast<dds_return_t>(handles.size())) {
    handles.resize(static_cast<std::size_t>(count));
    count = dds_get_matched_publications(reader, handles.data(), handles.size());
  }
  std::vector<std::uint64_t> ids;
  for (dds_return_t i = 0; i < count; ++i)
    if (const std::uint64_t id = of(reader, handles[static_cast<std::size_t>(i)]); id != 0) ids.push_back(id);
  return ids;
}

}  // namespace prosector
