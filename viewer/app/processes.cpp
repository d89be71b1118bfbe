#include "viewer/app/processes.h"

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

namespace aomd::app {
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

/// What a process that shares the work does: answers until nothing is asked any more.
void answer(int socket, const std::function<std::string(std::size_t)>& work) {
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

class Sharing {
 public:
  Sharing(std::size_t count, std::size_t jobs, const std::function<std::string(std::size_t)>& work)
      : pieces_(count), work_(work) {
    for (std::size_t i = 0; i < std::min(jobs, count); ++i) start();
  }
  ~Sharing() {
    for (const Worker& each : workers_) close(each.socket);
    for (const Worker& each : workers_) death_of(each.process);
  }
  Sharing(const Sharing&) = delete;
  Sharing& operator=(const Sharing&) = delete;

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
      answer(ends[1], work_);
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
    std::vector<pollfd> sockets;
    for (const Worker& each : workers_) sockets.push_back({each.socket, POLLIN, 0});
    if (poll(sockets.data(), sockets.size(), -1) < 0 && errno != EINTR) fail("poll");
    for (std::size_t i = sockets.size(); i-- > 0;)
      if (sockets[i].revents != 0) take_answer(i);
  }
  void take_answer(std::size_t i) {
    Worker& worker = workers_[i];
    std::uint64_t size = 0;
    Piece& piece = pieces_[worker.piece];
    bool answered = receive_all(worker.socket, &size, sizeof size);
    if (answered) {
      piece.answer.resize(size);
      answered = receive_all(worker.socket, piece.answer.data(), size);
    }
    if (answered && next_ < pieces_.size()) return give_piece(worker);
    close(worker.socket);
    const std::string death = death_of(worker.process);
    workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(i));
    if (answered) return;
    piece.death = death;
    start();
  }

  std::vector<Piece> pieces_;
  const std::function<std::string(std::size_t)>& work_;
  std::vector<Worker> workers_;
  std::size_t next_ = 0;
};

}  // namespace

std::vector<Piece> share_among_processes(std::size_t count, std::size_t jobs,
                                         const std::function<std::string(std::size_t)>& work) {
  return Sharing(count, jobs, work).finish();
}

}  // namespace aomd::app
