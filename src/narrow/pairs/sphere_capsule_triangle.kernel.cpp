// Balls and untapered capsules with triangles, a register of pairs at a time in double.
#include "narrow/batch/pair_bundle.hpp"
#include "narrow/batch/point_contacts.hpp"
#include "narrow/batch/row_answers.hpp"
#include "narrow/batch/sphere_capsule_rows.hpp"
#include "narrow/core/in_double.hpp"
#include "narrow/pairs/segment_lanes.hpp"
#include "narrow/pairs/sphere_capsule_triangle_contact.hpp"

namespace graze::GRAZE_ISA {

namespace {

using S = Lanes<double>;
template <class L>
using Triangles = Rounded<TriangleCore<L>, L>;

/// The contacts of a register of pairs, each compiled once for all callers.
[[gnu::noinline, gnu::flatten]] void answer(const Rounded<PointCore<S>, S>& ball, const Pose<S>& pose,
                                            const Triangles<S>& triangle, const Pose<S>& pose_triangle, const S& limit,
                                            OneContact<S>& found) {
  found = closest_triangle_contact(BallAndTriangle<S>(ball, pose, triangle, pose_triangle), limit);
}
[[gnu::noinline, gnu::flatten]] void answer(const Rounded<AxisCore<S>, S>& capsule, const Pose<S>& pose,
                                            const Triangles<S>& triangle, const Pose<S>& pose_triangle, const S& limit,
                                            OneContact<S>& found) {
  found = closest_triangle_contact(CapsuleAndTriangle<S>(capsule, pose, triangle, pose_triangle), limit);
}

[[gnu::noinline, gnu::flatten]] void answer_lying(const Rounded<AxisCore<S>, S>& capsule, const Pose<S>& pose,
                                                  const Triangles<S>& triangle, const Pose<S>& pose_triangle,
                                                  const CoreDistance<S>& at, const S& margin, const S::Mask& lies,
                                                  const AnswerRounding& rounded, SegmentContact<S>& found) {
  found = side_contact(capsule, pose, triangle, pose_triangle, at, margin, lies, rounded);
}

/// The contacts of the first `count` lanes. Parts are found for pairs within their margins only.
template <class T, class Core>
OneContact<Lanes<T>> contacts_of(const Rounded<Core, Lanes<T>>& a, const Pose<Lanes<T>>& pose_a,
                                 const Triangles<Lanes<T>>& b, const Pose<Lanes<T>>& pose_b, const Lanes<T>& margin,
                                 std::size_t count) {
  OneContact<S> found[parts_of<T>]{};
  visit_parts<T>(count, [&](auto part) {
    answer(in_double<part>(a), in_double<part>(pose_a), in_double<part>(b), in_double<part>(pose_b),
           before_rounding<T>(lanes_in_double<part>(margin)), found[part]);
  });
  const auto number = [&](const auto& of) {
    S parts[parts_of<T>];
    for (std::size_t i = 0; i < parts_of<T>; ++i) parts[i] = of(found[i]);
    return joined(parts);
  };
  const auto vector = [&](auto member) {
    return Vec3<Lanes<T>>{number([=](const OneContact<S>& c) { return (c.at.*member).x; }),
                          number([=](const OneContact<S>& c) { return (c.at.*member).y; }),
                          number([=](const OneContact<S>& c) { return (c.at.*member).z; })};
  };
  return {{number([](const OneContact<S>& c) { return c.at.distance; }), vector(&CoreDistance<S>::normal),
           vector(&CoreDistance<S>::a), vector(&CoreDistance<S>::b)},
          number([](const OneContact<S>& c) { return c.part_a; }),
          number([](const OneContact<S>& c) { return c.part_b; }),
          number([](const OneContact<S>& c) { return c.known; })};
}
template <std::size_t part, class L>
CoreDistance<S> distance_in_double(const CoreDistance<L>& d) {
  return {lanes_in_double<part>(d.distance), in_double<part>(d.normal), in_double<part>(d.a), in_double<part>(d.b)};
}

/// Writes the contacts of capsules that lie on their sides, for the given lanes, one behind the other.
template <class T>
void put_lying(const Rounded<AxisCore<Lanes<T>>, Lanes<T>>& a, const Pose<Lanes<T>>& pose_a,
               const Triangles<Lanes<T>>& b, const Pose<Lanes<T>>& pose_b, const OneContact<Lanes<T>>& c,
               const Lanes<T>& margin, std::uint32_t lying, SegmentContact<T>* to) {
  visit_parts<T>(lanes_of<T>, [&](auto part) {
    const std::uint32_t bits = lying >> (part * lanes_of<double>)&Chosen<double>::all;
    if (bits == 0) return;
    const CoreDistance<S> at = distance_in_double<part>(c.at);
    const S limit = lanes_in_double<part>(margin);
    SegmentContact<S> found;
    answer_lying(in_double<part>(a), in_double<part>(pose_a), in_double<part>(b), in_double<part>(pose_b), at, limit,
                 (lanes_in_double<part>(c.known) == S(0)) & (at.distance <= limit), answer_rounding<T>(), found);
    put_sides(found, bits, to);
    to += count_bits(bits);
  });
}

template <class A, class T>
using TriangleRows = RowBundle<A, Triangle<T>, T>;
template <class A, class T>
OneContact<Lanes<T>> contacts_of(const TriangleRows<A, T>& p, const Lanes<T>& margin, std::size_t count) {
  return contacts_of<T>(p.a.shapes, p.pose_a, p.b.shapes, p.pose_b, margin, count);
}

/// Calls `f(distances, filled, first)` for the bundles of rows; parts are not found.
template <class A, class T, class F>
std::uint32_t answer_distances(const PairRows<T>& rows, std::size_t count, std::uint8_t* unknown, const F& f) {
  const auto answer = [&](const TriangleRows<A, T>& pairs, std::size_t filled, std::size_t first) {
    const Lanes<T> nowhere(-std::numeric_limits<T>::infinity());
    const CoreDistance<Lanes<T>> found = contacts_of<A, T>(pairs, nowhere, filled).at;
    f(found, filled, first);
    return (found.distance > nowhere) & pairs.regular();
  };
  return answer_rows<A, Triangle<T>>(rows, count, unknown, answer);
}

}  // namespace

template <class A, class T>
[[gnu::flatten]] void sphere_capsule_triangle_contacts(const PairRef<T>* pairs, std::size_t count,
                                                       PointContact<T>* contacts, Meeting* meetings,
                                                       [[maybe_unused]] SegmentContact<T>* sides) {
  using Pairs = PairBundle<A, Triangle<T>, T>;
  for (std::size_t first = 0; first < count; first += Pairs::lanes) {
    const Pairs p(pairs + first, count - first);
    const auto c = contacts_of<T>(p.a, p.pose_a, p.b, p.pose_b, p.margin, p.count);
    const Lanes<T> meeting = put_all<A, Triangle<T>>(c, p.margin, Lanes<T>(T(0.5)), contacts + first, meetings + first);
    if constexpr (lies_on_sides<A>) {
      const std::uint32_t lying = lying_lanes<T>(meeting, p.count);
      if (lying == 0) continue;
      put_lying(p.a, p.pose_a, p.b, p.pose_b, c, p.margin, lying, sides);
      sides += count_bits(lying);
    }
  }
}

template <class A, class T>
[[gnu::flatten]] void sphere_capsule_triangle_row_contacts(const PairRows<T>& rows, std::size_t count, T margin,
                                                           bool turned, const ContactRows<T>& to,
                                                           RowCounts& all_found) {
  RowCounts counts{};
  for (std::size_t first = 0; first < count; first += lanes_of<T>) {
    const TriangleRows<A, T> p(rows, first);
    const auto c = contacts_of<A, T>(p, Lanes<T>(margin), count - first);
    put_rows(
        p, c, Lanes<T>(T(0.5)), margin, turned, first, count, to,
        counts, [&](std::uint32_t lying, SegmentContact<T> * sides) __attribute__((always_inline)) {
          if constexpr (lies_on_sides<A>)
            put_lying(p.a.shapes, p.pose_a, p.b.shapes, p.pose_b, c, Lanes<T>(margin), lying, sides);
        });
  }
  all_found = counts;
}

template <class A, class T>
[[gnu::flatten]] std::uint32_t sphere_capsule_triangle_row_distances(const PairRows<T>& rows, std::size_t count,
                                                                     bool turned, Distance<T>* distances,
                                                                     std::uint8_t* unknown) {
  return answer_distances<A, T>(rows, count, unknown,
                                [=](const CoreDistance<Lanes<T>>& found, std::size_t filled, std::size_t first) {
                                  put(turned ? mirrored(found) : found, filled, distances + first);
                                });
}

template <class A, class T>
[[gnu::flatten]] std::uint32_t sphere_capsule_triangle_row_overlaps(const PairRows<T>& rows, std::size_t count,
                                                                    std::uint8_t* touch, std::uint8_t* unknown) {
  return answer_distances<A, T>(rows, count, unknown,
                                [=](const CoreDistance<Lanes<T>>& found, std::size_t filled, std::size_t first) {
                                  put_bytes<T>((found.distance <= Lanes<T>(0)).bits & 1, filled, touch + first);
                                });
}

#define GRAZE_INSTANTIATE(A, T)                                                                                        \
  template void sphere_capsule_triangle_contacts<A<T>>(const PairRef<T>*, std::size_t, PointContact<T>*, Meeting*,     \
                                                       SegmentContact<T>*);                                            \
  template void sphere_capsule_triangle_row_contacts<A<T>>(const PairRows<T>&, std::size_t, T, bool,                   \
                                                           const ContactRows<T>&, RowCounts&);                         \
  template std::uint32_t sphere_capsule_triangle_row_distances<A<T>>(const PairRows<T>&, std::size_t, bool,            \
                                                                     Distance<T>*, std::uint8_t*);                     \
  template std::uint32_t sphere_capsule_triangle_row_overlaps<A<T>>(const PairRows<T>&, std::size_t, std::uint8_t*,    \
                                                                    std::uint8_t*);
GRAZE_INSTANTIATE(Sphere, float)
GRAZE_INSTANTIATE(Sphere, double)
GRAZE_INSTANTIATE(Capsule, float)
GRAZE_INSTANTIATE(Capsule, double)
#undef GRAZE_INSTANTIATE

}  // namespace graze::GRAZE_ISA
