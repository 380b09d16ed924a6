// The pair routines that run across lanes: many pairs of two kinds of shapes at once, compiled for each instruction
// set.
//
// Guarantee: what comes out for a pair is a function of that pair alone: the same bits at every level, in any order,
// with any neighbours, one pair or many.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "graze/batch_contacts.hpp"
#include "graze/compact_contacts.hpp"
#include "graze/contact.hpp"
#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "simd/dispatch.hpp"

namespace graze {

/// Two shapes in place, as kernels load them: `a` and `b` are the concrete shapes of the kernel's two kinds.
template <class T>
struct PairRef {
  const void *a, *b;
  const Pose<T>*pose_a, *pose_b;
  T margin;  ///< up to where contacts are wanted
};

/// Pairs in four rows, of shapes of one kind a side and of their poses: those of a pair stand at its place in each.
template <class T>
struct PairRows {
  const void *a, *b;
  const Pose<T>*pose_a, *pose_b;
};

template <class S>
struct SegmentContact;  // pairs/segment_contact.hpp

/// Where a kernel writes what it finds of pairs in rows: of each pair an entry, of each that touches a manifold with
/// its point, and the places of those that it does not answer for, whose entry says that they are apart. So does that
/// of pairs whose sides lie along each other, which are listed with their places.
template <class T>
struct ContactRows {
  typename BatchContacts<T>::Pair* pairs;
  typename BatchContacts<T>::Group* manifolds;
  ContactPoint<T>* points;
  std::uint8_t *unknown, *side_places;
  SegmentContact<T>* sides;
  std::uint32_t first_manifold, first_point;  ///< the numbers that the first of these get
};
struct RowCounts {
  std::uint32_t touching, unknown, sides;
};

/// So many pairs at most are asked about at a time where the answer is a block of arrays, and so many points of each
/// are in one.
inline constexpr std::size_t block_pairs = 16, most_block_points = 8;

template <class S>
struct BoxReferenceAxis;  // pairs/box_box/reference_axis.hpp
template <class S>
struct TriangleReferenceAxis;  // pairs/box_triangle.hpp
template <class S>
struct ContactSlots;  // pairs/box_box/clip_faces.hpp
template <class S>
struct PlacedTriangle;  // pairs/triangle_triangle_distance.hpp
template <class S>
struct TriangleDistance;
template <class S>
struct TriangleAxes;
template <class T>
struct FoundTriangles;  // pairs/triangle_triangle/contacts.hpp
struct AnswerRounding;

/// The contacts of up to `block_pairs` pairs: of those that are known a manifold each, and its points, those of a pair
/// one behind the other, pair after pair; as a batch has them in the form of its answer.
template <class T, class Form = BatchContacts<T>>
struct PointBlock {
  using Group = typename Form::Group;
  using Point = typename decltype(Form::points)::value_type;
  /// Room for what kernels write behind the last point.
  static constexpr std::size_t room = (most_block_points + 1) * block_pairs;

  // Where to write to; there is room for `block_pairs` and for `room`.
  Group* manifolds;
  Point* points;
  std::uint32_t first_point;   ///< the number of the first of the points
  const std::uint32_t* pairs;  ///< numbers of the pairs, where the form has them; as many as lanes take are read

  std::uint32_t known;                        ///< the `k`-th pair is: bit k
  std::uint32_t manifold_count, point_count;  ///< of all
  bool any_twice;                             ///< two points of a pair have the same features
};
template <class T>
using CompactBlock = PointBlock<T, CompactContacts<T>>;

/// Pairs of boxes within their margins, as the kernel for axes hands them on to the one for points: of each number that
/// this takes a column, in which the pairs stand one behind the other.
template <class T>
struct alignas(64) MetBoxes {
  /// So many pairs are asked about at a time; of floats they, those that are left over and what kernels write behind
  /// the last stay within the smallest cache.
  static constexpr std::size_t most = 128, room = most + 2 * block_pairs;
  enum Column : std::size_t {
    half_a,
    half_b = half_a + 3,
    translation = half_b + 3,
    rotation = translation + 3,
    clipping = rotation + 9,
    limits = clipping + 7,
    distance = limits + 4,
    columns
  };

