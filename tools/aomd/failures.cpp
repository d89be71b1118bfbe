#include "tools/aomd/failures.h"

#include <exception>
#include <new>

#include "core/io/error.h"
#include "core/model/model.h"
#include "tools/aomd/signals.h"

namespace aomd::cli {
namespace {

struct Failure {
  std::string words;
  int code;
};

/// Of the exception that is being handled.
Failure present_failure() {
  try {
    throw;
  } catch (const io::ReadError& e) {
    return {e.what(), bad_input};
  } catch (const ModelError& e) {
    return {e.what(), bad_input};
  } catch (const io::WriteError& e) {
    return {e.what(), not_written};
  } catch (const io::LimitError& e) {
    return {e.what(), out_of_limits};
  } catch (const UsageError& e) {
    return {e.what(), wrong_usage};
  } catch (const NothingToDo& e) {
    return {e.what(), says_no};
  } catch (const InternalFault& e) {
    return {e.what(), internal_fault};
  } catch (const std::bad_alloc&) {
    return {"out of memory", out_of_limits};
  } catch (const std::exception& e) {
    return {fault_words(e.what()), internal_fault};
  } catch (...) {
    return {fault_words("an exception of unknown kind"), internal_fault};
  }
}

}  // namespace

int run_caught(const Action& action,
               const std::function<void(const std::string& words, int code)>& tell) {
  try {
    return action();
  } catch (...) {
    const Failure failure = present_failure();
    tell(failure.words, failure.code);
    return failure.code;
  }
}

}  // namespace aomd::cli
