#include "viewer/commands/tables.h"

#include <array>
#include <initializer_list>

#include "core/mesh/derive.h"
#include "core/mesh/names.h"
#include "core/operators/verdict.h"
#include "viewer/base/text.h"
#include "viewer/commands/arguments.h"
#include "viewer/document/adjacency.h"
#include "viewer/explain/id_facts.h"

namespace aomd::scene {
namespace {

void add_row(std::string& text, std::initializer_list<std::string> cells) {
  bool first = true;
  for (const std::string& cell : cells) {
    if (!first) text += '\t';
    text += cell;
    first = false;
  }
  text += '\n';
}

std::string plain(std::int64_t n) { return std::to_string(n); }

std::string counts(const Session& session) {
  const MeshFacts& now = session.sheet().facts();
  const MeshFacts& then = session.sheet().loaded_facts();
  std::string text;
  add_row(text, {"Count", "Now", "As loaded"});
  const auto row = [&](const char* name, std::int64_t after, std::int64_t before) {
    add_row(text, {name, plain(after), plain(before)});
  };
  row("Vertices", now.vertices, then.vertices);
  row("Unused vertices", now.unused, then.unused);
  row("Edges", now.edges, then.edges);
  row("Faces", now.faces, then.faces);
  if (now.regions > 0) {
    row("Regions", now.regions, then.regions);
    row("Outer faces", now.outer_faces, then.outer_faces);
  } else {
    row("Boundary edges", now.boundary, then.boundary);
    row("Non-manifold edges", now.nonmanifold, then.nonmanifold);
    row("Euler number", now.euler(), then.euler());
  }
  const Mesh& mesh = session.document().mesh();
  const auto bytes = [&](const char* name, std::size_t n) {
    add_row(text, {name, std::to_string(n), ""});
  };
  bytes("Mesh, bytes", mesh.entity_bytes());
  bytes("Adjacency, bytes", mesh.adjacency_bytes());
  bytes("History, bytes", session.document().journal().bytes());
  return text;
}

std::string legend(const Session& session) {
  const Mesh& mesh = session.document().mesh();
  std::string text;
  add_row(text, {"Model entity", "Mesh entities", "Hidden"});
  for (const int dim : {3, 2, 1, 0})
    for (const ModelRef ref : mesh.class_lists()->models(dim)) {
      if (ref.dimension() != dim && ref.valid()) continue;
      if (!ref.valid() && dim < 2) continue;
      const std::string name =
          ref.valid() ? model_entity_text(ref) : std::string("unclassified ") + entity_plural(dim);
      add_row(text, {name, std::to_string(mesh.class_lists()->entities(dim, ref).size()),
                     session.view.hidden.contains(ref) ? "yes" : "no"});
    }
  return text;
}

std::string adjacency(const Session& session) {
  const Mesh& mesh = session.document().mesh();
  std::string text;
  add_row(text, {"Relation", "Stored", "Set", "Requests", "Bytes", "Mean row", "Rows", "Asked by",
                 "Path"});
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      if (i == j) continue;
      const AdjacencyCell cell = adjacency_cell(mesh, i, j);
      add_row(text, {relation_name(i, j), cell.stored ? "yes" : "no", cell.set ? "yes" : "no",
                     plain(cell.requests), std::to_string(cell.stored ? cell.bytes : 0),
                     cell.stored ? short_number(mean_row_length(mesh, i, j)) : "",
                     cell.stored ? plain(mesh.count(i)) : "", askers(mesh, i, j),
                     explain(mesh, i, j).text()});
    }
  return text;
}

std::string hashes(const Session& session) {
  std::string text = "Level\tBuilt\tEntities\tBuckets\tUsed\tCrowded\tWorst\tBytes\tGrowths";
  for (std::size_t length = 0; length < HashFacts::bars; ++length)
    text += "\tBuckets of " + std::to_string(length) +
            (length + 1 == HashFacts::bars ? " and more" : "");
  text += '\n';
  for (int level = 1; level < 4; ++level) {
    const HashFacts facts = hash_facts(session.document().mesh(), level);
    const EntityHash::Statistics& s = facts.statistics;
    text += std::string(entity_plural(level)) + "\t" + (facts.built ? "yes" : "no");
    for (const std::uint64_t n :
         {facts.entities, std::uint64_t{s.buckets}, std::uint64_t{s.used}, std::uint64_t{s.crowded},
          std::uint64_t{s.worst}, std::uint64_t{facts.bytes}, std::uint64_t{s.rehashes}})
      text += '\t' + std::to_string(n);
    for (const std::uint32_t n : facts.buckets) text += '\t' + std::to_string(n);
    text += '\n';
  }
  return text;
}

std::string ids(const Session& session) {
  std::string text;
  add_row(text, {"Level", "Alive", "Free", "Capacity", "Next", "Top of the stack"});
  for (int level = 0; level < 4; ++level) {
    const IdFacts facts = id_facts(session.document().mesh(), level);
    std::string top;
    for (const std::uint32_t id : facts.top) top += (top.empty() ? "" : " ") + std::to_string(id);
    add_row(text, {entity_plural(level), plain(facts.alive), plain(facts.free),
                   plain(facts.capacity), plain(facts.next), top});
  }
  return text;
}

std::string strategies(const Session& session) {
  return storage_table(session.sheet().storage() ? *session.sheet().storage()
                                                 : StorageComparison());
}

std::string refusals(const Session& session) {
  std::string text;
  add_row(text, {"Reason", "Edges left by the last sweep"});
  const SweepStatistics* sweep = session.document().last_sweep();
  if (sweep == nullptr) return text;
  for (std::size_t r = 1; r < reason_count; ++r)
    add_row(text, {reason_name(static_cast<Reason>(r)), plain(sweep->refused[r])});
  return text;
}

std::string sweeps(const Session& session) {
  const bool volume = session.sheet().loaded_facts().regions > 0;
  std::string text =
      std::string("Sweep\tCollapses\tSwaps\tSmooths\t") + (volume ? "Regions" : "Faces");
  for (std::size_t r = 1; r < reason_count; ++r)
    text += std::string("\t") + reason_name(static_cast<Reason>(r));
  text += '\n';
  const Decimation* decimation = session.document().decimation();
  if (decimation == nullptr) return text;
  std::size_t number = 0;
  for (const SweepStatistics& s : decimation->sweeps()) {
    text += std::to_string(++number) + '\t' + plain(s.collapses) + '\t' + plain(s.swaps) + '\t' +
            plain(s.smooths) + '\t' + plain(volume ? s.regions : s.faces);
    for (std::size_t r = 1; r < reason_count; ++r) text += '\t' + plain(s.refused[r]);
    text += '\n';
  }
  return text;
}

std::string runs(const Session& session) {
  return runs_table(session.sheet().runs, session.sheet().loaded_facts().regions > 0);
}

/// As `select` takes them.
std::string selection(const Session& session) {
  std::string text;
  for (const EntityRef e : session.sheet().selection.entities())
    text += std::string(entity_name(e.dimension)) + " " + std::to_string(e.index) + "\n";
  return text;
}

struct Table {
  std::string_view name;
  std::string (*text)(const Session&);
};

constexpr std::array<Table, 10> tables = {{{"counts", counts},
                                           {"legend", legend},
                                           {"adjacency", adjacency},
                                           {"hashes", hashes},
                                           {"ids", ids},
                                           {"strategies", strategies},
                                           {"refusals", refusals},
                                           {"sweeps", sweeps},
                                           {"runs", runs},
                                           {"selection", selection}}};

}  // namespace

std::span<const std::string_view> table_names() {
  static const auto names = [] {
    std::array<std::string_view, tables.size()> all;
    for (std::size_t i = 0; i < tables.size(); ++i) all[i] = tables[i].name;
    return all;
  }();
  return names;
}

std::string table_text(const Session& session, std::string_view table) {
  for (const Table& each : tables)
    if (each.name == table) return each.text(session);
  return {};
}

}  // namespace aomd::scene
