// Twin: changes of T, and travels through the history.

#include <algorithm>
#include <functional>
#include <utility>

#include "core/mesh/names.h"
#include "tests/support/twin.h"

namespace aomd::oracle {
namespace {}  // namespace

// T

bool Twin::defines(int i, int j) const {
  if (i < j || plain_.count(i) == 0 || !mesh_.stored(i, j)) return false;
  for (int k = 0; k < i; ++k)
    if (k != j && mesh_.stored(i, k)) return false;
  return true;
}

void Twin::take_missing(int dim, const std::map<Ids, ModelRef>& missing) {
  const Index before = plain_.capacity(dim);
  for (std::size_t n = 0; n < missing.size(); ++n) {
    const EntityRef e(dim, before + static_cast<Index>(n));
    expect(mesh_.alive(e), name_of(e) + " should have been created for T");
    VertexBuffer buffer;
    const auto v = mesh_.vertices_of(e, buffer);
    const Ids vertices(v.begin(), v.end());
    const auto at = missing.find(sorted(vertices));
    expect(at != missing.end() && plain_.find(dim, vertices) == no_index,
           name_of(e) + " was not missing");
    (void)plain_.create(dim, {mesh_.shape(e), vertices, at->second}, true);
    touch(e);
  }
}

// Entities come into being when T first asks for their level, and never behind the back of a
// history.
bool Twin::complete_by(int i, int j, const std::function<void()>& change) {
  std::array<std::map<Ids, ModelRef>, 4> missing;
  std::array<bool, 4> complete{};
  bool creates = false;
  for (const int dim : {i, j}) {
    const auto d = static_cast<std::size_t>(dim);
    complete[d] = mesh_.complete(dim);
    if (!complete[d]) missing[d] = plain_.missing(dim);
    creates = creates || !missing[d].empty();
  }
  bool refused = false;
  try {
    change();
  } catch (const std::logic_error&) {
    refused = true;
  }
  const bool history = attached() && journal_.size() > 0;
  const bool incomplete =
      !complete[static_cast<std::size_t>(i)] || !complete[static_cast<std::size_t>(j)];
  // Where nothing is missing now, undo may still bring back what lacks its sides.
  expect(refused ? history && incomplete : !(history && creates), "T: entities and history");
  if (refused) return false;
  expect(mesh_.stored(i, j) && mesh_.complete(i) && mesh_.complete(j),
         "T: not stored, or not complete");
  for (const int dim : {2, 1}) take_missing(dim, missing[static_cast<std::size_t>(dim)]);
  if (creates && attached()) past_ = {{cursor_, plain_}};
  return true;
}

void Twin::set(int i, int j) {
  if (complete_by(i, j, [&] { mesh_.set(i, j); }))
    user_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = true;
}

void Twin::unset(int i, int j) {
  const bool must_stay = defines(i, j);
  bool& user = user_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
  try {
    mesh_.unset(i, j);
  } catch (const std::logic_error& error) {
    expect(must_stay, std::string("unset refused: ") + error.what());
    expect(mesh_.stored(i, j), "refused, and gone");
    return;
  }
  expect(!must_stay, "unset should be refused");
  user = false;
  expect(
      mesh_.stored(i, j) == (wishes_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] > 0),
      "stored after unset");
}

void Twin::request(int i, int j) {
  std::optional<Request> wish;
  if (!complete_by(i, j, [&] { wish = mesh_.request(i, j); })) return;
  requests_.push_back({i, j, std::move(*wish)});
  ++wishes_[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
}

void Twin::release(std::size_t k) {
  const int i = requests_[k].i, j = requests_[k].j;
  const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
  const bool stays = --wishes_[a][b] > 0 || user_[a][b] || defines(i, j);
  requests_.erase(requests_.begin() + static_cast<std::ptrdiff_t>(k));
  expect(mesh_.stored(i, j) == stays, "stored after release");
}

// History

void Twin::attach() {
  journal_.clear();
  mesh_.attach(&journal_);
  past_ = {{0, plain_}};
  cursor_ = 0;
}

void Twin::detach() {
  mesh_.attach(nullptr);
  journal_.clear();
  past_.clear();
}

void Twin::edited() {
  if (!attached()) return;
  if (journal_.cursor() == cursor_) return;
  past_.erase(past_.upper_bound(cursor_), past_.end());
  cursor_ = journal_.cursor();
  past_[cursor_] = plain_;
}

// What the mesh was at this point of the history, it must be again.
void Twin::travelled() {
  cursor_ = journal_.cursor();
  plain_ = past_.at(cursor_);
  touched_.clear();
  expect(mesh_.count(0) == plain_.count(0), "vertices after undo or redo");
  if (std::string d = state_difference(mesh_, plain_); !d.empty())
    throw Difference("undo or redo: " + d);
}

void Twin::undo() {
  const bool possible = journal_.cursor() > 0;
  expect(journal_.undo(mesh_) == possible, "undo at the start");
  while (!past_.count(journal_.cursor())) expect(journal_.undo(mesh_), "undo within an edit");
  travelled();
}

void Twin::redo() {
  const bool possible = journal_.cursor() < journal_.size();
  expect(journal_.redo(mesh_) == possible, "redo at the end");
  while (!past_.count(journal_.cursor())) expect(journal_.redo(mesh_), "redo within an edit");
  travelled();
}

void Twin::seek(std::size_t cursor) {
  const auto at = past_.lower_bound(std::min(cursor, journal_.size()));
  journal_.seek(mesh_, at->first);
  expect(journal_.cursor() == at->first, "seek");
  travelled();
}

}  // namespace aomd::oracle
