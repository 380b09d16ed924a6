// ODE, in the precision it was built with. It has contacts and no distance; overlap is a request for one contact. A
// triangle is a mesh of one, of which it takes only the front: a quarter of its answers about triangles are wrong by
// our count. It meets hulls with rays as if they came straight at a face, and misses most that come aslant. For a pair
// that it has no function for it says, without a word, "no contact".
#ifdef GRAZE_BENCH_ODE

#include <ode/ode.h>

#include <algorithm>
#include <array>
#include <deque>

#include "peer.hpp"

namespace graze::bench {

namespace {

dReal number(double v) { return static_cast<dReal>(v); }

/// What a geometry points to and does not copy.
struct Data {
  std::vector<dReal> points, planes;
  std::vector<unsigned> polygons;
  std::vector<dTriIndex> indices;
  dTriMeshDataID mesh = nullptr;
};

class Ode {
 public:
  static constexpr const char* name = "ode";
  static constexpr bool single_precision = sizeof(dReal) == sizeof(float);
  static std::string version() { return GRAZE_BENCH_ODE_VERSION; }

  Ode() { static_cast<void>(started()); }
  Ode(const Ode&) = delete;
  Ode& operator=(const Ode&) = delete;
  ~Ode() {
    for (const dGeomID geom : geoms_) dGeomDestroy(geom);
    for (const dGeomID ray : rays_) dGeomDestroy(ray);
    for (const Data& data : data_)
      if (data.mesh) dGeomTriMeshDataDestroy(data.mesh);
  }

  bool prepare(std::span<const Pair> pairs) {
    OncePerCorners<const Data*> shared;
    for (const Pair& pair : pairs) {
      for (const Body* body : {&pair.a, &pair.b}) {
        const dGeomID geom = make(*body, shared);
        if (!geom) return false;
        geoms_.push_back(geom);
      }
      if (max_abs(pair.motion) > 0) rays_.push_back(ray(pair));
    }
    return !crashes();
  }
  bool overlap(std::size_t i) {
    dContactGeom contact;
    return dCollide(geoms_[2 * i], geoms_[2 * i + 1], 1, &contact, sizeof contact) > 0;
  }
  Contacts contacts(std::size_t i) {
    std::array<dContactGeom, 8> points;
    const int count = dCollide(geoms_[2 * i], geoms_[2 * i + 1], static_cast<int>(points.size()), points.data(),
                               sizeof(dContactGeom));
    Contacts found{static_cast<std::size_t>(count), 0, {}};
    if (count > 0)
      found.normal = {static_cast<double>(points[0].normal[0]), static_cast<double>(points[0].normal[1]),
                      static_cast<double>(points[0].normal[2])};
    for (int k = 0; k < count; ++k) found.deepest = std::min(found.deepest, -static_cast<double>(points[k].depth));
    return found;
  }
  double raycast(std::size_t i) {
    dContactGeom contact;
    if (dCollide(geoms_[2 * i], rays_[i], 1, &contact, sizeof contact) == 0) return never;
    return static_cast<double>(contact.depth / dGeomRayGetLength(rays_[i]));
  }

