// The least that a user of the installed library writes: two balls, how far apart; and what takes classes and functions of
// the library as templates of its own types, of which a shared library may hide instances: batches and states as bytes.
#include <graze/graze.hpp>

namespace {

bool has_batches() {
  const std::vector<graze::Shaped> balls(2, graze::Sphere<double>(1));
  const std::vector<graze::Posed> poses{{}, {{0, 3, 0}, {}}};
  const graze::Bodies<double> bodies(balls, poses);
  const std::vector<graze::IdPair> pairs{{0, 1}};
  std::vector<graze::Distance<double>> found;
  graze::distance(graze::Batch<double>(bodies, bodies, pairs), found);
  return found.size() == 1 && found[0].distance == 1;
}

bool has_batches_of_the_plane() {
  const std::vector<graze::plane::Shaped> discs(2, graze::plane::Circle<double>(1));
  const std::vector<graze::plane::Pose2d> poses{{}, {{0, 3}, {}}};
  const graze::plane::Bodies<double> bodies(discs, poses);
  std::vector<graze::plane::Distance<double>> found;
  graze::plane::distance(graze::plane::Batch<double>(bodies, bodies), found);
  return found.size() == 2;
}

template <class Simulation, class Read>
bool has_states(Simulation&& simulation, const Read& read) {
  const auto before = simulation.state_hash();
  simulation.restore(read(graze::state_bytes(simulation.save())));
  return simulation.state_hash() == before;
}

}  // namespace

int main() {
  const graze::Shaped ball = graze::Sphere<double>(1);
  const graze::Distance<double> d = graze::distance(ball, {}, ball, graze::Posed{{0, 3, 0}, {}});
  const bool states =
      has_states(graze::Simulation<double>(), [](const std::string& b) { return graze::read_state<double>(b); }) &&
      has_states(graze::plane::Simulation<double>(),
                 [](const std::string& b) { return graze::read_state<double, graze::plane::Space<double>>(b); });
  const bool near = d.distance == 1 && d.normal == graze::Vec3d{0, 1, 0};
  return near && states && has_batches() && has_batches_of_the_plane() ? 0 : 1;
}
