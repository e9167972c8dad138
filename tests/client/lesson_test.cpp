// The lessons of docs/learn, gone through in one process: what they have a reader type and press there is,
// and the desk's lesson does on its scene what it says. deploy/learn.sh goes through them in real windows.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include "client/app/terminal/console.h"
#include "client/app/terminal/controls.h"
#include "common/scene/load_scene.h"
#include "server/physics/mechanics/soft/soft_body.h"
#include "tests/client/acted_desk.h"
#include "tests/folders.h"

namespace prosector::test {
namespace {

using Path = std::filesystem::path;

std::string text_of(const Path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The lessons, by the name of their page.
std::map<std::string, std::string> lessons() {
  std::map<std::string, std::string> out;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("docs/learn")))
    if (entry.path().stem() != "README") out[entry.path().stem().string()] = text_of(entry.path());
  return out;
}

std::vector<std::string> found_in(const std::string& text, const char* pattern) {
  std::vector<std::string> out;
  const std::regex regex(pattern);
  for (auto it = std::sregex_iterator(text.begin(), text.end(), regex); it != std::sregex_iterator(); ++it)
    out.push_back((*it)[1]);
  return out;
}

bool is_control(const std::string& key) {
  return std::ranges::any_of(controls, [&](const Control& control) {
    std::string input(control.input);
    std::ranges::replace(input, ',', ' ');
    std::istringstream words(input);
    for (std::string word; words >> word;)
      if (word == key) return true;
    return key.size() == 1 && std::isdigit(key[0]) != 0 && input.starts_with("1 to 9");
  });
}

TEST(Lessons, TypeOnlyWhatTheTerminalTakes) {
  std::map<ParticipantId, RosterEntry> roster;
  for (const char* name : {"Ann", "Ben"}) roster[roster.size() + 1].name = name;
  std::size_t typed = 0;
  for (const auto& [lesson, page] : lessons())
    for (const std::string& block : found_in(page, "```text\n([^`]*)```")) {
      std::istringstream lines(block);
      for (std::string line; std::getline(lines, line); ++typed) {
        const ConsoleLine read =
            parse_console_line(line, SceneInfo{}, roster, [](BodyId) { return Vec3(0, 1, 0); });
        const auto* refused = std::get_if<std::string>(&read);
        EXPECT_EQ(refused, nullptr) << lesson << ": " << line << ": " << (refused ? *refused : "");
      }
    }
  EXPECT_GE(typed, 7U);
}

TEST(Lessons, PressOnlyKeysThatDoSomething) {
  std::size_t pressed = 0;
  for (const auto& [lesson, page] : lessons())
    for (const std::string& key : found_in(page, "`([A-Z]|[0-9]|Home|Tab|Space|Esc|F[0-9]+)`")) {
      EXPECT_TRUE(is_control(key)) << lesson << ": " << key;
      ++pressed;
    }
  EXPECT_GE(pressed, 20U);
}

/// The scene that a lesson opens, with the shapes that it falls back to, coarsely: what can be done in it is
/// the same.
SceneDesc scene_of(const std::string& lesson) {
  const auto named = found_in(lessons().at(lesson), "prosector-server deploy/scenes/([a-z_]+[.]toml)");
  EXPECT_FALSE(named.empty()) << lesson << " opens no scene";
  SceneDesc scene = load_scene(source_path("deploy/scenes/" + named.at(0)));
  for (SoftDesc& soft : scene.soft) {
    soft.geometry.cell *= 1.5;
    soft.geometry.surface_cell *= 1.5;
    soft.material.tension = {};
  }
  return scene;
}

CompileOptions on_one_thread() {
  CompileOptions options;
  options.threads = 1;
  return options;
}

struct DeskLesson : testing::Test {
  Simulation simulation{scene_of("desk"), on_one_thread()};
  ActedDesk desk{simulation, Haste{}};
  const BodyId liver = body_named(simulation, "liver"), kidney = body_named(simulation, "kidney"),
               scalpel = body_named(simulation, "scalpel");
  static inline const Vec3 on_liver{0.03, 1.03, -0.02}, handle{0.29, 0.91, 0.08},
      cut_from{-0.04, 1.03, -0.02}, cut_to{0.05, 1.03, -0.02};  // m

