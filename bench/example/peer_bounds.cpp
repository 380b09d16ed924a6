// The shortest library there is: bounding spheres. It shows what a peer needs (see ../peer.hpp), is built with the
// benchmarks as one more file of theirs, and is in no table: it only knows that pairs are apart, not that they touch.
#include "peer.hpp"

namespace graze::bench {

namespace {

class Bounds {
 public:
  static constexpr const char* name = "bounds";
  static constexpr bool single_precision = false;
  static std::string version() { return "1"; }

  bool prepare(std::span<const Pair> pairs) {
    for (const Pair& pair : pairs)
      pairs_.push_back({pair.a.pose.translation - pair.b.pose.translation, pair.a.reach() + pair.b.reach()});
    return true;
  }
  bool overlap(std::size_t i) { return distance(i) <= 0; }
  double distance(std::size_t i) { return length(pairs_[i].between) - pairs_[i].reach; }

 private:
  struct Spheres {
    Vec3d between;
    double reach;
  };
  std::vector<Spheres> pairs_;
};

const Registered<Bounds> registered;

}  // namespace

}  // namespace graze::bench
