// Rays at a mesh, one at a time (Graze: and as a batch) on one thread, side by side with Bullet and Embree.
//
//   bench_rays [--mesh FILE.obj] [--rays N] [--rounds N] [--only REGEX]
//
// Without a file the mesh is a torus of 70,528 triangles with bumps all over it. `camera` are the rays of a picture
// that the mesh fills, row by row; `shadow` are parallel ones at what a picture from above shows, row by row too;
// `random` go from a sphere around it to points in its bounds. All libraries get the same rays in single precision, in
// turns round by round; told are rays in a second of the processor's time by the median round, how often the first hit
// is not where Embree's robust mode has it, and what that rate is in parts of Embree's. Embree's own `fast` mode is
// what its robust one would cost without watertightness; Graze's answers are watertight and in double.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <memory>
#include <regex>
#include <string>
#include <vector>

#ifdef GRAZE_BENCH_BULLET
#include <btBulletCollisionCommon.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#endif
#ifdef GRAZE_BENCH_EMBREE
#include <embree3/rtcore.h>
#endif

#include "command_line.hpp"
#include "graze/batch_raycast.hpp"
#include "random.hpp"

namespace graze::bench {

namespace {

struct Soup {
  std::vector<Vec3f> points;
  std::vector<Mesh<float>::Index> triangles;
  Aabbf bounds = Aabbf::empty();
};

Soup bumpy_torus() {
  constexpr std::uint32_t around = 304, across = 116;
  constexpr double turn = 6.283185307179586;
  Soup soup;
  Random random(3);
  for (std::uint32_t i = 0; i < around; ++i)
    for (std::uint32_t k = 0; k < across; ++k) {
      const double u = turn * i / around, v = turn * k / across;
      const double bump = 0.02 * std::sin(23 * u) * std::cos(9 * v) + random.number(-0.002, 0.002);
      const double minor = 0.38 + bump, rho = 1 + minor * std::cos(v);
      soup.points.push_back(converted<float>(Vec3d{rho * std::cos(u), minor * std::sin(v), rho * std::sin(u)}));
      const auto at = [&](std::uint32_t a, std::uint32_t b) { return (a % around) * across + b % across; };
      soup.triangles.push_back({at(i, k), at(i, k + 1), at(i + 1, k + 1)});
      soup.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i + 1, k)});
    }
  return soup;
}

/// The lines `v x y z` and `f a b c ...` of a Wavefront file; polygons become fans.
Soup read_obj(const char* path) {
  Soup soup;
  std::ifstream file(path);
  std::string line;
  while (std::getline(file, line)) {
    if (line.rfind("v ", 0) == 0) {
      Vec3f p;
      if (std::sscanf(line.c_str(), "v %f %f %f", &p.x, &p.y, &p.z) == 3) soup.points.push_back(p);
    } else if (line.rfind("f ", 0) == 0) {
      std::vector<std::uint32_t> corners;
      for (const char* at = line.c_str() + 1; (at = std::strchr(at, ' ')) != nullptr;) {
        while (*at == ' ') ++at;
        const long number = std::strtol(at, nullptr, 10);
        if (number > 0) corners.push_back(static_cast<std::uint32_t>(number - 1));
        if (number < 0) corners.push_back(static_cast<std::uint32_t>(static_cast<long>(soup.points.size()) + number));
      }
      for (std::size_t i = 2; i < corners.size(); ++i)
        soup.triangles.push_back({corners[0], corners[i - 1], corners[i]});
    }
  }
  return soup;
}

/// Directions of unit length, so that every library's t is a length.
using Rays = std::vector<Ray<float>>;

Ray<float> aimed(const Vec3d& from, const Vec3d& to) {
  return {converted<float>(from), converted<float>(normalized(to - from, Vec3d{0, 0, 1}))};
}

Rays camera_rays(const Soup& soup, std::size_t count) {
  const Vec3d center = converted<double>(soup.bounds.center());
  const double size = length(converted<double>(soup.bounds.extent()));
  const Vec3d eye = center + normalized(Vec3d{0.3, 0.8, 0.5}, Vec3d{}) * size;
  const Vec3d ahead = normalized(center - eye, Vec3d{}), right = normalized(cross(ahead, Vec3d{0, 1, 0}), Vec3d{});
  const Vec3d up = cross(right, ahead);
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
  Rays rays;
  for (std::size_t y = 0; y < side; ++y)
    for (std::size_t x = 0; x < side; ++x) {
      const auto across = [&](std::size_t i) { return 0.7 * size * ((double(i) + 0.5) / double(side) - 0.5); };
      rays.push_back(aimed(eye, center + right * across(x) + up * across(y)));
    }
  return rays;
}

