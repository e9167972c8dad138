#include "common/toml_nesting.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/error.h"

namespace prosector {
namespace {

/// Single pass over the text that skips strings and comments.
class NestingScan {
 public:
  NestingScan(std::string_view text, const std::string& file) : text_(text), file_(file) {}

  void run() {
    constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
    if (text_.starts_with(byte_order_mark)) at_ = byte_order_mark.size();
    while (at_ < text_.size()) step();
  }

 private:
  void step() {
    switch (const char c = text_[at_]) {
      case '"':
      case '\'':
        return skip_string(c);
      case '#':
        at_ = std::min(text_.find('\n', at_), text_.size());
        return;
      case '[':
      case '{':
        if (c == '[' && begins_line()) check_header();
        dots_ = 0;
        limit(++brackets_, "lists and tables are nested too deeply");
        break;
      case ']':
      case '}':
        dots_ = 0;
        if (brackets_ > 0) --brackets_;
        break;
      case '.':
        limit(++dots_ + 1, "a dotted key has too many parts");
        break;
      case '\n':
        ++line_;
        dots_ = 0;
        break;
      case '=':
      case ',':
        dots_ = 0;
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x80)
          throw InputError(
              fmt::format("{}:{}: non-ASCII text must be in quotes or in a comment", file_, line_));
        break;
    }
    ++at_;
  }

  /// Skips a string. A single-line string ends at the end of its line at the latest, a triple-quoted one at
  /// the end of the text.
  void skip_string(char quote) {
    const std::string three(3, quote);
    const bool multiline = text_.substr(at_, 3) == three;
    at_ += multiline ? 3 : 1;
    while (at_ < text_.size()) {
      if (multiline ? text_.substr(at_, 3) == three : text_[at_] == quote) {
        at_ += multiline ? 3 : 1;
        return;
      }
      if (text_[at_] == '\n') {
        if (!multiline) return;
        ++line_;
      }
      at_ += quote == '"' && text_[at_] == '\\' && at_ + 1 < text_.size() && text_[at_ + 1] != '\n' ? 2 : 1;
    }
  }

  /// Returns whether only blanks precede the current position in its line, outside all brackets.
  bool begins_line() const {
    if (brackets_ > 0) return false;
    const std::size_t before = at_ == 0 ? std::string_view::npos : text_.find_last_not_of(" \t", at_ - 1);
    return before == std::string_view::npos || text_[before] == '\n' || text_[before] == '\r';
  }

  /// Checks that a table header begins with a name, which toml++ assumes after the bracket.
  void check_header() const {
    std::size_t name = at_ + 1;
    const bool is_doubled = name < text_.size() && text_[name] == '[';
    if (is_doubled) ++name;
    name = text_.find_first_not_of(" \t", name);
    if (name == std::string_view::npos) return;  // the parser reports it
    const char c = text_[name];
    const bool is_bare =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
    if (!is_bare && c != '"' && c != '\'' && c != ']' && (is_doubled || c != '['))
      throw InputError(
          fmt::format("{}:{}: the name of a table must follow the opening bracket", file_, line_));
  }

  void limit(int levels, const char* what) const {
    if (levels > max_toml_nesting)
      throw InputError(fmt::format("{}:{}: {}; allowed: at most {}", file_, line_, what, max_toml_nesting));
  }

  std::string_view text_;
  const std::string& file_;
  std::size_t at_ = 0;
  int line_ = 1;
  int brackets_ = 0;  // open brackets
  int dots_ = 0;      // of the current key
};

}  // namespace

void check_nesting(std::string_view toml, const std::string& file) {
  NestingScan(toml, file).run();
}

}  // namespace prosector
