#include "rays/ray_stream.hpp"

#include "rays/ray_stream_lanes.hpp"

namespace graze::GRAZE_ISA {

using namespace ray_streams;

namespace {

/// The surface for `RayStream`.
template <class T>
struct MeshSurface {
  using Scalar = T;
  using Ref = std::uint32_t;
  struct Leaf {
    std::uint32_t number, lane;  ///< lane: in its node
  };
  using Piece = std::uint32_t;  ///< a triangle's number
  static constexpr int children = width;
  static constexpr std::size_t most = PackedLeaf::lanes, deep = 12;  // trees of a million triangles need ten

  const rays::BlockMesh<T>& question;

  [[gnu::always_inline]] Ref root() const { return 0; }
  [[gnu::always_inline]] Keys open(const BvhRay<T>& bvh_ray, Ref at, float limit) const {
    return crossed(bvh_ray, question.nodes[at], limit);
  }
  [[gnu::always_inline]] bool go(Ref& at, Leaf& leaf, std::uint32_t place) const {
    const TreeNode<T>& node = question.nodes[at];
    fetch(question.nodes, question.leaves, node, place);
    const bool inner = place < node.inner;
    __builtin_prefetch(question.order + node.first_of(place));  // an inner child has none: no branch
    at = inner ? node.first_child + place : at;
    leaf = {node.first_leaf + place - node.inner, place};
    return inner;
  }
  template <class Add>
  [[gnu::always_inline]] void each(const BvhRay<T>& bvh_ray, Ref at, Leaf leaf, const Add& add) const {
    const TreeNode<T>& node = question.nodes[at];
    const std::uint32_t* numbers = question.order + node.first_of(leaf.lane);
    std::uint32_t bits = left(bvh_ray, node, question.leaves[leaf.number]) & ((1u << node.pieces_of(leaf.lane)) - 1);
    const auto next = [&](bool really) __attribute__((always_inline)) {
      // The first in place of none.
      const std::uint32_t number = numbers[first_bit(bits | 1u << PackedLeaf::lanes) % PackedLeaf::lanes];
      __builtin_prefetch(question.triangles + 3 * std::size_t{number});
      add(number, really);
    };
    // Mostly none or one.
    next(bits != 0);
    while ((bits &= bits - 1) != 0) next(true);
  }

  [[gnu::always_inline]] const T* point(Piece piece, std::size_t corner) const {
    return question.points + 3 * std::size_t{question.triangles[3 * std::size_t{piece} + corner]};
  }
  [[gnu::always_inline]] void prefetch(Piece piece) const {
    for (std::size_t k = 0; k < 3; ++k) __builtin_prefetch(point(piece, k));
  }
  struct Triangle {
    const T* points[3];
    [[gnu::always_inline]] T operator()(std::size_t corner, std::size_t axis) const { return points[corner][axis]; }
  };
  [[gnu::always_inline]] Triangle triangle(Piece piece) const {
    return {{point(piece, 0), point(piece, 1), point(piece, 2)}};
  }
  [[gnu::always_inline]] std::uint32_t number(Piece piece) const { return piece; }
};

}  // namespace

template <class T>
[[gnu::flatten]] void block_at_mesh(rays::RayBlock& block, std::size_t count, const rays::BlockMesh<T>& mesh,
                                    std::uint32_t* pieces) {
  cast_block(block, count, MeshSurface<T>{mesh}, pieces);
}

template void block_at_mesh(rays::RayBlock&, std::size_t, const rays::BlockMesh<float>&, std::uint32_t*);
template void block_at_mesh(rays::RayBlock&, std::size_t, const rays::BlockMesh<double>&, std::uint32_t*);

}  // namespace graze::GRAZE_ISA
