#pragma once
// What of this machine bears a session well, and what doesn't, in words that say what to do.

#include <filesystem>
#include <string>
#include <vector>

#include "client/language/catalogue.h"

namespace prosector {

enum class CheckState : std::uint8_t { unknown, good, fair, bad };

struct MachineCheck {
  std::string name;
  CheckState state = CheckState::unknown;
  std::string words;
};

/// Where the system says how much a socket may keep, bytes.
inline constexpr const char* network_buffer_limit = "/proc/sys/net/core/rmem_max";

/// Judges the median time of a picture of a small scene, s, drawn at that quality by that OpenGL.
MachineCheck check_pictures(double seconds, const std::string& opengl, const Catalogue& words = {});
/// Asks for a real-time priority on a thread that ends at once: haptic arms want one.
MachineCheck check_real_time(const Catalogue& words = {});
/// Looks whether the system's clock is kept by a server of time: journals of several machines are compared
/// by it.
MachineCheck check_clock(const Catalogue& words = {});
/// Looks how much the system lets a socket keep, bytes, which bursts of a large scene need on a network.
MachineCheck check_network_buffers(const std::filesystem::path& limit = network_buffer_limit,
                                   const Catalogue& words = {});
/// Looks whether there are cores enough for a server and a client.
MachineCheck check_cores(unsigned cores, const Catalogue& words = {});
/// Looks for the anatomy that shipped scenes are made of.
MachineCheck check_anatomy(const std::filesystem::path& data, const Catalogue& words = {});

}  // namespace prosector