 private:
  /// A mesh of one triangle has no tree, which ODE's functions for hull and mesh follow all the same.
  bool crashes() const {
    if (std::all_of(data_.begin(), data_.end(), [](const Data& data) { return data.indices.size() != 3; }))
      return false;
    const auto is = [&](std::size_t k, int type) { return dGeomGetClass(geoms_[k]) == type; };
    return is(1, dTriMeshClass) && (is(0, dTriMeshClass) || is(0, dConvexClass));
  }
  static bool started() {
    static const bool done = dInitODE2(0) != 0 && dAllocateODEDataForThread(dAllocateMaskAll) != 0;
    dSetMessageHandler([](int, const char*, va_list) {});
    return done;
  }
  static dGeomID ray(const Pair& pair) {
    const Vec3d &from = pair.b.pose.translation, &way = pair.motion;
    const dGeomID ray = dCreateRay(nullptr, number(length(way)));
    dGeomRaySet(ray, number(from.x), number(from.y), number(from.z), number(way.x), number(way.y), number(way.z));
    return ray;
  }
  dGeomID make(const Body& body, OncePerCorners<const Data*>& shared) {
    const Vec3d& s = body.size;
    const Vec3d& t = body.pose.translation;
    dGeomID geom = nullptr;
    switch (body.kind) {
    case Kind::sphere: geom = dCreateSphere(nullptr, number(s.x)); break;
    case Kind::capsule: geom = dCreateCapsule(nullptr, number(s.x), number(s.y)); break;
    case Kind::box: geom = dCreateBox(nullptr, number(s.x), number(s.y), number(s.z)); break;
    case Kind::cylinder: geom = dCreateCylinder(nullptr, number(s.x), number(s.y)); break;
    case Kind::hull: geom = convex(*shared.of(body, [&](const Body& b) { return convex_data(b); })); break;
    case Kind::triangle:
    case Kind::mesh: geom = mesh(*shared.of(body, [&](const Body& b) { return mesh_data(b); })); break;
    case Kind::half_space: {
      const Vec3d n = normalized(rotate(body.pose.rotation, Vec3d{0, 1, 0}));
      return dCreatePlane(nullptr, number(n.x), number(n.y), number(n.z), number(dot(n, t)));
    }
    case Kind::cone:
    case Kind::ellipsoid: return nullptr;
    }
    const Quatd q = rotation_from_z(body);
    const dQuaternion turn = {number(q.w), number(q.x), number(q.y), number(q.z)};
    dGeomSetPosition(geom, number(t.x), number(t.y), number(t.z));
    dGeomSetQuaternion(geom, turn);
    return geom;
  }
  Data& data_of(const Body& body) {
    Data& data = data_.emplace_back();
    for (const Vec3d& p : body.corners->points)
      for (std::size_t axis = 0; axis < 3; ++axis) data.points.push_back(number(p[axis]));
    return data;
  }
  const Data* convex_data(const Body& body) {
    Data& data = data_of(body);
    for (const auto& face : body.corners->faces) {
      const auto& points = body.corners->points;
      const Vec3d &p = points[face[0]], &q = points[face[1]], &r = points[face[2]];
      const Vec3d n = normalized(cross(q - p, r - p));
      for (const double v : {n.x, n.y, n.z, dot(n, p)}) data.planes.push_back(number(v));
      data.polygons.push_back(3);
      for (const int index : face) data.polygons.push_back(static_cast<unsigned>(index));
    }
    return &data;
  }
  static dGeomID convex(const Data& data) {
    return dCreateConvex(nullptr, data.planes.data(), static_cast<unsigned>(data.planes.size() / 4), data.points.data(),
                         static_cast<unsigned>(data.points.size() / 3), data.polygons.data());
  }
  const Data* mesh_data(const Body& body) {
    Data& data = data_of(body);
    for (const auto& face : body.corners->faces)
      for (const int index : face) data.indices.push_back(static_cast<dTriIndex>(index));
    data.mesh = dGeomTriMeshDataCreate();
    const int point = 3 * sizeof(dReal), triangle = 3 * sizeof(dTriIndex);
    const int points = static_cast<int>(data.points.size() / 3), indices = static_cast<int>(data.indices.size());
    if constexpr (single_precision)
      dGeomTriMeshDataBuildSingle(data.mesh, data.points.data(), point, points, data.indices.data(), indices, triangle);
    else
      dGeomTriMeshDataBuildDouble(data.mesh, data.points.data(), point, points, data.indices.data(), indices, triangle);
    return &data;
  }
  static dGeomID mesh(const Data& data) { return dCreateTriMesh(nullptr, data.mesh, nullptr, nullptr, nullptr); }

  std::deque<Data> data_;  // addresses stay
  std::vector<dGeomID> geoms_, rays_;
};

const Registered<Ode> registered;

}  // namespace

}  // namespace graze::bench

#endif
