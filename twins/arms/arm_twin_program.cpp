#include "twins/arms/arm_twin_program.h"

#include <fmt/format.h>
#include <poll.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <iostream>

#include "common/clock.h"
#include "common/error.h"
#include "drivers/ports/real_time.h"

namespace prosector {
namespace {

constexpr std::int64_t period_ns = 1'000'000;
std::atomic<bool> arm_twin_stopped = false;

void stop_arm_twin(int) {
  arm_twin_stopped = true;
}

}  // namespace

void add_arm_options(CLI::App& app, ArmTwinSettings& settings, const char* garbage) {
  app.add_option(
         "--script", settings.script,
         "CSV script of the target poses to which the simulated hand moves the stylus (docs/do/devices.md)")
      ->required()
      ->check(CLI::ExistingFile);
  app.add_option("--room-arm", settings.room, "x,y,z,qw,qx,qy,qz: pose of the arm's frame in the room")
      ->expected(7)
      ->delimiter(',');
  app.add_option("--hand", settings.hand,
                 "Model of the simulated hand that holds the stylus: light or medium")
      ->check(CLI::IsMember({"light", "medium"}));
  app.add_option("--log", settings.log,
                 "Write the stylus pose, the motor forces and the hand's target to this CSV file");
  app.add_option("--garbage", settings.garbage,
                 fmt::format("Fraction of {} sent as random bytes, from 0 to 1", garbage))
      ->check(CLI::Range(0., 1.));
  app.add_option("--seed", settings.seed, "Seed of the simulated arm's random numbers");
  app.add_flag("--wait-client", settings.timing.wait_client,
               "Start the script when a client starts streaming (default: immediately)");
  app.add_option("--hold", settings.timing.holds,
                 "Script times, s, at which the script pauses until a line is read from standard input");
  app.add_flag("--loop", settings.timing.loop, "Repeat the script");
}

HeldArmOptions held_arm_options(const ArmTwinSettings& settings) {
  HeldArmOptions out;
  out.script = MotionScript::load(settings.script);
  out.timing = settings.timing;
  const std::vector<double>& r = settings.room;
  out.room_arm = {Vec3(r[0], r[1], r[2]), Quat(r[3], r[4], r[5], r[6]).normalized()};
  out.hand = settings.hand == "light" ? light_hand : medium_hand;
  out.turns = settings.turns;
  return out;
}

ArmLog::ArmLog(const std::string& file) {
  if (file.empty()) return;
  out_.open(file);
  if (!out_) throw InputError(file + ": cannot be written");
  out_ << "time_ns,x,y,z,fx,fy,fz,wx,wy,wz,energy\n";
}

void ArmLog::write(std::int64_t now_ns, const HeldArm& arm) {
  if (!out_.is_open()) return;
  const Pose& room_arm = arm.room_arm();
  const Vec3 x = room_arm * arm.model().position(), f = room_arm.q * arm.model().force();
  const Vec3 wanted = room_arm * arm.intended();
  out_ << fmt::format("{},{:.6f},{:.6f},{:.6f},{:.4f},{:.4f},{:.4f},{:.6f},{:.6f},{:.6f},{:.6g}\n", now_ns,
                      x.x(), x.y(), x.z(), f.x(), f.y(), f.z(), wanted.x(), wanted.y(), wanted.z(),
                      arm.model().energy());
}

void serve_arm(const ArmTwinSettings& settings, const std::function<void(std::int64_t now_ns)>& cycle,
               const std::function<void(std::int64_t now_ns)>& go_on) {
  std::signal(SIGINT, stop_arm_twin);
  std::signal(SIGTERM, stop_arm_twin);
  request_real_time_priority(servo_priority);  // so that the simulated arm keeps running on a busy machine
  const bool holds = !settings.timing.holds.empty();
  std::int64_t next = monotonic_ns();
  while (!arm_twin_stopped) {
    next = std::max(next + period_ns, monotonic_ns());
    const timespec until{next / 1'000'000'000, next % 1'000'000'000};
    clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr);
    const std::int64_t now = monotonic_ns();
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (std::string line; holds && ::poll(&input, 1, 0) > 0 && std::getline(std::cin, line)) go_on(now);
    cycle(now);
  }
}

}  // namespace prosector
