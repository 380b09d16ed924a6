// A scene that ranks read in parts: each its share of the files, and of all others only the colliders that it needs.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "graze/io/tiles.hpp"
#include "mpi/exchange.hpp"

namespace graze::cli {

/// The texts of all ranks on the first; empty on the others. All ranks.
std::vector<std::string> texts_on_first(mpi::Together& together, std::string text);

/// A scene in parts, dealt out in turn. Colliders have the numbers that they have in the whole scene, as `load_scene`
/// and `append` put it together, and a body's number is its collider's.
class SharedScene {
 public:
  /// Reads this rank's parts, the others' sizes, and the parts of the scene that all need. All ranks, with the same
  /// files. Throws `CommonError` on every rank when one cannot read.
  SharedScene(mpi::Together& together, const std::vector<std::string>& files, const io::LoadOptions& options);

  /// A collider by its number, with the scene that it is in. A part that this rank has not read before is read now, and
  /// some are kept. Throws `InvalidValue`. Both results are good until the next call.
  const io::Collider& collider(std::uint64_t number, const io::Scene** in = nullptr);
  /// The number in the whole scene of the body of a collider, given by its number.
  std::uint64_t body_of(std::uint64_t number);

  /// Calls `f(number)` for the colliders of the parts that this rank was dealt.
  template <class F>
  void each_own(F&& f) {
    for (std::size_t part = own_; part < parts_.size(); part += ranks_)
      for (std::uint64_t i = first_collider_[part]; i < first_collider_[part + 1]; ++i) f(i);
  }

  const std::string& source() const { return source_; }
  std::size_t parts() const { return parts_.size(); }
  std::uint64_t colliders() const { return first_collider_.back(); }
  std::uint64_t bodies() const { return first_body_.back(); }
  /// Whether anything in the whole scene can move.
  bool moves() const { return moves_; }
  /// Notices that this rank was given while it read its parts.
  const std::vector<std::string>& notices() const { return notices_; }

 private:
  struct Kept {
    std::size_t part;
    io::Scene scene;
  };
  const io::Scene& part(std::size_t number);
  io::Scene read(std::size_t number);

  std::vector<io::ScenePart> parts_;
  io::LoadOptions options_;
  std::size_t own_, ranks_;
  std::string source_;
  std::vector<std::string> systems_;                        ///< of the whole scene
  std::vector<std::uint64_t> first_collider_, first_body_;  ///< of each part, and the ends
  bool moves_ = false, systems_known_ = false;
  std::vector<std::string> notices_;
  std::deque<Kept> kept_;  ///< the one that was needed last in front
};

}  // namespace graze::cli
