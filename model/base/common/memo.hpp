#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

namespace mixcmp::inline common {

/// Keeps the value that was made for each key. Threads may share it. A missing value is made
/// without the lock, so that two threads may both make it.
template <class Key, class Value>
class Memo {
public:
  /// Forgets all values when there are `most`; without a limit, values live as long as the memo.
  explicit Memo(std::size_t most = std::numeric_limits<std::size_t>::max()) : most_(most) {}

  template <class Make>
  std::shared_ptr<const Value> of(const Key& key, const Make& make) {
    {
      const std::lock_guard lock(mutex_);
      if (const auto place = values_.find(key); place != values_.end()) return place->second;
    }
    auto value = std::make_shared<const Value>(make());
    const std::lock_guard lock(mutex_);
    if (values_.size() >= most_) values_.clear();
    return values_.try_emplace(key, std::move(value)).first->second;
  }

private:
  std::size_t most_;
  std::mutex mutex_;
  std::map<Key, std::shared_ptr<const Value>> values_;
};

}  // namespace mixcmp::inline common
