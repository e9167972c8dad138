#include "client/app/terminal/controls.h"

#include <fmt/format.h>

#include <algorithm>

namespace prosector {
namespace {

const char* name_of(ControlDevice device) {
  constexpr std::array<const char*, 6> names = {msg("Control the view with mouse and keyboard"),
                                                msg("Control your hand with the mouse"),
                                                msg("Gamepad"),
                                                msg("Headset and glove"),
                                                "At this terminal",
                                                msg("Control time during playback of a recording")};
  return names[static_cast<std::size_t>(device)];
}

std::string_view whose(Role least) {
  constexpr std::array<std::string_view, 3> names = {"everyone", "participants", "the host"};
  return names[static_cast<std::size_t>(least)];
}

/// Returns the number of code points of a UTF-8 text.
std::size_t letters(std::string_view utf8) {
  return static_cast<std::size_t>(std::ranges::count_if(utf8, [](char c) { return (c & 0xc0) != 0x80; }));
}

/// A row of the help, translated.
struct HelpRow {
  std::string input, does;
};

HelpRow row_of(const Control& control, const Catalogue& words) {
  HelpRow out{std::string(control.input), std::string(control.does)};
  if (control.device == ControlDevice::terminal) return out;  // terminal commands are English
  return {words.tr(out.input), words.tr(out.does)};
}

std::size_t longest_input(const Catalogue& words) {
  std::size_t out = 0;
  for (const Control& control : controls) out = std::max(out, letters(row_of(control, words).input));
  return out;
}

}  // namespace

std::string help_text(Role role, std::span<const ControlDevice> devices, HelpColumns columns,
                      const Catalogue& words) {
  const std::size_t width = longest_input(words);
  std::string out;
  for (const ControlDevice device : devices) {
    std::string lines;
    for (const Control& control : controls) {
      if (control.device != device || control.least > role) continue;
      const auto [input, does] = row_of(control, words);
      lines += columns == HelpColumns::tabs
                   ? fmt::format("{}\t{}\n", input, does)
                   : fmt::format("  {}{}  {}\n", input, std::string(width - letters(input), ' '), does);
    }
    if (!lines.empty()) out += fmt::format("{}\n{}", words.tr(name_of(device)), lines);
  }
  if (!out.empty()) out.pop_back();
  return out;
}

std::vector<std::string> first_hints(Role role, std::span<const ControlDevice> devices,
                                     const Catalogue& words) {
  std::vector<std::string> out;
  if (std::ranges::count(devices, ControlDevice::view) > 0)
    out.emplace_back(words.tr("H: lists all mouse and keyboard controls"));
  if (role != Role::observer && std::ranges::count(devices, ControlDevice::hand) > 0)
    out.emplace_back(
        words.tr("your hand follows the pointer; hold the left button to touch what is under it"));
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
