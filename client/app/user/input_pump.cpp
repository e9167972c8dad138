#include "client/app/user/input_pump.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <utility>

#include "common/clock.h"
#include "common/error.h"

namespace prosector {
namespace {

constexpr std::int64_t shortest_ns =
    5'000'000;  // between two sends: one message carries the records of several stations
constexpr std::int64_t desk_ns =
    16'000'000;  // interval for inputs that change without device data: desk user, tool hand
constexpr std::int64_t longest_ns =
    100'000'000;  // interval without new data: confirms that the hand is still present (or absent)

}  // namespace

InputPump::InputPump(Connection& connection, const ConfigSource& source, HeadsetUser* headset, ArmHand* arm,
                     const std::filesystem::path& log, std::function<void(const std::string&)> report)
    : connection_(connection), watch_(source), headset_(headset), arm_(arm), report_(std::move(report)) {
  take_config(source.read());
  if (!log.empty()) {
    log_.open(log);
    if (!log_) throw InputError(fmt::format("--latency-log {}: cannot be written", log.string()));
    log_ << "sequence,sent_ns,seen_ns,r0,r1,r2,r3,r4,r5,r6\n";
  }
  thread_ = std::jthread([this](std::stop_token stop) { run(stop); });
}

InputPump::~InputPump() {
  thread_.request_stop();
  thread_.join();
}

HandInput InputPump::latest() const {
  std::lock_guard lock(mutex_);
  return latest_;
}

void InputPump::set_desk_input(const HandInput& input) {
  std::lock_guard lock(mutex_);
  desk_input_ = input;
}

void InputPump::run(std::stop_token stop) {
  std::uint64_t sequence = 0;
  std::int64_t sent_ns = 0;
  bool news = false;
  while (!stop.stop_requested()) {
    rig_->wait(4);
    const std::int64_t now = monotonic_ns();
    if (const auto config = watch_.look(now, report_)) take_config(*config);
    news |= rig_->poll(now) || arm_ != nullptr;
    for (const std::string& line : rig_->take_news()) report_(line);
    for (const GestureTrigger& trigger : rig_->take_triggers()) obey(trigger);
    if (arm_ != nullptr) {
      for (const std::string& line : arm_->take_news()) report_(line);
      for (const CommandBody& wish : arm_->take_wishes()) connection_.command(wish);
    }
    const bool steady = desk_driven() || tool_hand_.leads();
    if (now - sent_ns < (news ? shortest_ns : steady ? desk_ns : longest_ns)) continue;
    send(now, ++sequence);
    sent_ns = now;
    news = false;
  }
}

void InputPump::take_config(const ClientConfig& config) {
  rig_.reset();  // close the devices first: a port can be open only once
  rig_ = std::make_unique<DeviceRig>(config, headset_);
  tool_ = config.tool;
  tool_hand_ = {};
}

/// Executes a gesture's command. Gestures of the right hand are ignored while the tool hand drives it.
void InputPump::obey(const GestureTrigger& trigger) {
  if (trigger.hand == right_hand && tool_hand_.leads()) return;
  const auto hand = static_cast<std::uint8_t>(trigger.hand);
  switch (trigger.event) {
    case GestureEvent::none:
      return;
    case GestureEvent::grasp:
      if (!latest().hands[trigger.hand].tracked) return;  // a glove closed before its tracker has a pose
      return connection_.command(Grasp{hand});
    case GestureEvent::release:
      return connection_.command(Release{hand});
    case GestureEvent::reset:
    case GestureEvent::panel:
    case GestureEvent::parts: {
      std::lock_guard lock(mutex_);
      calls_[trigger.event].push_back(trigger.hand);
    }
  }
}

std::vector<std::size_t> InputPump::take_calls(GestureEvent event) {
  std::lock_guard lock(mutex_);
  return std::exchange(calls_[event], {});
}

bool InputPump::desk_driven() const {
  std::lock_guard lock(mutex_);
  return desk_input_.has_value();
}

/// Lets the user's instrument control a blade of the scene with the right hand.
void InputPump::drive_tool_hand(HandInput& input, std::int64_t now_ns) {
  std::optional<ToolState> tool;
  std::string problem;
  try {
    tool = connection_.with_replica([&](const Replica& replica) {
      return tool_state(replica, {connection_.participant(), right_hand}, tool_);
    });
  } catch (const InputError& error) {
    problem = error.what();
  }
  if (problem != tool_problem_ && !problem.empty()) report_(problem);
  tool_problem_ = problem;
  if (!tool) return void(tool_hand_ = {});  // releases the hand to other devices
  const HeldPose& stylus = input.held[static_cast<std::size_t>(HeldObject::stylus)];
  const HandPose hand =
      tool_hand_.follow(*tool, stylus.tracked ? std::optional(stylus.pose) : std::nullopt, now_ns);
  if (tool_hand_.leads()) input.hands[right_hand] = hand;
  if (const auto wish = tool_hand_.take_command()) connection_.command(*wish);
}

void InputPump::send(std::int64_t now_ns, std::uint64_t sequence) {
  HandInput input = rig_->input();
  if (!tool_.empty()) drive_tool_hand(input, now_ns);
  {
    std::lock_guard lock(mutex_);
    if (desk_input_) input = *desk_input_;
  }
  input.participant = connection_.participant();
  input.sequence = sequence;
  if (arm_ != nullptr) {
    input.time_ns = now_ns;
    connection_.publish(arm_->fill(input));
  }
  connection_.publish(input);
  if (const auto& sample = rig_->tracker_sample(right_hand); log_.is_open() && sample)
    fmt::print(log_, "{},{},{},{}\n", sequence, now_ns, input.time_ns, fmt::join(sample->raw_pose, ","));
  std::lock_guard lock(mutex_);
  latest_ = input;
}

}  // namespace prosector