Rays shadow_rays(const Soup& soup, std::size_t count) {
  const Vec3d center = converted<double>(soup.bounds.center()), half = converted<double>(soup.bounds.extent()) * 0.5;
  const Vec3d toward = normalized(Vec3d{0.4, 0.7, -0.2}, Vec3d{});
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(count)));
  Rays rays;
  for (std::size_t z = 0; z < side; ++z)
    for (std::size_t x = 0; x < side; ++x) {
      const auto across = [&](std::size_t i) { return 2 * (double(i) + 0.5) / double(side) - 1; };
      const Vec3d to = center + scaled(Vec3d{across(x), 0, across(z)}, half);
      rays.push_back(aimed(to + toward * (2 * length(half)), to));
    }
  return rays;
}

Rays random_rays(const Soup& soup, std::size_t count) {
  Random random(5);
  const Vec3d center = converted<double>(soup.bounds.center()), half = converted<double>(soup.bounds.extent()) * 0.5;
  Rays rays;
  while (rays.size() < count) {
    const Vec3d from = center + random.direction() * (length(half) * 1.5);
    rays.push_back(aimed(from, center + scaled(random.in_cube(1), half)));
  }
  return rays;
}

constexpr float none = std::numeric_limits<float>::infinity();

/// Finds where each ray first hits, `none` for nowhere.
struct Contender {
  virtual ~Contender() = default;
  virtual void trace(const Rays& rays, float length, std::vector<float>& hits) = 0;
};

struct Graze : Contender {
  explicit Graze(const Soup& soup) : shape(Mesh<float>(soup.points, soup.triangles)) {}
  void trace(const Rays& rays, float length, std::vector<float>& hits) override {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const auto hit = raycast(shape, {}, rays[i], length);
      hits[i] = hit ? hit->t : none;
    }
  }
  Shape<float> shape;
};

/// All at once.
struct GrazeBatch : Graze {
  using Graze::Graze;
  void trace(const Rays& rays, float length, std::vector<float>& hits) override {
    found.resize(rays.size());
    raycast<float>(shape, {}, rays, found, length);
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i] = found[i] ? found[i]->t : none;
  }
  std::vector<std::optional<RayHit<float>>> found{};
};

#ifdef GRAZE_BENCH_BULLET
btVector3 vector(const Vec3f& v) { return {v.x, v.y, v.z}; }

/// The mesh alone, without a world around it.
struct Bullet : Contender {
  explicit Bullet(const Soup& soup) : soup_(soup) {
    btIndexedMesh part;
    part.m_numTriangles = static_cast<int>(soup.triangles.size());
    part.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(soup_.triangles.data());
    part.m_triangleIndexStride = sizeof soup.triangles[0];
    part.m_numVertices = static_cast<int>(soup.points.size());
    part.m_vertexBase = reinterpret_cast<const unsigned char*>(soup_.points.data());
    part.m_vertexStride = sizeof soup.points[0];
    part.m_vertexType = PHY_FLOAT;
    triangles_.addIndexedMesh(part);
    shape_ = std::make_unique<btBvhTriangleMeshShape>(&triangles_, true);
  }
  void trace(const Rays& rays, float length, std::vector<float>& hits) override {
    struct Nearest : btTriangleRaycastCallback {
      using btTriangleRaycastCallback::btTriangleRaycastCallback;
      btScalar reportHit(const btVector3&, btScalar fraction, int, int) override { return fraction; }
    };
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const btVector3 from = vector(rays[i].origin), to = from + vector(rays[i].direction) * length;
      Nearest nearest(from, to, btTriangleRaycastCallback::kF_None);
      shape_->performRaycast(&nearest, from, to);
      hits[i] = nearest.m_hitFraction < 1 ? nearest.m_hitFraction * length : none;
    }
  }

 private:
  Soup soup_;
  btTriangleIndexVertexArray triangles_;
  std::unique_ptr<btBvhTriangleMeshShape> shape_;
};
#endif

