// Properties of every row of the field tables.

#include "common/scene/scene_fields.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <sstream>

#include "tests/folders.h"
#include "tests/scene/scene_texts.h"

namespace prosector {
namespace {

void for_each_table(const Table& table, const std::function<void(const Table&)>& visit) {
  visit(table);
  for (const Child& child : table.children) for_each_table(child.table(), visit);
}

/// `x` as the field's type is written: 1.5, 2, "1.5 ms" or [1.5, 1.5, 1.5]; empty: the field holds no number.
std::string written(const Field& field, const FieldRef& ref, double x) {
  if (std::holds_alternative<int*>(ref)) return fmt::format("{}", static_cast<long long>(x));
  const std::string number = std::isfinite(x) ? fmt::format("{:.17e}", x) : fmt::format("{}", x);
  if (std::holds_alternative<double*>(ref)) return number;
  if (std::holds_alternative<Quantity*>(ref)) return fmt::format("\"{} {}\"", number, field.unit);
  if (std::holds_alternative<Vec3*>(ref)) return fmt::format("[{0}, {0}, {0}]", number);
  return "";
}

void for_each_number(const std::function<void(const Table&, const Field&, const FieldRef&)>& visit) {
  for_each_table(scene_table(), [&](const Table& table) {
    const auto fresh = table.fresh();
    for (const Field& field : table.fields)
      if (const FieldRef ref = field.in(fresh.get()); !written(field, ref, 1).empty())
        visit(table, field, ref);
  });
}

/// Returns what else has to be said with a field of this table: a patient's directions are perpendicular, and
/// what is `written` of one is along [1, 1, 1].
std::string companion(const Table& table, const Field& field) {
  if (table.name != "[patient]") return "";
  return fmt::format("\n{} = [1, -1, 0]", field.key == "right" ? "head" : "right");
}

std::string complaint_about(const Table& table, const Field& field, const std::string& value) {
  return complaint(scene_with(std::string(table.name),
                              fmt::format("{} = {}{}", field.key, value, companion(table, field))));
}

TEST(SceneFields, EveryRangeRejectsWhatLiesOutside) {
  for_each_number([](const Table& table, const Field& field, const FieldRef& ref) {
    const bool whole = std::holds_alternative<int*>(ref);
    const Range& r = field.range;
    const double step = whole ? 1 : 1e-9 * std::max({1.0, std::abs(r.min), std::abs(r.max)});
    for (const double x : {r.open_min ? r.min : r.min - step, r.open_max ? r.max : r.max + step})
      EXPECT_NE(complaint_about(table, field, written(field, ref, x)).find("must be"), std::string::npos)
          << table.name << " " << field.key << " took " << x;
  });
}

TEST(SceneFields, EveryRangeAcceptsItsInside) {
  for_each_number([](const Table& table, const Field& field, const FieldRef& ref) {
    const Range& r = field.range;
    const double third = r.min + (r.max - r.min) / 3;  // not 0: a direction may not be
    EXPECT_EQ(complaint_about(table, field,
                              written(field, ref, std::floor(third) > r.min ? std::floor(third) : third)),
              "");
    if (!r.open_min) {
      EXPECT_EQ(complaint_about(table, field, written(field, ref, r.min)), "");
    }
    if (!r.open_max) {
      EXPECT_EQ(complaint_about(table, field, written(field, ref, r.max)), "");
    }
  });
}

TEST(SceneFields, NoNumberMayBeNanOrInfinite) {
  for_each_number([](const Table& table, const Field& field, const FieldRef& ref) {
    for (const char* bad : {"nan", "inf", "-inf"}) {
      const std::string value = std::holds_alternative<Vec3*>(ref) ? fmt::format("[0, {}, 0]", bad) : bad;
      EXPECT_NE(complaint_about(table, field, value), "") << table.name << " " << field.key;
    }
  });
}

TEST(SceneFields, EveryDefaultIsInItsOwnRange) {
  for_each_number([](const Table& table, const Field& field, const FieldRef& ref) {
    if (const auto* x = std::get_if<double*>(&ref)) {
      EXPECT_TRUE(field.range.contains(**x)) << table.name << field.key;
    }
    if (const auto* n = std::get_if<int*>(&ref)) {
      EXPECT_TRUE(field.range.contains(**n)) << table.name << field.key;
    }
    if (const auto* v = std::get_if<Vec3*>(&ref)) {
      for (const double x : **v) EXPECT_TRUE(field.range.contains(x)) << table.name << field.key;
    }
  });
}

TEST(SceneFields, EveryFieldRejectsAWrongType) {
  for_each_table(scene_table(), [](const Table& table) {
    for (const Field& field : table.fields)
      if (!field.required) {
        EXPECT_NE(complaint_about(table, field, "1979-05-27"), "") << table.name << " " << field.key;
      }
  });
}

TEST(SceneFields, KeysDifferAndShareNoStorage) {
  for_each_table(scene_table(), [](const Table& table) {
    std::set<std::string_view> keys;
    std::set<const void*> places;
    const auto fresh = table.fresh();
    for (const Field& field : table.fields) {
      EXPECT_TRUE(keys.insert(field.key).second) << table.name << " " << field.key;
      const void* place =
          std::visit([](auto* p) { return static_cast<const void*>(p); }, field.in(fresh.get()));
      EXPECT_TRUE(places.insert(place).second) << table.name << " " << field.key;
    }
  });
}

TEST(SceneFields, ManualIsTheOneCommitted) {
  std::ostringstream generated;
  write_scene_manual(generated);
  std::ifstream file(source_path("docs/look-up/scene.md"));
  const std::string committed{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(generated.str(), committed) << "mend it with: prosector-scene --manual > docs/look-up/scene.md";
}

TEST(SceneFields, AListTakesThePlaceOfItsDefault) {
  const auto judged_by = [](const std::string& text) {
    return parse_scene("name = \"s\"\n[[soft]]\nname = \"a\"\nshape = \"block\"\naccuracy = \"2 %\"\n" + text,
                       "s.toml")
        .soft[0]
        .choice.accuracy_of;
  };
  EXPECT_EQ(judged_by(""), (std::vector<std::string>{"shape", "touch"}));
  EXPECT_EQ(judged_by("accuracy_of = [\"shape\"]\n"), std::vector<std::string>{"shape"});
  EXPECT_THROW(judged_by("accuracy_of = []\n"), InputError);
  EXPECT_THROW(judged_by("accuracy_of = [\"weight\"]\n"), InputError);
}

TEST(SceneFields, EverySceneFileHasARoomThatCollidesUnlessItSaysNot) {
  const auto room_of = [](const std::string& text) {
    return parse_scene("name = \"s\"\n" + text, "s.toml").room;
  };
  const auto whole = room_of("");
  ASSERT_TRUE(whole);
  EXPECT_TRUE(whole->floor && whole->walls);
  const auto no_floor = room_of("[room]\nfloor = false\n");
  EXPECT_TRUE(no_floor && !no_floor->floor && no_floor->walls);
  const auto no_walls = room_of("[room]\nwalls = false\n");
  EXPECT_TRUE(no_walls && no_walls->floor && !no_walls->walls);
  EXPECT_FALSE(SceneDesc().room) << "in code, nobody asked for one";
  EXPECT_NE(complaint("name = \"s\"\n[room]\nceiling = true\n").find("ceiling"), std::string::npos);
  EXPECT_NE(complaint("name = \"s\"\n[room]\nfloor = 1\n").find("true or false"), std::string::npos);
}

}  // namespace
}  // namespace prosector
