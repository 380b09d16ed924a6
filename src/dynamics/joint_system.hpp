// The locked axes of all joints of an island, solved at once: a chain of any length holds as one joint does.
//
// Rows of one joint after the other agree only after many rounds, and the error that remains in a stiff chain builds up
// from sub-step to sub-step. Joints that make no loop have a tree of bodies. From its leaves to its root each joint
// ties all that hangs on it to the next body, whose response to an impulse is from then on that of the whole; from the
// root back to the leaves impulses are corrected by what was not known yet (Featherstone 1983, "The calculation of
// robot dynamics using articulated-body inertias"; Baraff 1996, "Linear-time dynamics using Lagrange multipliers").
// Responses are inverse masses, so that a body that cannot move or turn is no case of its own.
//
// Joints that close loops are solved after the trees, all rows of a linkage at once, by their response with the trees
// holding (Baraff's auxiliary constraints). A loop may hold what others hold already, as the second hinge of a door
// does: each of its rows yields by a small part of what its bodies would alone, which shares such a load among them and
// bounds it where a linkage is stretched out.
//
// Guarantee: the impulses make all rates of locked axes of the tree what is wanted, up to rounding, in time linear in
// the joints; a row that follows from others is left out. Loops cost the cube of their rows and their rows times the
// joints of their linkage, and are left to the caller beyond `most_loop_rows` and `most_loop_work`.
#pragma once

#include <array>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "dynamics/joints.hpp"

namespace graze {

template <class T, class Space>
class JointSystem {
 public:
  /// Finds the trees and the loops. `bodies`: the two of each joint by their places; `movable`: of each body. Trees
  /// begin at bodies that nothing pushes.
  void prepare(std::span<const JointRows<T, Space>> joints,
               std::span<const std::pair<std::uint32_t, std::uint32_t>> bodies, std::span<const std::uint8_t> movable);
  /// Whether a joint's locked rows are solved here; otherwise it closes one loop too many, or has nothing that moves.
  bool holds(std::size_t joint) const { return held_[joint] != 0; }
  /// The number of these joints that close loops.
  std::size_t loops() const { return loops_.size(); }
  /// Whether all joints that anything moves are solved here.
  bool holds_all() const { return holds_all_; }

  /// Computes the responses where the joints' rows are now.
  void factor(std::span<const JointRows<T, Space>> joints, std::span<const SolverBody<T, Space>> bodies);
  /// One pass over all locked rows of the trees; with `bias` errors of position are corrected.
  void solve(std::span<JointRows<T, Space>> joints, std::span<SolverBody<T, Space>> bodies, bool bias);

 private:
  /// The most rows of loops of a linkage that are solved at once, some thirty ball joints, and the most responses of
  /// links that they may take in large trees.
  static constexpr std::size_t most_loop_rows = 96, most_loop_work = 4096;
  static constexpr std::size_t freedoms = std::is_same_v<typename Space::Vec, Vec3<T>> ? 6 : 3;
  static constexpr std::size_t most_rows = JointRows<T, Space>::most_locked;
  using Freedoms = std::array<T, freedoms>;
  using Rows = std::array<T, most_rows>;

  /// A joint from a body to the next one towards the root.
  struct Link {
    std::uint32_t joint = 0, body = 0, next = 0;
    bool body_is_a = false, next_moves = false;
    std::size_t rows = 0;
    std::array<Freedoms, most_rows> of_body{}, of_next{};  ///< what an impulse of 1 pushes
    std::array<Freedoms, most_rows> response{};            ///< of the next body to that, before it is tied
    FactoredRows<T, most_rows> factors{};
    Rows impulses{};
  };
  /// A joint that closes a loop.
  struct Loop {
    std::uint32_t joint = 0, a = 0, b = 0;
    std::size_t first_row = 0, rows = 0;  ///< among those of its linkage
  };
  /// Bodies that joints with loops hold together. Bodies that nothing pushes hold nothing together.
  struct Linkage {
    std::size_t first_link = 0, end_link = 0;
    std::size_t first_loop = 0, end_loop = 0;
    std::size_t first_row = 0, rows = 0;  ///< of its loops
    std::size_t first_factor = 0;
  };
  struct LoopRow {
    Freedoms of_a{}, of_b{};  ///< what an impulse of 1 pushes
    T yielding{};             ///< the rate that an impulse of 1 leaves
  };
  struct Response {
    std::array<Freedoms, freedoms> alone{};         ///< the body's inverse mass
    std::array<Freedoms, freedoms> inverse_mass{};  ///< of the body with all that hangs on it
    Freedoms change{}, pushed{};
  };

  static Freedoms pushed_by(const MeasuredRow<T, Space>& row, bool is_a);
  static Freedoms times(const std::array<Freedoms, freedoms>& matrix, const Freedoms& v);
  void tie(Link& link, const JointRows<T, Space>& joint);
  /// Finds the impulses of trees that make the rates of each link `wanted(link)`, and calls `push(link)`.
  template <class Wanted, class Push>
  void sweep(std::span<Link> links, const Wanted& wanted, const Push& push);
  void solve_trees(std::span<JointRows<T, Space>> joints, std::span<SolverBody<T, Space>> bodies, bool bias);
  void find_linkages(std::span<const JointRows<T, Space>> joints,
                     std::span<const std::pair<std::uint32_t, std::uint32_t>> bodies,
                     std::span<const std::uint8_t> movable);
  void add_linkage(Linkage linkage, std::span<const JointRows<T, Space>> joints,
                   std::span<const std::pair<std::uint32_t, std::uint32_t>> bodies,
                   std::span<const std::uint32_t> closing);
  std::span<const Loop> loops_of(const Linkage& linkage) const {
    return std::span(loops_).subspan(linkage.first_loop, linkage.end_loop - linkage.first_loop);
  }
  std::span<LoopRow> rows_of(const Linkage& linkage) {
    return std::span(loop_rows_).subspan(linkage.first_row, linkage.rows);
  }
  void set_loop_rows(std::span<const JointRows<T, Space>> joints);
  void respond_to(const Linkage& linkage, const Loop& loop, const LoopRow& row);
  void factor_loops(const Linkage& linkage);
  void solve_loops(const Linkage& linkage, std::span<JointRows<T, Space>> joints,
                   std::span<SolverBody<T, Space>> bodies, bool bias);

  std::vector<Link> links_;  ///< those nearer to the root first
  std::vector<std::uint8_t> held_;
  bool holds_all_ = true;
  std::vector<Response> responses_;  ///< of each body
  std::vector<Linkage> linkages_;    ///< those with loops that are solved here
  std::vector<Loop> loops_;
  std::vector<LoopRow> loop_rows_;
  std::vector<T> loop_factors_;     ///< L D Lᵀ of each linkage's loops, by rows; the diagonal has 1 / D
  std::vector<T> loop_rates_;       ///< kept for its storage
  std::vector<Freedoms> velocity_;  ///< of each body, by an impulse of 1 on a loop's row; kept likewise
};

}  // namespace graze
