// When a client believes that the server no longer hears it.

#include "client/app/unheard_inputs.h"

#include <gtest/gtest.h>

namespace prosector {
namespace {

/// Sends inputs and tells statuses; returns the number of the first one that said so, 0: none did.
int first_alarm(UnheardInputs& inputs, int statuses, bool sends, bool consumes, bool time_goes) {
  static std::uint64_t sequence = 0;
  for (int k = 1; k <= statuses; ++k) {
    if (sends) inputs.sent();
    if (consumes) inputs.take_consumed(++sequence);
    if (inputs.take_status(time_goes)) return k;
  }
  return 0;
}

TEST(UnheardInputs, AreToldOnlyWhereTheyAreSentAndTimeGoesOn) {
  for (int which = 0; which < 8; ++which) {
    UnheardInputs inputs;
    const bool sends = (which & 1) != 0, consumes = (which & 2) != 0, time_goes = (which & 4) != 0;
    const int expected = sends && !consumes && time_goes ? UnheardInputs::patience : 0;
    EXPECT_EQ(first_alarm(inputs, 100, sends, consumes, time_goes), expected) << which;
  }
}

TEST(UnheardInputs, AreToldLessAndLessOftenUntilTheServerHearsAgain) {
  UnheardInputs inputs;
  EXPECT_EQ(first_alarm(inputs, 1000, true, false, true), 5);
  EXPECT_EQ(first_alarm(inputs, 1000, true, false, true), 20);
  EXPECT_EQ(first_alarm(inputs, 1000, true, false, true), 80);
  EXPECT_EQ(first_alarm(inputs, 1000, true, false, true), 300);
  EXPECT_EQ(first_alarm(inputs, 1000, true, false, true), 300);
  EXPECT_EQ(first_alarm(inputs, 10, true, true, true), 0);
  EXPECT_EQ(first_alarm(inputs, 1000, true, false, true), 5);
}

TEST(UnheardInputs, APauseOfOneStatusStartsTheCountAnew) {
  UnheardInputs inputs;
  EXPECT_EQ(first_alarm(inputs, 4, true, false, true), 0);
  EXPECT_EQ(first_alarm(inputs, 1, true, false, false), 0);
  EXPECT_EQ(first_alarm(inputs, 100, true, false, true), 5);
}

}  // namespace
}  // namespace prosector
