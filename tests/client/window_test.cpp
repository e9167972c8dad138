// Run under deploy/with_display.sh with xdotool (tests/client/CMakeLists.txt): a real window, a person's hand
// on the mouse.

#include "client/render/window_context.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <thread>

#include "common/error.h"
#include "tests/client/picture.h"

namespace prosector {
namespace {

using namespace test;

class Window : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::getenv("DISPLAY"))
      GTEST_SKIP() << "no DISPLAY: run under deploy/with_display.sh (packages xvfb, xdotool)";
  }
};

DrawList ball() {
  DrawList list;
  list.cameras = {straight_camera({0, 0, 1}, 200, 150)};
  DrawItem item;
  item.mesh = sphere_mesh(0.2, 1);
  list.items = {item};
  list.lights = {directional({0, 0, -1})};
  return list;
}

/// Polls until `wanted` is true of some event, for at most 5 s.
bool arrives(WindowContext& window, const std::function<bool(const WindowEvent&)>& wanted) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (std::chrono::steady_clock::now() < deadline) {
    for (const WindowEvent& event : window.poll_events())
      if (wanted(event)) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return false;
}

template <class Event>
const Event* as(const WindowEvent& event) {
  return std::get_if<Event>(&event);
}

void act(const std::string& xdotool) {
  ASSERT_EQ(std::system(("xdotool " + xdotool).c_str()), 0) << xdotool;
}

TEST_F(Window, ShowsTheSamePictureAsOffscreen) {
  const DrawList list = ball();
  const Image offscreen = picture_of(list, 200, 150);
  const auto window = make_window_context(200, 150, "test");
  Renderer renderer(*window, default_shader_dir());
  renderer.draw(list);
  window->present();
  EXPECT_TRUE(renderer.read_pixels() == offscreen) << window->description();
}

TEST_F(Window, TellsWhatAPersonDoes) {
  const auto window = make_window_context(200, 150, "test");
  window->present();
  act("mousemove 60 40");
  EXPECT_TRUE(arrives(*window, [](const WindowEvent& e) { return as<MouseMoved>(e) != nullptr; }));
  act("mousedown 1");
  EXPECT_TRUE(arrives(*window, [](const WindowEvent& e) {
    const auto* b = as<MouseButtonEvent>(e);
    return b && b->button == MouseButton::left && b->down;
  }));
  act("mouseup 1");
  EXPECT_TRUE(arrives(*window, [](const WindowEvent& e) {
    const auto* b = as<MouseButtonEvent>(e);
    return b && b->button == MouseButton::left && !b->down;
  }));
  act("click 4");
  EXPECT_TRUE(arrives(*window, [](const WindowEvent& e) {
    const auto* w = as<WheelTurned>(e);
    return w && w->y > 0;
  }));
  act("keydown w");
  EXPECT_TRUE(arrives(*window, [](const WindowEvent& e) {
    const auto* k = as<KeyEvent>(e);
    return k && k->key == key_of('W') && k->down && !k->repeat;
  }));
  act("keyup w");
  EXPECT_TRUE(arrives(*window, [](const WindowEvent& e) {
    const auto* k = as<KeyEvent>(e);
    return k && k->key == key_of('W') && !k->down;
  }));
  act("key Escape");
  EXPECT_TRUE(arrives(*window, [](const WindowEvent& e) {
    const auto* k = as<KeyEvent>(e);
    return k && k->key == Key::escape;
  }));
}

TEST_F(Window, FollowsItsSize) {
  const auto window = make_window_context(200, 150, "resize me");
  window->present();
  act("search --sync --name 'resize me' windowsize 260 180");
  EXPECT_TRUE(arrives(*window, [](const WindowEvent& e) {
    const auto* r = as<Resized>(e);
    return r && r->width == 260 && r->height == 180;
  }));
  EXPECT_EQ(window->width(), 260);
  EXPECT_EQ(window->height(), 180);
}

TEST_F(Window, FillsAMonitorAndComesBack) {
  const auto window = make_window_context(200, 150, "fill");
  window->present();
  const auto has_size = [&](bool small) {
    return arrives(*window, [&](const WindowEvent& e) {
      const auto* r = as<Resized>(e);
      return r && (r->width == 200 && r->height == 150) == small;
    });
  };
  window->set_full_screen(0);
  EXPECT_TRUE(has_size(false));
  EXPECT_GT(window->width(), 600);
  window->set_full_screen(std::nullopt);
  EXPECT_TRUE(has_size(true));
  EXPECT_EQ(window->height(), 150);
  try {
    window->set_full_screen(99);
    ADD_FAILURE() << "a hundredth monitor";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("monitor 99: there"), std::string::npos) << error.what();
  }
}

TEST_F(Window, GoesOnWhenTheAudienceLeaves) {
  const Image offscreen = picture_of(ball(), 200, 150);
  const auto window = make_window_context(200, 150, "taking part");
  Renderer renderer(*window, default_shader_dir());
  window->open_audience({.width = 320, .height = 200});
  const auto show = [&] {
    (void)window->poll_events();
    renderer.draw(ball());
    window->present();
  };
  show();
  act("search --sync --name 'Prosector: audience' windowsize 500 200");
  show();
  act("search --name 'Prosector: audience' windowfocus --sync key Escape");
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (std::system("xdotool search --name 'Prosector: audience' >/dev/null") == 0 &&
         std::chrono::steady_clock::now() < deadline)
    show();
  EXPECT_NE(std::system("xdotool search --name 'Prosector: audience' >/dev/null"), 0) << "still there";
  show();
  EXPECT_TRUE(renderer.read_pixels() == offscreen);
  EXPECT_THROW(window->open_audience({.monitor = 99}), InputError);
}

TEST(NoWindow, SaysWhatToDoWithoutADisplay) {
  const char* display = std::getenv("DISPLAY");
  const std::string kept = display ? display : "";
  unsetenv("DISPLAY");
  try {
    make_window_context(100, 100, "none");
    ADD_FAILURE() << "a window without a display";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("DISPLAY"), std::string::npos) << error.what();
  }
  if (display) setenv("DISPLAY", kept.c_str(), 1);
}

}  // namespace
}  // namespace prosector
