#pragma once
// Splits a typed line into words.

#include <string>
#include <utility>

namespace prosector {

/// Returns the text without leading and trailing blanks.
inline std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

/// Splits off the first word. Returns it and the rest, both trimmed.
inline std::pair<std::string, std::string> split_first(const std::string& line) {
  const std::string text = trimmed(line);
  const auto space = text.find(' ');
  return {text.substr(0, space), space == std::string::npos ? "" : trimmed(text.substr(space))};
}

/// Splits off the last word of a trimmed text. Returns the text before it and the word; a single word is
/// returned first.
inline std::pair<std::string, std::string> split_last(const std::string& text) {
  const auto at = text.find_last_of(' ');
  if (at == std::string::npos) return {text, ""};
  return {trimmed(text.substr(0, at)), text.substr(at + 1)};
}

}  // namespace prosector
