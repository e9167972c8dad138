#pragma once
// Text styles of the set-up window's pages: headings, side notes and warnings.

#include <string>

namespace prosector {

/// Message of a set-up page, shown below the pages until another one replaces it.
struct Said {
  std::string words;
  bool wrong = false;  // an error message
};

void title(const std::string& words);
void wrapped(const std::string& words);
void quiet(const std::string& words);
void warning(const std::string& words);

}  // namespace prosector
