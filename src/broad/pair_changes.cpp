#include "graze/pair_changes.hpp"

#include <algorithm>

#include "broad/boxes.hpp"

namespace graze {

namespace {

/// Takes an id out of a list in ascending order; `insert` puts one into it.
template <class Ids>
void erase(Ids& ids, std::uint32_t id) {
  auto* at = std::lower_bound(ids.begin(), ids.end(), id);
  std::copy(at + 1, ids.end(), at);
  ids.truncate(ids.size() - 1);
}
template <class Ids>
void put(Ids& ids, std::uint32_t id) {
  ids.push_back(id);
  for (std::size_t i = ids.size() - 1; i > 0 && ids[i - 1] > ids[i]; --i) std::swap(ids[i - 1], ids[i]);
}

}  // namespace

template <class T>
void PairChanges<T>::touch(std::uint32_t id) {
  if (id >= is_touched_.size()) {
    is_touched_.resize(std::size_t{id} + 1, 0);
    told_.resize(is_touched_.size());
    now_.resize(is_touched_.size());
  }
  if (!is_touched_[id]) touched_.push_back(id);
  is_touched_[id] = 1;
}

template <class T>
void PairChanges<T>::insert(std::uint32_t id, const Aabb<T>& box) {
  boxes_->insert(id, box);
  touch(id);
}
template <class T>
void PairChanges<T>::remove(std::uint32_t id) {
  boxes_->remove(id);
  touch(id);
}
template <class T>
void PairChanges<T>::move(std::uint32_t id, const Aabb<T>& box) {
  boxes_->move(id, box);
  touch(id);
}

/// Gathers the partners of each touched id. The pairs are sorted, and so are the partners: the smaller ones come first.
template <class T>
void PairChanges<T>::gather_pairs_of_touched() {
  boxes_->moved_pairs(found_);
  for (const IdPair& p : found_)
    if (is_touched_[p.b]) now_[p.b].push_back(p.a);
  for (const IdPair& p : found_)
    if (is_touched_[p.a]) now_[p.a].push_back(p.b);
}

/// Compares the partners of a touched id with those that were reported. A pair of two touched ids is reported for the
/// smaller one; a partner that was not touched has its own list put right.
template <class T>
void PairChanges<T>::compare(std::uint32_t id, std::vector<IdPair>& begun, std::vector<IdPair>& ended) {
  const Ids &then = told_[id], &now = now_[id];
  const auto changed = [&](std::uint32_t other, bool began) {
    if (is_touched_[other] && other < id) return;
    (began ? begun : ended).push_back(ordered(id, other));
    if (is_touched_[other]) return;
    began ? put(told_[other], id) : erase(told_[other], id);
  };
  std::size_t i = 0, j = 0;
  while (i < then.size() || j < now.size()) {
    if (j == now.size() || (i < then.size() && then[i] < now[j]))
      changed(then[i++], false);
    else if (i == then.size() || now[j] < then[i])
      changed(now[j++], true);
    else
      ++i, ++j;
  }
}

template <class T>
void PairChanges<T>::find(std::vector<IdPair>& begun, std::vector<IdPair>& ended) {
  begun.clear(), ended.clear();
  gather_pairs_of_touched();
  for (const std::uint32_t id : touched_) compare(id, begun, ended);
  for (const std::uint32_t id : touched_) {
    std::swap(told_[id], now_[id]);
    now_[id].clear();
    is_touched_[id] = 0;
  }
  touched_.clear();
  std::sort(begun.begin(), begun.end());
  std::sort(ended.begin(), ended.end());
}

template <class T>
std::size_t PairChanges<T>::memory() const {
  return boxes_->memory() + (told_.capacity() + now_.capacity()) * sizeof(Ids) +
         touched_.capacity() * sizeof(std::uint32_t) + is_touched_.capacity() + found_.capacity() * sizeof(IdPair);
}

template class PairChanges<float>;
template class PairChanges<double>;

}  // namespace graze