#ifdef GRAZE_BENCH_EMBREE
struct Embree : Contender {
  Embree(const Soup& soup, bool robust) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    rtcSetSceneFlags(scene_, robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    const auto fill = [&](RTCBufferType type, RTCFormat format, const auto& from) {
      void* to = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof from[0], from.size());
      std::memcpy(to, from.data(), sizeof from[0] * from.size());
    };
    fill(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, soup.points);
    fill(RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, soup.triangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
  ~Embree() override {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  void trace(const Rays& rays, float length, std::vector<float>& hits) override {
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const Vec3f &o = rays[i].origin, &d = rays[i].direction;
      RTCRayHit query{};
      query.ray = {o.x, o.y, o.z, 0, d.x, d.y, d.z, 0, length, ~0u, 0, 0};
      query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
      RTCIntersectContext context;
      rtcInitIntersectContext(&context);
      rtcIntersect1(scene_, &context, &query);
      hits[i] = query.hit.geomID != RTC_INVALID_GEOMETRY_ID ? query.ray.tfar : none;
    }
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};
#endif

struct Column {
  std::string name;
  std::unique_ptr<Contender> contender;
  std::vector<float> hits{};
  std::vector<double> seconds{};

  double rate() const {
    std::vector<double> sorted = seconds;
    std::sort(sorted.begin(), sorted.end());
    return static_cast<double>(hits.size()) / sorted[sorted.size() / 2];
  }
};

/// Hits where the other has none, or further off than single precision explains.
std::size_t different(const std::vector<float>& a, const std::vector<float>& b, float size) {
  constexpr float same = 1e-4f;
  std::size_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    count += (a[i] == none) != (b[i] == none) || (a[i] != none && std::abs(a[i] - b[i]) > same * size);
  return count;
}

void measure(const char* name, const Rays& rays, float size, std::size_t rounds, std::vector<Column>& columns) {
  for (Column& column : columns) {
    column.hits.assign(rays.size(), none);
    column.seconds.clear();
  }
  for (std::size_t round = 0; round < rounds; ++round)
    for (Column& column : columns) {
      const std::clock_t start = std::clock();
      column.contender->trace(rays, 10 * size, column.hits);
      column.seconds.push_back(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    }
  const Column& ceiling = columns.back();
  for (const Column& column : columns) {
    const auto hits = rays.size() - static_cast<std::size_t>(std::count(column.hits.begin(), column.hits.end(), none));
    std::printf("| %-7s | %-13s | %7.3f | %6.0f | %5.2f | %7zu | %6zu |\n", name, column.name.c_str(),
                column.rate() * 1e-6, 1e9 / column.rate(), column.rate() / ceiling.rate(), hits,
                different(column.hits, ceiling.hits, size));
  }
}

int run(int argc, char** argv) {
  std::size_t count = 100'000, rounds = 9;
  std::string only = ".*", path;
  CommandLine("Rays at a mesh, one at a time on one thread, beside Bullet and Embree.")
      .file("--mesh", path, "a mesh of one's own (OBJ)")
      .number("--rays", count, "rays of a kind")
      .number("--rounds", rounds, "of which the median is taken")
      .expression("--only", only, "only libraries whose names match")
      .read(argc, argv);
  Soup soup = !path.empty() ? read_obj(path.c_str()) : bumpy_torus();
  for (const Vec3f& p : soup.points) soup.bounds = merged(soup.bounds, Aabbf{p, p});
  if (soup.triangles.empty()) {
    std::fprintf(stderr, "bench_rays: no triangles\n");
    return 1;
  }
  std::vector<Column> columns;
  const std::regex wanted(only);
  const auto add = [&](const char* name, auto make) {
    if (std::regex_search(name, wanted)) columns.push_back({name, make()});
  };
  add("graze", [&] { return std::make_unique<Graze>(soup); });
  add("graze batch", [&] { return std::make_unique<GrazeBatch>(soup); });
#ifdef GRAZE_BENCH_BULLET
  add("bullet", [&] { return std::make_unique<Bullet>(soup); });
#endif
#ifdef GRAZE_BENCH_EMBREE
  add("embree fast", [&] { return std::make_unique<Embree>(soup, false); });
  add("embree robust", [&] { return std::make_unique<Embree>(soup, true); });
#endif
  if (columns.empty()) return 1;
  std::printf("%zu triangles; rates and differences against %s; median of %zu rounds\n\n", soup.triangles.size(),
              columns.back().name.c_str(), rounds);
  std::printf("| rays    | library       | M/s     | ns     | ratio | hits    | differ |\n");
  std::printf("|---------|---------------|--------:|-------:|------:|--------:|-------:|\n");
  const float size = length(soup.bounds.extent());
  measure("camera", camera_rays(soup, count), size, rounds, columns);
  measure("shadow", shadow_rays(soup, count), size, rounds, columns);
  measure("random", random_rays(soup, count), size, rounds, columns);
  return 0;
}

}  // namespace

}  // namespace graze::bench

int main(int argc, char** argv) { return graze::bench::run(argc, argv); }
