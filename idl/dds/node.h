#pragma once
// This process's place in the star: its own DDS domain instance with exactly the configured network, and one
// participant in it.

#include <mutex>

#include "idl/bus.h"
#include "idl/dds/entity.h"

namespace prosector {

/// Returns the mutex that serialises creating and deleting local entities: Cyclone DDS 0.10 has races there.
std::mutex& entity_mutex();

struct Node {
  /// Throws InputError when the network can't be opened as configured. Call with entity_mutex() held.
  explicit Node(const BusConfig& config);

  Entity domain;
  Entity participant;
};

}  // namespace prosector
