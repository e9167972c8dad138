#pragma once
// DDS domain and participant of this process: a separate domain instance with exactly the configured network,
// and one participant in it.

#include <mutex>

#include "idl/bus.h"
#include "idl/dds/entity.h"

namespace prosector {

/// Returns the mutex that must be held to create or delete DDS entities of this process, because Cyclone DDS
/// 0.10 has race conditions there.
std::mutex& entity_mutex();

struct Node {
  /// Creates the DDS domain and participant for the configured network. Throws InputError if the network
  /// can't be opened as configured. Requires entity_mutex() to be held.
  explicit Node(const BusConfig& config);

  Entity domain;
  Entity participant;
};

}  // namespace prosector
