// The pair routines that run across lanes: many pairs of two kinds of shapes at once, compiled for each instruction
// set.
//
// Guarantee: the result for a pair is a function of that pair alone: the same bits at every level, in any order, with
// any neighbours, one pair or many.
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
  T margin;  ///< largest distance of contacts
};

/// Pairs in four rows, of shapes of one kind a side and of their poses: the i-th pair has the i-th entry of each.
template <class T>
struct PairRows {
  const void *a, *b;
  const Pose<T>*pose_a, *pose_b;
};

template <class S>
struct SegmentContact;  // pairs/segment_contact.hpp

/// Destination of a kernel's results for pairs in rows: for each pair an entry, for each that touches a manifold with
/// its point. Pairs without an answer are listed in `unknown`, and pairs of capsules side by side in `sides` with their
/// indices in `side_places`; the entries of both are those of disjoint pairs.
template <class T>
struct ContactRows {
  typename BatchContacts<T>::Pair* pairs;
  typename BatchContacts<T>::Group* manifolds;
  ContactPoint<T>* points;
  std::uint8_t *unknown, *side_places;
  SegmentContact<T>* sides;
  std::uint32_t first_manifold, first_point;  ///< the numbers of the first of these
};
struct RowCounts {
  std::uint32_t touching, unknown, sides;
};

/// Number of pairs passed in at a time where the answer is a block of arrays, and largest number of points of each.
inline constexpr std::size_t block_pairs = 16, most_block_points = 8;

template <class S>
struct BoxReferenceAxis;  // pairs/box_box/reference_axis.hpp
template <class S>
struct TriangleReferenceAxis;  // pairs/box_triangle/sat.hpp
template <class S>
struct ContactSlots;  // pairs/box_box/clip_box_faces.hpp
template <class S>
struct PlacedTriangle;  // pairs/triangle_triangle/distance.hpp
template <class S>
struct TriangleDistance;
template <class S>
struct TriangleAxes;
template <class T>
struct FoundTriangles;  // pairs/triangle_triangle/contacts.hpp
struct AnswerRounding;

/// The contacts of up to `block_pairs` pairs in the form of a batch's answer: a manifold for each known pair, and its
/// points, contiguous, pair after pair.
template <class T, class Form = BatchContacts<T>>
struct PointBlock {
  using Group = typename Form::Group;
  using Point = typename decltype(Form::points)::value_type;
  /// Capacity for points, including what kernels write behind the last one.
  static constexpr std::size_t room = (most_block_points + 1) * block_pairs;

  // Destinations, with capacity for `block_pairs` and for `room`.
  Group* manifolds;
  Point* points;
  std::uint32_t first_point;   ///< number of the first point
  const std::uint32_t* pairs;  ///< numbers of the pairs, where the form has them; read in multiples of the lanes

  std::uint32_t known;                        ///< bit k: the k-th pair is known
  std::uint32_t manifold_count, point_count;  ///< totals over all pairs
  bool any_twice;                             ///< whether two points of a pair have the same features
};
template <class T>
using CompactBlock = PointBlock<T, CompactContacts<T>>;

/// Pairs of boxes within their margins, passed from the kernel for axes to the one for points: a column for each number
/// that this takes, in which the pairs are consecutive.
template <class T>
struct alignas(64) MetBoxes {
  /// Number of pairs passed in at a time; for floats these, left-over ones and what kernels write behind the last stay
  /// within the smallest cache.
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
  std::size_t first = 0, count = 0;  ///< first waiting pair, and the end of the waiting ones
};

/// The contact of two shapes that touch in one point at most.
template <class T>
struct PointContact {
  ContactPoint<T> point;
  Vec3<T> normal;
};
/// The kind of a pair's meeting, needed before its contact is read; `lying`: the contact is the next in a list of
/// `SegmentContact`.
enum class Meeting : std::uint8_t { apart, touching, unknown, lying };
/// Whether the answer is not in the pair's own place: it is unknown, or a `SegmentContact`.
constexpr bool is_elsewhere(Meeting meeting) { return meeting >= Meeting::unknown; }
static_assert(is_elsewhere(Meeting::lying) && !is_elsewhere(Meeting::apart) && !is_elsewhere(Meeting::touching));

