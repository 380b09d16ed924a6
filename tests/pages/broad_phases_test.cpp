// docs/broad-phases.md: the loop, which has no end, is compiled and not run.
#include "broad-phases_includes.inc"

#include <gtest/gtest.h>

#include <vector>

struct BodyOfThePage {
  graze::Aabb<float> bounds;
};
graze::Aabb<float> bounds_of(const BodyOfThePage& body) { return body.bounds; }

void run_broad_phase(const std::vector<BodyOfThePage>& bodies, const std::vector<std::uint32_t>& moving,
                     const std::vector<graze::Filter>& filters) {
#include "broad-phases_1.inc"
}
