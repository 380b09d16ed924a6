// The answer of the query `response`.
#include "io/response.hpp"

namespace graze::io {

namespace {

template <class T>
bool finite(const Vec3<T>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}
template <class T>
bool finite(const Motion<T>& m) {
  return finite(m.linear) && finite(m.angular);
}

const char* name_of(AtFault fault) {
  switch (fault) {
  case AtFault::a: return R"("a")";
  case AtFault::b: return R"("b")";
  case AtFault::both: return R"("both")";
  case AtFault::neither: break;
  }
  return R"("neither")";
}

template <class T>
void write_motion(const char* body, const Motion<T>& motion, int dimension, JsonWriter& out) {
  out.key(body).open('{').key("linear").vector(motion.linear, dimension).key("angular");
  dimension == 2 ? out.number(motion.angular.z) : out.vector(motion.angular);
  out.close('}');
}

/// The quantities in the order in which they follow from each other.
template <class T>
void write_response_trace(const ResponseQuestion<T>& q, const Response<T>& r, JsonWriter& out) {
  const int d = q.dimension;
  out.key("trace").open('{').key("method").raw(R"("impulse")");
  out.key("point").vector(q.contact.point, d).key("normal").vector(q.contact.normal, d);
  out.key("relativeVelocity").open('{').key("whole").vector(r.approach.whole, d);
  out.key("normal").number(r.approach.normal).key("tangential").vector(r.approach.tangential, d).close('}');
  out.key("effectiveMass");
  std::isfinite(r.effective_mass) ? out.number(r.effective_mass) : out.raw(R"("infinity")");
  out.key("normalImpulse").number(r.normal_impulse);
  out.key("friction").open('{').key("sliding").vector(r.sliding, d);
  out.key("stopping").vector(r.stopping_impulse, d).key("limit").number(r.friction_limit);
  out.key("impulse").vector(r.friction_impulse, d).key("holds").value(r.holds()).close('}');
  out.key("atFault").raw(name_of(r.at_fault)).close('}');
}

}  // namespace

template <class T>
Response<T> answer_response(const ResponseQuestion<T>& q) {
  const Response<T> r = response(q.contact, q.a, q.b);
  if (!q.a.mass.movable() && !q.b.mass.movable() && r.approach.normal < T(0))
    throw InvalidValue("a.mass, b.mass", "a finite mass of one of two bodies that approach", "\"infinity\" twice");
  if (!finite(r.impulse) || !finite(r.a) || !finite(r.b))
    throw InvalidValue("a, b", "masses and velocities of which the products are finite numbers", "larger ones");
  return r;
}

template <class T>
void write_response(const ResponseQuestion<T>& q, JsonWriter& out) {
  const Response<T> r = answer_response(q);
  out.key("normalImpulse").number(r.normal_impulse).key("impulse").vector(r.impulse, q.dimension);
  write_motion("a", r.a, q.dimension, out);
  write_motion("b", r.b, q.dimension, out);
  if (q.explain) write_response_trace(q, r, out);
}

template Response<float> answer_response(const ResponseQuestion<float>&);
template Response<double> answer_response(const ResponseQuestion<double>&);
template void write_response(const ResponseQuestion<float>&, JsonWriter&);
template void write_response(const ResponseQuestion<double>&, JsonWriter&);

}  // namespace graze::io
