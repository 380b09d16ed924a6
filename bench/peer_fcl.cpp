// FCL in double precision with its default solver, libccd. A triangle is a mesh of one, since collide() does not take
// its triangle. Casts are by its conservative advancement. For a pair that it has no function for it writes a warning
// and says "no contact".
#ifdef GRAZE_BENCH_FCL

#include <fcl/fcl.h>

#include <algorithm>

#include "peer.hpp"

namespace graze::bench {

namespace {

class Fcl {
 public:
  static constexpr const char* name = "fcl";
  static constexpr bool single_precision = false;
  static std::string version() { return GRAZE_BENCH_FCL_VERSION; }

  bool prepare(std::span<const Pair> pairs) {
    OncePerCorners<Geometry> shared;
    for (const Pair& pair : pairs) {
      for (const Body* body : {&pair.a, &pair.b}) {
        const Quatd q = rotation_from_z(*body);
        Object object{shared.of(*body, make), fcl::Transform3d::Identity()};
        object.geometry->computeLocalAABB();
        object.pose.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
        object.pose.translation() = vector(body->pose.translation);
        objects_.push_back(std::move(object));
      }
      if (max_abs(pair.motion) > 0) ways_.push_back(vector(pair.motion));
    }
    return true;
  }
  /// Its distances to a half-space, and from a sphere to a mesh, end the process for some poses.
  bool has(Query query) const {
    const auto any = [&](fcl::NODE_TYPE type) {
      return std::any_of(objects_.begin(), objects_.end(),
                         [&](const Object& object) { return object.geometry->getNodeType() == type; });
    };
    return query != Query::distance || !(any(fcl::GEOM_HALFSPACE) || (any(fcl::GEOM_SPHERE) && any(fcl::BV_OBBRSS)));
  }

  bool overlap(std::size_t i) {
    const Object &a = objects_[2 * i], &b = objects_[2 * i + 1];
    collision_.clear();
    return fcl::collide(a.geometry.get(), a.pose, b.geometry.get(), b.pose, fcl::CollisionRequestd(1, false),
                        collision_) > 0;
  }
  double distance(std::size_t i) {
    const Object &a = objects_[2 * i], &b = objects_[2 * i + 1];
    distance_.clear();
    fcl::distance(a.geometry.get(), a.pose, b.geometry.get(), b.pose, fcl::DistanceRequestd(false, true), distance_);
    const double found = distance_.min_distance;
    return found < std::numeric_limits<double>::max() ? found : std::numeric_limits<double>::quiet_NaN();
  }
  Contacts contacts(std::size_t i) {
    const Object &a = objects_[2 * i], &b = objects_[2 * i + 1];
    collision_.clear();
    fcl::collide(a.geometry.get(), a.pose, b.geometry.get(), b.pose, fcl::CollisionRequestd(8, true), collision_);
    Contacts found{collision_.numContacts(), 0, {}};
    if (found.count > 0) {
      const fcl::Vector3d& normal = collision_.getContact(0).normal;
      found.normal = {normal.x(), normal.y(), normal.z()};
    }
    for (std::size_t k = 0; k < found.count; ++k)
      found.deepest = std::min(found.deepest, -collision_.getContact(k).penetration_depth);
    return found;
  }
  double cast(std::size_t i) {
    const Object &a = objects_[2 * i], &b = objects_[2 * i + 1];
    fcl::Transform3d end = a.pose;
    end.translation() += ways_[i];
    const fcl::ContinuousCollisionRequestd request(100, 1e-4, fcl::CCDM_TRANS, fcl::GST_LIBCCD,
                                                   fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide(a.geometry.get(), a.pose, end, b.geometry.get(), b.pose, b.pose, request, result);
    return result.is_collide ? result.time_of_contact : never;
  }

 private:
  using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;
  struct Object {
    Geometry geometry;
    fcl::Transform3d pose;
  };

  static fcl::Vector3d vector(const Vec3d& v) { return {v.x, v.y, v.z}; }
  static Geometry make(const Body& body) {
    const Vec3d& s = body.size;
    switch (body.kind) {
    case Kind::sphere: return std::make_shared<fcl::Sphered>(s.x);
    case Kind::capsule: return std::make_shared<fcl::Capsuled>(s.x, s.y);
    case Kind::box: return std::make_shared<fcl::Boxd>(s.x, s.y, s.z);
    case Kind::cylinder: return std::make_shared<fcl::Cylinderd>(s.x, s.y);
    case Kind::cone: return std::make_shared<fcl::Coned>(s.x, s.y);
    case Kind::ellipsoid: return std::make_shared<fcl::Ellipsoidd>(s.x, s.y, s.z);
    case Kind::half_space: return std::make_shared<fcl::Halfspaced>(fcl::Vector3d(0, 1, 0), 0.0);
    case Kind::triangle:
    case Kind::mesh: {
      auto mesh = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
      std::vector<fcl::Vector3d> points;
      for (const Vec3d& p : body.corners->points) points.push_back(vector(p));
      std::vector<fcl::Triangle> triangles;
      for (const auto& [i, j, k] : body.corners->faces) triangles.emplace_back(i, j, k);
      mesh->beginModel();
      mesh->addSubModel(points, triangles);
      mesh->endModel();
      return mesh;
    }
    case Kind::hull: break;
    }
    auto points = std::make_shared<std::vector<fcl::Vector3d>>();
    for (const Vec3d& p : body.corners->points) points->push_back(vector(p));
    auto faces = std::make_shared<std::vector<int>>();
    for (const auto& face : body.corners->faces) {
      faces->push_back(3);
      faces->insert(faces->end(), face.begin(), face.end());
    }
    return std::make_shared<fcl::Convexd>(points, static_cast<int>(body.corners->faces.size()), faces);
  }

  std::vector<Object> objects_;
  std::vector<fcl::Vector3d> ways_;
  fcl::CollisionResultd collision_;
  fcl::DistanceResultd distance_;
};

const Registered<Fcl> registered;

}  // namespace

}  // namespace graze::bench

#endif
