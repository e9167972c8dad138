// What a viewer chooses to see of the parts: the list, what mouse, keys and terminal do to it, and how it
// finds.

#include <gtest/gtest.h>

#include "client/app/desk/parts_desk.h"
#include "client/app/terminal/parts_commands.h"
#include "client/replica/shown_names.h"
#include "client/text/search_key.h"

namespace prosector {
namespace {

using Kind = PartsOrder::Kind;

SceneBody body(const std::string& name, const std::string& german, const std::string& term = "") {
  SceneBody out;
  out.name = name;
  out.names = {{"de", german}};
  out.term = term;
  out.kind = BodyKind::soft;
  out.part = true;
  return out;
}

/// A liver and what was cut off it twice, a kidney, a bone, a scalpel, a table; seen by a reader of
/// `language`.
PartsData known(const std::string& language = "de") {
  PartsData out;
  out.scene.bodies = {body("liver", "große Drüse (Leber)", "A05.8.01.001"),
                      body("left kidney", "linke Niere"),
                      body("femur", "Oberschenkelknochen"),
                      body("scalpel", "Skalpell"),
                      body("table", "Tisch"),
                      body("liver 2", "große Drüse (Leber) 2"),
                      body("liver 3", "große Drüse (Leber) 3")};
  out.scene.bodies[2].appearance.surface = Surface::bone;
  out.scene.bodies[3].kind = out.scene.bodies[4].kind = BodyKind::rigid;
  out.scene.bodies[3].part = out.scene.bodies[4].part = false;
  out.scene.bodies[3].moves = true;
  show_names(out.scene, language);
  const std::vector<std::int32_t> piece_of = {-1, -1, -1, -1, -1, 0, 5};
  out.organs = organs_of(out.scene, [&](BodyId id) { return piece_of[id]; });
  out.holders.resize(out.scene.bodies.size());
  out.holders[6] = {{"Ada", {1, 0, 0}}};
  out.holders[0] = {{"Ada", {1, 0, 0}}, {"Grace", {0, 1, 0}}};
  return out;
}

std::vector<std::string> names_of(const std::vector<PartRow>& rows) {
  std::vector<std::string> out;
  for (const PartRow& row : rows) out.push_back(row.text);
  return out;
}

std::vector<std::string> found(const std::string& search) {
  std::vector<std::string> out;
  for (const PartRow& row : part_rows(known(), {}, search))
    if (!row.is_head) out.push_back(row.parts.front());
  return out;
}

TEST(SearchKey, HasNeitherCaseNorMarks) {
  const std::vector<std::pair<const char*, const char*>> same = {{"große Drüse", "GROSSE  druse"},
                                                                 {"sağ göğüs", "SAG GOGUS"},
                                                                 {"İğne", "igne"},
                                                                 {"ışık", "IŞIK"},
                                                                 {"ήπαρ", "ΗΠΑΡ"},
                                                                 {"печень", "ПЕЧЕНЬ"},
                                                                 {"cœur", "COEUR"},
                                                                 {" a\t b ", "A B"},
                                                                 {"ὀστοῦς", "οστουσ"},
                                                                 {"כָּבֵד", "כבד"},
                                                                 {"Ångström", "angstrom"},
                                                                 {"tiếng Việt", "tieng viet"}};
  for (const auto& [a, b] : same) EXPECT_EQ(search_key(a), search_key(b)) << a;
  EXPECT_NE(search_key("肝"), search_key("腎"));
  EXPECT_NE(search_key("liver"), search_key("lives"));
  EXPECT_FALSE(search_key("肝脏").empty());
}

TEST(SearchKey, FindsEachWordAnywhere) {
  EXPECT_TRUE(is_found(search_key("left superior frontal gyrus"), search_key("front LEFT")));
  EXPECT_FALSE(is_found(search_key("left superior frontal gyrus"), search_key("front right")));
  EXPECT_TRUE(is_found(search_key("anything"), search_key("  ")));
}

TEST(PartRows, AreGroupedWithPiecesBelowTheirOrgan) {
  EXPECT_EQ(names_of(part_rows(known(), {}, "")),
            (std::vector<std::string>{"Anatomy · 2", "große Drüse (Leber)", "linke Niere", "Bones · 1",
                                      "Oberschenkelknochen", "Instruments and objects · 1", "Skalpell",
                                      "Room · 1", "Tisch"}));
  const PartRow liver = part_rows(known(), {}, "")[1];
  EXPECT_EQ(liver.bodies, (std::vector<BodyId>{0, 5, 6}));
  ASSERT_EQ(liver.holders.size(), 2u) << "each once";
  EXPECT_EQ(liver.holders[1].name, "Grace");
}

TEST(PartRows, HaveBonesThatLieAboutAmongTheBones) {
  PartsData loose = known();
  loose.scene.bodies[2].part = false;
  loose.scene.bodies[2].moves = true;
  const auto names = names_of(part_rows(loose, {}, ""));
  ASSERT_EQ(names[3], "Bones · 1");
  EXPECT_EQ(names[4], "Oberschenkelknochen");
}

TEST(PartRows, AreFoundByNameInAnyLanguageAndByNumber) {
  for (const char* search : {"LIVER", "grosse druse", "Leber", "a05.8"})
    EXPECT_EQ(found(search), std::vector<std::string>{"liver"}) << search;
  EXPECT_EQ(found("kidney left"), std::vector<std::string>{"left kidney"});
  EXPECT_TRUE(found("spleen").empty());
  EXPECT_EQ(found("").size(), 5u);
}

TEST(PartsChoice, HidesIsolatesColoursAndResets) {
  PartsChoice choice;
  choice.obey({.kind = Kind::hide, .parts = {"liver"}});
  choice.obey({.kind = Kind::opacity, .parts = {"kidney"}, .opacity = 0.4});
  choice.obey({.kind = Kind::color, .parts = {"kidney"}, .color = Vec3(0, 0, 1)});
  EXPECT_TRUE(choice.look_of("liver", true).hidden);
  EXPECT_EQ(choice.look_of("kidney", true).opacity, 0.4);
  EXPECT_EQ(choice.look_of("kidney", true).color, std::optional(Vec3(0, 0, 1)));
  EXPECT_EQ(choice.look_of("bone", true), PartLook());

  choice.obey({.kind = Kind::isolate_next, .parts = {"liver"}});
  EXPECT_FALSE(choice.look_of("liver", true).hidden) << "what is isolated is shown";
  EXPECT_EQ(choice.look_of("bone", true).opacity, faint_opacity);
  EXPECT_EQ(choice.look_of("table", false), PartLook()) << "no anatomy";
  choice.obey({.kind = Kind::isolate_next, .parts = {"liver"}});
  EXPECT_TRUE(choice.look_of("bone", true).hidden);
  choice.obey({.kind = Kind::isolate_next, .parts = {"liver"}});
  EXPECT_EQ(choice.look_of("bone", true), PartLook());
  EXPECT_EQ(choice.look_of("kidney", true).opacity, 0.4) << "as it was before";

  choice.obey({.kind = Kind::opacity, .parts = {"bone"}, .opacity = 0});
  EXPECT_EQ(choice.look_of("bone", true).opacity, least_opacity) << "hiding is something else";
  choice.obey({.kind = Kind::reset_all});
  for (const char* part : {"liver", "kidney", "bone"}) EXPECT_EQ(choice.look_of(part, true), PartLook());
}

// ---- At the terminal

PartsOrder order(const std::string& line) {
  const auto parsed = parse_parts_line(line, known(), {});
  EXPECT_TRUE(parsed && std::holds_alternative<PartsOrder>(*parsed)) << line;
  return parsed && std::holds_alternative<PartsOrder>(*parsed) ? std::get<PartsOrder>(*parsed) : PartsOrder{};
}

std::string words(const std::string& line) {
  const auto parsed = parse_parts_line(line, known(), {});
  EXPECT_TRUE(parsed && std::holds_alternative<std::string>(*parsed)) << line;
  return parsed && std::holds_alternative<std::string>(*parsed) ? std::get<std::string>(*parsed) : "";
}

TEST(PartsCommands, SayWhatTheListDoes) {
  const std::vector<std::string> liver = {"liver"}, kidney = {"left kidney"};
  EXPECT_EQ(order("hide liver").kind, Kind::hide);
  EXPECT_EQ(order("hide liver").parts, liver) << "and not its pieces, which follow it";
  EXPECT_EQ(order("  show   linke Niere ").parts, kidney);
  EXPECT_EQ(order("show all").kind, Kind::reset_all);
  EXPECT_EQ(order("isolate left kidney").opacity, 0);
  EXPECT_EQ(order("isolate left kidney 15 %").opacity, 0.15);
  EXPECT_TRUE(order("isolate").parts.empty());
  EXPECT_EQ(order("opacity left kidney 40%").opacity, 0.4);
  EXPECT_EQ(order("opacity left kidney 40 %").parts, kidney);
  EXPECT_EQ(order("colour left kidney sky blue").color, std::optional(part_colors()[1].color));
  EXPECT_EQ(order("colour left kidney own").color, std::nullopt);
  EXPECT_EQ(order("color left kidney blue").parts, kidney);
  EXPECT_EQ(order("labels").kind, Kind::labels);
  EXPECT_EQ(order("hide er").parts.size(), 3u) << "what no part is called is searched for";
}

TEST(PartsCommands, SayWhatIsWrong) {
  EXPECT_NE(words("hide spleen").find("spleen"), std::string::npos);
  EXPECT_NE(words("opacity liver").find("5 to 100"), std::string::npos);
  EXPECT_NE(words("opacity liver 140 %").find("5 to 100"), std::string::npos);
  EXPECT_NE(words("opacity liver nan %").find("5 to 100"), std::string::npos);
  EXPECT_NE(words("colour liver mauve").find("sky blue"), std::string::npos);
  EXPECT_EQ(parse_parts_line("reset all", known(), {}), std::nullopt);
  EXPECT_EQ(parse_parts_line("", known(), {}), std::nullopt);
  EXPECT_NE(words("parts niere").find("linke Niere"), std::string::npos);
  EXPECT_NE(words("parts").find("held by Ada, held by Grace"), std::string::npos);
}

// ---- With mouse and keys

class AtTheList : public testing::Test {
 protected:
  static constexpr double width = 800, height = 600;
  PartsDesk desk;
  PartsChoice choice;
  Eigen::Vector2d pointer{100, 300};

