// The table of controls: the help that is made of it, and the documentation that is held to it.

#include "client/app/terminal/controls.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <set>
#include <sstream>
#include <string>

#include "client/view/help_board.h"
#include "client/view/set_text.h"
#include "tests/folders.h"

namespace prosector {
namespace {

constexpr std::array at_the_desk = {ControlDevice::hand, ControlDevice::view};

TEST(Controls, EachRoleIsToldWhatItMayDoAndNothingElse) {
  const std::string observer = help_text(Role::observer, at_the_desk);
  const std::string dissector = help_text(Role::dissector, at_the_desk);
  EXPECT_EQ(observer.find("hand"), std::string::npos) << observer;
  EXPECT_NE(observer.find("Tab"), std::string::npos);
  EXPECT_NE(dissector.find("your hand hovers"), std::string::npos);
  EXPECT_NE(dissector.find("Tab"), std::string::npos);
  constexpr std::array terminal = {ControlDevice::terminal};
  EXPECT_EQ(help_text(Role::dissector, terminal).find("give"), std::string::npos);
  EXPECT_NE(help_text(Role::host, terminal).find("give"), std::string::npos);
}

TEST(Controls, AreToldOfFirstByTheKeyThatShowsThem) {
  const auto dissector = first_hints(Role::dissector, at_the_desk);
  ASSERT_EQ(dissector.size(), 2u);
  EXPECT_EQ(dissector[0].substr(0, 3), "H: ");
  EXPECT_NE(help_text(Role::observer, at_the_desk).find("\n  H, "), std::string::npos);
  EXPECT_NE(dissector[1].find("left button"), std::string::npos);
  EXPECT_EQ(first_hints(Role::observer, at_the_desk), std::vector{dissector[0]}) << "has no hand";
  constexpr std::array gloves = {ControlDevice::headset, ControlDevice::view};
  EXPECT_EQ(first_hints(Role::dissector, gloves), std::vector{dissector[0]}) << "has no mouse for a hand";
}

TEST(Controls, StandInTheSameColumnsAtATerminalAndInAPicture) {
  std::istringstream blanks(help_text(Role::host, at_the_desk));
  std::istringstream tabs(help_text(Role::host, at_the_desk, HelpColumns::tabs));
  std::size_t column = 0;
  for (std::string plain, tabbed; std::getline(tabs, tabbed) && std::getline(blanks, plain);) {
    const std::size_t tab = tabbed.find('\t');
    if (tab == std::string::npos) {
      EXPECT_EQ(plain, tabbed) << "a head";
      continue;
    }
    const std::size_t does = plain.rfind(tabbed.substr(tab + 1));
    ASSERT_NE(does, std::string::npos) << plain;
    if (column == 0) column = does;
    EXPECT_EQ(does, column) << plain;
    EXPECT_EQ(plain.find(tabbed.substr(0, tab)), 2u) << plain;
  }
  EXPECT_GT(column, 0u);
}

TEST(Controls, HaveOneRowForEachInputOfADeviceAndShortLines) {
  std::set<std::pair<ControlDevice, std::string_view>> seen;
  for (const Control& control : controls) {
    EXPECT_TRUE(seen.emplace(control.device, control.input).second) << control.input;
    EXPECT_FALSE(control.does.empty());
  }
  std::istringstream lines(help_text(Role::host, at_the_desk));
  for (std::string line; std::getline(lines, line);) EXPECT_LT(line.size(), 80u) << line;
}

TEST(Controls, AreAllOnTheBoardOfHelpInASmallWindowAndAtTwiceTheScale) {
  constexpr std::array devices = {ControlDevice::hand, ControlDevice::view, ControlDevice::gamepad};
  Typesetter typesetter;
  for (const char* language : {"en", "de", "tr"})
    for (const double scale : {1.0, 2.0})
      for (const Eigen::Vector2i& size : {Eigen::Vector2i(640, 480), Eigen::Vector2i(1600, 900)}) {
        DrawList list;
        list.scale = scale;
        list.cameras.emplace_back();
        list.cameras[0].width = size.x();
        list.cameras[0].height = size.y();
        add_help(list, help_text(Role::host, devices, HelpColumns::tabs, catalogue_for(language)));
        ASSERT_EQ(list.texts.size(), 2u);
        for (const DrawText& text : list.texts) {
          const SetText set = set_text(typesetter, text, scale);
          EXPECT_FALSE(set.block->cut) << language << text.text;
          EXPECT_GE(set.size, 7) << "pixels, " << language;
          EXPECT_LE(scale * text.at.x() + set.width(), size.x());
          EXPECT_LE(scale * text.at.y() + set.height(), size.y());
        }
      }
}

TEST(Controls, AreToldInTheUsersLanguageButCommandsAsTheyAreTyped) {
  const Catalogue german = catalogue_for("de");
  const std::string help = help_text(Role::host, at_the_desk, HelpColumns::tabs, german);
  EXPECT_NE(help.find("Rad\twie hoch sie schwebt, bis zum Eindrücken"), std::string::npos) << help;
  EXPECT_EQ(help.find("hovers"), std::string::npos);
  constexpr std::array terminal = {ControlDevice::terminal};
  EXPECT_EQ(help_text(Role::host, terminal, HelpColumns::tabs, german),
            help_text(Role::host, terminal, HelpColumns::tabs));
}

TEST(Controls, StandInOneColumnWhateverLettersALanguageHas) {
  std::istringstream lines(help_text(Role::host, at_the_desk, HelpColumns::blanks, catalogue_for("tr")));
  std::set<std::size_t> columns;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  ")) continue;
    const std::size_t does = line.find_first_not_of(' ', line.find("  ", 2));
    columns.insert(
        static_cast<std::size_t>(std::count_if(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(does),
                                               [](char c) { return (c & 0xc0) != 0x80; })));
  }
  EXPECT_EQ(columns.size(), 1u);
}

TEST(Controls, AreInTheDocumentationAsTheyAreHere) {
  std::stringstream page;
  for (const char* name : {"join.md", "watch-recordings.md"})
    page << std::ifstream(source_path("docs/do/") + name).rdbuf();
  constexpr std::array<std::pair<std::string_view, ControlDevice>, 6> tables = {
      {{"hand", ControlDevice::hand},
       {"view", ControlDevice::view},
       {"gamepad", ControlDevice::gamepad},
       {"headset", ControlDevice::headset},
       {"terminal", ControlDevice::terminal},
       {"recording", ControlDevice::recording}}};
  for (const auto& [name, device] : tables) {
    const std::string expected = "<!-- controls: " + std::string(name) + " -->\n" +
                                 controls_in_markdown(device) + "<!-- /controls -->\n";
    EXPECT_NE(page.str().find(expected), std::string::npos)
        << "docs/do differs from client/app/terminal/controls.h; put there:\n"
        << expected;
  }
}

}  // namespace
}  // namespace prosector
