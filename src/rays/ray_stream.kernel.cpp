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
  using Leaf = std::uint32_t;
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
    at = inner ? node.first_child + place : at;
    leaf = node.first_leaf + place - node.inner;
    return inner;
  }
  template <class Add>
  [[gnu::always_inline]] void each(const BvhRay<T>& bvh_ray, Ref at, Leaf number, const Add& add) const {
    const PackedLeaf& leaf = question.leaves[number];
    std::uint32_t bits = left(bvh_ray, question.nodes[at], leaf) & ((1u << leaf.count) - 1);
    const auto next = [&](bool really) __attribute__((always_inline)) {
      const std::uint32_t lane = first_bit(bits | 8) & 3;
      for (std::uint32_t corner : leaf.corners[lane]) __builtin_prefetch(question.points + 3 * std::size_t{corner});
      add(lane, really);
    };
    // Mostly none or one.
    next(bits != 0);
    while ((bits &= bits - 1) != 0) next(true);
  }

  struct Triangle {
    const T* points[3];
    [[gnu::always_inline]] T operator()(std::size_t corner, std::size_t axis) const { return points[corner][axis]; }
  };
  [[gnu::always_inline]] Triangle triangle(Leaf leaf, std::size_t lane) const {
    const std::uint32_t* corners = question.leaves[leaf].corners[lane];
    const auto point = [&](std::size_t k) __attribute__((always_inline)) {
      return question.points + 3 * std::size_t{corners[k]};
    };
    return {{point(0), point(1), point(2)}};
  }
  [[gnu::always_inline]] std::uint32_t piece(Leaf leaf, std::size_t lane) const {
    return question.order[question.leaves[leaf].first + lane];
  }
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
