#include "client/app/run/run_setup.h"

#include <chrono>
#include <csignal>
#include <thread>

#include "client/app/output/picture_time.h"
#include "client/setup/interface.h"
#include "client/setup/layout_log.h"
#include "client/setup/pages.h"
#include "client/setup/setup_session.h"
#include "common/error.h"
#include "common/paths.h"

namespace prosector {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds between_pictures{33}, idle_time{200};

volatile std::sig_atomic_t setup_interrupted = 0;

std::filesystem::path scenes_of(const SetupOptions& o) {
  return o.scenes.empty() ? shipped_scenes_dir(program_folder()) : o.scenes;
}

/// Returns the side-by-side displays shipped with the program.
std::vector<EyeDisplay> eye_displays() {
  std::vector<EyeDisplay> out;
  for (const std::string& name : shipped_profiles()) {
    const StereoProfile profile = load_stereo_profile(name);
    out.push_back(
        {name, static_cast<int>(profile.eye_width), static_cast<int>(profile.eye_height), profile.swap_eyes});
  }
  return out;
}

/// Makes the window full screen on the monitor that the pages request, for instance to show calibration
/// crosses, and restores it afterwards.
void fill_screen(WindowContext& window, const Pages& pages, std::optional<int>& filled, SetupSession& room) {
  if (pages.full_screen() == filled) return;
  filled = pages.full_screen();
  try {
    window.set_full_screen(filled);
  } catch (const InputError& error) {
    room.say(error.what(), true);
  }
}

/// Shows the pages until the user enters a session. Returns the command to run; nullopt: the window was
/// closed.
std::optional<std::vector<std::string>> show_pages(const SetupOptions& o, SetupSession& room,
                                                   ConfigDraft& draft) {
  auto window = make_window_context(o.width, o.height, "Prosector");
  Interface ui(*window, o.shaders, o.scale.value_or(window->content_scale()), o.words);
  const std::filesystem::path scenes = scenes_of(o);
  Pages pages(
      room, draft,
      [&] {
        try {
          return check_pictures(picture_time(*window, o.shaders, scenes / "minimal.toml"),
                                window->description(), o.words);
        } catch (const InputError& error) {
          return MachineCheck{msg("Pictures"), CheckState::unknown, error.what()};
        }
      },
      eye_displays());
  LayoutLog layout(o.layout_log);
  std::optional<int> filled;  // index of the monitor filled by the window; nullopt: none
  Clock::time_point last = Clock::now(), busy = last;
  while (setup_interrupted == 0) {
    const std::vector<WindowEvent> events = window->poll_events();
    for (const WindowEvent& event : events)
      if (std::holds_alternative<CloseRequested>(event)) return std::nullopt;
    ui.take(events);
    const Clock::time_point now = Clock::now();
    if (!events.empty() || ui.behind() || pages.lively()) busy = now;
    // Without activity an occasional frame suffices.
    if (now - busy > idle_time && now - last < idle_time) {
      std::this_thread::sleep_for(between_pictures / 2);
      continue;
    }
    room.poll();
    ui.draw(std::chrono::duration<double>(now - last).count(), [&] { pages.draw(ui); });
    last = now;
    fill_screen(*window, pages, filled, room);
    window->present();
    layout.write(ui, pages.said().words);
    if (auto entry = room.take_entry_command()) return entry;
    std::this_thread::sleep_until(now + between_pictures);
  }
  return std::nullopt;
}

/// Runs a client until it ends, while polling the room. An interrupt is forwarded to the client.
void visit(const std::vector<std::string>& command, SetupSession& room) {
  try {
    ChildProcess client(command);
    while (!client.ended()) {
      if (setup_interrupted != 0) client.interrupt();
      std::this_thread::sleep_for(between_pictures);
      client.poll();
      room.poll();
    }
    room.report_exit(*client.ended(), client.lines().empty() ? "" : client.lines().back());
  } catch (const InputError& error) {
    room.say(error.what(), true);
  }
}

}  // namespace

int run_setup(const SetupOptions& options) {
  std::signal(SIGINT, [](int) { setup_interrupted = 1; });
  std::signal(SIGTERM, [](int) { setup_interrupted = 1; });
  const std::filesystem::path config = default_config_dir();
  const std::filesystem::path settings = options.config.empty() ? config / "client.toml" : options.config;
  ConfigDraft draft(settings);
  SetupSession room({.bus = options.bus,
                     .scenes = scenes_of(options),
                     .cache = default_cache_dir(),
                     .memory = config / "anteroom.toml",
                     .config = settings,
                     .language = options.language,
                     .words = options.words});
  if (room.memory.name.empty()) room.memory.name = options.name;
  while (setup_interrupted == 0) {
    const auto entry = show_pages(options, room, draft);
    if (!entry) break;
    visit(*entry, room);
  }
  return 0;
}

}  // namespace prosector
