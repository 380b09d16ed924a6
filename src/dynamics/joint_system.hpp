// The locked axes of all joints of an island, solved at once: a chain of any length holds as one joint does.
//
// Rows of one joint after the other agree only after many rounds, and what is left of a stiff chain swings itself up
// from sub-step to sub-step. Joints that make no loop have a tree of bodies. From its leaves to its root each joint
// ties all that hangs on it to the next body, whose response to an impulse is from then on that of the whole; from the
// root back to the leaves impulses are corrected by what was not known yet (Featherstone 1983, "The calculation of
// robot dynamics using articulated-body inertias"; Baraff 1996, "Linear-time dynamics using Lagrange multipliers").
// Responses are inverse masses, so that what cannot move or turn is no case of its own.
//
// Guarantee: the impulses make all rates of locked axes of the tree what is wanted, up to rounding, in time linear in
// the joints; a row that follows from others is left out. Joints that close a loop are not among them.
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
  /// Finds the trees: `bodies` has the two of each joint by their places, `movable` tells of each body. Bodies that
  /// nothing pushes are where trees begin.
  void prepare(std::span<const std::pair<std::uint32_t, std::uint32_t>> bodies, std::span<const std::uint8_t> movable);
  /// Whether a joint is of a tree; otherwise it closes a loop, or has nothing that moves.
  bool holds(std::size_t joint) const { return held_[joint] != 0; }
  /// Whether any joint is of no tree.
  bool has_loops() const { return links_.size() != held_.size(); }

  /// The responses where the joints' rows are now.
  void factor(std::span<const JointRows<T, Space>> joints, std::span<const SolverBody<T, Space>> bodies);
  /// One pass over all locked rows of the trees; with `bias` errors of position are corrected.
  void solve(std::span<JointRows<T, Space>> joints, std::span<SolverBody<T, Space>> bodies, bool bias);

 private:
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
  struct Response {
    std::array<Freedoms, freedoms> alone{};         ///< the body's inverse mass
    std::array<Freedoms, freedoms> inverse_mass{};  ///< that of the body and what hangs on it
    Freedoms change{}, pushed{};
  };

  static Freedoms pushed_by(const MeasuredRow<T, Space>& row, bool is_a);
  static Freedoms times(const std::array<Freedoms, freedoms>& matrix, const Freedoms& v);
  void tie(Link& link, const JointRows<T, Space>& joint);

  std::vector<Link> links_;  ///< those nearer to the root first
  std::vector<std::uint8_t> held_;
  std::vector<Response> responses_;  ///< of each body
};

}  // namespace graze
