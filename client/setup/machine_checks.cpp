#include "client/setup/machine_checks.h"

#include <sys/timex.h>

#include <array>
#include <fstream>
#include <thread>

#include "drivers/ports/real_time.h"

namespace prosector {
namespace {

constexpr double smooth = 1. / 60, bearable = 1. / 25;  // s per frame
constexpr double good_buffer = 1 << 20;                 // bytes: a few frames of a large scene
constexpr unsigned good_cores = 4, least_cores = 2;
constexpr std::array shipped_data = {"liver.inr.gz", "head.nii", "brain.nii.gz", "femur.off"};

}  // namespace

MachineCheck check_pictures(double seconds, const std::string& opengl, const Catalogue& words) {
  MachineCheck out{
      msg("Pictures"), CheckState::good,
      words.tr("Rendering takes {:.1f} ms per frame for a small scene, with {}.", 1e3 * seconds, opengl)};
  if (seconds > bearable) {
    out.state = CheckState::bad;
    out.words += words.tr(
        " This frame time is too long for smooth motion: use --quality low, or install the graphics card's "
        "driver.");
  } else if (seconds > smooth) {
    out.state = CheckState::fair;
    out.words += words.tr(" Large scenes may need --quality low, or --frame-time 33.");
  }
  return out;
}

MachineCheck check_real_time(const Catalogue& words) {
  bool given = false;
  std::thread([&] { given = request_real_time_priority(servo_priority); }).join();
  if (given)
    return {msg("Real-time priority"), CheckState::good,
            words.tr("Real-time priority is available for the servo loop of a haptic arm.")};
  return {msg("Real-time priority"), CheckState::fair,
          words.tr("Real-time priority is not available: a haptic arm may stutter. Allow it in "
                   "/etc/security/limits.d: @audio - rtprio 50.")};
}

MachineCheck check_clock(const Catalogue& words) {
  timex asked{};
  const bool known = adjtimex(&asked) >= 0;
  if (!known)
    return {msg("Clock"), CheckState::unknown,
            words.tr("Cannot determine whether the clock is synchronised.")};
  if ((asked.status & STA_UNSYNC) == 0)
    return {msg("Clock"), CheckState::good, words.tr("Synchronised with a time server.")};
  return {msg("Clock"), CheckState::fair,
          words.tr("The clock is not synchronised with a time server. Sessions are not affected; times in "
                   "journals of several machines may differ.")};
}

MachineCheck check_network_buffers(const std::filesystem::path& limit, const Catalogue& words) {
  double bytes = 0;
  if (!(std::ifstream(limit) >> bytes))
    return {msg("Network"), CheckState::unknown, words.tr("Cannot read {}.", limit.string())};
  if (bytes >= good_buffer)
    return {msg("Network"), CheckState::good,
            words.tr("Network sockets buffer up to {:.0f} kB.", bytes / 1024)};
  return {msg("Network"), CheckState::fair,
          words.tr("Network sockets buffer at most {:.0f} kB. If bursts are lost on the network, increase "
                   "it: sysctl net.core.rmem_max={:.0f}.",
                   bytes / 1024, 4 * good_buffer)};
}

MachineCheck check_cores(unsigned cores, const Catalogue& words) {
  const std::string count = words.tr("{} cores.", cores);
  if (cores >= good_cores) return {msg("Processor"), CheckState::good, count};
  if (cores >= least_cores)
    return {msg("Processor"), CheckState::fair,
            count + words.tr(" To host and participate on this machine, choose small scenes.")};
  return {msg("Processor"), CheckState::bad, count + words.tr(" Host on another machine.")};
}

MachineCheck check_anatomy(const std::filesystem::path& data, const Catalogue& words) {
  std::string missing;
  for (const char* file : shipped_data)
    if (!std::filesystem::exists(data / file)) missing += (missing.empty() ? "" : ", ") + std::string(file);
  if (missing.empty())
    return {msg("Anatomy"), CheckState::good,
            words.tr("All files of the shipped scenes are in {}.", data.string())};
  return {msg("Anatomy"), CheckState::fair,
          words.tr("The folder {} lacks {}: simple shapes are used instead. Fetch the files with "
                   "deploy/fetch_anatomy.sh.",
                   data.string(), missing)};
}

}  // namespace prosector
