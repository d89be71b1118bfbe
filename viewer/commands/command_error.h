#pragma once
// What is wrong in a line.

#include <stdexcept>

namespace aomd::scene {

/// A command that cannot be carried out as it was given; what() says why and what would be right.
class CommandError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// `expect` found something else.
class ExpectationMissed : public CommandError {
 public:
  using CommandError::CommandError;
};

}  // namespace aomd::scene
