#pragma once
// Words of a line that somebody typed.

#include <string>
#include <utility>

namespace prosector {

/// Returns the text without blanks at its ends.
inline std::string trimmed(const std::string& text) {
  const auto begin = text.find_first_not_of(" \t\r"), end = text.find_last_not_of(" \t\r");
  return begin == std::string::npos ? "" : text.substr(begin, end - begin + 1);
}

/// Splits off the first word; both are trimmed.
inline std::pair<std::string, std::string> split_first(const std::string& line) {
  const std::string text = trimmed(line);
  const auto space = text.find(' ');
  return {text.substr(0, space), space == std::string::npos ? "" : trimmed(text.substr(space))};
}

/// Splits off the last word of a trimmed text; of a single word that word is the first.
inline std::pair<std::string, std::string> split_last(const std::string& text) {
  const auto at = text.find_last_of(' ');
  if (at == std::string::npos) return {text, ""};
  return {trimmed(text.substr(0, at)), text.substr(at + 1)};
}

}  // namespace prosector
