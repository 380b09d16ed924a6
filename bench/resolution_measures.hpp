// What each row of the table measures of an engine, as the table prints it. Depths are those at the end of a run.
#pragma once

#include <string>

#include "resolution_engine.hpp"

namespace graze::bench {

// What stands (resolution_stacks.cpp).
std::string tallest(const EngineKind& kind, bool sleep);                      ///< the tallest tower that stands
std::string tower_row(const EngineKind& kind, int count, double off);         ///< sink and drift of the top, energy
std::string pyramid(const EngineKind& kind);                                  ///< depth, drift, energy, time of a step
std::string heavy_on_light(const EngineKind& kind, double ratio, int light);  ///< depth, energy
std::string card_house(const EngineKind& kind);                               ///< cards fallen, greatest move
std::string sizes(const EngineKind& kind);                                    ///< sink of five boxes, size by size

// What moves (resolution_moves.cpp).
std::string creep(const EngineKind& kind, bool plate);  ///< in two seconds; of that, after the first 0.2 s
/// The way, or the speed, after two seconds, over the exact one.
std::string sliding(const EngineKind& kind, double share, bool plate, bool way);
std::string stopping(const EngineKind& kind);
std::string rebound(const EngineKind& kind);
std::string elastic(const EngineKind& kind, bool ball);
std::string cradle(const EngineKind& kind);             ///< speed of the last ball, greatest of the others, energy
std::string spin(const EngineKind& kind, double rate);  ///< errors of angular momentum, its direction, energy; flips
std::string free_fall(const EngineKind& kind);
std::string cylinders(const EngineKind& kind);      ///< how many sleep, since when, depth
std::string balls_in_bowl(const EngineKind& kind);  ///< the same
std::string through_wall(const EngineKind& kind, double size, bool moving_wall);
std::string past_post(const EngineKind& kind, double rate, bool moving_post);
/// Change of momentum and of angular momentum, at most and in the mean, in a second in which two bodies meet.
std::string meeting(const EngineKind& kind, double restitution, double friction);

// A pile (resolution_pile.cpp).
std::string pile(const EngineKind& kind);          ///< time of a step, depth, energy at three quarters and at the end
std::string settled_pile(const EngineKind& kind);  ///< time of a step, depth
std::string two_threads(const EngineKind& kind);   ///< how many times faster than one
std::string same_bits(const EngineKind& kind);     ///< twice; on several threads; after it was put back

}  // namespace graze::bench
