#pragma once
// Data attached to the entities of a mesh by name and type (paper, figure 7: the vertices'
// "spacing").

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <typeindex>
#include <unordered_map>
#include <utility>
#include <vector>

#include "core/mesh/handle.h"
#include "core/mesh/mesh_data.h"

#pragma GCC visibility push(default)

namespace aomd {

/// What a file says of an array beside its values, of which Attribute tells: to_data() gives it
/// back.
struct FileNumbers {
  bool integer = false;
  std::optional<NumberType> type{};
  Meaning meaning = Meaning::Any;
  std::vector<std::string> names{};
};

/// What a mesh does to attached data of any type. Values of new entities are the column's initial
/// value. Where the creation is recorded in a journal, the value that it covers and the value that
/// undoing it removes are kept, so that undo and redo bring both back.
class AttachedBase {
 public:
  virtual ~AttachedBase() = default;
  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::type_index type() const { return type_; }
  [[nodiscard]] virtual std::size_t bytes() const = 0;
  [[nodiscard]] const FileNumbers& file_numbers() const { return file_numbers_; }
  void remember(FileNumbers numbers) { file_numbers_ = std::move(numbers); }

 protected:
  AttachedBase(std::string name, std::type_index type) : name_(std::move(name)), type_(type) {}

 private:
  friend class AttachedData;
  virtual void resize(std::uint32_t entities) = 0;
  virtual void reset(std::uint32_t id) = 0;
  /// An entity was created, and the journal counts it as the level's creation number `creation`:
  /// the value that it covers is kept, those kept from there on are forgotten.
  virtual void cover(std::uint32_t id, std::size_t creation) = 0;
  /// The creation numbered `creation` is undone (uncover) or done again (cover_again): the value
  /// and the kept one change places.
  virtual void uncover(std::uint32_t id, std::size_t creation) = 0;
  virtual void cover_again(std::uint32_t id, std::size_t creation) = 0;
  /// Nothing is kept of the first so many creations: a journal was attached that has applied them.
  virtual void start_after(std::size_t creations) = 0;
  virtual void compact(std::span<const std::uint32_t> new_index, std::uint32_t entities) = 0;

  std::string name_;
  std::type_index type_;
  FileNumbers file_numbers_;
};

/// One T for every entity of a kind. References stay valid until the column is dropped.
template <typename H, typename T>
class Attached final : public AttachedBase {
 public:
  Attached(std::string name, T initial, std::uint32_t entities, std::size_t creations)
      : AttachedBase(std::move(name), typeid(T)),
        initial_(std::move(initial)),
        values_(entities, initial_),
        first_creation_(creations) {}

  [[nodiscard]] T& operator[](H h) { return values_[h.index]; }
  [[nodiscard]] const T& operator[](H h) const { return values_[h.index]; }
  [[nodiscard]] const T& initial() const { return initial_; }
  [[nodiscard]] std::size_t bytes() const override {
    return (values_.capacity() + kept_.capacity()) * sizeof(T);
  }

 private:
  void resize(std::uint32_t entities) override { values_.resize(entities, initial_); }
  void reset(std::uint32_t id) override { values_[id] = initial_; }
  void cover(std::uint32_t id, std::size_t creation) override {
    forget(creation);
    kept_.push_back(std::exchange(values_[id], initial_));
  }
  void uncover(std::uint32_t id, std::size_t creation) override {
    if (creation >= first_creation_) std::swap(values_[id], kept_[creation - first_creation_]);
  }
  void cover_again(std::uint32_t id, std::size_t creation) override {
    if (creation < first_creation_) return reset(id);
    if (creation - first_creation_ == kept_.size()) return cover(id, creation);
    std::swap(values_[id], kept_[creation - first_creation_]);
  }
  void start_after(std::size_t creations) override {
    first_creation_ = creations;
    kept_.clear();
  }
  /// Values kept from creation number `creations` on: others take their numbers.
  void forget(std::size_t creations) {
    if (creations < first_creation_) start_after(creations);
    if (creations - first_creation_ < kept_.size())
      kept_.resize(creations - first_creation_, initial_);
  }
  void compact(std::span<const std::uint32_t> new_index, std::uint32_t entities) override {
    for (std::size_t old = 0; old < new_index.size(); ++old)
      if (new_index[old] != no_index && new_index[old] != old)
        values_[new_index[old]] = std::move(values_[old]);
    values_.resize(entities, initial_);
    values_.shrink_to_fit();
  }

  T initial_;
  std::vector<T> values_;
  std::vector<T> kept_;
  std::size_t first_creation_;  ///< number of the first recorded creation that this column has seen
};

/// All columns of one mesh.
class AttachedData {
 public:
  using List = std::vector<std::unique_ptr<AttachedBase>>;

  [[nodiscard]] const List& columns(int dim) const { return lists_[static_cast<std::size_t>(dim)]; }
  /// Null where there is no such column. O(1).
  [[nodiscard]] AttachedBase* find(int dim, std::string_view name) const;
  AttachedBase& add(int dim, std::unique_ptr<AttachedBase> column);
  /// False where there is no such column.
  bool drop(int dim, std::string_view name);
  [[nodiscard]] std::size_t bytes() const;

  // What happened to the entities
  // -----------------------------------------------------------------------------
  void resize(int dim, std::uint32_t entities);
  void created(int dim, std::uint32_t id);
  void cover(int dim, std::uint32_t id, std::size_t creation);
  void uncover(int dim, std::uint32_t id, std::size_t creation);
  void cover_again(int dim, std::uint32_t id, std::size_t creation);
  void start_after(int dim, std::size_t creations);
  void compact(int dim, std::span<const std::uint32_t> new_index, std::uint32_t entities);

 private:
  /// Columns by name; the key is the text that the column itself holds, which stays where it is.
  using Names = std::unordered_map<std::string_view, AttachedBase*>;

  std::array<List, 4> lists_;
  std::array<Names, 4> names_;
};

}  // namespace aomd

#pragma GCC visibility pop
