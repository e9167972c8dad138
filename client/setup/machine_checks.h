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

/// File in which the system states the upper limit of a socket's receive buffer, bytes.
inline constexpr const char* network_buffer_limit = "/proc/sys/net/core/rmem_max";

/// Rates the median time, s, that the renderer needs for a frame of a small scene. `opengl` describes the
/// OpenGL used, for the message.
MachineCheck check_pictures(double seconds, const std::string& opengl, const Catalogue& words = {});
/// Checks whether the system grants real-time priority, which the servo loop of a haptic arm needs, by
/// requesting it on a temporary thread.
MachineCheck check_real_time(const Catalogue& words = {});
/// Checks whether the system's clock is synchronised with a time server, because session journals of several
/// machines are compared by clock time.
MachineCheck check_clock(const Catalogue& words = {});
/// Checks the upper limit of sockets' receive buffers, read from the file `limit` (bytes). Bursts of a large
/// scene on a network need large buffers.
MachineCheck check_network_buffers(const std::filesystem::path& limit = network_buffer_limit,
                                   const Catalogue& words = {});
/// Checks whether the number of processor cores suffices to run a server and a client on this machine.
MachineCheck check_cores(unsigned cores, const Catalogue& words = {});
/// Checks whether the folder `data` contains all anatomy files of the shipped scenes.
MachineCheck check_anatomy(const std::filesystem::path& data, const Catalogue& words = {});

}  // namespace prosector
