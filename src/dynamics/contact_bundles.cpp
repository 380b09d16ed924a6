#include "dynamics/contact_bundles.hpp"

#include <algorithm>

namespace graze {

namespace {

/// The number of contacts up to which they take less time one by one than across the lanes.
constexpr std::size_t few = 2;

}  // namespace

template <class T, class Space>
void ContactBundles<T, Space>::clear() {
  contacts_.clear();
  links_.clear();
  colors_.clear();
  chunks_.assign(1, 0);
  bundles_.clear();
  places_.clear();
  sources_.clear();
  point_count_ = 0;
}

template <class T, class Space>
void ContactBundles<T, Space>::add(const TouchingBodies<T, Space>& touching,
                                   std::span<const ContactManifold<T, Space>> manifolds) {
  std::uint32_t rows = 0;
  for (const ContactManifold<T, Space>& m : manifolds) rows += m.point_count;
  contacts_.push_back({touching, manifolds, rows});
  links_.push_back({touching.a, touching.b});
  point_count_ += rows;
}

template <class T, class Space>
void ContactBundles<T, Space>::build(std::span<const std::uint8_t> movable) {
  coloring_.find(movable, links_);
  order_.assign(coloring_.order().begin(), coloring_.order().end());
  for (const Coloring::Range& range : coloring_.colors()) {
    const std::span<std::uint32_t> members = std::span(order_).subspan(range.first, range.end - range.first);
    if (!range.ordered)
      std::stable_sort(members.begin(), members.end(),
                       [&](std::uint32_t i, std::uint32_t j) { return contacts_[i].rows < contacts_[j].rows; });
    const auto first = static_cast<std::uint32_t>(chunk_count());
    for (std::size_t i = 0; i < members.size();) {
      const std::size_t left = members.size() - i;
      const std::size_t count =
          range.ordered || left <= few ? 1 : std::min<std::size_t>(left, kernels_->together.lanes);
      add_chunk(members.subspan(i, count), movable);
      i += count;
    }
    colors_.push_back({first, static_cast<std::uint32_t>(chunk_count()), range.ordered});
  }
  lay_out();
}

/// Adds the bundles of one chunk of contacts.
template <class T, class Space>
void ContactBundles<T, Space>::add_chunk(std::span<const std::uint32_t> members,
                                         std::span<const std::uint8_t> movable) {
  const std::size_t lanes = members.size() == 1 ? 1 : kernels_->together.lanes;
  for (std::size_t round = 0;; ++round) {
    Bundle bundle{};
    bundle.alone = members.size() == 1;
    for (const std::uint32_t i : members) {
      const Contact& contact = contacts_[i];
      std::size_t number = 0;
      for (const ContactManifold<T, Space>& m : contact.found) {
        if (m.point_count == 0 || number++ != round) continue;
        const TouchingBodies<T, Space>& touching = contact.touching;
        const std::uint32_t lane = bundle.filled++;
        bundle.row_count = std::max(bundle.row_count, m.point_count);
        bundle.roll = bundle.roll || touching.between.material.rolling_friction > T(0);
        bundle.pushed_a |= std::uint32_t{movable[touching.a]} << lane;
        bundle.pushed_b |= std::uint32_t{movable[touching.b]} << lane;
        places_.push_back({touching.a, touching.b});
        typename Space::Turning* const rolling =
            touching.rolling ? touching.rolling + (&m - contact.found.data()) : nullptr;
        sources_.push_back({&touching, &m, rolling});
        break;
      }
    }
    if (bundle.filled == 0) break;
    for (std::size_t lane = bundle.filled; lane < lanes; ++lane) {
      places_.push_back(places_[places_.size() - lane]);
      sources_.push_back(sources_[sources_.size() - lane]);
    }
    bundles_.push_back(bundle);
  }
  chunks_.push_back(static_cast<std::uint32_t>(bundles_.size()));
}

/// Reserves memory for the rows, and sets where the bundles' lanes are, once no bundle is added any more.
template <class T, class Space>
void ContactBundles<T, Space>::lay_out() {
  const auto blocks_of = [&](const Bundle& bundle) {
    const Kernels& kernels = kernels_of(bundle);
    return (kernels.manifold_bytes + bundle.row_count * kernels.row_bytes + sizeof(Block) - 1) / sizeof(Block);
  };
  std::size_t blocks = 0;
  for (const Bundle& bundle : bundles_) blocks += blocks_of(bundle);
  if (rows_.size() < blocks) rows_.resize(blocks);
  std::size_t block = 0, lane = 0;
  for (Bundle& bundle : bundles_) {
    bundle.rows = rows_.data() + block;
    bundle.places = places_.data() + lane;
    bundle.sources = sources_.data() + lane;
    block += blocks_of(bundle);
    lane += kernels_of(bundle).lanes;
  }
}

template class ContactBundles<float, Space<float>>;
template class ContactBundles<double, Space<double>>;
template class ContactBundles<float, plane::Space<float>>;
template class ContactBundles<double, plane::Space<double>>;

}  // namespace graze
