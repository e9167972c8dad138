// Tests the formats of reports, text tables and plots.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/bench/report.h"
#include "tests/bench/text_table.h"
#include "tests/bench/trade_plot.h"
#include "tests/bench/verdict_map.h"

namespace prosector {
namespace {

TEST(Report, SaysOnWhatItWasMeasuredAndWritesNullForWhatIsNotFinite) {
  Report report("trade");
  report.add({{"model", "fem_linear"}, {"dt", 0.01}, {"residual", std::numeric_limits<double>::infinity()}});
  const auto read = nlohmann::json::parse(report.json().dump());
  EXPECT_EQ(read["bench"], "trade");
  for (const char* key : {"machine", "compiler", "date", "commit"}) EXPECT_FALSE(read[key].empty()) << key;
  ASSERT_EQ(read["rows"].size(), 1u);
  EXPECT_EQ(read["rows"][0]["dt"], 0.01);
  EXPECT_TRUE(read["rows"][0]["residual"].is_null());
  EXPECT_TRUE(std::isnan(figure(report.rows()[0], "no such key")));
}

TEST(TextTable, AlignsColumnsAndKeepsThreeDigits) {
  using enum Column::Kind;
  const TextTable table(
      {{text, "model", "model", 8}, {count, "tets", "tets", 6}, {percent, "error", "error", 9}});
  EXPECT_EQ(table.header(), "model       tets      error  ");
  EXPECT_EQ(table.line({{"model", "xpbd"}, {"tets", 648}, {"error", 0.01234}}),
            "xpbd         648     1.23 %  ");
  EXPECT_EQ(table.line({{"model", "xpbd"}, {"tets", 648}}), "xpbd         648          -  ");
  EXPECT_EQ(three_digits(0.0123456), "0.0123");
  EXPECT_EQ(three_digits(12345.6), "12346");
  EXPECT_EQ(three_digits(1.234e-7), "1.2e-07");
}

TEST(TradePlot, FrontHoldsWhatNothingElseBeats) {
  const std::vector<TradePoint> points = {
      {10, 0.1, "a", ""}, {1, 0.5, "a", ""}, {5, 0.5, "b", ""}, {20, 0.1, "b", ""}, {30, 0.01, "b", ""}};
  EXPECT_EQ(pareto_front(points), (std::vector<std::size_t>{1, 0, 4}));
}

TEST(TradePlot, DrawsAFrontOfEachOfItsGroups) {
  TradePlot plot;
  plot.fronts = {{"some", {"a"}}, {"all", {}}};
  plot.points = {{1, 0.1, "a", "first"}, {2, 0.01, "a", "second"}, {2, 0.001, "b", "third"}};
  const std::string svg = draw(plot).str();
  const auto times = [&](const std::string& word) {
    std::size_t count = 0;
    for (std::size_t at = svg.find(word); at != std::string::npos; at = svg.find(word, at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(times("<polyline"), 2u);
  EXPECT_EQ(times("1  first"), 2u) << "on both, by one number";
  EXPECT_EQ(times("2  second"), 1u) << "beaten where b counts";
  EXPECT_EQ(times("3  third"), 1u);
}

TEST(TradePlot, DrawsEachPointAndLeavesOutWhatIsNotFinite) {
  TradePlot plot;
  plot.title = "a < b & c";
  plot.points = {{10, 0.1, "a", "first"}, {1, std::nan(""), "b", "never drawn"}};
  const std::string svg = draw(plot).str();
  EXPECT_NE(svg.find("a &lt; b &amp; c"), std::string::npos);
  EXPECT_NE(svg.find("first"), std::string::npos);
  EXPECT_EQ(svg.find("never drawn"), std::string::npos);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(draw(TradePlot{}).str().find("nan"), std::string::npos);
}

TEST(VerdictMap, NamesRowsAndColumns) {
  VerdictMap map;
  map.rungs = {"fem_linear"};
  map.extremes = {"dt 1 s", "NaN input"};
  map.cells = {{VerdictCell{Verdict::survives, false}, std::nullopt}};
  const std::string svg = draw(map).str();
  for (const char* word : {"fem_linear", "dt 1 s", "NaN input", "survives", "fails"})
    EXPECT_NE(svg.find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace prosector
