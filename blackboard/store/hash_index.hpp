#pragma once

// Finds values by a hash that the caller knows: open addressing, no allocation for each value, nothing kept but the
// hash and the value. Which of the values with a hash is meant, the caller says. Its order is nobody's to see.
//
//   HashIndex<Entry*> by_key;
//   by_key.insert(hash, entry);
//   Entry** found = by_key.find(hash, [&](Entry* e) { return e->key == key; });     // null where there is none
//   by_key.erase(hash, [&](Entry* e) { return e == entry; });

#include <bit>
#include <cstddef>
#include <optional>
#include <vector>

namespace pizarra {

template <class Value>
class HashIndex {
 public:
  std::size_t size() const { return size_; }

  template <class Wanted>
  const Value* find(std::size_t hash, Wanted&& wanted) const {
    const std::size_t at = place_of(hash, wanted);
    return at == nowhere ? nullptr : &*slots_[at].value;
  }

  void insert(std::size_t hash, Value value) {
    if ((size_ + 1) * 3 > slots_.size() * 2) grow();
    std::size_t at = home_of(hash);
    while (slots_[at].value) at = after(at);
    slots_[at] = {hash, std::move(value)};
    ++size_;
  }

  template <class Wanted>
  void erase(std::size_t hash, Wanted&& wanted) {
    std::size_t hole = place_of(hash, wanted);
    if (hole == nowhere) return;
    --size_;
    // Whatever was put further on because this place was taken moves up, so that no search ends at the hole.
    for (std::size_t at = after(hole); slots_[at].value; at = after(at)) {
      const std::size_t home = home_of(slots_[at].hash);
      const bool may_move = ((at - home) & mask()) >= ((at - hole) & mask());
      if (!may_move) continue;
      slots_[hole] = std::move(slots_[at]);
      hole = at;
    }
    slots_[hole].value.reset();
  }

 private:
  struct Slot {
    std::size_t hash = 0;
    std::optional<Value> value;
  };
  static constexpr std::size_t nowhere = ~std::size_t{0};
  static constexpr std::size_t smallest = 16;

  std::size_t mask() const { return slots_.size() - 1; }
  std::size_t after(std::size_t at) const { return (at + 1) & mask(); }
  // The high bits of the product depend on all bits of the hash.
  std::size_t home_of(std::size_t hash) const {
    return (hash * std::size_t{0x9e3779b97f4a7c15}) >> (64 - std::countr_zero(slots_.size()));
  }

  template <class Wanted>
  std::size_t place_of(std::size_t hash, Wanted& wanted) const {
    if (slots_.empty()) return nowhere;
    for (std::size_t at = home_of(hash); slots_[at].value; at = after(at)) {
      if (slots_[at].hash == hash && wanted(*slots_[at].value)) return at;
    }
    return nowhere;
  }

  void grow() {
    std::vector<Slot> before(slots_.empty() ? smallest : slots_.size() * 2);
    before.swap(slots_);
    for (Slot& slot : before) {
      if (!slot.value) continue;
      std::size_t at = home_of(slot.hash);
      while (slots_[at].value) at = after(at);
      slots_[at] = std::move(slot);
    }
  }

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
};

}  // namespace pizarra
