#include "viewer/suite/suite.h"

#include <algorithm>
#include <array>

#include "core/io/error.h"
#include "core/io/source.h"
#include "viewer/base/text.h"
#include "viewer/suite/key_table.h"

namespace aomd::suite {
namespace {

namespace fs = std::filesystem;

toml::table parsed(const fs::path& file) {
  const std::string text = io::detail::read_whole(file);
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    throw io::ReadError(file.string(), {.line = error.source().begin.line},
                        std::string(error.description()));
  }
}

const toml::table& table_of(std::string_view key, const toml::node& node) {
  if (!node.is_table()) throw WrongEntry(node, "'" + std::string(key) + "' is a table");
  return *node.as_table();
}

/// A text alone is a mesh, or a script where it is named so.
void apply_entry(const toml::node& entry, Case& into) {
  if (!entry.is_string()) {
    if (!entry.is_table())
      throw WrongEntry(entry, "a case is a file or a table, such as { mesh = \"part.ply\" }");
    return apply_keys(*entry.as_table(), into);
  }
  const std::string file = text_of(into.name, entry);
  (fs::path(file).extension() == ".aomd" ? into.script : into.mesh) = file;
}

class Reader {
 public:
  explicit Reader(const fs::path& file) {
    suite_.file = file;
    folder_ = fs::absolute(file).parent_path();
    suite_.baselines = folder_ / "baselines";
  }

  Suite read() {
    const toml::table table = parsed(suite_.file);
    try {
      take(table);
    } catch (const WrongEntry& error) {
      throw io::ReadError(suite_.file.string(), {.line = static_cast<std::uint64_t>(error.line)},
                          error.what());
    }
    return std::move(suite_);
  }

 private:
  void take(const toml::table& table) {
    refuse_unknown(table, std::array<std::string_view, 3>{"baselines", "defaults", "cases"});
    if (const toml::node* node = table.get("baselines"))
      suite_.baselines = folder_ / text_of("baselines", *node);
    if (const toml::node* node = table.get("defaults"))
      apply_keys(table_of("defaults", *node), defaults_);
    const toml::node* cases = table.get("cases");
    if (cases == nullptr || table_of("cases", *cases).empty())
      throw WrongEntry(cases != nullptr ? *cases : table, "there are no cases: [cases] lists them");
    for (const auto& [name, entry] : *cases->as_table())
      suite_.cases.push_back(read_case(std::string(name.str()), entry));
    sort_by_place(*cases->as_table());
  }
  Case read_case(std::string name, const toml::node& entry) {
    Case each = defaults_;
    each.name = std::move(name);
    each.line = static_cast<int>(entry.source().begin.line);
    try {
      apply_entry(entry, each);
      check_case(entry, each);
    } catch (const WrongEntry& error) {
      each.problem = error.what();
      each.line = error.line;
    }
    each.folder = folder_ / each.folder;
    return each;
  }
  /// TOML's tables are sorted by name.
  void sort_by_place(const toml::table& cases) {
    const auto column = [&](const Case& each) {
      return cases.get(each.name)->source().begin.column;
    };
    std::sort(suite_.cases.begin(), suite_.cases.end(), [&](const Case& a, const Case& b) {
      return std::pair(a.line, column(a)) < std::pair(b.line, column(b));
    });
  }

  fs::path folder_;
  Suite suite_;
  Case defaults_;
};

}  // namespace

Suite read_suite(const fs::path& file) { return Reader(file).read(); }

}  // namespace aomd::suite
