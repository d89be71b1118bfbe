#pragma once
// A list as a set.

#include <algorithm>
#include <vector>

namespace aomd::scene {

/// In ascending order, each once.
template <typename T>
void sort_once(std::vector<T>& items) {
  std::sort(items.begin(), items.end());
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

}  // namespace aomd::scene
