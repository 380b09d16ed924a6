#include "rays/bvh_lanes.hpp"

namespace graze::GRAZE_ISA {

using namespace tree;

template <class T>
void traverse_bvh(const BvhQuestion<T>& question) {
  /// A node with its children that the ray has still to visit, and the key of the first of them.
  struct alignas(64) Entry {
    float keys[width];
    const TreeNode<T>* node;
    std::int32_t key;
  };
  Entry stack[TreeNode<T>::deepest + 1];
  std::size_t waiting = 0;
  const BvhRay<T> bvh_ray(question);
  const TreeNode<T>* node = question.nodes;
  float limit = bvh_ray.key(question.end);
  Keys keys = crossed(bvh_ray, *node, limit);
  std::int32_t key = keys.least();
  for (;;) {
    if (key > (number_bits(limit) | Keys::place_bits)) {
      if (waiting == 0) return;
      const Entry& entry = stack[--waiting];
      node = entry.node;
      keys.load(entry.keys);
      key = entry.key;
      continue;
    }
    keys.remove(key);
    const auto place = static_cast<std::uint32_t>(key & Keys::place_bits);
    // The successor of this child is fetched while this one is processed.
    key = keys.least();
    fetch(question.nodes, question.leaves, *node, static_cast<std::uint32_t>(key & Keys::place_bits));
    if (place < node->inner) {
      // Written in any case and kept if there are more children, which is unpredictable.
      stack[waiting].node = node;
      stack[waiting].key = key;
      keys.store(stack[waiting].keys);
      waiting += key != absent;
      node = question.nodes + node->first_child + place;
      keys = crossed(bvh_ray, *node, limit);
      key = keys.least();
      continue;
    }
    const PackedLeaf& leaf = question.leaves[node->first_leaf + place - node->inner];
    const std::uint32_t first = node->first_of(place);
    std::uint32_t bits = left(bvh_ray, *node, leaf) & ((1u << node->pieces_of(place)) - 1);
    for (; bits != 0; bits &= bits - 1) {
      limit = bvh_ray.key(question.found(question.owner, first + first_bit(bits)));
      if (!(limit > 0)) return;
    }
  }
}

template void traverse_bvh(const BvhQuestion<float>&);
template void traverse_bvh(const BvhQuestion<double>&);

}  // namespace graze::GRAZE_ISA
