// Tables of names: both forms, and every way in which they can be wrong.

#include "common/scene/label_table.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "common/error.h"
#include "common/ids.h"
#include "common/local_name.h"
#include "common/math.h"
#include "common/scene/load_scene.h"
#include "common/scene/material.h"
#include "tests/folders.h"

namespace prosector {
namespace {

std::string refusal_of(const std::string& text) {
  try {
    parse_labels(text, "t.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(LabelTable, CsvNamesColumns) {
  const LabelTable t = parse_labels(
      "\xef\xbb\xbf# a comment\n\n id , name,name.de,ta,color, name.pt-BR\r\n"
      "7,liver,Leber,A05.8.01.001,#ffffff,\n"
      ",\"a, \"\"b\"\"\",,,#000000,x\n",
      "t.csv");
  ASSERT_EQ(t.labels.size(), 2u);
  EXPECT_EQ(t.labels[0].id, 7);
  EXPECT_EQ(t.labels[0].names, (std::vector<LocalName>{{"de", "Leber"}}));
  EXPECT_EQ(t.labels[0].term, "A05.8.01.001");
  EXPECT_TRUE(t.labels[0].color->isApprox(Vec3::Ones()));
  EXPECT_EQ(t.labels[1].name, "a, \"b\"");
  EXPECT_TRUE(t.labels[1].color->isZero());
  EXPECT_EQ(t.labels[1].names, (std::vector<LocalName>{{"pt-BR", "x"}}));
  EXPECT_EQ(t.find(7), &t.labels[0]);
  EXPECT_EQ(t.find("a, \"b\""), &t.labels[1]);
  EXPECT_EQ(t.find(0), nullptr);  // what has no id is not label 0
  EXPECT_EQ(t.find("b"), nullptr);
}

TEST(LabelTable, ListsAreNumberAndName) {
  const LabelTable t = parse_labels(
      "0 Background 0 0 0 0\r\n1 Precentral_L 2001\r\n2\tPrecentral_R\n116 Vermis 255 0 0 255\n", "t.txt");
  ASSERT_EQ(t.labels.size(), 3u);
  EXPECT_EQ(t.labels[0].name, "Precentral L");
  EXPECT_FALSE(t.labels[0].color.has_value());
  EXPECT_EQ(t.labels[2].id, 116);
  EXPECT_TRUE(t.labels[2].color->isApprox(Vec3(1, 0, 0)));
}

TEST(LabelTable, SaysWhatIsWrongAndWhere) {
  struct {
    const char *text, *line, *what;
  } const table[] = {
      {"", "t.csv", "no labels; at least one"},
      {"name\n", "t.csv", "no labels; at least one"},
      {"id,ta\n", ":1:", "no column \"name\""},
      {"id,nmae\n", ":1:", "did you mean \"name\""},
      {"name,\n", ":1:", "must be one of: id, name, ta, color, name.LANGUAGE"},
      {"name,name.d_e\n", ":1:", "is not a language tag"},
      {"name,name\n", ":1:", "duplicate column"},
      {"name,id\nliver\n", ":2:", "this row has 1 cells, but the header row has 2"},
      {"id,name\n0,liver\n", ":2:", "in [1, 65535]"},
      {"id,name\n65536,liver\n", ":2:", "in [1, 65535]"},
      {"id,name\n1.5,liver\n", ":2:", "whole number"},
      {"id,name\n1,a\n1,b\n", ":3:", "already used in line 2"},
      {"id,name\n1,a\n2,a\n", ":3:", "names must differ"},
      {"id,name\n1,\n", ":2:", "name is missing"},
      {"name,color\na,red\n", ":2:", "#rrggbb"},
      {"name,color\na,#12345g\n", ":2:", "#rrggbb"},
      {"name\n\"a\n", ":2:", "quote"},
      {"name\n\xff\n", ":2:", "UTF-8"},
      {"name\na\x01\n", ":2:", "control characters"},
      {"1\n", ":1:", "without a name"},
      {"1 a 1 2 999\n", ":1:", "[0, 255]"},
      {"1 a 1 2\n", ":1:", "three or four"},
      {"1 a 1 2 3 4 5\n", ":1:", "names as _"},
      {"-1 a\n", ":1:", "in [1, 65535]"},
  };
  for (const auto& row : table) {
    const std::string said = refusal_of(row.text);
    EXPECT_NE(said.find(row.line), std::string::npos) << row.text << said;
    EXPECT_NE(said.find(row.what), std::string::npos) << row.text << said;
  }
  EXPECT_NE(refusal_of("name\n" + std::string(max_name_length + 1, 'x')).find("1 to 63 bytes"),
            std::string::npos);
  std::string languages = "name";
  for (char c = 'a'; c <= 'q'; ++c) languages += fmt::format(",name.{}", c);
  EXPECT_NE(refusal_of(languages + "\n").find("16 at most"), std::string::npos);
}

TEST(LabelTable, MutatedTablesAreReadOrRefused) {
  const std::string good = "id,name,name.de,ta,color\n1,\"a, b\",c,A05,#a0b1c2\n2,d,,,\n3,Größe,x,,#ffffff\n";
  std::mt19937_64 random(1);
  for (int round = 0; round < 20000; ++round) {
    std::string text = good;
    for (std::size_t k = 1 + random() % 4; k > 0; --k)
      if (random() % 3 == 0)
        text.erase(random() % text.size(), 1 + random() % 3);
      else
        text[random() % text.size()] =
            static_cast<char>(random() % 3 == 0 ? random() : good[random() % good.size()]);
    try {
      for (const Label& label : parse_labels(text, "t").labels) {
        EXPECT_LE(label.name.size(), max_name_length);
        EXPECT_TRUE(label.id >= 0 && label.id <= 65535);
      }
    } catch (const InputError&) {
    }
  }
}

// Every named part of what ships has a name in each language that ships.
TEST(ShippedLabels, NameEveryBodyInGermanAndTurkish) {
  const std::filesystem::path folder = source_path("deploy/scenes");
  const LabelTable table = load_labels(folder / "labels.csv");
  const auto is_whole = [](const Label& label) {
    std::vector<std::string> languages;
    for (const LocalName& local : label.names) languages.push_back(local.language);
    return languages == std::vector<std::string>{"de", "tr"};
  };
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    const SceneDesc scene = load_scene(entry.path());
    EXPECT_EQ(scene.labels, "labels.csv") << entry.path();
    const auto check = [&](const std::string& name) {
      const Label* label = table.find(name);
      ASSERT_NE(label, nullptr) << entry.path() << ": " << name;
      EXPECT_TRUE(is_whole(*label)) << name;
    };
    for (const RigidDesc& body : scene.rigid) check(body.name);
    for (const SoftDesc& body : scene.soft) check(body.name);
  }
  const LabelTable brain = load_labels(folder / "brain.csv");
  EXPECT_EQ(brain.labels.size(), 116u);
  for (const Label& label : brain.labels) EXPECT_TRUE(is_whole(label) && label.color) << label.name;
  EXPECT_EQ(table.find("liver")->term, "A05.8.01.001");
}

TEST(Materials, AreKnownByAWordOfTheName) {
  struct {
    const char *part, *material;
  } const table[] = {{"liver", "liver"},
                     {"Left_Kidney 2", "kidney"},
                     {"LeftKidney", "kidney"},
                     {"skull", "bone"},
                     {"rib 7", "bone"},
                     {"gallbladder", "gallbladder"},
                     {"urinary bladder", "bladder"},
                     {"delivery", "tissue"},
                     {"", "tissue"},
                     {"vena cava", "vessel"},
                     {"Precentral L", "tissue"}};
  for (const auto& row : table) EXPECT_EQ(material_for_part(row.part).name, row.material) << row.part;
  for (const Material& material : materials()) {
    EXPECT_EQ(find_material(material.name), &material);
    EXPECT_TRUE(material.rigid || (material.youngs_modulus > 0 && material.toughness > 0)) << material.name;
    EXPECT_TRUE(material.density > 100 && material.usual_size > 0) << material.name;
  }
}

}  // namespace
}  // namespace prosector
