// How far the answers of the plane are from the truth: that of the tests' figures, in extended precision.
#include "accuracy_plane.hpp"

#include <array>
#include <cstdio>

#include "largest_error.hpp"
#include "plane/moving_figures.hpp"
#include "table.hpp"

namespace graze::plane {

namespace {

using bench::LargestError;

constexpr std::array<const char*, figure_kinds> figure_names = {"circle",  "box",     "capsule", "tapered",
                                                                "segment", "polygon", "ellipse", "user's"};

struct PlaneErrors {
  LargestError apart, overlapping, depth, cast, impact;
};

/// A body's figure and where it is.
template <class T>
struct Standing {
  Figure<T> figure;
  Pose2<T> pose;
};

template <class T>
void ask_where(const Standing<T>& a, const Standing<T>& b, Wide size, PlaneErrors& errors) {
  const Wide so = swept_distance(a.figure, a.pose, b.figure, b.pose);
  const Wide told = distance(a.figure.shape, a.pose, b.figure.shape, b.pose).distance;
  (so > 0 ? errors.apart : errors.overlapping).add((told - so) / size);
  if (so >= 0) return;
  Manifolds<T> manifolds;
  contacts(a.figure.shape, a.pose, b.figure.shape, b.pose, T(0), manifolds);
  Wide deepest = 0;
  for (const auto& m : manifolds)
    for (const auto& p : m.points) deepest = std::min(deepest, Wide(p.distance));
  manifolds.empty() ? errors.depth.add_wrong() : errors.depth.add((deepest - so) / size);
}

/// How far apart or deep bodies are at the time of a hit. A miss of what meets by more than 2e-5 of the size is wrong,
/// and so is a hit after they were as deep.
template <class T>
void ask_when(const Standing<T>& a, const Velocity<T>& of_a, const Standing<T>& b, const Velocity<T>& of_b, Wide size,
              LargestError& errors) {
  const auto hit = cast<T>(a.figure.shape, a.pose, of_a, b.figure.shape, b.pose, of_b, T(1));
  if (hit && hit->t == T(0)) return;
  const MovingFigures<T> moving(a.figure, a.pose, of_a, b.figure, b.pose, of_b);
  Wide met_at = 0;
  const bool met = moving.stay_apart(hit ? Wide(hit->t) : 1, Wide(2e-5) * size, met_at) == Apart::met;
  if (met) return errors.add_wrong();
  if (hit) errors.add(moving.distance_at(hit->t) / size);
}

template <class T>
PlaneErrors ask_plane(int kind_a, int kind_b, std::size_t pairs) {
  std::mt19937 random(static_cast<unsigned>(1 + kind_a * figure_kinds + kind_b));
  std::uniform_real_distribution<double> uniform(-1, 1);
  PlaneErrors errors;
  for (std::size_t i = 0; i < pairs; ++i) {
    const double scale = std::array<double, 4>{1e-4, 0.01, 1, 1e5}[i % 4];
    const Standing<T> a{random_figure<T>(kind_a, scale, random), random_pose<T>(0.3 * scale, random)},
        b{random_figure<T>(kind_b, scale, random), random_pose<T>(0.6 * scale, random)},
        far{b.figure, random_pose<T>(2 * scale, random)};
    const Wide size = std::max(furthest_reach(a.figure), furthest_reach(b.figure));
    ask_where(a, b, size, errors);
    const auto number = [&](double reach) { return static_cast<T>(reach * uniform(random)); };
    const Vec2<T> way = a.pose.translation - far.pose.translation;
    const T x = way.x * T(2) + number(scale), y = way.y * T(2) + number(scale), turn = number(3), other = number(3);
    ask_when(a, {}, far, {{x, y}, T(0)}, size, errors.cast);
    ask_when(a, {{}, other}, far, {{x, y}, turn}, size, errors.impact);
  }
  return errors;
}

}  // namespace

void print_accuracy(std::size_t pairs, const std::regex& only) {
  bench::Table table({"largest, double / float", "apart", "overlapping", "depth", "cast", "impact"});
  for (int a = 0; a < figure_kinds; ++a)
    for (int b = a; b < figure_kinds; ++b) {
      const std::string name =
          std::string("plane ") + figure_names[std::size_t(a)] + "-" + figure_names[std::size_t(b)];
      if (!std::regex_search(name, only)) continue;
      const PlaneErrors wide = ask_plane<double>(a, b, pairs), narrow = ask_plane<float>(a, b, pairs);
      const auto both = [&](LargestError PlaneErrors::*query) {
        return (wide.*query).text() + " / " + (narrow.*query).text();
      };
      table.add({name.substr(6), both(&PlaneErrors::apart), both(&PlaneErrors::overlapping), both(&PlaneErrors::depth),
                 both(&PlaneErrors::cast), both(&PlaneErrors::impact)});
    }
  std::string text = table.text();
  while (text.ends_with("\n\n")) text.pop_back();
  std::printf(R"(
## The plane

%zu pairs of each two kinds of `graze::plane`, from 0.1 mm to 100 km, a third of them rounded. "Apart" and "overlapping"
are signed distances, "depth" is that of the deepest contact; "cast" is B moving without turning and "impact" both
turning: how far apart, or deep, they are at the time told. The truth is a search over all directions in extended
precision (`tests/plane/figures.hpp`); no contact deeper than 2e-5 of the size was found before a hit or where there was
none, or its share stands in brackets.

%s)",
              pairs, text.c_str());
}

}  // namespace graze::plane
