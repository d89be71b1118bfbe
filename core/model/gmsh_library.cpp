#include "core/model/gmsh_library.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <clocale>
#include <cstdio>
#include <iostream>

#include "core/model/cad_file.h"

namespace aomd::gmsh {
namespace {

Functions load() {
  void* library = dlopen(AOMD_GMSH_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  if (!library)
    throw ModelError("Gmsh cannot be loaded (install libgmsh): " + std::string(dlerror()));
  Functions f;
  const auto find = [library](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(library, name));
    if (!function) throw ModelError(std::string(AOMD_GMSH_LIBRARY " has no function ") + name);
  };
#define AOMD_GMSH_FIND(name) find(f.name, "gmsh" #name);
  AOMD_GMSH_FUNCTIONS(AOMD_GMSH_FIND)
#undef AOMD_GMSH_FIND
  return f;
}

void set_option(const char* name, double value) { call(functions().OptionSetNumber, name, value); }

}  // namespace

const Functions& functions() {
  static const Functions f = load();
  return f;
}

std::string last_error() {
  char* text = nullptr;
  int error = 0;
  functions().LoggerGetLastError(&text, &error);
  std::string said = text && *text ? text : "it failed without a message";
  functions().Free(text);
  return said.substr(0, said.find('\n'));
}

// OpenCASCADE prints to standard output whatever Gmsh's options say.
Silence::Silence() {
  std::cout.flush();
  std::fflush(nullptr);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (const int i : {0, 1}) {
    saved_[i] = fcntl(i + 1, F_DUPFD_CLOEXEC, 3);
    if (nowhere >= 0 && saved_[i] >= 0) dup2(nowhere, i + 1);
  }
  if (nowhere >= 0) close(nowhere);
}

Silence::~Silence() {
  std::cout.flush();
  std::fflush(nullptr);
  for (const int i : {0, 1})
    if (saved_[i] >= 0) dup2(saved_[i], i + 1), close(saved_[i]);
}

class Session {
 public:
  Session() {
    const std::string locale = std::setlocale(LC_ALL, nullptr);
    call(functions().Initialize, 0, nullptr, 0);
    std::setlocale(LC_ALL, locale.c_str());  // Gmsh takes the user's
    prepare();
  }
  ~Session() {
    int ignored = 0;
    functions().Finalize(&ignored);
  }

  static std::shared_ptr<Session> get() {
    static std::weak_ptr<Session> present;
    std::shared_ptr<Session> session = present.lock();
    if (!session) present = session = std::make_shared<Session>();
    return session;
  }

  // A script may have changed options: ours are set again after each.
  static void prepare() {
    set_option("General.Terminal", 0);
    set_option("General.AbortOnError", 2);
    set_option("General.NumThreads", 1);
  }

  [[nodiscard]] std::string next_name() { return "aomd-" + std::to_string(++made_); }

  void make_current(const std::string& name) {
    if (name == current_) return;
    call(functions().ModelSetCurrent, name.c_str());
    current_ = name;
  }
  void add(const std::string& name) {
    call(functions().ModelAdd, name.c_str());
    current_ = name;
  }
  void remove(const std::string& name) noexcept {
    int ignored = 0;
    functions().ModelSetCurrent(name.c_str(), &ignored);
    functions().ModelRemove(&ignored);
    current_.clear();
  }

 private:
  int made_ = 0;
  std::string current_;
};

File::File(const std::string& path) : session_(Session::get()), name_(session_->next_name()) {
  check_cad_file(path);
  session_->add(name_);
  try {
    merge(path);
  } catch (...) {
    session_->remove(name_);
    throw;
  }
}

File::~File() { session_->remove(name_); }

void File::make_current() const { session_->make_current(name_); }

// An error that throws out of Gmsh's parser spoils every script read afterwards, so errors are only
// collected here.
void File::merge(const std::string& path) {
  const Functions& f = functions();
  std::string wrong;
  {
    const Silence silence;
    set_option("General.AbortOnError", 0);
    call(f.LoggerStart);
    int failed = 0;
    f.Merge(path.c_str(), &failed);
    Array<char*> log;
    call(f.LoggerGet, &log.data, &log.size);
    for (char* line : log.values()) {
      const std::string text(line);
      f.Free(line);
      if (wrong.empty() && text.rfind("Error", 0) == 0) wrong = text.substr(text.find(':') + 1);
    }
    call(f.LoggerStop);
    if (failed && wrong.empty()) wrong = last_error();
    session_->prepare();
  }
  if (!wrong.empty()) throw ModelError(in_file(path, wrong));
  if (entities().empty()) throw ModelError(path + ": no model in it");
}

std::vector<ModelRef> File::entities() const {
  make_current();
  Array<int> pairs;
  call(functions().ModelGetEntities, &pairs.data, &pairs.size, -1);
  std::vector<ModelRef> refs;
  for (std::size_t i = 0; i + 1 < pairs.size; i += 2) {
    if (pairs.data[i + 1] > ModelRef::max_tag) throw ModelError("a tag of the model is too large");
    refs.emplace_back(pairs.data[i], pairs.data[i + 1]);
  }
  return refs;
}

}  // namespace aomd::gmsh
