#include "mpi/partition.hpp"

#include <zoltan.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "mpi/messages.hpp"

namespace graze::mpi {

namespace {

/// The largest coordinate for Zoltan, which computes differences: those of half-spaces, which have no end, would be
/// none.
constexpr double furthest = 1e100;

void check(int error, const char* what) {
  if (error == ZOLTAN_OK || error == ZOLTAN_WARN) return;
  throw std::runtime_error(std::string("Zoltan cannot ") + what);
}

double clamped(double x) { return std::clamp(x, -furthest, furthest); }

}  // namespace

Partition::Partition(MPI_Comm comm) : comm_(comm), own_(rank_of(comm)) {
  float version = 0;
  Zoltan_Initialize(0, nullptr, &version);
  zoltan_ = Zoltan_Create(comm);
  if (!zoltan_) throw std::runtime_error("Zoltan cannot be started");
  const std::pair<const char*, const char*> settings[] = {{"DEBUG_LEVEL", "0"},
                                                          {"LB_METHOD", "RCB"},
                                                          {"NUM_GID_ENTRIES", "1"},
                                                          {"NUM_LID_ENTRIES", "1"},
                                                          {"OBJ_WEIGHT_DIM", "1"},
                                                          {"RETURN_LISTS", "NONE"},
                                                          {"KEEP_CUTS", "1"},
                                                          {"RCB_OUTPUT_LEVEL", "0"},
                                                          {"IMBALANCE_TOL", "1.02"},
                                                          {"RCB_REUSE", "0"},
                                                          {"REMAP", "0"}};
  for (const auto& [name, value] : settings) Zoltan_Set_Param(zoltan_, name, value);
  const auto count = [](void* data, int* error) {
    *error = ZOLTAN_OK;
    return static_cast<int>(static_cast<Partition*>(data)->loads_.size());
  };
  const auto list = [](void* data, int, int, ZOLTAN_ID_PTR global, ZOLTAN_ID_PTR local, int, float* weights,
                       int* error) {
    const Partition& self = *static_cast<Partition*>(data);
    for (std::size_t i = 0; i < self.loads_.size(); ++i) {
      global[i] = static_cast<ZOLTAN_ID_TYPE>(i * static_cast<std::size_t>(size_of(self.comm_)) +
                                              static_cast<std::size_t>(rank_of(self.comm_)));
      local[i] = static_cast<ZOLTAN_ID_TYPE>(i);
      weights[i] = static_cast<float>(self.loads_[i].weight);
    }
    *error = ZOLTAN_OK;
  };
  const auto dimensions = [](void*, int* error) {
    *error = ZOLTAN_OK;
    return 3;
  };
  const auto places = [](void* data, int, int, int some, ZOLTAN_ID_PTR, ZOLTAN_ID_PTR local, int, double* out,
                         int* error) {
    const Partition& self = *static_cast<Partition*>(data);
    for (int i = 0; i < some; ++i)
      for (std::size_t axis = 0; axis < 3; ++axis)
        out[3 * static_cast<std::size_t>(i) + axis] = clamped(self.loads_[local[i]].place[axis]);
    *error = ZOLTAN_OK;
  };
  Zoltan_Set_Num_Obj_Fn(zoltan_, count, this);
  Zoltan_Set_Obj_List_Fn(zoltan_, list, this);
  Zoltan_Set_Num_Geom_Fn(zoltan_, dimensions, this);
  Zoltan_Set_Geom_Multi_Fn(zoltan_, places, this);
  processes_.resize(static_cast<std::size_t>(size_of(comm)));
  parts_.resize(processes_.size());
}

Partition::~Partition() { Zoltan_Destroy(&zoltan_); }

void Partition::draw(std::span<const Load> loads) {
  loads_ = loads;
  int changes = 0, global_entries = 0, local_entries = 0, imports = 0, exports = 0;
  ZOLTAN_ID_PTR import_global = nullptr, import_local = nullptr, export_global = nullptr, export_local = nullptr;
  int *import_ranks = nullptr, *import_parts = nullptr, *export_ranks = nullptr, *export_parts = nullptr;
  check(Zoltan_LB_Partition(zoltan_, &changes, &global_entries, &local_entries, &imports, &import_global, &import_local,
                            &import_ranks, &import_parts, &exports, &export_global, &export_local, &export_ranks,
                            &export_parts),
        "share out the bodies");
  loads_ = {};
  drawn_ = true;
  int dimensions = 0;
  check(Zoltan_RCB_Box(zoltan_, rank_of(comm_), &dimensions, &region_.lower.x, &region_.lower.y, &region_.lower.z,
                       &region_.upper.x, &region_.upper.y, &region_.upper.z),
        "tell a region");
}

int Partition::rank_of_point(const Vec3<double>& point) const {
  // A point on a border is left to Zoltan.
  const Vec3<double>&lower = region_.lower, &upper = region_.upper;
  if (drawn_ && lower.x < point.x && point.x < upper.x && lower.y < point.y && point.y < upper.y && lower.z < point.z &&
      point.z < upper.z)
    return own_;
  double place[3] = {clamped(point.x), clamped(point.y), clamped(point.z)};
  int process = 0, part = 0;
  check(Zoltan_LB_Point_PP_Assign(zoltan_, place, &process, &part), "find the rank of a point");
  return process;
}

void Partition::ranks_of_box(const Aabb<double>& box, std::vector<int>& out) const {
  int processes = 0, parts = 0;
  check(Zoltan_LB_Box_PP_Assign(zoltan_, clamped(box.lower.x), clamped(box.lower.y), clamped(box.lower.z),
                                clamped(box.upper.x), clamped(box.upper.y), clamped(box.upper.z), processes_.data(),
                                &processes, parts_.data(), &parts),
        "find the ranks of a box");
  out.insert(out.end(), processes_.begin(), processes_.begin() + processes);
}

}  // namespace graze::mpi