  /// Types a line at the client's terminal.
  void type(const std::string& line) {
    SceneInfo scene;
    for (BodyId body = 0; body < simulation.body_count(); ++body)
      scene.bodies.emplace_back().name = simulation.name(body);
    const ConsoleLine read = parse_console_line(line, scene, {}, [](BodyId) { return Vec3(0, 1, 0); });
    ASSERT_TRUE(std::holds_alternative<CommandBody>(read)) << line;
    desk.ask(std::get<CommandBody>(read));
    desk.wait(0.2);
  }
  void set(PanelControl control, double value) {
    desk.ask(SetControl{control, value});
    desk.wait(1.5);  // a person's pace: a detached liver has sunk by then
  }
  std::string messages() const { return desk.messages().empty() ? "" : desk.messages().back(); }
};

TEST_F(DeskLesson, TouchesTheLiver) {
  desk.point_at(on_liver);
  desk.wait(1);
  desk.press();
  EXPECT_TRUE(desk.waits_until_held(liver, true, 5)) << messages();
  desk.let_go();
  EXPECT_TRUE(desk.waits_until_held(liver, false, 2));
}

TEST_F(DeskLesson, AsksAPartWhatItIs) {
  desk.point_at(on_liver);
  desk.wait(0.5);
  for (const BodyId part : {liver, kidney, body_named(simulation, "gallbladder")}) {
    desk.ask(OpenPanel{part});
    desk.wait(1);
    ASSERT_EQ(simulation.panels().size(), 1U) << simulation.name(part) << ": " << messages();
    EXPECT_EQ(simulation.panels()[0].body, part);
  }
  desk.ask(OpenPanel{liver});
  desk.wait(1);
  set(PanelControl::attach, 0);
  EXPECT_FALSE(simulation.part(liver).attached) << messages();
  set(PanelControl::attach, 1);
  EXPECT_TRUE(simulation.part(liver).attached) << messages();
  set(PanelControl::light_shaft, 1);
  EXPECT_TRUE(simulation.part(liver).lit);
  set(PanelControl::stiffness, 0.75);
  EXPECT_GT(simulation.part(liver).stiffness, 1.5);
  desk.ask(ClosePanel{});
  desk.wait(0.5);
  EXPECT_TRUE(simulation.panels().empty());
  EXPECT_TRUE(desk.messages().empty()) << messages();
}

TEST_F(DeskLesson, DoesTheSameAtTheTerminal) {
  type("detach kidney");
  EXPECT_FALSE(simulation.part(kidney).attached) << messages();
  type("attach kidney");
  EXPECT_TRUE(simulation.part(kidney).attached) << messages();
  type("inspect liver 2");
  EXPECT_TRUE(simulation.part(liver).inspected) << messages();
  type("end liver");
  EXPECT_FALSE(simulation.part(liver).inspected) << messages();
  EXPECT_TRUE(desk.messages().empty()) << messages();
}

TEST_F(DeskLesson, CutsTheLiverAndTakesItBack) {
  desk.point_at(handle);
  desk.wait(1);
  desk.press();
  ASSERT_TRUE(desk.waits_until_held(scalpel, true, 5)) << messages();
  desk.let_go();
  desk.wait(1.5);
  desk.draw(handle, cut_from, 1);
  desk.wait(1.5);
  desk.press();
  desk.draw(cut_from, cut_to, 2);
  desk.let_go();
  for (int k = 0; k < 60 && desk.draws(); ++k) desk.wait(0.5);
  ASSERT_GT(simulation.revision(liver), 0U) << "nothing was cut: " << messages();
  EXPECT_TRUE(desk.holds(scalpel));
  const std::size_t tets = simulation.soft(liver).anatomy().tets.tets.size();
  desk.take_back();
  desk.wait(1);
  EXPECT_LT(simulation.soft(liver).anatomy().tets.tets.size(), tets);
  EXPECT_TRUE(desk.messages().empty()) << messages();
}

// A picture that takes 3 s drops nothing.
TEST_F(DeskLesson, KeepsTheScalpelThroughAStall) {
  desk.point_at(handle);
  desk.wait(1);
  desk.press();
  ASSERT_TRUE(desk.waits_until_held(scalpel, true, 5)) << messages();
  desk.let_go();
  desk.draw(handle, cut_from, 1);
  desk.wait(1);
  desk.stall(3);
  EXPECT_TRUE(desk.holds(scalpel));
  desk.wait(1);
  EXPECT_TRUE(desk.holds(scalpel));
  EXPECT_TRUE(desk.messages().empty()) << messages();
}

}  // namespace
}  // namespace prosector::test
