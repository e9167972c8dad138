#include "client/app/terminal/console.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <csignal>
#include <optional>
#include <sstream>

#include "client/app/terminal/controls.h"
#include "client/app/terminal/split_line.h"
#include "client/replica/shown_names.h"
#include "common/role_words.h"

namespace prosector {
namespace {

constexpr std::size_t longest_line = 4096;

std::optional<BodyId> body_of(const SceneInfo& scene, const std::string& name) {
  for (BodyId body = 0; body < scene.bodies.size(); ++body)
    if (is_called(scene.bodies[body], name)) return body;
  return std::nullopt;
}

/// Returns the uniform scaling that leaves `center` fixed.
Affine scaled_about(const Vec3& center, double scale) {
  Affine out;
  out.A *= scale;
  out.p = center - scale * center;
  return out;
}

std::string no_body_called(const std::string& name) {
  return fmt::format("the scene has no body called \"{}\"", name);
}

/// Reads the name of the body that a command is about.
template <class OfBody>
ConsoleLine of_body(const std::string& name, const SceneInfo& scene) {
  const auto body = body_of(scene, name);
  if (!body) return no_body_called(name);
  return OfBody{*body};
}

ConsoleLine inspect(const std::string& rest, const SceneInfo& scene,
                    const std::function<Vec3(BodyId)>& middle) {
  if (const auto body = body_of(scene, rest)) return Inspect{*body};
  const auto [name, number] = split_last(rest);
  double scale = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), scale);
  if (error != std::errc() || end != number.data() + number.size() ||
      !(scale >= 0.01 && scale <= max_shape_entry))
    return fmt::format("inspect PART SCALE: SCALE is from 0.01 to {} times the part's size", max_shape_entry);
  const auto body = body_of(scene, name);
  if (!body) return no_body_called(name);
  return Inspect{*body, scaled_about(middle(*body), scale)};
}

ConsoleLine give(const std::string& rest, const std::map<ParticipantId, RosterEntry>& roster) {
  const auto [name, word] = split_last(rest);
  const auto role = role_of(word);
  if (!role) return "give NAME ROLE: ROLE is host, dissector or observer";
  for (const auto& [id, entry] : roster)
    if (entry.name == name) return SetRole{id, *role};
  return fmt::format("no participant is called \"{}\"", name);
}

ConsoleLine rewind(const std::string& rest, const SceneInfo& scene) {
  const auto [name, number] = split_last(rest);
  Rewind out;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), out.revision);
  if (number.empty() || error != std::errc() || end != number.data() + number.size())
    return "rewind PART REVISION: REVISION is the number of one of the part's cuts, 0 for its initial state";
  const auto body = body_of(scene, name);
  if (!body) return no_body_called(name);
  out.body = *body;
  return out;
}

/// Reads a number that is not below 0, and nothing else.
std::optional<double> number_of(const std::string& text) {
  double out = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && std::isfinite(out) && out >= 0 ? std::optional(out) : std::nullopt;
}

ConsoleLine slow(const std::string& rest) {
  const std::optional<double> share = number_of(rest);
  if (!share || *share < min_pace || *share > 1)
    return fmt::format("slow SHARE: SHARE is the speed as a fraction of real time, {:g} to 1", min_pace);
  return SetPace{*share};
}

ConsoleLine step(const std::string& rest) {
  StepTicks out{1};
  if (rest.empty()) return out;
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), out.ticks);
  if (error != std::errc() || end != rest.data() + rest.size() || out.ticks < 1 || out.ticks > most_steps)
    return fmt::format("step TICKS: 1 to {}; default: 1", most_steps);
  return out;
}

ConsoleLine fast(const std::string& rest) {
  const std::optional<double> times = number_of(rest);
  if (!times || *times < 1 || *times > max_pace)
    return fmt::format(
        "fast TIMES: TIMES is the speed as a multiple of real time, 1 to {:g}; recordings only", max_pace);
  return SetPace{*times};
}

ConsoleLine effort(const std::string& rest, const SceneInfo& scene) {
  const auto [name, word] = split_last(rest);
  const std::optional<double> steps = word == "exact"    ? std::optional(0.0)
                                      : word == "coarse" ? std::optional<double>(max_steps_down)
                                                         : number_of(word);
  if (name.empty() || word.empty() || !steps || *steps > max_steps_down || *steps != std::floor(*steps))
    return fmt::format(
        "effort PART STEPS, or effort all STEPS: STEPS reduces the solver's effort, from 0 or exact (as "
        "configured) to {} or coarse",
        max_steps_down);
  const auto steps_down = static_cast<std::uint32_t>(*steps);
  if (name == "all") return SetAllEfforts{steps_down};
  const auto body = body_of(scene, name);
  if (!body) return no_body_called(name);
  return SetEffort{*body, steps_down};
}

