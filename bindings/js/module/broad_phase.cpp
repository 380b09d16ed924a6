// The broad phases for JavaScript, in the manner of the C interface.
#include <algorithm>

#include "graze/broad_phase.hpp"

#include "c/error.hpp"

#ifdef GRAZE_JS_DOUBLE
#define EXPORTED(name) __attribute__((export_name("graze_js_broad_phase_" name "_d")))
using T = double;
#else
#define EXPORTED(name) __attribute__((export_name("graze_js_broad_phase_" name "_f")))
using T = float;
#endif

namespace {

/// A broad phase and what it found last.
struct Phase {
  std::unique_ptr<graze::BroadPhase<T>> broad;
  std::vector<graze::IdPair> pairs;
  std::vector<std::uint32_t> ids;
  std::vector<graze::BroadPhasePart<T>> parts;
};

/// In the order of the words of JavaScript.
std::unique_ptr<graze::BroadPhase<T>> of_kind(int kind) {
  switch (kind) {
  case 0: return graze::make_dynamic_tree<T>();
  case 1: return graze::make_sort_and_sweep<T>();
  case 2: return graze::make_sweep_and_prune<T>();
  case 3: return graze::make_hashed_grid<T>();
  case 4: return graze::make_loose_octree<T>();
  default: return graze::make_bsp<T>();
  }
}

using graze::c::guarded;
using Box = graze::Aabb<T>;

/// Where the ids of the last question are, and how many.
template <class Id>
void show(const std::vector<Id>& found, const void** first, std::size_t* count) {
  *first = found.data();
  *count = found.size() * sizeof(Id) / sizeof(std::uint32_t);
}

}  // namespace

extern "C" {

EXPORTED("create") GrazeStatus graze_js_broad_create(int kind, Phase** phase) {
  return guarded([&] { *phase = new Phase{of_kind(kind), {}, {}, {}}; });
}

EXPORTED("destroy") GrazeStatus graze_js_broad_destroy(Phase* phase) {
  delete phase;
  return GRAZE_OK;
}

EXPORTED("insert") GrazeStatus graze_js_broad_insert(Phase* phase, std::uint32_t id, const Box* box) {
  return guarded([&] { phase->broad->insert(id, *box); });
}

EXPORTED("move") GrazeStatus graze_js_broad_move(Phase* phase, std::uint32_t id, const Box* box) {
  return guarded([&] { phase->broad->move(id, *box); });
}

EXPORTED("remove") GrazeStatus graze_js_broad_remove(Phase* phase, std::uint32_t id) {
  return guarded([&] { phase->broad->remove(id); });
}

EXPORTED("pairs")
GrazeStatus graze_js_broad_pairs(Phase* phase, bool moved, const void** first, std::size_t* count) {
  return guarded([&] {
    moved ? phase->broad->moved_pairs(phase->pairs) : phase->broad->pairs(phase->pairs);
    show(phase->pairs, first, count);
  });
}

EXPORTED("query")
GrazeStatus graze_js_broad_query(Phase* phase, const Box* box, const void** first, std::size_t* count) {
  return guarded([&] {
    phase->broad->query(*box, phase->ids);
    show(phase->ids, first, count);
  });
}

EXPORTED("sweep")
GrazeStatus graze_js_broad_sweep(Phase* phase, const Box* box, const graze::Vec3<T>* motion, const void** first,
                                 std::size_t* count) {
  return guarded([&] {
    phase->broad->sweep(*box, *motion, phase->ids);
    show(phase->ids, first, count);
  });
}

/// Where the parts of the structure are, a box and a number each, and how many.
EXPORTED("parts")
GrazeStatus graze_js_broad_parts(Phase* phase, const void** first, std::size_t* count) {
  return guarded([&] {
    phase->broad->parts(phase->parts);
    *first = phase->parts.data();
    *count = phase->parts.size();
  });
}

EXPORTED("counts") GrazeStatus graze_js_broad_counts(const Phase* phase, std::uint32_t* tests, std::size_t* bytes) {
  return guarded([&] {
    *tests = static_cast<std::uint32_t>(std::min<std::uint64_t>(phase->broad->tests(), ~std::uint32_t{0}));
    *bytes = phase->broad->memory();
  });
}

}  // extern "C"
