// A tick's input as bytes: every kind comes back, and journals that were written before stay readable.

#include "server/session/journal/input_bytes.h"

#include <gtest/gtest.h>

#include "common/error.h"
#include "common/hash.h"

namespace prosector {
namespace {

/// Every kind of input, each field with a value of its own.
ConsumedInput one_of_each() {
  ConsumedInput out;
  out.keys = {{11, 1001}, {12, 1002}};
  out.input.efforts = {{3, 2}};
  out.input.events = {{HandEvent::Kind::grasp, 11, left_hand, 0}, {HandEvent::Kind::reset_body, 12, 1, 7}};
  PartEvent part{PartEvent::Kind::inspect, 11, 5, {}, 0.25};
  for (int k = 0; k < 9; ++k) part.shape.A(k / 3, k % 3) = 0.5 + k;
  part.shape.p = {1, 2, 3};
  out.input.parts = {part};
  HandTarget target{12, left_hand, {{0.1, 0.2, 0.3}, Quat(0.5, -0.5, 0.5, 0.5)}, {}};
  for (std::size_t i = 0; i < fingers; ++i) target.flexion[i] = 0.125 * static_cast<double>(i);
  out.input.targets = {target};
  out.input.heads = {{11, {1.5, 1.6, 1.7}, {0.6, 0, -0.8}}};
  out.input.panels = {{panel::PanelEvent::Kind::set, 12, 4, PanelControl::stiffness, 0.75, {0.5, 1.25, 2}}};
  out.input.held = {{11, HeldObject::tablet, true, {{1, 2, 3}, Quat(0.5, 0.5, -0.5, 0.5)}},
                    {12, HeldObject::stylus, false, {}}};
  CutEvent undo{CutEvent::Kind::undo, 11, 0, 0, {}};
  CutEvent rewind{CutEvent::Kind::rewind, 12, 2, 9, {}};
  rewind.state = std::make_shared<const std::vector<std::uint8_t>>(std::vector<std::uint8_t>{9, 8, 7});
  out.input.cuts = {undo, rewind};
  return out;
}

TEST(InputBytes, StayAsJournalsHaveThem) {
  const std::vector<std::uint8_t> bytes = encode_input(one_of_each());
  EXPECT_EQ(bytes.size(), 598u);
  EXPECT_EQ(to_hex(content_hash(std::as_bytes(std::span(bytes)))), "efb1a68b7642a75fba62dcf262525915");
}

TEST(InputBytes, AGraspOfWhatIsWantedComesBack) {
  ConsumedInput wanted;
  wanted.input.events = {{HandEvent::Kind::grasp_body, 13, left_hand, 9}};
  const ConsumedInput back = decode_input(encode_input(wanted));
  ASSERT_EQ(back.input.events.size(), 1u);
  EXPECT_EQ(back.input.events[0].kind, HandEvent::Kind::grasp_body);
  EXPECT_EQ(back.input.events[0].body, 9u);
}

TEST(InputBytes, AHandThatDrawsIsNoLongerThanOneThatDoesNot) {
  ConsumedInput drawn = one_of_each();
  drawn.input.targets[0].hand = right_hand;
  drawn.input.targets[0].draws = true;
  const std::vector<std::uint8_t> bytes = encode_input(drawn);
  EXPECT_EQ(bytes.size(), encode_input(one_of_each()).size()) << "journals from before it stay readable";
  const ConsumedInput back = decode_input(bytes);
  ASSERT_EQ(back.input.targets.size(), 1u);
  EXPECT_TRUE(back.input.targets[0].draws);
  EXPECT_EQ(back.input.targets[0].hand, right_hand);
  EXPECT_FALSE(decode_input(encode_input(one_of_each())).input.targets[0].draws);
}

TEST(InputBytes, EveryKindComesBack) {
  const std::vector<std::uint8_t> bytes = encode_input(one_of_each());
  const ConsumedInput back = decode_input(bytes);
  EXPECT_EQ(encode_input(back), bytes);
  ASSERT_EQ(back.input.cuts.size(), 2u);
  EXPECT_EQ(back.input.cuts[0].state, nullptr);
  EXPECT_EQ(*back.input.cuts[1].state, (std::vector<std::uint8_t>{9, 8, 7}));
  ASSERT_EQ(back.input.targets.size(), 1u);
  EXPECT_EQ(back.input.targets[0].target.q.w(), 0.5);
  EXPECT_EQ(back.input.parts.at(0).shape.A(1, 2), 5.5);
  EXPECT_EQ(back.input.events.at(0).hand, left_hand);
}

/// `member` of one_of_each() alone.
template <class Member>
ConsumedInput only(Member member) {
  ConsumedInput all = one_of_each(), out;
  member(out) = member(all);
  return out;
}

TEST(InputBytes, ATickThatConsumedOneKindIsNotEmpty) {
  EXPECT_TRUE(encode_input({}).empty());
  EXPECT_FALSE(encode_input(only([](auto& in) -> auto& { return in.keys; })).empty());
  EXPECT_FALSE(encode_input(only([](auto& in) -> auto& { return in.input.efforts; })).empty());
  EXPECT_FALSE(encode_input(only([](auto& in) -> auto& { return in.input.events; })).empty());
  EXPECT_FALSE(encode_input(only([](auto& in) -> auto& { return in.input.targets; })).empty());
  EXPECT_FALSE(encode_input(only([](auto& in) -> auto& { return in.input.heads; })).empty());
  EXPECT_FALSE(encode_input(only([](auto& in) -> auto& { return in.input.panels; })).empty());
  EXPECT_FALSE(encode_input(only([](auto& in) -> auto& { return in.input.held; })).empty());
  EXPECT_FALSE(encode_input(only([](auto& in) -> auto& { return in.input.parts; })).empty());
  EXPECT_FALSE(encode_input(only([](auto& in) -> auto& { return in.input.cuts; })).empty());
}

TEST(InputBytes, WhatIsCutShortIsRefused) {
  const std::vector<std::uint8_t> bytes = encode_input(one_of_each());
  for (std::size_t size = 1; size < bytes.size(); ++size)
    EXPECT_THROW(decode_input(std::span(bytes).first(size)), InputError) << size;
  std::vector<std::uint8_t> longer = bytes;
  longer.push_back(0);
  EXPECT_THROW(decode_input(longer), InputError);
}

}  // namespace
}  // namespace prosector
