#include "client/setup/machine_checks.h"

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

MachineCheck check_pictures(double seconds, const std::string& opengl, const Catalogue& words) {
  MachineCheck out{msg("Pictures"), CheckState::good,
                   words.tr("{:.1f} ms a picture of a small scene, by {}.", 1e3 * seconds, opengl)};
  if (seconds > bearable) {
    out.state = CheckState::bad;
    out.words += words.tr(" That isn't smooth: take --quality low, or a graphics card's driver.");
  } else if (seconds > smooth) {
    out.state = CheckState::fair;
    out.words += words.tr(" Large scenes may want --quality low, or --frame-time 33.");
  }
  return out;
}

MachineCheck check_real_time(const Catalogue& words) {
  bool given = false;
  std::thread([&] { given = ask_for_real_time(servo_priority); }).join();
  if (given)
    return {msg("Real-time priority"), CheckState::good, words.tr("The servo of a haptic arm gets one.")};
  return {msg("Real-time priority"), CheckState::fair,
          words.tr("None is given: a haptic arm may stutter. Allow it in /etc/security/limits.d: @audio - "
                   "rtprio 50.")};
}

MachineCheck check_clock(const Catalogue& words) {
  timex asked{};
  const bool known = adjtimex(&asked) >= 0;
  if (!known)
    return {msg("Clock"), CheckState::unknown,
            words.tr("The system doesn't tell whether its clock is right.")};
  if ((asked.status & STA_UNSYNC) == 0)
    return {msg("Clock"), CheckState::good, words.tr("It is kept by a server of time.")};
  return {"Clock", CheckState::fair,
          words.tr("No server of time keeps it. Sessions don't mind; times in journals of several machines "
                   "may differ.")};
}

MachineCheck check_network_buffers(const std::filesystem::path& limit, const Catalogue& words) {
  double bytes = 0;
  if (!(std::ifstream(limit) >> bytes))
    return {msg("Network"), CheckState::unknown, words.tr("{} can't be read.", limit.string())};
  if (bytes >= good_buffer)
    return {msg("Network"), CheckState::good, words.tr("Sockets keep up to {:.0f} kB.", bytes / 1024)};
  return {msg("Network"), CheckState::fair,
          words.tr("Sockets keep {:.0f} kB at most. On a network that loses bursts, let them keep more: "
                   "sysctl net.core.rmem_max={:.0f}.",
                   bytes / 1024, 4 * good_buffer)};
}

MachineCheck check_cores(unsigned cores, const Catalogue& words) {
  const std::string count = words.tr("{} cores.", cores);
  if (cores >= good_cores) return {msg("Processor"), CheckState::good, count};
  if (cores >= least_cores)
    return {msg("Processor"), CheckState::fair,
            count + words.tr(" To host and take part here at once, choose small scenes.")};
  return {msg("Processor"), CheckState::bad, count + words.tr(" Host on another machine.")};
}

MachineCheck check_anatomy(const std::filesystem::path& data, const Catalogue& words) {
  std::string missing;
  for (const char* file : shipped_data)
    if (!std::filesystem::exists(data / file)) missing += (missing.empty() ? "" : ", ") + std::string(file);
  if (missing.empty())
    return {msg("Anatomy"), CheckState::good,
            words.tr("All that shipped scenes name is in {}.", data.string())};
  return {msg("Anatomy"), CheckState::fair,
          words.tr("{} lacks {}: plain shapes stand for it. Fetch it: deploy/fetch_anatomy.sh.",
                   data.string(), missing)};
}

}  // namespace prosector
