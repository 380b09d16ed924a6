// Saving and going back.
//
// A step depends on what stands where, how it moves, and on the impulses of the last step's contacts. The latter belong
// to points that the world finds anew where the last update found them: so bodies are put there first.
#include <string>

#include "dynamics/simulation_parts.hpp"

namespace graze {

template <class T>
struct State<T>::Kept {
  const void* of = nullptr;  ///< the simulation
  std::vector<SimulatedBody<T>> bodies;
  std::vector<JointPlace<T>> joints;
  std::vector<BodyId> ids;
  std::vector<Pose<T>> poses, found_at;
  std::vector<Vec3<T>> linear, angular;
  std::vector<Vec3<T>> impulses;  ///< in the order of pairs
  SimulationSettings<T> settings;
  StepReport<T> last;
  T last_step{};
};

template <class T>
State<T>::State() = default;
template <class T>
State<T>::~State() = default;
template <class T>
State<T>::State(const State& other) : kept_(other.kept_ ? std::make_unique<Kept>(*other.kept_) : nullptr) {}
template <class T>
State<T>::State(State&&) noexcept = default;
template <class T>
State<T>& State<T>::operator=(const State& other) {
  if (this != &other) kept_ = other.kept_ ? std::make_unique<Kept>(*other.kept_) : nullptr;
  return *this;
}
template <class T>
State<T>& State<T>::operator=(State&&) noexcept = default;

namespace {

template <class T>
std::vector<BodyId> ids_of(const World<T>& world) {
  std::vector<BodyId> ids;
  for (std::uint32_t i = 0; i < world.bodies().size(); ++i)
    if (world.bodies().alive()[i] != 0) ids.push_back(world.bodies().id(i));
  return ids;
}

/// Calls `f` with every point, pair by pair: an order that the pairs alone decide.
template <class T, class F>
void each_point(ContactArrays<T>& contacts, F&& f) {
  for (const ContactPair<T>& pair : contacts.pairs)
    for (const ContactManifold<T>& m : contacts.manifolds_of(pair))
      for (std::uint32_t i = 0; i < m.point_count; ++i) f(contacts.points[m.first_point + i]);
}

template <class T>
bool same_joints(const std::vector<JointPlace<T>>& a, const std::vector<JointPlace<T>>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].alive != b[i].alive || a[i].generation != b[i].generation) return false;
  return true;
}

}  // namespace

template <class T>
State<T> Simulation<T>::save() const {
  SimulationParts<T>& p = *parts_;
  const BodyArrays<T>& all = p.world.bodies();
  State<T> state;
  state.kept_ = std::make_unique<typename State<T>::Kept>();
  auto& kept = *state.kept_;
  kept.of = parts_.get();
  kept.bodies = p.bodies;
  kept.joints = p.joints;
  kept.ids = ids_of(p.world);
  kept.poses.assign(all.poses().begin(), all.poses().end());
  kept.linear.assign(all.linear().begin(), all.linear().end());
  kept.angular.assign(all.angular().begin(), all.angular().end());
  // Bodies that were added since the last update have not been found anywhere yet.
  kept.found_at = p.found_at;
  for (std::size_t i = kept.found_at.size(); i < kept.poses.size(); ++i) kept.found_at.push_back(kept.poses[i]);
  each_point(p.world.contacts(), [&](const SolverPoint<T>& point) { kept.impulses.push_back(point.impulse); });
  kept.settings = p.settings;
  kept.last = p.last;
  kept.last_step = p.last_step;
  return state;
}

template <class T>
void Simulation<T>::restore(const State<T>& state) {
  SimulationParts<T>& p = *parts_;
  if (!state.kept_ || state.kept_->of != parts_.get())
    throw InvalidValue("state", "a state that this simulation saved", "another");
  const auto& kept = *state.kept_;
  if (kept.ids != ids_of(p.world)) throw InvalidValue("state", "one of the bodies that there are now", "others");
  if (!same_joints(kept.joints, p.joints))
    throw InvalidValue("state", "one of the joints that there are now", "others");
  const auto put = [&](std::span<const Pose<T>> poses) {
    for (const BodyId id : kept.ids) p.world.move(id, poses[id.index], kept.linear[id.index], kept.angular[id.index]);
  };
  put(kept.found_at);
  p.world.update();
  std::size_t known = 0;
  each_point(p.world.contacts(), [&](SolverPoint<T>& point) {
    point.impulse = known < kept.impulses.size() ? kept.impulses[known] : Vec3<T>{};
    ++known;
  });
  put(kept.poses);
  p.bodies = kept.bodies;
  p.joints = kept.joints;
  p.found_at = kept.found_at;
  p.settings = kept.settings;
  p.last = kept.last;
  p.last_step = kept.last_step;
}

#define GRAZE_STATE(T)                                                                                                 \
  template class State<T>;                                                                                             \
  template State<T> Simulation<T>::save() const;                                                                       \
  template void Simulation<T>::restore(const State<T>&);
GRAZE_STATE(float)
GRAZE_STATE(double)
#undef GRAZE_STATE

}  // namespace graze
