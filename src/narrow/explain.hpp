// Explanations of the answers for two convex shapes: the method of each, made after the answer.
//
// Guarantee: nothing here computes an answer or has an influence on one. An explanation calls the routines once more to
// find out which of them answered, and repeats the searches with an observer.
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
