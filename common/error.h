#pragma once
// Exceptions: InputError for bad input, InternalError for errors in the program itself.

#include <stdexcept>
#include <string>

namespace prosector {

/// Exception for an error in input from a user or a file. Its `what()` names the error, its position (file,
/// line, field) and the allowed values. It is thrown only while loading or starting; a running session counts
/// and reports bad input instead.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Exception for an error in the program: an internal assumption is violated, whatever the input was. Its
/// `what()` describes it for developers. It never steers control flow, and no handler of InputError catches
/// it.
class InternalError : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace prosector