/// The points of contact of up to `block_pairs` bodies on half-spaces; see `Rest`.
template <class T>
struct HalfSpaceBlock {
  using Column = T[block_pairs];
  Column distance, up[3], filled;
  struct Slot {
    Column of_body[3], of_plane[3], distance, corner;
  } slots[4];
};

/// Prefetches the cache lines of records, which may be behind the end of an array: for reading, or for writing. Saves a
/// quarter of the time for batches larger than the cache.
template <bool to_write, class Record>
[[gnu::always_inline]] inline void fetch_lines(const Record* first, std::size_t count) {
  constexpr std::size_t line = 64;
  const auto begin = reinterpret_cast<std::uintptr_t>(first), end = begin + count * sizeof(Record);
  for (std::uintptr_t at = begin; at < end; at += line)
    __builtin_prefetch(reinterpret_cast<const void*>(at), to_write);  // NOLINT(performance-no-int-to-ptr): never read
}

/// `count` rounded up to a multiple of the widest registers' lanes.
constexpr std::size_t bundled(std::size_t count) { return (count + 15) / 16 * 16; }

// clang-format off
GRAZE_DECLARE_KERNEL(
    /// Finds the axes of up to `MetBoxes::most` pairs of boxes, whose indices are counted from `place` on: appends
    /// those within their margins or irregular to `met`, and writes the indices of the others to `apart`, returning
    /// their number. Fewer than a block may wait in `met` before.
    template <class T> std::size_t box_axes(const PairRef<T>* pairs, std::size_t count, std::uint32_t place,
                                            MetBoxes<T>& met, std::uint32_t* apart);
    /// The axes of pairs in rows, as `box_axes` finds them; `bundled(count)` rows are read.
    template <class T> std::size_t box_row_axes(const PairRows<T>& rows, std::size_t count, T margin,
                                                std::uint32_t place, MetBoxes<T>& met, std::uint32_t* apart);
    /// Finds the points of the next `count` <= `block_pairs` pairs of `met`, behind which there must be numbers for the
    /// lanes that stay empty.
    template <class T> void box_points(const MetBoxes<T>& met, std::size_t count, PointBlock<T>& block);
    /// The points of `box_points` in compact form.
    template <class T> void box_compact_points(const MetBoxes<T>& met, std::size_t count, CompactBlock<T>& block);
    /// The axes of pairs of a box and a triangle, and the points of up to `block_pairs` along them.
    template <class T> void triangle_axes(const PairRef<T>* pairs, std::size_t count, TriangleReferenceAxis<T>* axes);
    template <class T> void triangle_points(const PairRef<T>* pairs, const TriangleReferenceAxis<T>* axes,
                                            std::size_t count, PointBlock<T>& points);
    /// Axis and points of one pair, given as its cores. Returns the distance; where that exceeds the margin, only the
    /// normal of the manifold is set.
    template <class T> T triangle_contact(const PairRef<T>& pair, ContactSlots<T>& manifold);
    /// The axis of one pair of boxes, and its points where it is within its margin, which the result says. Also takes
    /// irregular boxes, whose points are not known.
    template <class T> bool box_contact(const PairRef<T>& pair, BoxReferenceAxis<T>& choice, ContactSlots<T>& found);
    /// The contacts of pairs with `one_contact_kernels`, without rounding radii beside their own, capsules untapered
    /// and with a length. Up to `bundled(count)` entries may be written; `sides` lists the capsules side by
    /// side.
    template <class A, class B, class T> void sphere_capsule_contacts(const PairRef<T>* pairs, std::size_t count,
                                                             PointContact<T>* contacts, Meeting* meetings,
                                                             SegmentContact<T>* sides);
    /// The contacts of `sphere_capsule_contacts` for pairs in rows, of any capsules and boxes. `turned`: A is the
    /// caller's second shape. `bundled(count)` rows are read, and there must be capacity for as many manifolds and
    /// points.
    template <class A, class B, class T> void sphere_capsule_row_contacts(const PairRows<T>& rows, std::size_t count,
                                                                          T margin, bool turned,
                                                                          const ContactRows<T>& to, RowCounts& found);
    /// The contacts of capsules with boxes, in the form of `sphere_capsule_contacts`.
    template <class T> void capsule_box_contacts(const PairRef<T>* pairs, std::size_t count,
                                                 PointContact<T>* contacts, Meeting* meetings,
                                                 SegmentContact<T>* sides);
    /// The points of up to `block_pairs` balls, untapered capsules with a length, boxes or triangles on half-spaces,
    /// all without rounding.
    template <class A, class T> void half_space_slots(const PairRef<T>* pairs, std::size_t count,
                                                      HalfSpaceBlock<T>& points);
    /// The distances of pairs with `closed_form_rows`, in rows. `turned`: A is the caller's second shape.
    /// `bundled(count)` rows are read. Returns the number of pairs without an answer, whose indices are written to
    /// `unknown`.
    template <class A, class B, class T> std::uint32_t row_distances(const PairRows<T>& rows, std::size_t count,
                                                                     bool turned, Distance<T>* distances,
                                                                     std::uint8_t* unknown);
    /// Overlap tests, 1 or 0, of the pairs of `row_distances`, of boxes, and of boxes with triangles.
    template <class A, class B, class T> std::uint32_t row_overlaps(const PairRows<T>& rows, std::size_t count,
                                                                    std::uint8_t* touch, std::uint8_t* unknown);
    /// Overlap test of one pair of boxes; nothing for irregular ones. `faces_only`: as for `boxes_apart`.
    template <class T> std::optional<bool> boxes_touch(const Box<T>& a, const Pose<T>& pose_a, const Box<T>& b,
                                                       const Pose<T>& pose_b, bool faces_only);
    /// Distances and overlap tests of boxes and box-like shapes (`box_box/box_like_pair.hpp`), in double.
    template <class A, class B, class T> std::uint32_t box_row_distances(const PairRows<T>& rows, std::size_t count,
                                                                         bool turned, Distance<T>* distances,
                                                                         std::uint8_t* unknown);
    template <class A, class B, class T> std::uint32_t box_like_row_overlaps(const PairRows<T>& rows, std::size_t count,
                                                                             std::uint8_t* touch,
                                                                             std::uint8_t* unknown);
    /// Contacts, distances and overlap tests, as above, of balls or capsules with triangles, in double. `unknown`
    /// includes pairs that need the general path.
    template <class A, class T> void sphere_capsule_triangle_contacts(const PairRef<T>* pairs, std::size_t count,
                                                             PointContact<T>* contacts, Meeting* meetings,
                                                             SegmentContact<T>* sides);
    template <class A, class T> void sphere_capsule_triangle_row_contacts(const PairRows<T>& rows, std::size_t count,
                                                                          T margin, bool turned,
                                                                          const ContactRows<T>& to, RowCounts& found);
    template <class A, class T> std::uint32_t sphere_capsule_triangle_row_distances(
        const PairRows<T>& rows, std::size_t count, bool turned, Distance<T>* distances, std::uint8_t* unknown);
    template <class A, class T> std::uint32_t sphere_capsule_triangle_row_overlaps(
        const PairRows<T>& rows, std::size_t count, std::uint8_t* touch, std::uint8_t* unknown);
    /// The distances of triangles, in double.
    template <class T> std::uint32_t triangle_row_distances(const PairRows<T>& rows, std::size_t count, bool turned,
                                                            Distance<T>* distances, std::uint8_t* unknown);
    /// The distances of pairs of triangles without rounding, and the points of up to `block_pairs` of those within
    /// their margins.
    template <class T> void triangle_pair_distances(const PairRef<T>* pairs, std::size_t count,
                                                    FoundTriangles<T>* found);
    template <class T> void triangle_pair_points(const PairRef<T>* pairs, const FoundTriangles<T>* found,
                                                 std::size_t count, PointBlock<T>& points);
    /// The distance of one pair of triangles, or that it exceeds `enough`.
    void triangle_pair(const PlacedTriangle<double>& a, const PlacedTriangle<double>& b, double enough,
                       TriangleDistance<double>& found);
    /// The distance of one pair, and within the margin the axes and, for triangles without rounding, the points.
    void triangle_pair_contact(const PlacedTriangle<double>& a, const PlacedTriangle<double>& b, double enough,
                               double margin, const AnswerRounding& rounding, TriangleDistance<double>& found,
                               TriangleAxes<double>& axes, ContactSlots<double>& points);)
// clang-format on

}  // namespace graze
