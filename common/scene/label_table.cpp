#include "common/scene/label_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>

#include "common/error.h"
#include "common/ids.h"
#include "common/math.h"
#include "common/regular_file.h"
#include "common/scene/suggest.h"
#include "common/scene_messages.h"
#include "common/valid_text.h"

namespace prosector {
namespace {

constexpr std::size_t max_table_bytes = 4u * 1024 * 1024;
constexpr int max_label = 65535;
constexpr std::string_view blank = " \t";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blank) - first + 1);
}

/// Returns the integer if `text` is exactly one, else nullopt.
std::optional<int> parse_integer(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

double linear(int byte) {  // sRGB to linear (IEC 61966-2-1)
  const double c = byte / 255.;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Parses a label table line by line; errors name the file and the line.
class LabelReader {
 public:
  LabelReader(std::string_view text, const std::string& file) : text_(text) { table_.file = file; }

  LabelTable read() {
    while (next_line()) {
      if (columns_.empty() && table_.labels.empty() && is_header(line_))
        read_header();
      else if (columns_.empty())
        parse_list_line();
      else
        read_row();
    }
    if (table_.labels.empty())
      throw InputError(fmt::format("{}: no labels; at least one is needed", table_.file));
    return std::move(table_);
  }

 private:
  enum class Kind { id, name, term, color, local };
  struct Column {
    Kind kind;
    std::string language;  // of a column name.LANGUAGE
  };

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", table_.file, number_, what));
  }

  /// Advances to the next line that is neither empty nor a comment. Returns false at the end.
  bool next_line() {
    while (!text_.empty()) {
      const std::size_t end = std::min(text_.find('\n'), text_.size());
      line_ = text_.substr(0, end);
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++number_;
      if (line_.ends_with('\r')) line_.remove_suffix(1);
      if (number_ == 1 && line_.starts_with("\xef\xbb\xbf")) line_.remove_prefix(3);  // a byte order mark
      line_ = trimmed(line_);
      if (!line_.empty() && line_.front() != '#') return true;
    }
    return false;
  }

  static bool is_header(std::string_view line) {
    return !parse_integer(line.substr(0, line.find_first_of(" \t,")));
  }

  /// Splits the line at commas. A cell in double quotes may contain commas, and quotes written twice.
  std::vector<std::string> cells() const {
    std::vector<std::string> out(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line_.size(); ++i) {
      const char c = line_[i];
      if (c == '"' && quoted && i + 1 < line_.size() && line_[i + 1] == '"')
        out.back() += line_[++i];
      else if (c == '"')
        quoted = !quoted;
      else if (c == ',' && !quoted)
        out.emplace_back();
      else
        out.back() += c;
    }
    if (quoted) fail("unclosed quote");
    for (std::string& cell : out) cell = trimmed(cell);
    return out;
  }

  void read_header() {
    std::vector<std::string> seen;
    for (const std::string& cell : cells()) {
      if (std::ranges::find(seen, cell) != seen.end()) fail(fmt::format("duplicate column \"{}\"", cell));
      columns_.push_back(column(cell));
      seen.push_back(cell);
    }
    if (std::ranges::find(seen, "name") == seen.end())
      fail(
          "no column \"name\"; allowed: a row of columns (name, id, ta, color, name.LANGUAGE), or lines of a "
          "number and a name");
    if (seen.size() > max_local_names) {
      const auto local = std::ranges::count(columns_, Kind::local, &Column::kind);
      if (local > static_cast<std::ptrdiff_t>(max_local_names))
        fail(fmt::format("the label table has names in {} languages; allowed: {} at most", local,
                         max_local_names));
    }
  }

  Column column(const std::string& title) const {
    static const std::map<std::string_view, Kind> kinds = {
        {"id", Kind::id}, {"name", Kind::name}, {"ta", Kind::term}, {"color", Kind::color}};
    if (const auto found = kinds.find(title); found != kinds.end()) return {found->second, ""};
    constexpr std::string_view local = "name.";
    if (title.starts_with(local)) {
      const std::string language = title.substr(local.size());
      if (is_language_tag(language)) return {Kind::local, language};
      fail(fmt::format("column \"{}\": \"{}\" is not a language tag; allowed: e.g. de, tr, pt-BR", title,
                       language));
    }
    constexpr std::array<std::string_view, 4> known = {"id", "name", "ta", "color"};
    fail(fmt::format("column \"{}\": must be one of: {}, name.LANGUAGE{}", title, fmt::join(known, ", "),
                     title.empty() ? "" : suggest(title, known)));
  }

  void read_row() {
    const std::vector<std::string> row = cells();
    if (row.size() != columns_.size())
      fail(fmt::format("this row has {} cells, but the header row has {} columns; the numbers must be equal",
                       row.size(), columns_.size()));
    Label label;
    for (std::size_t i = 0; i < row.size(); ++i)
      if (!row[i].empty()) read_cell(columns_[i], row[i], label);
    add(std::move(label));
  }

  void read_cell(const Column& column, const std::string& cell, Label& label) const {
    switch (column.kind) {
      case Kind::id:
        label.id = id(cell);
        return;
      case Kind::name:
        label.name = cell;
        return;
      case Kind::term:
        if (cell.size() > max_term_length || !valid_name(cell))
          fail(fmt::format("column ta: must be text of at most {} bytes", max_term_length));
        label.term = cell;
        return;
      case Kind::color:
        label.color = hex_color(cell);
        return;
      case Kind::local:
        check_name("name." + column.language, cell);
        label.names.push_back({column.language, cell});
        return;
    }
  }

  int id(std::string_view cell) const {
    const std::optional<int> value = parse_integer(cell);
    if (!value || *value < 1 || *value > max_label)
      fail(fmt::format("id = \"{}\": must be a whole number in [1, {}]", cell, max_label));
    return *value;
  }

  Vec3 hex_color(std::string_view cell) const {
    unsigned rgb = 0;
    const auto [end, error] = std::from_chars(cell.data() + 1, cell.data() + cell.size(), rgb, 16);
    if (cell.size() != 7 || cell.front() != '#' || error != std::errc{} || end != cell.data() + cell.size())
      fail(fmt::format("color = \"{}\": must be #rrggbb, e.g. #b8443a", cell));
    return {linear(static_cast<int>(rgb >> 16)), linear(static_cast<int>(rgb >> 8 & 0xff)),
            linear(static_cast<int>(rgb & 0xff))};
  }

  /// Parses a line such as "12 Frontal_Inf 2301" or "12 Frontal_Inf 221 130 101 255".
  void parse_list_line() {
    std::vector<std::string_view> words;
    for (std::string_view rest = line_; !rest.empty();) {
      const std::size_t end = std::min(rest.find_first_of(blank), rest.size());
      words.push_back(rest.substr(0, end));
      rest = trimmed(rest.substr(end));
    }
    if (words.size() < 2)
      fail("this line has a number without a name; allowed: a number, a name, then a code or a colour");
    if (words.front() == "0") return;  // background
    Label label;
    label.id = id(words[0]);
    label.name = words[1];
    std::ranges::replace(label.name, '_', ' ');
    label.color = parse_listed_color(words);
    add(std::move(label));
  }

  std::optional<Vec3> parse_listed_color(const std::vector<std::string_view>& words) const {
    if (words.size() <= 3) return std::nullopt;  // a code, or nothing
    if (words.size() > 6)
      fail("this line has more than a number, a name and a colour; write spaces in names as _");
    Vec3 color;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::optional<int> byte = words.size() > 2 + k ? parse_integer(words[2 + k]) : std::nullopt;
      if (!byte || *byte < 0 || *byte > 255)
        fail("the colour must be three or four whole numbers in [0, 255]");
      color[static_cast<int>(k)] = linear(*byte);
    }
    return color;
  }

  void check_name(std::string_view column, const std::string& name) const {
    if (!valid_name(name))
      fail(fmt::format("{} = \"{}\": must be 1 to {} bytes of UTF-8 without control characters", column,
                       valid_utf8(name) ? name : "?", max_name_length));
  }

  void add(Label label) {
    if (label.name.empty()) fail("name is missing");
    check_name("name", label.name);
    if (label.id > 0 && !ids_.emplace(label.id, number_).second)
      fail(fmt::format("id {} is already used in line {}; ids must differ", label.id, ids_[label.id]));
    if (!names_.emplace(label.name, number_).second)
      fail(fmt::format("name \"{}\" is already used in line {}; names must differ", label.name,
                       names_[label.name]));
    table_.labels.push_back(std::move(label));
  }

  std::string_view text_, line_;
  int number_ = 0;
  LabelTable table_;
  std::vector<Column> columns_;
  std::map<int, int> ids_;  // line number of each id
  std::map<std::string, int> names_;
};

}  // namespace

const Label* LabelTable::find(int id) const {
  const auto found = std::ranges::find(labels, id, &Label::id);
  return id <= 0 || found == labels.end() ? nullptr : &*found;
}

const Label* LabelTable::find(std::string_view name) const {
  const auto found = std::ranges::find(labels, name, &Label::name);
  return found == labels.end() ? nullptr : &*found;
}

LabelTable parse_labels(std::string_view text, const std::string& file) {
  return LabelReader(text, file).read();
}

LabelTable load_labels(const std::filesystem::path& file) {
  return parse_labels(read_regular_file(file, max_table_bytes), file.string());
}

}  // namespace prosector
