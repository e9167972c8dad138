// The set-up window's pages, drawn without a window and worked by events.
#include "client/setup/pages.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "client/render/image.h"
#include "client/render/shader_dir.h"
#include "tests/dds_domains.h"
#include "tests/session/temporary_file.h"
#include "tests/setup/written_file.h"

namespace prosector::test {
namespace {

BusConfig test_bus() {
  BusConfig out;
  out.domain = dds_domain::set_up;
  return out;
}

/// A window of a person with a configuration. `scale`: of letters, and with `wide` of the window, too.
class Room {
 public:
  Room(const std::string& config, double scale, double wide = 1)
      : folder_("pages"),
        file_(folder_.path / "client.toml"),
        draft_((write_file(file_, config), file_)),
        room_({.bus = test_bus(),
               .scenes = folder_.path,
               .cache = folder_.path,
               .memory = folder_.path / "m.toml",
               .config = file_}),
        context_(make_offscreen_context(static_cast<int>(1280 * wide), static_cast<int>(720 * wide))),
        ui_(*context_, default_shader_dir(), scale),
        pages_(room_, draft_,
               [] {
                 return MachineCheck{"Pictures", CheckState::good, "8 ms"};
               },
               {{"5dt_hmd_800_26", 800, 600, false}}) {
    draw(3);
  }
  ~Room() { std::filesystem::remove_all(folder_.path); }

  void draw(int pictures = 4) {
    for (int k = 0; k < pictures || ui_.behind(); ++k) ui_.draw(1. / 30, [&] { pages_.draw(ui_); });
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
  Anteroom room_;
  std::unique_ptr<GlContext> context_;
  Interface ui_;
  Pages pages_;
};

constexpr const char* no_devices = "# none\n";

TEST(Pages, NothingOfThemIsBesideTheWindow) {
  for (const double scale : {1., 2.}) {
    Room room(no_devices, scale, scale);
    for (const char* page : {"Enter", "Devices", "Calibrate", "Pictures and eyes", "Checks"}) {
      room.click(page);
      room.picture(std::string(page) + (scale == 1 ? "-1x" : "-2x"));
      for (const PlacedControl& c : room.placed()) {
        EXPECT_GE(c.left, 0) << page << " " << c.name;
        EXPECT_LE(c.right, room.width()) << page << " " << c.name;
        EXPECT_LE(c.bottom, room.height()) << page << " " << c.name;
      }
    }
  }
}

TEST(Pages, TheRulerFindsHowFarEyesAreApart) {
  Room room(no_devices, 1);
  room.click("Pictures and eyes");
  const PlacedControl& card = room.control("card");
  EXPECT_NEAR(card.right - card.left, 0.0856 / 0.265e-3, 1);
  room.click("reckon");
  EXPECT_EQ(room.said().words, "Done.");
  EXPECT_NEAR(room.draft().config().eyes.distance.value_or(0), 0.06, 1e-9) << "20 mm at 600 and 450 mm";
  room.picture("ruler");
  room.click("save");
  EXPECT_FALSE(room.draft().changed());
  // A press moves the mark that is nearer: at 150 mm the left eye's, which is too far from the other one.
  room.click("once more");
  const PlacedControl ruler = room.control("ruler");
  room.press(ruler.left + 150e-3 / 0.265e-3, (ruler.top + ruler.bottom) / 2);
  room.click("reckon");
  EXPECT_NE(room.said().words.find("people have"), std::string::npos) << room.said().words;
  EXPECT_FALSE(room.draft().changed());
}

TEST(Pages, CrossesWantAHeadWithAReceiver) {
  Room room("[tracker]\naddress = \"fastrak:/nowhere\"\n", 1);
  room.click("Pictures and eyes");
  room.click("by crosses");
  room.picture("crosses-wishes");
  room.click("begin eyes");
  EXPECT_TRUE(room.said().wrong);
  EXPECT_NE(room.said().words.find("head"), std::string::npos) << room.said().words;
}

TEST(Pages, CrossesComeOverTheWholeWindowAndSpaceConfirms) {
  for (const double scale : {1., 2.}) {
    Room room("[tracker]\naddress = \"fastrak:/nowhere\"\nstations.head.station = 2\n", scale, scale);
    room.click("Pictures and eyes");
    room.click("by crosses");
    room.click("begin eyes");
    ASSERT_NE(room.find("covered"), nullptr);
    EXPECT_LT(room.control("covered").right, room.width() / 2) << "the left eye's first";
    room.tap(Key::space);
    room.picture(scale == 1 ? "crosses-1x" : "crosses-2x");
    EXPECT_EQ(room.said().words, "Cross 1 of 32") << "no head was still";
    EXPECT_NE(room.find("trouble"), nullptr);
    room.click("stop");
    EXPECT_EQ(room.find("covered"), nullptr);
    EXPECT_EQ(room.said().words, "Stopped: nothing is changed.");
    EXPECT_FALSE(room.draft().changed());
  }
}

}  // namespace
}  // namespace prosector::test
