// Messages of any length between ranks, and waiting for them without taking a processor from those that work.
#pragma once

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <string>
#include <thread>

namespace graze::mpi {

inline int rank_of(MPI_Comm comm) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  return rank;
}

inline int size_of(MPI_Comm comm) {
  int size = 0;
  MPI_Comm_size(comm, &size);
  return size;
}

/// The bytes of a piece: MPI counts in int, so longer messages are sent in pieces.
constexpr std::size_t largest_piece = std::size_t{1} << 30;

/// Calls `f(offset, count)` for the pieces of so many bytes.
template <class F>
void each_piece(std::size_t bytes, F&& f) {
  for (std::size_t begin = 0; begin < bytes; begin += largest_piece)
    f(begin, static_cast<int>(std::min(largest_piece, bytes - begin)));
}

/// Sends a text of one rank to all.
inline void broadcast(MPI_Comm comm, std::string& text, int from) {
  std::uint64_t size = text.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, from, comm);
  text.resize(size);
  each_piece(text.size(),
             [&](std::size_t begin, int count) { MPI_Bcast(text.data() + begin, count, MPI_BYTE, from, comm); });
}

/// Sends a text to one rank, which has its size.
inline void send(MPI_Comm comm, const std::string& text, int to, int tag) {
  each_piece(text.size(),
             [&](std::size_t begin, int count) { MPI_Send(text.data() + begin, count, MPI_BYTE, to, tag, comm); });
}

inline void receive(MPI_Comm comm, std::string& text, int from, int tag) {
  each_piece(text.size(), [&](std::size_t begin, int count) {
    MPI_Recv(text.data() + begin, count, MPI_BYTE, from, tag, comm, MPI_STATUS_IGNORE);
  });
}

/// Waiting between two looks, the longer the longer nothing came: MPI itself would keep a processor busy meanwhile.
class Patience {
 public:
  void wait() {
    constexpr auto longest = std::chrono::microseconds(1000);
    std::this_thread::sleep_for(pause_);
    pause_ = std::min(2 * pause_, longest);
  }
  void reset() { pause_ = shortest; }

 private:
  static constexpr std::chrono::microseconds shortest{20};
  std::chrono::microseconds pause_ = shortest;
};

}  // namespace graze::mpi
