// Scenes of the plane: drawings as shapes, what of a file is refused, and which pairs touch.
#include "graze/io/plane_scene.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <random>
#include <set>

#include "graze/error.hpp"
#include "graze/io/collide.hpp"
#include "graze/io/plane_simulate.hpp"
#include "graze/plane/mass.hpp"
#include "graze/plane/query.hpp"
#include "io/svg_path.hpp"

namespace graze::io {
namespace {

PlaneScene svg(const std::string& inside) {
  return load_plane_svg("<svg xmlns=\"http://www.w3.org/2000/svg\">" + inside + "</svg>", "t.svg");
}

/// What a drawing is refused with.
std::string refused(const std::string& inside) {
  try {
    svg(inside);
  } catch (const InvalidValue& e) {
    return e.what();
  }
  return "nothing";
}

/// The distance of a point of the drawing from its only shape.
double at(const PlaneScene& scene, double x, double y, std::size_t i = 0) {
  const PlaneCollider& c = scene.colliders.at(i);
  return plane::closest(c.shape, c.pose, plane::Vec2d{x, -y}).distance;
}

TEST(PlaneSvg, ElementsBecomeTheShapesThatTheyDraw) {
  EXPECT_NEAR(at(svg(R"x(<circle cx="3" cy="4" r="2"/>)x"), 3, 9), 3, 1e-12);
  EXPECT_NEAR(at(svg(R"x(<rect x="1" y="2" width="4" height="2"/>)x"), 6, 3), 1, 1e-12);
  EXPECT_NEAR(at(svg(R"x(<rect width="4" height="4" rx="1"/>)x"), 5, 5), std::sqrt(8.0) - 1, 1e-12);
  EXPECT_NEAR(at(svg(R"x(<ellipse rx="3" ry="1"/>)x"), 5, 0), 2, 1e-9);
  EXPECT_NEAR(at(svg(R"x(<ellipse rx="3" ry="1"/>)x"), 0, 5), 4, 1e-9);
  EXPECT_NEAR(at(svg(R"x(<line x1="0" y1="0" x2="4" y2="0" data-margin="0.5"/>)x"), 2, 3), 2.5, 1e-12);
  EXPECT_NEAR(at(svg(R"x(<polyline points="0,0 4,0 4,4"/>)x"), 2, 2), 2, 1e-12);  // a chain has no inside
  EXPECT_NEAR(at(svg(R"x(<polygon points="0 0 4 0 4 4 0 4"/>)x"), 2, 1), -1, 1e-12);
  EXPECT_NEAR(at(svg(R"x(<polygon points="0 0 4 0 4 4 0 4" data-solid="false"/>)x"), 2, 1), 1, 1e-12);
  EXPECT_NEAR(at(svg(R"x(<path d="M0 0h4v4H0z"/>)x"), 2, 1), -1, 1e-12);
  EXPECT_NEAR(at(svg(R"x(<path d="m1,1 4,0 0,4"/>)x"), 3, 2), 1, 1e-12);
}

TEST(PlaneSvg, TransformsMoveTurnStretchAndMirror) {
  const char* moved = R"x(<g transform="translate(10 20) rotate(90)"><rect x="-2" y="-1" width="4" height="2"/></g>)x";
  EXPECT_NEAR(at(svg(moved), 10, 23), 1, 1e-12);
  EXPECT_NEAR(at(svg(moved), 12, 20), 1, 1e-12);
  EXPECT_NEAR(at(svg(R"x(<circle r="1" transform="scale(3 1)"/>)x"), 5, 0), 2, 1e-9);
  EXPECT_NEAR(at(svg(R"x(<circle r="1" transform="scale(-2)"/>)x"), 5, 0), 3, 1e-12);
  EXPECT_NEAR(at(svg(R"x(<rect width="2" height="2" transform="skewX(45)"/>)x"), 3, 1), 0, 1e-12);
  EXPECT_NEAR(at(svg(R"x(<rect width="2" height="1" transform="matrix(0 1 1 0 5 5)"/>)x"), 5.5, 8), 1, 1e-12);
  EXPECT_NEAR(at(svg(R"x(<rect width="2" height="2" transform="rotate(45, 1, 1)"/>)x"), 1, 1 + std::sqrt(2.0) + 1), 1,
              1e-12);
}

/// An <svg> inside another is a viewport of its own; that at the root has the numbers of the drawing.
TEST(PlaneSvg, InnerDrawingsHaveTheirPlaceAndSize) {
  const auto inner = [](const std::string& attributes) {
    return svg("<svg " + attributes + R"x("><rect width="2" height="2"/></svg>)x");
  };
  EXPECT_NEAR(at(inner(R"x(x="50" y="7)x"), 53, 8), 1, 1e-12);
  EXPECT_NEAR(at(inner(R"x(transform="scale(2)" x="50)x"), 105, 1), 1, 1e-12);
  // Ten units over twenty by forty: twice as large, ten units below the top.
  EXPECT_NEAR(at(inner(R"x(x="50" width="20" height="40" viewBox="-1 -1 10 10)x"), 58, 14), 2, 1e-12);
  const std::string box = R"x(width="20" height="40" viewBox="0 0 10 10" preserveAspectRatio=")x";
  EXPECT_NEAR(at(inner(box + "none"), 2, 9), 1, 1e-12);
  EXPECT_NEAR(at(inner(box + "xMinYMax"), 2, 19), 1, 1e-12);
  EXPECT_NEAR(at(inner(box + "xMaxYMin slice"), -11, 4), 1, 1e-12);
  EXPECT_NE(refused(R"x(<svg viewBox="0 0 1 1"/>)x").find("width"), std::string::npos);
  EXPECT_NE(refused(R"x(<svg width="1" height="1" viewBox="0 0 0 1"/>)x").find("above 0"), std::string::npos);
  EXPECT_NE(refused("<svg " + box + "middle\"/>").find("xMidYMid"), std::string::npos);
  EXPECT_NE(refused(R"x(<svg x="50%"/>)x").find("50%"), std::string::npos);
  EXPECT_NEAR(at(load_plane_svg(R"x(<svg viewBox="5 5 1 1" width="9"><circle r="1"/></svg>)x", "t.svg"), 3, 0), 2,
              1e-12);
}

/// A style may move an element in words of its own, which are refused and not passed over.
TEST(PlaneSvg, TransformsInStylesAreRefused) {
  for (const char* style : {"transform: translate(50px)", "fill:red;rotate:45deg", "transform:none; scale:2"})
    EXPECT_NE(refused("<g style='" + std::string(style) + "'><circle r='1'/></g>").find("style: expected a transform"),
              std::string::npos)
        << style;
  EXPECT_EQ(refused("<circle r='1' style='transform:none;transform-origin:1px 1px;fill:none'/>"), "nothing");
}

/// The pieces of a path are one body, which does not touch itself, and not that of another path without a name.
TEST(PlaneSvg, PiecesOfAPathAreOneBody) {
  for (const char* id : {"id='p'", ""}) {
    const std::string path = "<path " + std::string(id) + " d='M0 0 L5 0 M5 0 L15 0'";
    const PlaneScene scene = svg(path + "/>");
    ASSERT_EQ(scene.colliders.size(), 2u);
    EXPECT_EQ(scene.bodies.size(), 1u);
    EXPECT_TRUE(collide(scene).empty());
    EXPECT_EQ(svg(path + "/>" + path + "/>").bodies.size(), 2u);
    EXPECT_EQ(svg(path + " data-body='b'/><circle cx='40' r='1' data-body='b'/>").bodies.size(), 1u);
  }
  const PlaneScene moving = svg("<path class='dynamic' data-mass='2' data-inertia='50' d='M0 0 L5 0 M5 0 L15 0'/>");
  SimulateOptions options;
  options.seconds = 1;
  std::vector<PlaneSimulationFrame> frames;
  simulate(moving, options, [&](const PlaneSimulationFrame& frame) { frames.push_back(frame); });
  ASSERT_EQ(frames.back().bodies.size(), 1u);
  EXPECT_NEAR(frames.back().bodies[0].translation.y, -4.905, 0.1);
  EXPECT_NEAR(frames.back().bodies[0].rotation, 0, 1e-9);
}

TEST(PlaneSvg, CurvesStayWithinTheTolerance) {
  // Quarter circles, by an arc and by Bezier curves, against the circle itself.
  for (const double tolerance : {0.1, 0.01, 0.001}) {
    const PlaneScene arc =
        svg(fmt::format(R"x(<path data-tolerance="{}" d="M-5 0A5 5 0 0 1 5 0A5 5 0 0 1-5 0Z"/>)x", tolerance));
    const double area = plane::mass_properties(arc.colliders[0].shape).area;
    EXPECT_LE(area, 25 * std::acos(-1.0));
    EXPECT_GE(area, 25 * std::acos(-1.0) - 2 * std::acos(-1.0) * 5 * tolerance);
    for (int i = 0; i < 100; ++i) {
      const double angle = 0.0628 * i;
      EXPECT_LE(std::abs(at(arc, 5 * std::cos(angle), 5 * std::sin(angle))), tolerance * 1.0001);
    }
    // By de Casteljau at many parameters.
    const PlaneScene cubic =
        svg(fmt::format(R"x(<path data-tolerance="{}" d="M0 0C3 8 7-8 10 1Q14 9 18 1T26 1"/>)x", tolerance));
    for (int i = 0; i <= 100; ++i) {
      const double t = i / 100.0, s = 1 - t;
      EXPECT_LE(at(cubic, 9 * s * s * t + 21 * s * t * t + 10 * t * t * t, 24 * s * s * t - 24 * s * t * t + t * t * t),
                tolerance);
      EXPECT_LE(at(cubic, 10 * s * s + 28 * s * t + 18 * t * t, s * s + 18 * s * t + t * t), tolerance);
      EXPECT_LE(at(cubic, 18 * s * s + 44 * s * t + 26 * t * t, s * s - 14 * s * t + t * t), tolerance);  // mirrored
    }
  }
  EXPECT_NE(refused(R"x(<path data-tolerance="1e-12" d="M0 0Q5 9 10 0"/>)x").find("tolerance"), std::string::npos);
}

TEST(PlaneSvg, RolesAreInherited) {
  const PlaneScene scene = svg(R"x(
    <g class="dynamic big" data-systems="a b">
      <rect id="one" width="1" height="1"/>
      <g data-body="pair" data-motion="kinematic"><rect width="1" height="1"/><circle r="1"/></g>
      <circle class="trigger" r="1" data-collide-with="b"/>
    </g>
    <circle r="1" data-not-collide-with="a b"/><rect width="3" height="3" display="none"/>
    <circle r="1" style="fill:red; display: none"/><defs><circle r="9"/></defs><text>words</text>)x");
  ASSERT_EQ(scene.colliders.size(), 5u);
  ASSERT_EQ(scene.bodies.size(), 4u);
  EXPECT_EQ(scene.colliders[0].name, "one");
  EXPECT_EQ(scene.bodies[0].type, MotionType::dynamic);
  EXPECT_EQ(scene.bodies[1].name, "pair");
  EXPECT_EQ(scene.bodies[1].type, MotionType::kinematic);
  EXPECT_EQ(scene.colliders[1].body, scene.colliders[2].body);
  EXPECT_FALSE(may_collide(scene.colliders[1].filter, scene.colliders[2].filter));
  EXPECT_TRUE(may_collide(scene.colliders[0].filter, scene.colliders[1].filter));
  EXPECT_TRUE(scene.colliders[3].trigger);
  EXPECT_FALSE(scene.colliders[2].trigger);
  EXPECT_TRUE(may_collide(scene.colliders[0].filter, scene.colliders[3].filter));
  EXPECT_FALSE(may_collide(scene.colliders[0].filter, scene.colliders[4].filter));
  EXPECT_EQ(scene.bodies[3].type, MotionType::fixed);
  ASSERT_EQ(scene.notices.size(), 1u);
  EXPECT_NE(scene.notices[0].find("<text>"), std::string::npos);
}

TEST(PlaneSvg, WhatIsWrongIsNamed) {
  const auto names = [](const std::string& drawing, std::initializer_list<const char*> words) {
    const std::string why = refused(drawing);
    for (const char* word : words) EXPECT_NE(why.find(word), std::string::npos) << why << " lacks " << word;
  };
  names("<circle id='sun' r='-1'/>", {"t.svg: line 1: <circle id=", "sun", "r", ">= 0", "-1"});
  names("<rect width='1em' height='1'/>", {"width", "px", "1em"});
  names("<rect width='4' height='2' rx='1' ry='0.5'/>", {"ry"});
  names("<rect width='4' height='2' rx='1' transform='scale(1 2)'/>", {"transform", "round"});
  names("<path d='L1 1'/>", {"begins with M"});
  names("<path d='M0 0 X'/>", {"commands"});
  names("<path d='M0 0 L1'/>", {"a number", "the end"});
  names("<path d='M0 0 L1 1e999'/>", {"finite number"});
  names("<path d='M0 0 A1 1 0 2 0 4 4'/>", {"flag"});
  names("<path d='M0 0h1v1z m3 3h1v1z'/>", {"one closed outline", "2"});
  names("<polygon id='bow' points='0,0 4,4 4,0 0,4'/>", {"bow", "meets no other"});
  names("<polygon points='0,0 4'/>", {"two numbers a point"});
  names("<g transform='turn(3)'><circle r='1'/></g>", {"transform", "rotate"});
  names("<circle r='1' data-motion='flying'/>", {"data-motion", "static, kinematic, dynamic", "flying"});
  names("<circle r='1' data-body='x'/><circle class='dynamic' r='1' data-body='x'/>", {"one motion", "x"});
  names("<circle cx='1e60' r='1'/>", {"position"});
  names("<rect width='1' height='1'>", {"XML"});
  EXPECT_THROW(load_plane_svg("", "t.svg"), InvalidValue);
  EXPECT_THROW(load_plane_svg("<html/>", "t.svg"), InvalidValue);
  std::string systems;
  for (int i = 0; i < 70; ++i) systems += " s" + std::to_string(i);
  names("<circle r=\"1\" data-systems=\"" + systems + "\"/>", {"63 collision systems"});
}

TEST(PlaneSvg, NoFileCanExhaustTheProcess) {
  // Entities are not expanded, ten levels of ten or not.
  std::string bomb = "<!DOCTYPE svg [<!ENTITY a0 \"ha\">";
  for (int i = 1; i < 10; ++i) {
    bomb += fmt::format("<!ENTITY a{} \"", i);
    for (int k = 0; k < 10; ++k) bomb += fmt::format("&a{};", i - 1);
    bomb += "\">";
  }
  try {
    EXPECT_TRUE(load_plane_svg(bomb + "]><svg><text>&a9;</text></svg>", "bomb.svg").colliders.empty());
  } catch (const InvalidValue&) {
  }
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<g>";
  EXPECT_NE(refused(deep).find("XML"), std::string::npos);
  std::string path = "<path d=\"M0 0";
  for (int i = 0; i < 200000; ++i) path += "h1v1";
  EXPECT_NE(refused(path + "\"/>").find("100000"), std::string::npos);
  // A path of a few words whose curves would need more points than fit.
  std::string curves = "<path data-tolerance=\"1e-6\" d=\"M0 0";
  for (int i = 0; i < 3000; ++i) curves += "c9 9 9 9 9 0";
  EXPECT_NE(refused(curves + "\"/>").find("100000"), std::string::npos);
  std::string wheel;
  for (int i = 0; i < 30000; ++i) wheel += fmt::format("{},{} ", 1e3 * std::cos(i * 2e-4), 1e3 * std::sin(i * 2e-4));
  EXPECT_NE(refused("<polygon points=\"" + wheel + "\"/>").find("fewer points"), std::string::npos);
  EXPECT_EQ(svg("<polyline points=\"" + wheel + "\"/>").colliders.size(), 1u);
}

/// A shape's points are about its middle, and whoever looks for a refused one in the drawing is told where that is.
TEST(PlaneSvg, AnOutlineThatCrossesItself) {
  const std::string crossed = refused("<polygon points='10,10 30,30 30,10 10,30'/>");
  EXPECT_NE(crossed.find("points[0]"), std::string::npos) << crossed;
  EXPECT_NE(crossed.find("[-10, 10] from the middle [20, -20]"), std::string::npos) << crossed;
}

TEST(PlaneJson, BodiesOfTheProtocol) {
  const PlaneScene scene = load_plane_json(
      R"x({"dimension": 2, "bodies": [
          {"name": "floor", "shape": {"type": "plane"}},
          {"name": "crate", "motion": "dynamic", "translation": [0, 0.45], "rotation": 0, "shape": {"type": "box", "box": {"size": [1, 1]}}},
          {"motion": "dynamic", "trigger": true, "systems": ["t"], "shape": {"type": "circle", "circle": {"radius": 1}}, "translation": [3, 0.5]}]})x",
      "t.json");
  const auto pairs = collide(scene);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(scene.colliders[pairs[0].a].name, "floor");
  EXPECT_NEAR(pairs[0].distance(), -0.05, 1e-12);
  EXPECT_EQ(pairs[0].point_count(), 2u);
  EXPECT_TRUE(pairs[1].trigger);
  for (const char* wrong : {"[]", "{}", R"x({"dimension": 3, "bodies": []})x", R"x({"dimension": 2, "bodies": [{}]})x",
                            R"x({"dimension": 2, "bodies": [{"shape": {"type": "plane"}, "motion": "up"}]})x",
                            R"x({"dimension": 2, "bodies": [{"shape": {"type": "plane"}, "colour": 1}]})x",
                            R"x({"dimension": 2, "bodies": [{"shape": {"type": "box", "box": {"size": [-1, 1]}}}]})x"})
    EXPECT_THROW(load_plane_json(wrong, "t.json"), InvalidValue) << wrong;
}

/// Every word of a scene, and every number to the last bit but those of turns.
void expect_same(const PlaneScene& a, const PlaneScene& b) {
  EXPECT_EQ(a.gravity, b.gravity);
  EXPECT_EQ(a.collision_systems.size(), b.collision_systems.size());
  ASSERT_EQ(a.bodies.size(), b.bodies.size());
  for (std::size_t i = 0; i < a.bodies.size(); ++i) {
    EXPECT_EQ(a.bodies[i].name, b.bodies[i].name);
    EXPECT_EQ(a.bodies[i].type, b.bodies[i].type);
    EXPECT_EQ(a.bodies[i].motion, b.bodies[i].motion);
  }
  const auto bits = [](const PlaneScene& scene, std::uint64_t mask) {
    std::set<std::string> names;
    for (std::size_t k = 0; k < scene.collision_systems.size(); ++k)
      if (mask >> k & 1) names.insert(scene.collision_systems[k]);
    if (mask >> 63) names.insert("no system");
    return names;
  };
  ASSERT_EQ(a.colliders.size(), b.colliders.size());
  for (std::size_t i = 0; i < a.colliders.size(); ++i) {
    const PlaneCollider &p = a.colliders[i], &q = b.colliders[i];
    EXPECT_EQ(p.name, q.name);
    EXPECT_EQ(p.body, q.body);
    EXPECT_EQ(p.trigger, q.trigger);
    EXPECT_EQ(bits(a, p.filter.category), bits(b, q.filter.category)) << p.name;
    EXPECT_EQ(bits(a, p.filter.mask), bits(b, q.filter.mask)) << p.name;
    EXPECT_EQ(p.shape.index(), q.shape.index());
    EXPECT_EQ(p.shape.rounding(), q.shape.rounding());
    EXPECT_EQ(p.pose.translation, q.pose.translation);
    EXPECT_NEAR(p.pose.rotation.sine, q.pose.rotation.sine, 1e-15);
    EXPECT_NEAR(p.pose.rotation.cosine, q.pose.rotation.cosine, 1e-15);
    const auto box_p = plane::bounds(p.shape, {}), box_q = plane::bounds(q.shape, {});
    EXPECT_TRUE(box_p.lower == box_q.lower && box_p.upper == box_q.upper) << p.name;
  }
}

TEST(PlaneJson, AWrittenSceneIsReadAgain) {
  const PlaneScene drawn = svg(R"x(<g data-systems="a b" data-collide-with="b"><circle r="1"/></g>
      <rect id="&quot;r&quot;" width="3" height="2" rx="0.3" transform="rotate(30)" data-not-collide-with="a c"/>
      <g class="dynamic" data-body="cart" data-mass="2" data-velocity="1 2" data-angular="3" data-friction="0.1">
        <circle cx="9" r="1"/><ellipse cx="12" rx="2" ry="1"/></g>
      <polygon class="kinematic" points="0 0 4 0 4 4 2 1" data-margin="0.25" data-restitution="0.5"/>
      <polyline class="trigger" points="0,9 4,9 4,12" data-sides="one"/><line x2="4" data-inertia="3"/>)x");
  expect_same(load_plane_json(to_json(drawn), "t.json"), drawn);
  const PlaneScene told = load_plane_json(R"x({"dimension": 2, "gravity": [0, -3], "bodies": [
      {"shape": {"type": "plane"}}, {"shape": {"type": "convex", "convex": {"points": [[0, 0], [1, 0], [0, 1]]}}},
      {"name": "c", "rotation": 0.3, "shape": {"type": "capsule", "capsule": {"height": 1, "radiusBottom": 1, "radiusTop": 0.5}}},
      {"body": "two", "shape": {"type": "compound", "compound": {"children": [{"shape": {"type": "box", "box":
        {"size": [1, 2]}}, "translation": [3, 4], "rotation": 1}]}}}]})x",
                                          "t.json");
  expect_same(load_plane_json(to_json(told), "t.json"), told);
  const PlaneScene example = load_plane_scene(std::string(GRAZE_SOURCE_DIR) + "/examples/scenes/plane.svg");
  expect_same(load_plane_json(to_json(example), "t.json"), example);
}

TEST(PlaneCollide, FindsThePairsOfABruteForce) {
  std::mt19937 random(3);
  const auto u = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  std::string drawing;
  for (int i = 0; i < 120; ++i) {
    const char* kind = i % 4 == 0 ? "static" : "dynamic";
    const double x = u(0, 40), y = u(0, 40);
    switch (i % 5) {
    case 0:
      drawing +=
          fmt::format(R"x(<rect class="{}" x="{}" y="{}" width="{}" height="{}"/>)x", kind, x, y, u(1, 6), u(1, 6));
      break;
    case 1: drawing += fmt::format(R"x(<circle class="{}" cx="{}" cy="{}" r="{}"/>)x", kind, x, y, u(1, 3)); break;
    case 2:
      drawing += fmt::format(R"x(<ellipse class="{}" cx="{}" cy="{}" rx="{}" ry="1"/>)x", kind, x, y, u(1, 4));
      break;
    case 3:
      drawing +=
          fmt::format(R"x(<polyline class="{}" points="{},{} {},{} {},{}"/>)x", kind, x, y, x + 3, y + 1, x + 5, y - 1);
      break;
    default: drawing += fmt::format(R"x(<path class="{}" d="M{} {}q4 0 4 4l-2-2z"/>)x", kind, x, y); break;
    }
  }
  const PlaneScene scene = svg(drawing);
  for (const double margin : {0.0, 0.5}) {
    CollideOptions options;
    options.margin = margin;
    const auto pairs = collide(scene, options);
    std::size_t next = 0, found = 0;
    for (std::uint32_t i = 0; i < scene.colliders.size(); ++i)
      for (std::uint32_t k = i + 1; k < scene.colliders.size(); ++k) {
        const PlaneCollider &a = scene.colliders[i], &b = scene.colliders[k];
        const bool listed = next < pairs.size() && pairs[next].a == i && pairs[next].b == k;
        const bool overlap = plane::overlap(a.shape, a.pose, b.shape, b.pose);
        if (scene.bodies[a.body].type == MotionType::fixed && scene.bodies[b.body].type == MotionType::fixed) {
          EXPECT_FALSE(listed);
          continue;
        }
        if (overlap) {
          ASSERT_TRUE(listed) << a.name << " " << b.name;
          EXPECT_TRUE(pairs[next].overlap);
        }
        if (listed) {
          ++found, ++next;
          EXPECT_LE(plane::distance(a.shape, a.pose, b.shape, b.pose).distance, margin + 1e-9);
        }
      }
    EXPECT_EQ(next, pairs.size());
    EXPECT_GT(found, 50u);
    options.precision = Precision::single_precision;
    const auto in_float = collide(scene, options);
    EXPECT_NEAR(double(in_float.size()), double(pairs.size()), 2);
  }
  CollideOptions one_point;
  one_point.points_per_pair = 1;
  const auto all = collide(scene), few = collide(scene, one_point);
  ASSERT_EQ(few.size(), all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(few[i].point_count(), std::min<std::size_t>(1, all[i].point_count()));
    EXPECT_TRUE(all[i].point_count() == 0 || few[i].distance() == all[i].distance());
  }
  const std::string picture = draw_picture(scene, collide(scene));
  EXPECT_TRUE(picture.ends_with("</svg>\n"));
  EXPECT_EQ(picture.find("nan"), std::string::npos);
}

}  // namespace
}  // namespace graze::io
