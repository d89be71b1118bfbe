#include "core/base/processes.h"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <optional>
#include <system_error>
#include <thread>

namespace aomd {
namespace {

[[noreturn]] void fail(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// False where the other end is closed.
bool send_all(int socket, const void* data, std::size_t size) {
  const char* at = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t sent = send(socket, at, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    at += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receive_all(int socket, void* data, std::size_t size) {
  char* at = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t got = recv(socket, at, size, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    at += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

/// Once the other end of the socket is closed, this process has been let go.
void wait_for_letting_go(int socket, const std::function<void()>& let_go) {
  pollfd end{socket, 0, 0};
  while (poll(&end, 1, -1) < 0 && errno == EINTR) {
  }
  let_go();
}

/// What a process that shares the work does: answers until nothing is asked any more.
void answer(int socket, const Sharing& how, const std::function<std::string(std::size_t)>& work) {
  if (how.let_go) std::thread([&] { wait_for_letting_go(socket, how.let_go); }).detach();
  std::uint64_t piece = 0;
  while (receive_all(socket, &piece, sizeof piece)) {
    const std::string text = work(piece);
    const std::uint64_t size = text.size();
    if (!send_all(socket, &size, sizeof size) || !send_all(socket, text.data(), text.size()))
      return;
  }
}

std::string death_of(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status))
                             : "exit code " + std::to_string(WEXITSTATUS(status));
}

class Pieces {
 public:
  Pieces(std::size_t count, const Sharing& how, const std::function<std::string(std::size_t)>& work)
      : pieces_(count, {"", "not begun"}), how_(how), work_(work) {
    for (std::size_t i = 0; i < std::min(how.jobs, count); ++i) start();
  }
  ~Pieces() { let_go(); }
  Pieces(const Pieces&) = delete;
  Pieces& operator=(const Pieces&) = delete;

  std::vector<Piece> finish() {
    while (!workers_.empty()) wait();
    return std::move(pieces_);
  }

 private:
  struct Worker {
    pid_t process;
    int socket;
    std::uint64_t piece;
  };

  /// Starts a process on the next piece, where there is one.
  void start() {
    if (next_ >= pieces_.size()) return;
    std::array<int, 2> ends{};
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) fail("socketpair");
    const pid_t process = fork();
    if (process < 0) fail("fork");
    if (process == 0) {
      for (const Worker& each : workers_) close(each.socket);
      close(ends[0]);
      answer(ends[1], how_, work_);
      _exit(0);
    }
    close(ends[1]);
    workers_.push_back({process, ends[0], next_});
    give_piece(workers_.back());
  }
  /// A process that has died does not take it: that is noticed when its answer is waited for.
  void give_piece(Worker& worker) {
    worker.piece = next_++;
    send_all(worker.socket, &worker.piece, sizeof worker.piece);
  }
  void wait() {
    std::vector<pollfd> ends;
    for (const Worker& each : workers_) ends.push_back({each.socket, POLLIN, 0});
    ends.push_back({how_.stop, POLLIN, 0});  // poll passes over what is negative
    if (poll(ends.data(), ends.size(), -1) < 0) {
      if (errno != EINTR) fail("poll");
      return;
    }
    for (std::size_t i = workers_.size(); i-- > 0;)
      if (ends[i].revents != 0) take_answer(i);
    if (ends.back().revents != 0) stop();
  }
  void take_answer(std::size_t i) {
    Worker& worker = workers_[i];
    const std::size_t at = worker.piece;
    std::uint64_t size = 0;
    Piece piece;
    bool answered = receive_all(worker.socket, &size, sizeof size);
    if (answered) {
      piece.answer.resize(size);
      answered = receive_all(worker.socket, piece.answer.data(), size);
    }
    if (answered && !how_.fresh && next_ < pieces_.size()) {
      give_piece(worker);
    } else {
      close(worker.socket);
      const std::string death = death_of(worker.process);
      workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(i));
      if (!answered) piece = {"", death};
      start();
    }
    pieces_[at] = std::move(piece);
    if (how_.tell) how_.tell(at, pieces_[at]);
  }
  void stop() {
    for (const Worker& each : workers_) pieces_[each.piece].death = "stopped";
    let_go();
  }
  void let_go() {
    for (const Worker& each : workers_) close(each.socket);
    for (const Worker& each : workers_) death_of(each.process);
    workers_.clear();
  }

  std::vector<Piece> pieces_;
  const Sharing& how_;
  const std::function<std::string(std::size_t)>& work_;
  std::vector<Worker> workers_;
  std::size_t next_ = 0;
};

}  // namespace

std::vector<Piece> share_among_processes(std::size_t count, const Sharing& how,
                                         const std::function<std::string(std::size_t)>& work) {
  return Pieces(count, how, work).finish();
}

}  // namespace aomd
