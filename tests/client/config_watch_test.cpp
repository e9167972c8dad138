// The configuration's file while a client runs.
#include "client/app/user/config_watch.h"

#include <gtest/gtest.h>

#include <fstream>

#include "common/error.h"
#include "tests/session/temporary_file.h"

namespace prosector::test {
namespace {

constexpr std::int64_t second_ns = 1'000'000'000;

struct Watched {
  TemporaryFile file{"watched.toml"};
  std::vector<std::string> messages;
  int age = 0;

  void write(const std::string& text) {
    std::ofstream(file.path) << text;
    // File systems' times may be coarse: each writing is a second later than the last.
    std::filesystem::last_write_time(
        file.path, std::filesystem::file_time_type::clock::now() + std::chrono::seconds(++age));
  }
  std::function<void(const std::string&)> report() {
    return [this](const std::string& line) { messages.push_back(line); };
  }
};

TEST(ConfigWatch, TakesWhatIsWrittenAndRefusesMistakes) {
  Watched w;
  w.write("");
  ConfigWatch watch({w.file.path, {}, {}, {}, {}});
  EXPECT_FALSE(watch.look(second_ns, w.report()));
  w.write("[tracker]\naddress = \"fastrak:/dev/ttyS7\"\n");
  EXPECT_FALSE(watch.look(second_ns + 1, w.report())) << "twice a second is often enough";
  const auto taken = watch.look(2 * second_ns, w.report());
  ASSERT_TRUE(taken);
  EXPECT_EQ(taken->tracker, "fastrak:/dev/ttyS7");
  EXPECT_FALSE(watch.look(3 * second_ns, w.report())) << "once";
  w.write("[tracker]\nwings = 2\n");
  EXPECT_FALSE(watch.look(4 * second_ns, w.report()));
  ASSERT_EQ(w.messages.size(), 2u);
  EXPECT_NE(w.messages[1].find(":2: "), std::string::npos) << w.messages[1];
  EXPECT_NE(w.messages[1].find("are unchanged"), std::string::npos);
  std::filesystem::remove(w.file.path);
  EXPECT_FALSE(watch.look(5 * second_ns, w.report())) << "it is being replaced";
}

TEST(ConfigSource, AddressesOfTheCommandLineComeFirst) {
  Watched w;
  w.write("[tracker]\naddress = \"fastrak:/dev/ttyS7\"\n[glove.left]\naddress = \"5dt:/dev/ttyS8\"\n");
  const ClientConfig config =
      ConfigSource{w.file.path, "fastrak:/dev/ttyS1", "", "5dt:/dev/ttyS2", ""}.read();
  EXPECT_EQ(config.tracker, "fastrak:/dev/ttyS1");
  EXPECT_EQ(config.gloves[left_hand].address, "5dt:/dev/ttyS8");
  EXPECT_EQ(config.gloves[right_hand].address, "5dt:/dev/ttyS2");
  EXPECT_THROW((ConfigSource{{}, "nothing", {}, {}, {}}.read()), InputError);
}

}  // namespace
}  // namespace prosector::test
