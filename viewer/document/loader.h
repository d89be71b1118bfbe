#pragma once
// Loads meshes in the background.

#include <atomic>
#include <exception>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "viewer/document/loaded_mesh.h"

namespace aomd::scene {

/// One load at a time that counts: starting another or cancelling lets the present one run out
/// unheard.
class Loader {
 public:
  Loader() = default;
  /// Waits for what is still reading.
  ~Loader() = default;
  Loader(const Loader&) = delete;
  Loader& operator=(const Loader&) = delete;

  void start(LoadRequest request);
  /// This is the result: nothing has to be read.
  void give(std::unique_ptr<LoadedMesh> mesh);
  void cancel();
  [[nodiscard]] bool busy() const { return present_ != nullptr; }
  /// What is being loaded: a file's or a sample's name.
  [[nodiscard]] const std::string& name() const { return name_; }

  struct Result {
    std::unique_ptr<LoadedMesh> mesh;
    std::exception_ptr error;  ///< where mesh is null
  };
  /// The result, once. With `wait` it blocks until there is one. None while nothing is loaded.
  [[nodiscard]] std::optional<Result> take(bool wait);

 private:
  struct Job {
    Result result;
    std::atomic<bool> finished = false;
    std::jthread thread;  ///< none where the mesh was given; last: joined before the rest goes
  };
  void forget_finished();

  std::list<std::unique_ptr<Job>> jobs_;
  Job* present_ = nullptr;
  std::string name_;
};

}  // namespace aomd::scene
