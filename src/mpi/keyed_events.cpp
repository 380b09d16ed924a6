#include "mpi/keyed_events.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_map>

namespace graze::mpi {

namespace {

auto keys_of(const KeyedEvent& e) { return std::pair(e.a, e.b); }

struct Hash {
  std::size_t operator()(const std::pair<Key, Key>& keys) const {
    return std::hash<Key>()(keys.first * 0x9e3779b97f4a7c15 ^ keys.second);
  }
};

}  // namespace

/// News of a pair from a rank: it was found here and did not touch before, or touched and was not found.
struct KeyedEvents::Claim {
  Key a, b;
  std::uint8_t found;  ///< found now; else missed
  std::uint8_t overlap, trigger;
};

/// Finds the events that this rank decides by itself, and its claims for the judges of all others.
void KeyedEvents::find_claims(std::span<const KeyedPair> pairs, ByRank<Claim>& claims) {
  const auto judge = [&](Key a, Key b) -> auto& { return claims[Hash()(std::pair(a, b)) / 7 % claims.size()]; };
  std::swap(events_, last_);
  events_.clear();
  auto last = last_.cbegin();
  const auto end = last_.cend();
  const auto skip_ends = [&] {
    while (last != end && last->kind == EventKind::end) ++last;
  };
  const auto take = [&]() -> const KeyedEvent& {
    const KeyedEvent& taken = *last++;
    skip_ends();
    return taken;
  };
  skip_ends();
  const auto miss = [&](const KeyedEvent& e) { judge(e.a, e.b).push_back({e.a, e.b, 0, 0, e.trigger}); };
  auto was_apart = apart_.begin();
  for (const KeyedPair& p : pairs) {
    while (was_apart != apart_.end() && *was_apart < std::pair(p.a, p.b)) ++was_apart;
    while (last != end && keys_of(*last) < std::pair(p.a, p.b)) miss(take());
    if (last != end && keys_of(*last) == std::pair(p.a, p.b))
      events_.push_back({p.a, p.b, EventKind::stay, take().trigger});
    // A pair that was found here and does not touch was found by no other rank: this one decides.
    else if (was_apart == apart_.end() || *was_apart != std::pair(p.a, p.b))
      judge(p.a, p.b).push_back({p.a, p.b, 1, p.overlap, p.trigger});
    else if (p.overlap)
      events_.push_back({p.a, p.b, EventKind::begin, p.trigger});
  }
  while (last != end) miss(take());
}

/// Keeps the pairs that were found here and have no event: they are near and do not touch.
void KeyedEvents::keep_apart(std::span<const KeyedPair> pairs) {
  apart_.clear();
  auto event = events_.begin();
  for (const KeyedPair& p : pairs) {
    while (event != events_.end() && keys_of(*event) < std::pair(p.a, p.b)) ++event;
    if (event == events_.end() || keys_of(*event) != std::pair(p.a, p.b)) apart_.emplace_back(p.a, p.b);
  }
}

/// Sends the verdict to the rank that found the pair, and on an end to the one that missed it.
void KeyedEvents::update(Together& together, std::span<const KeyedPair> pairs) {
  ByRank<Claim> claims = together.nothing<Claim>();
  together.alone([&] { find_claims(pairs, claims); });
  const ByRank<Claim> heard = together.exchange(claims);
  ByRank<KeyedEvent> verdicts = together.nothing<KeyedEvent>();
  together.alone([&] {
    std::unordered_map<std::pair<Key, Key>, std::pair<Claim, std::size_t>, Hash> missed;
    for (std::size_t r = 0; r < heard.size(); ++r)
      for (const Claim& c : heard[r])
        if (c.found == 0) missed.emplace(std::pair(c.a, c.b), std::pair(c, r));
    for (std::size_t r = 0; r < heard.size(); ++r)
      for (const Claim& c : heard[r]) {
        if (c.found == 0) continue;
        const auto before = missed.find(std::pair(c.a, c.b));
        if (before != missed.end()) {
          verdicts[r].push_back({c.a, c.b, EventKind::stay, before->second.first.trigger != 0});
          missed.erase(before);
        } else if (c.overlap != 0) {
          verdicts[r].push_back({c.a, c.b, EventKind::begin, c.trigger != 0});
        }
      }
    for (const auto& [keys, claim] : missed)
      verdicts[claim.second].push_back({keys.first, keys.second, EventKind::end, claim.first.trigger != 0});
  });
  const ByRank<KeyedEvent> heard_of = together.exchange(verdicts);
  together.alone([&] {
    const auto before = [](const KeyedEvent& e, const KeyedEvent& f) { return keys_of(e) < keys_of(f); };
    const auto known = static_cast<std::ptrdiff_t>(events_.size());
    for (const std::vector<KeyedEvent>& some : heard_of) events_.insert(events_.end(), some.begin(), some.end());
    std::sort(events_.begin() + known, events_.end(), before);
    std::inplace_merge(events_.begin(), events_.begin() + known, events_.end(), before);
    keep_apart(pairs);
  });
}

}  // namespace graze::mpi
