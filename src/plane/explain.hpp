// The trace of a pair of shapes in the plane, made after the answer.
//
// Guarantee: no query computes differently for it, or knows of it: what a search did is found by searching anew, with
// somebody who looks on. The axes are those of the edges, with the intervals that both shapes
// cover on them. The steps of curved cores are those that led to the answer; polygons are answered by one walk around
// their difference, and GJK and EPA are run beside it, for show.
#pragma once

#include "graze/plane/query.hpp"
#include "plane/leaves.hpp"

namespace graze::plane {

/// The trace of a pair with the answer `answer`.
template <class T>
Trace explained(const LeafPair<T>& pair, const Distance<double>& answer);

/// Adds why shapes that overlap have no contacts.
template <class T>
void explain_missing_contacts(const Shape<T>& a, const Shape<T>& b, Trace& trace);

/// The outline of the Minkowski difference of two bounded cores in the world, counter-clockwise; of curved ones
/// sampled.
template <class T>
std::vector<TraceSupport> difference_outline(const LeafPair<T>& pair);

/// GJK (Gilbert, Johnson, Keerthi 1988) and, where the simplex comes to hold the origin, EPA (van den Bergen 2001), as
/// they find the distance or the depth of two bounded cores: appended to the trace.
template <class T>
void explain_search(const LeafPair<T>& pair, Trace& trace);

/// The steps by which the nearest points of two bounded cores were found, of which one at least is curved: appended to
/// the trace. Those outside of the difference are GJK's, those inside EPA's.
template <class T>
void explain_curved_search(const LeafPair<T>& pair, Trace& trace);

}  // namespace graze::plane
