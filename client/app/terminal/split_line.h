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

/// Splits off the first word of a line. Returns this word and the rest of the line, both without surrounding
/// blanks.
inline std::pair<std::string, std::string> split_first(const std::string& line) {
  const std::string text = trimmed(line);
  const auto space = text.find(' ');
  return {text.substr(0, space), space == std::string::npos ? "" : trimmed(text.substr(space))};
}

/// Splits off the last word of a text without surrounding blanks. Returns the text before the word, and the
/// word. If there is only one word, returns it first and an empty string second.
inline std::pair<std::string, std::string> split_last(const std::string& text) {
  const auto at = text.find_last_of(' ');
  if (at == std::string::npos) return {text, ""};
  return {trimmed(text.substr(0, at)), text.substr(at + 1)};
}

}  // namespace prosector
