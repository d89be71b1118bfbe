#pragma once
// Unsaved work of a program that is gone.

#include <filesystem>
#include <initializer_list>
#include <string_view>

#include "tests/support/session_helpers.h"

namespace aomd::scene::test {

/// A program that did some work and died: its session is gone, its files are there.
inline void work_and_die(const std::filesystem::path& folder,
                         std::initializer_list<std::string_view> lines) {
  Session s;
  s.keep_work(folder);
  drive(s, lines);
  s.recovery->write_now(s.document());
}

}  // namespace aomd::scene::test
