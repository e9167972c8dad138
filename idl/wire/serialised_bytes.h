#pragma once
// Serialised size of a sample.

#include <cstddef>

struct dds_topic_descriptor;

namespace prosector {

/// Returns the size in bytes of the serialised sample (CDR, OMG DDSI-RTPS 2.3, 10.2), without the 4-byte
/// header and the padding at the end. Interprets the type's instructions for Cyclone DDS, which idlc
/// generates from prosector.idl, so that no field can be omitted. Throws InternalError for field types that
/// no topic uses yet.
std::size_t serialised_bytes(const dds_topic_descriptor& type, const void* sample);

}  // namespace prosector
