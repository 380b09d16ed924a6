#include "mpi/shared_scene.hpp"

#include <algorithm>

namespace graze::cli {

namespace {

/// The number of parts that a rank keeps beside each other: those around a corner of eight.
constexpr std::size_t most_kept = 8;

std::vector<std::uint64_t> firsts_of(MPI_Comm comm, std::vector<std::uint64_t> counts) {
  MPI_Allreduce(MPI_IN_PLACE, counts.data(), static_cast<int>(counts.size()), MPI_UINT64_T, MPI_SUM, comm);
  std::vector<std::uint64_t> firsts{0};
  for (const std::uint64_t count : counts) firsts.push_back(firsts.back() + count);
  return firsts;
}

/// A part's number and names, each after an "n" and before a zero, and one more zero.
std::string packed(std::size_t part, const std::vector<std::string>& names) {
  std::string text = std::to_string(part) + '\0';
  for (const std::string& name : names) text += 'n' + name + '\0';
  return text + '\0';
}

}  // namespace

std::vector<std::string> texts_on_first(mpi::Together& together, std::string text) {
  mpi::ByRank<char> to = together.nothing<char>();
  to[0].assign(text.begin(), text.end());
  std::vector<std::string> texts;
  for (const auto& some : together.exchange(to)) texts.emplace_back(some.begin(), some.end());
  if (mpi::rank_of(together.comm()) != 0) texts.clear();
  return texts;
}

SharedScene::SharedScene(mpi::Together& together, const std::vector<std::string>& files, const io::LoadOptions& options)
    : options_(options),
      own_(static_cast<std::size_t>(mpi::rank_of(together.comm()))),
      ranks_(static_cast<std::size_t>(mpi::size_of(together.comm()))) {
  together.alone([&] {
    for (const std::string& file : files) {
      for (io::ScenePart& part : io::scene_parts(file)) parts_.push_back(std::move(part));
      source_ += (source_.empty() ? "" : " + ") + std::filesystem::path(file).filename().string();
    }
  });
  together.meet();
  mpi::agree_on(together.comm(), "the scene", std::to_string(parts_.size()) + " parts of " + source_);
  std::vector<std::uint64_t> colliders(parts_.size()), bodies(parts_.size());
  std::string names;
  together.alone([&] {
    for (std::size_t i = own_; i < parts_.size(); i += ranks_) {
      const io::Scene& scene = part(i);
      colliders[i] = scene.colliders.size();
      bodies[i] = scene.bodies.size();
      notices_.insert(notices_.end(), scene.notices.begin(), scene.notices.end());
      for (const io::Body& body : scene.bodies) moves_ = moves_ || body.type != io::MotionType::fixed;
      names += packed(i, scene.collision_systems);
    }
  });
  together.meet();
  first_collider_ = firsts_of(together.comm(), std::move(colliders));
  first_body_ = firsts_of(together.comm(), std::move(bodies));
  MPI_Allreduce(MPI_IN_PLACE, &moves_, 1, MPI_CXX_BOOL, MPI_LOR, together.comm());
  // The names of collision systems in the order of the parts, so that their bits are those of the whole scene.
  std::string all;
  std::vector<std::vector<std::string>> by_part(parts_.size());
  for (const std::string& text : texts_on_first(together, names)) all += text;
  mpi::broadcast(together.comm(), all, 0);
  for (std::size_t at = 0; at < all.size();) {
    const auto next = [&] {
      const std::string word = all.c_str() + at;
      at += word.size() + 1;
      return word;
    };
    std::vector<std::string>& systems = by_part.at(std::stoul(next()));
    for (std::string word = next(); !word.empty(); word = next()) systems.push_back(word.substr(1));
  }
  for (const auto& some : by_part)
    for (const std::string& name : some)
      if (std::find(systems_.begin(), systems_.end(), name) == systems_.end()) systems_.push_back(name);
  systems_known_ = true;
  kept_.clear();
}

io::Scene SharedScene::read(std::size_t number) {
  io::Scene scene = io::load_part(parts_[number], options_);
  if (!systems_known_) return scene;
  io::Scene with_systems;
  with_systems.collision_systems = systems_;
  io::append(with_systems, std::move(scene));
  return with_systems;
}

const io::Scene& SharedScene::part(std::size_t number) {
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& k) { return k.part == number; });
  if (found == kept_.begin() && found != kept_.end()) return found->scene;
  if (found != kept_.end()) {
    Kept kept = std::move(*found);
    kept_.erase(found);
    kept_.push_front(std::move(kept));
  } else {
    if (kept_.size() == most_kept) kept_.pop_back();
    kept_.push_front({number, read(number)});
  }
  return kept_.front().scene;
}

const io::Collider& SharedScene::collider(std::uint64_t number, const io::Scene** in) {
  const auto behind = std::upper_bound(first_collider_.begin(), first_collider_.end(), number);
  const auto at = static_cast<std::size_t>(behind - first_collider_.begin()) - 1;
  const io::Scene& scene = part(at);
  if (in) *in = &scene;
  return scene.colliders.at(number - first_collider_[at]);
}

std::uint64_t SharedScene::body_of(std::uint64_t number) {
  const auto behind = std::upper_bound(first_collider_.begin(), first_collider_.end(), number);
  const auto at = static_cast<std::size_t>(behind - first_collider_.begin()) - 1;
  return first_body_[at] + part(at).colliders.at(number - first_collider_[at]).body;
}

}  // namespace graze::cli
