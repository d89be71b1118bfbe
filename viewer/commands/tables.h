#pragma once
// The tables that panels show as text to paste elsewhere: a line of titles, then one line a row,
// columns separated by tabs. Numbers are plain ("69451"), so that a spreadsheet takes them.

#include <span>
#include <string>
#include <string_view>

#include "viewer/session/session.h"

namespace aomd::scene {

/// "counts", "legend", "adjacency", "hashes", "ids", "strategies", "refusals", "sweeps".
[[nodiscard]] std::span<const std::string_view> table_names();

/// One of them for the present mesh, which must be there; the session must be refreshed. Titles
/// alone where there is nothing to list yet. O(rows); adjacency O(entities).
[[nodiscard]] std::string table_text(const Session& session, std::string_view table);

}  // namespace aomd::scene
