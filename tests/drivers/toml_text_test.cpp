// Texts of any shape that TOML allows, changed in place and judged by toml++.
#include "drivers/files/toml_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <map>

#include "tests/random.h"

namespace prosector {
namespace {

/// Makes TOML texts: headers, dotted keys, inline tables, arrays over lines, strings of all kinds, comments.
class TextMaker {
 public:
  explicit TextMaker(Random& random) : random_(random) {}

  std::string text() {
    std::string out = random_.below(3) == 0 ? "# head = [1]\n\n" : "";
    lines(out, "r");
    for (const char* header : {"a", "b.c", "d"}) {
      if (random_.below(3) == 0) continue;
      out += fmt::format("[{}]{}\n", header, random_.below(2) == 0 ? " # [x]" : "");
      lines(out, "k");
    }
    if (random_.below(4) == 0) out += "[[list]]\nn = 1\n";
    if (random_.below(5) == 0 && !out.empty()) out.pop_back();  // no line break at the end
    return out;
  }

 private:
  void lines(std::string& out, const std::string& stem) {
    for (std::size_t i = 0, n = random_.below(4); i < n; ++i) {
      const char* dotted = random_.below(3) == 0 ? ".x" : "";
      out += fmt::format("{}{}{}{}= {}{}\n", random_.below(3) == 0 ? "  " : "", stem, i, dotted, value(0),
                         comment());
      if (random_.below(4) == 0) out += "\n# k9 = 2\n";
    }
  }
  std::string comment() { return random_.below(3) == 0 ? " # it's \"[{\" = 1" : ""; }
  std::string value(int depth) {
    switch (random_.below(depth > 2 ? 6 : 9)) {
      case 0:
        return "1";
      case 1:
        return "-2.5e3";
      case 2:
        return "\"a # \\\" b = ]\"";
      case 3:
        return "'c:\\ # ]'";
      case 4:
        return "true";
      case 5:
        return "\"\"\"two\nlines # \\\" ] \"quoted\"\"\"\"";
      case 6:
        return fmt::format("[{}, # one, ]\n {}\n]", value(3), value(3));
      case 7:
        return "[ { p = 1 }, { p = 2, q = [1] } ]";
      default:
        return fmt::format("{{ i = {}, j = {{ k = 1 }} }}", depth == 0 ? "1" : "'x'");
    }
  }

  Random& random_;
};

/// All leaves of a table by their dotted names, as text.
void leaves(const toml::table& table, const std::string& prefix, std::map<std::string, std::string>& out) {
  for (const auto& [key, node] : table) {
    const std::string name = fmt::format("{}{}{}", prefix, prefix.empty() ? "" : ".", key.str());
    if (const toml::table* inner = node.as_table()) {
      leaves(*inner, name, out);
      continue;
    }
    std::ostringstream text;
    node.visit([&](const auto& n) { text << n; });
    out[name] = text.str();
  }
}

TEST(TomlEditor, ChangesOneKeyAndNoOther) {
  Random random(25);
  TextMaker maker(random);
  const char* added[] = {"r0.z",      "new",        "a.new", "a.k0.y", "b.c.new",
                         "b.c.new.x", "b.c.k0.y.z", "b.new", "d.e.f",  "e.f.g"};
  int changed = 0, made = 0;
  for (int k = 0; k < 3000; ++k) {
    const std::string text = maker.text();
    std::map<std::string, std::string> before, after;
    try {
      leaves(toml::parse(text), "", before);
    } catch (const toml::parse_error&) {
      continue;  // a key twice, by chance
    }
    std::string name = added[random.below(std::size(added))];
    if (!before.empty() && random.below(2) == 0)
      name = std::next(before.begin(), static_cast<std::ptrdiff_t>(random.below(before.size())))->first;
    // What is a value can't become a table, nor a table a value.
    bool clashes = false;
    for (const auto& [other, value] : before)
      clashes =
          clashes || (other != name && (other.starts_with(name + ".") || name.starts_with(other + ".")));
    if (clashes || name.starts_with("list")) continue;
    SCOPED_TRACE(fmt::format("{} in:\n{}", name, text));
    TomlEditor edited(text);
    EXPECT_EQ(edited.value(split_toml_path(name)).has_value(), before.contains(name));
    edited.set(split_toml_path(name), "\"set\"");
    ASSERT_NO_THROW(leaves(toml::parse(edited.text()), "", after)) << edited.text();
    (before.contains(name) ? changed : made)++;
    before[name] = after[name];
    EXPECT_EQ(after, before) << edited.text();
    EXPECT_NE(after[name].find("set"), std::string::npos);
    // Nothing but the value, or what was added, differs.
    const std::string& now = edited.text();
    std::size_t head = 0, tail = 0;
    while (head < text.size() && head < now.size() && text[head] == now[head]) ++head;
    while (tail < text.size() - head && tail < now.size() - head &&
           text[text.size() - 1 - tail] == now[now.size() - 1 - tail])
      ++tail;
    EXPECT_LE(now.size() - head - tail, 40u) << now;
    if (HasFailure()) break;
  }
  EXPECT_GT(changed, 300);
  EXPECT_GT(made, 300);
}

}  // namespace
}  // namespace prosector
