// The program `aomd-mpi`: `mpirun -n N aomd-mpi decimate --blocks M ...`.

#include <fcntl.h>
#include <unistd.h>

#include "tools/aomd/program.h"
#include "tools/mpi/mpi_exchange.h"

namespace {

/// The first process speaks for all.
void be_silent() {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace aomd::cli;
  aomd::MpiExchange exchange;
  const bool first = exchange.rank() == 0;
  if (!first) be_silent();
  const auto add = [&](CLI::App& app, Action& action) {
    add_shared_decimate(app, action, exchange);
  };
  const int code = run_program("aomd-mpi", {add}, argc, argv);
  // What is wrong with options and input all find, and the first one says so.
  return aomd::MpiExchange::end(code, first || code >= out_of_limits);
}
