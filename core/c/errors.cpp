// Exceptions as statuses and one line of text.

#include <new>

#include "core/c/handles.h"
#include "core/io/error.h"
#include "core/model/model.h"

namespace aomd::c {
namespace {

std::string& last_error() {
  thread_local std::string text;
  return text;
}

aomd_status failed(aomd_status status, const std::exception& e) {
  set_last_error(e.what());
  return status;
}

}  // namespace

void set_last_error(const std::string& text) noexcept {
  try {
    last_error() = text;
  } catch (...) {
    last_error().clear();
  }
}

aomd_status status_of_exception() noexcept {
  try {
    throw;
  } catch (const io::WriteError& e) {
    return failed(AOMD_OUTPUT, e);
  } catch (const io::LimitError& e) {
    return failed(AOMD_LIMIT, e);
  } catch (const io::FileError& e) {
    return failed(AOMD_INPUT, e);
  } catch (const ModelError& e) {
    return failed(AOMD_INPUT, e);
  } catch (const Cancelled& e) {
    return failed(AOMD_CANCELLED, e);
  } catch (const BadArgument& e) {
    return failed(AOMD_USAGE, e);
  } catch (const std::bad_alloc&) {
    set_last_error("out of memory");
    return AOMD_LIMIT;
  } catch (const std::logic_error& e) {  // what the database refuses
    return failed(AOMD_USAGE, e);
  } catch (const std::exception& e) {
    return failed(AOMD_FAULT, e);
  } catch (...) {
    set_last_error("an exception of unknown kind");
    return AOMD_FAULT;
  }
}

void check_dimension(int dimension, int lowest) {
  if (dimension < lowest || dimension > 3)
    throw BadArgument("a dimension is " + std::to_string(lowest) + " to 3, not " +
                      std::to_string(dimension));
}

}  // namespace aomd::c

const char* aomd_last_error() { return aomd::c::last_error().c_str(); }
int aomd_version_number() { return AOMD_VERSION_NUMBER; }
