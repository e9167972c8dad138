#pragma once
// Checkpoints. Loading builds the rigid world anew from plain numbers, so whatever Bullet caches is a
// function of them. A run that goes on after a checkpoint and one that restores it are equal.

#include <cstdint>
#include <span>

#include "common/byte_stream.h"
#include "server/physics/state.h"

namespace prosector {

/// Writes the state as it is.
void save(const State& state, ByteWriter& out);
/// Puts a saved state in place of this one. Throws InputError, and changes nothing, for bytes that are none
/// of this scene.
void load(State& state, std::span<const std::uint8_t> bytes);
/// Returns a hash over every bit that changes the next tick.
std::uint64_t hash_of(const State& state);

}  // namespace prosector
