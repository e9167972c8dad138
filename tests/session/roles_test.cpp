// Roles: who may hand them out, and what they change.

#include <gtest/gtest.h>

#include "tests/session/session_room.h"

namespace prosector {
namespace {

using namespace test;

Command set_role(ParticipantId by, ParticipantId subject, Role role) {
  return command(by, SetRole{subject, role}, 50);
}

Role role_of(const Room& room, ParticipantId id) {
  return room.session.roster().members().at(id).role;
}

TEST(Session, OnlyTheHostHandsOutRoles) {
  Room room;
  room.join(presence(1, "hana", Role::host), 1);
  room.join(presence(2, "dora"), 2);
  room.join(presence(3, "otto", Role::observer), 3);
  for (const ParticipantId asker : {2, 3})
    for (const Role role : {Role::observer, Role::dissector, Role::host}) {
      room.feed({from(asker, set_role(asker, asker, role))});
      EXPECT_FALSE(room.results.back().accepted);
      EXPECT_NE(room.results.back().reason.find("only the host"), std::string::npos);
    }
  EXPECT_EQ(role_of(room, 2), Role::dissector);
  EXPECT_EQ(role_of(room, 3), Role::observer);
  room.feed({from(1, set_role(1, 99, Role::dissector))});
  EXPECT_FALSE(room.results.back().accepted);
  room.feed({from(1, set_role(1, 1, Role::observer))});  // who would hand out roles then?
  EXPECT_FALSE(room.results.back().accepted);
  EXPECT_EQ(role_of(room, 1), Role::host);
}

TEST(Session, AnObserverThatIsMadeADissectorHasHands) {
  Room room;
  room.join(presence(1, "hana", Role::host), 1);
  room.join(presence(2, "otto", Role::observer), 2);
  EXPECT_TRUE(room.feed({from(2, input(2, 1))}).input.targets.empty());
  EXPECT_EQ(room.feed({from(1, set_role(1, 2, Role::dissector)), from(2, input(2, 2))}).input.targets.size(),
            1u);
  EXPECT_TRUE(room.results.back().accepted);
  EXPECT_EQ(room.session.roster().observers(), 0u);
  const std::vector<SessionEvent> events = room.session.output().take_events();
  ASSERT_FALSE(events.empty());
  EXPECT_EQ(events.back().kind, SessionEvent::Kind::role);
  EXPECT_EQ(events.back().detail, "dissector");
}

TEST(Session, ADissectorThatIsMadeAnObserverLosesItsHands) {
  Room room;
  room.join(presence(1, "hana", Role::host), 1);
  room.join(presence(2, "dora"), 2);
  room.feed({from(2, input(2, 1))});
  const ConsumedInput in = room.feed({from(2, command(2, Grasp{}, 9)), from(2, input(2, 2)),
                                      from(1, set_role(1, 2, Role::observer)), from(2, input(2, 3))});
  ASSERT_EQ(in.input.events.size(), 1u);
  EXPECT_EQ(in.input.events[0].kind, HandEvent::Kind::vanish);
  EXPECT_EQ(in.input.events[0].participant, 2u);
  EXPECT_TRUE(in.input.targets.empty());
  EXPECT_TRUE(room.feed({from(2, input(2, 4))}).input.targets.empty());
  EXPECT_EQ(room.session.roster().observers(), 1u);
}

TEST(Session, HandingOverTheHostsRoleMakesADissector) {
  Room room;
  room.join(presence(1, "hana", Role::host), 1);
  room.join(presence(2, "dora"), 2);
  room.feed({from(1, set_role(1, 2, Role::host))});
  EXPECT_EQ(role_of(room, 1), Role::dissector);
  EXPECT_EQ(role_of(room, 2), Role::host);
  room.feed({from(1, set_role(1, 1, Role::host))});  // not to be taken back
  EXPECT_FALSE(room.results.back().accepted);
  EXPECT_EQ(role_of(room, 2), Role::host);
}

TEST(Session, RolesRespectThePlacesForObservers) {
  Room room;
  room.join(presence(1, "hana", Role::host), 1);
  room.join(presence(2, "a", Role::observer), 2);
  room.join(presence(3, "b", Role::observer), 3);
  room.join(presence(4, "dora"), 4);
  room.feed({from(1, set_role(1, 4, Role::observer))});
  EXPECT_FALSE(room.results.back().accepted);
  EXPECT_NE(room.results.back().reason.find("observer"), std::string::npos);
  EXPECT_EQ(role_of(room, 4), Role::dissector);
}

}  // namespace
}  // namespace prosector
