// The contacts of an island, coloured, and laid out in bundles for the kernels that solve them.
//
// Guarantee: the contacts of a colour that is not ordered stand in chunks of as many as a kernel has lanes. A chunk is
// a bundle for the first manifold of each of its contacts, one for the second of those that have one, and so on; its
// bundles are solved one after the other, chunks of a colour in any order, on any threads, with the same bits. Where a
// colour is ordered each contact is a chunk.
#pragma once

#include <cstddef>
#include <vector>

#include "dynamics/colors.hpp"
#include "dynamics/contact_kernels.hpp"

namespace graze {

template <class T, class Space>
class ContactBundles {
 public:
  using Bundle = ContactBundle<T, Space>;
  using Kernels = ContactKernels<T, Space>;

  explicit ContactBundles(Isa level = chosen_isa())
      : kernels_(&GRAZE_KERNEL(level, contact_kernels)().template of<T, Space>()) {}

  void clear();
  /// Adds the manifolds of a pair, which outlive the step.
  void add(const TouchingBodies<T, Space>& touching, std::span<const ContactManifold<T, Space>> manifolds);
  /// Colours and bundles the contacts that were added. `movable[i]`: whether body i can be pushed.
  void build(std::span<const std::uint8_t> movable);

  bool empty() const { return contacts_.empty(); }
  std::size_t color_count() const { return coloring_.colors().size(); }
  std::size_t point_count() const { return point_count_; }
  /// Calls `f` with the two bodies and each of their manifolds, in the order in which they were added.
  template <class F>
  void each_manifold(const F& f) const {
    for (const Contact& c : contacts_)
      for (const ContactManifold<T, Space>& m : c.found)
        if (m.point_count != 0) f(c.touching, m);
  }

  struct Color {
    std::uint32_t first_chunk, end_chunk;
    bool ordered;
  };
  std::span<const Color> colors() const { return colors_; }
  std::size_t chunk_count() const { return chunks_.size() - 1; }
  std::span<const Bundle> bundles_of(std::size_t chunk) const {
    return std::span(bundles_).subspan(chunks_[chunk], chunks_[chunk + 1] - chunks_[chunk]);
  }
  const Kernels& kernels_of(const Bundle& bundle) const { return bundle.alone ? kernels_->alone : kernels_->together; }

 private:
  struct Contact {
    TouchingBodies<T, Space> touching;
    std::span<const ContactManifold<T, Space>> found;
    std::uint32_t rows;
  };
  /// A block as wide as the widest registers, which are quickest with such an alignment.
  struct alignas(64) Block {
    std::byte bytes[64];
  };

  void add_chunk(std::span<const std::uint32_t> members, std::span<const std::uint8_t> movable);
  void lay_out();

  const ContactKernelPair<T, Space>* kernels_;
  std::vector<Contact> contacts_;
  std::vector<IslandLink> links_;
  Coloring coloring_;
  std::vector<std::uint32_t> order_;  ///< by colour, in each of which contacts with few points come first
  std::vector<Color> colors_;
  std::vector<std::uint32_t> chunks_;  ///< first bundle of each, and the end of the last one
  std::vector<Bundle> bundles_;
  std::vector<LanePlaces> places_;
  std::vector<LaneSource<T, Space>> sources_;
  std::vector<Block> rows_;  ///< of all bundles; grows, and is never cleared
  std::size_t point_count_ = 0;
};

}  // namespace graze
