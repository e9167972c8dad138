// What a user reads who was not let into a session.

#include "client/app/session/no_session.h"

#include <gtest/gtest.h>

namespace prosector {
namespace {

using namespace std::chrono_literals;

SessionInfo running(const std::string& name) {
  SessionInfo out;
  out.session = name;
  out.scene = "abdomen";
  return out;
}

BusConfig looking_for(const std::string& name) {
  BusConfig out;
  out.session = name;
  return out;
}

TEST(NoSession, SaysWhatToStartOrToChoose) {
  const std::string none = session_not_found_text(looking_for("lesson"), 5s, {});
  EXPECT_NE(none.find("no server found for session 'lesson'"), std::string::npos) << none;
  EXPECT_NE(none.find("Start a server"), std::string::npos) << none;
  const std::vector<SessionInfo> others = {running("ward"), running("class")};
  const std::string other = session_not_found_text(looking_for("lesson"), 5s, others);
  EXPECT_NE(other.find("'ward' (scene abdomen), 'class'"), std::string::npos) << other;
}

TEST(NoSession, DoesNotSayOfASessionThatRunsThatItDoesNot) {
  const std::vector<SessionInfo> found = {running("ward"), running("lesson")};
  EXPECT_TRUE(is_among(looking_for("lesson"), found));
  EXPECT_FALSE(is_among(looking_for("less"), found));
  EXPECT_EQ(session_not_found_text(looking_for("lesson"), 10s, found),
            "session 'lesson' is running but did not answer within 10 s: its server or the network is busy. "
            "Wait longer with --timeout 40");
}

}  // namespace
}  // namespace prosector
