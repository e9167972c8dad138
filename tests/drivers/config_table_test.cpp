// Properties over the whole table of the client's keys, and over texts that people write.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "common/error.h"
#include "drivers/config/client_config_table.h"
#include "drivers/config/client_config_write.h"
#include "tests/folders.h"
#include "tests/random.h"

namespace prosector {
namespace {

std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// A value that the key allows.
ConfigValue some_value(const ConfigKey& key, Random& random) {
  switch (key.type) {
    case ConfigType::flag:
      return random.below(2) == 0;
    case ConfigType::number:
      return random.uniform(key.least, key.most);
    case ConfigType::whole:
      return key.least +
             static_cast<double>(random.below(static_cast<std::size_t>(key.most - key.least) + 1));
    case ConfigType::numbers: {
      std::vector<double> out;
      for (std::size_t i = 0; i < key.count; ++i) out.push_back(random.uniform(-key.most, key.most));
      if (key.name.ends_with("orientation")) {
        const Eigen::Vector4d q = Eigen::Map<Eigen::Vector4d>(out.data()).normalized();
        out.assign(q.data(), q.data() + 4);
      }
      return out;
    }
    case ConfigType::text:
      break;
  }
  if (!key.choices.empty()) return key.choices[random.below(key.choices.size())];
  if (key.name == "arm.address") return std::string("omni-twin:/tmp/\"arm\" \\ 1");
  return std::string(key.name.ends_with("address") ? "5dt:/dev/a b#c" : "/map '1'.toml");
}

bool same(const ConfigValue& a, const ConfigValue& b) {
  if (a.index() != b.index()) return false;
  if (const double* x = std::get_if<double>(&a)) return std::abs(*x - std::get<double>(b)) < 1e-9;
  const auto* v = std::get_if<std::vector<double>>(&a);
  if (v == nullptr) return a == b;
  const auto& w = std::get<std::vector<double>>(b);
  return v->size() == w.size() && std::equal(v->begin(), v->end(), w.begin(),
                                             [](double x, double y) { return std::abs(x - y) < 1e-9; });
}

/// The names of keys, but for those of the changes, whose meaning two texts differ in.
std::string differing(const std::string& before, const std::string& after,
                      const std::vector<ConfigChange>& changes) {
  const ClientConfig a = parse_client_config(before, "c.toml"), b = parse_client_config(after, "c.toml");
  const auto concerns = [](const ConfigChange& c, const std::string& key) {
    // The other half of a pose that may be missing comes with the first.
    const bool is_pose = key.ends_with(".position") || key.ends_with(".orientation");
    const bool may_miss = key.find("mount.") != std::string::npos || (is_pose && key.starts_with("phantom."));
    return c.key == key || (may_miss && c.key.substr(0, c.key.rfind('.')) == key.substr(0, key.rfind('.')));
  };
  std::string out;
  for (const ConfigKey& key : client_config_keys()) {
    if (std::ranges::any_of(changes, [&](const ConfigChange& c) { return concerns(c, key.name); })) continue;
    const auto x = key.get(a), y = key.get(b);
    if (x.has_value() != y.has_value() || (x && !same(*x, *y))) out += key.name + " ";
  }
  return out;
}

/// What must stand beside a key so that the whole is allowed.
std::vector<ConfigChange> companions(const std::string& name) {
  std::vector<ConfigChange> out;
  for (const char* glove : {"glove.right", "glove.left"}) {
    if (!name.starts_with(glove)) continue;
    out.push_back({std::string(glove) + ".open", std::vector<double>{1, 2, 3, 4, 5}});
    out.push_back({std::string(glove) + ".closed", std::vector<double>{11, 12, 13, 14, 15}});
    out.push_back({std::string(glove) + ".open_below", 0.0});
    out.push_back({std::string(glove) + ".closed_above", 1.0});
  }
  if (name == "phantom.board" || name == "phantom.position" || name == "phantom.orientation")
    out.push_back({"phantom.body", std::string("skull")});
  for (const ConfigKey& key : client_config_keys()) {
    const std::string table = key.name.substr(0, key.name.rfind('.'));
    if (!key.needed.empty() && (name.starts_with(table + ".")))
      out.push_back({key.name, key.type == ConfigType::whole
                                   ? ConfigValue(2.0)
                                   : ConfigValue(std::string(table == "arm" ? "omni-twin:/x" : "5dt:/x"))});
  }
  return out;
}

TEST(ConfigTable, EachKeyIsOneOfATableAndHasHelp) {
  std::set<std::string> names;
  for (const ConfigKey& key : client_config_keys()) {
    EXPECT_TRUE(names.insert(key.name).second) << key.name;
    EXPECT_FALSE(key.help.empty()) << key.name;
    const auto dot = key.name.rfind('.');
    const std::string table = dot == std::string::npos ? "" : key.name.substr(0, dot);
    EXPECT_TRUE(std::ranges::any_of(client_config_tables(), [&](const ConfigTable& t) {
      return t.name == table;
    })) << key.name;
    if (const auto value = key.get(ClientConfig())) {
      EXPECT_TRUE(fits(key, *value)) << key.name << ": its default is allowed";
    }
  }
}

TEST(ConfigTable, TheSampleNamesEachKey) {
  const std::string sample = read_file(source_path("deploy/client.toml"));
  for (const ConfigKey& key : client_config_keys())
    EXPECT_NE(sample.find(key.name.substr(key.name.rfind('.') + 1)), std::string::npos) << key.name;
}

TEST(ConfigTable, ThePageOfTheDocumentationIsTheTables) {
  const std::filesystem::path page = source_path("docs/look-up/client-configuration.md");
  EXPECT_EQ(read_file(page), client_config_page())
      << "renew it: prosector-client config --manual > docs/look-up/client-configuration.md";
}

// Each key is written into texts of all kinds, comes back with its value, and nothing else changes.
TEST(ConfigWrite, EachKeyComesBackFromEachText) {
  const std::string texts[] = {
      "",
      "# Only a comment\n",
      "# No line end",
      "[gestures]\nfist = 'grasp' # a comment\n",
      "[tracker]\naddress = 'fastrak:/x'\nroom = { position = [0, 0, 0] } # inline\nstations = { right = { "
      "station = 1 } }\n",
      "[tracker]\r\naddress = \"fastrak:/x\" # CR LF\r\nroom.position = [1,\r\n 2, # two\r\n 3]\r\n\r\n# "
      "end\r\n",
      "tracker.address = \"\"\"fastrak:/x\"\"\"\ntracker.stations.head.station = 4\n[glove.right]\naddress = "
      "'5dt:/y'\n",
      "[tracker.room]\nposition = [0, 0, 0]\n[tracker]\naddress = "
      "'fastrak:/x'\n[tracker.stations]\nright.station = 1\n",
      read_file(source_path("deploy/client.toml")),
  };
  Random random(22);
  int written = 0;
  for (const std::string& text : texts) {
    for (const ConfigKey& key : client_config_keys()) {
      if (key.name == "version") continue;
      std::vector<ConfigChange> before = companions(key.name);
      if (key.name.starts_with("tracker.stations."))
        std::erase_if(before, [&](const ConfigChange& c) { return c.key.ends_with(".station"); });
      const std::string role =
          key.name.substr(0, key.name.find('.', std::string("tracker.stations.").size()));
      if (key.name.starts_with("tracker.stations.")) before.push_back({role + ".station", 3.0});
      if (key.name.starts_with("tracker.")) before.push_back({"tracker.address", std::string("fastrak:/x")});
      const std::string base = write_client_config(text, before, "c.toml");
      for (int k = 0; k < 3; ++k) {
        const ConfigChange change = {key.name, key.name.ends_with(".station")
                                                   ? ConfigValue(k + 2.0 > 3 ? 3.0 : k + 2.0)
                                                   : some_value(key, random)};
        SCOPED_TRACE(key.name + " = " + to_toml(change.value) + "\n" + base);
        std::string out;
        try {
          out = write_client_config(base, {change}, "c.toml");
        } catch (const InputError& e) {
          // A rule between keys may refuse a value; it then says so by its name.
          EXPECT_NE(std::string(e.what()).find(key.name.substr(0, key.name.find('.'))), std::string::npos)
              << e.what();
          continue;
        }
        ++written;
        const auto read = key.get(parse_client_config(out, "c.toml"));
        ASSERT_TRUE(read.has_value());
        EXPECT_TRUE(same(*read, change.value)) << to_toml(*read);
        EXPECT_EQ(write_client_config(out, {change}, "c.toml"), out) << "a second time changes nothing";
        if (!key.name.ends_with(".station")) {
          EXPECT_EQ(differing(base, out, {change}), "");
        }
      }
    }
  }
  EXPECT_GT(written, 1000);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> out;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) out.push_back(line);
  return out;
}

// Whatever is changed, each line that doesn't hold a changed key is there as before, in its order.
TEST(ConfigWrite, AllOtherLinesStayByteForByte) {
  const std::string text = read_file(source_path("deploy/client.toml"));
  Random random(23);
  const auto keys = client_config_keys();
  for (int k = 0; k < 400; ++k) {
    std::vector<ConfigChange> changes;
    for (int i = 0; i < 4; ++i) {
      const ConfigKey& key = keys[random.below(keys.size())];
      if (key.name == "version" || key.name.ends_with(".station")) continue;
      changes.push_back({key.name, some_value(key, random)});
    }
    std::string out;
    try {
      out = write_client_config(text, changes, "c.toml");
    } catch (const InputError&) {
      continue;
    }
    const std::vector<std::string> before = lines_of(text), after = lines_of(out);
    std::size_t at = 0, lost = 0;
    for (const std::string& line : before) {
      const auto found = std::find(after.begin() + static_cast<std::ptrdiff_t>(at), after.end(), line);
      if (found == after.end())
        ++lost;
      else
        at = static_cast<std::size_t>(found - after.begin()) + 1;
    }
    EXPECT_LE(lost, changes.size()) << out;
    for (const std::string& line : before) {
      if (const auto comment = line.find('#'); comment != std::string::npos) {
        EXPECT_NE(out.find(line.substr(comment)), std::string::npos) << line;
      }
    }
  }
}

// Texts that were damaged at random are refused in words or changed into what can be read: nothing else
// happens.
TEST(ConfigWrite, DamagedTextsAreRefusedOrChangedCorrectly) {
  const std::string text = read_file(source_path("deploy/client.toml"));
  constexpr std::string_view bytes = "[]{}\"'=.,#\n\r\t \\a1";
  Random random(24);
  int changed = 0;
  for (int k = 0; k < 1500; ++k) {
    std::string damaged = text;
    for (std::size_t i = 0; i <= random.below(3); ++i) {
      const std::size_t at = random.below(damaged.size());
      if (random.below(2) == 0)
        damaged[at] = bytes[random.below(bytes.size())];
      else
        damaged.erase(at, random.below(20));
    }
    const ConfigChange change = {"glove.right.hysteresis", 0.125};
    try {
      const std::string out = write_client_config(damaged, {change}, "c.toml");
      EXPECT_EQ(parse_client_config(out, "c.toml").gloves[right_hand].device.gestures.hysteresis, 0.125)
          << damaged;
      EXPECT_EQ(differing(damaged, out, {change}), "") << damaged;
      ++changed;
    } catch (const InputError& e) {
      EXPECT_NE(std::string(e.what()).find("c.toml"), std::string::npos) << e.what();
    }
  }
  EXPECT_GT(changed, 300);
}

TEST(ConfigWrite, ChangesOneValueAndNothingElse) {
  const std::string text =
      "# mine\n[tracker] # t\naddress = 'fastrak:/x'   # port\n\n[tracker.room]\n"
      "position = [0, 1, 2] # measured\n# end\n";
  EXPECT_EQ(write_client_config(text, {{"tracker.room.position", std::vector<double>{0.5, 1, 2}}}, "c.toml"),
            "# mine\n[tracker] # t\naddress = 'fastrak:/x'   # port\n\n[tracker.room]\n"
            "position = [0.5, 1, 2] # measured\n# end\n");
  EXPECT_EQ(
      write_client_config(text, {{"tracker.field_map", std::string("f.toml")}}, "c.toml"),
      "# mine\n[tracker] # t\naddress = 'fastrak:/x'   # port\nfield_map = \"f.toml\"\n\n[tracker.room]\n"
      "position = [0, 1, 2] # measured\n# end\n");
}

// Tables whose defaults hold only without them: a change of one key must not take the others away.
TEST(ConfigWrite, WhatNoChangeNamesMeansWhatItMeantBefore) {
  const std::string text = "[tracker]\naddress = 'fastrak:/x'\n";
  const ClientConfig gestures = parse_client_config(
      write_client_config(text, {{"gestures.point", std::string("panel")}}, "c.toml"), "c.toml");
  auto expected = ClientConfig().gestures;
  expected[Gesture::point] = GestureEvent::panel;
  EXPECT_EQ(gestures.gestures, expected);
  const auto stations = [&](double instrument) {
    return parse_client_config(
               write_client_config(text, {{"tracker.stations.instrument.station", instrument}}, "c.toml"),
               "c.toml")
        .stations;
  };
  EXPECT_EQ(stations(3)[0], StationRole::right_hand);
  EXPECT_EQ(stations(3)[2], StationRole::instrument);
  EXPECT_EQ(stations(1)[0], StationRole::instrument) << "unless the change takes its receiver";
}

void expect_refusal(const std::vector<ConfigChange>& changes, const char* says) {
  try {
    (void)write_client_config("[tracker]\naddress = 'fastrak:/x'\n", changes, "c.toml");
    ADD_FAILURE() << "accepted, not: " << says;
  } catch (const InputError& e) {
    EXPECT_NE(std::string(e.what()).find(says), std::string::npos) << e.what();
  }
}

TEST(ConfigWrite, RefusesWhatNoFileMayHold) {
  expect_refusal({{"tracker.colour", 1.0}}, "no such key");
  expect_refusal({{"tracker.binary", 1.0}}, "must be true or false");
  expect_refusal({{"tracker.hemisphere", std::vector<double>{1, 2, NAN}}}, "3 numbers within ±1");
  expect_refusal({{"tracker.address", std::string("fastrak:")}}, "path must follow");
  expect_refusal({{"glove.right.pinch", true}}, "glove.right.address: must be given");
  expect_refusal({{"eyes.distance", 0.5}}, "from 0 to 0.2");
}

TEST(ConfigVersions, OlderKeysAreReadAndRenewed) {
  const std::string old =
      "[tracker]\naddress = 'fastrak:/x' # port\nalignment = [0, 0, 0, 200, 0, # x\n 0, 0, 150, 0]\nbinary = "
      "false\n";
  const ClientConfig config = parse_client_config(old, "c.toml");
  ASSERT_TRUE(config.tracker_device.fastrak.alignment.has_value());
  EXPECT_DOUBLE_EQ((*config.tracker_device.fastrak.alignment)[3], 200);
  EXPECT_DOUBLE_EQ((*config.tracker_device.fastrak.alignment)[7], 150);
  const MigratedConfig migrated = migrate_client_config(old);
  ASSERT_EQ(migrated.notes.size(), 1u);
  EXPECT_NE(migrated.notes[0].find("alignment_frame"), std::string::npos);
  const std::string renewed = write_client_config(old, {}, "c.toml");
  EXPECT_NE(renewed.find("version = 2"), std::string::npos) << renewed;
  EXPECT_EQ(parse_client_config(renewed, "c.toml").tracker_device.fastrak.alignment,
            config.tracker_device.fastrak.alignment);
  EXPECT_EQ(write_client_config(renewed, {}, "c.toml"), renewed);
  EXPECT_NE(renewed.find("# port"), std::string::npos);
}

TEST(ConfigVersions, ErrorsAfterARenewedKeyNameTheirOwnLine) {
  const auto says = [](const std::string& text) {
    try {
      (void)parse_client_config(text, "c.toml");
    } catch (const InputError& e) {
      return std::string(e.what());
    }
    return std::string("nothing");
  };
  EXPECT_EQ(
      says("[tracker]\naddress = 'fastrak:/x'\nalignment = [0, 0, 0, 200, 0,\n 0, 0, 150, 0]\nbinary = 1\n"),
      "c.toml:5: tracker.binary: must be true or false");
  EXPECT_EQ(says("version = 3\nnew = 1\n"),
            "c.toml:1: version: a file of version 3 was written by a newer Prosector; this program reads "
            "versions up to 2");
  EXPECT_NE(says("version = 2\n[tracker]\naddress = 'fastrak:/x'\nalignment = [0]\n")
                .find("alignment: unknown key"),
            std::string::npos);
}

TEST(ConfigChange, IsReadAsPeopleGiveIt) {
  EXPECT_EQ(std::get<double>(parse_config_change("eyes.distance", "0.06").value), 0.06);
  EXPECT_EQ(std::get<bool>(parse_config_change("tracker.binary", "false").value), false);
  EXPECT_EQ(std::get<std::string>(parse_config_change("tracker.address", "fastrak:/dev/x").value),
            "fastrak:/dev/x");
  EXPECT_EQ(std::get<std::string>(parse_config_change("gestures.fist", "\"none\"").value), "none");
  EXPECT_EQ(
      std::get<std::vector<double>>(parse_config_change("tracker.room.position", "[1, 2, 3]").value).size(),
      3u);
  EXPECT_THROW((void)parse_config_change("gestures.fist", "explode"), InputError);
  EXPECT_THROW((void)parse_config_change("gestures.wave", "grasp"), InputError);
}

}  // namespace
}  // namespace prosector
