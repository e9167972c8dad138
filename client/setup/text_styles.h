#pragma once
// Text styles of the set-up window's pages: headings, side notes and warnings.

#include <string>

namespace prosector {

/// A page's message, shown until it is replaced.
struct Said {
  std::string words;
  bool wrong = false;  // an error message
};

void title(const std::string& words);
void wrapped(const std::string& words);
void quiet(const std::string& words);
void warning(const std::string& words);

}  // namespace prosector
