#include "resolution_run.hpp"

#include <algorithm>
#include <cmath>

#include "graze/world.hpp"
#include "resolution_bowl.hpp"
#include "table.hpp"

namespace graze::bench {

Thing floor_with(double friction, double restitution) {
  Thing floor;
  floor.form = Form::floor;
  floor.density = 0;
  floor.friction = friction;
  floor.restitution = restitution;
  return floor;
}

Thing box(const Vec3d& at, const Vec3d& size, double density) {
  Thing thing;
  thing.size = size;
  thing.pose.translation = at;
  thing.density = density;
  return thing;
}

Thing round(Form form, const Vec3d& at, double radius, double height) {
  Thing thing;
  thing.form = form;
  thing.size = {radius, height, radius};
  thing.pose.translation = at;
  return thing;
}

Quatd about(const Vec3d& axis, double angle) { return Quatd::from_axis_angle(axis, angle); }

Run::Run(const EngineKind& kind, std::vector<Thing> things, const EngineOptions& options)
    : things_(std::move(things)), options_(options), engine_(kind.make(options)) {
  for (const Thing& thing : things_) engine_->add(thing);
}

Vec3d Run::angular_momentum(std::size_t i) const {
  const Moving m = moving(i);
  return rotate(m.pose.rotation, scaled(rotate(conjugate(m.pose.rotation), m.angular), mass_of(things_[i]).inertia));
}

double Run::kinetic_energy() const {
  double sum = 0;
  for (std::size_t i = 0; i < things_.size(); ++i) {
    if (things_[i].density == 0) continue;
    const Moving m = moving(i);
    sum += (mass_of(things_[i]).mass * length_squared(m.linear) + dot(m.angular, angular_momentum(i))) / 2;
  }
  return sum;
}

double Run::potential_energy() const {
  double sum = 0;
  for (std::size_t i = 0; i < things_.size(); ++i)
    if (things_[i].density > 0) sum -= mass_of(things_[i]).mass * dot(options_.gravity, at(i));
  return sum;
}

double Run::greatest_move() const {
  double most = 0;
  for (std::size_t i = 0; i < things_.size(); ++i)
    if (things_[i].density > 0) most = std::max(most, length(at(i) - things_[i].pose.translation));
  return most;
}

double Run::deepest() const {
  Worldd world;
  for (std::size_t i = 0; i < things_.size(); ++i) {
    const Thing& t = things_[i];
    Shaped shape = Box<double>(t.size);
    if (t.form == Form::ball) shape = Sphere<double>(t.size.x);
    if (t.form == Form::cylinder) shape = Cylinder<double>(t.size.y, t.size.x);
    if (t.form == Form::floor) shape = HalfSpace<double>();
    if (t.form == Form::bowl) shape = bowl_of(t.size.x).mesh<double>();
    world.add({.shape = shape, .pose = moving(i).pose, .fixed = t.density == 0});
  }
  world.update();
  double deepest = 0;
  for (const auto& point : world.contacts().points) deepest = std::max(deepest, -point.distance);
  return deepest;
}

std::string millimetres(double metres) { return printed(metres < 1e-2 ? "%.2f mm" : "%.0f mm", metres * 1e3); }
std::string joules(double energy) { return printed("%.1e J", energy); }

}  // namespace graze::bench
