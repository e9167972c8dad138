// Former names of renamed options.

#include "common/former_option_name.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace prosector {
namespace {

/// A program whose options were renamed.
struct Renamed {
  CLI::App app{"", "program"};
  double timeout = 5;
  bool verbose = false;
  std::vector<std::string> published;
  std::vector<double> spans;
  std::optional<std::string> spectators;

  Renamed() {
    accept_former_name(app, *app.add_option("--timeout", timeout)->check(CLI::Range(0.1, 600.0)),
                       "--patience");
    accept_former_name(app, *app.add_flag("--verbose", verbose), "--tell");
    accept_former_name(app, *app.add_option("--publish", published), "--offer");
    accept_former_name(app, *app.add_option("--span", spans)->expected(2)->delimiter(','), "--from-to");
    CLI::Option* spectator_window = app.add_option_function<std::string>(
        "--spectator-window", [this](const std::string& monitor) { spectators = monitor; });
    accept_former_name(app, *spectator_window->expected(0, 1), "--audience");
    app.get_option("--span")->needs("--publish");
  }

  /// Parses a command line and returns what it prints on standard error.
  std::string parse(const std::string& line) {
    testing::internal::CaptureStderr();
    try {
      app.parse(line);
    } catch (...) {
      (void)testing::internal::GetCapturedStderr();
      throw;
    }
    return testing::internal::GetCapturedStderr();
  }
};

TEST(FormerOptionName, SetsTheOptionAndPrintsOneWarning) {
  Renamed program;
  EXPECT_EQ(program.parse("--patience 20"),
            "warning: --patience is deprecated and will be removed in the next release; use --timeout\n");
  EXPECT_EQ(program.timeout, 20);
  EXPECT_EQ(program.parse("--timeout 30"), "");
  EXPECT_EQ(program.timeout, 30);
}

TEST(FormerOptionName, TakesAsManyValuesAsTheOption) {
  Renamed program;
  const std::string warnings = program.parse("--tell --offer vrpn --offer igtl --from-to 1,2 --audience");
  EXPECT_EQ(std::count(warnings.begin(), warnings.end(), '\n'), 4) << warnings;
  EXPECT_TRUE(program.verbose);
  EXPECT_EQ(program.published, (std::vector<std::string>{"vrpn", "igtl"}));
  EXPECT_EQ(program.spans, (std::vector<double>{1, 2}));
  EXPECT_EQ(program.spectators, "");
  (void)program.parse("--audience 1");
  EXPECT_EQ(program.spectators, "1");
}

TEST(FormerOptionName, KeepsTheChecksOfTheOption) {
  Renamed program;
  EXPECT_THROW((void)program.parse("--patience 0"), CLI::ValidationError);
  EXPECT_THROW((void)program.parse("--patience 10 --timeout 20"), CLI::ArgumentMismatch);
  EXPECT_THROW((void)program.parse("--from-to 1 2"), CLI::RequiresError);
  EXPECT_EQ(program.parse("--from-to 1 2 --publish vrpn").find("--publish"), std::string::npos);
}

TEST(FormerOptionName, IsNotInTheHelp) {
  const Renamed program;
  EXPECT_NE(program.app.help().find("--timeout"), std::string::npos);
  EXPECT_EQ(program.app.help().find("--patience"), std::string::npos);
}

}  // namespace
}  // namespace prosector
