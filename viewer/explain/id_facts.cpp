#include "viewer/explain/id_facts.h"

#include <algorithm>

namespace aomd::scene {

HashFacts hash_facts(const Mesh& mesh, int level) {
  HashFacts facts;
  const EntityHash& hash = mesh.hash(level);
  if (!hash.built()) return facts;
  facts.built = true;
  facts.bytes = hash.bytes();
  facts.statistics = hash.statistics();
  facts.rehashes = hash.rehashes();
  const std::vector<std::uint32_t> lengths = hash.lengths();
  for (std::size_t length = 0; length < lengths.size(); ++length) {
    facts.buckets[std::min(length, HashFacts::bars - 1)] += lengths[length];
    facts.entities += std::uint64_t{lengths[length]} * length;
  }
  return facts;
}

IdFacts id_facts(const Mesh& mesh, int level) {
  const IdPool& ids = mesh.ids(level);
  const std::vector<std::uint32_t>& stack = ids.free_ids();
  IdFacts facts{ids.size(),
                static_cast<std::uint32_t>(stack.size()),
                ids.capacity(),
                stack.empty() ? ids.capacity() : stack.back(),
                {}};
  const auto shown = static_cast<std::ptrdiff_t>(std::min(stack.size(), IdFacts::most_shown));
  facts.top.assign(stack.rbegin(), stack.rbegin() + shown);
  return facts;
}

}  // namespace aomd::scene
