#pragma once
// What goes wrong with input, said so that its author can mend it.

#include <stdexcept>
#include <string>

namespace prosector {

/// Bad input from a person or a file: `what()` names what is wrong, where (file, line, field), and what is
/// allowed. Thrown only while loading or starting; a running session counts and reports instead.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace prosector
