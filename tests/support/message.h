#pragma once
// What a refused call says.

#include <exception>
#include <functional>
#include <string>

namespace aomd::test {

/// The text of the exception that a call ends with; "" when it works.
inline std::string message(const std::function<void()>& call) {
  try {
    call();
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

}  // namespace aomd::test
