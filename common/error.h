#pragma once
// What goes wrong: with input, said so that its author can mend it, and with the program itself.

#include <stdexcept>
#include <string>

namespace prosector {

/// Bad input from a person or a file: `what()` names what is wrong, where (file, line, field), and what is
/// allowed. Thrown only while loading or starting; a running session counts and reports instead.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A fault of the program: something that it relies on isn't so, whatever the input was. `what()` says what,
/// for who maintains it. It never steers control flow, and no handler of InputError catches it.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace prosector
