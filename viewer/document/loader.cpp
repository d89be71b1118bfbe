#include "viewer/document/loader.h"

#include <utility>

namespace aomd::scene {

void Loader::start(LoadRequest request) {
  forget_finished();
  name_ = request.file.empty() ? request.sample : request.file.filename().string();
  jobs_.push_back(std::make_unique<Job>());
  present_ = jobs_.back().get();
  present_->thread = std::jthread([job = present_, request = std::move(request)] {
    try {
      job->result.mesh = load(request);
    } catch (...) {
      job->result.error = std::current_exception();
    }
    job->finished = true;
  });
}

void Loader::give(std::unique_ptr<LoadedMesh> mesh) {
  forget_finished();
  name_ = mesh->name;
  jobs_.push_back(std::make_unique<Job>());
  present_ = jobs_.back().get();
  present_->result.mesh = std::move(mesh);
  present_->finished = true;
}

void Loader::cancel() { present_ = nullptr; }

std::optional<Loader::Result> Loader::take(bool wait) {
  if (present_ == nullptr) return {};
  if (wait && present_->thread.joinable()) present_->thread.join();
  if (!present_->finished) return {};
  std::optional<Result> result = std::move(present_->result);
  present_ = nullptr;
  forget_finished();
  return result;
}

void Loader::forget_finished() {
  std::erase_if(jobs_, [&](const auto& job) { return job.get() != present_ && job->finished; });
}

}  // namespace aomd::scene
