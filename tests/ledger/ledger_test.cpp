// The ledger: state hashes of scripted sessions, every ten ticks, as they were. A change that says that it
// changes no result leaves them alone; one that changes results renews them with deploy/renew_ledger.sh and
// says in the CHANGELOG which sessions replay differently.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

#include "common/hash.h"
#include "tests/folders.h"
#include "tests/ledger/sessions.h"
#include "tests/physics/scenes.h"
#include "tests/save_check.h"

namespace prosector::test {
namespace {

constexpr const char* compiler = "12.2.0";  // others may round otherwise
constexpr int ticks_between = 10;
const std::string ledger = source_path("tests/ledger/hashes.txt");

/// One a line: the session's name, a colon, and what it came to.
using Hashes = std::map<std::string, std::string>;

Hashes read() {
  Hashes out;
  std::ifstream in(ledger);
  for (std::string line; std::getline(in, line);)
    if (const auto colon = line.find(": "); colon != line.npos)
      out[line.substr(0, colon)] = line.substr(colon + 2);
  return out;
}

std::string run(const Session& session, int threads, std::set<std::string>& happened) {
  auto simulation = std::make_unique<Simulation>(session.scene, options(threads));
  std::string out = to_hex(simulation->state_hash());
  for (int tick = 0; tick < session.ticks; ++tick) {
    if (session.handed_over > 0 && tick == session.handed_over) {
      const std::vector<std::uint8_t> state = simulation->checkpoint();
      simulation = std::make_unique<Simulation>(session.scene, options(threads));
      simulation->restore(state);
    }
    const StepReport& report = simulation->step(session.input(tick, *simulation));
    happened.merge(events(*simulation, report));
    if ((tick + 1) % ticks_between == 0) out.append(" ").append(to_hex(simulation->state_hash()));
  }
  return out;
}

/// The first tick at which the two differ.
int first_difference(const std::string& a, const std::string& b) {
  std::istringstream left(a), right(b);
  int tick = 0;
  for (std::string x, y; left >> x && right >> y && x == y;) tick += ticks_between;
  return tick;
}

const Session& named(const std::vector<Session>& all, const std::string& name) {
  return *std::ranges::find(all, name, &Session::name);
}

class Ledger : public testing::TestWithParam<std::string> {};

TEST_P(Ledger, HoldsForAnyNumberOfThreads) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "recorded with the release preset";
#endif
  if (std::string(__VERSION__) != compiler)
    GTEST_SKIP() << "recorded with g++ " << compiler << ", this is " << __VERSION__;
  const std::vector<Session> all = sessions();
  const Session* session = &named(all, GetParam());
  std::string expected = read()[session->name];
  if (std::getenv("PROSECTOR_RENEW_LEDGER")) {
    std::set<std::string> any;
    expected = run(*session, 1, any);
    Hashes renewed = read();
    renewed[session->name] = expected;
    std::ofstream out(ledger);
    for (const auto& [name, hashes] : renewed) out << name << ": " << hashes << '\n';
  }
  for (const int threads : {1, 2, 4}) {
    std::set<std::string> happened;
    const std::string found = run(*session, threads, happened);
    EXPECT_EQ(found, expected) << threads << " threads: from tick " << first_difference(found, expected)
                               << " on";
    for (const std::string& event : session->reaches) EXPECT_TRUE(happened.contains(event)) << event;
  }
}

// The server restores its own checkpoints while it runs, at ticks that depend on how fast it is.
TEST_P(Ledger, EveryStateCanBeRestored) {
  const std::vector<Session> all = sessions();
  const Session& session = named(all, GetParam());
  Simulation simulation(session.scene, options(1));
  SaveCheck saves(session.scene, options(1));
  for (int tick = 0; tick < session.ticks; ++tick) {
    (void)simulation.step(session.input(tick, simulation));
    ASSERT_EQ(saves.look(simulation), "");
  }
}

std::vector<std::string> names() {
  std::vector<std::string> out;
  for (const Session& session : sessions()) out.push_back(session.name);
  return out;
}

INSTANTIATE_TEST_SUITE_P(Sessions, Ledger, testing::ValuesIn(names()), [](const auto& info) {
  std::string name = info.param;
  std::erase_if(name, [](char c) { return c == ','; });
  std::ranges::replace(name, ' ', '_');
  return name;
});

TEST(LedgerFile, HasEachSessionAndNoOther) {
  std::vector<std::string> found;
  for (const auto& [name, hashes] : read()) found.push_back(name);
  std::vector<std::string> expected = names();
  std::ranges::sort(expected);
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace prosector::test
