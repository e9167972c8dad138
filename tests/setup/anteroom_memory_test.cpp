// What the set-up window keeps for the next time.
#include "client/setup/setup_choices.h"

#include <gtest/gtest.h>

#include "common/error.h"
#include "tests/random.h"
#include "tests/session/temporary_file.h"
#include "tests/setup/written_file.h"

namespace prosector::test {
namespace {

TEST(SetupChoices, ComesBackAsItWasKept) {
  const TemporaryFile file("anteroom.toml");
  SetupChoices memory{"Ada \"the\" Ünïcode",  true,           true,
                      "/tmp/scénes/a b.toml", {"two", "one"}, {"stereo:anaglyph", "", 1}};
  remember(memory, file.path);
  const SetupChoices back = recall(file.path);
  EXPECT_EQ(back.name, memory.name);
  EXPECT_EQ(back.watches, memory.watches);
  EXPECT_EQ(back.lan, memory.lan);
  EXPECT_EQ(back.scene, memory.scene);
  EXPECT_EQ(back.entered, memory.entered);
  EXPECT_EQ(back.seen.words(), memory.seen.words());
}

TEST(SetupChoices, HowASessionIsSeenIsAsTheCommandLineSaysIt) {
  EXPECT_TRUE(DisplaySettings{}.words().empty()) << "what holds anyway isn't said";
  const std::vector<std::string> words = {"--display", "stereo:x", "--monitor", "1", "--quality", "low"};
  EXPECT_EQ((DisplaySettings{"stereo:x", "low", 1}.words()), words);
  const std::vector<std::string> headset = {"--display", "openxr"};
  EXPECT_EQ((DisplaySettings{"openxr", "medium", 0}.words()), headset) << "it fills no screen";
  const std::vector<std::string> by_itself = {"--frame-time", "33"};
  EXPECT_EQ((DisplaySettings{"window", "", -1}.words()), by_itself);
}

TEST(SetupChoices, WhatIsMissingOrDamagedIsAsGoodAsNone) {
  const TemporaryFile file("anteroom.toml");
  EXPECT_EQ(recall(file.path).name, "");
  for (const char* text :
       {"name = ", "name = 3\nwatches = \"yes\"\nentered = 7", "[[[[", "entered = [1, [2], \"x\"]"}) {
    write_file(file.path, text);
    const SetupChoices back = recall(file.path);
    EXPECT_EQ(back.name, "") << text;
    EXPECT_FALSE(back.watches) << text;
  }
}

TEST(SetupChoices, NoBytesHurt) {
  const TemporaryFile file("anteroom.toml");
  std::mt19937_64 random(3);
  const std::string good = "name = 'Ada'\nwatches = true\nentered = ['a', 'b']\n";
  for (int k = 0; k < 300; ++k) {
    std::string text = good;
    for (int n = 0; n < 4; ++n) text[random() % text.size()] = static_cast<char>(random());
    write_file(file.path, text);
    EXPECT_LE(recall(file.path).entered.size(), max_recent_sessions);
  }
}

TEST(SetupChoices, KeepsTheLastSessionsEachOnce) {
  SetupChoices memory;
  for (int k = 0; k < 20; ++k) add_recent_session(memory, std::to_string(k % 12));
  EXPECT_EQ(memory.entered.size(), max_recent_sessions);
  EXPECT_EQ(memory.entered.front(), "7");
  add_recent_session(memory, "5");
  EXPECT_EQ(memory.entered.front(), "5");
  EXPECT_EQ(std::count(memory.entered.begin(), memory.entered.end(), "5"), 1);
}

TEST(SetupChoices, SaysWhereItCannotBeKept) {
  EXPECT_THROW(remember({}, "/proc/nowhere/anteroom.toml"), InputError);
}

}  // namespace
}  // namespace prosector::test
