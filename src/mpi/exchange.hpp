// Steps that ranks take together: each its own part, then messages from every rank to every other.
//
// Guarantee: no rank waits for one that has failed. An error in a rank's own part, and messages for it that do not fit
// into its memory, are an error of the next exchange on every rank. Messages may have any length, and most have none.
#pragma once

#include <cstring>
#include <ctime>
#include <exception>
#include <new>
#include <string>
#include <type_traits>
#include <vector>

#include "graze/mpi/sweep.hpp"
#include "mpi/messages.hpp"

namespace graze::mpi {

/// Messages to each rank, or from it.
template <class E>
using ByRank = std::vector<std::vector<E>>;

class Together {
 public:
  explicit Together(MPI_Comm comm) : comm_(comm) {}

  MPI_Comm comm() const { return comm_; }
  std::uint64_t bytes() const { return bytes_; }  ///< sent to other ranks so far
  double work() const { return work_; }           ///< seconds of processors that this rank's own parts took so far
  template <class E>
  ByRank<E> nothing() const {
    return ByRank<E>(static_cast<std::size_t>(size_of(comm_)));
  }

  /// Runs this rank's part of a step; nothing after one that has failed.
  template <class F>
  void alone(F&& part) {
    if (!fault_.empty()) return;
    const double before = processor_seconds();
    try {
      part();
    } catch (const std::bad_alloc&) {
      fault_ = "out of memory";
    } catch (const std::exception& e) {
      fault_ = e.what();
    }
    work_ += processor_seconds() - before;
  }

  /// Throws `CommonError` on every rank when a part of any has failed. All ranks.
  void meet() { agree(comm_, fault_); }

  /// Sends `to[r]` to rank r; returns the messages that came. Those to the own rank are not sent. Throws as `meet`. All
  /// ranks.
  template <class E>
  ByRank<E> exchange(ByRank<E>& to);

 private:
  /// The seconds of all threads of the process.
  static double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

  MPI_Comm comm_;
  std::string fault_;
  std::uint64_t bytes_ = 0;
  double work_ = 0;
};

template <class E>
ByRank<E> Together::exchange(ByRank<E>& to) {
  static_assert(std::is_trivially_copyable_v<E>);
  constexpr int tag = 11;
  const auto ranks = static_cast<std::size_t>(size_of(comm_)), own = static_cast<std::size_t>(rank_of(comm_));
  std::vector<std::uint64_t> sizes(ranks), sizes_from(ranks);
  for (std::size_t r = 0; r < ranks; ++r) sizes[r] = to[r].size();
  MPI_Alltoall(sizes.data(), 1, MPI_UINT64_T, sizes_from.data(), 1, MPI_UINT64_T, comm_);
  ByRank<E> from(ranks);
  alone([&] {
    std::uint64_t coming = 0;
    for (std::size_t r = 0; r < ranks; ++r) coming += r == own ? 0 : sizes_from[r] * sizeof(E);
    try {
      for (std::size_t r = 0; r < ranks; ++r)
        if (r != own) from[r].resize(sizes_from[r]);
    } catch (const std::exception&) {
      throw std::runtime_error("messages of " + std::to_string(coming) + " bytes do not fit into memory");
    }
  });
  meet();
  std::vector<MPI_Request> open;
  for (std::size_t r = 0; r < ranks; ++r) {
    char* const begin = reinterpret_cast<char*>(from[r].data());
    each_piece(from[r].size() * sizeof(E), [&](std::size_t at, int count) {
      MPI_Irecv(begin + at, count, MPI_BYTE, static_cast<int>(r), tag, comm_, &open.emplace_back());
    });
  }
  for (std::size_t r = 0; r < ranks; ++r) {
    if (r == own) continue;
    const char* const begin = reinterpret_cast<const char*>(to[r].data());
    bytes_ += to[r].size() * sizeof(E);
    each_piece(to[r].size() * sizeof(E), [&](std::size_t at, int count) {
      MPI_Isend(begin + at, count, MPI_BYTE, static_cast<int>(r), tag, comm_, &open.emplace_back());
    });
  }
  MPI_Waitall(static_cast<int>(open.size()), open.data(), MPI_STATUSES_IGNORE);
  from[own] = std::move(to[own]);
  return from;
}

}  // namespace graze::mpi
