// Controls in pictures without a window, worked by events.
#include "client/setup/interface.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include "client/render/shader_dir.h"

namespace prosector {
namespace {

struct Page {
  explicit Page(double scale = 1, std::unique_ptr<GlContext> made = make_offscreen_context(320, 240))
      : context(std::move(made)), ui(*context, default_shader_dir(), scale) {}

  std::unique_ptr<GlContext> context;
  Interface ui;
  int pressed = 0;
  bool held = false;

  void draw() {
    ui.draw(1. / 30, [&] {
      ImGui::SetNextWindowPos({0, 0});
      ImGui::SetNextWindowSize({320, 240});
      ImGui::Begin("page", nullptr, ImGuiWindowFlags_NoDecoration);
      if (ImGui::Button("Press")) ++pressed;
      held = ImGui::IsItemActive();
      ui.note("press");
      ImGui::Button("Other");
      ui.note("other");
      ImGui::End();
    });
  }
  const PlacedControl& control(const std::string& name) const {
    for (const PlacedControl& c : ui.placed())
      if (c.name == name) return c;
    throw std::out_of_range(name);
  }
  MouseMoved over(const std::string& name) const {
    const PlacedControl& c = control(name);
    return {(c.left + c.right) / 2, (c.top + c.bottom) / 2};
  }
};

TEST(Interface, AClickIsAClickHoweverShort) {
  Page page;
  for (int k = 0; k < 2; ++k) page.draw();
  page.ui.take({page.over("press"), MouseButtonEvent{MouseButton::left, true},
                MouseButtonEvent{MouseButton::left, false}});
  page.draw();
  EXPECT_TRUE(page.held);
  EXPECT_TRUE(page.ui.behind());
  while (page.ui.behind()) page.draw();
  EXPECT_EQ(page.pressed, 1);
  page.ui.take({page.over("other"), MouseButtonEvent{MouseButton::left, true},
                MouseButtonEvent{MouseButton::left, false}});
  for (int k = 0; k < 4; ++k) page.draw();
  EXPECT_EQ(page.pressed, 1);
}

TEST(Interface, TheKeyboardAloneSuffices) {
  Page page;
  for (int k = 0; k < 2; ++k) page.draw();
  const auto tap = [&](Key key) {
    page.ui.take({KeyEvent{key, true, false}, KeyEvent{key, false, false}});
    for (int k = 0; k < 4; ++k) page.draw();
  };
  for (int k = 0; k < 2; ++k) tap(Key::up);
  tap(Key::space);
  EXPECT_EQ(page.pressed, 1);
  tap(Key::down);
  tap(Key::space);
  EXPECT_EQ(page.pressed, 1) << "that is the other one";
}

TEST(Interface, IsTheSameFromEveryContext) {
  Page egl(1, make_egl_context(320, 240)), osmesa(1, make_osmesa_context(320, 240));
  for (int k = 0; k < 3; ++k) egl.draw();
  const Image first = egl.ui.read_pixels();
  for (int k = 0; k < 3; ++k) osmesa.draw();
  EXPECT_EQ(first.rgb, osmesa.ui.read_pixels().rgb);
}

TEST(Interface, GrowsWithItsScale) {
  Page usual(1), large(2);
  for (int k = 0; k < 3; ++k) usual.draw();
  const PlacedControl one = usual.control("press");
  for (int k = 0; k < 3; ++k) large.draw();
  const PlacedControl two = large.control("press");
  EXPECT_NEAR((two.bottom - two.top) / (one.bottom - one.top), 2, 0.1);
  EXPECT_NEAR((two.right - two.left) / (one.right - one.left), 2, 0.1);
}

TEST(Interface, AControlsLettersAreInThePicture) {
  Page page;
  for (int k = 0; k < 3; ++k) page.draw();
  const Image picture = page.ui.read_pixels();
  const PlacedControl& button = page.control("press");
  int bright = 0;
  for (int y = static_cast<int>(button.top); y < static_cast<int>(button.bottom); ++y)
    for (int x = static_cast<int>(button.left); x < static_cast<int>(button.right); ++x)
      bright += picture.pixel(x, y)[0] > 200 ? 1 : 0;
  EXPECT_GT(bright, 40);
  EXPECT_LT(bright, 400);
}

}  // namespace
}  // namespace prosector
