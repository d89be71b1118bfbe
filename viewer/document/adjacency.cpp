#include "viewer/document/adjacency.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/mesh/derive.h"
#include "core/mesh/names.h"
#include "viewer/base/text.h"

namespace aomd::scene {
namespace {

std::string one(int dim) { return entity_name(dim); }
std::string many(int dim) { return entity_plural(dim); }

/// "1 request holds it", "2 requests hold it"
std::string held_by(int requests) {
  return std::to_string(requests) + (requests == 1 ? " request holds it" : " requests hold it");
}

/// Higher entities may have sides that the level does not hold.
bool lacks_some(const Mesh& mesh, int level) {
  std::uint32_t higher = 0;
  for (int dim = level + 1; dim <= 3; ++dim) higher += mesh.count(dim);
  return level > 0 && higher > 0 && !mesh.complete(level);
}

/// How many lower entities of dimension `low` all entities of dimension `high` have together.
std::uint64_t uses(const Mesh& mesh, int high, int low) {
  std::array<std::uint64_t, max_shapes> count{};
  for (std::uint32_t id = 0; id < mesh.capacity(high); ++id)
    if (mesh.alive({high, id})) ++count[static_cast<std::size_t>(mesh.shape({high, id}))];
  std::uint64_t sum = 0;
  for (std::size_t s = 0; s < shape_count(); ++s)
    sum += count[s] * static_cast<std::uint64_t>(shape_template(static_cast<Shape>(s)).count(low));
  return sum;
}

std::string storage_words(const Mesh& mesh, int i, int j, bool times) {
  const Representation::Record& record = mesh.representation().record(i, j);
  std::string text = "Stored: " + bytes_text(mesh.representation().bytes(i, j)) + ", " +
                     grouped(mesh.count(i)) + " rows of " +
                     short_number(mean_row_length(mesh, i, j), 1) + " on average";
  if (times && record.builds > 0)
    text += ", built in " + short_number(record.build_ms, record.build_ms < 10 ? 1 : 0) + " ms";
  return text + ".";
}

std::string demand_words(const Mesh& mesh, int i, int j) {
  const std::string by = askers(mesh, i, j);
  return by.empty() ? "Nobody asked for it." : "Held by: " + by + ".";
}

/// What became of it before. Empty where it was never freed.
std::string past_words(const Representation::Record& record) {
  if (record.frees == 0) return {};
  const std::string times = record.frees == 1 ? "once" : std::to_string(record.frees) + " times";
  return " Freed " + times + ", last of " + bytes_text(record.freed_bytes) + ".";
}

std::string cost_words(const AdjacencyPath& path) {
  return "about " + short_number(path.cost, 0) + " ids read for each answer" +
         (path.by_hash ? ", a look into the hash set counting as 8" : "");
}

std::string defining_words(int i, int j) {
  std::string others;
  for (int k = 0; k < i; ++k)
    if (k != j) others += (others.empty() ? "" : " or ") + relation_name(i, k);
  return "It defines the " + many(i) +
         (others.empty() ? ": it stays while there are any."
                         : ": it stays until " + others + " is stored.");
}

}  // namespace

AdjacencyCell adjacency_cell(const Mesh& mesh, int i, int j) {
  AdjacencyCell cell;
  const Representation& representation = mesh.representation();
  cell.stored = mesh.stored(i, j);
  cell.set = representation.demand(i, j).user;
  cell.requests = representation.demand(i, j).requests;
  cell.bytes = representation.bytes(i, j);
  cell.defines = cell.stored && i > j && mesh.count(i) > 0;
  for (int k = 0; k < i; ++k) cell.defines = cell.defines && (k == j || !mesh.stored(i, k));
  return cell;
}

double mean_row_length(const Mesh& mesh, int i, int j) {
  const auto entries = static_cast<double>(i > j ? uses(mesh, i, j) : uses(mesh, j, i));
  return mesh.count(i) == 0 ? 0 : entries / mesh.count(i);
}

std::string relation_words(int i, int j) {
  if (i < j) return "The " + many(j) + " around each " + one(i) + ", sorted";
  std::string words = "The " + many(j) + " of each " + one(i) + ", in template order";
  if (j > 0 && j == i - 1) words += ", with the direction of each use";
  return words;
}

std::string adjacency_words(const Mesh& mesh, int i, int j, bool times) {
  const AdjacencyCell cell = adjacency_cell(mesh, i, j);
  std::string text = relation_name(i, j) + ": " + relation_words(i, j) + ".\n";
  if (!cell.stored) {
    const AdjacencyPath path = explain(mesh, i, j);
    text += path.kind == AdjacencyPath::Kind::None
                ? "Not stored."
                : "Not stored, but derived: " + path.text() + ", " + cost_words(path) + ".";
    text += past_words(mesh.representation().record(i, j));
    for (const int level : {std::min(i, j), std::max(i, j)})
      if (lacks_some(mesh, level)) text += " Storing it creates the missing " + many(level) + ".";
    return text;
  }
  text += storage_words(mesh, i, j, times) + "\n" + demand_words(mesh, i, j);
  if (cell.defines) text += " " + defining_words(i, j);
  return text + past_words(mesh.representation().record(i, j));
}

std::string askers(const Mesh& mesh, int i, int j) {
  const Representation::Demand& demand = mesh.representation().demand(i, j);
  std::vector<std::pair<std::string, int>> names;
  if (demand.user) names.emplace_back("you or its source", 1);
  for (const char* by : demand.by) {
    const auto same =
        std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == by; });
    same == names.end() ? static_cast<void>(names.emplace_back(by, 1))
                        : static_cast<void>(++same->second);
  }
  std::string text;
  for (const auto& [name, count] : names)
    text +=
        (text.empty() ? "" : ", ") + name + (count > 1 ? " (" + std::to_string(count) + ")" : "");
  return text;
}

AdjacencyChange change_adjacency(Mesh& mesh, int i, int j, bool on) {
  using Clock = std::chrono::steady_clock;
  AdjacencyChange change{i, j, on, 0, {}};
  const auto before = Clock::now();
  try {
    on ? mesh.set(i, j) : mesh.unset(i, j);
  } catch (const std::logic_error& refused) {
    change.refusal = refused.what();
  }
  change.ms = std::chrono::duration<double, std::milli>(Clock::now() - before).count();
  return change;
}

std::string change_words(const Mesh& mesh, const AdjacencyChange& change) {
  if (!change.refusal.empty()) return change.refusal;
  const AdjacencyCell cell = adjacency_cell(mesh, change.i, change.j);
  const std::string name = relation_name(change.i, change.j);
  if (change.on) return name + " is stored: " + bytes_text(cell.bytes);
  if (!cell.stored) return name + " is freed";
  return name + " is no longer set, but " + held_by(cell.requests);
}

}  // namespace aomd::scene
