#pragma once

#include <cstddef>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>

namespace mixcmp::inline common {

/// Keeps the value that was made for each key. Threads may share it: one of them makes a missing
/// value, while those that ask for the same key wait. Making a value may ask for other keys, but
/// never, however indirectly, for its own: that would wait for ever.
template <class Key, class Value>
class Memo {
public:
  /// Forgets all values when there are `most`; without a limit, values live as long as the memo.
  explicit Memo(std::size_t most = std::numeric_limits<std::size_t>::max()) : most_(most) {}

  template <class Make>
  std::shared_ptr<const Value> of(const Key& key, const Make& make) {
    const std::shared_ptr<Place> place = place_of(key);
    // No std::once_flag: with the thread sanitizer it never returns after an exception.
    const std::lock_guard making(place->making);
    if (!place->value) place->value.emplace(make());
    return {place, &*place->value};
  }

private:
  struct Place {
    std::mutex making;
    std::optional<Value> value;
  };

  std::shared_ptr<Place> place_of(const Key& key) {
    const std::lock_guard lock(mutex_);
    if (const auto known = places_.find(key); known != places_.end()) return known->second;
    if (places_.size() >= most_) places_.clear();
    return places_.emplace(key, std::make_shared<Place>()).first->second;
  }

  std::size_t most_;
  std::mutex mutex_;
  std::map<Key, std::shared_ptr<Place>> places_;
};

}  // namespace mixcmp::inline common
