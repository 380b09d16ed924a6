#include "io/gltf_animation.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace graze::io {

namespace {

using Numbers = std::shared_ptr<const std::vector<float>>;

/// The kinds of numbers that an accessor is read as.
enum class Meaning : std::uint8_t { times, vectors, rotations, spline_rotations };

std::size_t width_of(Meaning meaning) { return meaning == Meaning::times ? 1 : meaning == Meaning::vectors ? 3 : 4; }

std::string place(const JsonValue& index, std::size_t i) {
  return "accessors[" + index.json().dump() + "][" + std::to_string(i) + "]";
}

/// Checks times by glTF 2.0, section 3.11: the first is not negative, and each is later than the one before.
void check_times(const std::vector<float>& times, const JsonValue& index) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto time = static_cast<double>(times[i]);
    if (i == 0 && time < 0) validate::fail(place(index, i), "a time of at least 0", time);
    if (i > 0 && !(times[i] > times[i - 1]))
      validate::fail(place(index, i), "a time later than the one before, " + validate::number(double(times[i - 1])),
                     time);
  }
}

/// Checks rotations. Only the keys of a spline are rotations; its tangents may be anything.
void check_rotations(const std::vector<float>& values, const JsonValue& index, bool spline) {
  for (std::size_t i = spline ? 1 : 0; 4 * i + 3 < values.size(); i += spline ? 3 : 1) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(4 * i);
    if (std::all_of(at, at + 4, [](float v) { return v == 0; }))
      throw InvalidValue(place(index, i), "a quaternion that is not zero", "[0,0,0,0]");
  }
}

class AnimationReader {
 public:
  AnimationReader(const GltfDocument& document, std::shared_ptr<const NodeTree> tree)
      : document_(document), tree_(std::move(tree)) {}

  Animation read(const JsonValue& json, std::size_t index) {
    Animation animation;
    const auto name = json.find("name");
    animation.name = name ? name->string() : "animation " + std::to_string(index);
    auto tracks = std::make_shared<AnimationTracks>();
    tracks->tree = tree_;
    const auto samplers = json.at("samplers").elements();
    std::set<std::pair<std::size_t, std::string>> moved;
    for (const JsonValue& channel : json.at("channels").elements()) {
      const JsonValue sampler = channel.at("sampler"), target = channel.at("target");
      if (sampler.whole_number() >= samplers.size()) sampler.fail("an index below " + std::to_string(samplers.size()));
      const JsonValue path = target.at("path");
      const std::string property = path.string();
      const auto node = target.find("node");
      if (!node) continue;  // for an extension; others are to ignore it
      const std::size_t at = checked_node(*node);
      if (!moved.insert({at, property}).second) path.fail("a property of its node that no other channel moves");
      const auto moving = property_of(path);
      if (!moving) continue;
      tracks->channels.push_back({at, *moving, read_keys(samplers[sampler.whole_number()], *moving)});
      animation.duration = std::max(animation.duration, tracks->channels.back().keys.duration());
    }
    animation.tracks = std::move(tracks);
    return animation;
  }

  std::size_t weights() const { return weights_; }
  std::size_t unknown() const { return unknown_; }

 private:
  std::size_t checked_node(const JsonValue& node) const {
    const std::size_t at = node.whole_number();
    if (at >= tree_->nodes.size()) node.fail("an index below " + std::to_string(tree_->nodes.size()));
    if (document_.json().at("nodes").at(at).contains("matrix"))
      node.fail("a node without a matrix, which no channel can move");
    return at;
  }

  std::optional<NodeProperty> property_of(const JsonValue& path) {
    const std::string name = path.string();
    if (name == "translation") return NodeProperty::translation;
    if (name == "rotation") return NodeProperty::rotation;
    if (name == "scale") return NodeProperty::scale;
    ++(name == "weights" ? weights_ : unknown_);
    return std::nullopt;
  }

