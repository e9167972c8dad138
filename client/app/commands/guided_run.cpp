#include "client/app/commands/guided_run.h"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>

#include "common/clock.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr int longest_wait_ms = 20;
constexpr double progress_interval = 0.25;  // step of the progress between two printed lines

/// Prints instruction, progress, problems and device messages when they change.
class GuidePrinter {
 public:
  void show(const GuideStep& step, const DeviceStatus& status) {
    if (status.health != DeviceHealth::streaming && !status.message.empty() && status.message != message_)
      say("device: " + status.message);
    message_ = status.message;
    if (!step.rejection.empty() && step.rejection != rejection_) say("  " + step.rejection);
    rejection_ = step.rejection;
    if (step.done) return;
    if (step.instruction != instruction_) {
      instruction_ = step.instruction;
      printed_progress_ = 0;
      say(fmt::format("{}/{} {}", step.index + 1, step.count, step.instruction));
    } else if (step.count <= 2 && step.progress >= printed_progress_ + progress_interval &&
               step.progress < 1) {
      printed_progress_ = step.progress;
      say(fmt::format("  {:.0f} %", 100 * printed_progress_));
    }
  }

 private:
  static void say(const std::string& line) {
    fmt::print("{}\n", line);
    std::fflush(stdout);
  }

  std::string instruction_, rejection_, message_;
  double printed_progress_ = 0;
};

}  // namespace

void run_guide(Guide& guide, Device& device, double time_limit, const std::function<void()>& also) {
  const std::int64_t begin_ns = monotonic_ns();
  GuidePrinter printer;
  std::vector<DeviceSample> samples;
  for (GuideStep step = guide.step(); !step.done; step = guide.step()) {
    if (seconds_since(begin_ns) > time_limit)
      throw InputError(fmt::format(
          "calibration timed out after {:.0f} s in step {} of {}, \"{}\"; allow more time with --timeout",
          time_limit, step.index + 1, step.count, step.instruction));
    pollfd descriptor{device.descriptor(), POLLIN, 0};
    ::poll(&descriptor, descriptor.fd >= 0 ? 1 : 0, longest_wait_ms);
    samples.clear();
    device.poll(samples);
    for (const DeviceSample& sample : samples) guide.take(sample);
    if (also) also();
    printer.show(guide.step(), device.status());
  }
}

}  // namespace prosector
