// The animations of a glTF file: channels of keyframes, and the nodes that they move.
//
// Guarantee: animations that were read can be played at any time: every keyframe list satisfies `Keyframes`, every
// channel has a node that may be moved, and no two move the same property of one. They take no more than some 300 MB,
// whatever the file claims, besides the bytes of the file itself.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "graze/io/scene.hpp"
#include "io/gltf_document.hpp"
#include "io/gltf_node.hpp"
#include "io/keyframes.hpp"

namespace graze::io {

/// The most numbers that the keyframes of a file may have, all accessors together: ten minutes of a hundred
/// joints at 60 frames a second are 15 million numbers. Accessors may overlap, so that without a limit a megabyte
/// of file would become gigabytes.
inline constexpr std::size_t max_key_numbers = std::size_t{1} << 26;

enum class NodeProperty : std::uint8_t { translation, rotation, scale };

struct Channel {
  std::size_t node;
  NodeProperty property;
  Keyframes keys;
};

struct TreeNode {
  std::ptrdiff_t parent = -1;  ///< or -1 of a root
  NodeTransform rest{};        ///< meaningless with a matrix, which no channel moves
  Affine map{};                ///< the same, or the matrix
};

/// A collider as the file describes it: the shape before its node's map, and that map at rest.
struct RestCollider {
  Shaped shape;
  std::size_t node;
  Affine map;
};

/// The nodes of a file's scene and what hangs on them.
struct NodeTree {
  std::string source;
  std::vector<TreeNode> nodes;            ///< by their indices in the file
  std::vector<std::size_t> order;         ///< of those in the scene, parents first
  std::vector<RestCollider> colliders{};  ///< in the order of the scene's
  std::vector<std::size_t> bodies{};      ///< the nodes of the scene's bodies, in their order
};

struct AnimationTracks {
  std::shared_ptr<const NodeTree> tree;
  std::vector<Channel> channels;
};

/// All animations of a file. `notices` gets a sentence for whatever is left out. Throws `InvalidValue`.
std::vector<Animation> read_animations(const GltfDocument& document, std::shared_ptr<const NodeTree> tree,
                                       std::vector<std::string>& notices);

}  // namespace graze::io