  Keyframes read_keys(const JsonValue& sampler, NodeProperty property) {
    Keyframes keys;
    if (const auto kind = sampler.find("interpolation")) {
      const std::string name = kind->string();
      if (name == "STEP")
        keys.interpolation = Interpolation::step;
      else if (name == "CUBICSPLINE")
        keys.interpolation = Interpolation::cubic_spline;
      else if (name != "LINEAR")
        kind->fail("one of STEP, LINEAR, CUBICSPLINE");
    }
    const bool spline = keys.interpolation == Interpolation::cubic_spline;
    const Meaning meaning = property != NodeProperty::rotation ? Meaning::vectors
                            : spline                           ? Meaning::spline_rotations
                                                               : Meaning::rotations;
    const JsonValue input = sampler.at("input"), output = sampler.at("output");
    keys.times = numbers(input, Meaning::times);
    const std::size_t count = keys.times->size(), least = spline ? 2 : 1;
    if (count < least)
      throw InvalidValue(input.path(), "at least " + std::to_string(least) + " keyframes", std::to_string(count));
    keys.values = numbers(output, meaning);
    const std::size_t wanted = spline ? 3 * count : count, found = keys.values->size() / width_of(meaning);
    if (found != wanted)
      throw InvalidValue(output.path(),
                         std::to_string(wanted) + " values, " + (spline ? "three" : "one") + " for each of " +
                             std::to_string(count) + " times",
                         std::to_string(found));
    return keys;
  }

  /// The numbers of an accessor, read and checked once however many samplers share them.
  Numbers numbers(const JsonValue& index, Meaning meaning) {
    Numbers& known = read_[{index.whole_number(), meaning}];
    if (!known) known = read_numbers(index, meaning);
    return known;
  }

  Numbers read_numbers(const JsonValue& index, Meaning meaning) {
    const std::size_t width = width_of(meaning);
    const Elements elements = document_.elements(index, width);
    const bool rotations = width == 4;
    if (!elements.fractional() || (!rotations && !elements.is_float()))
      throw InvalidValue("accessors[" + index.json().dump() + "].componentType",
                         rotations ? "floats, or normalized bytes or shorts, for rotations" : "floats",
                         std::to_string(elements.component()));
    if (elements.count() > numbers_left_ / width)
      throw InvalidValue("accessors[" + index.json().dump() + "].count",
                         "at most " + std::to_string(max_key_numbers) + " numbers in all keyframes of a file", "more");
    numbers_left_ -= elements.count() * width;
    std::vector<float> out;
    out.reserve(elements.count() * width);
    for (std::size_t i = 0; i < elements.count(); ++i)
      for (std::size_t k = 0; k < width; ++k) {
        out.push_back(elements.number(i, k));
        if (!std::isfinite(out.back())) validate::fail(place(index, i), "finite numbers", double(out.back()));
      }
    if (meaning == Meaning::times) check_times(out, index);
    if (rotations) check_rotations(out, index, meaning == Meaning::spline_rotations);
    return std::make_shared<const std::vector<float>>(std::move(out));
  }

  const GltfDocument& document_;
  std::shared_ptr<const NodeTree> tree_;
  std::map<std::pair<std::size_t, Meaning>, Numbers> read_;
  std::size_t numbers_left_ = max_key_numbers, weights_ = 0, unknown_ = 0;
};

}  // namespace

std::vector<Animation> read_animations(const GltfDocument& document, std::shared_ptr<const NodeTree> tree,
                                       std::vector<std::string>& notices) {
  std::vector<Animation> animations;
  const auto list = JsonValue(document.json(), "").find("animations");
  if (!list) return animations;
  AnimationReader reader(document, std::move(tree));
  for (const JsonValue& animation : list->elements()) animations.push_back(reader.read(animation, animations.size()));
  if (reader.weights() > 0)
    notices.push_back(std::to_string(reader.weights()) + " channels of weights are skipped: meshes keep their points");
  if (reader.unknown() > 0)
    notices.push_back(std::to_string(reader.unknown()) + " channels of unknown paths are skipped");
  return animations;
}

}  // namespace graze::io
