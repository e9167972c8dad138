#pragma once
// What of this machine bears a session well, and what doesn't, in words that say what to do.

#include <filesystem>
#include <string>
#include <vector>

namespace prosector {

enum class CheckState : std::uint8_t { unknown, good, fair, bad };

struct MachineCheck {
  std::string name;
  CheckState state = CheckState::unknown;
  std::string words;
};

/// Judges the median time of a picture of a small scene, s, drawn at that quality by that OpenGL.
MachineCheck check_pictures(double seconds, const std::string& opengl);
/// Asks for a real-time priority on a thread that ends at once: haptic arms want one.
MachineCheck check_real_time();
/// Looks whether the system's clock is kept by a server of time: journals of several machines are compared
/// by it.
MachineCheck check_clock();
/// Looks how much the system lets a socket keep, bytes, which bursts of a large scene need on a network.
MachineCheck check_network_buffers(const std::filesystem::path& limit = "/proc/sys/net/core/rmem_max");
/// Looks whether there are cores enough for a server and a client.
MachineCheck check_cores(unsigned cores);
/// Looks for the anatomy that shipped scenes are made of.
MachineCheck check_anatomy(const std::filesystem::path& data);

}  // namespace prosector
