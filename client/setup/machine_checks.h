#pragma once
// Checks of this machine's suitability for sessions, with messages that state what to do.

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

/// File with the system's limit of a socket's receive buffer, bytes.
inline constexpr const char* network_buffer_limit = "/proc/sys/net/core/rmem_max";

/// Rates the median frame time of a small scene, s; `opengl`: description of the OpenGL used.
MachineCheck check_pictures(double seconds, const std::string& opengl, const Catalogue& words = {});
/// Requests a real-time priority on a temporary thread; haptic arms need one.
MachineCheck check_real_time(const Catalogue& words = {});
/// Checks whether the system's clock is synchronised with a time server. Journals of several machines are
/// compared by clock time.
MachineCheck check_clock(const Catalogue& words = {});
/// Checks the limit of sockets' receive buffers, bytes. Bursts of a large scene on a network need large
/// buffers.
MachineCheck check_network_buffers(const std::filesystem::path& limit = network_buffer_limit,
                                   const Catalogue& words = {});
/// Checks whether there are enough cores for a server and a client.
MachineCheck check_cores(unsigned cores, const Catalogue& words = {});
/// Checks whether the anatomy data of the shipped scenes is present.
MachineCheck check_anatomy(const std::filesystem::path& data, const Catalogue& words = {});

}  // namespace prosector
