#pragma once
// The set-up window's pages without a window, for tests that work them by events.

#include <chrono>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>

#include "client/render/image.h"
#include "client/render/shader_dir.h"
#include "client/setup/pages.h"
#include "tests/dds_domains.h"
#include "tests/session/temporary_file.h"
#include "tests/setup/written_file.h"

namespace prosector::test {

inline BusConfig test_bus() {
  BusConfig out;
  out.domain = dds_domain::set_up;
  return out;
}

/// A window of a person with a configuration. `scale`: of letters, and with `wide` of the window, too.
class PagesRoom {
 public:
  PagesRoom(const std::string& config, double scale, double wide = 1)
      : PagesRoom(config, scale, static_cast<int>(1280 * wide), static_cast<int>(720 * wide)) {}
  /// Takes the window's size, pixels, and its language.
  PagesRoom(const std::string& config, double scale, int wide, int high, const std::string& language = "")
      : folder_("pages"),
        file_(folder_.path / "client.toml"),
        draft_((write_file(file_, config), file_)),
        room_({.bus = test_bus(),
               .scenes = folder_.path,
               .cache = folder_.path,
               .memory = folder_.path / "m.toml",
               .config = file_,
               .language = language,
               .words = catalogue_for(language)}),
        context_(make_offscreen_context(wide, high)),
        ui_(*context_, default_shader_dir(), scale, catalogue_for(language)),
        pages_(room_, draft_,
               [] {
                 return MachineCheck{"Pictures", CheckState::good, "8 ms"};
               },
               {{"5dt_hmd_800_26", 800, 600, false}}) {
    draw(3);
  }
  ~PagesRoom() { std::filesystem::remove_all(folder_.path); }

  void draw(int pictures = 4) {
    for (int k = 0; k < pictures || ui_.behind(); ++k) ui_.draw(1. / 30, [&] { pages_.draw(ui_); });
  }
  /// Draws pictures until something is so, or two minutes are over: a limit for slow machines.
  void until(const std::function<bool()>& so) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    while (!so() && std::chrono::steady_clock::now() < end) {
      draw(1);
      std::this_thread::sleep_for(std::chrono::milliseconds(15));
    }
  }
  const PlacedControl* find(const std::string& name) const {
    for (const PlacedControl& c : ui_.placed())
      if (c.name == name) return &c;
    return nullptr;
  }
  const PlacedControl& control(const std::string& name) const {
    const PlacedControl* found = find(name);
    if (found == nullptr) throw std::out_of_range(name);
    return *found;
  }
  void click(const std::string& name) {
    const PlacedControl& c = control(name);
    press((c.left + c.right) / 2, (c.top + c.bottom) / 2);
  }
  void press(double x, double y) {
    ui_.take({MouseMoved{x, y}, MouseButtonEvent{MouseButton::left, true},
              MouseButtonEvent{MouseButton::left, false}});
    draw();
    ui_.take({MouseMoved{1, 1}});
    draw(2);
  }
  /// Replaces what a field has; an empty text clears it.
  void type(const std::string& name, const std::string& text) {
    click(name);
    type(text);
  }
  void type(const std::string& text) {
    ui_.take({KeyEvent{Key::control, true, false}, KeyEvent{key_of('A'), true, false},
              KeyEvent{key_of('A'), false, false}, KeyEvent{Key::control, false, false}});
    for (const char c : text) ui_.take({CharacterTyped{static_cast<char32_t>(c)}});
    if (text.empty())
      ui_.take({KeyEvent{Key::backspace, true, false}, KeyEvent{Key::backspace, false, false}});
    draw();
    tap(Key::enter);
  }
  /// Returns the number that follows these words in a reported result.
  double reported(const std::string& words) const {
    for (const PlacedControl& c : ui_.placed())
      if (c.name.starts_with("reported: " + words)) return std::stod(c.name.substr(10 + words.size()));
    throw std::out_of_range(words);
  }
  void tap(Key key) {
    ui_.take({KeyEvent{key, true, false}, KeyEvent{key, false, false}});
    draw();
  }
  /// Keeps a picture where somebody wants to look at them.
  void picture(const std::string& name) const {
    if (const char* folder = std::getenv("PROSECTOR_PICTURES"))
      write_png(ui_.read_pixels(), std::filesystem::path(folder) / (name + ".png"));
  }
  const std::vector<PlacedControl>& placed() const { return ui_.placed(); }
  int width() const { return context_->width(); }
  int height() const { return context_->height(); }
  ConfigDraft& draft() { return draft_; }
  const Said& said() const { return pages_.said(); }

 private:
  TemporaryFile folder_;
  std::filesystem::path file_;
  ConfigDraft draft_;
  SetupSession room_;
  std::unique_ptr<GlContext> context_;
  Interface ui_;
  Pages pages_;
};

}  // namespace prosector::test
