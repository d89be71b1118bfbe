#include "tools/mpi/mpi_exchange.h"

#include <algorithm>
#include <cstdint>

#define OMPI_SKIP_MPICXX 1
#include <mpi.h>

namespace aomd {
namespace {

constexpr int tag = 1;
constexpr std::size_t most_at_once = std::size_t{1} << 30;  // lengths of messages are ints

/// Calls pass(first byte, count) for pieces that a message may have.
template <typename Bytes, typename Pass>
void in_messages(Bytes& bytes, const Pass& pass) {
  for (std::size_t at = 0; at < bytes.size(); at += most_at_once)
    pass(bytes.data() + at, static_cast<int>(std::min(most_at_once, bytes.size() - at)));
}

}  // namespace

MpiExchange::MpiExchange() {
  MPI_Init(nullptr, nullptr);
  int rank = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  rank_ = static_cast<std::size_t>(rank);
  ranks_ = static_cast<std::size_t>(ranks);
}

// One after the other, so that the first one has no more than it keeps.
std::vector<std::string> MpiExchange::gather(std::string bytes) {
  const std::uint64_t mine = bytes.size();
  std::vector<std::uint64_t> sizes(ranks_, mine);
  MPI_Gather(&mine, 1, MPI_UINT64_T, sizes.data(), 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
  if (rank_ > 0) {
    in_messages(bytes, [](const char* data, int count) {
      MPI_Send(data, count, MPI_BYTE, 0, tag, MPI_COMM_WORLD);
    });
    return {};
  }
  std::vector<std::string> all;
  all.push_back(std::move(bytes));
  for (std::size_t from = 1; from < ranks_; ++from) {
    all.emplace_back(sizes[from], '\0');
    in_messages(all.back(), [from](char* data, int count) {
      MPI_Recv(data, count, MPI_BYTE, static_cast<int>(from), tag, MPI_COMM_WORLD,
               MPI_STATUS_IGNORE);
    });
  }
  return all;
}

bool MpiExchange::told(bool by_first) {
  char said = by_first ? 1 : 0;
  MPI_Bcast(&said, 1, MPI_CHAR, 0, MPI_COMM_WORLD);
  return said != 0;
}

int MpiExchange::end(int code, bool for_all) {
  if (code != 0 && for_all) MPI_Abort(MPI_COMM_WORLD, code);
  MPI_Finalize();
  return code;
}

}  // namespace aomd
