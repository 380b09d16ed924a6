// graze-mpi collide: the contacts of a scene, by all ranks.
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstring>
#include <memory>

#include "cli/checked.hpp"
#include "cli/output.hpp"
#include "cli/pair_json.hpp"
#include "cli/scene_options.hpp"
#include "graze/geometry.hpp"
#include "graze/io/file.hpp"
#include "graze/io/owners_picture.hpp"
#include "graze/io/world_body.hpp"
#include "mpi/collide_report.hpp"
#include "mpi/commands.hpp"
#include "mpi/shared_scene.hpp"

namespace graze::cli {

namespace {

struct CollideArguments {
  SceneOptions scene;
  std::string precision = "double", contacts, svg;
  double margin = 0;
  std::string points;  ///< as it was given; empty where it was not
  std::vector<double> direction{1, 0.7, 1.2};
};

std::optional<std::size_t> points_of(const CollideArguments& options) {
  if (options.points.empty()) return std::nullopt;
  return checked_count("--points", options.points);
}

/// Whether a shape has data of its own, which a body takes along by number only.
template <class T>
bool is_shared(const Shape<T>& shape) {
  return shape.visit([](const auto& c) { return !std::is_trivially_copyable_v<std::decay_t<decltype(c)>>; });
}

template <class T>
class Collision {
 public:
  Collision(mpi::Together& together, SharedScene& scene, const CollideArguments& options)
      : together_(together),
        scene_(scene),
        world_(together.comm(),
               {.margin = static_cast<T>(options.margin), .allow = {}, .points_per_pair = points_of(options)}) {
    world_.share_from([&](std::uint64_t number) { return body(number).shape; });
    together_.alone([&] {
      scene_.each_own([&](std::uint64_t number) {
        Body<T> body = this->body(number);
        if (is_shared(body.shape)) body.shape = world_.shared(number);
        world_.add(number, body);
      });
    });
    // Costs of pairs are known after the first update: the second has the borders that follow from them.
    const int updates = mpi::size_of(together_.comm()) > 1 ? 2 : 1;
    for (int i = 0; i < updates; ++i) {
      together_.meet();
      world_.update();
    }
  }

  const mpi::World<T>& world() const { return world_; }
  /// Writes all pairs, one a line in the order of the colliders, as `graze collide --json` has them.
  void write_contacts(const std::string& file);
  void write_picture(const std::string& file, const Vec3d& direction);

 private:
  Body<T> body(std::uint64_t number) {
    const io::Scene* in = nullptr;
    const io::Collider& c = scene_.collider(number, &in);
    Body<T> body = io::world_body<T>(*in, c, scene_.moves() && in->bodies[c.body].type == io::MotionType::fixed);
    body.filter.group = -1 - static_cast<std::int32_t>(scene_.body_of(number));
    return body;
  }

