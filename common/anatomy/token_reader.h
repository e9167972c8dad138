#pragma once
// Tokenizer for text files, with line numbers for messages.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>

#include "common/error.h"

namespace prosector {

class TokenReader {
 public:
  /// Reads from `text`, the content of a file. Error messages begin with `name`, the file's name, and the
  /// line; if `name` is empty, with the line only.
  TokenReader(std::string_view text, std::string name) : text_(text), name_(std::move(name)) {}

  /// Returns the next word (up to white space) of the text, and moves past it; empty at the end of the text.
  std::string_view word() {
    while (at_ < text_.size() && is_space(text_[at_])) line_ += text_[at_++] == '\n';
    const std::size_t start = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return text_.substr(start, at_ - start);
  }
  /// Returns the rest of the current line without its line break, and moves past it.
  std::string_view rest() {
    const std::size_t start = at_;
    while (at_ < text_.size() && text_[at_] != '\n') ++at_;
    return text_.substr(start, at_ - start);
  }
  /// Returns the line after the current one, without its line break, and moves past it. Empty at the end of
  /// the text.
  std::string_view next_line() {
    end_line();
    const std::string_view line = rest();
    return !line.empty() && line.back() == '\r' ? line.substr(0, line.size() - 1) : line;
  }
  template <class T>
  T number(const char* what) {
    std::string_view w = word();
    if (w.size() > 1 && w[0] == '+' && w[1] != '-') w.remove_prefix(1);  // not accepted by from_chars
    T value{};
    const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
    if (w.empty()) fail(fmt::format("ends; expected: {}", what));
    if (error != std::errc{} || end != w.data() + w.size())
      fail(fmt::format("\"{}\" found; expected: {}", w.substr(0, 32), what));
    return value;
  }
  /// Moves past the rest of the current line, to the start of the next line of the text.
  void end_line() {
    rest();
    if (at_ == text_.size()) return;
    ++at_;
    ++line_;
  }
  /// Returns the next `count` bytes of the text, and moves past them. Throws InputError, naming `what`, if
  /// the text is shorter.
  std::string_view bytes(std::size_t count, const char* what) {
    if (left() < count)
      fail(fmt::format("truncated: {} need {} bytes, {} are left in the file", what, count, left()));
    const std::string_view out = text_.substr(at_, count);
    line_ += static_cast<std::size_t>(std::count(out.begin(), out.end(), '\n'));
    at_ += count;
    return out;
  }
  /// Returns `count` bytes from the start of the next line, and moves past them. Throws InputError, naming
  /// `what`, if the text is shorter.
  std::string_view raw(std::size_t count, const char* what) {
    end_line();
    return bytes(count, what);
  }
  /// Returns the number of bytes of the text that have not been read yet.
  std::size_t left() const { return text_.size() - at_; }
  /// Reads the number of records that follow, each at least `bytes` bytes long. Throws InputError, naming
  /// `what`, if the remaining text can't contain them, so that a false count can't cause a large allocation.
  std::uint64_t count(const char* what, std::size_t bytes = 2) {
    const auto n = number<std::uint64_t>(what);
    if (n > (text_.size() - at_) / bytes) fail(fmt::format("{} {} exceeds the file size", what, n));
    return n;
  }
  void expect(std::string_view wanted) {
    const std::string_view w = word();
    if (w != wanted) fail(fmt::format("\"{}\" found; expected: {}", w.substr(0, 32), wanted));
  }
  bool skip_to(std::string_view wanted) {
    for (std::string_view w = word(); !w.empty(); w = word())
      if (w == wanted) return true;
    return false;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(name_.empty() ? fmt::format("line {}: {}", line_, what)
                                   : fmt::format("{}:{}: {}", name_, line_, what));
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }

  std::string_view text_;
  std::string name_;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
};

}  // namespace prosector
