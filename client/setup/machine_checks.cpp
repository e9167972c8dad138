#include "client/setup/machine_checks.h"

#include <fmt/format.h>
#include <sys/timex.h>

#include <array>
#include <fstream>
#include <thread>

#include "drivers/real_time.h"

namespace prosector {
namespace {

constexpr double smooth = 1. / 60, bearable = 1. / 25;  // s a picture
constexpr double good_buffer = 1 << 20;                 // bytes: a few frames of a large scene
constexpr unsigned good_cores = 4, least_cores = 2;
constexpr std::array shipped_data = {"liver.inr.gz", "head.nii", "brain.nii.gz", "femur.off"};

}  // namespace

MachineCheck check_pictures(double seconds, const std::string& opengl) {
  MachineCheck out{"Pictures", CheckState::good,
                   fmt::format("{:.1f} ms a picture of a small scene, by {}.", 1e3 * seconds, opengl)};
  if (seconds > bearable) {
    out.state = CheckState::bad;
    out.words += " That isn't smooth: take --quality low, or a graphics card's driver.";
  } else if (seconds > smooth) {
    out.state = CheckState::fair;
    out.words += " Large scenes may want --quality low, or --frame-time 33.";
  }
  return out;
}

MachineCheck check_real_time() {
  bool given = false;
  std::thread([&] { given = ask_for_real_time(servo_priority); }).join();
  if (given) return {"Real-time priority", CheckState::good, "The servo of a haptic arm gets one."};
  return {"Real-time priority", CheckState::fair,
          "None is given: a haptic arm may stutter. Allow it in /etc/security/limits.d: @audio - rtprio 50."};
}

MachineCheck check_clock() {
  timex asked{};
  const bool known = adjtimex(&asked) >= 0;
  if (!known) return {"Clock", CheckState::unknown, "The system doesn't tell whether its clock is right."};
  if ((asked.status & STA_UNSYNC) == 0) return {"Clock", CheckState::good, "It is kept by a server of time."};
  return {
      "Clock", CheckState::fair,
      "No server of time keeps it. Sessions don't mind; times in journals of several machines may differ."};
}

MachineCheck check_network_buffers(const std::filesystem::path& limit) {
  double bytes = 0;
  if (!(std::ifstream(limit) >> bytes))
    return {"Network", CheckState::unknown, limit.string() + " can't be read."};
  if (bytes >= good_buffer)
    return {"Network", CheckState::good, fmt::format("Sockets keep up to {:.0f} kB.", bytes / 1024)};
  return {"Network", CheckState::fair,
          fmt::format("Sockets keep {:.0f} kB at most. On a network that loses bursts, let them keep more: "
                      "sysctl net.core.rmem_max={:.0f}.",
                      bytes / 1024, 4 * good_buffer)};
}

MachineCheck check_cores(unsigned cores) {
  const std::string words = fmt::format("{} cores.", cores);
  if (cores >= good_cores) return {"Processor", CheckState::good, words};
  if (cores >= least_cores)
    return {"Processor", CheckState::fair,
            words + " To host and take part here at once, choose small scenes."};
  return {"Processor", CheckState::bad, words + " Host on another machine."};
}

MachineCheck check_anatomy(const std::filesystem::path& data) {
  std::string missing;
  for (const char* file : shipped_data)
    if (!std::filesystem::exists(data / file)) missing += (missing.empty() ? "" : ", ") + std::string(file);
  if (missing.empty())
    return {"Anatomy", CheckState::good, "All that shipped scenes name is in " + data.string() + "."};
  return {"Anatomy", CheckState::fair,
          fmt::format("{} lacks {}: plain shapes stand for it. Fetch it: deploy/fetch_anatomy.sh.",
                      data.string(), missing)};
}

}  // namespace prosector