ConsoleLine accuracy(const std::string& rest, const SceneInfo& scene) {
  SetAccuracy out;
  std::string name = rest;
  std::string last = split_last(rest).second;
  if (last == "%") {
    name = split_last(rest).first;
    last = split_last(name).second + "%";
  }
  if (last.ends_with('%')) {
    const std::optional<double> percent = number_of(last.substr(0, last.size() - 1));
    if (!percent || *percent < min_accuracy || *percent > max_accuracy)
      return fmt::format(
          "accuracy PART PERCENT: PERCENT is the largest error, {:g} … {:g} %; accuracy PART alone lists the "
          "available accuracies",
          min_accuracy, max_accuracy);
    out.percent = *percent;
    name = split_last(name).first;
  }
  const auto body = body_of(scene, name);
  if (!body) return no_body_called(name);
  out.body = *body;
  return out;
}

/// Parses a time in seconds or minutes and seconds: "75", "1:15".
std::optional<double> seconds_of(const std::string& text) {
  const auto colon = text.find(':');
  const std::optional<double> seconds = number_of(text.substr(colon == text.npos ? 0 : colon + 1));
  if (colon == text.npos || !seconds) return seconds;
  const std::optional<double> minutes = number_of(text.substr(0, colon));
  if (!minutes || *seconds >= 60) return std::nullopt;
  return 60 * *minutes + *seconds;
}

ConsoleLine seek(const std::string& rest, const std::optional<ShownTime>& watched) {
  if (!watched) return "seek: this session is live; seek moves only in a recording";
  const bool from_now = rest.starts_with('+') || rest.starts_with('-');
  const std::optional<double> seconds = seconds_of(from_now ? rest.substr(1) : rest);
  if (!seconds)
    return "seek TIME: TIME is in seconds or minutes:seconds, e.g. 75 or 1:15, or +10, -10 from the current "
           "time";
  const double way = rest.starts_with('-') ? -*seconds : *seconds;
  const double tick = (from_now ? watched->tick : 0) + way * watched->tick_rate;
  return Seek{static_cast<std::uint32_t>(
      std::lround(std::clamp(tick, 0.0, static_cast<double>(watched->last_tick))))};
}

ConsoleLine look(const std::string& rest) {
  if (rest.empty()) return RestoreView{};
  std::istringstream words(rest);
  Vec3 eye, target;
  for (Vec3* v : {&eye, &target})
    for (int k = 0; k < 3; ++k) words >> (*v)[k];
  const bool numbers = words && (words >> std::ws).eof();
  const bool inside = numbers && eye.cwiseAbs().maxCoeff() <= max_coordinate &&
                      target.cwiseAbs().maxCoeff() <= max_coordinate;
  if (!inside || eye == target)
    return fmt::format(
        "look X Y Z X Y Z: positions of the eye and of its target, two different points with room "
        "coordinates up to ±{} m; look alone restores the view",
        max_coordinate);
  return LookFrom{eye, target};
}

}  // namespace

std::string console_help() {
  constexpr std::array devices = {ControlDevice::terminal};
  return help_text(Role::host, devices);
}

ConsoleLine parse_console_line(const std::string& line, const SceneInfo& scene,
                               const std::map<ParticipantId, RosterEntry>& roster,
                               const std::function<Vec3(BodyId)>& middle,
                               const std::optional<ShownTime>& watched) {
  auto [verb, rest] = split_first(line);
  if (verb == "give") return give(rest, roster);
  if (verb == "rewind") return rewind(rest, scene);
  if (verb == "look") return look(rest);
  if (verb == "stop") return SetPace{0};
  if (verb == "go") return SetPace{1};
  if (verb == "slow") return slow(rest);
  if (verb == "fast") return fast(rest);
  if (verb == "effort") return effort(rest, scene);
  if (verb == "accuracy") return accuracy(rest, scene);
  if (verb == "seek") return seek(rest, watched);
  if (verb == "step") return step(rest);
  if (verb == "reset" && rest == "all") return ResetAll{};
  if (verb == "cuts") return ListCuts{};
  if (verb == "what") return DescribePointed{};
  if (verb == "undo") return Undo{};
  if (verb == "picture") {
    if (rest.empty()) return "picture FILE: FILE is the PNG file to write the current frame to";
    return TakePicture{rest};
  }
  if (verb == "detach") return of_body<Detach>(rest, scene);
  if (verb == "attach") return of_body<Attach>(rest, scene);
  if (verb == "reset") return of_body<ResetBody>(rest, scene);
  if (verb == "end") return of_body<EndInspect>(rest, scene);
  if (verb == "inspect") return inspect(rest, scene, middle);
  return console_help();
}

// Ignore SIGTTIN: a client in the background must not be stopped when the user types at the terminal.
Console::Console() : open_(std::signal(SIGTTIN, SIG_IGN) != SIG_ERR) {}

std::vector<std::string> Console::take() {
  std::vector<std::string> out;
  while (open_) {
    pollfd input{STDIN_FILENO, POLLIN, 0};
    if (poll(&input, 1, 0) <= 0) break;
    char bytes[512];
    const ssize_t got = read(STDIN_FILENO, bytes, sizeof bytes);
    if (got <= 0 || rest_.size() > longest_line) {
      open_ = false;
      break;
    }
    rest_.append(bytes, static_cast<std::size_t>(got));
    for (auto end = rest_.find('\n'); end != std::string::npos; end = rest_.find('\n')) {
      if (const std::string line = trimmed(rest_.substr(0, end)); !line.empty()) out.push_back(line);
      rest_.erase(0, end + 1);
    }
  }
  return out;
}

}  // namespace prosector
