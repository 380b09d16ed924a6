#include "graze/mpi/configurations.hpp"

#include <cmath>
#include <cstring>

#include "graze/error.hpp"
#include "graze/query.hpp"
#include "mpi/exchange.hpp"
#include "mpi/words.hpp"

namespace graze::mpi {

namespace {

constexpr std::size_t numbers_of_pose = 7;

/// A pose from the bytes of a file; nothing for one that no body could have.
template <class T>
std::optional<Pose<T>> pose_of(const char* bytes) {
  double n[numbers_of_pose];
  std::memcpy(n, bytes, sizeof n);
  const Pose<T> pose{{static_cast<T>(n[0]), static_cast<T>(n[1]), static_cast<T>(n[2])},
                     {static_cast<T>(n[3]), static_cast<T>(n[4]), static_cast<T>(n[5]), static_cast<T>(n[6])}};
  try {
    return Space<T>::checked(pose);
  } catch (const InvalidValue&) {
    return std::nullopt;
  }
}

/// The chain, the scene and the limit as words by which a journal identifies them: kinds, bounds and places.
template <class T>
std::string words_of_all(const Chain<T>& chain, const World<T>& scene, T limit) {
  std::string links, bodies;
  for (const Shape<T>& link : chain.links) links += words_of(link);
  for (const auto& [a, b] : chain.pairs) links += std::to_string(a) + "-" + std::to_string(b) + " ";
  const BodyArrays<T>& all = scene.bodies();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all.alive()[i] == 0) continue;
    const auto& [at, turn] = all.poses()[i];
    const T numbers[] = {at.x, at.y, at.z, turn.x, turn.y, turn.z, turn.w};
    bodies += words_of(all.shapes()[i]) + sum_of(std::span<const T>(numbers));
  }
  const auto sum = [](const std::string& words) { return sum_of(std::span<const char>(words)); };
  return std::to_string(chain.links.size()) + " links, " + std::to_string(chain.pairs.size()) + " pairs " + sum(links) +
         ", " + std::to_string(all.count()) + " bodies " + sum(bodies) + ", limit " +
         digits(static_cast<double>(limit)) + (sizeof(T) == sizeof(float) ? ", float" : ", double");
}

template <class T>
void check(const Chain<T>& chain, T limit) {
  if (!(limit >= T(0))) throw InvalidValue("limit", "a number >= 0", digits(static_cast<double>(limit)));
  if (chain.links.empty()) throw InvalidValue("chain.links", "at least one", "none");
  for (const auto& [a, b] : chain.pairs)
    if (std::max(a, b) >= chain.links.size() || a == b)
      throw InvalidValue("chain.pairs", "two links below " + std::to_string(chain.links.size()),
                         std::to_string(a) + " and " + std::to_string(b));
}

}  // namespace

template <class T>
NearestOfChain nearest_of_chain(const Chain<T>& chain, const World<T>& scene, std::span<const Pose<T>> poses, T limit) {
  NearestOfChain nearest;
  const auto links = static_cast<std::uint32_t>(chain.links.size());
  const auto take = [&](T distance, std::uint32_t link, std::uint32_t other) {
    if (distance > limit || static_cast<double>(distance) >= nearest.distance) return;
    nearest = {static_cast<double>(distance), link, other};
  };
  for (std::uint32_t i = 0; i < links; ++i) {
    // Bodies further than the nearest so far cannot become it; those that overlap all may.
    const double reach = std::max(0.0, std::min(static_cast<double>(limit), nearest.distance));
    if (const auto found = scene.closest(chain.links[i], poses[i], static_cast<T>(reach)))
      take(found->distance.distance, i, links + found->body.index);
  }
  for (const auto& [a, b] : chain.pairs)
    take(distance(chain.links[a], poses[a], chain.links[b], poses[b]).distance, a, b);
  return nearest;
}

template <class T>
SweepReport sweep_configurations(MPI_Comm comm, SweepSettings settings, const Chain<T>& chain, const World<T>& scene,
                                 std::ostream& stream, T limit) {
  Together together(comm);
  together.alone([&] { check(chain, limit); });
  together.meet();
  const std::size_t links = chain.links.size();
  settings.record_bytes = links * numbers_of_pose * sizeof(double);
  settings.kind += "; " + words_of_all(chain, scene, limit);
  std::vector<Pose<T>> poses(links);
  const auto answer = [&](std::string_view record, std::size_t, std::string& out) {
    NearestOfChain nearest;
    bool good = true;
    for (std::size_t i = 0; i < links && good; ++i) {
      const auto pose = pose_of<T>(record.data() + i * numbers_of_pose * sizeof(double));
      good = pose.has_value();
      if (good) poses[i] = *pose;
    }
    if (good)
      nearest = nearest_of_chain<T>(chain, scene, poses, limit);
    else
      nearest.distance = std::numeric_limits<double>::quiet_NaN();
    out.append(reinterpret_cast<const char*>(&nearest), sizeof nearest);
    return !good;
  };
  return sweep_lines(comm, settings, answer, stream);
}

#define GRAZE_INSTANTIATE(T)                                                                                           \
  template NearestOfChain nearest_of_chain(const Chain<T>&, const World<T>&, std::span<const Pose<T>>, T);             \
  template SweepReport sweep_configurations(MPI_Comm, SweepSettings, const Chain<T>&, const World<T>&, std::ostream&,  \
                                            T);
GRAZE_INSTANTIATE(float)
GRAZE_INSTANTIATE(double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::mpi
