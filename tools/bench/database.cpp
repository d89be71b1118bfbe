// aomd-bench MESH...: what the database costs. Prints three tables for each mesh, in Markdown:
// bytes an element under several settings of T, building each relation beside a loop that only
// moves the same bytes, and nanoseconds a query, stored and derived by each path. Times are
// medians; compare them within one run only.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <numeric>
#include <utility>

#include "core/io/io.h"
#include "core/mesh/derive.h"
#include "core/mesh/names.h"
#include "core/samples/samples.h"

namespace aomd {
namespace {

using Cells = std::vector<std::pair<int, int>>;

constexpr int runs = 7;

double milliseconds(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
      .count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

std::string names(const Cells& cells) {
  std::string text;
  for (const auto& [i, j] : cells) text += (text.empty() ? "" : " ") + relation_name(i, j);
  return text;
}

Mesh with(const MeshData& data, const Cells& cells) {
  Mesh mesh(data);
  for (const auto& [i, j] : cells) mesh.set(i, j);
  for (int i = 1; i < 4; ++i)  // what the file came with and the setting does not ask for
    for (int j = 0; j < i; ++j)
      if (mesh.stored(i, j) &&
          std::find(cells.begin(), cells.end(), std::pair{i, j}) == cells.end())
        try {
          mesh.unset(i, j);
        } catch (const std::logic_error&) {  // it defines its level
        }
  return mesh;
}

// Memory
// ------------------------------------------------------------------------------------------------

void print_memory(const MeshData& data, int dim) {
  const std::vector<std::pair<const char*, Cells>> surface = {
      {"reduced: faces by vertices", {{2, 0}}},
      {"one level, downward", {{1, 0}, {2, 1}}},
      {"circular", {{1, 0}, {2, 1}, {0, 1}, {1, 2}}},
      {"decimation, keep all", {{2, 0}, {0, 1}, {2, 1}, {1, 2}, {0, 2}}},
      {"decimation, collapses only", {{2, 0}, {1, 2}, {2, 1}, {0, 2}}},
      {"all of T", {{1, 0}, {2, 0}, {2, 1}, {0, 1}, {0, 2}, {1, 2}}}};
  const std::vector<std::pair<const char*, Cells>> volume = {
      {"reduced: regions by vertices", {{3, 0}}},
      {"reduced, with regions at vertices", {{3, 0}, {0, 3}}},
      {"one level, downward", {{1, 0}, {2, 1}, {3, 2}}},
      {"full one-level", {{1, 0}, {2, 1}, {3, 2}, {0, 1}, {1, 2}, {2, 3}}},
      {"regions by faces, faces by vertices", {{2, 0}, {3, 2}, {2, 3}}},
      {"collapses", {{3, 0}, {1, 0}, {0, 1}, {0, 3}}},
      {"all of T",
       {{1, 0},
        {2, 0},
        {2, 1},
        {3, 0},
        {3, 1},
        {3, 2},
        {0, 1},
        {0, 2},
        {0, 3},
        {1, 2},
        {1, 3},
        {2, 3}}}};
  std::printf(
      "| setting | T | bytes a %s | of it adjacency | of it the rest |\n|---|---|---:|---:|---:|\n",
      entity_name(dim));
  for (const auto& [label, cells] : dim == 3 ? volume : surface) {
    const Mesh mesh = with(data, cells);
    const double n = mesh.count(dim);
    const double adjacency = static_cast<double>(mesh.adjacency_bytes()) / n;
    const double rest = static_cast<double>(mesh.entity_bytes()) / n;
    std::printf("| %s | %s | %.1f | %.1f | %.1f |\n", label, names(cells).c_str(), adjacency + rest,
                adjacency, rest);
  }
}

// Building
// ------------------------------------------------------------------------------------------------

// Reads what defines the relation and writes as many bytes as it takes: fresh memory on both runs.
double plain_loop(const std::vector<std::uint32_t>& source, std::size_t bytes) {
  std::unique_ptr<std::uint32_t[]> target;
  const std::size_t words = bytes / 4;
  const double ms = milliseconds([&] {
    target = std::make_unique_for_overwrite<std::uint32_t[]>(words);
    std::uint32_t sum = 0;
    for (const std::uint32_t v : source) sum += v;
    for (std::size_t k = 0; k < words; ++k) target[k] = sum + static_cast<std::uint32_t>(k);
  });
  volatile std::uint32_t keep = target[words / 2];
  (void)keep;
  return ms;
}

std::vector<std::uint32_t> source_of(const Mesh& mesh, int i, int j) {
  std::vector<std::uint32_t> source;
  const auto read = [&](int level) {
    VertexBuffer buffer;
    for (std::uint32_t id = 0; id < mesh.capacity(level); ++id)
      for (const std::uint32_t v : mesh.vertices_of(EntityRef(level, id), buffer))
        source.push_back(v);
  };
  read(std::max(i, j));
  if (std::min(i, j) > 0) read(std::min(i, j));
  return source;
}

void print_building(const MeshData& data, const Cells& cells) {
  std::printf(
      "| relation | pairs | ms | Mpairs/s | plain loop ms | ratio "
      "|\n|---|---:|---:|---:|---:|---:|\n");
  for (const auto& [i, j] : cells) {
    Mesh mesh(data);
    if (std::min(i, j) > 0 || i == 1 || j == 1) mesh.set(1, 0);
    if (std::max(i, j) == 3 && std::min(i, j) == 2) mesh.set(2, 0);
    if (i < j && i > 0) mesh.set(j, i);
    std::vector<double> ours, plain;
    const std::vector<std::uint32_t> source = source_of(mesh, i, j);
    for (int run = 0; run < runs; ++run) {
      ours.push_back(milliseconds([&, a = i, b = j] { mesh.set(a, b); }));
      plain.push_back(plain_loop(source, mesh.representation().bytes(i, j)));
      if (run + 1 < runs) mesh.unset(i, j);
    }
    double pairs = 0;
    if (i < j)
      pairs = static_cast<double>(mesh.representation().up(i, j).entries());
    else
      for (std::uint32_t id = 0; id < mesh.capacity(i); ++id)
        pairs += shape_template(mesh.shape(EntityRef(i, id))).count(j);
    std::printf("| %s | %.0f | %.2f | %.0f | %.2f | %.1f |\n", relation_name(i, j).c_str(), pairs,
                median(ours), pairs / median(ours) / 1e3, median(plain),
                median(ours) / median(plain));
  }
}

// Queries
// ------------------------------------------------------------------------------------------------

void print_query(const Mesh& mesh, int i, int j, const std::string& stored) {
  const AdjacencyPath path = explain(mesh, i, j);
  if (path.kind == AdjacencyPath::Kind::None) return;
  const std::uint32_t n = std::min(mesh.count(i), 20000u), step = std::max(1u, mesh.count(i) / n);
  std::vector<std::uint32_t> result;
  std::vector<double> times;
  std::size_t read = 0;
  times.reserve(static_cast<std::size_t>(runs));
  for (int run = 0; run < runs; ++run)
    times.push_back(milliseconds([&] {
      for (std::uint32_t k = 0; k < n; ++k) {
        adjacent(mesh, EntityRef(i, k * step), j, result);
        read += result.size();
      }
    }));
  std::printf("| %s | %s | %s | %.1f | %.0f |\n", relation_name(i, j).c_str(), path.text().c_str(),
              stored.c_str(), static_cast<double>(read) / runs / n, median(times) * 1e6 / n);
}

void print_queries(const MeshData& data, int dim) {
  std::printf("| relation | path | stored | answers | ns a query |\n|---|---|---|---:|---:|\n");
  const std::vector<Cells> surface = {{{1, 0}, {2, 0}, {2, 1}, {0, 1}, {0, 2}, {1, 2}},
                                      {{1, 0}, {2, 1}, {0, 1}, {1, 2}},
                                      {{1, 0}, {2, 0}, {0, 2}},
                                      {{2, 0}, {1, 0}}};
  const std::vector<Cells> volume = {{{1, 0},
                                      {2, 0},
                                      {2, 1},
                                      {3, 0},
                                      {3, 1},
                                      {3, 2},
                                      {0, 1},
                                      {0, 2},
                                      {0, 3},
                                      {1, 2},
                                      {1, 3},
                                      {2, 3}},
                                     {{1, 0}, {2, 1}, {3, 2}, {0, 1}, {1, 2}, {2, 3}},
                                     {{1, 0}, {2, 0}, {3, 0}, {0, 3}},
                                     {{1, 0}, {2, 0}, {3, 0}}};
  const auto& sets = dim == 3 ? volume : surface;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const Mesh mesh = with(data, sets[s]);
    for (int i = 0; i <= dim; ++i)
      for (int j = 0; j <= dim; ++j)
        if (i != j && (s == 0 || !mesh.stored(i, j)))
          print_query(mesh, i, j, s == 0 ? "all" : names(sets[s]));
  }
}

MeshData load(const std::string& argument) {
  if (argument.find('.') != std::string::npos) return io::read(argument).mesh;
  return make_sample(argument, 0);
}

void report(const std::string& argument) {
  const MeshData data = load(argument);
  const int dim = Mesh(data).dimension();
  std::printf("## %s: %zu vertices, %zu %ss\n\n### Memory\n\n", argument.c_str(),
              data.positions.size(), data.list(dim).size(), entity_name(dim));
  print_memory(data, dim);
  std::printf("\n### Building (median of %d)\n\n", runs);
  Cells cells{{0, 2}, {1, 2}, {0, 1}, {2, 1}};
  if (dim == 3) cells.insert(cells.end(), {{0, 3}, {3, 2}, {2, 3}, {3, 1}, {1, 3}});
  print_building(data, cells);
  std::printf("\n### Queries (median of %d)\n\n", runs);
  print_queries(data, dim);
  std::printf("\n");
}

}  // namespace
}  // namespace aomd

int main(int argc, char** argv) {
  try {
    if (argc < 2 || argv[1][0] == '-') {
      std::fprintf(
          stderr,
          "usage: aomd-bench MESH...   (files, or names that `aomd sample --list` gives)\n");
      return 2;
    }
    for (int k = 1; k < argc; ++k) aomd::report(argv[k]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "aomd-bench: %s\n", error.what());
    return 3;
  }
}
