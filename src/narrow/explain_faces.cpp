#include "narrow/explain_faces.hpp"

#include <algorithm>

#include "narrow/manifold/contact_side.hpp"
#include "narrow/manifold/polygon.hpp"

namespace graze {

namespace {

/// Whether every point of the answer, in the frame of A, is one of the faces' contacts: with the same features, and at
/// most `same_place` of a size beside it as seen along the normal.
template <class T>
bool stands_on(const FaceContacts& faces, const Manifold<T>& answer, const Posed& frame, const Vec3d& normal,
               double size) {
  return std::all_of(answer.points.begin(), answer.points.end(), [&](const ContactPoint<T>& point) {
    const Vec3d at = inverse_transform(frame, converted<double>(point.a));
    return std::any_of(faces.begin(), faces.end(), [&](const FaceContact& c) {
      const Vec3d beside = at - c.a, across = beside - normal * dot(beside, normal);
      return c.feature == point.feature && length(across) <= same_place * size;
    });
  });
}

/// Keeps all cuts, moved from the frame of the pair to the world.
class CutRecorder final : public CutObserver {
 public:
  explicit CutRecorder(const Posed& frame) : frame_(frame) {}

  void cut(const Vec3d& from, const Vec3d& to, std::span<const Vec3d> left) override {
    TraceCut& cut = cuts.emplace_back(TraceCut{transform(frame_, from), transform(frame_, to), {}});
    for (const Vec3d& point : left) cut.left.push_back(transform(frame_, point));
  }

  std::vector<TraceCut> cuts;

 private:
  Posed frame_;
};

}  // namespace

template <class T>
void explain_faces(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                   const Manifold<T>& answer, Trace& trace) {
  if (a.template as<HalfSpace<T>>() || b.template as<HalfSpace<T>>()) return;
  const Posed frame = in_double(pose_a);
  const Side<T> side_a(a, Posed{}), side_b(b, relative_in_double(pose_a, pose_b));
  const Vec3d normal = unit(rotate(conjugate(frame.rotation), converted<double>(answer.normal)));
  const PlacedFace face_a = side_a.face(normal, true), face_b = side_b.face(-normal, true);
  const double smaller = least(side_a.size(), side_b.size());
  FaceContacts laid;
  CutRecorder recorder(frame);
  clip_faces(face_a, face_b, normal, normal_rounding<T> * (side_a.radius() + side_b.radius() + smaller), laid,
             &recorder);
  if (!stands_on(laid, answer, frame, normal, smaller)) return;

  const auto world = [&](Vec3d& point) { point = transform(frame, point); };
  trace.cuts = std::move(recorder.cuts);
  trace.face_a.assign(face_a.vertices.begin(), face_a.vertices.end());
  trace.face_b.assign(face_b.vertices.begin(), face_b.vertices.end());
  std::for_each(trace.face_a.begin(), trace.face_a.end(), world);
  std::for_each(trace.face_b.begin(), trace.face_b.end(), world);
}

template void explain_faces(const Shape<float>&, const Pose<float>&, const Shape<float>&, const Pose<float>&,
                            const Manifold<float>&, Trace&);
template void explain_faces(const Shape<double>&, const Pose<double>&, const Shape<double>&, const Pose<double>&,
                            const Manifold<double>&, Trace&);

}  // namespace graze
