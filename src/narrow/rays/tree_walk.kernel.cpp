#include "narrow/rays/tree_lanes.hpp"

namespace graze::GRAZE_ISA {

using namespace tree;

template <class T>
void walk_tree(const TreeWalk<T>& question) {
  /// A node with those of its children that the ray has still to visit.
  struct alignas(64) Entry {
    float keys[width];
    const TreeNode<T>* node;
  };
  Entry stack[TreeNode<T>::deepest + 1];
  std::size_t waiting = 0;
  const Walk<T> walk(question);
  const TreeNode<T>* node = question.nodes;
  float limit = walk.key(question.end);
  Keys keys = crossed(walk, *node, limit);
  for (;;) {
    const std::int32_t key = keys.least();
    if (key > (number_bits(limit) | Keys::place_bits)) {
      if (waiting == 0) return;
      const Entry& entry = stack[--waiting];
      node = entry.node;
      keys.load(entry.keys);
      continue;
    }
    keys.remove(key);
    const auto place = static_cast<std::uint32_t>(key & Keys::place_bits);
    if (place < node->inner) {
      // Written in any case and kept if there is more to come: which is hard to foresee.
      stack[waiting].node = node;
      keys.store(stack[waiting].keys);
      const std::int32_t next = keys.least();
      waiting += next != absent;
      fetch(question.nodes, question.leaves, *node, static_cast<std::uint32_t>(next & Keys::place_bits));
      node = question.nodes + node->first_child + place;
      keys = crossed(walk, *node, limit);
      continue;
    }
    const PackedLeaf& leaf = question.leaves[node->first_leaf + place - node->inner];
    std::uint32_t bits = left(walk, *node, leaf) & ((1u << leaf.count) - 1);
    for (; bits != 0; bits &= bits - 1) {
      limit = walk.key(question.found(question.owner, leaf, first_bit(bits)));
      if (!(limit > 0)) return;
    }
  }
}

template void walk_tree(const TreeWalk<float>&);
template void walk_tree(const TreeWalk<double>&);

}  // namespace graze::GRAZE_ISA
