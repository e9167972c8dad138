#pragma once
// A window without a display, whose events a test makes.

#include <string>
#include <utility>
#include <vector>

#include "client/render/window_context.h"

namespace prosector::test {

class ActedWindow final : public WindowContext {
 public:
  explicit ActedWindow(int width = 800, int height = 600) : width_(width), height_(height) {}

  std::vector<WindowEvent> events;

  void press(Key key) {
    events.push_back(KeyEvent{key, true, false});
    events.push_back(KeyEvent{key, true, true});  // held
    events.push_back(KeyEvent{key, false, false});
  }
  void drag_right(double x, double y) {
    events.insert(events.end(), {MouseMoved{100, 100}, MouseButtonEvent{MouseButton::right, true},
                                 MouseMoved{100 + x, 100 + y}, MouseButtonEvent{MouseButton::right, false}});
  }

  std::vector<WindowEvent> poll_events() override { return std::exchange(events, {}); }
  void capture_pointer(bool) override {}
  void set_full_screen(std::optional<int>) override {}
  void open_audience(const Audience&) override {}
  double content_scale() const override { return 1; }
  void* proc(const char*) const override { return nullptr; }
  int width() const override { return width_; }
  int height() const override { return height_; }
  bool has_screen() const override { return true; }
  void present() override {}
  std::string description() const override { return "a window in which somebody acts"; }

 private:
  int width_, height_;  // pixels
};

}  // namespace prosector::test
