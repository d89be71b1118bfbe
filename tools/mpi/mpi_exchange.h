#pragma once
// Processes on several machines, through MPI.

#include "core/blocks/exchange.h"

namespace aomd {

/// All processes of MPI_COMM_WORLD. MPI is started when it is made, and must not have been.
class MpiExchange final : public Exchange {
 public:
  MpiExchange();
  MpiExchange(const MpiExchange&) = delete;
  MpiExchange& operator=(const MpiExchange&) = delete;

  [[nodiscard]] std::size_t rank() const override { return rank_; }
  [[nodiscard]] std::size_t ranks() const override { return ranks_; }
  [[nodiscard]] std::vector<std::string> gather(std::string bytes) override;
  [[nodiscard]] bool told(bool by_first) override;

  /// Ends all of them with this process's exit code, which becomes that of mpirun. Who found the
  /// same as the others waits for the first one.
  [[nodiscard]] static int end(int code, bool for_all);

 private:
  std::size_t rank_ = 0, ranks_ = 1;
};

}  // namespace aomd
