#include "client/app/controls.h"

#include <fmt/format.h>

#include <algorithm>

namespace prosector {
namespace {

std::string_view name_of(ControlDevice device) {
  constexpr std::array<std::string_view, 6> names = {"The view, with mouse and keyboard",
                                                     "Your hand, with the mouse",
                                                     "Gamepad",
                                                     "Headset and glove",
                                                     "At this terminal",
                                                     "Time, while a recording is watched"};
  return names[static_cast<std::size_t>(device)];
}

std::string_view whose(Role least) {
  constexpr std::array<std::string_view, 3> names = {"everyone", "who takes part", "the host"};
  return names[static_cast<std::size_t>(least)];
}

std::size_t longest_input() {
  return std::ranges::max(controls, {}, [](const Control& c) { return c.input.size(); }).input.size();
}

}  // namespace

std::string help_text(Role role, std::span<const ControlDevice> devices, HelpColumns columns) {
  std::string out;
  for (const ControlDevice device : devices) {
    std::string lines;
    for (const Control& control : controls)
      if (control.device == device && control.least <= role)
        lines += columns == HelpColumns::tabs
                     ? fmt::format("{}\t{}\n", control.input, control.does)
                     : fmt::format("  {:<{}}  {}\n", control.input, longest_input(), control.does);
    if (!lines.empty()) out += fmt::format("{}\n{}", name_of(device), lines);
  }
  if (!out.empty()) out.pop_back();
  return out;
}

std::vector<std::string> first_words(Role role, std::span<const ControlDevice> devices) {
  std::vector<std::string> out;
  if (std::ranges::count(devices, ControlDevice::view) > 0)
    out.emplace_back("H: all that mouse and keys do here");
  if (role != Role::observer && std::ranges::count(devices, ControlDevice::hand) > 0)
    out.emplace_back("your hand follows the pointer; hold the left button to touch what it is at");
  return out;
}

std::string controls_in_markdown(ControlDevice device) {
  std::string out = "| Control | does | for |\n|---|---|---|\n";
  for (const Control& control : controls)
    if (control.device == device)
      out += fmt::format("| {} | {} | {} |\n", control.input, control.does, whose(control.least));
  return out;
}

}  // namespace prosector
