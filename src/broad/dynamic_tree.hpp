// The state of a dynamic tree between calls, beside its nodes, and the numbers that steer it.
#pragma once

#include <vector>

#include "broad/box_splits.hpp"
#include "broad/id_table.hpp"
#include "broad/pair_sort.hpp"
#include "graze/dynamic_tree.hpp"

namespace graze {

/// The share of boxes, one in so many, above which all pairs are found by one walk through the tree, in which
/// neighbours share most of the way, and not box by box.
constexpr std::size_t max_moved_share = 4;

template <class T>
struct DynamicTree<T>::Storage {
  IdTable ids;
  PairSort sort;
  std::vector<std::uint32_t> free_leaves, free_nodes;
  std::vector<std::uint32_t> moved, waiting, far;

  std::vector<double> built_area;       ///< of each node, when it was built
  std::vector<std::uint8_t> worn_mark;  ///< of each node: it is in the next list
  std::vector<std::uint32_t> worn;
  bool all_worn = false;
  std::size_t credit = 0;  ///< number of boxes that may be built anew

  struct Task {
    std::uint32_t node, begin, end;
    unsigned depth;
  };
  BoxSplits<T> splits;
  std::vector<Task> tasks;
  std::vector<std::uint32_t> order;  ///< of nodes being built, parents first

  std::vector<IdPair> known, found;  ///< the pairs of the last call, if `is_known`; and those of what moved since
  bool is_known = false, lost = false;
  std::vector<IdPair> pair_stack;
  std::uint64_t tests = 0;  ///< of the last call

  std::size_t memory() const {
    return ids.memory() + sort.memory() +
           (free_leaves.capacity() + free_nodes.capacity() + moved.capacity() + waiting.capacity() + far.capacity() +
            worn.capacity() + order.capacity()) *
               sizeof(std::uint32_t) +
           built_area.capacity() * sizeof(double) + worn_mark.capacity() + tasks.capacity() * sizeof(Task) +
           splits.items.capacity() * sizeof(typename BoxSplits<T>::Item) +
           (known.capacity() + found.capacity() + pair_stack.capacity()) * sizeof(IdPair);
  }
};

}  // namespace graze