  void lay_out(std::optional<BodyId> pointed = {}) {
    for (const PartsOrder& one : desk.take_orders()) choice.obey(one);
    desk.lay_out(part_rows(known(), choice, desk.search()), pointed, {width, height});
  }
  bool press(Key key) {
    const bool taken = desk.take(KeyEvent{key, true, false}, pointer);
    desk.take(KeyEvent{key, false, false}, pointer);
    return taken;
  }
  void open() {
    press(key_of('L'));
    desk.take(CharacterTyped{U'l'}, pointer);
    lay_out();
  }
  void type(std::u32string_view text) {
    for (const char32_t c : text) desk.take(CharacterTyped{c}, pointer);
    lay_out();
  }
  /// Moves to the first place of the list that is such a spot; false: there is none.
  bool go_to(const PartsSpot& wanted) {
    for (double y = 1; y < height; y += 3)
      for (double x = 1; x < width; x += 3)
        if (spot_at(*desk.shown(), {x, y}) == std::optional(wanted)) {
          pointer = {x + 2, y + 2};
          desk.take(MouseMoved{pointer.x(), pointer.y()}, pointer);
          return true;
        }
    return false;
  }
  void click(const PartsSpot& wanted) {
    ASSERT_TRUE(go_to(wanted));
    EXPECT_TRUE(desk.take(MouseButtonEvent{MouseButton::left, true}, pointer));
    EXPECT_TRUE(desk.take(MouseButtonEvent{MouseButton::left, false}, pointer));
    lay_out();
  }
  PartLook liver() const { return choice.look_of("liver", true); }
};

TEST_F(AtTheList, SearchesAsOneTypesAndEscapeShutsOneThingAfterTheOther) {
  open();
  EXPECT_EQ(desk.search(), "") << "the key that opened it is no search";
  type(U"NİERE");
  ASSERT_EQ(desk.shown()->rows.size(), 2u);
  EXPECT_TRUE(press(key_of('W'))) << "typing does not fly";
  for (int k = 0; k < 5; ++k) press(Key::backspace);
  type(U"skal");
  EXPECT_EQ(desk.search(), "skal");
  EXPECT_EQ(desk.shown()->rows[1].text, "Skalpell");
  EXPECT_TRUE(press(Key::escape));
  lay_out();
  EXPECT_EQ(desk.search(), "");
  EXPECT_EQ(desk.shown()->rows.size(), 9u);
  EXPECT_FALSE(press(key_of('W'))) << "keys are the room's again";
  EXPECT_TRUE(press(Key::escape));
  EXPECT_FALSE(desk.is_open());
  EXPECT_FALSE(press(Key::escape)) << "leaves";
}

TEST_F(AtTheList, EyeTargetSliderColoursAndResetDoWhatTheySay) {
  open();
  click({PartsSpot::Kind::eye, 1, 0});
  EXPECT_TRUE(liver().hidden);
  click({PartsSpot::Kind::eye, 1, 0});
  EXPECT_FALSE(liver().hidden);
  click({PartsSpot::Kind::isolate, 2, 0});
  EXPECT_EQ(liver().opacity, faint_opacity);
  click({PartsSpot::Kind::swatch, 1, 0});
  click({PartsSpot::Kind::color, 1, 4});
  EXPECT_EQ(liver().color, std::optional(part_colors()[4].color));
  click({PartsSpot::Kind::reset, 0, 0});
  EXPECT_EQ(liver(), PartLook());
  click({PartsSpot::Kind::eye, 0, 0});
  EXPECT_TRUE(liver().hidden && choice.look_of("left kidney", true).hidden) << "a head: all below it";
}

TEST_F(AtTheList, TheSliderFollowsThePointerWhileTheButtonIsDown) {
  open();
  ASSERT_TRUE(go_to({PartsSpot::Kind::slider, 1, 0}));
  desk.take(MouseButtonEvent{MouseButton::left, true}, pointer);
  double last = 0;
  for (const double x : {790.0 - 54, 790.0 - 36, 790.0 + 5}) {
    pointer.x() = x;
    desk.take(MouseMoved{x, 500}, {x, 500});
    lay_out();
    EXPECT_GT(liver().opacity, last);
    last = liver().opacity;
    EXPECT_TRUE(desk.has_pointer());
  }
  EXPECT_EQ(last, 1);
  desk.take(MouseButtonEvent{MouseButton::left, false}, pointer);
  desk.take(MouseMoved{400, 500}, {400, 500});
  lay_out();
  EXPECT_EQ(liver().opacity, 1);
  EXPECT_FALSE(desk.has_pointer());
}

TEST_F(AtTheList, AClickOnANameFramesThePartWithItsPieces) {
  open();
  click({PartsSpot::Kind::name, 1, 0});
  EXPECT_EQ(desk.take_framed(), (std::vector<BodyId>{0, 5, 6}));
  EXPECT_TRUE(desk.take_framed().empty());
  EXPECT_EQ(desk.hovered_bodies(), (std::vector<BodyId>{0, 5, 6}));
}

TEST_F(AtTheList, LeavesTheRoomWhatIsNotOnIt) {
  open();
  pointer = {100, 300};
  desk.take(MouseMoved{100, 300}, pointer);
  EXPECT_FALSE(desk.has_pointer());
  EXPECT_FALSE(desk.take(MouseButtonEvent{MouseButton::left, true}, pointer));
  EXPECT_FALSE(press(key_of('W'))) << "a click into the room ends typing";
  EXPECT_FALSE(desk.take(WheelTurned{0, 1}, pointer));
  EXPECT_TRUE(press(key_of('N')));
  lay_out();
  EXPECT_TRUE(choice.labels());
}

TEST(PartsListLayout, ScrollsWithinWhatThereIsAndToWhatIsPointedAt) {
  PartsData many;
  for (int k = 0; k < 116; ++k) many.scene.bodies.push_back(body("region " + std::to_string(k), "Region"));
  many.organs = organs_of(many.scene, [](BodyId) { return -1; });
  many.holders.resize(116);
  PartsListState state;
  state.first = 1000;
  const PartsList list = lay_out_parts(part_rows(many, {}, ""), state, {800, 600});
  EXPECT_EQ(list.all_lines, 117u);
  EXPECT_EQ(list.lines.size(), line_capacity(list));
  EXPECT_EQ(list.lines.back().row, 116u);
  for (const PartsList::Line& line : list.lines) EXPECT_LE(line.top + 20, list.lines_area.max().y() + 1e-9);
  scroll_to(state = list.state, list, 10);
  EXPECT_EQ(state.first, 10u);
  DrawList drawn;
  add_parts_list(drawn, list);
  for (const DrawText& text : drawn.texts) {
    EXPECT_TRUE(list.board.contains(text.at.head<2>().eval())) << text.text;
    EXPECT_GT(text.wrap, 0) << text.text;
  }
}

}  // namespace
}  // namespace prosector
