// Programs that the set-up window starts.
#include "client/setup/child_process.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "client/setup/hosted_server.h"
#include "common/error.h"

namespace prosector {
namespace {

void wait(ChildProcess& process, const std::string& words = "") {
  for (int k = 0; k < 500 && !process.ended() && (words.empty() || !process.said(words)); ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    process.poll();
  }
}

TEST(ChildProcess, TellsWhatItSaidAndHowItEnded) {
  ChildProcess process({"sh", "-c", "echo one; echo two >&2; printf three; exit 7"});
  wait(process);
  EXPECT_EQ(process.ended(), 7);
  EXPECT_TRUE(process.said("one"));
  EXPECT_EQ(process.lines().back(), "two") << "a line is one when it is over";
}

TEST(ChildProcess, ThatIsMissingIsNamed) {
  try {
    ChildProcess process({"/nowhere/prosector-server"});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/prosector-server"), std::string::npos);
  }
}

TEST(ChildProcess, EndsWithIt) {
  pid_t pid = 0;
  {
    ChildProcess process({"sh", "-c", "echo $$; exec sleep 60"});
    for (int k = 0; k < 100 && process.lines().empty(); ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      process.poll();
    }
    ASSERT_FALSE(process.lines().empty());
    pid = std::stoi(process.lines().front());
    EXPECT_EQ(kill(pid, 0), 0);
  }
  EXPECT_NE(kill(pid, 0), 0);
}

TEST(ChildProcess, ASignalIsAnEndToo) {
  ChildProcess process({"sh", "-c", "kill -9 $$"});
  wait(process);
  EXPECT_EQ(process.ended(), 128 + 9);
}

TEST(ChildProcess, KeepsTheLastLinesOfMany) {
  ChildProcess process({"seq", "300"});
  wait(process);
  EXPECT_LE(process.lines().size(), 200u);
  EXPECT_EQ(process.lines().back(), "300");
}

TEST(ShellLine, IsWhatAShellReadsBack) {
  const std::vector<std::string> words = {"a", "b c", "", "it's", "$HOME", "x;y", "Ünï"};
  std::vector<std::string> command = {"printf", "%s\\n"};
  command.insert(command.end(), words.begin(), words.end());
  ChildProcess process({"sh", "-c", shell_line(command)});
  wait(process);
  EXPECT_EQ(process.lines(), words);
}

TEST(NetworkWords, AreThoseOfTheCommandLine) {
  BusConfig where;
  EXPECT_TRUE(network_words(where).empty());
  where.domain = 3;
  where.profile = "lan";
  where.interface = "eth0";
  where.peers = {"ward"};
  const std::vector<std::string> words = {"--domain", "3", "--lan", "eth0", "--peer", "ward"};
  EXPECT_EQ(network_words(where), words);
}

}  // namespace
}  // namespace prosector