  T number[columns][room];
  std::uint32_t place[room];
  std::size_t first = 0, count = 0;  ///< of those that wait: the one whose turn is next, and the end
};

/// The contact of two shapes that touch in one point at most.
template <class T>
struct PointContact {
  ContactPoint<T> point;
  Vec3<T> normal;
};
/// What is to be known of two shapes before their contact is read; `lying`: it is the next of a list of
/// `SegmentContact`.
enum class Meeting : std::uint8_t { apart, touching, unknown, lying };

/// The points of contact of up to `block_pairs` bodies on half-spaces; see `Rest`.
template <class T>
struct HalfSpaceBlock {
  using Column = T[block_pairs];
  Column distance, up[3], filled;
  struct Slot {
    Column of_body[3], of_plane[3], distance, corner;
  } slots[4];
};

/// Has the lines of so many records brought near, which may be behind the end of an array: to be read, or to be
/// written. Neither waits for a line then: of batches that are larger than the cache a quarter of the time.
template <bool to_write, class Record>
[[gnu::always_inline]] inline void fetch_lines(const Record* first, std::size_t count) {
  constexpr std::size_t line = 64;
  const auto begin = reinterpret_cast<std::uintptr_t>(first), end = begin + count * sizeof(Record);
  for (std::uintptr_t at = begin; at < end; at += line)
    __builtin_prefetch(reinterpret_cast<const void*>(at), to_write);  // NOLINT(performance-no-int-to-ptr): never read
}

/// `count` rounded up to what the widest registers hold.
constexpr std::size_t bundled(std::size_t count) { return (count + 15) / 16 * 16; }

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// The axes of up to `MetBoxes::most` pairs of boxes, whose places are counted from `place` on: appends those
    /// within their margins or not regular, and writes the places of the others to `apart`; how many. Of those in `met`
    /// only less than a block may wait.
    template <class T> std::size_t box_axes(const PairRef<T>* pairs, std::size_t count, std::uint32_t place,
                                            MetBoxes<T>& met, std::uint32_t* apart);
    /// The same of pairs in rows; there are `bundled(count)` rows to read.
    template <class T> std::size_t box_row_axes(const PairRows<T>& rows, std::size_t count, T margin,
                                                std::uint32_t place, MetBoxes<T>& met, std::uint32_t* apart);
    /// The points of the next `count` <= `block_pairs` of these. Behind them there are numbers for the lanes that stay
    /// empty.
    template <class T> void box_points(const MetBoxes<T>& met, std::size_t count, PointBlock<T>& block);
    /// Their points in few bytes.
    template <class T> void box_compact_points(const MetBoxes<T>& met, std::size_t count, CompactBlock<T>& block);
    /// The axes of pairs of a box and a triangle, and the points of up to `block_pairs` along them.
    template <class T> void triangle_axes(const PairRef<T>* pairs, std::size_t count, TriangleReferenceAxis<T>* axes);
    template <class T> void triangle_points(const PairRef<T>* pairs, const TriangleReferenceAxis<T>* axes, std::size_t count,
                                            PointBlock<T>& points);
    /// Both for one pair, given as its cores: the distance; where that is more than the margin, of the manifold only
    /// the normal.
    template <class T> T triangle_contact(const PairRef<T>& pair, ContactSlots<T>& manifold);
    /// The axis of one pair of boxes, and its points where it is within its margin: whether it is. Of boxes that are
    /// not regular too, and the points are not known.
    template <class T> bool box_contact(const PairRef<T>& pair, BoxReferenceAxis<T>& choice, ContactSlots<T>& found);
    /// The contacts of pairs that `is_sphere_capsule_pair` names, without rounding radii beside their own, capsules
    /// even and with a length. There is room for `bundled(count)`, all of which may be written; `sides` is the list of
    /// those that lie.
    template <class A, class B, class T> void sphere_capsule_contacts(const PairRef<T>* pairs, std::size_t count,
                                                             PointContact<T>* contacts, Meeting* meetings,
                                                             SegmentContact<T>* sides);
    /// The same of pairs in rows, of any capsules and boxes. `turned`: A is the second of the two for whoever asks.
    /// There are `bundled(count)` rows to read, and there is room for as many manifolds and points.
    template <class A, class B, class T> void sphere_capsule_row_contacts(const PairRows<T>& rows, std::size_t count, T margin,
                                                                 bool turned, const ContactRows<T>& to,
                                                                 RowCounts& found);
    /// As `sphere_capsule_contacts`, of capsules with boxes.
    template <class T> void capsule_box_contacts(const PairRef<T>* pairs, std::size_t count,
                                                 PointContact<T>* contacts, Meeting* meetings,
                                                 SegmentContact<T>* sides);
    /// The points of up to `block_pairs` balls, untapered capsules with a length, boxes or triangles on half-spaces,
    /// all without a margin.
    template <class A, class T> void half_space_slots(const PairRef<T>* pairs, std::size_t count, HalfSpaceBlock<T>& points);
    /// The distances of pairs in rows, of those that `is_sphere_capsule_pair` names and of balls, capsules, boxes and
    /// triangles with half-spaces. `turned`: A is the second of the two for whoever asks. There are `bundled(count)`
    /// rows to read. Returns how many it does not answer for, whose places it writes to `unknown`.
    template <class A, class B, class T> std::uint32_t row_distances(const PairRows<T>& rows, std::size_t count,
                                                                     bool turned, Distance<T>* distances,
                                                                     std::uint8_t* unknown);
    /// Whether the same pairs, boxes, and boxes with triangles touch: 1 or 0.
    template <class A, class B, class T> std::uint32_t row_overlaps(const PairRows<T>& rows, std::size_t count,
                                                                    std::uint8_t* touch, std::uint8_t* unknown);
    /// Whether one pair of boxes touches; nothing of those that are not regular. `faces_only`: as of `boxes_apart`.
    template <class T> std::optional<bool> boxes_touch(const Box<T>& a, const Pose<T>& pose_a, const Box<T>& b,
                                                       const Pose<T>& pose_b, bool faces_only);
    /// Both of boxes and of what is asked as one (`box_box/box_like_pair.hpp`), in double.
    template <class A, class B, class T> std::uint32_t box_row_distances(const PairRows<T>& rows, std::size_t count,
                                                                         bool turned, Distance<T>* distances,
                                                                         std::uint8_t* unknown);
    template <class A, class B, class T> std::uint32_t box_like_row_overlaps(const PairRows<T>& rows, std::size_t count,
                                                                             std::uint8_t* touch,
                                                                             std::uint8_t* unknown);
    /// Contacts, distances and overlaps, as those above, of balls or capsules with triangles, in double. `unknown`:
    /// also those that the general path has to answer for.
    template <class A, class T> void sphere_capsule_triangle_contacts(const PairRef<T>* pairs, std::size_t count,
                                                             PointContact<T>* contacts, Meeting* meetings,
                                                             SegmentContact<T>* sides);
    template <class A, class T> void sphere_capsule_triangle_row_contacts(const PairRows<T>& rows, std::size_t count, T margin,
                                                                 bool turned, const ContactRows<T>& to,
                                                                 RowCounts& found);
    template <class A, class T> std::uint32_t sphere_capsule_triangle_row_distances(const PairRows<T>& rows, std::size_t count,
                                                                           bool turned, Distance<T>* distances,
                                                                           std::uint8_t* unknown);
    template <class A, class T> std::uint32_t sphere_capsule_triangle_row_overlaps(const PairRows<T>& rows, std::size_t count,
                                                                          std::uint8_t* touch, std::uint8_t* unknown);
    /// The distances of triangles, in double.
    template <class T> std::uint32_t triangle_row_distances(const PairRows<T>& rows, std::size_t count, bool turned,
                                                            Distance<T>* distances, std::uint8_t* unknown);
    /// Of pairs of triangles without a margin how far they are apart, and the points of up to `block_pairs` of those
    /// within their margins.
    template <class T> void triangle_pair_distances(const PairRef<T>* pairs, std::size_t count,
                                                    FoundTriangles<T>* found);
    template <class T> void triangle_pair_points(const PairRef<T>* pairs, const FoundTriangles<T>* found,
                                                 std::size_t count, PointBlock<T>& points);
    /// The distance of one pair of triangles, or that it is more than `enough`.
    void triangle_pair(const PlacedTriangle<double>& a, const PlacedTriangle<double>& b, double enough,
                       TriangleDistance<double>& found);
    /// The same, and of those within the margin the axes and, of triangles that are not rounded, the points.
    void triangle_pair_contact(const PlacedTriangle<double>& a, const PlacedTriangle<double>& b, double enough,
                               double margin, const AnswerRounding& rounding, TriangleDistance<double>& found,
                               TriangleAxes<double>& axes, ContactSlots<double>& points);)
// clang-format on

}  // namespace graze
