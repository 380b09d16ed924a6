// A capture of one scalar played again.
//
// Guarantee: that of `graze::replay`; a program that plays one scalar needs the code of no other.
#pragma once

#include "capture/frames.hpp"
#include "graze/capture.hpp"

namespace graze::capture {

/// Plays the frames behind `head`, which has to be of `T`.
template <class T>
ReplayReport play(FrameReader& frames, const Head& head, const ReplayFunction& each, Executor* executor);

extern template ReplayReport play<float>(FrameReader&, const Head&, const ReplayFunction&, Executor*);
extern template ReplayReport play<double>(FrameReader&, const Head&, const ReplayFunction&, Executor*);

}  // namespace graze::capture
