#pragma once
// DDS domain and participant of this process: a separate domain instance with exactly the configured network,
// and one participant in it.

#include <mutex>

#include "idl/bus.h"
#include "idl/dds/entity.h"

namespace prosector {

/// Returns the mutex that serialises creation and deletion of local entities: Cyclone DDS 0.10 has races
/// there.
std::mutex& entity_mutex();

struct Node {
  /// Opens the network. Throws InputError if it can't be opened as configured. Requires entity_mutex() to be
  /// held.
  explicit Node(const BusConfig& config);

  Entity domain;
  Entity participant;
};

}  // namespace prosector
