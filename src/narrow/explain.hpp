// Explanations of the answers for two convex shapes: how each was found, for show, after it has been found.
//
// Guarantee: no answer is computed here and none depends on anything here. An explanation asks the routines that
// answered once more where it has to know which of them did, and repeats the searches with an observer.
#pragma once

#include "graze/contact.hpp"
#include "graze/result.hpp"
#include "graze/shape.hpp"
#include "graze/trace.hpp"

namespace graze {

template <class T>
void explain_distance(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b,
                      const Distance<T>& answer, Trace& trace);

template <class T>
void explain_overlap(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, Trace& trace);

/// `answer`: the manifold that was found, without points where none is within the margin.
template <class T>
void explain_contacts(const Shape<T>& a, const Pose<T>& pose_a, const Shape<T>& b, const Pose<T>& pose_b, T margin,
                      const Manifold<T>& answer, Trace& trace);

}  // namespace graze
