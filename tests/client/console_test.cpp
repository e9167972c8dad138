#include "client/app/terminal/console.h"

#include <gtest/gtest.h>

#include <random>

#include "client/app/terminal/cut_list.h"

namespace prosector {
namespace {

SceneInfo scene() {
  SceneInfo out;
  for (const char* name : {"liver", "left kidney", "bone 2"}) out.bodies.emplace_back().name = name;
  return out;
}

std::map<ParticipantId, RosterEntry> roster() {
  std::map<ParticipantId, RosterEntry> out;
  for (const auto& [id, name] : {std::pair<ParticipantId, const char*>{7, "Ada"}, {9, "Grace from Room 2"}}) {
    out[id].participant = id;
    out[id].name = name;
  }
  return out;
}

const Vec3 middle(0.1, 1.2, -0.3);

ConsoleLine parse(const std::string& line) {
  return parse_console_line(line, scene(), roster(), [](BodyId) { return middle; });
}

/// Returns the command that a line gives; of another kind, fails the test.
template <class Kind>
Kind command(const std::string& line) {
  const ConsoleLine parsed = parse(line);
  const auto* const body = std::get_if<CommandBody>(&parsed);
  const auto* const out = body == nullptr ? nullptr : std::get_if<Kind>(body);
  EXPECT_TRUE(out) << line;
  return out == nullptr ? Kind{} : *out;
}

std::string refusal(const std::string& line) {
  const ConsoleLine parsed = parse(line);
  EXPECT_TRUE(std::holds_alternative<std::string>(parsed)) << line;
  return std::holds_alternative<std::string>(parsed) ? std::get<std::string>(parsed) : "";
}

TEST(Console, EveryVerbTakesNamesWithSpaces) {
  for (const char* between : {" ", "   ", " \t "}) {
    const auto line = [&](const std::string& verb) { return "  " + verb + between + "left kidney \r"; };
    EXPECT_EQ(command<Detach>(line("detach")).body, 1u);
    EXPECT_EQ(command<Attach>(line("attach")).body, 1u);
    EXPECT_EQ(command<ResetBody>(line("reset")).body, 1u);
    EXPECT_EQ(command<Inspect>(line("inspect")).body, 1u);
    EXPECT_EQ(command<EndInspect>(line("end")).body, 1u);
  }
}

TEST(Console, ListsWhatWasCutAndByWhom) {
  EXPECT_TRUE(std::holds_alternative<ListCuts>(parse("cuts")));
  EXPECT_TRUE(std::holds_alternative<DescribePointed>(parse("what")));
  std::map<BodyId, TopologyRevision> shown;
  const auto answer = [&] {
    return cut_list_text(scene(), roster(), 0.02, [&](BodyId body) {
      const auto found = shown.find(body);
      return found == shown.end() ? nullptr : &found->second;
    });
  };
  shown[0].cause = TopologyCause::compiled;
  EXPECT_EQ(answer(), "nothing has been cut");
  TopologyRevision& liver = shown[0];
  liver.revision = 12;
  liver.time.tick = 100;
  liver.cause = TopologyCause::cut;
  liver.author = 7;
  TopologyRevision& piece = shown[2];
  piece.time.tick = 150;
  piece.cause = TopologyCause::cut;
  piece.author = 8;
  piece.piece_of = 0;
  EXPECT_EQ(answer(),
            "liver: revision 12, cut by Ada 2.0 s into the session\n"
            "bone 2: revision 0, cut by a participant who left 3.0 s into the session");
}

TEST(Console, LooksFromAPlaceToAnother) {
  const ConsoleLine parsed = parse("look 0 1.5 1  0 1.5 -2");
  ASSERT_TRUE(std::holds_alternative<LookFrom>(parsed));
  EXPECT_EQ(std::get<LookFrom>(parsed).eye, Vec3(0, 1.5, 1));
  EXPECT_EQ(std::get<LookFrom>(parsed).target, Vec3(0, 1.5, -2));
  EXPECT_TRUE(std::holds_alternative<RestoreView>(parse("look")));
  for (const char* line : {"look 1", "look 1 2 3 4 5", "look 1 2 3 4 5 6 7", "look 1 2 3 4 5 x",
                           "look 1 2 3 1 2 3", "look 1 2 3 4 5 1e9", "look nan 2 3 4 5 6"})
    EXPECT_NE(refusal(line).find("look X Y Z"), std::string::npos) << line;
}

TEST(Console, UndoesAndRewinds) {
  command<Undo>("undo");
  const Rewind out = command<Rewind>("rewind left kidney 12");
  EXPECT_EQ(out.body, 1u);
  EXPECT_EQ(out.revision, 12u);
  EXPECT_NE(refusal("rewind left kidney").find("REVISION"), std::string::npos);
  EXPECT_NE(refusal("rewind left kidney -1").find("REVISION"), std::string::npos);
  EXPECT_NE(refusal("rewind spleen 3").find("no body"), std::string::npos);
}

TEST(Console, StopsSlowsAndStepsTime) {
  const auto pace = [](const std::string& line) { return command<SetPace>(line).pace; };
  EXPECT_EQ(pace("stop"), 0);
  EXPECT_EQ(pace("go"), 1);
  EXPECT_EQ(pace("slow 0.25"), 0.25);
  for (const char* bad : {"slow", "slow 0", "slow 2", "slow -1", "slow nan", "slow 0.5x"})
    EXPECT_NE(refusal(bad).find("SHARE"), std::string::npos) << bad;
  EXPECT_EQ(command<StepTicks>("step").ticks, 1u);
  EXPECT_EQ(command<StepTicks>("step 120").ticks, 120u);
  for (const char* bad : {"step 0", "step -1", "step 6001", "step x"})
    EXPECT_NE(refusal(bad).find("TICKS"), std::string::npos) << bad;
  command<ResetAll>("reset all");
}

TEST(Console, GoesToTimesOfARecording) {
  const ShownTime shown{6000, 1200, 60, 1};
  const auto tick = [&](const std::string& line, const std::optional<ShownTime>& watched) {
    const ConsoleLine out = parse_console_line(
        line, scene(), roster(), [](BodyId) { return middle; }, watched);
    const auto* const found = std::get_if<CommandBody>(&out);
    EXPECT_EQ(found == nullptr, !watched || line.find('x') != line.npos) << line;
    return found == nullptr ? 0u : std::get<Seek>(*found).tick;
  };
  EXPECT_EQ(tick("seek 75", shown), 4500u);
  EXPECT_EQ(tick("seek 1:15", shown), 4500u);
  EXPECT_EQ(tick("seek 0.0166667", shown), 1u) << "the nearest one";
  EXPECT_EQ(tick("seek +10", shown), 1800u);
  EXPECT_EQ(tick("seek -10", shown), 600u);
  EXPECT_EQ(tick("seek -1:00", shown), 0u) << "the beginning";
  EXPECT_EQ(tick("seek 10:00", shown), 6000u) << "the end";
  for (const char* bad : {"seek x", "seek 1:x", "seek +x", "seek 7x"}) tick(bad, shown);
  tick("seek 75", std::nullopt);
  EXPECT_EQ(command<SetPace>("fast 4").pace, 4);
  for (const char* bad : {"fast", "fast 0.5", "fast 9", "fast nan"})
    EXPECT_NE(refusal(bad).find("TIMES"), std::string::npos) << bad;
}

TEST(Console, SaysHowAccurateTissueIsToBe) {
  for (const char* line : {"accuracy left kidney 5 %", "accuracy left kidney 5%"}) {
    EXPECT_EQ(command<SetAccuracy>(line).body, 1u) << line;
    EXPECT_EQ(command<SetAccuracy>(line).percent, 5) << line;
  }
  EXPECT_EQ(command<SetAccuracy>("accuracy left kidney").body, 1u);
  EXPECT_EQ(command<SetAccuracy>("accuracy left kidney").percent, 0) << "only to be told what it can have";
  for (const char* bad :
       {"accuracy left kidney 0.01 %", "accuracy left kidney 101 %", "accuracy left kidney x%"})
    EXPECT_NE(refusal(bad).find("PART"), std::string::npos) << bad;
  for (const char* bad : {"accuracy", "accuracy spleen 5 %", "accuracy left kidney 5"})
    EXPECT_NE(refusal(bad).find("no body"), std::string::npos) << bad;
}

TEST(Console, SaysHowExactlyTissueIsSolved) {
  EXPECT_EQ(command<SetEffort>("effort left kidney 2").body, 1u);
  EXPECT_EQ(command<SetEffort>("effort left kidney 2").steps_down, 2u);
  EXPECT_EQ(command<SetEffort>("effort left kidney exact").steps_down, 0u);
  EXPECT_EQ(command<SetAllEfforts>("effort all coarse").steps_down, max_steps_down);
  for (const char* bad : {"effort", "effort all", "effort all 4", "effort all 1.5", "effort all -1"})
    EXPECT_NE(refusal(bad).find("STEPS"), std::string::npos) << bad;
  EXPECT_NE(refusal("effort spleen 1").find("no body"), std::string::npos);
}

TEST(Console, InspectScalesAboutTheMiddle) {
  for (const double scale : {0.01, 0.5, 3.0, max_shape_entry}) {
    const Inspect out = command<Inspect>("inspect left kidney " + std::to_string(scale));
    EXPECT_EQ(out.body, 1u);
    EXPECT_LT((out.shape * middle - middle).norm(), 1e-12 * scale);
    EXPECT_LT((out.shape * (middle + Vec3::UnitX()) - middle - scale * Vec3::UnitX()).norm(), 1e-9);
  }
  const Inspect as_it_is = command<Inspect>("inspect liver");
  EXPECT_LT((as_it_is.shape * middle - middle).norm(), 1e-15);
  EXPECT_EQ(command<Inspect>("inspect bone 2").body, 2u) << "a number may be part of a name";
  for (const char* bad : {"0", "-1", "nan", "inf", "1e9", "2x", "0x2"})
    EXPECT_NE(refusal(std::string("inspect liver ") + bad).find("SCALE is from"), std::string::npos) << bad;
}

TEST(Console, GivesRoles) {
  const std::map<std::string, Role> roles = {
      {"host", Role::host}, {"dissector", Role::dissector}, {"observer", Role::observer}};
  for (const auto& [word, role] : roles) {
    const SetRole out = command<SetRole>("give Grace from Room 2 " + word);
    EXPECT_EQ(out.subject, 9u);
    EXPECT_EQ(out.role, role);
  }
  EXPECT_NE(refusal("give Ada king").find("ROLE is host"), std::string::npos);
  EXPECT_NE(refusal("give Nobody host").find("\"Nobody\""), std::string::npos);
  EXPECT_NE(refusal("give").find("ROLE is host"), std::string::npos);
}

TEST(Console, TakesPictures) {
  const ConsoleLine parsed = parse("picture out/first view.png ");
  ASSERT_TRUE(std::holds_alternative<TakePicture>(parsed));
  EXPECT_EQ(std::get<TakePicture>(parsed).file, "out/first view.png");
  EXPECT_NE(refusal("picture").find("FILE"), std::string::npos);
}

TEST(Console, WhatItDoesNotKnowItSays) {
  EXPECT_EQ(refusal("dance"), console_help());
  EXPECT_EQ(refusal(""), console_help());
  EXPECT_NE(refusal("detach spleen").find("\"spleen\""), std::string::npos);
  EXPECT_NE(refusal("detach").find("\"\""), std::string::npos);
  // Every verb of the help is one.
  for (const char* verb : {"give", "detach", "attach", "reset", "inspect", "end", "picture"})
    EXPECT_NE(console_help().find(verb), std::string::npos) << verb;
}

TEST(Console, NoLineBreaksIt) {
  std::mt19937 random(5);
  const std::vector<std::string> words = {"give",  "inspect", "detach", "liver", "left kidney", "Ada",
                                          "host",  "3",       "\t",     " ",     "\xff\xfe",    "picture",
                                          "1e400", "",        "  ",     "bone 2"};
  for (int i = 0; i < 20000; ++i) {
    std::string line;
    for (std::size_t k = random() % 6; k > 0; --k)
      line += words[random() % words.size()] + (random() % 3 != 0 ? " " : "");
    const ConsoleLine parsed = parse(line);
    const auto* const body = std::get_if<CommandBody>(&parsed);
    if (const auto* out = body == nullptr ? nullptr : std::get_if<Inspect>(body)) {
      EXPECT_LT(out->body, 3u) << line;
      EXPECT_TRUE(out->shape.A.allFinite() && out->shape.p.allFinite()) << line;
    }
    if (const auto* out = body == nullptr ? nullptr : std::get_if<Detach>(body)) {
      EXPECT_LT(out->body, 3u) << line;
    }
  }
}

}  // namespace
}  // namespace prosector
