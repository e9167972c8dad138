// What clients know of hands' contacts: while they last, and when they are over, whatever is lost on the way.

#include <gtest/gtest.h>

#include "server/session/sending/hand_sender.h"
#include "tests/session/hosted.h"

namespace prosector {
namespace {

using test::Guest;
using test::Hosted;

ContactSample touch(ParticipantId who, std::uint64_t tick) {
  ContactSample sample;
  sample.participant = who;
  sample.touching = true;
  sample.time = {0, tick};
  return sample;
}

std::vector<ContactSample> contacts_in(HandSender& sender, const Snapshot& snapshot) {
  std::vector<Message> messages;
  sender.update(snapshot, false, messages);
  std::vector<ContactSample> out;
  for (const Message& m : messages)
    if (const auto* sample = std::get_if<ContactSample>(&m)) out.push_back(*sample);
  return out;
}

// On a busy machine snapshots are dropped; and a hand that is gone has no contact in any.
TEST(HandSender, SaysThatATouchIsOverHoweverManyTicksWereNotPublished) {
  for (const bool gone : {false, true}) {
    HandSender sender;
    Snapshot snapshot;
    snapshot.time = {0, 100};
    snapshot.contacts = {touch(7, 100)};
    ASSERT_EQ(contacts_in(sender, snapshot).size(), 1U);
    snapshot.time = {0, 150};
    if (gone)
      snapshot.contacts.clear();
    else
      snapshot.contacts[0].touching = false;
    int repeats = 0;
    for (auto sent = contacts_in(sender, snapshot); !sent.empty(); sent = contacts_in(sender, snapshot)) {
      ASSERT_EQ(sent.size(), 1U);
      EXPECT_EQ(sent[0].participant, 7U);
      EXPECT_FALSE(sent[0].touching);
      EXPECT_EQ(sent[0].time, snapshot.time);
      ++snapshot.time.tick;
      ++repeats;
      ASSERT_LE(repeats, 20);
    }
    EXPECT_GE(repeats, 5) << "samples get lost";
  }
}

TEST(HandSender, TellsOfWhatAHandComesNear) {
  HandSender sender;
  Snapshot snapshot;
  snapshot.contacts = {touch(7, 0)};
  snapshot.contacts[0].touching = false;
  EXPECT_TRUE(contacts_in(sender, snapshot).empty());
  snapshot.contacts[0].impact = 0.03;
  const auto sent = contacts_in(sender, snapshot);
  ASSERT_EQ(sent.size(), 1U);
  EXPECT_EQ(sent[0].impact, 0.03);
}

void tell(Replica& replica, const Message& message, Liveness liveness = Liveness::alive) {
  replica.apply({message, liveness, 1, 1});
}

TEST(ReplicaContacts, LateWordsOfThemChangeNothing) {
  Replica replica;
  tell(replica, SessionInfo{});
  RosterEntry ada;
  ada.participant = 7;
  tell(replica, touch(7, 90));
  EXPECT_EQ(replica.contact(7, right_hand), nullptr) << "not here yet";
  tell(replica, ada);
  ContactSample over = touch(7, 101);
  over.touching = false;
  tell(replica, over);
  tell(replica, touch(7, 100));
  ASSERT_NE(replica.contact(7, right_hand), nullptr);
  EXPECT_FALSE(replica.contact(7, right_hand)->touching);
  tell(replica, ada, Liveness::gone);
  tell(replica, touch(7, 102));
  EXPECT_EQ(replica.contact(7, right_hand), nullptr) << "gone";
}

TEST(ReplicaContacts, AreForgottenWhenNothingMoreIsHeardOfThem) {
  Replica replica;
  tell(replica, SessionInfo{});
  RosterEntry ada;
  ada.participant = 7;
  tell(replica, ada);
  tell(replica, touch(7, 100));
  ServerStatus status;
  status.time = {0, 110};
  tell(replica, status);
  ASSERT_NE(replica.contact(7, right_hand), nullptr);
  EXPECT_TRUE(replica.contact(7, right_hand)->touching);
  status.time = {0, 130};
  tell(replica, status);
  EXPECT_EQ(replica.contact(7, right_hand), nullptr);
}

// Half of what is sent is lost, and the hand goes while it presses: its user is not tracked any more, is made
// an observer, or leaves.
TEST(ContactSession, NoneIsLeftOverOfAHandThatIsGone) {
  for (const char* how : {"not tracked", "observer", "leaves"}) {
    LocalNetworkConfig network;
    network.loss = 0.5;
    Hosted hosted(network);
    Guest ada = hosted.guest(1, BusEnd::dissector), eve = hosted.guest(2, BusEnd::observer),
          hana = hosted.guest(3, BusEnd::dissector);
    hosted.tick();
    hana.greet("hana", Role::host);
    hosted.tick();
    ada.greet("ada", Role::dissector);
    eve.greet("eve", Role::observer);
    const auto tick = [&](int times) {
      for (int i = 0; i < times; ++i) {
        hosted.tick();
        ada.take();
        eve.take();
      }
    };
    tick(10);
    bool touched = false;
    for (std::uint64_t t = 0; t < 80; ++t) {
      ada.bus->publish(ada.hand_at(test::press(t)));
      tick(1);
      const ContactSample* contact = eve.replica.contact(ada.id, right_hand);
      touched = touched || (contact != nullptr && contact->touching);
    }
    EXPECT_TRUE(touched);
    if (std::string(how) == "leaves") ada.command(Leave{});
    if (std::string(how) == "observer") hana.command(SetRole{ada.id, Role::observer});
    for (int i = 0; i < 40; ++i) {
      if (std::string(how) == "not tracked") {
        HandInput input = ada.hand_at(test::press(0));
        input.hands[right_hand].tracked = false;
        ada.bus->publish(input);
      }
      tick(1);
    }
    const ContactSample* contact = eve.replica.contact(ada.id, right_hand);
    EXPECT_TRUE(contact == nullptr || !contact->touching) << how;
  }
}

}  // namespace
}  // namespace prosector
