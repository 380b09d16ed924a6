#include <algorithm>
#include <string>
#include <unordered_map>

#include "graze/broad_phase.hpp"
#include "graze/error.hpp"

namespace graze {

namespace {

template <class T>
class SortAndSweep final : public BroadPhase<T> {
 public:
  void insert(std::uint32_t id, const Aabb<T>& box) override {
    check(box);
    if (!place_.emplace(id, entries_.size()).second)
      throw InvalidValue("id", "an id that is not in use", std::to_string(id));
    entries_.push_back({box, id});
  }

  void remove(std::uint32_t id) override {
    const std::size_t hole = at(id);
    place_.erase(id);
    if (hole + 1 != entries_.size()) {
      entries_[hole] = entries_.back();
      place_[entries_[hole].id] = hole;
    }
    entries_.pop_back();
  }

  void move(std::uint32_t id, const Aabb<T>& box) override {
    check(box);
    entries_[at(id)].box = box;
  }

  void pairs(std::vector<IdPair>& out) override {
    out.clear();
    const std::size_t axis = widest_axis();
    // Insertion keeps what is nearly sorted cheap; what is not falls back to the library's sort.
    const auto before = [axis](const Entry& a, const Entry& b) {
      return a.box.lower[axis] != b.box.lower[axis] ? a.box.lower[axis] < b.box.lower[axis] : a.id < b.id;
    };
    if (!std::is_sorted(entries_.begin(), entries_.end(), before)) {
      std::sort(entries_.begin(), entries_.end(), before);
      for (std::size_t i = 0; i < entries_.size(); ++i) place_[entries_[i].id] = i;
    }
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const Entry& a = entries_[i];
      for (std::size_t j = i + 1; j < entries_.size() && entries_[j].box.lower[axis] <= a.box.upper[axis]; ++j)
        if (const Entry& b = entries_[j]; overlap(a.box, b.box))
          out.push_back({std::min(a.id, b.id), std::max(a.id, b.id)});
    }
    std::sort(out.begin(), out.end());
  }

  void query(const Aabb<T>& box, std::vector<std::uint32_t>& out) const override {
    out.clear();
    for (const Entry& e : entries_)
      if (overlap(e.box, box)) out.push_back(e.id);
    std::sort(out.begin(), out.end());
  }

 private:
  struct Entry {
    Aabb<T> box;
    std::uint32_t id;
  };

  static void check(const Aabb<T>& box) {
    for (std::size_t i = 0; i < 3; ++i)
      if (!(box.lower[i] <= box.upper[i]))
        throw InvalidValue("box", "lower <= upper on every axis",
                           std::to_string(box.lower[i]) + " and " + std::to_string(box.upper[i]));
  }

  std::size_t at(std::uint32_t id) const {
    const auto found = place_.find(id);
    if (found == place_.end()) throw InvalidValue("id", "an id that was inserted", std::to_string(id));
    return found->second;
  }

  /// The axis along which the boxes' lower ends spread most, relative to the boxes' own lengths along it: that is
  /// where the fewest overlap. Infinite boxes do not vote.
  std::size_t widest_axis() const {
    double sum[3] = {}, square[3] = {};
    double voters = 0;
    for (const Entry& e : entries_) {
      const Vec3<T> center = e.box.center();
      if (!(max_abs(center) < std::numeric_limits<T>::infinity())) continue;
      ++voters;
      for (std::size_t i = 0; i < 3; ++i) {
        sum[i] += static_cast<double>(center[i]);
        square[i] += static_cast<double>(center[i]) * static_cast<double>(center[i]);
      }
    }
    std::size_t best = 0;
    double most = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      const double variance = voters > 0 ? square[i] / voters - (sum[i] / voters) * (sum[i] / voters) : 0;
      if (variance > most) {
        most = variance;
        best = i;
      }
    }
    return best;
  }

  std::vector<Entry> entries_;
  std::unordered_map<std::uint32_t, std::size_t> place_;
};

}  // namespace

template <class T>
std::unique_ptr<BroadPhase<T>> make_sort_and_sweep() {
  return std::make_unique<SortAndSweep<T>>();
}

template std::unique_ptr<BroadPhase<float>> make_sort_and_sweep();
template std::unique_ptr<BroadPhase<double>> make_sort_and_sweep();

}  // namespace graze
