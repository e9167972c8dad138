#include "drivers/files/toml_text.h"

#include <fmt/format.h>

#include <algorithm>

namespace prosector {
namespace {

bool starts_with(const TomlPath& path, const TomlPath& prefix) {
  return path.size() >= prefix.size() && std::equal(prefix.begin(), prefix.end(), path.begin());
}

std::string dotted(TomlPath::const_iterator begin, TomlPath::const_iterator end) {
  std::string out;
  for (auto part = begin; part != end; ++part) out += fmt::format("{}{}", out.empty() ? "" : ".", *part);
  return out;
}

bool is_space(char c) {
  return c == ' ' || c == '\t';
}

}  // namespace

TomlPath split_toml_path(std::string_view text) {
  TomlPath out;
  for (;;) {
    const auto dot = text.find('.');
    out.emplace_back(text.substr(0, dot));
    if (dot == std::string_view::npos) return out;
    text.remove_prefix(dot + 1);
  }
}

TomlEditor::TomlEditor(std::string text)
    : text_(std::move(text)), line_break_(text_.find("\r\n") == std::string::npos ? "\n" : "\r\n") {
  scan();
}

void TomlEditor::scan() {
  entries_.clear();
  sections_.assign(1, {{}, 0});
  // Root keys are added before everything else, but after a leading comment.
  constexpr std::string_view mark = "\xEF\xBB\xBF";
  const bool marked = std::string_view(text_).starts_with(mark);
  std::size_t head = marked ? mark.size() : 0;
  while (head < text_.size() && text_[head] == '#') head = line_end(head);
  sections_.front().end = head;
  for (std::size_t at = marked ? mark.size() : 0; at < text_.size();) {
    at = skip_blank(at);
    if (at >= text_.size()) break;
    if (text_[at] == '[') {
      at = scan_header(at);
    } else {
      at = line_end(scan_entry(at, sections_.back().path, false));
      sections_.back().end = at;
      sections_.back().has_keys = true;
    }
  }
}

/// Skips spaces, line breaks and comments.
std::size_t TomlEditor::skip_blank(std::size_t at) const {
  while (at < text_.size()) {
    if (text_[at] == '#')
      at = line_end(at);
    else if (is_space(text_[at]) || text_[at] == '\n' || text_[at] == '\r')
      ++at;
    else
      break;
  }
  return at;
}

/// Returns the offset of the next line.
std::size_t TomlEditor::line_end(std::size_t at) const {
  const auto found = text_.find('\n', at);
  return found == std::string::npos ? text_.size() : found + 1;
}

std::size_t TomlEditor::scan_header(std::size_t at) {
  while (text_[at] == '[') ++at;
  Section section;
  at = line_end(scan_key(at, section.path, nullptr));
  section.end = at;
  sections_.push_back(section);
  return at;
}

/// Appends the parts of a dotted key to `path`. Returns the end offset; `last` receives the start of the last
/// part.
std::size_t TomlEditor::scan_key(std::size_t at, TomlPath& path, std::size_t* last) const {
  std::size_t end = at;
  for (;; ++at) {
    while (at < text_.size() && is_space(text_[at])) ++at;
    if (last != nullptr) *last = at;
    if (at < text_.size() && (text_[at] == '"' || text_[at] == '\'')) {
      end = at + 1;
      while (end < text_.size() && text_[end] != text_[at])
        end += text_[end] == '\\' && text_[at] == '"' ? 2 : 1;
      path.push_back(text_.substr(at + 1, end - at - 1));
      end = std::min(end + 1, text_.size());
    } else {
      end = text_.find_first_of(" \t.=]", at);
      end = std::min(end, text_.size());
      path.push_back(text_.substr(at, end - at));
    }
    at = end;
    while (at < text_.size() && is_space(text_[at])) ++at;
    if (at >= text_.size() || text_[at] != '.') return end;
  }
}

/// Scans KEY = VALUE. Returns the end offset of the value.
std::size_t TomlEditor::scan_entry(std::size_t at, const TomlPath& prefix, bool is_inline) {
  Entry entry{};
  entry.path = prefix;
  entry.section = sections_.size() - 1;
  entry.is_inline = is_inline;
  entry.key_end = scan_key(at, entry.path, &entry.key_begin);
  at = text_.find('=', entry.key_end);
  at = std::min(at, text_.size() - 1) + 1;
  while (at < text_.size() && is_space(text_[at])) ++at;
  entry.value_begin = at;
  const std::size_t index = entries_.size();
  entries_.push_back(entry);
  bool is_table = false;
  const std::size_t end = scan_value(at, entry.path, &is_table);
  entries_[index].value_end = end;
  entries_[index].is_table = is_table;
  return end;
}

/// Scans a value and returns its end offset. Members of an inline table become entries, unless the table is
/// inside an array.
std::size_t TomlEditor::scan_value(std::size_t at, const TomlPath& path, bool* is_table) {
  if (at >= text_.size()) return at;
  const char c = text_[at];
  if (c == '"' || c == '\'') {
    const std::string triple(3, c);
    const bool multi = text_.compare(at, 3, triple) == 0;
    std::size_t end = at + (multi ? 3 : 1);
    while (end < text_.size() && (multi ? text_.compare(end, 3, triple) != 0 : text_[end] != c))
      end += c == '"' && text_[end] == '\\' ? 2 : 1;
    end += multi ? 3 : 1;
    while (multi && end < text_.size() && text_[end] == c) ++end;  // quotes may precede the closing three
    return std::min(end, text_.size());
  }
  if (c == '[' || c == '{') {
    const char close = c == '[' ? ']' : '}';
    for (at = skip_blank(at + 1); at < text_.size() && text_[at] != close; at = skip_blank(at)) {
      if (text_[at] == ',')
        ++at;
      else if (c == '[')
        at = scan_value(at, {}, nullptr);
      else
        at = scan_entry(at, path, true);
    }
    if (is_table != nullptr) *is_table = c == '{';
    return std::min(at + 1, text_.size());
  }
  std::size_t end = std::min(text_.find_first_of(",]}#\r\n", at), text_.size());
  while (end > at && is_space(text_[end - 1])) --end;
  return end;
}

const TomlEditor::Entry* TomlEditor::find(const TomlPath& path) const {
  const auto found =
      std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.path == path; });
  return found == entries_.end() ? nullptr : &*found;
}

