#include <algorithm>
#include <numeric>

#include "broad/boxes.hpp"

namespace graze {

namespace {

template <class T>
class SortAndSweep final : public BroadPhase<T> {
 public:
  void insert(std::uint32_t id, const Aabb<T>& box) override { boxes_.insert(id, box); }
  void remove(std::uint32_t id) override { boxes_.remove(id); }
  void move(std::uint32_t id, const Aabb<T>& box) override { boxes_.move(id, box); }

  void pairs(std::vector<IdPair>& out) override { find(out, false); }
  void moved_pairs(std::vector<IdPair>& out) override { find(out, true); }
  std::uint64_t tests() const override { return tests_; }

  void query(const Aabb<T>& box, std::vector<std::uint32_t>& out) const override {
    boxes_.collect(out, [&](const Aabb<T>& other) { return overlap(other, box); });
  }
  void sweep(const Aabb<T>& box, const Vec3<T>& motion, std::vector<std::uint32_t>& out) const override {
    boxes_.collect(out, SweptBox<T>(box, motion));
  }
  std::size_t memory() const override { return boxes_.memory() + order_.capacity() * sizeof(order_[0]); }

 private:
  void find(std::vector<IdPair>& out, bool moved_only) {
    const std::size_t axis = widest_axis();
    if (order_.size() != boxes_.size()) {
      order_.resize(boxes_.size());
      std::iota(order_.begin(), order_.end(), 0u);
    }
    const auto before = [&](std::uint32_t i, std::uint32_t j) {
      return boxes_[i].box.lower[axis] < boxes_[j].box.lower[axis];
    };
    if (!std::is_sorted(order_.begin(), order_.end(), before)) std::sort(order_.begin(), order_.end(), before);
    tests_ = boxes_.collect_pairs(out, moved_only, [&](auto& test) {
      for (std::size_t i = 0; i < order_.size(); ++i) {
        const T end = boxes_[order_[i]].box.upper[axis];
        for (std::size_t j = i + 1; j < order_.size() && !(boxes_[order_[j]].box.lower[axis] > end); ++j)
          test(order_[i], order_[j]);
      }
    });
  }

  /// The axis along which the boxes' lower ends spread most, relative to the boxes' own lengths along it: that is
  /// where the fewest overlap. Infinite boxes do not count.
  std::size_t widest_axis() const {
    double sum[3] = {}, square[3] = {};
    double voters = 0;
    for (const auto& e : boxes_) {
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

  BoxTable<T> boxes_;
  std::vector<std::uint32_t> order_;
  std::uint64_t tests_ = 0;
};

}  // namespace

template <class T>
std::unique_ptr<BroadPhase<T>> make_sort_and_sweep() {
  return std::make_unique<SortAndSweep<T>>();
}

template std::unique_ptr<BroadPhase<float>> make_sort_and_sweep();
template std::unique_ptr<BroadPhase<double>> make_sort_and_sweep();

}  // namespace graze