  mpi::Together& together_;
  SharedScene& scene_;
  mpi::World<T> world_;
};

/// A collider in the list of the first rank: its name, and whether it is a trigger.
struct Known {
  std::string name;
  bool trigger = false;
};

std::vector<Known> all_known(mpi::Together& together, SharedScene& scene) {
  std::string mine;
  together.alone([&] {
    scene.each_own([&](std::uint64_t number) {
      const io::Collider& c = scene.collider(number);
      const std::uint64_t words[] = {number, c.trigger, c.name.size()};
      mine.append(reinterpret_cast<const char*>(words), sizeof words).append(c.name);
    });
  });
  std::vector<Known> known(mpi::rank_of(together.comm()) == 0 ? scene.colliders() : 0);
  for (const std::string& text : texts_on_first(together, std::move(mine)))
    for (std::size_t at = 0; at < text.size();) {
      std::array<std::uint64_t, 3> words{};
      std::memcpy(words.data(), text.data() + at, sizeof words);
      at += sizeof words;
      known.at(words[0]) = {text.substr(at, words[2]), words[1] != 0};
      at += words[2];
    }
  return known;
}

template <class T>
io::TouchingPair in_double(const mpi::Gathered<T>& found, const mpi::KeyedPair& pair, bool trigger) {
  io::TouchingPair out{
      static_cast<std::uint32_t>(pair.a), static_cast<std::uint32_t>(pair.b), pair.overlap, trigger, {}};
  for (std::uint32_t i = 0; i < pair.manifold_count; ++i) {
    const ContactManifold<T>& m = found.manifolds[pair.first_manifold + i];
    Manifold<double> manifold;
    manifold.normal = converted<double>(m.normal);
    for (std::uint32_t k = 0; k < m.point_count; ++k) {
      const SolverPoint<T>& p = found.points[m.first_point + k];
      manifold.points.push_back({converted<double>(p.a), converted<double>(p.b), static_cast<double>(p.distance),
                                 p.feature, static_cast<double>(p.weight)});
    }
    out.manifolds.push_back(std::move(manifold));
  }
  return out;
}

template <class T>
void Collision<T>::write_contacts(const std::string& file) {
  const std::vector<Known> known = all_known(together_, scene_);
  const mpi::Gathered<T> found = world_.gather();
  together_.alone([&] {
    if (mpi::rank_of(together_.comm()) != 0) return;
    io::WholeFileWriter out(file);
    for (const mpi::KeyedPair& p : found.pairs) {
      const Known &a = known[p.a], &b = known[p.b];
      Json line{{"a", a.name}, {"b", b.name}, {"colliderA", p.a}, {"colliderB", p.b}};
      line.update(
          json_of_touch(in_double(found, p, a.trigger || b.trigger), [](const Vec3d& v) { return json_of(v); }));
      out.write(line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
    }
    out.close();
  });
  together_.meet();
}

/// The bounds of all bounded bodies.
template <class T>
Aabbd bounds_of_all(MPI_Comm comm, const mpi::World<T>& world) {
  Aabbd all = Aabbd::empty();
  for (const mpi::Key key : world.keys()) {
    const Body<T> body = world.body(key);
    const Aabb<T> box = bounds(body.shape, body.pose);
    const Aabbd wide{converted<double>(box.lower), converted<double>(box.upper)};
    if (max_abs(wide.extent()) < 1e30) all = merged(all, wide);
  }
  MPI_Allreduce(MPI_IN_PLACE, &all.lower.x, 3, MPI_DOUBLE, MPI_MIN, comm);
  MPI_Allreduce(MPI_IN_PLACE, &all.upper.x, 3, MPI_DOUBLE, MPI_MAX, comm);
  return all;
}

template <class T>
void Collision<T>::write_picture(const std::string& file, const Vec3d& direction) {
  const auto rank = static_cast<std::uint32_t>(mpi::rank_of(together_.comm()));
  io::OwnersPicture picture(bounds_of_all(together_.comm(), world_), direction, scene_.colliders());
  std::string mine;
  together_.alone([&] {
    for (const mpi::Key key : world_.keys()) {
      const io::Scene* in = nullptr;
      const io::Collider& c = scene_.collider(key, &in);
      picture.add(c.shape, c.pose, in->bodies[c.body].type == io::MotionType::fixed, rank);
    }
    if (rank != 0) mine = picture.packed();
  });
  const std::vector<std::string> drawn = texts_on_first(together_, std::move(mine));
  struct Share {
    std::uint64_t bodies, ghosts;
    Aabbd region;
  };
  const Share share{world_.report().bodies, world_.report().ghosts, world_.region()};
  std::vector<Share> shares(static_cast<std::size_t>(mpi::size_of(together_.comm())));
  MPI_Gather(&share, sizeof share, MPI_BYTE, shares.data(), sizeof share, MPI_BYTE, 0, together_.comm());
  together_.alone([&] {
    if (rank != 0) return;
    for (const std::string& bytes : drawn) picture.add_packed(bytes);
    std::vector<io::OwnersPicture::Owner> owners;
    for (std::size_t i = 0; i < shares.size(); ++i)
      owners.push_back({fmt::format("rank {}: {}", i, counted(shares[i].bodies, "body")), shares[i].region});
    io::write_file(file,
                   picture.svg(fmt::format("{}: {} on {}", scene_.source(), counted(scene_.colliders(), "collider"),
                                           counted(shares.size(), "rank")),
                               owners));
  });
  together_.meet();
}

template <class T>
void collide(mpi::Together& together, SharedScene& scene, const CollideArguments& options, double reading) {
  Collision<T> collision(together, scene, options);
  const mpi::World<T>& world = collision.world();
  const std::uint64_t mine = world.report().pairs;
  std::uint64_t pairs = 0;
  MPI_Allreduce(&mine, &pairs, 1, MPI_UINT64_T, MPI_SUM, together.comm());
  if (!options.contacts.empty()) collision.write_contacts(options.contacts);
  if (!options.svg.empty()) collision.write_picture(options.svg, checked_direction(options.direction));
  print_report(together.comm(),
               fmt::format("{}: {}, {} in {}, {} in contact", scene.source(), counted(scene.parts(), "part"),
                           counted(scene.colliders(), "collider"), counted(scene.bodies(), "body"),
                           counted(pairs, "pair")),
               {world.report(), world.memory(), reading});
}

int run_collide(const CollideArguments& options) {
  mpi::Together together(MPI_COMM_WORLD);
  const io::Precision precision = precision_of(options.precision);
  mpi::agree_on(MPI_COMM_WORLD, "the files to write", "'" + options.contacts + "' and '" + options.svg + "'");
  together.alone([&] {
    checked_length("--margin", options.margin, precision);
    checked_direction(options.direction);
    points_of(options);
    check_ending("--svg", options.svg, ".svg");
    check_ending("--contacts", options.contacts, ".jsonl");
    check_output("--svg", options.svg, options.scene.files);
    if (mpi::rank_of(MPI_COMM_WORLD) != 0) return;
    for (const std::string& file : {options.svg, options.contacts})
      if (!file.empty()) io::check_writable(file);
  });
  together.meet();
  const auto begin = std::chrono::steady_clock::now();
  SharedScene scene(together, options.scene.files, options.scene.load_options());
  const std::chrono::duration<double> reading = std::chrono::steady_clock::now() - begin;
  std::string notices;
  for (const std::string& text : scene.notices()) notices += "note: " + text + "\n";
  for (const std::string& text : texts_on_first(together, notices)) fmt::print(stderr, "{}", text);
  if (precision == io::Precision::double_precision)
    collide<double>(together, scene, options, reading.count());
  else
    collide<float>(together, scene, options, reading.count());
  together.alone(flush_output);
  together.meet();
  return 0;
}

}  // namespace

Run add_collide(CLI::App& app) {
  auto options = std::make_shared<CollideArguments>();
  CLI::App* command = app.add_subcommand("collide", "Find the contacts of a scene that ranks share");
  options->scene.add_to(*command, false);
  command->add_option("--margin", options->margin, "Also find what is up to this far apart")->capture_default_str();
  command->add_option(
      "--points", options->points,
      "At most so many points of contact a pair: the deepest, and those that span most; by default all");
  command->add_option("--precision", options->precision, "Compute in double or float")
      ->check(CLI::IsMember({"double", "float"}))
      ->capture_default_str();
  command->add_option("--contacts", options->contacts,
                      "Write all pairs in contact, a JSON object a line as graze collide --json has them (.jsonl). The "
                      "first rank holds all of them, and the names of all colliders");
  command->add_option("--svg", options->svg, "Draw a picture of who owns what (.svg)");
  command->add_option("--direction", options->direction, "Where the picture is seen from: x,y,z")
      ->delimiter(',')
      ->expected(3)
      ->capture_default_str();
  command->footer(
      "The contacts are bit for bit those of graze collide, whatever the number of ranks. Printed is how the work was\n"
      "shared: bodies that live on each rank, those lent to it as ghosts, pairs that it found, bytes that it sent and\n"
      "holds, the balance, and the seconds of each stage. With more than one rank there are two updates, of which the\n"
      "first tells what pairs cost; the numbers are those of the second.\n\n"
      "A scene may be in parts: a glTF whose nodes reference tiles, {\"extras\": {\"grazeTile\": \"tiles/0.gltf\"}}. "
      "Each\n"
      "rank reads its share of the tiles, and of others only those whose meshes and hulls it needs;\n"
      "docs/many-machines.md describes them, examples/make_tiled_scene.py writes one.\n"
      "Exit code: 0, or 2 when a file or an option cannot be used or the ranks differ.\n\n"
      "Example:\n  mpirun -n 8 graze-mpi collide city.gltf --margin 0.01 --svg owners.svg --contacts contacts.jsonl");
  return [options] { return run_collide(*options); };
}

}  // namespace graze::cli
