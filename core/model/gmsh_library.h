#pragma once
// Gmsh's C interface, loaded when it is first needed: linking it would cost every start of every
// program 0.1 s.

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <gmshc.h>

#include "core/model/model.h"

namespace aomd::gmsh {

/// The functions in use, by their names in gmshc.h without the prefix.
struct Functions {
#define AOMD_GMSH_FUNCTIONS(use)                                                             \
  use(Initialize) use(Finalize) use(Free) use(Merge) use(OptionSetNumber) use(LoggerStart)   \
      use(LoggerGet) use(LoggerStop) use(LoggerGetLastError) use(ModelAdd) use(ModelRemove)  \
          use(ModelSetCurrent) use(ModelGetEntities) use(ModelGetType) use(ModelGetBoundary) \
              use(ModelGetBoundingBox) use(ModelGetValue) use(ModelGetDerivative)            \
                  use(ModelGetSecondDerivative) use(ModelGetNormal)                          \
                      use(ModelGetParametrizationBounds) use(ModelMeshGenerate)              \
                          use(ModelMeshGetNodes) use(ModelMeshGetElements)                   \
                              use(ModelMeshGetEmbedded)
// NOLINTNEXTLINE(bugprone-macro-parentheses): a name that is declared stands in none
#define AOMD_GMSH_MEMBER(name) decltype(&::gmsh##name) name = nullptr;
  AOMD_GMSH_FUNCTIONS(AOMD_GMSH_MEMBER)
#undef AOMD_GMSH_MEMBER
};

/// The library's functions. Throws ModelError where it cannot be loaded.
[[nodiscard]] const Functions& functions();

/// Calls a function of the interface with its error code appended; throws ModelError with Gmsh's
/// own words.
template <typename Function, typename... Arguments>
void call(Function function, Arguments... arguments);
/// What Gmsh said last.
[[nodiscard]] std::string last_error();

/// An array that Gmsh allocates: `call(f, ..., &a.data, &a.size)`.
template <typename T>
struct Array {
  T* data = nullptr;
  std::size_t size = 0;

  Array() = default;
  Array(const Array&) = delete;
  Array& operator=(const Array&) = delete;
  ~Array() { functions().Free(data); }
  [[nodiscard]] std::span<const T> values() const { return {data, size}; }
};

/// An array of arrays.
template <typename T>
struct Table {
  T** data = nullptr;
  std::size_t* sizes = nullptr;
  std::size_t size = 0;

  Table() = default;
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;
  ~Table() {
    for (std::size_t i = 0; i < size; ++i) functions().Free(data[i]);
    functions().Free(data), functions().Free(sizes);
  }
  [[nodiscard]] std::span<const T> row(std::size_t i) const { return {data[i], sizes[i]}; }
};

/// Sends what any library prints to nowhere for its lifetime.
class Silence {
 public:
  Silence();
  ~Silence();
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  int saved_[2];
};

/// Gmsh's state: starts with the first owner and ends with the last.
class Session;

/// A CAD file as one of Gmsh's models, gone with its last owner.
class File {
 public:
  /// Throws ModelError.
  explicit File(const std::string& path);
  ~File();
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  /// Makes it the model that Gmsh's functions speak of.
  void make_current() const;
  /// All entities: dimensions and tags in turn.
  [[nodiscard]] std::vector<ModelRef> entities() const;

 private:
  void merge(const std::string& path);

  std::shared_ptr<Session> session_;
  std::string name_;
};

template <typename Function, typename... Arguments>
void call(Function function, Arguments... arguments) {
  int error = 0;
  function(arguments..., &error);
  if (error != 0) throw ModelError("Gmsh: " + last_error());
}

}  // namespace aomd::gmsh
