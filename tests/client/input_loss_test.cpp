// When a client believes that the server no longer hears it.

#include "client/app/session/input_loss_detector.h"

#include <gtest/gtest.h>

namespace prosector {
namespace {

/// A client that may send, and a server that may consume, told of by a status every quarter of a second.
struct Ends {
  bool sends = true, consumes = false, time_advances = true;
  InputLossDetector inputs;
  std::int64_t now_ns = 1'000'000'000;
  std::uint64_t sequence = 0;

  /// Lets seconds pass; returns after how many the client found that it isn't heard, 0: it did not.
  double first_alarm(double seconds) {
    for (double passed = 0.25; passed <= seconds; passed += 0.25) {
      now_ns += 250'000'000;
      if (sends) inputs.sent();
      if (consumes) inputs.take_consumed(++sequence);
      if (inputs.take_status(now_ns, time_advances)) return passed;
    }
    return 0;
  }
};

TEST(InputLossDetector, AreToldOnlyWhereTheyAreSentAndTimeGoesOn) {
  for (int which = 0; which < 8; ++which) {
    Ends ends;
    ends.sends = (which & 1) != 0, ends.consumes = (which & 2) != 0, ends.time_advances = (which & 4) != 0;
    const double expected = ends.sends && !ends.consumes && ends.time_advances ? 5.25 : 0;
    EXPECT_EQ(ends.first_alarm(100), expected) << which;
  }
}

TEST(InputLossDetector, AreToldLessAndLessOftenUntilTheServerHearsAgain) {
  Ends ends;
  EXPECT_EQ(ends.first_alarm(1000), 5.25);
  for (const double seconds : {20, 80, 300, 300}) EXPECT_EQ(ends.first_alarm(1000), seconds);
  ends.consumes = true;
  EXPECT_EQ(ends.first_alarm(10), 0);
  ends.consumes = false;
  EXPECT_EQ(ends.first_alarm(1000), 5) << "since the last status before which it consumed";
}

TEST(InputLossDetector, ArentCountedWhileTheServerIsSilent) {
  Ends ends;
  EXPECT_EQ(ends.first_alarm(4), 0);
  ends.now_ns += 60'000'000'000;
  EXPECT_EQ(ends.first_alarm(1000), 5.25);
  EXPECT_EQ(ends.first_alarm(4), 0);
  ends.time_advances = false;
  EXPECT_EQ(ends.first_alarm(60), 0) << "the host stopped time";
}

}  // namespace
}  // namespace prosector