std::optional<std::string> TomlEditor::value(const TomlPath& path) const {
  const Entry* entry = find(path);
  if (entry == nullptr) return std::nullopt;
  return text_.substr(entry->value_begin, entry->value_end - entry->value_begin);
}

bool TomlEditor::has_table(const TomlPath& path) const {
  const auto below = [&](const auto& thing) { return starts_with(thing.path, path); };
  return std::any_of(entries_.begin(), entries_.end(), below) ||
         std::any_of(sections_.begin(), sections_.end(), below);
}

void TomlEditor::replace(std::size_t begin, std::size_t end, const std::string& with) {
  text_.replace(begin, end - begin, with);
  scan();
}

void TomlEditor::rename(const TomlPath& path, const std::string& name) {
  if (const Entry* entry = find(path)) replace(entry->key_begin, entry->key_end, name);
}

void TomlEditor::set(const TomlPath& path, const std::string& value) {
  if (const Entry* entry = find(path)) return replace(entry->value_begin, entry->value_end, value);
  if (!add_to_inline_table(path, value) && !add_to_section(path, value)) add_section(path, value);
}

bool TomlEditor::add_to_inline_table(const TomlPath& path, const std::string& value) {
  const Entry* deepest = nullptr;
  for (const Entry& e : entries_)
    if (e.is_table && starts_with(path, e.path) &&
        (deepest == nullptr || e.path.size() > deepest->path.size()))
      deepest = &e;
  if (deepest == nullptr) return false;
  std::size_t at = deepest->value_end - 1;  // the closing brace
  while (is_space(text_[at - 1])) --at;
  const bool empty = text_[at - 1] == '{';
  const auto from = path.begin() + static_cast<std::ptrdiff_t>(deepest->path.size());
  replace(at, deepest->value_end - 1,
          fmt::format("{}{} = {}{}", empty ? " " : ", ", dotted(from, path.end()), value, " "));
  return true;
}

/// Returns the section of a super-table such as [tracker.stations] in which `table` can be created with a
/// dotted key. Returns nothing if there is none or headers already define `table`.
std::optional<std::size_t> TomlEditor::group_for(const TomlPath& table) const {
  constexpr std::size_t least_depth = 2;
  for (std::size_t i = 1; i < sections_.size(); ++i) {
    const TomlPath& group = sections_[i].path;
    if (group.size() < least_depth || group.size() >= table.size() || !starts_with(table, group)) continue;
    if (!has_table(TomlPath(table.begin(), table.begin() + static_cast<std::ptrdiff_t>(group.size()) + 1)))
      return i;
  }
  return std::nullopt;
}

bool TomlEditor::add_to_section(const TomlPath& path, const std::string& value) {
  // A table created by dotted keys cannot also have a header, so a new key is added after those keys.
  const TomlPath table(path.begin(), path.end() - 1);
  std::optional<std::size_t> chosen;
  std::size_t shared = 0;
  for (const Entry& e : entries_) {
    if (e.is_inline) continue;
    const std::size_t header = sections_[e.section].path.size();
    std::size_t common = 0;
    while (common + 1 < e.path.size() && common < table.size() && e.path[common] == table[common]) ++common;
    if (common > header && common > shared && starts_with(path, sections_[e.section].path)) {
      chosen = e.section;
      shared = common;
    }
  }
  for (std::size_t i = 0; i < sections_.size(); ++i) {
    const bool is_tables = i == 0 ? table.empty() : sections_[i].path == table;
    if (is_tables && sections_[i].path.size() >= shared) {
      chosen = i;
      shared = sections_[i].path.size();
    }
  }
  if (!chosen) chosen = group_for(table);
  if (!chosen) return false;
  const Section& section = sections_[*chosen];
  const bool breaks = section.end > 0 && text_[section.end - 1] != '\n';
  const auto from = path.begin() + static_cast<std::ptrdiff_t>(section.path.size());
  replace(
      section.end, section.end,
      fmt::format("{}{} = {}{}", breaks ? line_break_ : "", dotted(from, path.end()), value, line_break_));
  return true;
}

void TomlEditor::add_section(const TomlPath& path, const std::string& value) {
  std::string added;
  if (!text_.empty() && text_.back() != '\n') added += line_break_;
  if (!text_.empty()) added += line_break_;
  added += fmt::format("[{}]{}{} = {}{}", dotted(path.begin(), path.end() - 1), line_break_, path.back(),
                       value, line_break_);
  replace(text_.size(), text_.size(), added);
}

}  // namespace prosector
