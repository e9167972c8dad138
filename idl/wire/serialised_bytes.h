#pragma once
// How large a sample is on the wire.

#include <cstddef>

struct dds_topic_descriptor;

namespace prosector {

/// Returns the bytes that a sample is serialised to (CDR, OMG DDSI-RTPS 2.3, 10.2), without the 4 of its
/// header and the padding at its end. Follows Cyclone's instructions for the type, which idlc made of
/// prosector.idl, so that no field can be forgotten. Throws InternalError for kinds of fields that no topic
/// has yet.
std::size_t serialised_bytes(const dds_topic_descriptor& type, const void* sample);

}  // namespace prosector
