// Messages from every rank to every other, of any length, most of them empty.
#pragma once

#include <cstring>
#include <type_traits>
#include <vector>

#include "mpi/messages.hpp"

namespace graze::mpi {

/// What goes to each rank, or came from it.
template <class E>
using ByRank = std::vector<std::vector<E>>;

/// Sends `to[r]` to rank r; returns what came. What goes to the own rank is not sent. Adds to `bytes` what was sent.
template <class E>
ByRank<E> exchanged(MPI_Comm comm, ByRank<E>& to, std::uint64_t& bytes) {
  static_assert(std::is_trivially_copyable_v<E>);
  constexpr int tag = 11;
  const auto ranks = static_cast<std::size_t>(size_of(comm)), own = static_cast<std::size_t>(rank_of(comm));
  std::vector<std::uint64_t> sizes(ranks), sizes_from(ranks);
  for (std::size_t r = 0; r < ranks; ++r) sizes[r] = to[r].size();
  MPI_Alltoall(sizes.data(), 1, MPI_UINT64_T, sizes_from.data(), 1, MPI_UINT64_T, comm);
  ByRank<E> from(ranks);
  std::vector<MPI_Request> open;
  for (std::size_t r = 0; r < ranks; ++r) {
    if (r == own) continue;
    from[r].resize(sizes_from[r]);
    char* const begin = reinterpret_cast<char*>(from[r].data());
    each_piece(from[r].size() * sizeof(E), [&](std::size_t at, int count) {
      MPI_Irecv(begin + at, count, MPI_BYTE, static_cast<int>(r), tag, comm, &open.emplace_back());
    });
  }
  for (std::size_t r = 0; r < ranks; ++r) {
    if (r == own) continue;
    const char* const begin = reinterpret_cast<const char*>(to[r].data());
    bytes += to[r].size() * sizeof(E);
    each_piece(to[r].size() * sizeof(E), [&](std::size_t at, int count) {
      MPI_Isend(begin + at, count, MPI_BYTE, static_cast<int>(r), tag, comm, &open.emplace_back());
    });
  }
  MPI_Waitall(static_cast<int>(open.size()), open.data(), MPI_STATUSES_IGNORE);
  from[own] = std::move(to[own]);
  return from;
}

}  // namespace graze::mpi
