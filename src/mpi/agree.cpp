#include <algorithm>

#include "graze/mpi/sweep.hpp"
#include "mpi/messages.hpp"

namespace graze::mpi {

void agree(MPI_Comm comm, const std::string& fault) {
  const int mine = fault.empty() ? size_of(comm) : rank_of(comm);
  int first = 0;
  MPI_Allreduce(&mine, &first, 1, MPI_INT, MPI_MIN, comm);
  if (first == size_of(comm)) return;
  std::string message = "rank " + std::to_string(first) + ": " + fault;
  broadcast(comm, message, first);
  throw CommonError(message);
}

void agree_on(MPI_Comm comm, const std::string& what, const std::string& text) {
  std::string of_first = text;
  broadcast(comm, of_first, 0);
  agree(comm, text == of_first ? "" : what + ": expected what rank 0 has, " + of_first + ", got " + text);
}

}  // namespace graze::mpi
