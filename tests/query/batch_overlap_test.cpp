// Overlaps of batches: pairs that GJK answers for alone are told by portals, and the answers are the same.
#include <gtest/gtest.h>

#include "common/specimen.hpp"
#include "graze/batch.hpp"
#include "query/batch_mpr.hpp"

namespace graze::testing {
namespace {

/// Pairs of bodies, the i-th of A with the i-th of B.
template <class T>
struct HullSatCulling {
  std::vector<Shape<T>> a, b;
  std::vector<Pose<T>> pose_a, pose_b;

  void add(const Shape<T>& first, const Pose<T>& at, const Shape<T>& second, const Pose<T>& there) {
    a.push_back(first), pose_a.push_back(at);
    b.push_back(second), pose_b.push_back(there);
  }
  void expect_as_alone() const {
    const Bodies<T> first{std::span<const Shape<T>>(a), std::span<const Pose<T>>(pose_a)},
        second{std::span<const Shape<T>>(b), std::span<const Pose<T>>(pose_b)};
    std::vector<std::uint8_t> touch;
    overlap(Batch<T>(first, second), touch);
    for (std::size_t i = 0; i < a.size(); ++i)
      EXPECT_EQ(touch[i] != 0, overlap(a[i], pose_a[i], b[i], pose_b[i]))
          << "pair " << i << ": " << a[i].name() << ' ' << b[i].name() << ' '
          << distance(a[i], pose_a[i], b[i], pose_b[i]).distance;
  }
};

/// Calls `f(kind of A, kind of B)` for all.
template <class F>
void for_all_kinds(const F& f) {
  for (int a = 0; a < kind_count; ++a)
    for (int b = 0; b < kind_count; ++b) f(static_cast<Kind>(a), static_cast<Kind>(b));
}

/// Near each other, `far` from the origin, at every size.
template <class T>
void random_pairs(T scale, float far, unsigned seed) {
  Random random(seed);
  HullSatCulling<T> pairs;
  for_all_kinds([&](Kind a, Kind b) {
    const Vec3f middle = random_vector(random, far);
    for (int i = 0; i < 12; ++i) {
      const PlacedSpecimen p{random_specimen(a, 1, random), middle + random_vector(random, 0.6f),
                             random_rotation(random)},
          q{random_specimen(b, 1, random), middle + random_vector(random, 0.6f), random_rotation(random)};
      pairs.add(build<T>(p.specimen, scale), pose_of<T>(p, scale), build<T>(q.specimen, scale), pose_of<T>(q, scale));
    }
  });
  pairs.expect_as_alone();
}

TEST(BatchOverlap, AnswersAsAloneForAllKindsAtAnySizeAndPlace) {
  random_pairs<float>(1, 0, 1);
  random_pairs<double>(1, 0, 2);
  random_pairs<float>(1e-4f, 1000, 3);
  random_pairs<double>(1e4, 1000, 4);
  random_pairs<double>(1e-30, 1, 5);
}

TEST(BatchOverlap, AnswersAsAloneWhereShapesAreDegenerateOrInLine) {
  Random random(6);
  HullSatCulling<float> floats;
  HullSatCulling<double> doubles;
  for_all_kinds([&](Kind a, Kind b) {
    for (int i = 0; i < 16; ++i) {
      const PlacedSpecimen p = on_lattice(degenerate_specimen(a, 1, random), 1, random),
                           q = on_lattice(degenerate_specimen(b, 1, random), 1, random);
      floats.add(build<float>(p.specimen), pose_of<float>(p), build<float>(q.specimen), pose_of<float>(q));
      doubles.add(build<double>(p.specimen), pose_of<double>(p), build<double>(q.specimen), pose_of<double>(q));
    }
  });
  floats.expect_as_alone();
  doubles.expect_as_alone();
}

// Within what a portal can prove, on its rim and beyond.
TEST(BatchOverlap, AnswersAsAloneWhereShapesNearlyTouch) {
  Random random(7);
  HullSatCulling<double> pairs;
  for_all_kinds([&](Kind a, Kind b) {
    if (a == Kind::half_space || b == Kind::half_space) return;
    for (const double gap : {1e-8, 1e-7, 1e-6, 4e-6, 1e-5, 2e-5, 4e-5, 1e-4}) {
      const Shape<double> first = build<double>(random_specimen(a, 1, random)),
                          second = build<double>(random_specimen(b, 1, random));
      const Posed at{{}, converted<double>(random_rotation(random))};
      Posed there{converted<double>(random_vector(random, 1)), converted<double>(random_rotation(random))};
      const Distance<double> d = distance(first, at, second, there);
      for (const double wanted : {gap, -gap}) {
        const Vec3d touching = there.translation + d.normal * (wanted - d.distance);
        pairs.add(first, at, second, {touching, there.rotation});
      }
    }
  });
  pairs.expect_as_alone();
}

/// Columns of one kind of pairs, filled up.
MprPairs columns_of(Kind a, Kind b, Random& random) {
  static constexpr MprKinds<float> kinds;
  MprPairs pairs;
  for (std::size_t k = 0; k < mpr_chunk; ++k) {
    const auto put = [&](Kind kind, std::size_t core, std::size_t turn, MprPairs::Vertices& vertices) {
      const auto vertices_of = [](const Shape<float>& shape) {
        const auto* hull = shape.as<ConvexHull<float>>();
        return hull ? hull->data().vertices.size() : 0;
      };
      Shape<float> shape = build<float>(random_specimen(kind, 1, random));
      while (vertices_of(shape) > most_mpr_points) shape = build<float>(random_specimen(kind, 1, random));
      vertices.count[k] = static_cast<std::uint8_t>(vertices_of(shape));
      const float radius = shape.visit([&](const auto& concrete) {
        return kinds[shape.index()].put(&concrete, {pairs.column + core, k}) + shape.rounding();
      });
      MprPlace{pairs.column + turn, k}.put(random_rotation(random));
      return radius;
    };
    const float reach = put(a, MprPairs::of_a, MprPairs::turn_a, pairs.vertices_a) +
                        put(b, MprPairs::of_b, MprPairs::turn_b, pairs.vertices_b);
    MprPlace{pairs.column + MprPairs::reach, k}.put(0, reach);
    MprPlace{pairs.column + MprPairs::way, k}.put(0, random_vector(random, 1.2f));
  }
  const auto side = [](Kind kind) { return kind == Kind::hull ? MprShape::hull : MprShape::points; };
  pairs.fill_up(mpr_chunk, side(a), side(b));
  return pairs;
}

TEST(BatchOverlap, MprTellsOfNearlyAllAndTheSameAtEveryLevel) {
  Random random(8);
  std::size_t unknown = 0, apart = 0, asked = 0;
  const auto ask = [&]<MprShape A, MprShape B>(Kind a, Kind b) {
    const MprPairs pairs = columns_of(a, b, random);
    std::uint8_t expected[mpr_chunk];
    GRAZE_KERNEL(Isa::baseline, mpr_overlaps<A, B>)(pairs, mpr_chunk, expected);
    for (const Isa level : {Isa::avx2, Isa::avx512}) {
      if (!isa_available(level)) continue;
      std::uint8_t found[mpr_chunk];
      GRAZE_KERNEL(level, mpr_overlaps<A, B>)(pairs, mpr_chunk, found);
      EXPECT_TRUE(std::equal(found, found + mpr_chunk, expected)) << name_of(a) << ' ' << name_of(b);
    }
    unknown += static_cast<std::size_t>(std::count(expected, expected + mpr_chunk, 2));
    apart += static_cast<std::size_t>(std::count(expected, expected + mpr_chunk, 0));
    asked += mpr_chunk;
  };
  constexpr Kind sums[] = {Kind::capsule, Kind::tapered_capsule, Kind::box, Kind::rectangle, Kind::cylinder,
                           Kind::cone,    Kind::ellipsoid};
  constexpr Kind points[] = {Kind::sphere, Kind::segment, Kind::triangle};
  for (const Kind a : sums) {
    for (const Kind b : sums) ask.operator()<MprShape::sum, MprShape::sum>(a, b);
    for (const Kind b : points) ask.operator()<MprShape::sum, MprShape::points>(a, b);
    ask.operator()<MprShape::sum, MprShape::hull>(a, Kind::hull);
  }
  for (const Kind a : points) ask.operator()<MprShape::points, MprShape::hull>(a, Kind::hull);
  ask.operator()<MprShape::hull, MprShape::hull>(Kind::hull, Kind::hull);
  ask.operator()<MprShape::points, MprShape::points>(Kind::triangle, Kind::triangle);
  EXPECT_LT(unknown * 50, asked);
  EXPECT_GT(apart * 4, asked);
  EXPECT_GT((asked - apart) * 4, asked);
}

}  // namespace
}  // namespace graze::testing
